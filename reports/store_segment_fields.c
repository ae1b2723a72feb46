// reports/store_segment_fields.c
// What the fields of a segment stand on, and the fields.
#include "base/memory.h"
#include "reports/store_parts.h"

#include <stdio.h>

enum { MOST_LAYERS = 1000000, MOST_VALUES = 1000000000 };

// Fields go into the file, and come out of it, where all levels are: here, or on the ranks
// together.
bool store_segment_is_whole(const segment_body *b)
{
    return b->nlevel > 0 && (b->shared || (b->first == 0 && b->last == b->nlevel));
}

// [levels][nnode][width] of which the levels here are at hand
static status pass_levels(const passage *p, const char *group, const column *c, int nnode,
                          const segment_body *b, double *data)
{
    status st = OK;
    const passage_name full = passage_join(group, c->name);
    const size_t n = (size_t)nnode, width = c->shape[0];
    const size_t whole[2] = {(size_t)b->nlevel * n, width},
                 here[2] = {(size_t)(b->last - b->first) * n, width};
    if (p->reading || !b->shared) {
        return passage_columns(p, group, 1, c,
                               rows_of(data, b->nlevel * nnode, width * sizeof *data));
    }
    TRY(store_make(p->store, full.text, 2, whole, c->unit));
    TRY(store_rows(p->store, full.text, (size_t)b->first * n, 2, here, data));

done:
    return st;
}

// every node of `apart` is the copy of one node of the plane mesh
static status check_apart(const passage *p, const segment_body *b)
{
    status st = OK;
    int *copy_of = NULL;
    const mesh *plane = &b->plane, *apart = &b->apart;
    bool ok = apart->order == plane->order && apart->nblock == plane->nblock;
    TRY(TAKE(copy_of, (size_t)apart->nnode));
    for (int k = 0; ok && k < plane->nblock; k++) {
        const mesh_block *a = &apart->block[k], *o = &plane->block[k];
        ok = a->shape == o->shape && a->nelem == o->nelem;
        for (int i = 0; ok && i < o->nelem * o->per_elem; i++) {
            int *known = &copy_of[a->conn[i]];
            ok = *known == 0 || *known == o->conn[i] + 1;
            *known = o->conn[i] + 1;
        }
    }
    if (!ok) {
        TRY(passage_damaged(p, "fem/apart", "is not its plane mesh with nodes apart"));
    }

done:
    free(copy_of);
    return st;
}

static status check_levels(const passage *p, const segment_body *b)
{
    bool ok = b->plane.nnode > 0 && b->nlevel <= MOST_VALUES / b->plane.nnode;
    for (int i = 1; ok && i < b->nlevel; i++) {
        ok = b->level[i] > b->level[i - 1];
    }
    return ok ? OK : passage_damaged(p, "fem/level_m", "does not go up");
}

static status pass_matter(const passage *p, int nmaterial, segment_body *b)
{
    status st = OK;
    const size_t nelem = (size_t)mesh_element_count(&b->plane);
    // one more than the material, 0 where there is nothing
    const column matter = {"matter_plus_one", COLUMN_INT, "-", 0, 1, {nelem}, nmaterial};
    int there = b->matter != NULL, *plus = NULL;
    const size_t n = nelem * (size_t)b->nlayer;
    TRY(passage_count(p, "fem/has_matter", 0, 1, &there));
    if (there) {
        TRY(TAKE(plus, n));
        for (size_t i = 0; !p->reading && i < n; i++) {
            plus[i] = b->matter[i] + 1;
        }
        TRY(passage_columns(p, "fem", 1, &matter, rows_of(plus, b->nlayer, nelem * sizeof(int))));
        TRY(passage_room(p, (void **)&b->matter, n, sizeof *b->matter));
        for (size_t i = 0; p->reading && i < n; i++) {
            b->matter[i] = plus[i] - 1;
        }
    }

done:
    free(plus);
    return st;
}

status store_pass_segment_body(const passage *p, run_result *r)
{
    static const column level = {"level_m", COLUMN_REAL, "m", 0, 0, {0}, 0},
                        node = {"node_m", COLUMN_REAL, "m", 0, 1, {3}, 0};
    status st = OK;
    segment_body *b = &r->segment.body;
    int nlayer = store_segment_is_whole(b) ? b->nlayer : 0;
    TRY(passage_mesh(p, "fem/plane", 2, r->nmaterial, &b->plane));
    TRY(passage_count(p, "fem/layer_count", 0, MOST_LAYERS, &nlayer));
    if (nlayer == 0) {
        return OK;
    }
    TRY(passage_count(p, "fem/layer_order", 1, ELEMENT_MAX_ORDER, &b->order));
    if (p->reading) {
        b->nlayer = nlayer;
        b->last = b->nlevel = nlayer * b->order + 1;
    }
    TRY(passage_room(p, (void **)&b->level, (size_t)b->nlevel, sizeof *b->level));
    TRY(passage_columns(p, "fem", 1, &level, rows_of(b->level, b->nlevel, sizeof *b->level)));
    TRY(p->reading ? check_levels(p, b) : OK);
    const int n = b->nlevel * b->plane.nnode;
    TRY(passage_room(p, (void **)&b->node, (size_t)n, 3 * sizeof(double)));
    TRY(pass_levels(p, "fem", &node, b->plane.nnode, b, b->node));
    TRY(pass_matter(p, r->nmaterial, b));
    TRY(passage_mesh(p, "fem/apart", 2, r->nmaterial, &b->apart));
    TRY(p->reading && b->apart.nnode > 0 ? check_apart(p, b) : OK);

done:
    return st;
}

static status pass_field(const passage *p, int load, const column *c, int nnode,
                         const segment_body *b, double **field)
{
    status st = OK;
    char group[64], flag[96];
    const bool can = store_segment_is_whole(b) && nnode > 0;
    int there = *field != NULL && can;
    (void)snprintf(group, sizeof group, "fem/load/%d", load);
    (void)snprintf(flag, sizeof flag, "%s/has_%s", group, c->name);
    TRY(passage_count(p, flag, 0, can, &there));
    if (there) {
        TRY(passage_room(p, (void **)field, (size_t)b->nlevel * (size_t)nnode,
                         c->shape[0] * sizeof **field));
        TRY(pass_levels(p, group, c, nnode, b, *field));
    }

done:
    return st;
}

status store_pass_segment_fields(const passage *p, int load, run_result *r)
{
    static const column displacement = {"displacement_m", COLUMN_REAL, "m", 0, 1, {3}, 0},
                        stress = {"stress_Pa", COLUMN_REAL, "Pa", 0, 1, {6}, 0};
    status st = OK;
    segment_load_result *l = &r->segment.load[load];
    const segment_body *b = &r->segment.body;
    TRY(pass_field(p, load, &displacement, b->plane.nnode, b, &l->displacement));
    TRY(pass_field(p, load, &stress, b->apart.nnode, b, &l->stress));

done:
    return st;
}
