// fem/unknowns_motions.c
// The six rigid motions of a body at what is unknown of it.
#include "fem/unknowns.h"

// (k): translations, then rotations about the base's origin over the radius
static vec3 motion_at(const unknowns *u, int k, vec3 x)
{
    vec3 e = {0};
    e.a[k % 3] = 1;
    return k < 3 ? e : vec3_cross(e, vec3_scale(1 / u->radius, x));
}

static void at_nodes(const unknowns *u, int k, int level, double *to)
{
    for (int i = 0; i < u->nplane; i++) {
        const int block = unknowns_block(u, i, level);
        vec3 x;
        if (block < 0) {
            continue;
        }
        body_node(u->body, i, level, x.a);
        const vec3 v = motion_at(u, k, x);
        for (int d = 0; d < 3; d++) {
            to[3 * (size_t)(block - u->first) + (size_t)d] =
                unknowns_is_held(u, i, level, d) ? 0 : v.a[d];
        }
    }
}

// its rotation is an unknown times the radius
static void at_cap(const unknowns *u, int k, double *to)
{
    const vec3 x = {{u->cap_origin[0], u->cap_origin[1], u->cap_origin[2]}};
    const vec3 v = motion_at(u, k, x);
    double *cap = to + 3 * (size_t)(u->cap_block - u->first);
    for (int d = 0; d < 3; d++) {
        cap[d] = v.a[d];
        cap[3 + d] = k == 3 + d ? 1 : 0;
    }
}

void unknowns_rigid(const unknowns *u, double *motions)
{
    const size_t rows = 3 * (size_t)(u->last - u->first);
    for (int k = 0; k < 6; k++) {
        double *to = motions + (size_t)k * rows;
        for (int level = u->share.first; level < u->share.last; level++) {
            at_nodes(u, k, level, to);
        }
        if (unknowns_has_tip(u) && u->cap) {
            at_cap(u, k, to);
        }
    }
}
