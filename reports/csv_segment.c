// reports/csv_segment.c
// The 3D segment: segment.csv, a row per load, and segment_slices.csv, a row per slice.
#include "reports/csv_kit.h"

static void write_load(csv *c, const segment_load_result *load)
{
    csv_text(c, load->name ? load->name : "");
    csv_reals(c, 2, load->point);
    csv_reals(c, 3, load->force);
    csv_reals(c, 3, load->moment);
    csv_real(c, load->shortening);
    csv_reals(c, 3, load->tip_displacement);
    csv_reals(c, 3, load->tip_rotation);
    csv_reals(c, 2, load->mid_curvature);
    csv_real(c, load->strain_energy);
    csv_real(c, load->shortening_error);
    csv_real(c, load->tip_displacement_error);
    csv_real(c, load->tip_rotation_error);
    csv_real(c, load->mid_curvature_error);
    csv_real(c, load->strain_energy_error);
    csv_real(c, load->balance);
}

static status write_loads(const run_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h,
                "load point_x_m point_y_m force_x_N force_y_N force_z_N moment_x_Nm moment_y_Nm "
                "moment_z_Nm shortening_m tip_displacement_x_m tip_displacement_y_m "
                "tip_displacement_z_m tip_rotation_x_rad tip_rotation_y_rad tip_rotation_z_rad "
                "mid_curvature_x_per_m mid_curvature_y_per_m strain_energy_J shortening_error_m "
                "tip_displacement_error_m tip_rotation_error_rad mid_curvature_error_per_m "
                "strain_energy_error_J balance_ratio");
    const status st = csv_table(dir, "segment.csv", &h, &c);
    for (int i = 0; st == OK && i < r->segment.nload; i++) {
        write_load(c, &r->segment.load[i]);
    }
    return st == OK ? csv_close(c) : st;
}

static status write_slices(const run_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h,
                "load_count load s_m displacement_x_m displacement_y_m displacement_z_m "
                "rotation_x_rad rotation_y_rad rotation_z_rad force_x_N force_y_N force_z_N "
                "moment_x_Nm moment_y_Nm moment_z_Nm load_force_x_N load_force_y_N load_force_z_N "
                "load_moment_x_Nm load_moment_y_Nm load_moment_z_Nm shear_x_ratio shear_y_ratio "
                "elongation_ratio curvature_x_per_m curvature_y_per_m twist_per_m");
    const status st = csv_table(dir, "segment_slices.csv", &h, &c);
    for (int i = 0; st == OK && i < r->segment.nload; i++) {
        const segment_load_result *load = &r->segment.load[i];
        for (int k = 0; k < load->nslice; k++) {
            const segment_slice *slice = &load->slice[k];
            csv_real(c, i + 1);
            csv_text(c, load->name ? load->name : "");
            csv_real(c, slice->s);
            csv_reals(c, 6, slice->motion.a);
            csv_reals(c, 6, slice->resultant.a);
            csv_reals(c, 6, slice->load.a);
            csv_reals(c, 6, slice->strain.a);
        }
    }
    return st == OK ? csv_close(c) : st;
}

status csv_segment(const run_result *r, const char *dir)
{
    status st = OK;
    TRY(write_loads(r, dir));
    TRY(write_slices(r, dir));

done:
    return st;
}
