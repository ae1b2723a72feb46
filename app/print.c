// app/print.c
#include "app/print.h"

#include "app/command.h"
#include "reports/markup.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// K_ij over sqrt(K_ii K_jj) below this is the rounding of a solve and is shown as 0
static const double rounding = 1e-11;

static const double degrees = 180 / 3.14159265358979323846;

double print_shown(double value, double last_digit)
{
    return fabs(value) < 0.5 * last_digit ? 0 : value;
}

print_words print_plain(const char *words)
{
    print_words out;
    (void)utf8_clean(words, out.text, sizeof out.text);
    return out;
}

void print_stiffness(const char *title, const mat6 *K)
{
    static const char *const names[6] = {"nx", "ny", "nz", "mx", "my", "mz"};
    printf("%s\n    ", title);
    for (int j = 0; j < 6; j++) {
        printf(" %13s", names[j]);
    }
    putchar('\n');
    for (int i = 0; i < 6; i++) {
        printf("  %s", names[i]);
        for (int j = 0; j < 6; j++) {
            const double size = sqrt(fabs(K->a[i][i] * K->a[j][j]));
            const double value = fabs(K->a[i][j]) < rounding * size ? 0 : K->a[i][j];
            printf(" %13.6g", value * (i < 3 ? 1 : 1e3) * (j < 3 ? 1 : 1e3));
        }
        putchar('\n');
    }
}

void print_section(const run_result *r)
{
    static const char *const models[] = {"full (warping)", "classical"};
    const section_result *section = &r->section;
    char effort[SECTION_EFFORT_WORDS];
    printf("section: %s, %d station%s, %s\n", models[r->section_model], section->nstation,
           section->nstation == 1 ? "" : "s", section_effort_words(&section->effort, effort));
    if (section->resolution > 0) {
        printf("pixels twice as wide would move its stiffness by %.1e: so much they are worth\n",
               section->resolution);
    }
    if (section->effort.uneven) {
        printf("its shapes turn at different rates: K is that of a section that does not turn\n");
    }
    printf("%9s %10s %8s %8s %8s %10s %10s %10s %8s %8s %8s\n", "s", "EA", "x_nc", "y_nc", "angle",
           "EI x'", "EI y'", "GJ", "x_sc", "y_sc", "error");
    printf("%9s %10s %8s %8s %8s %10s %10s %10s %8s %8s %8s\n", "mm", "N", "mm", "mm", "deg",
           "N mm^2", "N mm^2", "N mm^2", "mm", "mm", "relative");
    for (int i = 0; i < section->nstation; i++) {
        const section_station *one = &section->station[i];
        const beam_centres *c = &one->centres;
        printf("%9.3f %10.5g %8.4f %8.4f %8.3f %10.5g %10.5g %10.5g %8.4f %8.4f %8.1e\n",
               1e3 * one->s, c->EA, print_shown(1e3 * c->stiffness_centre[0], 1e-4),
               print_shown(1e3 * c->stiffness_centre[1], 1e-4),
               print_shown(degrees * c->principal_angle, 1e-3), 1e6 * c->EI[0], 1e6 * c->EI[1],
               1e6 * c->GJ, print_shown(1e3 * c->shear_centre[0], 1e-4),
               print_shown(1e3 * c->shear_centre[1], 1e-4), one->law.relative_error);
    }
    if (section->station[0].centres.isotropic) {
        printf("no preferred axes at the first station: its angle is 0 by convention\n");
    }
    print_stiffness("stiffness at the first station, about the geometric centre [N, N mm, N mm^2]",
                    &section->station[0].law.K);
    print_answers(r);
}

static double angle_of(const double *rotation)
{
    return degrees *
           sqrt(rotation[0] * rotation[0] + rotation[1] * rotation[1] + rotation[2] * rotation[2]);
}

static void print_effort(const segment_result *fem)
{
    static const char *const ways[] = {"one mesh", "doubling", "direct", "iterative"};
    printf("way: %s, %d mesh%s, %.3g s of processor time%s%s\n", ways[(unsigned)fem->way % 4],
           fem->rungs, fem->rungs == 1 ? "" : "es",
           fem->assemble_seconds + fem->factor_seconds + fem->solve_seconds,
           fem->why[0] ? "; " : "", fem->why);
    printf("estimated error of the tip compliance %.1e", fem->relative_error);
    if (isfinite(fem->middle.relative_error)) {
        printf(", of the middle's law %.1e", fem->middle.relative_error);
    }
    printf("; residual %.1e\n", fem->residual);
}

