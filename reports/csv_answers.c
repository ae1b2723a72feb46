// reports/csv_answers.c
#include "reports/csv_kit.h"

#include <math.h>
#include <stdio.h>

void csv_add_answers(csv_header *h)
{
    csv_add_all(h, "turn_rate_rad_per_m shear_stiffness_1_N shear_stiffness_2_N shear_angle_rad "
                   "geometric_centre_x_m geometric_centre_y_m mass_kg_per_m mass_centre_x_m "
                   "mass_centre_y_m mass_moment_xx_kgm mass_moment_yy_kgm mass_moment_xy_kgm "
                   "EI_warping_Nm4");
}

// int rho y^2, int rho x^2, int rho x y about the geometric centre
static void write_mass(csv *c, const section_mass *mass)
{
    csv_real(c, mass->mass);
    csv_reals(c, 2, mass->mass_centre);
    csv_real(c, mass->matrix.a[MX][MX]);
    csv_real(c, mass->matrix.a[MY][MY]);
    csv_real(c, -mass->matrix.a[MX][MY]);
}

void csv_answers(csv *c, const run_result *r, int station)
{
    static const double unknown[6] = {NAN, NAN, NAN, NAN, NAN, NAN};
    const section_station *s = &r->section.station[station];
    const section_answers *a = result_answers(r, station);
    section_axes axes = {.shear_stiffness = {NAN, NAN}, .shear_angle = NAN};
    if (section_axes_of(&s->law, &s->centres, &axes) != OK) {
        status_clear(); // a stored law: the table says that there is no number
    }
    csv_real(c, s->turn_rate);
    csv_reals(c, 2, axes.shear_stiffness);
    csv_real(c, axes.shear_angle);
    csv_reals(c, 2, a ? a->mass.centre : unknown);
    if (a && a->mass.known) {
        write_mass(c, &a->mass);
    } else {
        csv_reals(c, 6, unknown);
    }
    csv_real(c, a ? a->EI_warping : NAN);
}

// a case has no more; a file that says so has columns for these only
enum { MOST_MATERIALS_SHOWN = 64 };

static int shown(const run_result *r)
{
    return r->nmaterial < MOST_MATERIALS_SHOWN ? r->nmaterial : MOST_MATERIALS_SHOWN;
}

void csv_add_strains(csv_header *h, const run_result *r)
{
    for (int i = 0; i < shown(r); i++) {
        static const char *const what[] = {"strain", "s", "x", "y"};
        for (int k = 0; k < 4; k++) {
            char name[CSV_MAX_NAME];
            (void)snprintf(name, sizeof name, "largest_%s_%d_%.40s_%s", what[k], i + 1,
                           r->materials[i].name, k == 0 ? "ratio" : "m");
            csv_add(h, name);
        }
    }
}

void csv_strains(csv *c, const run_result *r, const struct rod_run *run)
{
    for (int i = 0; i < shown(r); i++) {
        const section_strain_place unknown = {NAN, NAN, {NAN, NAN}};
        const section_strain_place *e = run->strain ? &run->strain[i] : &unknown;
        csv_real(c, e->value);
        csv_real(c, e->s);
        csv_reals(c, 2, e->at);
    }
}

status csv_kern(const run_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    if (r->nanswer == 0) {
        return OK;
    }
    csv_add_all(&h, "s_m x_m y_m");
    const status st = csv_table(dir, "kern.csv", &h, &c);
    for (int i = 0; st == OK && i < r->nanswer; i++) {
        const section_answers *a = &r->answer[i];
        for (int k = 0; k < a->nkern; k++) {
            csv_real(c, r->section.station[a->station].s);
            csv_reals(c, 2, a->kern[k]);
        }
    }
    return st == OK ? csv_close(c) : st;
}

static void write_extreme(csv *c, const section_extreme *e)
{
    csv_real(c, e->value);
    csv_reals(c, 2, e->at);
}

static void write_load(csv *c, const run_result *r, double s, const section_load_answer *load)
{
    for (int m = 0; m < r->nmaterial; m++) {
        const section_extremes *e = &load->extreme[m];
        if (e->used) {
            csv_text(c, load->name);
            csv_text(c, r->materials[m].name);
            csv_real(c, s);
            csv_reals(c, 2, load->at);
            csv_reals(c, 3, load->force);
            csv_reals(c, 3, load->moment);
            write_extreme(c, &e->strain);
            write_extreme(c, &e->von_mises);
            write_extreme(c, &e->axial_highest);
            write_extreme(c, &e->axial_lowest);
        }
    }
}

status csv_stresses(const run_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    if (r->nanswer == 0 || r->answer[0].nload == 0) {
        return OK;
    }
    csv_add_all(&h, "wrench material s_m at_x_m at_y_m force_x_N force_y_N force_z_N moment_x_Nm "
                    "moment_y_Nm moment_z_Nm largest_strain_ratio strain_x_m strain_y_m "
                    "von_mises_Pa von_mises_x_m von_mises_y_m axial_highest_Pa axial_highest_x_m "
                    "axial_highest_y_m axial_lowest_Pa axial_lowest_x_m axial_lowest_y_m");
    const status st = csv_table(dir, "stresses.csv", &h, &c);
    for (int i = 0; st == OK && i < r->nanswer; i++) {
        for (int k = 0; k < r->answer[i].nload; k++) {
            const double s = r->section.station[r->answer[i].station].s;
            write_load(c, r, s, &r->answer[i].load[k]);
        }
    }
    return st == OK ? csv_close(c) : st;
}
