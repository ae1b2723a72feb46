// reports/page_rod.c
#include "reports/page_kit.h"
#include "reports/page_rod_parts.h"
#include "reports/rod_show.h"

#include <math.h>
#include <stdio.h>

static const double error_limit = 1e-2; // of the length: what is worse is no answer

static double degrees(double angle)
{
    return angle * 180 / acos(-1.0);
}

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

bool rod_error_is_large(const struct rod_run *run)
{
    return run->relative_error > error_limit;
}

// a hundred-thousandth of the length is told
int rod_decimals(const run_result *r)
{
    const double decimals = ceil(5 - log10(fmax(1e3 * r->rod_length, 1e-9)) + 0.9);
    return (int)fmin(fmax(decimals, 1), 12);
}

// A rod of one curvature is met by a closed form: what is left are roundings, counted, not measured
static const double rounding_floor = 1e-15;

static status error_cell(bytes *page, const struct rod_run *run)
{
    status st = OK;
    const bool bad = rod_error_is_large(run);
    PAGE("<td%s>%s%s</td>", bad ? " class=\"bad\"" : "",
         isnan(run->relative_error)             ? "not known"
         : run->relative_error < rounding_floor ? "below 10⁻¹⁵"
                                                : number_digits(run->relative_error, 2).text,
         bad ? " ⚠" : "");

done:
    return st;
}

// --- the shapes

static status shape_head(bytes *page, const rod_result *rod, const rod_rows *rows)
{
    status st = OK;

    PAGE("<thead><tr><th>no.</th>");
    for (int i = 0; i < rows->ntendon; i++) {
        PAGE("<th>");
        TRY(page_escaped(page, rod->tendon_name[i]));
        PAGE("<small>N</small></th>");
    }
    for (int i = 0; i < rows->nload; i++) {
        PAGE("<th>");
        TRY(page_escaped(page, rod->load_name[i]));
        PAGE("<small>factor</small></th>");
    }
    PAGE("<th>tip<small>x, y, z in mm</small></th><th>bend<small>deg</small></th>");
    for (int i = 0; i < rows->ntendon; i++) {
        PAGE("<th>length of ");
        TRY(page_escaped(page, rod->tendon_name[i]));
        PAGE("<small>mm</small></th>");
    }
    PAGE("<th>largest strain<small>its size, %%</small></th><th>rel. error<small>of the "
         "tip</small></th></tr></thead>\n");

done:
    return st;
}

// as given, or what a given length needs
static status tension_cell(bytes *page, const struct rod_run *run, int tendon)
{
    status st = OK;
    const number_text tension = number_short(run->tension[tendon], 4);
    if (isnan(run->pull[tendon])) {
        PAGE("<td>%s</td>", tension.text);
    } else {
        PAGE("<td>%s<small>drawn %s mm</small></td>",
             result_is_slack(run, tendon) ? "slack" : tension.text,
             number_short(run->pull[tendon] * 1e3, 4).text);
    }

done:
    return st;
}

static status shape_row(bytes *page, const run_result *r, const rod_rows *rows, int solution)
{
    status st = OK;
    const struct rod_run *run = &r->rod.run[solution];
    const bool beyond = result_beyond_linear(r, run) >= 0;
    const int decimals = rod_decimals(r);

    PAGE("<tr><td>%d%s</td>", solution + 1, run->fraction < 1 ? " ⚠" : "");
    for (int i = 0; i < rows->ntendon; i++) {
        TRY(tension_cell(page, run, i));
    }
    for (int i = 0; i < rows->nload; i++) {
        PAGE("<td>%s</td>", number_short(run->load[i], 4).text);
    }
    PAGE("<td>%s, %s, %s</td>", number_fixed(run->tip.p.a[0] * 1e3, decimals).text,
         number_fixed(run->tip.p.a[1] * 1e3, decimals).text,
         number_fixed(run->tip.p.a[2] * 1e3, decimals).text);
    PAGE("<td>%s</td>", number_fixed(degrees(run->total_bend_rad), 2).text);
    for (int i = 0; i < rows->ntendon; i++) {
        PAGE("<td>%s</td>", number_fixed(run->tendon_length[i] * 1e3, decimals).text);
    }
    PAGE("<td%s>%s%s</td>", beyond ? " class=\"bad\"" : "",
         number_digits(run->largest_strain * 100, 3).text, beyond ? " ⚠" : "");
    TRY(error_cell(page, run));
    PAGE("</tr>\n");

done:
    return st;
}

