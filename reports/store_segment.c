// reports/store_segment.c
// What a 3D segment found: its numbers, loads and slices. Fields: reports/store_segment_fields.c
#include "base/memory.h"
#include "reports/store_parts.h"

#include <stdio.h>
#include <string.h>

#define MOTION_UNIT "m, rad (along x y z, about x y z)"
#define WRENCH_UNIT "N, N m (nx ny nz mx my mz)"
#define STRAIN_UNIT "-, 1/m (along x y z, about x y z)"

// integers up to here are doubles
static const double MOST_DOFS = 9007199254740992.0;

static status pass_load_names(const passage *p, run_result *r, int n)
{
    status st = OK;
    for (int i = 0; i < n; i++) {
        char name[64], *text = (char *)r->segment.load[i].name;
        size_t length = text ? strlen(text) : 0;
        (void)snprintf(name, sizeof name, "fem/load/%d/name", i);
        TRY(passage_text(p, name, &text, &length));
        if (p->reading) {
            r->segment.load[i].name = r->load_name[i] = text;
        }
    }

done:
    return st;
}

static status pass_slices(const passage *p, int i, segment_load_result *load)
{
#define SLICE(member) offsetof(segment_slice, member)
    static const column columns[] = {
        {"s_m", COLUMN_REAL, "m", SLICE(s), 0, {0}, 0},
        {"motion", COLUMN_REAL, MOTION_UNIT, SLICE(motion), 1, {6}, 0},
        {"resultant", COLUMN_REAL, WRENCH_UNIT, SLICE(resultant), 1, {6}, 0},
        {"load", COLUMN_REAL, WRENCH_UNIT, SLICE(load), 1, {6}, 0},
        {"strain", COLUMN_REAL, STRAIN_UNIT, SLICE(strain), 1, {6}, 0},
    };
#undef SLICE
    status st = OK;
    char group[64];
    (void)snprintf(group, sizeof group, "fem/load/%d/slice", i);
    TRY(passage_count(p, passage_join(group, "count").text, 0, MOST_POINTS, &load->nslice));
    TRY(passage_room(p, (void **)&load->slice, (size_t)load->nslice, sizeof *load->slice));
    TRY(passage_columns(p, group, COUNT_OF(columns), columns,
                        rows_of(load->slice, load->nslice, sizeof *load->slice)));

done:
    return st;
}

static status pass_loads(const passage *p, run_result *r)
{
#define LOAD(member) offsetof(segment_load_result, member)
    static const column columns[] = {
        {"point_m", COLUMN_REAL, "m", LOAD(point), 1, {2}, 0},
        {"force_N", COLUMN_REAL, "N", LOAD(force), 1, {3}, 0},
        {"moment_Nm", COLUMN_REAL, "N m", LOAD(moment), 1, {3}, 0},
        {"shortening_m", COLUMN_REAL, "m", LOAD(shortening), 0, {0}, 0},
        {"tip_displacement_m", COLUMN_REAL, "m", LOAD(tip_displacement), 1, {3}, 0},
        {"tip_rotation_rad", COLUMN_REAL, "rad", LOAD(tip_rotation), 1, {3}, 0},
        {"mid_curvature_per_m", COLUMN_REAL, "1/m", LOAD(mid_curvature), 1, {2}, 0},
        {"strain_energy_J", COLUMN_REAL, "J", LOAD(strain_energy), 0, {0}, 0},
        {"shortening_error_m", COLUMN_ANY, "m", LOAD(shortening_error), 0, {0}, 0},
        {"tip_displacement_error_m", COLUMN_ANY, "m", LOAD(tip_displacement_error), 0, {0}, 0},
        {"tip_rotation_error_rad", COLUMN_ANY, "rad", LOAD(tip_rotation_error), 0, {0}, 0},
        {"mid_curvature_error_per_m", COLUMN_ANY, "1/m", LOAD(mid_curvature_error), 0, {0}, 0},
        {"strain_energy_error_J", COLUMN_ANY, "J", LOAD(strain_energy_error), 0, {0}, 0},
        {"balance", COLUMN_ANY, "-", LOAD(balance), 0, {0}, 0},
    };
#undef LOAD
    status st = OK;
    segment_result *s = &r->segment;
    int n = s->nload;
    TRY(passage_count(p, "fem/load_count", 0, MOST_LOADS, &n));
    TRY(passage_room(p, (void **)&s->load, (size_t)n, sizeof *s->load));
    TRY(passage_room(p, (void **)&r->load_name, (size_t)n, sizeof *r->load_name));
    s->nload = n;
    TRY(pass_load_names(p, r, n));
    TRY(passage_columns(p, "fem/load", COUNT_OF(columns), columns,
                        rows_of(s->load, n, sizeof *s->load)));
    for (int i = 0; i < n; i++) {
        TRY(pass_slices(p, i, &s->load[i]));
        TRY(store_pass_segment_fields(p, i, r));
    }

done:
    return st;
}

#define SEGMENT(member) offsetof(run_result, member)

