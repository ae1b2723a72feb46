// reports/store_reach.c
// A reach study on its way to the store and back: tissue, targets, scopes with their answers and
// maps. Bodies and ways in lie one after the other, with a count for each target.
#include "reports/store_reach.h"

#include "base/memory.h"
#include "reach/reach_case.h"
#include "reach/surface.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

enum { MOST_CORNERS = 3 * SURFACE_MOST_TRIANGLES, MOST_LOOKS = 1 << 30 };

// a column of n plain numbers or points
static status pass_array(const passage *p, const char *group, const column *c, int n, void *a,
                         size_t size)
{
    return passage_columns(p, group, 1, c, rows_of(a, n, size));
}

// --- texts: one to a line of one dataset ---------------------------------------------------------

static status write_lines(const passage *p, const char *name, int n, const char *text,
                          size_t stride)
{
    status st = OK;
    char *all = NULL;
    size_t used = 0;
    TRY(TAKE(all, (size_t)n * stride + 1));
    for (int i = 0; i < n; i++) {
        const char *one = text + (size_t)i * stride;
        for (size_t k = 0; k + 1 < stride && one[k]; k++) {
            all[used++] = one[k] == '\n' ? ' ' : one[k];
        }
        all[used++] = '\n';
    }
    TRY(store_text(p->store, name, all, used));

done:
    free(all);
    return st;
}

static status read_lines(const passage *p, const char *name, int n, char *text, size_t stride)
{
    status st = OK;
    char *all = NULL;
    size_t length = 0;
    TRY(store_read_text(p->store, name, &all, &length));
    const char *at = all;
    for (int i = 0; i < n; i++) {
        const char *end = strchr(at, '\n');
        if (!end || (size_t)(end - at) >= stride) {
            TRY(passage_damaged(p, name, "has other lines than the counts say"));
        }
        memcpy(text + (size_t)i * stride, at, (size_t)(end - at));
        at = end + 1;
    }
    if ((size_t)(at - all) != length) {
        TRY(passage_damaged(p, name, "has other lines than the counts say"));
    }

done:
    free(all);
    return st;
}

// n texts of `stride` bytes, one after the other
status store_pass_lines(const passage *p, const char *group, const char *tail, int n, void *text,
                        size_t stride)
{
    const passage_name name = passage_join(group, tail);
    return p->reading ? read_lines(p, name.text, n, text, stride)
                      : write_lines(p, name.text, n, text, stride);
}

// --- what the study was asked --------------------------------------------------------------------

static status pass_head(const passage *p, reach_result *r)
{
#define OF(member) offsetof(reach_result, member)
    static const column columns[] = {
        {"synthetic", COLUMN_FLAG, "-", OF(synthetic), 0, {0}, 0},
        {"source", COLUMN_TEXT, "-", OF(source), 0, {REACH_TEXT}, 0},
        {"tissue_file", COLUMN_TEXT, "-", OF(tissue), 0, {REACH_TEXT}, 0},
        {"area_m2", COLUMN_REAL, "m^2", OF(area), 0, {0}, 0},
        {"volume_m3", COLUMN_REAL, "m^3", OF(volume), 0, {0}, 0},
        {"entry_m", COLUMN_REAL, "m", OF(entry.p), 1, {3}, 0},
        {"entry_rotation", COLUMN_REAL, "-", OF(entry.R), 2, {3, 3}, 0},
        {"entry_free_m", COLUMN_REAL, "m", OF(entry_free), 0, {0}, 0},
        {"tolerance_m", COLUMN_REAL, "m", OF(tolerance), 0, {0}, 0},
        {"clearance_m", COLUMN_REAL, "m", OF(clearance), 0, {0}, 0},
        {"resolution_m", COLUMN_REAL, "m", OF(resolution), 0, {0}, 0},
        {"tip", COLUMN_INT, "0 centre, 1 skin", OF(tip), 0, {0}, REACH_TIP_SKIN},
        {"path", COLUMN_INT, "0 final pose, 1 insertion", OF(path), 0, {0}, REACH_INSERTION},
        {"map_seed", COLUMN_INT, "-", OF(map_seed), 0, {0}, INT_MAX},
    };
#undef OF
    return passage_columns(p, "reach", COUNT_OF(columns), columns, single(r));
}

static status pass_anatomy(const passage *p, reach_result *r)
{
    static const column vertex = {"vertex_m", COLUMN_REAL, "m", 0, 1, {3}, 0};
    static const column target = {"place_m", COLUMN_REAL, "m", 0, 1, {3}, 0};
    static const column depth = {"depth_m", COLUMN_KNOWN, "m", 0, 0, {0}, 0};
    static const column sample = {"place_m", COLUMN_REAL, "m", 0, 1, {3}, 0};
    const column triangle = {"triangle", COLUMN_INT, "-", 0, 1, {3}, r->nvertex - 1};
    status st = OK;
    TRY(pass_array(p, "reach/tissue", &vertex, r->nvertex, r->vertex, sizeof *r->vertex));
    TRY(pass_array(p, "reach/tissue", &triangle, r->ntriangle, r->triangle, sizeof *r->triangle));
    TRY(store_pass_lines(p, "reach/target", "name", r->ntarget, r->target_name,
                         sizeof *r->target_name));
    TRY(pass_array(p, "reach/target", &target, r->ntarget, r->target, sizeof *r->target));
    TRY(pass_array(p, "reach/target", &depth, r->ntarget, r->target_depth,
                   sizeof *r->target_depth));
    TRY(pass_array(p, "reach/map", &sample, r->nmap, r->map_point, sizeof *r->map_point));

done:
    return st;
}

