// reports/segment_sides.c
// The sides of a segment's layers, and the faces that look up.
#include "reports/segment_surface_parts.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

enum { MAX_CUTS = 16 }; // of one element

static int cuts_for(int wanted, double part)
{
    const double cuts = round(wanted * part);
    return cuts < 1 ? 1 : cuts > MAX_CUTS ? MAX_CUTS : (int)cuts;
}

// --- the sides

// by its share of the circumference of a circle around the section
static int cuts_of_edge(const surface_maker *m, const plane_edge *edge, int order)
{
    const double *a = m->body->plane.xyz + 3 * (size_t)edge->node[0];
    const double *b = m->body->plane.xyz + 3 * (size_t)edge->node[order];
    const double around = 2 * acos(-1.0) * m->radius;
    return cuts_for(m->wanted_around, around > 0 ? hypot(b[0] - a[0], b[1] - a[1]) / around : 0);
}

static int cuts_of_layer(const surface_maker *m, int layer)
{
    const segment_body *b = m->body;
    const double height = b->level[(layer + 1) * b->order] - b->level[layer * b->order];
    return cuts_for(m->wanted_along, height / (b->level[b->nlevel - 1] - b->level[0]));
}

static status add_side(surface_maker *m, const element *side, const plane_edge *edge, int layer,
                       bool border)
{
    status st = OK;
    element line;
    const int p = m->body->order, around = cuts_of_edge(m, edge, side->order),
              along = cuts_of_layer(m, layer);
    int apart[ELEMENT_MAX_ORDER + 1] = {0};
    surface_point grid[MAX_CUTS + 1][MAX_CUTS + 1];
    const surface_nodes at = {side->nnode, edge->node, apart};

    m->material = edge->material;
    m->part = 0;
    TRY(element_make(SHAPE_LINE, p, &line));
    for (int i = 0; i < side->nnode && m->ncopy > 0; i++) {
        apart[i] = surface_copy_of(m, edge->node[i], edge->material);
    }
    for (int j = 0; j <= along; j++) {
        double M[ELEMENT_MAX_ORDER + 1];
        element_basis(&line, &(double){2.0 * j / along - 1}, M, NULL);
        for (int i = 0; i <= around; i++) {
            double N[ELEMENT_MAX_ORDER + 1];
            element_basis(side, &(double){2.0 * i / around - 1}, N, NULL);
            grid[j][i] = surface_point_of(m, &at, N, layer * p, p + 1, M);
        }
    }
    for (int j = 0; j < along; j++) {
        for (int i = 0; i < around; i++) {
            const surface_point *corner[4] = {&grid[j][i], &grid[j][i + 1], &grid[j + 1][i + 1],
                                              &grid[j + 1][i]};
            TRY(surface_add_facet(m, 4, corner, border && i == 0));
        }
    }

done:
    return st;
}

// the material of the outer side that ends where this one begins differs
static status find_borders(const plane_edges *edges, bool **out)
{
    status st = OK;
    const int p = edges->line.order;
    int *ends = NULL;
    bool *border = NULL;
    TRY(TAKE(ends, (size_t)edges->mesh->nnode));
    TRY(TAKE(border, (size_t)edges->count));
    for (int i = 0; i < edges->mesh->nnode; i++) {
        ends[i] = -1;
    }
    for (int i = 0; i < edges->count; i++) {
        if (edges->edge[i].other < 0) {
            ends[edges->edge[i].node[p]] = edges->edge[i].material;
        }
    }
    for (int i = 0; i < edges->count; i++) {
        const plane_edge *e = &edges->edge[i];
        border[i] = e->other < 0 && ends[e->node[0]] >= 0 && ends[e->node[0]] != e->material;
    }
    *out = border;
    border = NULL;

done:
    free(ends);
    free(border);
    return st;
}

static status add_sides(surface_maker *m, const plane_edges *edges, int layer)
{
    status st = OK;
    bool *border = NULL;
    TRY(find_borders(edges, &border));
    for (int i = 0; i < edges->count; i++) {
        if (edges->edge[i].other < 0) {
            TRY(add_side(m, &edges->line, &edges->edge[i], layer, border[i]));
        }
    }

done:
    free(border);
    return st;
}

// --- faces that look up: of elements with nothing above them

// corner (i, j) of the lattice that cuts a reference quad or triangle
static surface_point cap_point(const surface_maker *m, const element *e, const surface_nodes *at,
                               int level, double i, double j, int cuts)
{
    const bool quad = e->shape == SHAPE_QUAD;
    const double x[2] = {quad ? 2 * i / cuts - 1 : i / cuts, quad ? 2 * j / cuts - 1 : j / cuts};
    double N[ELEMENT_MAX_PLANE_NODES];
    element_basis(e, x, N, NULL);
    return surface_point_of(m, at, N, level, 1, &(double){1});
}

