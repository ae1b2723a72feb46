// reports/page_models.c
// What assumptions about the section cost, entry by entry.
#include "reports/page_kit.h"

#include <math.h>

static const char *const axis[6] = {"n<sub>x</sub>", "n<sub>y</sub>", "n<sub>z</sub>",
                                    "m<sub>x</sub>", "m<sub>y</sub>", "m<sub>z</sub>"};

// entries that are smaller in 3D and in every model are left out: they are zero
static const double SMALL = 1e-5;

static double scale_of(const model_checks *m, int i, int j)
{
    return sqrt(m->compliance.a[i][i] * m->compliance.a[j][j]);
}

static bool counts(const model_checks *m, int i, int j)
{
    bool any = fabs(m->compliance.a[i][j]) > SMALL * scale_of(m, i, j);
    for (int k = 0; k < MODEL_CHECKS; k++) {
        any = any || (!m->model[k].why[0] &&
                      fabs(m->model[k].compliance.a[i][j]) > SMALL * scale_of(m, i, j));
    }
    return any;
}

static status entry_line(bytes *page, const model_checks *m, int i, int j)
{
    status st = OK;
    const double scale = scale_of(m, i, j);
    // mm, N, rad
    const double unit = (i < 3 ? 1e3 : 1) * (j < 3 ? 1 : 1e-3);
    PAGE("<tr><td class=\"text\">%s %s</td><td>%s</td>", axis[i], axis[j],
         number_digits(unit * m->compliance.a[i][j], 6).text);
    for (int k = 0; k < MODEL_CHECKS; k++) {
        const model_check *one = &m->model[k];
        PAGE(
            "<td>%s</td>",
            one->why[0]
                ? ""
                : number_digits((one->compliance.a[i][j] - m->compliance.a[i][j]) / scale, 2).text);
    }
    PAGE("</tr>\n");

done:
    return st;
}

static status total_line(bytes *page, const model_checks *m, bool law)
{
    status st = OK;
    PAGE("<tr><td class=\"text\">%s</td><td></td>",
         law ? "its law alone: stretch, bending, twist" : "the largest, ends and all");
    for (int k = 0; k < MODEL_CHECKS; k++) {
        const model_check *one = &m->model[k];
        const double error = law ? one->law_error : one->error;
        if (one->why[0] || isnan(error)) {
            PAGE("<td></td>");
        } else {
            PAGE("<td><b>%s</b> at %s %s</td>", number_digits(error, 2).text,
                 axis[law ? one->law_row : one->row], axis[law ? one->law_column : one->column]);
        }
    }
    PAGE("</tr>\n");

done:
    return st;
}

static status model_head(bytes *page, const model_checks *m)
{
    status st = OK;
    PAGE("<div class=\"scroll\"><table>\n<thead><tr><th class=\"text\">entry</th><th>3D<small>mm, "
         "N, rad</small></th>");
    for (int k = 0; k < MODEL_CHECKS; k++) {
        PAGE("<th>");
        TRY(page_escaped(page, m->model[k].name));
        PAGE("<small>off 3D</small></th>");
    }
    PAGE("</tr></thead>\n<tbody>\n");

done:
    return st;
}

status page_models(bytes *page, const run_result *r)
{
    status st = OK;
    const model_checks *m = &r->models;
    if (!m->there) {
        return OK;
    }
    PAGE("<h3 id=\"models\">What each assumption about the section costs</h3>\n<p>The tip's "
         "compliance of a straight rod of %s mm by three laws of its section, less that of the 3D "
         "segment, over its √(C<sub>ii</sub> C<sub>jj</sub>). ",
         number_digits(1e3 * m->lengths[0], 4).text);
    if (m->lengths[1] > 0) {
        PAGE("A second segment of %s mm tells the ends apart: they take the same of both.</p>\n",
             number_digits(1e3 * m->lengths[1], 4).text);
    } else {
        PAGE("The ends' part is in it: ");
        TRY(page_escaped(page, m->why_no_second));
        PAGE(".</p>\n");
    }
    TRY(model_head(page, m));
    for (int k = 0; k < 36; k++) {
        TRY(k % 6 >= k / 6 && counts(m, k / 6, k % 6) ? entry_line(page, m, k / 6, k % 6) : OK);
    }
    TRY(total_line(page, m, false));
    TRY(m->lengths[1] > 0 ? total_line(page, m, true) : OK);
    PAGE("</tbody></table></div>\n");

done:
    return st;
}
