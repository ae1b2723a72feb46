// reports/segment_surface.c
#include "reports/segment_surface.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

enum {
    WANTED_AROUND = 64, // facets around the section, so that a circle looks round on paper
    WANTED_ALONG = 56,  // and along it, so that the colour changes smoothly
    MAX_CUTS = 16,      // of one element
};

camera camera_from(double azimuth, double elevation)
{
    const double ca = cos(azimuth), sa = sin(azimuth), ce = cos(elevation), se = sin(elevation);
    return (camera){
        .right = {{ca, sa, 0}},
        .up = {{-se * sa, se * ca, ce}},
        .eye = {{ce * sa, -ce * ca, se}},
    };
}

vec3 camera_see(const camera *c, vec3 p)
{
    return (vec3){{vec3_dot(c->right, p), vec3_dot(c->up, p), vec3_dot(c->eye, p)}};
}

typedef struct surface_maker {
    const mesh *plane, *solid;
    const double *displacement;
    double magnify;
    const camera *camera;
    vec3 light;
    int nlayer;
    double radius; // of a circle about the origin that holds the section [m]
    int room;
    segment_surface out;
} surface_maker;

typedef struct surface_point {
    vec3 at;      // deformed, magnified [m]
    double value; // [m]
} surface_point;

// sum of N_i M_k over plane nodes i and levels k
static surface_point point_of(const surface_maker *m, int nplane, const int *node, const double *N,
                              int level, int nlevel, const double *M)
{
    double u[3] = {0}, x[3] = {0};
    for (int k = 0; k < nlevel; k++) {
        for (int i = 0; i < nplane; i++) {
            const int at = 3 * (node[i] + m->plane->nnode * (level + k));
            for (int d = 0; d < 3; d++) {
                x[d] += N[i] * M[k] * m->solid->xyz[at + d];
                u[d] += N[i] * M[k] * m->displacement[at + d];
            }
        }
    }
    const vec3 move = {{u[0], u[1], u[2]}};
    return (surface_point){vec3_add((vec3){{x[0], x[1], x[2]}}, vec3_scale(m->magnify, move)),
                           vec3_norm(move)};
}

// corners counter-clockwise as seen from outside
static status add_facet(surface_maker *m, int n, const surface_point *const *corner, bool border)
{
    const vec3 normal = vec3_cross(vec3_sub(corner[n / 2]->at, corner[0]->at),
                                   vec3_sub(corner[n - 1]->at, corner[1]->at));
    const double size = vec3_norm(normal);
    if (size <= 0 || vec3_dot(normal, m->camera->eye) <= 0) {
        return OK;
    }
    if (m->out.count == m->room) {
        return status_fail(ERR_BUG, "segment_surface: more facets than were counted");
    }
    facet *f = &m->out.facet[m->out.count++];
    *f = (facet){.ncorner = n, .border = border};
    for (int i = 0; i < n; i++) {
        const vec3 seen = camera_see(m->camera, corner[i]->at);
        f->at[i][0] = seen.a[0];
        f->at[i][1] = seen.a[1];
        f->depth += seen.a[2] / n;
        f->value += corner[i]->value / n;
    }
    f->light = vec3_dot(normal, m->light) / size;
    return OK;
}

// --- the sides ---

static int cuts_for(int wanted, double part)
{
    const double cuts = round(wanted * part);
    return cuts < 1 ? 1 : cuts > MAX_CUTS ? MAX_CUTS : (int)cuts;
}

// by its share of the circumference of a circle around the section
static int cuts_of_edge(const surface_maker *m, const plane_edge *edge, int order)
{
    const double *a = m->plane->xyz + 3 * (size_t)edge->node[0];
    const double *b = m->plane->xyz + 3 * (size_t)edge->node[order];
    const double around = 2 * acos(-1.0) * m->radius;
    return cuts_for(WANTED_AROUND, around > 0 ? hypot(b[0] - a[0], b[1] - a[1]) / around : 0);
}

