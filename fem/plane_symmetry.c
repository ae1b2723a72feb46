// fem/plane_symmetry.c
#include "fem/plane_symmetry.h"

#include "base/memory.h"

#include <math.h>

// Nodes meet their images to this part of the section's radius: meshes are symmetric to rounding or
// not at all
static const double NODES_MEET = 1e-9;

void plane_symmetry_free(plane_symmetry *s)
{
    for (int k = 0; k < PLANE_SYMMETRIES; k++) {
        free(s->partner[k]);
    }
    *s = (plane_symmetry){0};
}

// nodes by their distance from the centre
typedef struct ring_node {
    double radius, x, y; // from the centre
    int node;
} ring_node;

typedef struct rings {
    int count;
    double tolerance;
    ring_node *at; // [count] ascending
} rings;

static int by_radius(const void *a, const void *b)
{
    const double r = ((const ring_node *)a)->radius, s = ((const ring_node *)b)->radius;
    return (r > s) - (r < s);
}

static status rings_make(const mesh *plane, const double *centre, rings *out)
{
    status st = OK;
    TRY(TAKE(out->at, (size_t)plane->nnode));
    out->count = plane->nnode;
    for (int i = 0; i < plane->nnode; i++) {
        const double *p = plane->xyz + 3 * (size_t)i;
        const double x = p[0] - centre[0], y = p[1] - centre[1];
        out->at[i] = (ring_node){hypot(x, y), x, y, i};
    }
    qsort(out->at, (size_t)out->count, sizeof *out->at, by_radius);
    out->tolerance = NODES_MEET * out->at[out->count - 1].radius;

done:
    return st;
}

static int first_at(const rings *r, double radius)
{
    int low = 0, high = r->count;
    while (low < high) {
        const int mid = low + (high - low) / 2;
        if (r->at[mid].radius < radius) {
            low = mid + 1;
        } else {
            high = mid;
        }
    }
    return low;
}

// -1: no node there
static int node_at(const rings *r, double x, double y)
{
    const double radius = hypot(x, y), tolerance = r->tolerance;
    for (int k = first_at(r, radius - tolerance);
         k < r->count && r->at[k].radius <= radius + tolerance; k++) {
        if (fabs(r->at[k].x - x) <= tolerance && fabs(r->at[k].y - y) <= tolerance) {
            return r->at[k].node;
        }
    }
    return -1;
}

// images under a 2x2 matrix of order two; *out stays NULL where a node has none
static status find_images(const rings *r, double xx, double xy, double yy, int **out)
{
    status st = OK;
    int *image = NULL;
    TRY(TAKE(image, (size_t)r->count));
    for (int k = 0; k < r->count; k++) {
        const ring_node *n = r->at + k;
        const int to = node_at(r, xx * n->x + xy * n->y, xy * n->x + yy * n->y);
        if (to < 0) {
            goto done;
        }
        image[n->node] = to;
    }
    *out = image;
    image = NULL;

done:
    free(image);
    return st;
}

static status find_mirror(const rings *r, double angle, int **out)
{
    const double c = cos(2 * angle), s = sin(2 * angle);
    return find_images(r, c, s, -c, out);
}

// the axes themselves where they are meant: then directions need no turning
static double snapped(double angle)
{
    const double right = acos(0.0), turns = round(angle / right);
    return fabs(angle - turns * right) < 1e-9 ? turns * right : angle;
}

// A mirror line halves the angle between the farthest node and its image, which is as far
static status find_lines(const rings *r, plane_symmetry *s)
{
    status st = OK;
    const ring_node *far = r->at + r->count - 1;
    const double turn = atan2(far->y, far->x), right = acos(0.0);
    for (int k = first_at(r, far->radius - r->tolerance); k < r->count; k++) {
        const double middle = (turn + atan2(r->at[k].y, r->at[k].x)) / 2;
        for (int j = 0; j < 2; j++) {
            const double angle = snapped(remainder(middle + j * right, 2 * right));
            TRY(find_mirror(r, angle, &s->partner[MIRROR_A]));
            if (s->partner[MIRROR_A]) {
                s->angle = angle;
                TRY(find_mirror(r, angle + right, &s->partner[MIRROR_B]));
                return OK;
            }
        }
    }

done:
    return st;
}

status plane_symmetry_find(const mesh *plane, bool about_origin, plane_symmetry *out)
{
    status st = OK;
    plane_symmetry s = {0};
    rings r = {0};
    double size = 0;
    for (int i = 0; i < plane->nnode && !about_origin; i++) {
        s.centre[0] += plane->xyz[3 * (size_t)i] / plane->nnode;
        s.centre[1] += plane->xyz[3 * (size_t)i + 1] / plane->nnode;
        size = fmax(size, hypot(plane->xyz[3 * (size_t)i], plane->xyz[3 * (size_t)i + 1]));
    }
    for (int i = 0; i < 2; i++) {
        s.centre[i] = fabs(s.centre[i]) > 1e-3 * NODES_MEET * size ? s.centre[i] : 0;
    }
    TRY(rings_make(plane, s.centre, &r));
    TRY(find_lines(&r, &s));
    TRY(find_images(&r, -1, 0, -1, &s.partner[HALF_TURN]));
    *out = s;
    s = (plane_symmetry){0};

done:
    free(r.at);
    plane_symmetry_free(&s);
    return st;
}
