// fem/way_energy.c
// The strain energy of unit wrenches over a window of the middle. docs/theory.md (5.5)
#include "fem/way_fill.h"

#include "base/beam_law.h"
#include "base/memory.h"
#include "fem/brick.h"

#include <string.h>

// What is left of the six solutions near the window's centre, once they are combined to unit
// wrenches there and the motion of the section nearby is taken away: the energy would lose as many
// digits as the motion is larger than the strains.
typedef struct near_centre {
    const way_field *f;
    double from, to;  // of the window [m]
    mat6 combine;     // column j: coefficients of the tip's unit solutions
    vec6 motion[6];   // of the combined ones at the level nearby
    double origin[3]; // of that level's section
    brick *brick;
    element plane;
    double *u[6]; // of one element
} near_centre;

static int nearest_level(const body *b, double z)
{
    int level = 0;
    for (int k = 1; k < b->nlevel; k++) {
        level = fabs(b->level[k] - z) < fabs(b->level[level] - z) ? k : level;
    }
    return level;
}

// which layer of this rank a height lies in, -1: none; of two the lower one
static int layer_at(const way_field *f, double z)
{
    const body *b = f->p->body;
    for (int layer = f->share.first_layer; layer < f->share.last_layer; layer++) {
        const bool begins = layer == 0 ? z >= b->level[0] : z > b->level[layer * b->order];
        if (begins && z <= b->level[(layer + 1) * b->order]) {
            return layer;
        }
    }
    return -1;
}

// Origins that only one rank knows: of the window's centre, the level nearby and the tip. (all)
static void find_origins(const way_field *f, double z, double *centre, double *near, double *tip)
{
    const body *b = f->p->body;
    const int level = nearest_level(b, z), layer = layer_at(f, z), p = b->order;
    const bool any = f->share.first < f->share.last;
    double all[9] = {0};
    mat3 axes;
    if (layer >= 0) {
        const double begin = b->level[layer * p], end = b->level[(layer + 1) * p];
        body_pose_at(b, layer, 2 * (z - begin) / (end - begin) - 1, &axes, all);
    }
    if (any && level >= f->share.first && level < f->share.last) {
        body_origin(b, level, all + 3);
    }
    if (any && f->share.last == b->nlevel) {
        body_origin(b, b->nlevel - 1, all + 6);
    }
    f->door->sum(9, all);
    memcpy(centre, all, 3 * sizeof *all);
    memcpy(near, all + 3, 3 * sizeof *all);
    memcpy(tip, all + 6, 3 * sizeof *all);
}

static void combine_solutions(near_centre *s, double z, const vec6 *motion)
{
    const body *b = s->f->p->body;
    const int level = nearest_level(b, z);
    double centre[3], tip[3];
    find_origins(s->f, z, centre, s->origin, tip);
    for (int j = 0; j < 6; j++) {
        vec6 w = {0};
        w.a[j] = 1;
        w = wrench_moved(w, centre, tip);
        for (int k = 0; k < 6; k++) {
            s->combine.a[k][j] = w.a[k];
            s->motion[j] =
                vec6_add(s->motion[j], vec6_scale(w.a[k], motion[k * b->nlevel + level]));
        }
    }
}

// nodal values of the combined solutions in one element, without the motion nearby
static void gather(const near_centre *s, const int *conn, int n2, int layer)
{
    const body *b = s->f->p->body;
    for (int i = 0; i < n2 * (b->order + 1); i++) {
        const int node = conn[i % n2], level = layer * b->order + i / n2;
        double x[3];
        body_node(b, node, level, x);
        const vec3 r = {{x[0] - s->origin[0], x[1] - s->origin[1], x[2] - s->origin[2]}};
        for (int j = 0; j < 6; j++) {
            const vec3 turn = vec3_cross(vec6_angular(s->motion[j]), r);
            for (int d = 0; d < 3; d++) {
                s->u[j][3 * i + d] = -(s->motion[j].a[d] + turn.a[d]);
            }
        }
        for (int k = 0; k < 6; k++) {
            const double *from = way_field_level(s->f, k, level) + 3 * (size_t)node;
            for (int j = 0; j < 6; j++) {
                for (int d = 0; d < 3; d++) {
                    s->u[j][3 * i + d] += s->combine.a[k][j] * from[d];
                }
            }
        }
    }
}

