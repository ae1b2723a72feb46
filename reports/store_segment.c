// reports/store_segment.c
#include "base/memory.h"
#include "reports/store_parts.h"

#include <stdio.h>
#include <string.h>

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

static status pass_displacement(const passage *p, int i, int nnode, segment_load_result *load)
{
    static const column u = {"displacement_m", COLUMN_REAL, "m", 0, 1, {3}, 0};
    status st = OK;
    char group[64], flag[96];
    int there = load->displacement != NULL;
    (void)snprintf(group, sizeof group, "fem/load/%d", i);
    (void)snprintf(flag, sizeof flag, "%s/has_displacement", group);
    TRY(passage_count(p, flag, 0, 1, &there));
    if (there) {
        TRY(passage_room(p, (void **)&load->displacement, (size_t)nnode, 3 * sizeof(double)));
        TRY(passage_columns(p, group, 1, &u,
                            rows_of(load->displacement, nnode, 3 * sizeof(double))));
    }

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
        TRY(pass_displacement(p, i, r->segment_mesh.nnode, &s->load[i]));
    }

done:
    return st;
}

// the solid is the plane mesh level by level: the pictures rely on it
static status check_extruded(const passage *p, const mesh *plane, const mesh *solid)
{
    if (plane->nnode == 0 || solid->nnode == 0) {
        return plane->nnode == solid->nnode ? OK : passage_damaged(p, "fem", "has one mesh of two");
    }
    const int level = solid->nnode / plane->nnode, layers = (level - 1) / plane->order;
    bool ok = solid->order == plane->order && solid->nblock == plane->nblock &&
              solid->nnode == level * plane->nnode && level > 1 &&
              level == layers * plane->order + 1;
    for (int b = 0; ok && b < plane->nblock; b++) {
        ok = (solid->block[b].shape == SHAPE_HEX) == (plane->block[b].shape == SHAPE_QUAD) &&
             solid->block[b].nelem / layers == plane->block[b].nelem &&
             solid->block[b].nelem % layers == 0;
    }
    return ok ? OK : passage_damaged(p, "fem/mesh", "is not its plane mesh extruded");
}

status store_pass_segment(const passage *p, run_result *r)
{
#define SEGMENT(member) offsetof(run_result, member)
    static const column columns[] = {
        {"length_m", COLUMN_POSITIVE, "m", SEGMENT(segment_length), 0, {0}, 0},
        {"section_at_m", COLUMN_REAL, "m", SEGMENT(segment_section_at), 0, {0}, 0},
        {"base", COLUMN_INT, "-", SEGMENT(segment_base), 0, {0}, BASE_FREE_TO_CONTRACT},
        {"tip", COLUMN_INT, "-", SEGMENT(segment_tip), 0, {0}, TIP_UNIFORM},
        {"K", COLUMN_REAL, STIFFNESS_UNIT, SEGMENT(segment.middle.K), 2, {6, 6}, 0},
        {"area_m2", COLUMN_POSITIVE, "m^2", SEGMENT(segment.middle.area), 0, {0}, 0},
        {"K_relative_error", COLUMN_ANY, "-", SEGMENT(segment.middle.relative_error), 0, {0}, 0},
        {"stiffness_centre_m", COLUMN_REAL, "m", SEGMENT(segment.stiffness_centre), 1, {2}, 0},
        {"tip_centre_m", COLUMN_ANY, "m", SEGMENT(segment.tip_centre), 1, {2}, 0},
        {"tip_compliance",
         COLUMN_REAL,
         COMPLIANCE_UNIT,
         SEGMENT(segment.tip_compliance),
         2,
         {6, 6},
         0},
        {"relative_error", COLUMN_ANY, "-", SEGMENT(segment.relative_error), 0, {0}, 0},
        {"residual", COLUMN_ANY, "-", SEGMENT(segment.residual), 0, {0}, 0},
    };
#undef SEGMENT
    static const column dofs = {"dofs", COLUMN_REAL, "-", 0, 0, {0}, 0};
    status st = OK;
    double count = (double)r->segment.dofs; // more than an int holds
    TRY(passage_columns(p, "fem", 1, &dofs, single(&count)));
    if (!(count >= 0 && count < MOST_DOFS)) {
        TRY(passage_damaged(p, "fem/dofs", "is out of range"));
    }
    r->segment.dofs = (long long)count;
    TRY(passage_columns(p, "fem", COUNT_OF(columns), columns, single(r)));
    TRY(passage_mesh(p, "fem/plane", 2, r->nmaterial, &r->segment_plane));
    TRY(passage_mesh(p, "fem/mesh", 3, r->nmaterial, &r->segment_mesh));
    TRY(p->reading ? check_extruded(p, &r->segment_plane, &r->segment_mesh) : OK);
    TRY(pass_loads(p, r));

done:
    return st;
}
