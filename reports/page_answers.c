// reports/page_answers.c
#include "reports/page_kit.h"

#include <math.h>
#include <stdio.h>

static status row(bytes *page, const char *what, const char *value, const char *unit,
                  const char *where)
{
    status st = OK;
    PAGE("<tr><th>%s</th><td>%s</td><td>%s</td><td>%s</td></tr>\n", what, value, unit, where);

done:
    return st;
}

typedef struct pair_text {
    char text[96];
} pair_text;

static pair_text pair(const double v[2], double unit, int decimals)
{
    pair_text p;
    (void)snprintf(p.text, sizeof p.text, "%s, %s", number_fixed(v[0] * unit, decimals).text,
                   number_fixed(v[1] * unit, decimals).text);
    return p;
}

static status body_rows(bytes *page, const section_answers *a)
{
    status st = OK;
    TRY(row(page, "centre of the area", pair(a->mass.centre, 1e3, 5).text, "mm",
            "from the origin"));
    if (a->mass.known) {
        TRY(row(page, "mass per length", number_digits(a->mass.mass * 1e3, 7).text, "g/m", ""));
        TRY(row(page, "mass centre", pair(a->mass.mass_centre, 1e3, 5).text, "mm",
                "from the origin"));
    }
    if (isfinite(a->EI_warping)) {
        TRY(row(page, "warping constant E I<sub>ω</sub>",
                number_digits(a->EI_warping * 1e12, 7).text, "N mm⁴", "about the shear centre"));
    }

done:
    return st;
}

static status more_numbers(bytes *page, const run_result *r)
{
    status st = OK;
    const section_station *s = &r->section.station[0];
    const section_answers *a = result_answers(r, 0);
    section_axes axes = {0};
    if (section_axes_of(&s->law, &s->centres, &axes) != OK) {
        status_clear(); // a stored law that is none has no axes to show
        return OK;
    }
    PAGE(
        "<div class=\"scroll\"><table>\n<caption>More of the section at s = %s mm</caption>\n"
        "<thead><tr><th></th><th>value</th><th>unit</th><th>reference</th></tr></thead>\n<tbody>\n",
        number_short(s->s * 1e3, 6).text);
    TRY(row(page, "shear stiffness along x″", number_digits(axes.shear_stiffness[0], 7).text, "N",
            "at the shear centre"));
    TRY(row(page, "shear stiffness along y″", number_digits(axes.shear_stiffness[1], 7).text, "N",
            "at the shear centre"));
    TRY(row(page, "x″ turned", number_fixed(axes.shear_angle * 180 / acos(-1.0), 3).text, "deg",
            "from x"));
    if (s->turn_rate != 0) {
        TRY(row(page, "turning rate of the pattern", number_digits(s->turn_rate, 7).text, "rad/m",
                "about z"));
    }
    TRY(a ? body_rows(page, a) : OK);
    PAGE("</tbody></table></div>\n");

done:
    return st;
}

static status load_rows(bytes *page, const run_result *r, double s, const section_load_answer *load)
{
    status st = OK;
    for (int m = 0; m < r->nmaterial; m++) {
        const section_extremes *e = &load->extreme[m];
        const double limit = r->materials[m].linear_strain;
        const bool beyond = limit > 0 && fabs(e->strain.value) > limit;
        if (!e->used) {
            continue;
        }
        PAGE("<tr><td>%s</td><td>", number_fixed(s * 1e3, 3).text);
        TRY(page_escaped(page, load->name));
        PAGE("</td><td>");
        TRY(page_escaped(page, r->materials[m].name));
        PAGE("</td><td%s>%s%s</td><td>%s</td>", beyond ? " class=\"bad\"" : "",
             number_fixed(e->strain.value * 100, 4).text, beyond ? " ⚠" : "",
             pair(e->strain.at, 1e3, 4).text);
        PAGE("<td>%s</td><td>%s</td>", number_digits(e->von_mises.value * 1e-6, 6).text,
             pair(e->von_mises.at, 1e3, 4).text);
        PAGE("<td>%s</td><td>%s</td></tr>\n", number_digits(e->axial_lowest.value * 1e-6, 6).text,
             number_digits(e->axial_highest.value * 1e-6, 6).text);
    }

done:
    return st;
}