static double level_z(const surface_maker *m, int level)
{
    return m->solid->xyz[3 * (size_t)m->plane->nnode * (size_t)level + 2];
}

static int cuts_of_layer(const surface_maker *m, int layer)
{
    const int p = m->solid->order;
    const double height = level_z(m, (layer + 1) * p) - level_z(m, layer * p);
    const double length = level_z(m, m->nlayer * p) - level_z(m, 0);
    return cuts_for(WANTED_ALONG, length > 0 ? height / length : 0);
}

static status add_side(surface_maker *m, const element *line, const plane_edge *edge, int layer,
                       const int cuts[2], bool border)
{
    status st = OK;
    const int p = line->order;
    surface_point grid[MAX_CUTS + 1][MAX_CUTS + 1];

    for (int j = 0; j <= cuts[1]; j++) {
        double M[ELEMENT_MAX_ORDER + 1];
        element_basis(line, &(double){2.0 * j / cuts[1] - 1}, M, NULL);
        for (int i = 0; i <= cuts[0]; i++) {
            double N[ELEMENT_MAX_ORDER + 1];
            element_basis(line, &(double){2.0 * i / cuts[0] - 1}, N, NULL);
            grid[j][i] = point_of(m, p + 1, edge->node, N, layer * p, p + 1, M);
        }
    }
    for (int j = 0; j < cuts[1]; j++) {
        for (int i = 0; i < cuts[0]; i++) {
            const surface_point *corner[4] = {&grid[j][i], &grid[j][i + 1], &grid[j + 1][i + 1],
                                              &grid[j + 1][i]};
            TRY(add_facet(m, 4, corner, border && i == 0));
        }
    }

done:
    return st;
}

// the material of the outer side that ends where this one begins differs
static bool *find_borders(const plane_edges *edges)
{
    const int p = edges->line.order;
    int *ends = malloc(sizeof *ends * (size_t)edges->mesh->nnode);
    bool *border = calloc((size_t)edges->count + 1, sizeof *border);
    if (!ends || !border) {
        free(ends);
        free(border);
        return NULL;
    }
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
    free(ends);
    return border;
}

static status add_sides(surface_maker *m, const plane_edges *edges)
{
    status st = OK;
    bool *border = find_borders(edges);
    if (!border) {
        return status_fail(ERR_RESOURCE, "out of memory for the picture of the segment");
    }
    for (int i = 0; i < edges->count; i++) {
        const plane_edge *edge = &edges->edge[i];
        for (int layer = 0; edge->other < 0 && layer < m->nlayer; layer++) {
            const int cuts[2] = {cuts_of_edge(m, edge, edges->line.order), cuts_of_layer(m, layer)};
            TRY(add_side(m, &edges->line, edge, layer, cuts, border[i]));
        }
    }

done:
    free(border);
    return st;
}

// --- the end ---

// corner (i, j) of the lattice that cuts a reference quad or triangle
static surface_point cap_point(const surface_maker *m, const element *e, const int *node, int level,
                               double i, double j, int cuts)
{
    const bool quad = e->shape == SHAPE_QUAD;
    const double x[2] = {quad ? 2 * i / cuts - 1 : i / cuts, quad ? 2 * j / cuts - 1 : j / cuts};
    double N[ELEMENT_MAX_PLANE_NODES];
    element_basis(e, x, N, NULL);
    return point_of(m, e->nnode, node, N, level, 1, &(double){1});
}

static status add_cap_element(surface_maker *m, const element *e, const int *node, int level,
                              int cuts)
{
    status st = OK;
    for (int j = 0; j < cuts; j++) {
        for (int i = 0; i < (e->shape == SHAPE_QUAD ? cuts : cuts - j); i++) {
            const surface_point a = cap_point(m, e, node, level, i, j, cuts);
            const surface_point b = cap_point(m, e, node, level, i + 1, j, cuts);
            const surface_point d = cap_point(m, e, node, level, i, j + 1, cuts);
            if (e->shape == SHAPE_TRIANGLE && i + j + 1 == cuts) {
                TRY(add_facet(m, 3, (const surface_point *[]){&a, &b, &d}, false));
                continue;
            }
            const surface_point c = cap_point(m, e, node, level, i + 1, j + 1, cuts);
            TRY(add_facet(m, 4, (const surface_point *[]){&a, &b, &c, &d}, false));
        }
    }

done:
    return st;
}

