// app/print_answers.c
#include "app/print.h"

#include <math.h>
#include <stdio.h>

static const double degrees = 180 / 3.14159265358979323846;

static void print_point(const double at[2])
{
    printf(" %8.4f %8.4f", print_shown(1e3 * at[0], 1e-4), print_shown(1e3 * at[1], 1e-4));
}

static void print_shear(const section_station *s)
{
    section_axes axes = {0};
    if (section_axes_of(&s->law, &s->centres, &axes) != OK) {
        status_clear();
        return;
    }
    printf("shear stiffness there: %.6g N along x'', %.6g N along y'', x'' turned by %.3f deg\n",
           axes.shear_stiffness[0], axes.shear_stiffness[1],
           print_shown(degrees * axes.shear_angle, 1e-3));
}

static void print_points(const run_result *r)
{
    for (int i = 0; i < r->npoint; i++) {
        char title[120];
        const double *at = r->point[i];
        const mat6 K = beam_law_move(r->section.station[0].law.K, at[0], at[1], 0);
        (void)snprintf(title, sizeof title,
                       "stiffness at the first station, about (%.6g, %.6g) mm [N, N mm, N mm^2]",
                       1e3 * at[0], 1e3 * at[1]);
        print_stiffness(title, &K);
    }
}

static void print_body(const section_answers *a)
{
    printf("area's centre (%.4f, %.4f) mm", print_shown(1e3 * a->mass.centre[0], 1e-4),
           print_shown(1e3 * a->mass.centre[1], 1e-4));
    if (a->mass.known) {
        printf(", mass %.6g g/m with its centre at (%.4f, %.4f) mm", 1e3 * a->mass.mass,
               print_shown(1e3 * a->mass.mass_centre[0], 1e-4),
               print_shown(1e3 * a->mass.mass_centre[1], 1e-4));
    }
    if (isfinite(a->EI_warping)) {
        printf(", warping constant E I_w = %.6g N mm^4", 1e12 * a->EI_warping);
    }
    (void)putchar('\n');
}

static void print_load(const run_result *r, const section_load_answer *load, double s)
{
    printf("wrench '%s' at s = %.4g mm: force (%.4g, %.4g, %.4g) N at (%.4f, %.4f) mm, moment "
           "(%.4g, %.4g, %.4g) N mm\n",
           load->name, 1e3 * s, load->force[0], load->force[1], load->force[2],
           print_shown(1e3 * load->at[0], 1e-4), print_shown(1e3 * load->at[1], 1e-4),
           1e3 * load->moment[0], 1e3 * load->moment[1], 1e3 * load->moment[2]);
    printf("  %-16s %9s %17s %11s %17s %11s %11s\n", "material", "strain %", "at x, y mm",
           "Mises MPa", "at x, y mm", "zz from MPa", "to MPa");
    for (int i = 0; i < r->nmaterial; i++) {
        const section_extremes *e = &load->extreme[i];
        const double limit = r->materials[i].linear_strain;
        if (e->used) {
            printf("  %-16.16s %8.4f%s", r->materials[i].name, 100 * e->strain.value,
                   limit > 0 && fabs(e->strain.value) > limit ? "!" : " ");
            print_point(e->strain.at);
            printf(" %11.5g", 1e-6 * e->von_mises.value);
            print_point(e->von_mises.at);
            printf(" %11.5g %11.5g\n", 1e-6 * e->axial_lowest.value, 1e-6 * e->axial_highest.value);
        }
    }
}

void print_answers(const run_result *r)
{
    print_shear(&r->section.station[0]);
    print_points(r);
    for (int i = 0; i < r->nanswer; i++) {
        const section_answers *a = &r->answer[i];
        if (i == 0) {
            print_body(a);
        }
        for (int k = 0; k < a->nload; k++) {
            print_load(r, &a->load[k], r->section.station[a->station].s);
        }
    }
}

// the solution that strains a material most; -1: none does
static int worst_solution(const rod_result *rod, int material)
{
    int worst = -1;
    double most = 0;
    for (int i = 0; i < rod->nsolution; i++) {
        const double strain = rod->run[i].strain ? fabs(rod->run[i].strain[material].value) : 0;
        if (strain > most) {
            most = strain;
            worst = i;
        }
    }
    return worst;
}

void print_strains(const run_result *r)
{
    bool beyond = false;
    for (int m = 0; m < r->nmaterial; m++) {
        const int worst = worst_solution(&r->rod, m);
        if (worst < 0) {
            continue;
        }
        const section_strain_place *e = &r->rod.run[worst].strain[m];
        const double limit = r->materials[m].linear_strain;
        const bool past = limit > 0 && fabs(e->value) > limit;
        printf("largest strain of %s: %.3g %%%s in solution %d, at s = %.4g mm, (x, y) = (%.4f, "
               "%.4f) mm",
               r->materials[m].name, 100 * e->value, past ? "!" : "", worst + 1, 1e3 * e->s,
               print_shown(1e3 * e->at[0], 1e-4), print_shown(1e3 * e->at[1], 1e-4));
        if (limit > 0) {
            printf("; close to linear up to %.3g %%", 100 * limit);
        }
        (void)putchar('\n');
        beyond = beyond || past;
    }
    if (beyond) {
        printf("! strain beyond where the material stops being close to linear\n");
    }
}
