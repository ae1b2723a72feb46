// reports/result_csv.c
// Tables for spreadsheets. Every name of a column of numbers ends in its unit; "ratio" and "count"
// stand for none.
#include "reports/csv_kit.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// the upper half of a stiffness: forces by strains N, couplings N m, moments by curvatures N m^2
static void add_stiffness(csv_header *h)
{
    static const char *const names[] = {"nx", "ny", "nz", "mx", "my", "mz"};
    static const char *const units[] = {"N", "Nm", "Nm2"};
    for (int i = 0; i < 6; i++) {
        for (int k = i; k < 6; k++) {
            char name[CSV_MAX_NAME];
            (void)snprintf(name, sizeof name, "K_%s_%s_%s", names[i], names[k],
                           units[(i >= MX) + (k >= MX)]);
            csv_add(h, name);
        }
    }
}

static void stiffness(csv *c, const mat6 *K)
{
    for (int i = 0; i < 6; i++) {
        csv_reals(c, 6 - i, &K->a[i][i]);
    }
}

static status write_sections(const run_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h,
                "s_m area_m2 EA_N stiffness_centre_x_m stiffness_centre_y_m principal_angle_rad "
                "EI_about_principal_x_Nm2 EI_about_principal_y_Nm2 EIxx_centre_Nm2 EIyy_centre_Nm2 "
                "EIxy_centre_Nm2 GJ_Nm2 shear_centre_x_m shear_centre_y_m relative_error_ratio");
    add_stiffness(&h);
    csv_add_answers(&h);
    const status st = csv_table(dir, "sections.csv", &h, &c);
    for (int i = 0; st == OK && i < r->section.nstation; i++) {
        const section_station *s = &r->section.station[i];
        csv_real(c, s->s);
        csv_real(c, s->law.area);
        csv_real(c, s->centres.EA);
        csv_reals(c, 2, s->centres.stiffness_centre);
        csv_real(c, s->centres.principal_angle);
        csv_reals(c, 2, s->centres.EI);
        csv_reals(c, 3, s->centres.EI_centre);
        csv_real(c, s->centres.GJ);
        csv_reals(c, 2, s->centres.shear_centre);
        csv_real(c, s->law.relative_error);
        stiffness(c, &s->law.K);
        csv_answers(c, r, i);
    }
    return st == OK ? csv_close(c) : st;
}

// one column per tendon; names are numbered, since two tendons may be called the same
static void add_tendons(csv_header *h, const rod_result *rod, const char *what, const char *unit)
{
    for (int i = 0; i < rod->ntendon; i++) {
        char name[CSV_MAX_NAME];
        (void)snprintf(name, sizeof name, "%s_%d_%.40s%s%s", what, i + 1, rod->tendon_name[i],
                       rod->tendon_name[i][0] ? "_" : "", unit);
        csv_add(h, name);
    }
}

// one column per load; a factor has no unit
static void add_loads(csv_header *h, const rod_result *rod)
{
    for (int i = 0; i < rod->nload; i++) {
        char name[CSV_MAX_NAME];
        (void)snprintf(name, sizeof name, "load_%d_%.40s%sratio", i + 1, rod->load_name[i],
                       rod->load_name[i][0] ? "_" : "");
        csv_add(h, name);
    }
}

static void rod_header(csv_header *h, const run_result *r)
{
    const rod_result *rod = &r->rod;
    csv_add_all(h, "solution_count");
    add_tendons(h, rod, "tension", "N");
    csv_add_all(h,
                "tip_x_m tip_y_m tip_z_m tip_Rxx_ratio tip_Rxy_ratio tip_Rxz_ratio tip_Ryx_ratio "
                "tip_Ryy_ratio tip_Ryz_ratio tip_Rzx_ratio tip_Rzy_ratio tip_Rzz_ratio "
                "total_bend_rad");
    add_tendons(h, rod, "length", "m");
    csv_add_all(h, "iterations_count relative_error_ratio largest_strain_ratio");
    csv_add_strains(h, r);
    add_tendons(h, rod, "pull", "m");
    add_loads(h, rod);
    csv_add_all(h, "reached_ratio stable eigenvalue_ratio critical_points_count energy_J work_J "
                   "energy_misfit_ratio residual_ratio");
}

