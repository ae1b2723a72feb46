// fem/way_resultant.c
// The resultants of the stresses on every level, by the work of nodal forces on rigid motions.
// docs/theory.md (5.13)
#include "fem/level_forces.h"

#include "base/memory.h"

#include <string.h>

// --- from forces of nodes to resultants inside a layer

typedef struct line_weights {
    int p;
    // resultant at level k = 0..p of a layer: sum of a[k][l] x (force on level l), l = 1..p
    double a[ELEMENT_MAX_ORDER + 1][ELEMENT_MAX_ORDER + 1];
} line_weights;

// Gaussian elimination of the p x p matrix with p + 1 right-hand sides, pivoted by columns' largest
static void solve_small(int p, double (*m)[2 * ELEMENT_MAX_ORDER + 1])
{
    for (int i = 0; i < p; i++) {
        int best = i;
        for (int r = i + 1; r < p; r++) {
            best = fabs(m[r][i]) > fabs(m[best][i]) ? r : best;
        }
        for (int c = 0; c < 2 * p + 1; c++) {
            const double t = m[i][c];
            m[i][c] = m[best][c];
            m[best][c] = t;
        }
        for (int r = 0; r < p; r++) {
            const double by = r == i ? 0 : m[r][i] / m[i][i];
            for (int c = i; by != 0 && c < 2 * p + 1; c++) {
                m[r][c] -= by * m[i][c];
            }
        }
    }
    for (int i = 0; i < p; i++) {
        for (int c = p; c < 2 * p + 1; c++) {
            m[i][c] /= m[i][i];
        }
    }
}

// The polynomial W of degree p - 1 with int N_l' W ds = force on level l. Unknown: its values at
// the p Gauss points.
static line_weights line_weights_of(const element *line)
{
    const int p = line->order;
    line_weights w = {.p = p};
    double x[ELEMENT_MAX_ORDER], g[ELEMENT_MAX_ORDER], N[ELEMENT_MAX_ORDER + 1],
        dN[ELEMENT_MAX_ORDER + 1];
    double m[ELEMENT_MAX_ORDER][2 * ELEMENT_MAX_ORDER + 1] = {{0}}; // transposed system
    gauss_legendre(p, x, g);
    for (int q = 0; q < p; q++) {
        element_basis(line, &x[q], N, dN);
        for (int l = 1; l <= p; l++) {
            m[q][l - 1] = g[q] * dN[l];
        }
        for (int k = 0; k <= p; k++) { // W at level k by its values at the points
            m[q][p + k] = 1;
            for (int r = 0; r < p; r++) {
                m[q][p + k] *= r == q ? 1 : (line->line_node[k] - x[r]) / (x[q] - x[r]);
            }
        }
    }
    solve_small(p, m);
    for (int k = 0; k <= p; k++) {
        for (int l = 1; l <= p; l++) {
            w.a[k][l] = m[l - 1][p + k];
        }
    }
    return w;
}

static vec6 inside(const line_weights *w, int k, const vec6 *force)
{
    vec6 here = {0};
    for (int l = 1; l <= w->p; l++) {
        here = vec6_add(here, vec6_scale(w->a[k][l], force[l]));
    }
    return here;
}

static vec6 about_section(const body *b, vec6 w, int level)
{
    const double zero[3] = {0};
    double origin[3];
    body_origin(b, level, origin);
    return wrench_moved(w, zero, origin);
}

// --- of stresses

// Upper ends of layers by the nodes' forces there, without what loads and springs on the layer put
// on them; levels inside by the polynomial; the base as the upper ends.
static void fill_layer(const way_field *f, const level_forces *inner, const line_weights *w,
                       int column, int layer, vec6 *resultant)
{
    const body *b = f->p->body;
    const int p = b->order, own = f->share.last_layer - f->share.first_layer;
    const int at = column * own + layer - f->share.first_layer;
    const vec6 *sum = inner->sum + (size_t)at * (size_t)(p + 1);
    for (int k = 1; k < p; k++) {
        resultant[layer * p + k] = about_section(b, inside(w, k, sum), layer * p + k);
    }
    const vec6 loads = vec6_sub(f->loads->on_top[at], inner->sprung_top[at]);
    resultant[(layer + 1) * p] = about_section(b, vec6_sub(sum[p], loads), (layer + 1) * p);
    if (layer == 0) {
        const vec6 low = vec6_sub(f->loads->on_base[column], inner->sprung_base[column]);
        resultant[0] = about_section(b, vec6_sub(low, sum[0]), 0);
    }
}

