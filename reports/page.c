// reports/page.c
#include "reports/figures.h"
#include "reports/page_kit.h"

#include <math.h>
#include <stdio.h>

static const char *verdict(const run_result *r)
{
    return compare_out_of_tolerance(r) > 0 ? "out of tolerance" : "all agree";
}

// `mark` is markup that qualifies it
static status key_number_marked(bytes *page, const char *name, const char *value, const char *unit,
                                const char *mark)
{
    status st = OK;

    PAGE("<div><dt>");
    TRY(page_escaped(page, name));
    PAGE("</dt><dd>%s <small>%s</small>%s</dd></div>\n", value, unit, mark);

done:
    return st;
}

static status key_number(bytes *page, const char *name, const char *value, const char *unit)
{
    return key_number_marked(page, name, value, unit, "");
}

// how many shapes strain a material past what keeps it linear: the bend is that of a linear one
static status largest_bend(bytes *page, const run_result *r)
{
    status st = OK;
    char mark[160] = "";
    double most = 0;
    int beyond = 0;
    for (int i = 0; i < r->rod.nsolution; i++) {
        most = fmax(most, r->rod.run[i].total_bend_rad);
        beyond += result_beyond_linear(r, &r->rod.run[i]) >= 0;
    }
    if (beyond > 0) {
        (void)snprintf(mark, sizeof mark,
                       "<a href=\"#linear\">⚠ %d of %d shapes past the linear strain</a>", beyond,
                       r->rod.nsolution);
    }
    TRY(key_number_marked(page, "Largest bend of the rod",
                          number_fixed(most * 180 / acos(-1.0), 1).text, "deg", mark));

done:
    return st;
}

// n of N targets, of the first few scopes
static status reached_numbers(bytes *page, const reach_result *r)
{
    enum { SHOWN_SCOPES = 6 };
    status st = OK;
    for (int i = 0; r->ntarget > 0 && i < r->nscope && i < SHOWN_SCOPES; i++) {
        char name[REACH_NAME + 40], count[32];
        (void)snprintf(name, sizeof name, "Targets reached: %s", r->scope[i].name);
        (void)snprintf(count, sizeof count, "%d of %d", r->scope[i].nreached, r->ntarget);
        TRY(key_number(page, name, count, r->synthetic ? "in synthetic anatomy" : ""));
    }

done:
    return st;
}

static status key_numbers(bytes *page, const run_result *r)
{
    status st = OK;

    PAGE("<dl class=\"key\">\n");
    if (r->has_section && r->section.nstation > 0) {
        const beam_centres *c = &r->section.station[0].centres;
        const double off = hypot(c->stiffness_centre[0], c->stiffness_centre[1]) * 1e3;
        TRY(key_number(page, "Stiffness centre off the geometric one", number_fixed(off, 4).text,
                       "mm"));
        TRY(key_number(page, "Axial stiffness EA", number_digits(c->EA, 6).text, "N"));
        TRY(key_number(page, "Torsional stiffness GJ", number_digits(c->GJ * 1e6, 6).text,
                       "N mm²"));
    }
    if (r->has_rod && r->rod.nsolution > 0) {
        TRY(largest_bend(page, r));
    }
    for (int i = 0; r->has_segment && i < r->segment.nload && i < 2; i++) {
        const double *w = r->segment.load[i].tip_rotation;
        char name[160];
        (void)snprintf(name, sizeof name, "Segment's tip angle: %.80s",
                       r->segment.load[i].name ? r->segment.load[i].name : "load");
        TRY(key_number(page, name, number_fixed(hypot(w[0], w[1]) * 180 / acos(-1.0), 3).text,
                       "deg"));
    }
    TRY(reached_numbers(page, &r->reach));
    if (r->has_compare && r->ncompare > 0) {
        TRY(key_number(page, "Comparisons", verdict(r), ""));
    }
    PAGE("</dl>\n");

done:
    return st;
}

static status header(bytes *page, const run_result *r)
{
    status st = OK;
    const struct {
        bool there;
        const char *id, *name;
    } parts[] = {
        {r->has_section, "section", "Cross section"},
        {r->has_rod, "rod", "Rod"},
        {r->has_measured, "measured",
         r->measured.nline == 0  ? "The paper's shapes"
         : r->measured.synthetic ? "Synthetic shapes"
                                 : "Measured shapes"},
        {r->has_segment, "segment", "3D segment"},
        {r->fit.there, "fit", "Fit"},
        {r->reach.there, "reach", "Where the scopes reach"},
        {r->has_compare, "compare", "Comparisons"},
        {r->has_sensitivity, "sensitivity", "What moves the answer"},
        {true, "assumptions", "Assumptions"},
        {true, "origin", "Case and versions"},
    };

    PAGE("<header><div>\n<h1>");
    TRY(page_escaped(page, r->title[0] ? r->title : "untitled case"));
    PAGE("</h1>\n<p>From cross section to deformed shape, by stiffaxis %s</p>\n<nav>",
         STIFFAXIS_VERSION);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        if (parts[i].there) {
            PAGE("<a href=\"#%s\">%s</a> ", parts[i].id, parts[i].name);
        }
    }
    PAGE("</nav>\n</div></header>\n");

done:
    return st;
}

static status write_page(const bytes *page, const char *dir)
{
    char path[4096];
    const int n = snprintf(path, sizeof path, "%s/report.html", dir);
    FILE *f = n > 0 && n < (int)sizeof path ? fopen(path, "wb") : NULL;
    if (!f) {
        return status_fail(ERR_RESOURCE, "cannot write the page %s/report.html", dir);
    }
    const size_t written = fwrite(page->data, 1, page->length, f);
    if (fclose(f) != 0 || written != page->length) {
        return status_fail(ERR_RESOURCE, "writing the page %s failed: disk full?", path);
    }
    return OK;
}

status report_page(const run_result *r, const char *dir)
{
    status st = OK;
    bytes text = {0}, *page = &text;

    TRY(page_open(page, r->title[0] ? r->title : "untitled case"));
    TRY(header(page, r));
    PAGE("<main>\n");
    TRY(key_numbers(page, r));
    TRY(page_section(page, r, dir));
    TRY(page_rod(page, r, dir));
    TRY(page_measured(page, r, dir));
    TRY(page_segment(page, r, dir));
    TRY(page_fit(page, r, dir));
    TRY(page_reach(page, r, dir));
    TRY(page_compare(page, r));
    TRY(page_models(page, r));
    TRY(page_sensitivity(page, r, dir));
    TRY(page_assumptions(page, r));
    TRY(page_origin(page, r));
    PAGE("</main>\n<footer><div>Written by stiffaxis %s. Numbers in full precision stand in the "
         "JSON, CSV and "
         "HDF5 files of the same run.</div></footer>\n",
         STIFFAXIS_VERSION);
    TRY(page_close(page));
    TRY(write_page(page, dir));

done:
    bytes_free(&text);
    return st;
}
