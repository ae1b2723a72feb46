// section/plane.c
#include "section/plane.h"

#include "base/memory.h"

#include <math.h>
#include <stdbool.h>

void plane_free(plane *p)
{
    free(p->xy);
    free(p->room);
    for (int b = 0; b < MESH_MAX_BLOCKS; b++) {
        basis_table_free(&p->table[b]);
    }
    *p = (plane){0};
}

static status scale_nodes(plane *p)
{
    status st = OK;
    const mesh *m = p->mesh;
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < m->nnode; i++) {
        for (int c = 0; c < 2; c++) {
            low[c] = fmin(low[c], m->xyz[3 * i + c]);
            high[c] = fmax(high[c], m->xyz[3 * i + c]);
        }
    }
    p->length = hypot(high[0] - low[0], high[1] - low[1]) / 2;
    if (m->dim != 2 || !(p->length > 0) || !isfinite(p->length)) {
        TRY(status_fail(ERR_NUMERIC, "section: the mesh is not a plane one with an extent"));
    }
    TRY(TAKE(p->xy, 2 * (size_t)m->nnode));
    for (int c = 0; c < 2; c++) {
        p->centre[c] = (low[c] + high[c]) / 2;
        for (int i = 0; i < m->nnode; i++) {
            p->xy[2 * i + c] = (m->xyz[3 * i + c] - p->centre[c]) / p->length;
        }
    }

done:
    return st;
}

status plane_make(const mesh *m, int degree, plane *out)
{
    status st = OK;
    plane p = {.mesh = m};
    size_t most = 0;

    TRY(scale_nodes(&p));
    for (int b = 0; b < m->nblock; b++) {
        element e = {0};
        TRY(element_make(m->block[b].shape, m->order, &e));
        TRY(basis_table_make(&e, degree, &p.table[b]));
        const size_t need = (size_t)p.table[b].npoint * (size_t)(3 + 2 * e.nnode);
        most = need > most ? need : most;
    }
    TRY(TAKE(p.room, most));
    *out = p;
    p = (plane){0};

done:
    plane_free(&p);
    return st;
}

void plane_use_origin(plane *p)
{
    for (int i = 0; i < p->mesh->nnode; i++) {
        for (int c = 0; c < 2; c++) {
            p->xy[2 * i + c] = p->mesh->xyz[3 * i + c] / p->length;
        }
    }
    p->centre[0] = p->centre[1] = 0;
}

// place, weight and derivatives at point q; false where the element is inverted there
static bool map_point(const plane *p, const basis_table *t, int q, plane_element *e)
{
    const int n = e->nnode;
    const double *N = t->N + q * n, *dN = t->dN + 2 * q * n;
    double x = 0, y = 0, xa = 0, xb = 0, ya = 0, yb = 0;
    for (int i = 0; i < n; i++) {
        const double *at = p->xy + 2 * e->node[i];
        x += N[i] * at[0];
        y += N[i] * at[1];
        xa += dN[2 * i] * at[0];
        xb += dN[2 * i + 1] * at[0];
        ya += dN[2 * i] * at[1];
        yb += dN[2 * i + 1] * at[1];
    }
    const double det = xa * yb - xb * ya;
    for (int i = 0; i < n; i++) {
        e->Nx[q * n + i] = (dN[2 * i] * yb - dN[2 * i + 1] * ya) / det;
        e->Ny[q * n + i] = (dN[2 * i + 1] * xa - dN[2 * i] * xb) / det;
    }
    e->x[q] = x;
    e->y[q] = y;
    e->dA[q] = t->weight[q] * det;
    return det > 0;
}

status plane_element_at(plane *p, int block, int index, plane_element *out)
{
    const mesh_block *b = &p->mesh->block[block];
    const basis_table *t = &p->table[block];
    const int n = t->nnode * t->npoint;
    *out = (plane_element){
        .block = block,
        .index = index,
        .nnode = t->nnode,
        .npoint = t->npoint,
        .material = b->material[index],
        .node = b->conn + (size_t)index * (size_t)b->per_elem,
        .N = t->N,
        .Nx = p->room,
        .Ny = p->room + n,
        .x = p->room + 2 * n,
        .y = p->room + 2 * n + t->npoint,
        .dA = p->room + 2 * n + 2 * t->npoint,
    };
    for (int q = 0; q < t->npoint; q++) {
        if (!map_point(p, t, q, out)) {
            return status_fail(ERR_NUMERIC, "section: %s %d is inverted at (%g, %g) m",
                               shape_name(b->shape), index, p->centre[0] + p->length * out->x[q],
                               p->centre[1] + p->length * out->y[q]);
        }
    }
    return OK;
}
