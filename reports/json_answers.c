// reports/json_answers.c
#include "reports/json_parts.h"

#include <math.h>

static void write_mass(json *j, const section_mass *mass)
{
    if (!mass || !mass->known) {
        json_null(j, "mass_kg_per_m");
        json_null(j, "mass_centre_m");
        json_null(j, "mass_matrix");
        return;
    }
    json_real(j, "mass_kg_per_m", mass->mass);
    json_reals(j, "mass_centre_m", 2, mass->mass_centre);
    json_mat6(j, "mass_matrix", mass->matrix);
}

static void write_kern(json *j, const section_answers *a)
{
    if (a->nkern == 0) {
        json_null(j, "kern_m");
        return;
    }
    json_array(j, "kern_m");
    for (int i = 0; i < a->nkern; i++) {
        json_reals(j, NULL, 2, a->kern[i]);
    }
    json_array_end(j);
}

static void write_extreme(json *j, const char *key, const section_extreme *e)
{
    json_object(j, key);
    json_real(j, "value", e->value);
    json_reals(j, "at_m", 2, e->at);
    json_object_end(j);
}

static void write_load(json *j, const run_result *r, const section_load_answer *load)
{
    json_object(j, NULL);
    json_text(j, "name", load->name);
    json_reals(j, "at_m", 2, load->at);
    json_reals(j, "force_N", 3, load->force);
    json_reals(j, "moment_Nm", 3, load->moment);
    json_array(j, "materials");
    for (int i = 0; i < r->nmaterial; i++) {
        const section_extremes *e = &load->extreme[i];
        if (e->used) {
            json_object(j, NULL);
            json_text(j, "name", r->materials[i].name);
            write_extreme(j, "largest_strain", &e->strain);
            write_extreme(j, "von_mises_Pa", &e->von_mises);
            write_extreme(j, "axial_stress_highest_Pa", &e->axial_highest);
            write_extreme(j, "axial_stress_lowest_Pa", &e->axial_lowest);
            json_object_end(j);
        }
    }
    json_array_end(j);
    json_object_end(j);
}

static void write_points(json *j, const run_result *r, const section_station *s)
{
    json_array(j, "points");
    for (int i = 0; i < r->npoint; i++) {
        const double *at = r->point[i];
        json_object(j, NULL);
        json_reals(j, "at_m", 2, at);
        json_mat6(j, "K", beam_law_move(s->law.K, at[0], at[1], 0));
        json_object_end(j);
    }
    json_array_end(j);
}

status json_station_answers(json *j, const run_result *r, int station)
{
    status st = OK;
    const section_station *s = &r->section.station[station];
    const section_answers *a = result_answers(r, station);
    section_axes axes = {0};
    TRY(section_axes_of(&s->law, &s->centres, &axes));
    json_real(j, "turn_rate_rad_per_m", s->turn_rate);
    json_reals(j, "shear_stiffness_N", 2, axes.shear_stiffness);
    json_real(j, "shear_angle_rad", axes.shear_angle);
    json_mat6(j, "K_principal", axes.K_principal);
    write_points(j, r, s);
    if (!a) {
        json_null(j, "geometric_centre_m");
        write_mass(j, NULL);
        json_null(j, "EI_warping_Nm4");
        json_null(j, "kern_m");
        json_null(j, "wrenches");
        goto done;
    }
    json_reals(j, "geometric_centre_m", 2, a->mass.centre);
    write_mass(j, &a->mass);
    json_real(j, "EI_warping_Nm4", a->EI_warping);
    write_kern(j, a);
    json_array(j, "wrenches");
    for (int i = 0; i < a->nload; i++) {
        write_load(j, r, &a->load[i]);
    }
    json_array_end(j);

done:
    return st;
}

void json_run_strains(json *j, const run_result *r, const struct rod_run *run)
{
    json_array(j, "materials");
    for (int i = 0; run->strain && i < r->nmaterial; i++) {
        const section_strain_place *e = &run->strain[i];
        const double limit = r->materials[i].linear_strain;
        json_object(j, NULL);
        json_text(j, "name", r->materials[i].name);
        json_real(j, "largest_strain", e->value);
        json_real(j, "s_m", e->s);
        json_reals(j, "at_m", 2, e->at);
        json_real(j, "linear_strain", limit > 0 ? limit : NAN);
        json_object_end(j);
    }
    json_array_end(j);
}