static status loads(bytes *page, const run_result *r, const char *dir)
{
    status st = OK;
    if (r->nanswer == 0 || r->answer[0].nload == 0) {
        return OK;
    }
    PAGE("<h3>Strain and stress under wrenches</h3>\n<p>The picture shows the first wrenches, as "
         "many "
         "as its mesh allows; result.hdf holds the fields of all.</p>\n");
    TRY(page_figure(page, dir, "stresses",
                    "Largest principal strain and von Mises stress; rings mark each material's "
                    "largest."));
    PAGE("<div class=\"scroll\"><table>\n<caption>Largest in each material, at the nodes of the "
         "mesh. At re-entrant corners and where materials meet a free edge stresses have no "
         "bound, and these numbers grow with a finer mesh.</caption>\n<thead><tr>");
    PAGE("<th>s<small>mm</small></th><th>wrench</th><th>material</th><th>strain<small>%%, "
         "principal</small></th><th>at<small>x, y in mm</small></th><th>von Mises<small>MPa"
         "</small></th><th>at<small>x, y in mm</small></th><th>σ<sub>zz</sub> from<small>MPa"
         "</small></th><th>to<small>MPa</small></th></tr></thead>\n<tbody>\n");
    for (int i = 0; i < r->nanswer; i++) {
        for (int k = 0; k < r->answer[i].nload; k++) {
            const double s = r->section.station[r->answer[i].station].s;
            TRY(load_rows(page, r, s, &r->answer[i].load[k]));
        }
    }
    PAGE("</tbody></table></div>\n");

done:
    return st;
}

status page_answers(bytes *page, const run_result *r, const char *dir)
{
    status st = OK;
    TRY(more_numbers(page, r));
    TRY(loads(page, r, dir));

done:
    return st;
}

// of every material the worst of all solutions
status page_strains(bytes *page, const run_result *r)
{
    status st = OK;
    if (r->rod.nsolution == 0 || !r->rod.run[0].strain) {
        return OK;
    }
    PAGE("<div class=\"scroll\"><table>\n<caption>The largest principal strain of each material "
         "among all solutions</caption>\n<thead><tr><th>material</th><th>strain<small>%%</small>"
         "</th><th>linear up to<small>%%</small></th><th>solution</th><th>s<small>mm</small></th>"
         "<th>at<small>x, y in mm</small></th></tr></thead>\n<tbody>\n");
    for (int m = 0; m < r->nmaterial; m++) {
        int worst = 0;
        for (int i = 1; i < r->rod.nsolution; i++) {
            const double strain = fabs(r->rod.run[i].strain[m].value);
            worst = strain > fabs(r->rod.run[worst].strain[m].value) ? i : worst;
        }
        const section_strain_place *e = &r->rod.run[worst].strain[m];
        const double limit = r->materials[m].linear_strain;
        const bool beyond = limit > 0 && fabs(e->value) > limit;
        PAGE("<tr><td>");
        TRY(page_escaped(page, r->materials[m].name));
        PAGE("</td><td%s>%s%s</td><td>%s</td><td>%d</td>", beyond ? " class=\"bad\"" : "",
             number_fixed(e->value * 100, 3).text, beyond ? " ⚠" : "",
             limit > 0 ? number_short(limit * 100, 3).text : "", worst + 1);
        PAGE("<td>%s</td><td>%s</td></tr>\n", number_fixed(e->s * 1e3, 2).text,
             pair(e->at, 1e3, 4).text);
    }
    PAGE("</tbody></table></div>\n");

done:
    return st;
}
