// reports/json_segment.c
// stiffaxis/fem/1: the 3D segment.
#include "reports/json_parts.h"

static const char *const base_names[] = {"clamped", "free_to_contract", "free"};
static const char *const tip_names[] = {"rigid", "E_proportional", "uniform", "free"};
static const char *const way_names[] = {"auto", "doubling", "direct", "iterative"};

static void write_slice(json *j, const segment_slice *slice)
{
    json_object(j, NULL);
    json_real(j, "s_m", slice->s);
    json_reals(j, "motion", 6, slice->motion.a);
    json_reals(j, "resultant", 6, slice->resultant.a);
    json_reals(j, "load", 6, slice->load.a);
    json_reals(j, "strain", 6, slice->strain.a);
    json_object_end(j);
}

static void write_load(json *j, const segment_load_result *load)
{
    json_object(j, NULL);
    json_text(j, "name", load->name);
    json_reals(j, "point_m", 2, load->point);
    json_reals(j, "force_N", 3, load->force);
    json_reals(j, "moment_Nm", 3, load->moment);
    json_real(j, "shortening_m", load->shortening);
    json_reals(j, "tip_displacement_m", 3, load->tip_displacement);
    json_reals(j, "tip_rotation_rad", 3, load->tip_rotation);
    json_reals(j, "mid_curvature_per_m", 2, load->mid_curvature);
    json_real(j, "strain_energy_J", load->strain_energy);
    json_real(j, "shortening_error_m", load->shortening_error);
    json_real(j, "tip_displacement_error_m", load->tip_displacement_error);
    json_real(j, "tip_rotation_error_rad", load->tip_rotation_error);
    json_real(j, "mid_curvature_error_per_m", load->mid_curvature_error);
    json_real(j, "strain_energy_error_J", load->strain_energy_error);
    json_real(j, "balance", load->balance);
    json_array(j, "slices");
    for (int i = 0; i < load->nslice; i++) {
        write_slice(j, &load->slice[i]);
    }
    json_array_end(j);
    json_object_end(j);
}

// which way, on which mesh, at what cost
static void write_effort(json *j, const segment_result *s)
{
    json_text(j, "way", way_names[s->way]);
    json_text(j, "why", s->why);
    json_integer(j, "rungs", s->rungs);
    json_array(j, "ladder");
    for (int i = 0; i < s->rungs && i < SEGMENT_MOST_STEPS && s->step[i].dofs > 0; i++) {
        json_object(j, NULL);
        json_integer(j, "dofs", (long)s->step[i].dofs);
        json_real(j, "cpu_s", s->step[i].seconds);
        json_real(j, "relative_error", segment_step_error(s, i));
        json_object_end(j);
    }
    json_array_end(j);
    json_flag(j, "tolerance_met", s->met);
    json_integer(j, "order", s->order);
    json_integer(j, "layers", s->layers);
    json_integer(j, "mesh_order", s->mesh_used.order);
    json_real(j, "mesh_size_m", s->mesh_used.size);
    json_integer(j, "edge_layers", s->mesh_used.edge_layers);
    json_real(j, "edge_first_over_radius", s->mesh_used.edge_first);
    json_real(j, "residual", s->residual);
    json_integer(j, "iterations", s->iterations);
    json_real(j, "assemble_s", s->assemble_seconds);
    json_real(j, "factor_s", s->factor_seconds);
    json_real(j, "solve_s", s->solve_seconds);
}

status result_json_segment(json *j, const char *key, const run_result *r)
{
    const segment_result *s = &r->segment;
    json_begin(j, key, "stiffaxis/fem/1", r);
    json_real(j, "length_m", r->segment_length);
    json_real(j, "section_at_m", r->segment_section_at);
    json_text(j, "base", base_names[r->segment_base]);
    json_text(j, "tip", tip_names[r->segment_tip]);
    json_integer(j, "dofs", (long)s->dofs);
    write_effort(j, s);
    json_mat6(j, "K", s->middle.K);
    json_real(j, "K_relative_error", s->middle.relative_error);
    json_mat6(j, "K_entry_error", s->middle.entry_error);
    json_reals(j, "stiffness_centre_m", 2, s->stiffness_centre);
    json_real(j, "stiffness_centre_error_m", s->stiffness_centre_error);
    json_reals(j, "tip_centre_m", 2, s->tip_centre);
    json_mat6(j, "tip_compliance", s->tip_compliance);
    json_reals(j, "end_length_m", 6, s->end_length);
    json_real(j, "relative_error", s->relative_error);
    json_array(j, "loads");
    for (int i = 0; i < s->nload; i++) {
        write_load(j, &s->load[i]);
    }
    json_array_end(j);
    json_object_end(j);
    return OK;
}
