// reach/surface_cross.c
// Two triangles may meet only at what they share: an edge, a corner, or nothing.
#include "reach/surface_inside.h"

#include "base/input_file.h"
#include "reach/embree_door.h"
#include "reach/triangle.h"

#include <math.h>
#include <stdint.h>

// of the diagonal: nearer than this they touch; some thousand times what rounding does
static const double TOUCH = 1e-12;
// looks at pairs per triangle and in all: far beyond any surface that is not made to take for ever
enum { MOST_EACH = 300, MOST_ALWAYS = 50 * 1000 * 1000 };

typedef struct crossing {
    const surface *s;
    double gap;
    int t;
    vec3 corner[3];
    double low[3], high[3], radius; // round t
    int64_t looks, most;
    int count, where; // pairs that cross; a triangle of one
} crossing;

static void box_of(const void *context, int t, double low[3], double high[3])
{
    const surface *s = context;
    for (int d = 0; d < 3; d++) {
        const double a = s->vertex[s->triangle[t][0]][d], b = s->vertex[s->triangle[t][1]][d],
                     c = s->vertex[s->triangle[t][2]][d];
        low[d] = fmin(a, fmin(b, c));
        high[d] = fmax(a, fmax(b, c));
    }
}

static bool boxes_meet(const crossing *c, int u)
{
    double low[3], high[3];
    box_of(c->s, u, low, high);
    for (int d = 0; d < 3; d++) {
        if (low[d] > c->high[d] + c->gap || high[d] < c->low[d] - c->gap) {
            return false;
        }
    }
    return true;
}

// how many corners they share; *i, *j: one of those of each
static int shared(const int *t, const int *u, int *i, int *j)
{
    int n = 0;
    for (int k = 0; k < 9; k++) {
        if (t[k / 3] == u[k % 3]) {
            n++;
            *i = k / 3;
            *j = k % 3;
        }
    }
    return n;
}

// two triangles at an edge lie on one another: in one plane, turned over
static bool is_folded(const vec3 *p, const vec3 *q, double gap)
{
    const vec3 n = triangle_normal(p), m = triangle_normal(q);
    const double ln = vec3_norm(n), lm = vec3_norm(m);
    double off = 0;
    for (int k = 0; k < 3; k++) {
        off = fmax(off, fabs(vec3_dot(n, vec3_sub(q[k], p[0]))) / ln);
        off = fmax(off, fabs(vec3_dot(m, vec3_sub(p[k], q[0]))) / lm);
    }
    return vec3_dot(n, m) < 0 && off <= gap;
}

static bool cross_each_other(const crossing *c, int u)
{
    vec3 q[3];
    int i = 0, j = 0;
    surface_corners(c->s, u, q);
    const int n = shared(c->s->triangle[c->t], c->s->triangle[u], &i, &j);
    if (n == 0) {
        return !triangles_apart(3, c->corner, 3, q, c->gap);
    }
    if (n == 1) {
        const vec3 beyond_t[2] = {c->corner[(i + 1) % 3], c->corner[(i + 2) % 3]};
        const vec3 beyond_u[2] = {q[(j + 1) % 3], q[(j + 2) % 3]};
        return !triangles_apart(2, beyond_t, 3, q, c->gap) ||
               !triangles_apart(2, beyond_u, 3, c->corner, c->gap);
    }
    return n == 3 || is_folded(c->corner, q, c->gap);
}

static double look(void *context, int u)
{
    crossing *c = context;
    c->looks++;
    if (u > c->t && boxes_meet(c, u) && cross_each_other(c, u)) {
        c->count++;
        c->where = c->t;
    }
    return c->looks > c->most ? -1 : c->radius;
}

// the ball round t's box
static void set_triangle(crossing *c, int t, double middle[3])
{
    double square = 0;
    c->t = t;
    surface_corners(c->s, t, c->corner);
    box_of(c->s, t, c->low, c->high);
    for (int d = 0; d < 3; d++) {
        const double half = 0.5 * (c->high[d] - c->low[d]);
        middle[d] = c->low[d] + half;
        square += half * half;
    }
    c->radius = sqrt(square) + 2 * c->gap;
}

status surface_check_crossings(surface_work *w)
{
    status st = OK;
    const embree_door *door = NULL;
    box_tree *boxes = NULL;
    const surface *s = &w->s;
    crossing c = {.s = s, .gap = TOUCH * w->diagonal};
    c.most = MOST_ALWAYS + (int64_t)MOST_EACH * s->ntriangle;
    TRY(embree_door_open(&door));
    TRY(door->make(s->ntriangle, box_of, s, &boxes));
    for (int t = 0; t < s->ntriangle && c.looks <= c.most; t++) {
        double middle[3];
        set_triangle(&c, t, middle);
        door->near(boxes, middle, c.radius, look, &c);
    }
    if (c.count > 0) {
        TRY(surface_fail(w, s->vertex[s->triangle[c.where][0]],
                         "%d pairs of its triangles cross or touch", c.count));
    }
    if (c.looks > c.most) {
        const input_file file = {.path = (char *)w->options->path};
        TRY(input_file_fail(&file, 0,
                            "its triangles lie too much among one another to be checked"));
    }

done:
    if (door) {
        door->free(boxes);
    }
    return st;
}
