// reach/triangle.c
#include "reach/triangle.h"

#include <math.h>

vec3 triangle_normal(const vec3 corner[3])
{
    return vec3_cross(vec3_sub(corner[1], corner[0]), vec3_sub(corner[2], corner[0]));
}

double triangle_angle(const vec3 corner[3], int k)
{
    const vec3 u = vec3_sub(corner[(k + 1) % 3], corner[k]);
    const vec3 v = vec3_sub(corner[(k + 2) % 3], corner[k]);
    return atan2(vec3_norm(vec3_cross(u, v)), vec3_dot(u, v));
}

// Van Oosterom and Strackee
double triangle_solid_angle(const vec3 corner[3], vec3 p)
{
    const vec3 a = vec3_sub(corner[0], p), b = vec3_sub(corner[1], p), c = vec3_sub(corner[2], p);
    const double la = vec3_norm(a), lb = vec3_norm(b), lc = vec3_norm(c);
    return 2 * atan2(vec3_dot(a, vec3_cross(b, c)), la * lb * lc + vec3_dot(a, b) * lc +
                                                        vec3_dot(b, c) * la + vec3_dot(c, a) * lb);
}

// the nearest point of the edge from corner k on
static vec3 edge_nearest(const vec3 corner[3], int k, vec3 p, int *place)
{
    const vec3 a = corner[k], b = corner[(k + 1) % 3];
    const vec3 e = vec3_sub(b, a);
    const double along = vec3_dot(vec3_sub(p, a), e), whole = vec3_dot(e, e);
    if (along <= 0) {
        *place = ON_CORNER + k;
        return a;
    }
    if (along >= whole) {
        *place = ON_CORNER + (k + 1) % 3;
        return b;
    }
    *place = ON_EDGE + k;
    return vec3_add_scaled(a, along / whole, e);
}

vec3 triangle_nearest(const vec3 corner[3], vec3 p, int *place)
{
    const vec3 n = triangle_normal(corner);
    const double square = vec3_dot(n, n);
    double least = INFINITY;
    vec3 nearest = corner[0];
    *place = ON_CORNER;
    for (int k = 0; k < 3; k++) {
        const vec3 e = vec3_sub(corner[(k + 1) % 3], corner[k]);
        const vec3 to = vec3_sub(p, corner[k]);
        // only an edge that p lies beyond can have the nearest point
        if (vec3_dot(vec3_cross(e, to), n) > 0 && square > 0) {
            continue;
        }
        int on = 0;
        const vec3 q = edge_nearest(corner, k, p, &on);
        const vec3 gap = vec3_sub(p, q);
        if (vec3_dot(gap, gap) < least) {
            least = vec3_dot(gap, gap);
            nearest = q;
            *place = on;
        }
    }
    if (least < INFINITY) {
        return nearest;
    }
    *place = ON_FACE;
    return vec3_add_scaled(p, -vec3_dot(vec3_sub(p, corner[0]), n) / square, n);
}

// whether the plane across `axis` parts them
static bool axis_parts(vec3 axis, int np, const vec3 *p, int nq, const vec3 *q, double gap)
{
    const double length = vec3_norm(axis);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    // seen from p[0]: near to one another, so little is lost by cancelling
    for (int i = 0; i < np; i++) {
        const double x = vec3_dot(axis, vec3_sub(p[i], p[0]));
        low[0] = fmin(low[0], x);
        high[0] = fmax(high[0], x);
    }
    for (int i = 0; i < nq; i++) {
        const double x = vec3_dot(axis, vec3_sub(q[i], p[0]));
        low[1] = fmin(low[1], x);
        high[1] = fmax(high[1], x);
    }
    return length > 0 && fmax(low[0] - high[1], low[1] - high[0]) > gap * length;
}

static vec3 edge_of(int n, const vec3 *p, int k)
{
    return vec3_sub(p[(k + 1) % n], p[k]);
}

// Two flat convex pieces are apart where one of few planes parts them: theirs, those along an edge
// of each, and for pieces in one plane those across it through an edge.
bool triangles_apart(int np, const vec3 *p, int nq, const vec3 *q, double gap)
{
    const int ep = np == 3 ? 3 : 1, eq = nq == 3 ? 3 : 1;
    vec3 normal[2];
    int nnormal = 0;
    if (np == 3) {
        normal[nnormal++] = triangle_normal(p);
    }
    if (nq == 3) {
        normal[nnormal++] = triangle_normal(q);
    }
    for (int m = 0; m < nnormal; m++) {
        if (axis_parts(normal[m], np, p, nq, q, gap)) {
            return true;
        }
    }
    for (int i = 0; i < ep; i++) {
        for (int j = 0; j < eq; j++) {
            if (axis_parts(vec3_cross(edge_of(np, p, i), edge_of(nq, q, j)), np, p, nq, q, gap)) {
                return true;
            }
        }
    }
    for (int m = 0; m < nnormal; m++) {
        for (int i = 0; i < ep + eq; i++) {
            const vec3 e = i < ep ? edge_of(np, p, i) : edge_of(nq, q, i - ep);
            if (axis_parts(vec3_cross(normal[m], e), np, p, nq, q, gap)) {
                return true;
            }
        }
    }
    return false;
}
