// fem/mesh_axes.c
#include "fem/mesh_axes.h"

double mesh_angle(const mesh *plane, const double *xyz, mat3 axes, const double origin[3])
{
    double along = 0, across = 0;
    for (int i = 0; i < plane->nnode; i++) {
        const double *from = plane->xyz + 3 * (size_t)i, *to = xyz + 3 * (size_t)i;
        const vec3 r = {{to[0] - origin[0], to[1] - origin[1], to[2] - origin[2]}};
        const vec3 x = mat3_tmul_vec(axes, r);
        along += from[0] * x.a[0] + from[1] * x.a[1];
        across += from[0] * x.a[1] - from[1] * x.a[0];
    }
    return atan2(across, along);
}

mat3 mesh_axes(const body *b, int level)
{
    double origin[3];
    if (b->prism) {
        return mat3_identity();
    }
    const mat3 axes = body_axes(b, level);
    const double *xyz = b->node + 3 * (size_t)(level - b->first) * (size_t)b->plane->nnode;
    body_origin(b, level, origin);
    return mat3_mul(axes, mat3_rot_z(mesh_angle(b->plane, xyz, axes, origin)));
}
