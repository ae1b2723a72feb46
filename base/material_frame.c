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
