// reach/distance.c
#include "reach/distance.h"

#include "base/memory.h"
#include "reach/distance_grid.h"
#include "reach/embree_door.h"
#include "reach/triangle.h"

#include <math.h>

// A disc about a triangle: no point of it is nearer than the disc's plane, nor than its rim.
typedef struct disc {
    vec3 middle, normal;
    double radius;
} disc;

struct distance_tree {
    const surface *s;
    const embree_door *door;
    box_tree *boxes;
    disc *disc; // [ntriangle] about the triangles
    distance_grid *grid;
    vec3 *face;   // [ntriangle] unit normals, outward; zero without area
    vec3 *vertex; // [nvertex] angle-weighted
};

static void triangle_box(const void *context, int i, double low[3], double high[3])
{
    const surface *s = context;
    for (int d = 0; d < 3; d++) {
        const double a = s->vertex[s->triangle[i][0]][d], b = s->vertex[s->triangle[i][1]][d],
                     c = s->vertex[s->triangle[i][2]][d];
        low[d] = fmin(a, fmin(b, c));
        high[d] = fmax(a, fmax(b, c));
    }
}

// Wider by what rounding may take from a sum of a few numbers; squares of lengths by more than it
// may take from their differences.
static const double disc_margin = 1 + 1e-12, disc_slip = 1e-12;

static void fill_discs(distance_tree *t)
{
    for (int i = 0; i < t->s->ntriangle; i++) {
        disc *b = &t->disc[i];
        vec3 c[3];
        surface_corners(t->s, i, c);
        b->middle = vec3_scale(1.0 / 3, vec3_add(vec3_add(c[0], c[1]), c[2]));
        b->normal = t->face[i];
        for (int k = 0; k < 3; k++) {
            b->radius = fmax(b->radius, vec3_norm(vec3_sub(c[k], b->middle)));
        }
        b->radius *= disc_margin;
    }
}

// whether nothing of the triangle is within the radius
static bool is_beyond(const disc *d, vec3 p, double radius)
{
    const vec3 to = vec3_sub(p, d->middle);
    const double square = vec3_dot(to, to), off = vec3_dot(to, d->normal);
    const double aside = sqrt(fmax(square - off * off, 0)) - d->radius;
    return off * off + (aside > 0 ? aside * aside : 0) > radius * radius + disc_slip * square;
}

static void fill_normals(distance_tree *t)
{
    for (int i = 0; i < t->s->ntriangle; i++) {
        vec3 corner[3];
        surface_corners(t->s, i, corner);
        const vec3 n = triangle_normal(corner);
        const double length = vec3_norm(n);
        t->face[i] = length > 0 ? vec3_scale(1 / length, n) : n;
        for (int k = 0; k < 3; k++) {
            vec3 *sum = &t->vertex[t->s->triangle[i][k]];
            *sum = vec3_add_scaled(*sum, triangle_angle(corner, k), t->face[i]);
        }
    }
}

static nearest_point search_tree(const distance_tree *t, vec3 p, double radius);

static nearest_point node_distance(const void *context, vec3 p)
{
    return search_tree(context, p, INFINITY);
}

status distance_tree_make(const surface *s, distance_tree **out)
{
    status st = OK;
    distance_tree *t = NULL;
    TRY(TAKE(t, 1));
    t->s = s;
    TRY(embree_door_open(&t->door));
    TRY(TAKE(t->face, (size_t)s->ntriangle));
    TRY(TAKE(t->vertex, (size_t)s->nvertex));
    TRY(TAKE(t->disc, (size_t)s->ntriangle));
    fill_normals(t);
    fill_discs(t);
    TRY(t->door->make(s->ntriangle, triangle_box, s, &t->boxes));
    TRY(distance_grid_make(s, node_distance, t, &t->grid));
    *out = t;
    t = NULL;

done:
    distance_tree_free(t);
    return st;
}

void distance_tree_free(distance_tree *t)
{
    if (t) {
        if (t->door) {
            t->door->free(t->boxes);
        }
        distance_grid_free(t->grid);
        free(t->disc);
        free(t->face);
        free(t->vertex);
        free(t);
    }
}

typedef struct search {
    const distance_tree *t;
    vec3 p;
    double radius; // the least distance so far, or what it must be below
    vec3 nearest;
    int triangle, place;
} search;

static double look(void *context, int i)
{
    search *s = context;
    vec3 corner[3];
    int place = 0;
    if (is_beyond(&s->t->disc[i], s->p, s->radius)) {
        return s->radius;
    }
    surface_corners(s->t->s, i, corner);
    const vec3 q = triangle_nearest(corner, s->p, &place);
    const double distance = vec3_norm(vec3_sub(s->p, q));
    if (distance < s->radius || (s->triangle < 0 && distance <= s->radius)) {
        s->radius = distance;
        s->nearest = q;
        s->triangle = i;
        s->place = place;
    }
    return s->radius;
}

// the normal that tells the sides where the nearest point is
static vec3 side_normal(const search *s)
{
    const surface *wall = s->t->s;
    const int t = s->triangle;
    if (s->place >= ON_CORNER) {
        return s->t->vertex[wall->triangle[t][s->place - ON_CORNER]];
    }
    if (s->place >= ON_EDGE) {
        return vec3_add(s->t->face[t], s->t->face[wall->across[t][s->place - ON_EDGE] / 3]);
    }
    return s->t->face[t];
}

static nearest_point answer(const search *s)
{
    nearest_point out = {.distance = NAN, .triangle = s->triangle, .p = s->nearest};
    if (s->triangle >= 0) {
        const double side = vec3_dot(vec3_sub(s->p, s->nearest), side_normal(s));
        out.distance = side > 0 ? -s->radius : s->radius;
    }
    return out;
}

static nearest_point search_tree(const distance_tree *t, vec3 p, double radius)
{
    search s = {.t = t, .p = p, .radius = radius, .triangle = -1};
    t->door->near(t->boxes, p.a, radius, look, &s);
    return answer(&s);
}

distance_range distance_between(const distance_tree *t, vec3 p)
{
    return distance_grid_nearest(t->grid, p);
}

distance_range distance_between_closely(const distance_tree *t, vec3 p)
{
    return distance_grid_eight(t->grid, p);
}

nearest_point distance_within(const distance_tree *t, vec3 p, double radius)
{
    const double reach = distance_between(t, p).reach;
    const nearest_point out = search_tree(t, p, fmin(radius, reach));
    // rounding may have put it just beyond
    return out.triangle < 0 && reach < radius ? search_tree(t, p, radius) : out;
}

nearest_point distance_to(const distance_tree *t, vec3 p)
{
    return distance_within(t, p, INFINITY);
}
