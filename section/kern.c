// section/kern.c
#include "section/kern.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// A corner of the hull that stands out less than this part of the section's size is none: rounding
// of nodes on a straight side.
static const double flat = 1e-9;

typedef struct point {
    double x, y;
} point;

static int by_x(const void *a, const void *b)
{
    const point *p = a, *q = b;
    if (p->x != q->x) {
        return p->x < q->x ? -1 : 1;
    }
    return (p->y > q->y) - (p->y < q->y);
}

// twice the area to the left of a b c
static double turn(point a, point b, point c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// goes once along the sorted points and keeps those with the hull on their left
static int go_along(int n, const point *sorted, int step, double least, int count, point *hull)
{
    const int base = count;
    for (int i = 0; i < n; i++) {
        const point p = sorted[step > 0 ? i : n - 1 - i];
        while (count > base + 1) {
            const point a = hull[count - 2], b = hull[count - 1];
            if (turn(a, b, p) > least * hypot(p.x - a.x, p.y - a.y)) {
                break;
            }
            count--;
        }
        hull[count++] = p;
    }
    return count - 1; // the last begins the way back
}

// Hull of the mesh's nodes, counter-clockwise; hull has room for 2 nnode points.
static status find_hull(const mesh *m, int *count, point *hull)
{
    status st = OK;
    point *sorted = NULL;
    TRY(TAKE(sorted, (size_t)m->nnode));
    for (int i = 0; i < m->nnode; i++) {
        sorted[i] = (point){m->xyz[3 * (size_t)i], m->xyz[3 * (size_t)i + 1]};
    }
    double low = sorted[0].y, high = sorted[0].y;
    for (int i = 1; i < m->nnode; i++) {
        low = fmin(low, sorted[i].y);
        high = fmax(high, sorted[i].y);
    }
    qsort(sorted, (size_t)m->nnode, sizeof *sorted, by_x);
    const double size = hypot(sorted[m->nnode - 1].x - sorted[0].x, high - low);
    *count = go_along(m->nnode, sorted, 1, flat * size, 0, hull);
    *count = go_along(m->nnode, sorted, -1, flat * size, *count, hull);

done:
    free(sorted);
    return st;
}

// (3.24): the place of a force whose neutral line is the hull's side from a to b; false where the
// stiffness centre is not inside of it
static bool kern_corner(const mat3 *B, point a, point b, double *corner)
{
    const double EA = B->a[0][0], x = -B->a[0][2] / EA, y = B->a[0][1] / EA;
    const double xx = B->a[2][2] / EA - x * x; // int E x^2 / EA about the stiffness centre
    const double yy = B->a[1][1] / EA - y * y, xy = -B->a[1][2] / EA - x * y;
    const double nx = b.y - a.y, ny = a.x - b.x;
    const double h = nx * (a.x - x) + ny * (a.y - y);
    corner[0] = x - (xx * nx + xy * ny) / h;
    corner[1] = y - (xy * nx + yy * ny) / h;
    return h > 0;
}

status section_kern(const mesh *m, const beam_law *law, int *count, double (**kern)[2])
{
    status st = OK;
    point *hull = NULL;
    double(*corner)[2] = NULL;
    mat6 F;
    mat3 B;
    int n = 0;
    if (!mat6_inverse_spd(law->K, &F) || !beam_law_axial_bending(&F, &B)) {
        return status_fail(ERR_NUMERIC, "section: its stiffness is not positive definite");
    }
    TRY(TAKE(hull, 2 * (size_t)m->nnode));
    TRY(find_hull(m, &n, hull));
    TRY(TAKE(corner, (size_t)n));
    bool inside = n > 2;
    for (int i = 0; i < n && inside; i++) {
        inside = kern_corner(&B, hull[i], hull[(i + 1) % n], corner[i]);
    }
    *count = inside ? n : 0;
    *kern = corner;
    corner = NULL;

done:
    free(hull);
    free(corner);
    return st;
}