static status add_cap_element(surface_maker *m, const element *e, const surface_nodes *at,
                              int level, int cuts)
{
    status st = OK;
    for (int j = 0; j < cuts; j++) {
        for (int i = 0; i < (e->shape == SHAPE_QUAD ? cuts : cuts - j); i++) {
            const surface_point a = cap_point(m, e, at, level, i, j, cuts);
            const surface_point b = cap_point(m, e, at, level, i + 1, j, cuts);
            const surface_point d = cap_point(m, e, at, level, i, j + 1, cuts);
            if (e->shape == SHAPE_TRIANGLE && i + j + 1 == cuts) {
                TRY(surface_add_facet(m, 3, (const surface_point *[]){&a, &b, &d}, false));
                continue;
            }
            const surface_point c = cap_point(m, e, at, level, i + 1, j + 1, cuts);
            TRY(surface_add_facet(m, 4, (const surface_point *[]){&a, &b, &c, &d}, false));
        }
    }

done:
    return st;
}

static int cap_cuts(const surface_maker *m)
{
    // an element's size from the mean area
    const double side = m->radius * sqrt(acos(-1.0) / mesh_element_count(&m->body->plane));
    const double around = 2 * acos(-1.0) * m->radius;
    return cuts_for(m->wanted_around, around > 0 ? side / around : 0);
}

// element e counts through all blocks
static bool is_there(const segment_body *b, int layer, int e)
{
    if (layer < 0 || layer >= b->nlayer) {
        return false;
    }
    return !b->matter ||
           b->matter[(size_t)layer * (size_t)mesh_element_count(&b->plane) + (size_t)e] >= 0;
}

static int material_of(const segment_body *b, int layer, int e, int in_mesh)
{
    return b->matter ? b->matter[(size_t)layer * (size_t)mesh_element_count(&b->plane) + (size_t)e]
                     : in_mesh;
}

static status add_caps(surface_maker *m, int layer)
{
    status st = OK;
    const segment_body *body = m->body;
    element e;
    m->part = 1;
    for (int b = 0, count = 0; b < body->plane.nblock; b++) {
        const mesh_block *k = &body->plane.block[b];
        TRY(element_make(k->shape, body->plane.order, &e));
        for (int i = 0; i < k->nelem; i++, count++) {
            const size_t first = (size_t)i * (size_t)k->per_elem;
            const surface_nodes at = {e.nnode, k->conn + first,
                                      m->ncopy > 0 ? body->apart.block[b].conn + first : NULL};
            if (!is_there(body, layer, count)) {
                continue;
            }
            m->material = material_of(body, layer, count, k->material[i]);
            if (!is_there(body, layer + 1, count)) {
                TRY(add_cap_element(m, &e, &at, (layer + 1) * body->order, cap_cuts(m)));
            }
            if (m->below && !is_there(body, layer - 1, count)) {
                TRY(add_cap_element(m, &e, &at, layer * body->order, cap_cuts(m)));
            }
        }
    }

done:
    return st;
}

// --- layers

// the plane mesh without the elements that a layer has not, its materials those of the layer;
// nodes stay
static status mesh_of_layer(const segment_body *b, int layer, mesh *out)
{
    status st = OK;
    mesh m = {0};
    TRY(mesh_copy(&b->plane, &m));
    for (int k = 0, count = 0; k < m.nblock; k++) {
        mesh_block *block = &m.block[k];
        const size_t n = (size_t)block->per_elem;
        int left = 0;
        for (int e = 0; e < block->nelem; e++, count++) {
            if (is_there(b, layer, count)) {
                memmove(block->conn + (size_t)left * n, block->conn + (size_t)e * n,
                        n * sizeof *block->conn);
                block->material[left++] =
                    b->matter[(size_t)layer * (size_t)mesh_element_count(&b->plane) +
                              (size_t)count];
            }
        }
        block->nelem = left;
    }
    *out = m;
    m = (mesh){0};

done:
    mesh_free(&m);
    return st;
}

status surface_add_all(surface_maker *m)
{
    status st = OK;
    mesh own = {0};
    plane_edges edges = {0};
    const segment_body *b = m->body;
    TRY(b->matter ? OK : plane_edges_make(&b->plane, &edges));
    for (int layer = 0; layer < b->nlayer; layer++) {
        if (b->matter) {
            plane_edges_free(&edges);
            mesh_free(&own);
            TRY(mesh_of_layer(b, layer, &own));
            TRY(plane_edges_make(&own, &edges));
        }
        TRY(add_sides(m, &edges, layer));
        TRY(add_caps(m, layer));
    }

done:
    plane_edges_free(&edges);
    mesh_free(&own);
    return st;
}
