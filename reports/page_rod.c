// reports/page_rod.c
#include "reports/page_kit.h"

#include <math.h>

double smallest_linear_strain(const run_result *r, const char **name)
{
    double least = 0;
    for (int i = 0; i < r->nmaterial; i++) {
        const double strain = r->materials[i].linear_strain;
        if (strain > 0 && (least == 0 || strain < least)) {
            least = strain;
            *name = r->materials[i].name;
        }
    }
    return least;
}

static status head_row(bytes *page, const rod_result *rod)
{
    status st = OK;

    PAGE("<thead><tr>");
    for (int i = 0; i < rod->ntendon; i++) {
        PAGE("<th>");
        TRY(page_escaped(page, rod->tendon_name[i]));
        PAGE("<small>N</small></th>");
    }
    PAGE("<th>tip<small>x, y, z in mm</small></th><th>bend<small>deg</small></th>");
    for (int i = 0; i < rod->ntendon; i++) {
        PAGE("<th>length of ");
        TRY(page_escaped(page, rod->tendon_name[i]));
        PAGE("<small>mm</small></th>");
    }
    PAGE("<th>largest strain<small>%%</small></th><th>rel. error<small>of the "
         "tip</small></th></tr></thead>\n");

done:
    return st;
}

static status solution_row(bytes *page, const run_result *r, int solution)
{
    status st = OK;
    const rod_result *rod = &r->rod;
    const struct rod_run *run = &rod->run[solution];
    const bool beyond = result_beyond_linear(r, run) >= 0;

    PAGE("<tr>");
    for (int i = 0; i < rod->ntendon; i++) {
        PAGE("<td>%s</td>", number_short(run->tension[i], 4).text);
    }
    PAGE("<td>%s, %s, %s</td>", number_fixed(run->tip.p.a[0] * 1e3, 4).text,
         number_fixed(run->tip.p.a[1] * 1e3, 4).text, number_fixed(run->tip.p.a[2] * 1e3, 4).text);
    PAGE("<td>%s</td>", number_fixed(run->total_bend_rad * 180 / acos(-1.0), 2).text);
    for (int i = 0; i < rod->ntendon; i++) {
        PAGE("<td>%s</td>", number_fixed(run->tendon_length[i] * 1e3, 4).text);
    }
    PAGE("<td%s>%s%s</td><td>%s</td></tr>\n", beyond ? " class=\"bad\"" : "",
         number_fixed(run->largest_strain * 100, 2).text, beyond ? " ⚠" : "",
         number_digits(run->relative_error, 2).text);

done:
    return st;
}

static status strain_warning(bytes *page, const run_result *r)
{
    status st = OK;
    const rod_result *rod = &r->rod;
    int beyond = 0, worst = -1;
    double most = 0;
    const char *name = "";
    const double linear = smallest_linear_strain(r, &name);
    for (int i = 0; i < rod->nsolution; i++) {
        const int material = result_beyond_linear(r, &rod->run[i]);
        beyond += material >= 0;
        worst = material >= 0 ? material : worst;
        most = fmax(most, rod->run[i].largest_strain);
    }
    if (linear <= 0) {
        PAGE("<p class=\"note\">The case does not say up to which strain its materials stay linear "
             "(linear_strain). The largest strain here is %s %%.</p>\n",
             number_fixed(most * 100, 2).text);
    } else if (beyond > 0) {
        PAGE("<p class=\"note warn\">⚠ %d of %d shapes strain the section by more than what keeps ",
             beyond, rod->nsolution);
        TRY(page_escaped(page, r->materials[worst].name));
        PAGE(" close to linear, %s %% (up to %s %%). Their numbers are those of linear "
             "materials.</p>\n",
             number_short(r->materials[worst].linear_strain * 100, 3).text,
             number_fixed(most * 100, 2).text);
    } else {
        PAGE("<p class=\"note\">All shapes stay below the strains up to which the materials are "
             "close to linear (");
        TRY(page_escaped(page, name));
        PAGE(": %s %%).</p>\n", number_short(linear * 100, 3).text);
    }

done:
    return st;
}

status page_rod(bytes *page, const run_result *r, const char *dir)
{
    status st = OK;
    const rod_result *rod = &r->rod;
    if (!r->has_rod || rod->nsolution == 0) {
        return OK;
    }

    PAGE("<h2 id=\"rod\">Rod under its tendons</h2>\n<p>Length %s mm, clamped at the base, no "
         "friction. "
         "Strains are principal ones, over the whole section and along the rod.</p>\n",
         number_short(r->rod_length * 1e3, 6).text);
    TRY(page_figure(page, dir, "rods", "Shapes for all tensions."));
    TRY(strain_warning(page, r));
    PAGE("<div class=\"scroll\"><table>\n<caption>One row for each set of tensions; a tendon's "
         "length is "
         "what lies inside the body</caption>\n");
    TRY(head_row(page, rod));
    PAGE("<tbody>\n");
    for (int i = 0; i < rod->nsolution; i++) {
        TRY(solution_row(page, r, i));
    }
    PAGE("</tbody></table></div>\n");
    TRY(page_strains(page, r));
    TRY(page_figure(page, dir, "curvature",
                    "Curvature and twist along the rod, in the body frame."));

done:
    return st;
}