static int cap_cuts(const surface_maker *m)
{
    // an element's size from the mean area
    const double side = m->radius * sqrt(acos(-1.0) / mesh_element_count(m->plane));
    const double around = 2 * acos(-1.0) * m->radius;
    return cuts_for(WANTED_AROUND, around > 0 ? side / around : 0);
}

static status add_cap(surface_maker *m, int level)
{
    status st = OK;
    element e = {0};
    for (int b = 0; b < m->plane->nblock; b++) {
        const mesh_block *block = &m->plane->block[b];
        TRY(element_make(block->shape, m->plane->order, &e));
        for (int k = 0; k < block->nelem; k++) {
            TRY(add_cap_element(m, &e, block->conn + k * block->per_elem, level, cap_cuts(m)));
        }
    }

done:
    return st;
}

// --- all of it ---

static int farthest_first(const void *a, const void *b)
{
    const facet *f = a, *g = b;
    return (f->depth > g->depth) - (f->depth < g->depth);
}

static void count_facets(surface_maker *m, const plane_edges *edges)
{
    int along = 0, around = 0;
    for (int layer = 0; layer < m->nlayer; layer++) {
        along += cuts_of_layer(m, layer);
    }
    for (int i = 0; i < edges->count; i++) {
        around +=
            edges->edge[i].other < 0 ? cuts_of_edge(m, &edges->edge[i], edges->line.order) : 0;
    }
    m->room = around * along + mesh_element_count(m->plane) * cap_cuts(m) * cap_cuts(m);
}

status segment_surface_make(const run_result *r, const plane_edges *edges,
                            const double *displacement, double magnify, const camera *camera,
                            segment_surface *out)
{
    status st = OK;
    const mesh *plane = &r->segment_plane, *solid = &r->segment_mesh;
    const vec3 light = vec3_add(vec3_scale(0.45, camera->up),
                                vec3_add(vec3_scale(-0.45, camera->right), camera->eye));
    surface_maker m = {
        .plane = plane,
        .solid = solid,
        .displacement = displacement,
        .magnify = magnify,
        .camera = camera,
        .light = vec3_scale(1 / vec3_norm(light), light),
    };

    if (plane->nnode == 0 || solid->nnode % plane->nnode != 0 ||
        (solid->nnode / plane->nnode - 1) % solid->order != 0) {
        TRY(status_fail(ERR_BUG, "segment_surface: the solid mesh is not the plane one, extruded"));
    }
    m.nlayer = (solid->nnode / plane->nnode - 1) / solid->order;
    for (int i = 0; i < plane->nnode; i++) {
        m.radius = fmax(m.radius, hypot(plane->xyz[3 * i], plane->xyz[3 * i + 1]));
    }
    count_facets(&m, edges);
    TRY(TAKE(m.out.facet, (size_t)m.room));
    TRY(add_sides(&m, edges));
    TRY(add_cap(&m, m.nlayer * solid->order));
    qsort(m.out.facet, (size_t)m.out.count, sizeof *m.out.facet, farthest_first);
    *out = m.out;
    m.out = (segment_surface){0};

done:
    segment_surface_free(&m.out);
    return st;
}

void segment_surface_free(segment_surface *s)
{
    free(s->facet);
    *s = (segment_surface){0};
}

double segment_largest_displacement(const run_result *r, const double *displacement)
{
    double largest = 0;
    for (int i = 0; i < r->segment_mesh.nnode; i++) {
        const double *u = displacement + 3 * i;
        largest = fmax(largest, sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]));
    }
    return largest;
}
