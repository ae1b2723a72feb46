// reports/palette.c
#include "reports/palette.h"

const colour INK = {0.13, 0.15, 0.19, 1};
const colour INK_SOFT = {0.36, 0.40, 0.46, 1};
const colour INK_FAINT = {0.62, 0.66, 0.71, 1};
const colour INK_GRID = {0.90, 0.91, 0.93, 1};
const colour INK_ACCENT = {0.78, 0.22, 0.08, 1};
const colour INK_SECOND = {0.00, 0.36, 0.62, 1};
const colour PAPER = {1, 1, 1, 1};

const colour REACH_YES = {0.00, 0.36, 0.62, 1};
const colour REACH_NO = {0.87, 0.50, 0.10, 1};
const colour REACH_OPEN = {0.72, 0.72, 0.74, 1};
const colour WALL_YES = {0.22, 0.52, 0.74, 1};
const colour WALL_NO = {0.93, 0.70, 0.42, 1};
const colour WALL_OPEN = {0.80, 0.80, 0.82, 1};
const colour NOT_LOOKED_AT = {0.88, 0.82, 0.89, 1};
const colour TISSUE = {0.88, 0.80, 0.72, 1};
const colour TISSUE_PALE = {0.955, 0.945, 0.930, 1};
const colour TISSUE_DEEP = {0.850, 0.820, 0.780, 1};
const colour TISSUE_RIM = {0.62, 0.57, 0.50, 1};

const colour LOAD_FOLLOWER = {0.50, 0.13, 0.52, 1};
const colour NO_MATERIAL = {0.62, 0.68, 0.75, 1};
const colour FLOOR = {0.94, 0.945, 0.955, 1};
const colour SHADOW = {0.72, 0.74, 0.78, 1};
const colour CLOUD_POINT = {0.55, 0.60, 0.66, 0.55};
const colour CLOUD_TUBE = {0.00, 0.36, 0.62, 0.75};
const colour CLOUD_GAP = {0.96, 0.86, 0.80, 1};

colour colour_mix(colour a, colour b, double t)
{
    return (colour){a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b),
                    a.a + t * (b.a - a.a)};
}

colour colour_material(int index)
{
    static const colour inks[PALETTE_SIZE] = {
        {0.75, 0.86, 0.93, 1}, {0.90, 0.58, 0.20, 1}, {0.30, 0.58, 0.53, 1}, {0.97, 0.94, 0.45, 1},
        {0.60, 0.46, 0.90, 1}, {0.94, 0.76, 0.74, 1}, {0.36, 0.41, 0.52, 1}, {0.64, 0.50, 0.34, 1},
    };
    return inks[(unsigned)index % PALETTE_SIZE];
}

colour colour_series(int index)
{
    static const colour inks[PALETTE_SIZE] = {
        {0.00, 0.36, 0.62, 1}, {0.80, 0.30, 0.04, 1}, {0.00, 0.71, 0.57, 1}, {0.60, 0.38, 0.98, 1},
        {0.86, 0.58, 0.00, 1}, {0.15, 0.17, 0.20, 1}, {0.57, 0.65, 0.73, 1}, {0.42, 0.29, 0.23, 1},
    };
    return inks[(unsigned)index % PALETTE_SIZE];
}

colour colour_ramp(double t)
{
    static const colour knots[] = {
        {0.012, 0.213, 0.450, 1}, {0.128, 0.333, 0.487, 1}, {0.226, 0.436, 0.524, 1},
        {0.284, 0.528, 0.553, 1}, {0.382, 0.618, 0.575, 1}, {0.509, 0.699, 0.575, 1},
        {0.629, 0.775, 0.520, 1}, {0.745, 0.864, 0.415, 1}, {0.886, 1.000, 0.271, 1},
    };
    const int last = (int)(sizeof knots / sizeof *knots) - 1;
    const double at = (t > 0 ? (t < 1 ? t : 1) : 0) * last;
    const int i = at < last ? (int)at : last - 1;
    return colour_mix(knots[i], knots[i + 1], at - i);
}
