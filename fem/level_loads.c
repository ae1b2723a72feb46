// fem/level_loads.c
#include "fem/level_loads.h"

#include "base/beam_law.h"
#include "base/memory.h"
#include "fem/brick.h"
#include "fem/face.h"
#include "fem/level_fit.h"

#include <string.h>

void level_loads_free(level_loads *l)
{
    free(l->force);
    free(l->on_top);
    free(l->on_base);
    *l = (level_loads){0};
}

typedef struct loader {
    const petsc_door *door;
    const segment_problem *p;
    const level_share *s;
    level_loads out;
    brick *brick;
    double *f;    // of one element's nodes
    double *mass; // the same
} loader;

static double *level_of(const loader *l, int column, int level)
{
    return l->out.force + level_loads_offset(l->p->body, l->s, column, level);
}

// --- tractions on the end planes

// a uniform traction acts at the area's centroid
static vec6 uniform_wrench(const body *b, const level_fit *area, const double *force)
{
    const vec3 f = {{force[0], force[1], force[2]}};
    const vec3 c = mat3_mul_vec(body_axes(b, b->nlevel - 1),
                                (vec3){{area->centroid[0], area->centroid[1], 0}});
    const vec3 m = vec3_cross(c, f);
    return (vec6){{f.a[0], f.a[1], f.a[2], m.a[0], m.a[1], m.a[2]}};
}

static status load_tip(const loader *l)
{
    status st = OK;
    level_fit by_E = {0}, by_area = {0};
    const body *b = l->p->body;
    const int tip = b->nlevel - 1;
    if (l->p->tip != TIP_RIGID) {
        TRY(level_fit_make(b, tip, LEVEL_BY_E, &by_E));
        for (int j = 0; j < 6; j++) {
            vec6 w = {0};
            w.a[j] = 1;
            level_fit_add_wrench(&by_E, w, level_of(l, j, tip));
        }
    }
    for (int j = 0; j < l->p->nextra; j++) {
        if (l->p->extra[j].uniform_tip) {
            level_fit_free(&by_area);
            TRY(level_fit_make(b, tip, LEVEL_BY_AREA, &by_area));
            level_fit_add_wrench(&by_area, uniform_wrench(b, &by_area, l->p->extra[j].tip_force),
                                 level_of(l, 6 + j, tip));
        }
    }

done:
    level_fit_free(&by_E);
    level_fit_free(&by_area);
    return st;
}

// --- forces per volume

static bool has_volume_load(const load_column *c)
{
    bool any = false;
    for (int d = 0; d < 3; d++) {
        any = any || c->body_force[d] != 0 || c->acceleration[d] != 0;
    }
    return any;
}

static void add_nodes(loader *l, int column, const int *conn, int n2, int layer)
{
    const body *b = l->p->body;
    const int p = b->order, own = l->s->last_layer - l->s->first_layer;
    for (int i = 0; i < n2 * (p + 1); i++) {
        const int level = layer * p + i / n2, node = conn[i % n2];
        double *to = level_of(l, column, level) + 3 * (size_t)node, x[3];
        for (int d = 0; d < 3; d++) {
            to[d] += l->f[3 * i + d];
        }
        if (layer < l->s->first_layer || (i / n2 != p && level != 0)) {
            continue;
        }
        vec6 *end = level == 0 ? &l->out.on_base[column]
                               : &l->out.on_top[column * own + layer - l->s->first_layer];
        body_node(b, node, level, x);
        *end = vec6_add(*end, wrench_of_force(l->f + 3 * i, x));
    }
}

static status add_brick(loader *l, int block, int e, int layer)
{
    status st = OK;
    const mesh_block *k = &l->p->body->plane->block[block];
    const int n = k->per_elem * (l->p->body->order + 1);
    memset(l->mass, 0, (size_t)n * sizeof *l->mass);
    TRY(brick_mass(l->brick, layer, l->mass));
    for (int j = 0; j < l->p->nextra; j++) {
        const load_column *c = &l->p->extra[j];
        if (!has_volume_load(c)) {
            continue;
        }
        memset(l->f, 0, 3 * (size_t)n * sizeof *l->f);
        TRY(brick_body_force(l->brick, layer, c->body_force, l->f));
        for (int i = 0; i < 3 * n; i++) {
            l->f[i] += l->mass[i / 3] * c->acceleration[i % 3];
        }
        add_nodes(l, 6 + j, k->conn + (size_t)e * (size_t)k->per_elem, k->per_elem, layer);
    }

done:
    return st;
}

