// fem/body.c
#include "fem/body.h"

#include "base/memory.h"
#include "fem/body_place.h"

#include <math.h>
#include <string.h>

void body_free(body *b)
{
    free(b->level);
    free(b->node);
    free(b->axes);
    free(b->origin);
    free(b->touch_start);
    free(b->touch);
    basis_table_free(&b->line_table);
    for (int k = 0; k < MESH_MAX_BLOCKS; k++) {
        basis_table_free(&b->plane_table[k]);
    }
    *b = (body){0};
}

static status check_spec(const body_spec *s)
{
    if (!s->plane || s->plane->dim != 2 || mesh_element_count(s->plane) < 1 || !s->materials) {
        return status_fail(ERR_BUG, "segment: no plane mesh to stand on");
    }
    if (s->nlayer < 1) {
        return status_fail(ERR_INPUT, "segment: %d layers are none", s->nlayer);
    }
    for (int k = 0; k < s->nlayer; k++) {
        if (!(s->layer[k + 1] > s->layer[k]) || !isfinite(s->layer[k + 1] - s->layer[k])) {
            return status_fail(ERR_INPUT, "segment: layer %d from %g m to %g m has no height", k,
                               s->layer[k], s->layer[k + 1]);
        }
    }
    return OK;
}

static status make_levels(const body_spec *s, body *b)
{
    status st = OK;
    const int p = b->order;
    TRY(TAKE(b->level, (size_t)b->nlevel));
    for (int i = 0; i < b->nlevel; i++) {
        const int k = i < b->nlevel - 1 ? i / p : b->nlayer - 1;
        const double begin = s->layer[k], end = s->layer[k + 1];
        b->level[i] = i == b->nlevel - 1
                          ? end
                          : begin + (end - begin) * (b->line.line_node[i - k * p] + 1) / 2;
    }
    b->length = b->level[b->nlevel - 1] - b->level[0];

done:
    return st;
}

// Two degrees over the product of two basis functions: then forces of a uniform stress balance on
// elements as curved as their order allows
static status make_tables(body *b)
{
    status st = OK;
    const int along = b->prism ? 2 * b->order : 2 * b->order + 2;
    TRY(basis_table_make(&b->line, along, &b->line_table));
    for (int k = 0; k < b->plane->nblock; k++) {
        element e = {0};
        TRY(element_make(b->plane->block[k].shape, b->plane->order, &e));
        TRY(basis_table_make(&e, 2 * b->plane->order + 2, &b->plane_table[k]));
    }

done:
    return st;
}

// one step per element of the plane mesh and node of it
typedef struct touch_step {
    int block, element, node, index;
} touch_step;

static bool touch_next(const mesh *m, touch_step *t)
{
    if (++t->node == m->block[t->block].per_elem) {
        t->node = 0;
        t->index++;
        t->element++;
    }
    while (t->block < m->nblock && t->element >= m->block[t->block].nelem) {
        t->element = 0;
        t->block++;
    }
    return t->block < m->nblock;
}

static int touch_node(const mesh *m, const touch_step *t)
{
    const mesh_block *k = &m->block[t->block];
    return k->conn[(size_t)t->element * (size_t)k->per_elem + (size_t)t->node];
}

// which elements of the plane mesh a node belongs to
static status make_touch(body *b)
{
    status st = OK;
    const mesh *m = b->plane;
    const touch_step before = {.node = -1};
    int *end = NULL;
    TRY(TAKE(b->touch_start, (size_t)m->nnode + 1));
    TRY(TAKE(end, (size_t)m->nnode));
    for (touch_step t = before; touch_next(m, &t);) {
        b->touch_start[touch_node(m, &t) + 1]++;
    }
    for (int i = 0; i < m->nnode; i++) {
        b->touch_start[i + 1] += b->touch_start[i];
        end[i] = b->touch_start[i];
    }
    TRY(TAKE(b->touch, (size_t)b->touch_start[m->nnode]));
    for (touch_step t = before; touch_next(m, &t);) {
        b->touch[end[touch_node(m, &t)]++] = t.index;
    }

done:
    free(end);
    return st;
}