static status shapes(bytes *page, const run_result *r, const rod_rows *rows)
{
    status st = OK;
    PAGE("<div class=\"scroll\"><table>\n<caption>One row for each solution; a tendon's "
         "length is what lies inside the body</caption>\n");
    TRY(shape_head(page, &r->rod, rows));
    PAGE("<tbody>\n");
    for (int i = 0; i < rows->count; i++) {
        TRY(shape_row(page, r, rows, rows->row[i]));
    }
    PAGE("</tbody></table></div>\n");
    if (rows->count < r->rod.nsolution) {
        PAGE("<p class=\"note\">%d of %d solutions, at equal steps; all are in rods.csv, their "
             "shapes in shapes.csv.</p>\n",
             rows->count, r->rod.nsolution);
    }
    if (rows->ntendon < r->rod.ntendon || (rows->nload > 0 && rows->nload < r->rod.nload)) {
        PAGE("<p class=\"note\">The first %d of %d tendons and %d of %d loads; all are in "
             "rods.csv.</p>\n",
             rows->ntendon, r->rod.ntendon, rows->nload, r->rod.nload);
    }

done:
    return st;
}

// --- in words

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
             number_digits(most * 100, 3).text);
    } else if (beyond > 0) {
        PAGE("<p class=\"note warn\" id=\"linear\">⚠ %d of %d shapes strain the section by more "
             "than what keeps ",
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

static status heading(bytes *page, const run_result *r)
{
    status st = OK;
    const rod_result *rod = &r->rod;
    const vec3 base = vec3_scale(1e3, rod->run[0].shape[0].p);
    const int decimals = rod_decimals(r) > 2 ? 2 : rod_decimals(r);

    PAGE("<h2 id=\"rod\">Rod under its %s</h2>\n<p>Length %s mm, clamped at ",
         rod->nload == 0     ? "tendons"
         : rod->ntendon == 0 ? "loads"
                             : "tendons and loads",
         number_short(r->rod_length * 1e3, 6).text);
    if (vec3_norm(base) == 0) {
        PAGE("the origin. ");
    } else {
        PAGE("(%s, %s, %s) mm. ", number_fixed(base.a[0], decimals).text,
             number_fixed(base.a[1], decimals).text, number_fixed(base.a[2], decimals).text);
    }
    PAGE("Strains are principal ones, over the whole section and along the rod.</p>\n");

done:
    return st;
}

// a picture holds as many shapes as can be told apart
static status figure_of_some(bytes *page, const rod_show *show, const char *dir, const char *name,
                             const char *what)
{
    char which[80], caption[200];
    rod_show_words(show, which, sizeof which);
    (void)snprintf(caption, sizeof caption, "%s of %s.", what, which);
    return page_figure(page, dir, name, caption);
}

status page_rod(bytes *page, const run_result *r, const char *dir)
{
    status st = OK;
    const rod_result *rod = &r->rod;
    if (!r->has_rod || rod->nsolution == 0 || rod->npoint < 2) {
        return OK;
    }
    const rod_rows rows = rod_rows_choose(rod);
    rod_show show = {0};

    TRY(rod_show_make(rod, &show));
    TRY(heading(page, r));
    TRY(page_rod_warnings(page, r));
    TRY(page_rod_view(page, r));
    TRY(figure_of_some(page, &show, dir, "rods", "Shapes"));
    TRY(page_rod_loads(page, r));
    TRY(strain_warning(page, r));
    TRY(shapes(page, r, &rows));
    TRY(page_figure(page, dir, "sweep", "Tip, bend and strain along the sweep."));
    TRY(page_rod_equilibria(page, r, &rows));
    TRY(page_strains(page, r));
    TRY(figure_of_some(page, &show, dir, "curvature",
                       "Curvature, twist and strains along the rod, in the body frame,"));
    TRY(figure_of_some(page, &show, dir, "wrench",
                       "The section's force and moment along the rod,"));
    TRY(figure_of_some(page, &show, dir, "tendons",
                       "Paths of the tendons, and the tension along each,"));

done:
    rod_show_free(&show);
    return st;
}