static status load_volume(loader *l)
{
    status st = OK;
    const body *b = l->p->body;
    bool any = false;
    for (int j = 0; j < l->p->nextra; j++) {
        any = any || has_volume_load(&l->p->extra[j]);
    }
    for (int block = 0; any && block < b->plane->nblock; block++) {
        for (int e = 0; e < b->plane->block[block].nelem; e++) {
            TRY(brick_stand_on(l->brick, block, e));
            for (int layer = l->s->from / b->order; layer < l->s->last_layer; layer++) {
                if (body_material(b, block, e, layer) >= 0) {
                    TRY(add_brick(l, block, e, layer));
                }
            }
        }
    }

done:
    return st;
}

// --- pressures and tractions on faces

typedef struct patch_loader {
    loader *l;
    const face_pressure *load;
    int column;
} patch_loader;

// where a patch's forces on the ends of its layer are counted, NULL: not at all
static vec6 *end_of(const loader *l, const face_pressure *load, const face_patch *p, int i,
                    int column)
{
    const int own = l->s->last_layer - l->s->first_layer, order = l->p->body->order;
    if (load->on.face < FACE_OUTSIDE || p->layer < l->s->first_layer) {
        return NULL; // what acts on the end planes lies beyond the sections
    }
    if (p->level[i] == 0) {
        return &l->out.on_base[column];
    }
    return p->level[i] == (p->layer + 1) * order
               ? &l->out.on_top[column * own + p->layer - l->s->first_layer]
               : NULL;
}

static status add_patch(void *self, const face_patch *p)
{
    const patch_loader *a = (const patch_loader *)self;
    for (int i = 0; i < p->nnode; i++) {
        double f[3] = {0}, x[3];
        for (int q = 0; q < p->npoint; q++) {
            for (int d = 0; d < 3; d++) {
                const double t = a->load->traction[d] - a->load->pressure * p->normal[q][d];
                f[d] += p->N[q][i] * p->dA[q] * t;
            }
        }
        double *to = level_of(a->l, a->column, p->level[i]) + 3 * (size_t)p->plane_node[i];
        vec6 *end = end_of(a->l, a->load, p, i, a->column);
        body_node(a->l->p->body, p->plane_node[i], p->level[i], x);
        for (int d = 0; d < 3; d++) {
            to[d] += f[d];
        }
        if (end) {
            *end = vec6_add(*end, wrench_of_force(f, x));
        }
    }
    return OK;
}

static status load_faces(loader *l)
{
    status st = OK;
    const body *b = l->p->body;
    for (int j = 0; j < l->p->nextra; j++) {
        for (int k = 0; k < l->p->extra[j].npressure; k++) {
            patch_loader a = {l, &l->p->extra[j].pressure[k], 6 + j};
            TRY(face_check(b, &a.load->on));
            TRY(face_walk(b, &a.load->on, l->s->from / b->order, l->s->last_layer, add_patch, &a));
        }
    }

done:
    return st;
}

// --- the whole

static status load_levels(loader *l)
{
    status st = OK;
    const body *b = l->p->body;
    const size_t ncolumn = (size_t)l->out.ncolumn, held = (size_t)(l->s->to - l->s->from);
    TRY(TAKE(l->out.force, ncolumn * held * 3 * (size_t)b->plane->nnode));
    TRY(TAKE(l->out.on_top, ncolumn * (size_t)(l->s->last_layer - l->s->first_layer)));
    TRY(TAKE(l->out.on_base, ncolumn));
    TRY(TAKE(l->f, BRICK_MAX_DOFS));
    TRY(TAKE(l->mass, BRICK_MAX_NODES));
    TRY(brick_make(b, &l->brick));
    if (l->s->last == b->nlevel && l->s->first < l->s->last) {
        TRY(load_tip(l));
    }
    TRY(load_volume(l));
    TRY(load_faces(l));

done:
    return st;
}

status level_loads_make(const petsc_door *door, const segment_problem *p, const level_share *s,
                        level_loads *out)
{
    status st = OK;
    loader l = {.door = door, .p = p, .s = s, .out = {.ncolumn = problem_columns(p)}};
    TRY(door->agree(load_levels(&l)));
    if (p->base == BASE_FREE_TO_CONTRACT) {
        TRY(level_loads_balance(door, p, s, &l.out));
    }
    *out = l.out;
    l.out = (level_loads){0};

done:
    free(l.f);
    free(l.mass);
    brick_free(l.brick);
    level_loads_free(&l.out);
    return st;
}