static void find_radius(body *b)
{
    for (int i = 0; i < b->plane->nnode; i++) {
        const double *x = b->plane->xyz + 3 * (size_t)i;
        b->radius = fmax(b->radius, hypot(x[0], x[1]));
    }
}

status body_make(const body_spec *spec, body *out)
{
    status st = OK;
    body b = {0};
    TRY(check_spec(spec));
    b.spec = *spec;
    b.spec.layer = NULL;
    b.plane = spec->plane;
    b.order = spec->order;
    b.nlayer = spec->nlayer;
    b.nlevel = b.nlayer * b.order + 1;
    b.prism = !spec->shape.place && spec->turn_rate == 0;
    b.last = b.nlevel;
    if (spec->hold_last > 0) {
        b.first = spec->hold_first;
        b.last = spec->hold_last;
    }
    TRY(element_make(SHAPE_LINE, b.order, &b.line));
    TRY(make_levels(spec, &b));
    TRY(make_tables(&b));
    find_radius(&b);
    if (spec->matter) {
        TRY(make_touch(&b));
    }
    if (!b.prism) {
        TRY(body_place(&b));
        TRY(body_check(&b));
    }
    *out = b;
    b = (body){0};

done:
    body_free(&b);
    return st;
}

// --- fewer levels

static status keep(void **all, size_t size, size_t skip, size_t count)
{
    void *kept = NULL;
    const status st = memory_take(&kept, count, size);
    if (st == OK) {
        memcpy(kept, (const char *)*all + skip * size, count * size);
        free(*all);
        *all = kept;
    }
    return st;
}

status body_hold(body *b, int first, int last)
{
    status st = OK;
    if (first < b->first || last > b->last || first >= last) {
        TRY(status_fail(ERR_BUG, "segment: levels %d to %d are not held", first, last));
    }
    if (!b->prism) {
        const size_t skip = (size_t)(first - b->first), count = (size_t)(last - first);
        TRY(keep((void **)&b->node, 3 * (size_t)b->plane->nnode * sizeof *b->node, skip, count));
        TRY(keep((void **)&b->axes, sizeof *b->axes, skip, count));
        TRY(keep((void **)&b->origin, sizeof *b->origin, skip, count));
    }
    b->first = first;
    b->last = last;

done:
    return st;
}

// --- questions

mat3 body_axes(const body *b, int level)
{
    return b->axes ? b->axes[level - b->first] : mat3_identity();
}

void body_origin(const body *b, int level, double origin[3])
{
    for (int i = 0; i < 3; i++) {
        origin[i] = b->origin ? b->origin[level - b->first][i] : i == 2 ? b->level[level] : 0;
    }
}

static int plane_element_index(const body *b, int block, int e)
{
    return block == 0 ? e : b->plane->block[0].nelem + e;
}

static int material_of(const body *b, int index, int layer)
{
    const size_t nelem = (size_t)mesh_element_count(b->plane);
    return b->spec.matter[(size_t)layer * nelem + (size_t)index];
}

int body_material(const body *b, int block, int e, int layer)
{
    return b->spec.matter ? material_of(b, plane_element_index(b, block, e), layer)
                          : b->plane->block[block].material[e];
}

bool body_node_is_used(const body *b, int plane_node, int level)
{
    if (!b->spec.matter) {
        return true;
    }
    const int above = level / b->order, below = level > 0 ? (level - 1) / b->order : above;
    for (int k = b->touch_start[plane_node]; k < b->touch_start[plane_node + 1]; k++) {
        for (int layer = below; layer <= above && layer < b->nlayer; layer++) {
            if (material_of(b, b->touch[k], layer) >= 0) {
                return true;
            }
        }
    }
    return false;
}