static status pass_counts(const passage *p, reach_result *r)
{
    status st = OK;
    reach_result n = *r;
    TRY(passage_count(p, "reach/vertex_count", 0, MOST_CORNERS, &n.nvertex));
    TRY(passage_count(p, "reach/triangle_count", 0, SURFACE_MOST_TRIANGLES, &n.ntriangle));
    TRY(passage_count(p, "reach/target_count", 0, REACH_TARGETS, &n.ntarget));
    TRY(passage_count(p, "reach/map_count", 0, REACH_MAP_POINTS, &n.nmap));
    TRY(passage_count(p, "reach/scope_count", 0, REACH_SCOPES, &n.nscope));
    n.design.there = false; // it makes its own room
    TRY(p->reading ? reach_result_make(&n, r) : OK);

done:
    return st;
}

// --- scopes --------------------------------------------------------------------------------------

static status pass_scope_head(const passage *p, const char *group, reach_scope_result *s)
{
#define OF(member) offsetof(reach_scope_result, member)
    static const column columns[] = {
        {"name", COLUMN_TEXT, "-", OF(name), 0, {REACH_NAME}, 0},
        {"kind", COLUMN_TEXT, "-", OF(kind), 0, {REACH_NAME}, 0},
        {"limit_note", COLUMN_TEXT, "-", OF(limit_note), 0, {REACH_TEXT}, 0},
        {"length_m", COLUMN_POSITIVE, "m", OF(length), 0, {0}, 0},
        {"constant_curvature", COLUMN_FLAG, "-", OF(arc), 0, {0}, 0},
        {"radius_m", COLUMN_REAL, "m", OF(radius), 0, {0}, 0},
        {"joint_low", COLUMN_REAL, JOINT_UNITS, OF(low), 1, {SCOPE_JOINTS}, 0},
        {"joint_high", COLUMN_REAL, JOINT_UNITS, OF(high), 1, {SCOPE_JOINTS}, 0},
        {"spacing_m", COLUMN_KNOWN, "m", OF(spacing), 0, {0}, 0},
        {"area_reached_share", COLUMN_KNOWN, "-", OF(area_reached), 0, {0}, 0},
        {"area_undecided_share", COLUMN_KNOWN, "-", OF(area_undecided), 0, {0}, 0},
        {"area_error_share", COLUMN_KNOWN, "-", OF(area_error), 0, {0}, 0},
        {"map_spacing_m", COLUMN_KNOWN, "m", OF(map_spacing), 0, {0}, 0},
        {"cpu_s", COLUMN_KNOWN, "s", OF(seconds), 0, {0}, 0},
    };
#undef OF
    return passage_columns(p, group, COUNT_OF(columns), columns, single(s));
}

static status pass_scope(const passage *p, int i, reach_result *r)
{
    static const column state = {
        "map_state", COLUMN_INT, "0 not reached, 1 reached, 2 not known", 0, 0, {0}, MAP_UNDECIDED};
    status st = OK;
    reach_scope_result *s = &r->scope[i];
    char group[64];
    (void)snprintf(group, sizeof group, "reach/scope/%d", i);
    TRY(passage_count(p, passage_join(group, "joint_count").text, SCOPE_BEND, SCOPE_JOINTS,
                      &s->njoint));
    TRY(passage_count(p, passage_join(group, "reached_count").text, 0, r->ntarget, &s->nreached));
    TRY(pass_scope_head(p, group, s));
    TRY(store_pass_reach_answers(p, group, r->ntarget, s));
    TRY(r->nmap > 0 ? pass_array(p, group, &state, r->nmap, s->state, sizeof *s->state) : OK);

done:
    return st;
}

status store_pass_reach(const passage *p, run_result *r)
{
    status st = OK;
    reach_result *reach = &r->reach;
    if (p->reading ? !store_has(p->store, "reach/scope_count") : !reach->there) {
        return OK;
    }
    TRY(pass_counts(p, reach));
    TRY(pass_head(p, reach));
    // a case may ask for none
    if (p->reading ? store_has(p->store, "reach/paper_table_4") : reach->paper) {
        TRY(passage_count(p, "reach/paper_table_4", 0, REACH_PAPER_TABLE_4, &reach->paper));
    }
    TRY(pass_anatomy(p, reach));
    for (int i = 0; i < reach->nscope; i++) {
        TRY(pass_scope(p, i, reach));
    }
    TRY(store_pass_reach_design(p, &reach->design));

done:
    return st;
}