void way_resultants(const way_field *f, const level_forces *inner, vec6 *resultant)
{
    const body *b = f->p->body;
    const line_weights w = line_weights_of(&b->line);
    for (int j = 0; j < problem_columns(f->p); j++) {
        for (int layer = f->share.first_layer; layer < f->share.last_layer; layer++) {
            fill_layer(f, inner, &w, j, layer, resultant + (size_t)j * (size_t)b->nlevel);
        }
    }
}

// --- of what acts beyond

typedef struct beyond {
    vec6 *on_level; // [nlevel] loads, springs and holds on the nodes of a level
    vec6 *on_top;   // [nlayer] of those what the layer below has on the level
    vec6 *on_base;  // [1] what the first layer has on the base
} beyond;

// Loads, and in held directions what holds them; about the base's origin.
static void act_on_levels(const way_field *f, const level_forces *inner, int column, vec6 *on_level)
{
    const unknowns *u = f->unknowns;
    for (int level = f->share.first; level < f->share.last; level++) {
        const size_t at = way_field_offset(f, column, level);
        for (int i = 0; i < u->nplane; i++) {
            const double *load = f->loads->force + at + 3 * (size_t)i;
            const double *force = inner->force + at + 3 * (size_t)i;
            double x[3];
            vec3 t;
            body_node(f->p->body, i, level, x);
            for (int d = 0; d < 3; d++) {
                t.a[d] = unknowns_is_held(u, i, level, d) ? force[d] : load[d];
            }
            on_level[level] = vec6_add(on_level[level], wrench_of_force(t.a, x));
        }
        on_level[level] = vec6_sub(
            on_level[level], inner->sprung[(size_t)column * (size_t)u->nlevel + (size_t)level]);
    }
}

static void fill_beyond(const way_field *f, const level_forces *inner, int column, beyond *out)
{
    const level_share *s = &f->share;
    const double zero[3] = {0};
    const int own = s->last_layer - s->first_layer, top = f->p->body->nlevel - 1;
    act_on_levels(f, inner, column, out->on_level);
    if (column < 6 && f->p->tip == TIP_RIGID && unknowns_has_tip(f->unknowns)) {
        double tip[3];
        vec6 unit = {0};
        unit.a[column] = 1;
        body_origin(f->p->body, top, tip);
        out->on_level[top] = vec6_add(out->on_level[top], wrench_moved(unit, tip, zero));
    }
    for (int layer = s->first_layer; layer < s->last_layer; layer++) {
        const int at = column * own + layer - s->first_layer;
        out->on_top[layer] = vec6_sub(f->loads->on_top[at], inner->sprung_top[at]);
    }
    *out->on_base = vec6_sub(f->loads->on_base[column], inner->sprung_base[column]);
}

// layer by layer from the tip
static void sum_beyond(const body *b, const line_weights *w, const beyond *from, vec6 *applied)
{
    const int p = b->order;
    vec6 sum = {0}, force[ELEMENT_MAX_ORDER + 1];
    for (int layer = b->nlayer - 1; layer >= 0; layer--) {
        const int top = (layer + 1) * p;
        sum = vec6_add(sum, from->on_level[top]);
        applied[top] = vec6_sub(sum, from->on_top[layer]);
        force[p] = sum;
        for (int k = 1; k < p; k++) {
            force[k] = from->on_level[layer * p + k];
            sum = vec6_add(sum, force[k]);
        }
        for (int k = 1; k < p; k++) {
            applied[layer * p + k] = inside(w, k, force);
        }
    }
    applied[0] = vec6_add(sum, *from->on_base);
}

status way_applied(const way_field *f, const level_forces *inner, vec6 *applied)
{
    status st = OK;
    const body *b = f->p->body;
    const line_weights w = line_weights_of(&b->line);
    const size_t many = (size_t)b->nlevel + (size_t)b->nlayer + 1;
    vec6 *all = NULL, *here = NULL;
    TRY(f->door->agree(TAKE(all, many)));
    TRY(f->door->agree(TAKE(here, (size_t)b->nlevel)));
    for (int j = 0; j < problem_columns(f->p); j++) {
        beyond from = {all, all + b->nlevel, all + b->nlevel + b->nlayer};
        vec6 *to = applied + (size_t)j * (size_t)b->nlevel;
        memset(all, 0, many * sizeof *all);
        fill_beyond(f, inner, j, &from);
        f->door->sum(6 * (int)many, all->a);
        sum_beyond(b, &w, &from, here);
        for (int level = f->share.first; level < f->share.last; level++) {
            to[level] = about_section(b, here[level], level);
        }
    }
    f->door->sum(6 * problem_columns(f->p) * b->nlevel, applied->a);

done:
    free(all);
    free(here);
    return st;
}
