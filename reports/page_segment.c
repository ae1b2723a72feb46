// reports/page_segment.c
#include "reports/fig4_paper.h"
#include "reports/page_kit.h"

#include <math.h>
#include <stdio.h>

static double degrees(double angle)
{
    return angle * 180 / acos(-1.0);
}

// +- an estimate in the same unit; nothing where none is known
static number_text with_error(double error)
{
    number_text t = {""};
    if (error > 0 && isfinite(error)) {
        const number_text digits = number_digits(error, 1);
        (void)snprintf(t.text, sizeof t.text, " ± %.30s", digits.text);
    }
    return t;
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
    PAGE("</td><td>%s, %s</td><td>%s%s<small>%s %% of the length</small>",
         number_fixed(l->point[0] * 1e3, 4).text, number_fixed(l->point[1] * 1e3, 4).text,
         number_fixed(l->shortening * 1e3, 5).text, with_error(l->shortening_error * 1e3).text,
         number_fixed(l->shortening / r->segment_length * 100, 3).text);
    TRY(paper_word(page, paper.shortening, fig4));
    PAGE("</td><td>%s%s</td><td>%s%s", number_fixed(-l->tip_displacement[2] * 1e3, 5).text,
         with_error(l->tip_displacement_error * 1e3).text,
         number_fixed(degrees(hypot(l->tip_rotation[0], l->tip_rotation[1])), 4).text,
         with_error(degrees(l->tip_rotation_error)).text);
    TRY(paper_word(page, paper.tip_angle, fig4));
    PAGE("</td><td>%s</td><td>%s, %s%s", number_fixed(degrees(l->tip_rotation[2]), 4).text,
         number_fixed(l->mid_curvature[0], 4).text, number_fixed(l->mid_curvature[1], 4).text,
         with_error(l->mid_curvature_error).text);
    TRY(paper_word(page, paper.mid_curvature, fig4));
    PAGE("</td><td>%s%s</td></tr>\n", number_digits(l->strain_energy * 1e6, 5).text,
         with_error(l->strain_energy_error * 1e6).text);

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

static status effort(bytes *page, const segment_result *s)
{
    static const char *const how[] = {
        "", "one thin slab, condensed to its two end planes and joined with itself again and again",
        "sparse factors of the whole mesh", "conjugate gradients without a matrix"};
    status st = OK;
    const double seconds = s->assemble_seconds + s->factor_seconds + s->solve_seconds;
    PAGE("<p>Solved by %s", how[(unsigned)s->way % 4][0] ? how[(unsigned)s->way % 4] : "one mesh");
    if (s->iterations > 0) {
        PAGE(", %d iterations", s->iterations);
    }
    PAGE(", on %d mesh%s one after the other, in %s s of processor time. ", s->rungs,
         s->rungs == 1 ? "" : "es", number_digits(seconds, 2).text);
    if (s->why[0]) {
        PAGE("Why this way: ");
        TRY(page_escaped(page, s->why));
        PAGE(". ");
    }
    PAGE("Estimated relative error of the tip compliance %s, of the middle's law %s; largest "
         "residual of the solves %s.</p>\n",
         number_digits(s->relative_error, 2).text, number_digits(s->middle.relative_error, 2).text,
         number_digits(s->residual, 2).text);

done:
    return st;
}

static status end_lengths(bytes *page, const segment_result *s)
{
    static const char *const names[6] = {"shear x",      "shear y",      "stretch",
                                         "bend about x", "bend about y", "twist"};
    status st = OK;
    bool any = false;
    for (int i = 0; i < 6; i++) {
        any = any || isfinite(s->end_length[i]);
    }
    if (!any) {
        return OK;
    }
    PAGE(
        "<div class=\"scroll\"><table>\n<caption>What the layers at both ends take: a segment that "
        "much shorter, all of it like its middle, has the same compliance</caption>\n<thead><tr>");
    for (int i = 0; i < 6; i++) {
        PAGE("<th>%s<small>mm</small></th>", names[i]);
    }
    PAGE("</tr></thead>\n<tbody><tr>");
    for (int i = 0; i < 6; i++) {
        PAGE("<td>%s</td>",
             isfinite(s->end_length[i]) ? number_digits(s->end_length[i] * 1e3, 4).text : "–");
    }
    PAGE("</tr></tbody></table></div>\n");

done:
    return st;
}

static status balances(bytes *page, const segment_result *s)
{
    status st = OK;
    double worst = 0;
    for (int i = 0; i < s->nload; i++) {
        worst = fmax(worst, s->load[i].balance);
    }
    if (s->nload > 0 && s->load[0].nslice > 0) {
        PAGE("<p>In every one of %d sections the stresses carry what acts beyond it, to %s of the "
             "load (<code>segment_slices.csv</code>).</p>\n",
             s->load[0].nslice, number_digits(worst, 2).text);
    }

done:
    return st;
}

static status figures(bytes *page, const run_result *r, const char *dir)
{
    status st = OK;
    TRY(page_segment_view(page, r));
    TRY(page_figure(page, dir, "segment", "Deformed segments, one colour scale for all loads."));
    if (r->segment.body.shared) {
        PAGE("<p class=\"note\">Several processes have the fields between them: "
             "<code>stiffaxis report</code> on the stored result draws them.</p>\n");
    }
    TRY(page_figure(page, dir, "segment_stress",
                    "Von Mises stress on the deformed segments, one colour scale for all loads."));
    TRY(page_figure(page, dir, "segment_along",
                    "Strains of the fitted sections along the segment; what the section's own law "
                    "says is dashed."));
    TRY(page_figure(page, dir, "segment_mesh", "The mesh and its grading."));
    TRY(page_figure(page, dir, "time_error",
                    "What accuracy took: error of the tip compliance against unknowns and "
                    "against the processor time of this run, mesh by mesh."));

done:
    return st;
}

// Its error is that of the meshes. What the ends' layers leave in the middle of a segment this
// short is no error of it, but keeps it from being the section's: told where one section is all
// there is.
static status apart_from_section(bytes *page, const run_result *r)
{
    status st = OK;
    if (r->has_section && r->section.nstation == 1) {
        const double *found = r->segment.stiffness_centre;
        const double *own = r->section.station[0].centres.stiffness_centre;
        PAGE(" It lies %s mm from the section's own stiffness centre: what the layers at both ends "
             "leave in the middle of a segment this long, beside the errors of both.",
             number_digits(hypot(found[0] - own[0], found[1] - own[1]) * 1e3, 2).text);
    }

done:
    return st;
}

// nothing where springs or holds on the walls leave the middle no law
static status centres(bytes *page, const run_result *r)
{
    status st = OK;
    const segment_result *s = &r->segment;
    if (isnan(s->stiffness_centre[0])) {
        return OK;
    }
    PAGE("<p>Centre found by the 3D solution (where a load leaves the middle uncurved): "
         "(%s, %s) mm",
         number_fixed(s->stiffness_centre[0] * 1e3, 4).text,
         number_fixed(s->stiffness_centre[1] * 1e3, 4).text);
    if (s->stiffness_centre_error > 0) {
        PAGE("%s mm by the meshes alone", with_error(s->stiffness_centre_error * 1e3).text);
    }
    PAGE("; where it leaves the tip unturned: (%s, %s) mm.",
         number_fixed(s->tip_centre[0] * 1e3, 4).text,
         number_fixed(s->tip_centre[1] * 1e3, 4).text);
    TRY(apart_from_section(page, r));
    PAGE("</p>\n");

done:
    return st;
}

status page_segment(bytes *page, const run_result *r, const char *dir)
{
    status st = OK;
    const segment_result *s = &r->segment;
    const bool fig4 = fig4_is(r);
    static const char *const base[] = {"clamped",
                                       "free to contract sideways, its rigid motions held", "free"};
    static const char *const tip[] = {"a rigid cap", "traction proportional to E",
                                      "uniform traction", "free"};
    if (!r->has_segment) {
        return OK;
    }

    PAGE("<h2 id=\"segment\">3D segment</h2>\n<p>From the section at s = %s mm on, %s mm long; "
         "linear elasticity with %lld unknowns. ",
         number_short(r->segment_section_at * 1e3, 6).text,
         number_short(r->segment_length * 1e3, 6).text, s->dofs);
    PAGE("Base: %s. Tip: %s.</p>\n", base[(unsigned)r->segment_base % 3],
         tip[(unsigned)r->segment_tip % 4]);
    TRY(effort(page, s));
    TRY(figures(page, r, dir));
    if (s->nload > 0) {
        TRY(loads(page, r, fig4));
        TRY(balances(page, s));
    }
    if (fig4) {
        char note[600];
        fig4_note(r, note, sizeof note);
        PAGE("<p class=\"note\">%s</p>\n", note);
    }
    TRY(centres(page, r));
    TRY(end_lengths(page, s));

done:
    return st;
}