static void write_stability(csv *c, const struct rod_run *run)
{
    csv_real(c, run->fraction);
    csv_text(c, run->stable < 0 ? "" : run->stable ? "true" : "false");
    csv_real(c, run->eigenvalue);
    csv_real(c, run->ncritical);
    csv_real(c, run->energy);
    csv_real(c, run->work);
    csv_real(c, result_energy_misfit(run));
    csv_real(c, run->residual);
}

static status write_rods(const run_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    const rod_result *rod = &r->rod;
    rod_header(&h, r);
    const status st = csv_table(dir, "rods.csv", &h, &c);
    for (int i = 0; st == OK && i < rod->nsolution; i++) {
        const struct rod_run *run = &rod->run[i];
        csv_real(c, i + 1);
        csv_reals(c, rod->ntendon, run->tension);
        csv_reals(c, 3, run->tip.p.a);
        csv_reals(c, 9, &run->tip.R.a[0][0]);
        csv_real(c, run->total_bend_rad);
        csv_reals(c, rod->ntendon, run->tendon_length);
        csv_real(c, run->iterations);
        csv_real(c, run->relative_error);
        csv_real(c, run->largest_strain);
        csv_strains(c, r, run);
        csv_reals(c, rod->ntendon, run->pull);
        csv_reals(c, rod->nload, run->load);
        write_stability(c, run);
    }
    return st == OK ? csv_close(c) : st;
}

static status write_shapes(const run_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    const rod_result *rod = &r->rod;
    csv_add_all(&h,
                "solution_count s_m x_m y_m z_m curvature_x_per_m curvature_y_per_m twist_per_m "
                "shear_x_ratio shear_y_ratio elongation_ratio force_x_N force_y_N force_z_N "
                "moment_x_Nm moment_y_Nm moment_z_Nm");
    add_tendons(&h, rod, "tension", "N");
    const status st = csv_table(dir, "shapes.csv", &h, &c);
    for (int i = 0; st == OK && i < rod->nsolution; i++) {
        const struct rod_run *run = &rod->run[i];
        for (int k = 0; k < rod->npoint; k++) {
            csv_real(c, i + 1);
            csv_real(c, run->s[k]);
            csv_reals(c, 3, run->shape[k].p.a);
            csv_reals(c, 3, run->curvature[k]);
            csv_reals(c, 3, run->stretch[k]);
            csv_reals(c, 6, run->wrench[k].a);
            csv_reals(c, rod->ntendon, run->along + (size_t)k * (size_t)rod->ntendon);
        }
    }
    return st == OK ? csv_close(c) : st;
}

static status write_compare(const run_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h, "what unit ours_in_unit other_in_unit difference_ratio tolerance_ratio verdict "
                    "reason");
    const status st = csv_table(dir, "compare.csv", &h, &c);
    for (int i = 0; st == OK && i < r->ncompare; i++) {
        const compare_row *row = &r->compare[i];
        csv_text(c, row->what);
        csv_text(c, row->unit);
        csv_real(c, row->skipped ? NAN : row->ours); // nothing was compared: empty
        csv_real(c, row->skipped ? NAN : row->other);
        csv_real(c, row->skipped ? NAN : row->difference);
        csv_real(c, row->tolerance);
        csv_text(c, row->skipped ? "skipped" : row->ok ? "ok" : "out of tolerance");
        csv_text(c, row->reason);
    }
    return st == OK ? csv_close(c) : st;
}

status result_csv(const run_result *r, const char *dir)
{
    status st = OK;
    TRY(r->has_section ? write_sections(r, dir) : OK);
    TRY(csv_kern(r, dir));
    TRY(csv_stresses(r, dir));
    TRY(r->has_rod ? write_rods(r, dir) : OK);
    TRY(r->has_rod ? write_shapes(r, dir) : OK);
    TRY(r->has_measured ? csv_measured(r, dir) : OK);
    TRY(r->has_segment ? csv_segment(r, dir) : OK);
    TRY(r->has_compare ? write_compare(r, dir) : OK);
    TRY(r->models.there ? csv_models(&r->models, dir) : OK);
    TRY(csv_sensitivity(r, dir));
    TRY(r->fit.there ? csv_fit(&r->fit, dir) : OK);
    TRY(r->reach.there ? csv_reach(&r->reach, dir) : OK);

done:
    return st;
}
