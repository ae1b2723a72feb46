// reports/segment_surface.c
#include "reports/segment_surface_parts.h"

#include "base/memory.h"
#include "section/fields.h"

#include <math.h>
#include <string.h>

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

// --- points

static double value_of(const surface_maker *m, const double *u, const double *stress)
{
    vec6 s;
    if (m->value == SURFACE_DISPLACEMENT) {
        return sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    }
    memcpy(s.a, stress, sizeof s.a);
    return von_mises(&s);
}

surface_point surface_point_of(const surface_maker *m, const surface_nodes *at, const double *N,
                               int level, int nlevel, const double *M)
{
    double u[3] = {0}, x[3] = {0}, stress[6] = {0};
    const segment_body *b = m->body;
    for (int k = 0; k < nlevel; k++) {
        for (int i = 0; i < at->count; i++) {
            const double w = N[i] * M[k];
            const size_t row = (size_t)(level + k);
            const size_t node = row * (size_t)b->plane.nnode + (size_t)at->node[i];
            for (int d = 0; d < 3; d++) {
                x[d] += w * b->node[3 * node + (size_t)d];
                u[d] += w * m->load->displacement[3 * node + (size_t)d];
            }
            for (int d = 0; m->value == SURFACE_MISES && d < 6; d++) {
                const size_t own = row * (size_t)b->apart.nnode + (size_t)at->apart[i];
                stress[d] += w * m->load->stress[6 * own + (size_t)d];
            }
        }
    }
    const vec3 rest = {{x[0], x[1], x[2]}}, move = {{u[0], u[1], u[2]}};
    return (surface_point){vec3_add_scaled(rest, m->magnify, move), value_of(m, u, stress), rest,
                           move};
}

// corners counter-clockwise as seen from outside
status surface_add_facet(surface_maker *m, int n, const surface_point *const *corner, bool border)
{
    status st = OK;
    if (m->take) {
        return m->take(m, n, corner);
    }
    const vec3 normal = vec3_cross(vec3_sub(corner[n / 2]->at, corner[0]->at),
                                   vec3_sub(corner[n - 1]->at, corner[1]->at));
    const double size = vec3_norm(normal);
    if (size <= 0 || vec3_dot(normal, m->camera->eye) <= 0) {
        return OK;
    }
    if (m->out.count == m->room) {
        const int room = m->room > 0 ? 2 * m->room : 4096;
        facet *more = realloc(m->out.facet, (size_t)room * sizeof *more);
        if (!more) {
            TRY(status_fail(ERR_RESOURCE, "out of memory for the picture of the segment"));
        }
        m->out.facet = more;
        m->room = room;
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

done:
    return st;
}

// --- which of a node's copies belongs to a material

static int by_node(const void *a, const void *b)
{
    const surface_copy *p = a, *q = b;
    return p->node != q->node           ? (p->node > q->node) - (p->node < q->node)
           : p->material != q->material ? (p->material > q->material) - (p->material < q->material)
                                        : (p->apart > q->apart) - (p->apart < q->apart);
}

static status find_copies(surface_maker *m)
{
    status st = OK;
    const mesh *plane = &m->body->plane, *apart = &m->body->apart;
    size_t n = 0;
    for (int b = 0; b < plane->nblock; b++) {
        n += (size_t)plane->block[b].nelem * (size_t)plane->block[b].per_elem;
    }
    TRY(TAKE(m->copy, n));
    for (int b = 0; b < plane->nblock; b++) {
        const mesh_block *k = &plane->block[b];
        for (int i = 0; i < k->nelem * k->per_elem; i++) {
            m->copy[m->ncopy++] =
                (surface_copy){k->conn[i], k->material[i / k->per_elem], apart->block[b].conn[i]};
        }
    }
    qsort(m->copy, (size_t)m->ncopy, sizeof *m->copy, by_node);

done:
    return st;
}

// the first copy of the node with the material; by layers' matter it may have another one: the
// node's only copy then
int surface_copy_of(const surface_maker *m, int node, int material)
{
    int low = 0, high = m->ncopy;
    const surface_copy wanted = {node, material, -1};
    while (low < high) {
        const int mid = (low + high) / 2;
        if (by_node(&m->copy[mid], &wanted) < 0) {
            low = mid + 1;
        } else {
            high = mid;
        }
    }
    const bool there = low < m->ncopy && m->copy[low].node == node;
    return m->ncopy == 0 ? 0 : m->copy[there ? low : low - 1].apart;
}

// --- all of it

static int farthest_first(const void *a, const void *b)
{
    const facet *f = a, *g = b;
    return (f->depth > g->depth) - (f->depth < g->depth);
}

double surface_radius(const segment_body *body)
{
    double radius = 0;
    for (int i = 0; i < body->plane.nnode; i++) {
        radius = fmax(radius, hypot(body->plane.xyz[3 * i], body->plane.xyz[3 * i + 1]));
    }
    return radius;
}

status segment_surface_make(const segment_body *body, const segment_load_result *load,
                            surface_value value, double magnify, const camera *camera,
                            segment_surface *out)
{
    status st = OK;
    const vec3 light = vec3_add(vec3_scale(0.45, camera->up),
                                vec3_add(vec3_scale(-0.45, camera->right), camera->eye));
    surface_maker m = {
        .body = body,
        .load = load,
        .value = value,
        .magnify = magnify,
        .camera = camera,
        .light = vec3_scale(1 / vec3_norm(light), light),
        .wanted_around = 64,
        .wanted_along = 56, // so that the colour changes smoothly
    };

    if (body->nlevel < 2 || body->first != 0 || body->last != body->nlevel || !load->displacement ||
        (value == SURFACE_MISES && !load->stress)) {
        TRY(status_fail(ERR_BUG, "segment_surface: the segment is not all here"));
    }
    m.radius = surface_radius(body);
    TRY(value == SURFACE_MISES ? find_copies(&m) : OK);
    TRY(surface_add_all(&m));
    qsort(m.out.facet, (size_t)m.out.count, sizeof *m.out.facet, farthest_first);
    *out = m.out;
    m.out = (segment_surface){0};

done:
    free(m.copy);
    segment_surface_free(&m.out);
    return st;
}

void segment_surface_free(segment_surface *s)
{
    free(s->facet);
    *s = (segment_surface){0};
}

static const double END_PART = 0.1; // of the length, where stresses are those of the ends

double segment_largest(const segment_body *body, const segment_load_result *load,
                       surface_value value)
{
    double largest = 0;
    const surface_maker m = {.value = value};
    const bool mises = value == SURFACE_MISES;
    const int n = mises ? body->apart.nnode : body->plane.nnode;
    const double from = body->level[0], length = body->level[body->nlevel - 1] - from;
    for (int i = 0; i < (body->last - body->first) * n; i++) {
        const double at = (body->level[body->first + i / n] - from) / length;
        if (!mises || (at >= END_PART && at <= 1 - END_PART)) {
            largest = fmax(largest, value_of(&m, mises ? NULL : load->displacement + 3 * (size_t)i,
                                             mises ? load->stress + 6 * (size_t)i : NULL));
        }
    }
    return largest;
}