// det J at a point of an element, the line's coordinate last
static double jacobian(const near_centre *s, const int *conn, int layer, const double at[3])
{
    const body *b = s->f->p->body;
    const int n2 = s->plane.nnode, p = b->order;
    double N[ELEMENT_MAX_PLANE_NODES], dN[2 * ELEMENT_MAX_PLANE_NODES], L[ELEMENT_MAX_ORDER + 1],
        dL[ELEMENT_MAX_ORDER + 1];
    mat3 J = {0};
    element_basis(&s->plane, at, N, dN);
    element_basis(&b->line, at + 2, L, dL);
    for (int i = 0; i < n2 * (p + 1); i++) {
        const int a = i % n2, k = i / n2;
        const double slope[3] = {dN[2 * a] * L[k], dN[2 * a + 1] * L[k], N[a] * dL[k]};
        double x[3];
        body_node(b, conn[a], layer * p + k, x);
        for (int r = 0; r < 3; r++) {
            for (int c = 0; c < 3; c++) {
                J.a[r][c] += x[r] * slope[c];
            }
        }
    }
    const double(*m)[3] = (const double(*)[3])J.a;
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

static status add_point(const near_centre *s, const int *conn, int layer, const double at[3],
                        double weight, mat6 *U)
{
    status st = OK;
    double strain[6][6], stress[6][6];
    const double dV = weight * jacobian(s, conn, layer, at);
    for (int j = 0; j < 6; j++) {
        TRY(brick_stress_at(s->brick, layer, at, s->u[j], strain[j], stress[j], NULL));
    }
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            for (int k = 0; k < 6; k++) {
                U->a[i][j] += dV * strain[i][k] * stress[j][k];
            }
        }
    }

done:
    return st;
}

// the part of a layer within the window, in the line's coordinate; false: none
static bool clip(const near_centre *s, int layer, double *begin, double *end)
{
    const body *b = s->f->p->body;
    const double low = b->level[layer * b->order], high = b->level[(layer + 1) * b->order];
    *begin = fmax(-1, 2 * (s->from - low) / (high - low) - 1);
    *end = fmin(1, 2 * (s->to - low) / (high - low) - 1);
    return *end > *begin;
}

static status add_element(const near_centre *s, int block, int e, int layer, mat6 *U)
{
    status st = OK;
    const body *b = s->f->p->body;
    const mesh_block *k = &b->plane->block[block];
    const int *conn = k->conn + (size_t)e * (size_t)k->per_elem;
    const basis_table *t = &b->plane_table[block];
    const int n = b->prism ? b->order + 1 : b->order + 2;
    double begin, end, x[ELEMENT_MAX_ORDER + 2], g[ELEMENT_MAX_ORDER + 2];
    if (!clip(s, layer, &begin, &end) || body_material(b, block, e, layer) < 0) {
        return OK;
    }
    gauss_legendre(n, x, g);
    gather(s, conn, k->per_elem, layer);
    for (int q = 0; q < t->npoint; q++) {
        for (int l = 0; l < n; l++) {
            const double at[3] = {t->point[2 * q], t->point[2 * q + 1],
                                  (begin + end) / 2 + (end - begin) / 2 * x[l]};
            TRY(add_point(s, conn, layer, at, t->weight[q] * g[l] * (end - begin) / 2, U));
        }
    }

done:
    return st;
}

static status add_elements(near_centre *s, mat6 *U)
{
    status st = OK;
    const body *b = s->f->p->body;
    for (int block = 0; block < b->plane->nblock; block++) {
        TRY(element_make(b->plane->block[block].shape, b->plane->order, &s->plane));
        for (int e = 0; e < b->plane->block[block].nelem; e++) {
            TRY(brick_stand_on(s->brick, block, e));
            for (int layer = s->f->share.first_layer; layer < s->f->share.last_layer; layer++) {
                TRY(add_element(s, block, e, layer, U));
            }
        }
    }

done:
    return st;
}

static status take_room(near_centre *s)
{
    status st = OK;
    for (int j = 0; j < 6; j++) {
        TRY(TAKE(s->u[j], BRICK_MAX_DOFS));
    }
    TRY(brick_make(s->f->p->body, &s->brick));

done:
    return st;
}

status way_window_energy(const way_field *f, const way_wants *wants, const vec6 *motion,
                         mat6 *energy)
{
    status st = OK;
    near_centre s = {.f = f,
                     .from = wants->middle - wants->middle_half,
                     .to = wants->middle + wants->middle_half};
    mat6 U = {0};
    TRY(f->door->agree(take_room(&s)));
    combine_solutions(&s, wants->middle, motion);
    TRY(f->door->agree(add_elements(&s, &U)));
    f->door->sum(36, U.a[0]);
    *energy = mat6_symmetric(U);

done:
    for (int j = 0; j < 6; j++) {
        free(s.u[j]);
    }
    brick_free(s.brick);
    return st;
}
