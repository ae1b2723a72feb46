// reach/reach_map_many.c
// More than one bending joint: the tip as it is in the middle of every cell of the grid, moved in
// and turned; finer and finer until the looks run out.
#include "reach/reach_map_inside.h"

#include <string.h>

enum { ROUNDS = 4, SAMPLES = 16 };

// Boxes of the first round are divided to this share of `near`, to a half of it each time.
static const double first_share = 1;

// a sweep that stays where it is
static status bend_to(mapping *m, const double *bend)
{
    status st = OK;
    const scope *s = m->inv->scope;
    double q[SCOPE_JOINTS] = {0};
    bend_node n = {0};
    memcpy(q + SCOPE_BEND, bend, (size_t)(s->njoint - SCOPE_BEND) * sizeof *q);
    TRY(scope_bend(m->state, q));
    TRY(scope_bent_tip(m->state, &n.tip, NULL));
    n.farthest = scope_stretch(m->state) * s->length / (2 * SAMPLES);
    for (int i = 1; i <= SAMPLES; i++) {
        vec3 p;
        TRY(scope_bent_point(m->state, s->length * i / SAMPLES, &p, NULL));
        n.farthest = fmax(n.farthest, hypot(p.a[0], p.a[1]) +
                                          scope_stretch(m->state) * s->length / (2 * SAMPLES));
    }
    m->still_node[0] = m->still_node[1] = n;
    m->still = (bend_sweep){.nnode = 2, .node = m->still_node};
    m->bend = bend;
    m->sweep = &m->still;

done:
    return st;
}

// whether any tip of the cell may come near it                              docs/theory.md (10.4)
static bool may_hold(const mapping *m, const grid_cell *g, cylinder_point c)
{
    const scope *s = m->inv->scope;
    const double rho = fmax(fmax(g->rho[0] - c.rho, c.rho - g->rho[1]), 0);
    const double z = fmax(
        fmax(g->z[0] + s->low[SCOPE_INSERTION] - c.z, c.z - g->z[1] - s->high[SCOPE_INSERTION]), 0);
    return hypot(rho, z) <= m->options->near;
}

static bool ask_cells(void *context, int point)
{
    const mapping *m = context;
    const bend_grid *g = &m->inv->grid;
    const double *p = m->samples.point[point];
    const cylinder_point c = cylinder_of(m->state, (vec3){{p[0], p[1], p[2]}});
    for (int k = 0; k < g->ncell && !m->maybe[point]; k++) {
        m->maybe[point] = may_hold(m, &g->cell[k], c);
    }
    return !m->maybe[point]; // what is out of reach is done
}

status map_many(mapping *m)
{
    status st = OK;
    const bend_grid *g = &m->inv->grid;
    sample_grid_near(&m->samples, scope_entry(m->state).p, INFINITY, ask_cells, m);
    for (int round = 0; round < ROUNDS && m->out->looks < m->options->most_looks; round++) {
        m->resolution = first_share * m->options->near / (1 << round);
        m->out->spacing = 0;
        for (int k = 0; k < g->ncell && m->out->looks < m->options->most_looks; k++) {
            TRY(bend_to(m, g->cell[k].middle));
            TRY(map_boxes(m));
        }
        m->out->spacing += g->spacing;
    }

done:
    return st;
}