// nothing where the section changes along the body
static void print_ends(const segment_result *fem)
{
    if (isnan(fem->end_length[NZ])) {
        return;
    }
    printf(
        "length that both ends take, mm: shear %.4g %.4g, stretch %.4g, bending %.4g %.4g, twist "
        "%.4g\n",
        1e3 * fem->end_length[0], 1e3 * fem->end_length[1], 1e3 * fem->end_length[2],
        1e3 * fem->end_length[3], 1e3 * fem->end_length[4], 1e3 * fem->end_length[5]);
}

void print_segment(const run_result *r)
{
    static const char *const bases[] = {"clamped", "free to contract", "free"};
    static const char *const tips[] = {"rigid", "E-proportional", "uniform", "free"};
    const segment_result *fem = &r->segment;
    printf("3D segment: %.4g mm, base %s, tip %s, %lld unknowns\n", 1e3 * r->segment_length,
           bases[(unsigned)r->segment_base % 3], tips[(unsigned)r->segment_tip % 4], fem->dofs);
    print_effort(fem);
    const bool law = isfinite(fem->middle.K.a[NZ][NZ]); // not where walls are held
    if (law) {
        printf("centre found by FEM: x = %.4f mm, y = %.4f mm\n",
               print_shown(1e3 * fem->stiffness_centre[0], 1e-4),
               print_shown(1e3 * fem->stiffness_centre[1], 1e-4));
    }
    printf("%-24s %17s %12s %10s %21s %12s\n", "load", "at x, y mm", "shortening", "tip angle",
           "mid curvature x, y", "energy");
    printf("%-24s %17s %12s %10s %21s %12s\n", "", "", "mm", "deg", "1/m", "mJ");
    for (int i = 0; i < fem->nload; i++) {
        const segment_load_result *load = &fem->load[i];
        printf("%-24.24s %8.4f %8.4f %12.6f %10.4f %10.5f %10.5f %12.6f\n",
               load->name ? load->name : "", print_shown(1e3 * load->point[0], 1e-4),
               print_shown(1e3 * load->point[1], 1e-4), print_shown(1e3 * load->shortening, 1e-6),
               angle_of(load->tip_rotation), load->mid_curvature[0], load->mid_curvature[1],
               1e3 * load->strain_energy);
    }
    print_ends(fem);
    if (law) {
        print_stiffness("stiffness of the middle, about the geometric centre [N, N mm, N mm^2]",
                        &fem->middle.K);
    } else {
        printf("springs or holds on its walls: the middle has no law of its own\n");
    }
}

static const char *verdict(const compare_row *row, bool colour)
{
    if (row->skipped) {
        return "skipped";
    }
    if (colour) {
        return row->ok ? "\033[32mok\033[0m" : "\033[31mOUT\033[0m";
    }
    return row->ok ? "ok" : "OUT";
}

void print_compare(const run_result *r)
{
    const bool colour = command_colour();
    int width = 4;
    for (int i = 0; i < r->ncompare; i++) {
        const int length = (int)strlen(r->compare[i].what);
        width = length > width ? length : width;
    }
    printf("%-*s %13s %13s %-11s %9s %9s verdict\n", width, "what", "ours", "other", "unit",
           "difference", "tolerance");
    for (int i = 0; i < r->ncompare; i++) {
        const compare_row *row = &r->compare[i];
        if (row->skipped) {
            printf("%-*s skipped: %s\n", width, row->what, row->reason);
            continue;
        }
        printf("%-*s %13.7g %13.7g %-11s %9.1e %9.1e %s\n", width, row->what, row->ours, row->other,
               row->unit, row->difference, row->tolerance, verdict(row, colour));
    }
    printf("tolerances\n");
    for (int i = 0; i < r->ncompare; i++) {
        const compare_row *row = &r->compare[i];
        if (!row->skipped && (i == 0 || r->compare[i - 1].skipped ||
                              strcmp(r->compare[i - 1].reason, row->reason) != 0)) {
            printf("  %.1e  %s\n", row->tolerance, row->reason);
        }
    }
    print_models(r);
    print_measured(r);
}
