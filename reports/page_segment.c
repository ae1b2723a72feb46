// reports/page_segment.c
#include "reports/fig4_paper.h"
#include "reports/page_kit.h"

#include <math.h>

static double degrees(double angle)
{
    return angle * 180 / acos(-1.0);
}

static status paper_word(bytes *page, const char *word, bool wanted)
{
    status st = OK;
    if (wanted) {
        PAGE("<small>paper: %s</small>", word ? word : "–");
    }

done:
    return st;
}

static status load_row(bytes *page, const run_result *r, int load, bool fig4)
{
    status st = OK;
    const segment_load_result *l = &r->segment.load[load];
    const fig4_reported paper = fig4_paper(fig4 ? fig4_which(r, load) : FIG4_NONE);

    PAGE("<tr><td class=\"text\">");
    TRY(page_escaped(page, l->name ? l->name : "load"));
    PAGE("</td><td>%s, %s</td><td>%s = %s %%", number_fixed(l->point[0] * 1e3, 4).text,
         number_fixed(l->point[1] * 1e3, 4).text, number_fixed(l->shortening * 1e3, 5).text,
         number_fixed(l->shortening / r->segment_length * 100, 3).text);
    TRY(paper_word(page, paper.shortening, fig4));
    PAGE("</td><td>%s</td><td>%s", number_fixed(-l->tip_displacement[2] * 1e3, 5).text,
         number_fixed(degrees(hypot(l->tip_rotation[0], l->tip_rotation[1])), 4).text);
    TRY(paper_word(page, paper.tip_angle, fig4));
    PAGE("</td><td>%s</td><td>%s, %s", number_fixed(degrees(l->tip_rotation[2]), 4).text,
         number_fixed(l->mid_curvature[0], 4).text, number_fixed(l->mid_curvature[1], 4).text);
    TRY(paper_word(page, paper.mid_curvature, fig4));
    PAGE("</td><td>%s</td></tr>\n", number_digits(l->strain_energy * 1e6, 5).text);

done:
    return st;
}

static status loads(bytes *page, const run_result *r, bool fig4)
{
    status st = OK;

    PAGE("<div class=\"scroll\"><table>\n<caption>What each load "
         "does</caption>\n<thead><tr><th>load</th>"
         "<th>acts at<small>x, y in mm</small></th><th>shortening<small>mm, E-weighted "
         "mean</small></th>");
    PAGE("<th>at the geometric centre<small>mm</small></th><th>tip angle<small>deg</small></th>"
         "<th>tip twist<small>deg</small></th><th>mid curvature<small>κx, κy in 1/m</small></th>"
         "<th>energy<small>µJ</small></th></tr></thead>\n<tbody>\n");
    for (int i = 0; i < r->segment.nload; i++) {
        TRY(load_row(page, r, i, fig4));
    }
    PAGE("</tbody></table></div>\n");

done:
    return st;
}

status page_segment(bytes *page, const run_result *r, const char *dir)
{
    status st = OK;
    const segment_result *s = &r->segment;
    const bool fig4 = fig4_is(r);
    static const char *const base[] = {"clamped",
                                       "free to contract sideways, its rigid motions held"};
    static const char *const tip[] = {"a rigid cap", "traction proportional to E",
                                      "uniform traction"};
    if (!r->has_segment) {
        return OK;
    }

    PAGE("<h2 id=\"segment\">3D segment</h2>\n<p>The section at s = %s mm, extruded to %s mm; "
         "linear elasticity "
         "with %lld unknowns. ",
         number_short(r->segment_section_at * 1e3, 6).text,
         number_short(r->segment_length * 1e3, 6).text, s->dofs);
    PAGE("Base: %s. Tip: %s.</p>\n", base[r->segment_base == BASE_FREE_TO_CONTRACT],
         tip[(unsigned)r->segment_tip % 3]);
    TRY(page_figure(page, dir, "segment", "Deformed segments, one colour scale for all loads."));
    if (s->nload > 0) {
        TRY(loads(page, r, fig4));
    }
    if (fig4) {
        char note[600];
        fig4_note(r, note, sizeof note);
        PAGE("<p class=\"note\">%s</p>\n", note);
    }
    PAGE("<p>Centre found by the 3D solution (where a load leaves the middle uncurved): "
         "(%s, %s) mm. ",
         number_fixed(s->stiffness_centre[0] * 1e3, 4).text,
         number_fixed(s->stiffness_centre[1] * 1e3, 4).text);
    PAGE("Estimated relative error of the tip compliance %s, largest residual of the solves "
         "%s.</p>\n",
         number_digits(s->relative_error, 2).text, number_digits(s->residual, 2).text);

done:
    return st;
}
