// base/material_frame.c
#include "base/material_frame.h"

#include <math.h>

material_frame material_frame_make(double plane_angle, double fibre_angle)
{
    const double c = cos(plane_angle), s = sin(plane_angle);
    const double cf = cos(fibre_angle), sf = sin(fibre_angle);
    // 1 = z, 2 = (c, s, 0), 3 = (-s, c, 0); then 1' = cf 1 + sf 2, 2' = -sf 1 + cf 2
    return (material_frame){.axes = {{
                                {sf * c, sf * s, cf},
                                {cf * c, cf * s, -sf},
                                {-s, c, 0},
                            }}};
}

mat3 material_frame_axes_at(const material_frame *f, double x, double y)
{
    if (!f->polar) {
        return f->axes;
    }
    const double dx = x - f->centre[0], dy = y - f->centre[1], r = hypot(dx, dy);
    const double c = r > 0 ? dx / r : 1, s = r > 0 ? dy / r : 0;
    mat3 axes;
    for (int i = 0; i < 3; i++) {
        const double *a = f->axes.a[i]; // along x' = (-s, c), y' = (-c, -s) and z
        axes.a[i][0] = -s * a[0] - c * a[1];
        axes.a[i][1] = c * a[0] - s * a[1];
        axes.a[i][2] = a[2];
    }
    return axes;
}

mat6 material_frame_strain_map(mat3 axes)
{
    static const int pair[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    mat6 T;
    for (int row = 0; row < 6; row++) {
        const double *p = axes.a[pair[row][0]], *q = axes.a[pair[row][1]];
        const double engineering = row < 3 ? 1 : 2; // gamma = 2 eps
        for (int k = 0; k < 6; k++) {
            const int i = pair[k][0], j = pair[k][1];
            T.a[row][k] = engineering * (p[i] * q[j] + p[j] * q[i]) / 2;
        }
    }
    return T;
}

static void turn_pair(double *x, double c, double s)
{
    const double a = x[0], b = x[1];
    x[0] = c * a - s * b;
    x[1] = s * a + c * b;
}

void material_frame_move(material_frame *f, double scale, double angle)
{
    const double c = cos(angle), s = sin(angle);
    turn_pair(f->centre, scale * c, scale * s);
    // a polar frame's axes are told from the circle, which turns with the section
    for (int i = 0; i < 3 && !f->polar; i++) {
        turn_pair(f->axes.a[i], c, s);
    }
}

bool material_frame_is(const material_frame *a, const material_frame *b, double gap, double size)
{
    if (a->polar != b->polar) {
        return false;
    }
    for (int i = 0; i < 9; i++) {
        if (fabs(a->axes.a[i / 3][i % 3] - b->axes.a[i / 3][i % 3]) > gap) {
            return false;
        }
    }
    const double away = hypot(a->centre[0] - b->centre[0], a->centre[1] - b->centre[1]);
    return !a->polar || away <= gap * size;
}
