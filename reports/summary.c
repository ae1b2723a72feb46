// reports/summary.c
// What the terminal shows: a few aligned lines, plain ASCII but for the user's own words.
#include "reach/reach_case.h"
#include "reports/fig4_paper.h"
#include "reports/figures.h"
#include "reports/page_kit.h"
#include "reports/page_rod_parts.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { COLUMNS = 100, MAX_LINES = 64 };

typedef struct summary {
    int count, room;
    char line[MAX_LINES][4 * COLUMNS + 4]; // four bytes to the character
} summary;

static void add(summary *s, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void add(summary *s, const char *format, ...)
{
    char text[1024];
    va_list arguments;
    if (s->count >= s->room) {
        return;
    }
    va_start(arguments, format);
    (void)vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    utf8_shorten(text, COLUMNS, s->line[s->count], sizeof s->line[0]);
    s->count++;
}

static double degrees(double angle)
{
    return angle * 180 / acos(-1.0);
}

// what rounds to nothing carries no minus
static double plain(double value, double least)
{
    return fabs(value) < least ? 0 : value;
}

static void section_lines(summary *s, const run_result *r)
{
    const section_station *at = &r->section.station[0];
    const beam_centres *c = &at->centres;
    add(s, "section  EA %.6g N   EI %.6g and %.6g N mm^2   GJ %.6g N mm^2   at s = %.4g mm", c->EA,
        c->EI[0] * 1e6, c->EI[1] * 1e6, c->GJ * 1e6, at->s * 1e3);
    add(s, "         stiffness centre (%.4f, %.4f) mm   shear centre (%.4f, %.4f) mm",
        plain(c->stiffness_centre[0] * 1e3, 5e-5), plain(c->stiffness_centre[1] * 1e3, 5e-5),
        plain(c->shear_centre[0] * 1e3, 5e-5), plain(c->shear_centre[1] * 1e3, 5e-5));
    add(s, "         %s model, %d station%s, relative error %.1e",
        r->section_model == MODEL_CLASSICAL ? "classical" : "full", r->section.nstation,
        r->section.nstation == 1 ? "" : "s", at->law.relative_error);
}

// as many decimals as tell a hundred-thousandth of that length
static int decimals_for(double length_mm)
{
    const int decimals = (int)ceil(5 - log10(length_mm > 0 ? length_mm : 1));
    return decimals < 1 ? 1 : decimals < 10 ? decimals : 10;
}

typedef struct mark_text {
    char text[24];
} mark_text;

// the worst that is to be said about a solution
static mark_text mark_of(const struct rod_run *run)
{
    mark_text m = {""};
    if (rod_error_is_large(run)) {
        (void)snprintf(m.text, sizeof m.text, " err %.1g!", run->relative_error);
    } else if (run->fraction < 1) {
        (void)snprintf(m.text, sizeof m.text, " at %.3g!", run->fraction);
    } else if (run->stable == 0) {
        (void)snprintf(m.text, sizeof m.text, " unstable");
    }
    return m;
}

static void rod_line(summary *s, const run_result *r, int solution)
{
    const struct rod_run *run = &r->rod.run[solution];
    char pulled[40] = "";
    const int d = decimals_for(r->rod_length * 1e3);
    const double least = 0.5 * pow(10, -d);
    for (int i = 0; i < r->rod.ntendon; i++) {
        const size_t used = strlen(pulled);
        if (result_is_slack(run, i)) {
            (void)snprintf(pulled + used, sizeof pulled - used, "%sslack", i ? " " : "");
        } else {
            (void)snprintf(pulled + used, sizeof pulled - used, "%s%.3g", i ? " " : "",
                           run->tension[i]);
        }
    }
    const int nload = rod_rows_choose(&r->rod).nload;
    for (int i = 0; i < nload; i++) {
        const size_t used = strlen(pulled);
        (void)snprintf(pulled + used, sizeof pulled - used, "%sx%.3g", used ? " " : "",
                       run->load[i]);
    }
    add(s, "         %-14s tip (%7.*f, %7.*f, %7.*f) mm bend %6.1f deg  strain %4.3g %%%s%s",
        pulled, d, plain(run->tip.p.a[0] * 1e3, least), d, plain(run->tip.p.a[1] * 1e3, least), d,
        plain(run->tip.p.a[2] * 1e3, least), degrees(run->total_bend_rad),
        run->largest_strain * 100, result_beyond_linear(r, run) >= 0 ? "!" : "", mark_of(run).text);
}

// what the marks of the lines mean, those that occur
static int rod_remarks(const run_result *r, summary *s)
{
    const rod_result *rod = &r->rod;
    int beyond = 0, worst = -1, stopped = 0, bad = 0;
    for (int i = 0; i < rod->nsolution; i++) {
        const struct rod_run *run = &rod->run[i];
        const int material = result_beyond_linear(r, run);
        beyond += material >= 0;
        worst = material >= 0 ? material : worst;
        stopped += run->fraction < 1;
        bad += rod_error_is_large(run);
    }
    if (beyond > 0 && s) {
        add(s, "         ! %d of %d strain %s past its linear %.3g %%", beyond, rod->nsolution,
            r->materials[worst].name, r->materials[worst].linear_strain * 100);
    }
    if (stopped > 0 && s) {
        add(s,
            "         ! %d of %d stop at a limit point, before all loads and tensions are reached",
            stopped, rod->nsolution);
    }
    if (bad > 0 && s) {
        add(s, "         ! %d of %d have an estimated error of the tip above 1 %% of the length",
            bad, rod->nsolution);
    }
    return (beyond > 0) + (stopped > 0) + (bad > 0);
}

static void rod_lines(summary *s, const run_result *r, int room)
{
    const rod_result *rod = &r->rod;
    // the heading, perhaps warnings, and as many solutions as fit
    const int space = room - 1 - rod_remarks(r, NULL);
    const int shown = rod->nsolution <= space ? rod->nsolution : space - 1;
    add(s, "rod      %.4g mm%s%s", r->rod_length * 1e3, rod->ntendon > 0 ? ", tensions in N" : "",
        rod_rows_choose(rod).nload > 0 ? ", times (x) loads"
        : rod->nload > 0               ? ", under loads"
                                       : "");
    for (int i = 0; i < shown; i++) {
        rod_line(s, r, i);
    }
    if (shown < rod->nsolution) {
        add(s, "         and %d more in rods.csv", rod->nsolution - (shown > 0 ? shown : 0));
    }
    (void)rod_remarks(r, s);
}

static void segment_lines(summary *s, const run_result *r)
{
    const double rounding = 1e-11; // of a solve with a million unknowns, for a segment of size 1
    const segment_result *g = &r->segment;
    const int shown = g->nload < 4 ? g->nload : 4;
    char centre[64] = ""; // none where springs or holds on the walls take part
    if (isfinite(g->stiffness_centre[0])) {
        (void)snprintf(centre, sizeof centre, ", centre found (%.4f, %.4f) mm",
                       plain(g->stiffness_centre[0] * 1e3, 5e-5),
                       plain(g->stiffness_centre[1] * 1e3, 5e-5));
    }
    add(s, "segment  %.4g mm, %lld unknowns%s", r->segment_length * 1e3, g->dofs, centre);
    for (int i = 0; i < shown; i++) {
        const segment_load_result *l = &g->load[i];
        char name[96];
        utf8_shorten(l->name ? l->name : "load", 18, name, sizeof name);
        // the larger of the two ways in which a tip turns
        const double bend = hypot(l->tip_rotation[0], l->tip_rotation[1]);
        const bool twists = fabs(l->tip_rotation[2]) > bend;
        add(s, "         %-18s shortening %7.4g mm  tip %s %7.4g deg  curvature %7.4g 1/m", name,
            plain(l->shortening, rounding * r->segment_length) * 1e3, twists ? "twist" : "angle",
            degrees(plain(twists ? l->tip_rotation[2] : bend, rounding)),
            plain(hypot(l->mid_curvature[0], l->mid_curvature[1]), rounding / r->segment_length));
    }
    if (shown < g->nload) {
        add(s, "         and %d more in segment.csv", g->nload - shown);
    }
    if (fig4_is(r)) {
        add(s, "         the paper reports: GC 10.7 deg, 9.39 1/m; NC 0.63 mm, under 0.1 deg (see "
               "the page)");
    }
}

static void compare_lines(summary *s, const run_result *r)
{
    const int bad = compare_out_of_tolerance(r), skipped = compare_skipped(r);
    add(s, "compare  %d agree, %d out of tolerance, %d skipped", r->ncompare - bad - skipped, bad,
        skipped);
    for (int i = 0, shown = 0; i < r->ncompare && shown < 3; i++) {
        const compare_row *row = &r->compare[i];
        if (!row->skipped && !row->ok) {
            add(s, "         OUT: %s: %.7g against %.7g %s (%.1e > %.1e)", row->what, row->ours,
                row->other, row->unit, row->difference, row->tolerance);
            shown++;
        }
    }
}

static void measured_lines(summary *s, const run_result *r)
{
    const measured_result *m = &r->measured;
    double tip[2] = {INFINITY, 0}, shape[2] = {INFINITY, 0};
    for (int i = 0; i < m->nline; i++) {
        const shape_error *e = &m->line[i].error;
        tip[0] = fmin(tip[0], e->tip);
        tip[1] = fmax(tip[1], e->tip);
        shape[0] = fmin(shape[0], e->shape);
        shape[1] = fmax(shape[1], e->shape);
    }
    if (m->nline == 0) {
        return;
    }
    add(s, "measured %d %s: tip error %.2f to %.2f mm, shape error %.1f to %.1f %%", m->nline,
        m->synthetic ? (m->nline == 1 ? "SYNTHETIC shape" : "SYNTHETIC shapes")
                     : (m->nline == 1 ? "shape" : "shapes"),
        1e3 * fmin(tip[0], tip[1]), 1e3 * tip[1], 100 * shape[0], 100 * shape[1]);
}

static void fit_lines(summary *s, const run_result *r)
{
    char words[400];
    add(s, "fitted   %s, to %d %sshape%s", fit_result_words(&r->fit, words, sizeof words),
        r->fit.answer.nshape, r->fit.synthetic ? "SYNTHETIC " : "",
        r->fit.answer.nshape == 1 ? "" : "s");
    add(s, "         the lines above have the case's own values; fitted.yaml has these");
}

static void sensitivity_lines(summary *s, const run_result *r)
{
    const sensitivity_result *a = &r->sensitivity;
    double most = -1;
    int mover = 0, solution = 0;
    for (int i = 0; i < a->nmover; i++) {
        for (int k = 0; k < a->nsolution; k++) {
            const double moved = move_largest(sensitivity_move(a, i, k));
            if (moved > most) {
                most = moved;
                mover = i;
                solution = k;
            }
        }
    }
    if (most >= 0) {
        add(s, "moved    the tip the most: %s, by %.4g mm in solution %d", a->mover[mover].name,
            1e3 * most, a->solution[solution] + 1);
    }
    if (a->monte_carlo.nsample > 0) {
        add(s, "         Monte Carlo: %d samples, seed %d, in monte_carlo.csv",
            a->monte_carlo.nsample, a->monte_carlo.seed);
    }
}

static void reach_lines(summary *s, const reach_result *r)
{
    enum { SHOWN = 6 };
    add(s, "reach    %d target%s%s, %s", r->ntarget, r->ntarget == 1 ? "" : "s",
        r->synthetic ? " in SYNTHETIC anatomy" : "",
        r->path == REACH_INSERTION ? "final poses and ways in" : "final poses only");
    for (int i = 0; i < r->nscope && i < SHOWN; i++) {
        const reach_scope_result *one = &r->scope[i];
        char area[64] = "";
        if (one->state) {
            (void)snprintf(area, sizeof area, "   %.1f +- %.1f %% of the wall",
                           100 * one->area_reached, 100 * one->area_error);
        }
        add(s, "         %d of %d%s   %s", one->nreached, r->ntarget, area, one->name);
    }
    if (r->nscope > SHOWN) {
        add(s, "         and %d more scopes in reach_scopes.csv", r->nscope - SHOWN);
    }
    if (r->paper == REACH_PAPER_TABLE_4) {
        add(s,
            "         the paper prints %d and %d of %d, on a patient's anatomy that is not "
            "published",
            PAPER_REACH_CONSTANT_CURVATURE, PAPER_REACH_HELICAL, PAPER_REACH_TARGETS);
    }
    const reach_design_result *d = &r->design;
    if (d->there && d->nrow > 0) {
        const double unit = d->goal == DESIGN_AREA ? 100 : 1;
        char start[32] = "no answer";
        if (isfinite(d->start_goal)) {
            (void)snprintf(start, sizeof start, "%.4g", unit * d->start_goal);
        }
        add(s, "design   %s %.4g%s, at the start %s; %d evaluations, seed %d", d->scope,
            unit * d->row[d->best].goal, d->goal == DESIGN_AREA ? " % of the wall" : " targets",
            start, d->evaluations, d->seed);
    }
}

status report_summary(const run_result *r, int max_lines, void *stdio_stream)
{
    FILE *stream = stdio_stream;
    summary first = {.room = max_lines < MAX_LINES ? max_lines : MAX_LINES}, rest = first;

    add(&first, "%s", r->title[0] ? r->title : "untitled case");
    if (r->has_section && r->section.nstation > 0) {
        section_lines(&first, r);
    }
    if (r->has_measured) {
        measured_lines(&rest, r);
    }
    if (r->fit.there) {
        fit_lines(&rest, r);
    }
    if (r->has_sensitivity) {
        sensitivity_lines(&rest, r);
    }
    if (r->has_segment) {
        segment_lines(&rest, r);
    }
    if (r->reach.there) {
        reach_lines(&rest, &r->reach);
    }
    if (r->has_compare && r->ncompare > 0) {
        compare_lines(&rest, r);
    }
    // the rod, of any number of lines, takes what the others leave
    const int room = first.room - first.count - rest.count;
    if (r->has_rod && r->rod.nsolution > 0 && room > 0) {
        rod_lines(&first, r, room);
    }
    for (int i = 0; i < rest.count; i++) {
        add(&first, "%s", rest.line[i]);
    }
    for (int i = 0; i < first.count; i++) {
        (void)fprintf(stream, "%s\n", first.line[i]);
    }
    return fflush(stream) == 0 && !ferror(stream)
               ? OK
               : status_fail(ERR_RESOURCE, "writing the summary failed: disk full or pipe closed?");
}