// the meshes one after the other; results of before have none
static status pass_steps(const passage *p, run_result *r)
{
    static const column columns[] = {
        {"dofs", COLUMN_REAL, "-", offsetof(segment_step, dofs), 0, {0}, 0},
        {"cpu_s", COLUMN_ANY, "s", offsetof(segment_step, seconds), 0, {0}, 0},
        {"tip_compliance",
         COLUMN_REAL,
         COMPLIANCE_UNIT,
         offsetof(segment_step, tip_compliance),
         2,
         {6, 6},
         0},
    };
    status st = OK;
    segment_result *s = &r->segment;
    const int kept = s->rungs <= SEGMENT_MOST_STEPS ? s->rungs : 0;
    if (kept < 1 || (p->reading ? !store_has(p->store, "fem/step/dofs") : s->step[0].dofs <= 0)) {
        return OK;
    }
    TRY(passage_columns(p, "fem/step", COUNT_OF(columns), columns,
                        rows_of(s->step, kept, sizeof *s->step)));

done:
    return st;
}

// which way, on which mesh, at what cost
static status pass_effort(const passage *p, run_result *r)
{
    static const column columns[] = {
        {"way", COLUMN_INT, "-", SEGMENT(segment.way), 0, {0}, WAY_ITERATIVE},
        {"rungs", COLUMN_INT, "-", SEGMENT(segment.rungs), 0, {0}, MOST_ROWS},
        {"met", COLUMN_FLAG, "-", SEGMENT(segment.met), 0, {0}, 0},
        {"order", COLUMN_INT, "-", SEGMENT(segment.order), 0, {0}, ELEMENT_MAX_ORDER},
        {"layers", COLUMN_INT, "-", SEGMENT(segment.layers), 0, {0}, MOST_POINTS},
        {"iterations", COLUMN_INT, "-", SEGMENT(segment.iterations), 0, {0}, MOST_POINTS},
        {"mesh_order",
         COLUMN_INT,
         "-",
         SEGMENT(segment.mesh_used.order),
         0,
         {0},
         ELEMENT_MAX_ORDER},
        {"mesh_size_m", COLUMN_REAL, "m", SEGMENT(segment.mesh_used.size), 0, {0}, 0},
        {"edge_layers", COLUMN_INT, "-", SEGMENT(segment.mesh_used.edge_layers), 0, {0}, MOST_ROWS},
        {"edge_first_over_radius",
         COLUMN_REAL,
         "-",
         SEGMENT(segment.mesh_used.edge_first),
         0,
         {0},
         0},
        {"assemble_s", COLUMN_ANY, "s", SEGMENT(segment.assemble_seconds), 0, {0}, 0},
        {"factor_s", COLUMN_ANY, "s", SEGMENT(segment.factor_seconds), 0, {0}, 0},
        {"solve_s", COLUMN_ANY, "s", SEGMENT(segment.solve_seconds), 0, {0}, 0},
        {"residual", COLUMN_ANY, "-", SEGMENT(segment.residual), 0, {0}, 0},
    };
    static const column dofs = {"dofs", COLUMN_REAL, "-", 0, 0, {0}, 0};
    status st = OK;
    double count = (double)r->segment.dofs; // more than an int holds
    TRY(passage_columns(p, "fem", 1, &dofs, single(&count)));
    if (!(count >= 0 && count < MOST_DOFS)) {
        TRY(passage_damaged(p, "fem/dofs", "is out of range"));
    }
    r->segment.dofs = (long long)count;
    TRY(passage_words(p, "fem/why", r->segment.why, sizeof r->segment.why));
    TRY(passage_columns(p, "fem", COUNT_OF(columns), columns, single(r)));
    TRY(pass_steps(p, r));

done:
    return st;
}

status store_pass_segment(const passage *p, run_result *r)
{
    static const column columns[] = {
        {"length_m", COLUMN_POSITIVE, "m", SEGMENT(segment_length), 0, {0}, 0},
        {"section_at_m", COLUMN_REAL, "m", SEGMENT(segment_section_at), 0, {0}, 0},
        {"base", COLUMN_INT, "-", SEGMENT(segment_base), 0, {0}, BASE_FREE},
        {"tip", COLUMN_INT, "-", SEGMENT(segment_tip), 0, {0}, TIP_FREE},
        {"K", COLUMN_KNOWN, STIFFNESS_UNIT, SEGMENT(segment.middle.K), 2, {6, 6}, 0},
        {"area_m2", COLUMN_POSITIVE, "m^2", SEGMENT(segment.middle.area), 0, {0}, 0},
        {"K_relative_error", COLUMN_ANY, "-", SEGMENT(segment.middle.relative_error), 0, {0}, 0},
        {"K_entry_error", COLUMN_ANY, "-", SEGMENT(segment.middle.entry_error), 2, {6, 6}, 0},
        {"stiffness_centre_m", COLUMN_KNOWN, "m", SEGMENT(segment.stiffness_centre), 1, {2}, 0},
        {"stiffness_centre_error_m",
         COLUMN_ANY,
         "m",
         SEGMENT(segment.stiffness_centre_error),
         0,
         {0},
         0},
        {"tip_centre_m", COLUMN_ANY, "m", SEGMENT(segment.tip_centre), 1, {2}, 0},
        {"end_length_m", COLUMN_ANY, "m", SEGMENT(segment.end_length), 1, {6}, 0},
        {"tip_compliance",
         COLUMN_REAL,
         COMPLIANCE_UNIT,
         SEGMENT(segment.tip_compliance),
         2,
         {6, 6},
         0},
        {"relative_error", COLUMN_ANY, "-", SEGMENT(segment.relative_error), 0, {0}, 0},
    };
    status st = OK;
    TRY(passage_columns(p, "fem", COUNT_OF(columns), columns, single(r)));
    TRY(pass_effort(p, r));
    TRY(store_pass_segment_body(p, r));
    TRY(pass_loads(p, r));

done:
    return st;
}
#undef SEGMENT
