// reports/page_section.c
#include "reports/page_kit.h"

#include <math.h>

enum { MAX_STATIONS = 24 }; // rows of the table; sections.csv has them all

static const double negligible = 1e-9; // of sqrt(K_ii K_jj): rounding and residuals of the solves

static status station_row(bytes *page, const section_station *s)
{
    status st = OK;
    const beam_centres *c = &s->centres;
    const double degree = 180 / acos(-1.0);

    PAGE("<tr><td>%s</td><td>%s</td>", number_fixed(s->s * 1e3, 3).text,
         number_digits(c->EA, 8).text);
    PAGE("<td>%s, %s</td>", number_fixed(c->stiffness_centre[0] * 1e3, 5).text,
         number_fixed(c->stiffness_centre[1] * 1e3, 5).text);
    PAGE("<td>%s</td>", c->isotropic ? "any" : number_fixed(c->principal_angle * degree, 3).text);
    PAGE("<td>%s</td><td>%s</td><td>%s</td>", number_digits(c->EI[0] * 1e6, 8).text,
         number_digits(c->EI[1] * 1e6, 8).text, number_digits(c->GJ * 1e6, 8).text);
    PAGE("<td>%s, %s</td>", number_fixed(c->shear_centre[0] * 1e3, 5).text,
         number_fixed(c->shear_centre[1] * 1e3, 5).text);
    PAGE("<td>%s</td><td>%s</td></tr>\n", number_digits(s->law.area * 1e6, 7).text,
         number_digits(s->law.relative_error, 2).text);

done:
    return st;
}

static status stations(bytes *page, const section_result *s)
{
    status st = OK;
    // evenly picked, the first and the last among them
    const int shown = s->nstation < MAX_STATIONS ? s->nstation : MAX_STATIONS;

    PAGE("<div class=\"scroll\"><table>\n<caption>Sections along the rod, about the geometric "
         "centre of "
         "each");
    if (shown < s->nstation) {
        PAGE("; %d of %d, the others are in sections.csv", shown, s->nstation);
    }
    PAGE("</caption>\n<thead><tr><th>s<small>mm</small></th><th>EA<small>N</small></th>"
         "<th>stiffness centre<small>x, y in mm</small></th><th>x′ turned<small>deg</small></th>");
    PAGE("<th>EI about x′<small>N mm²</small></th><th>EI about y′<small>N mm²</small></th>"
         "<th>GJ<small>N mm²</small></th><th>shear centre<small>x, y in mm</small></th>");
    PAGE("<th>area<small>mm²</small></th><th>rel. error<small>of K, "
         "estimated</small></th></tr></thead>\n<tbody>\n");
    for (int i = 0; i < shown; i++) {
        const int k = shown > 1 ? (int)((long)i * (s->nstation - 1) / (shown - 1)) : 0;
        TRY(station_row(page, &s->station[k]));
    }
    PAGE("</tbody></table></div>\n");

done:
    return st;
}

static status stiffness(bytes *page, const section_station *s)
{
    status st = OK;
    static const char *const force[] = {"n<sub>x</sub>", "n<sub>y</sub>", "n<sub>z</sub>",
                                        "m<sub>x</sub>", "m<sub>y</sub>", "m<sub>z</sub>"};
    static const char *const strain[] = {"γ<sub>x</sub>", "γ<sub>y</sub>", "ε",
                                         "κ<sub>x</sub>", "κ<sub>y</sub>", "τ"};

    PAGE("<h3>Stiffness at s = %s mm</h3>\n", number_short(s->s * 1e3, 6).text);
    PAGE("<div class=\"scroll\"><table>\n<caption>Rows: wrench; columns: strain. Upper left N, "
         "mixed "
         "blocks N mm, lower right N mm². Grey: below 10⁻⁹ of the "
         "diagonal.</caption>\n<thead><tr><th></th>");
    for (int j = 0; j < 6; j++) {
        PAGE("<th>%s</th>", strain[j]);
    }
    PAGE("</tr></thead>\n<tbody>\n");
    for (int i = 0; i < 6; i++) {
        PAGE("<tr><th>%s</th>", force[i]);
        for (int j = 0; j < 6; j++) {
            const mat6 *K = &s->law.K;
            const double unit = (i > 2 ? 1e3 : 1) * (j > 2 ? 1e3 : 1);
            const int zero = fabs(K->a[i][j]) < negligible * sqrt(fabs(K->a[i][i] * K->a[j][j]));
            PAGE("<td%s>%s</td>", zero ? " class=\"zero\"" : "",
                 number_digits(K->a[i][j] * unit, zero ? 2 : 7).text);
        }
        PAGE("</tr>\n");
    }
    PAGE("</tbody></table></div>\n");

done:
    return st;
}

status page_section(bytes *page, const run_result *r, const char *dir)
{
    status st = OK;
    const section_result *s = &r->section;
    if (!r->has_section || s->nstation == 0) {
        return OK;
    }

    PAGE("<h2 id=\"section\">Cross section</h2>\n<p>%s ",
         r->section_model == MODEL_CLASSICAL
             ? "Classical model: the paper's E-weighted integrals, without warping."
             : "Full model: warping solved on the mesh, any materials, all 36 stiffness entries.");
    char effort[SECTION_EFFORT_WORDS];
    PAGE("For %d station%s: %s.%s</p>\n", s->nstation, s->nstation == 1 ? "" : "s",
         section_effort_words(&s->effort, effort),
         s->effort.uneven
             ? " Its shapes turn at different rates: K is that of a section that does not turn."
             : "");
    TRY(page_section_figure(page, r, dir));
    TRY(stations(page, s));
    TRY(stiffness(page, &s->station[0]));
    TRY(page_answers(page, r, dir));

done:
    return st;
}
