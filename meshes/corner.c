// meshes/corner.c
#include "meshes/corner.h"

#include "meshes/outline.h"

#include <math.h>

#define PI 3.14159265358979323846

enum {
    AROUND = 72,      // directions
    STRAIGHT_GAP = 2, // directions by which a half turn may be missed: an edge bends a little, and
                      // samples are coarse
};

static bool is_half(int n)
{
    return n >= AROUND / 2 - STRAIGHT_GAP && n <= AROUND / 2 + STRAIGHT_GAP;
}

corner corner_at(const section_outline *o, double x, double y, double near)
{
    int material[AROUND], changes = 0, empty = 0;
    for (int i = 0; i < AROUND; i++) {
        // turning with the pattern, and off the common fractions of a turn
        const double a = o->turn + 2 * PI * (i + 0.382) / AROUND;
        const int top = section_top_shape(o, x + near * cos(a), y + near * sin(a));
        material[i] = top >= 0 ? o->items[top].material : -1;
        empty += material[i] < 0;
    }
    int first = 0;
    for (int i = 0; i < AROUND; i++) {
        changes += material[i] != material[(i + 1) % AROUND];
        first += material[i] == material[0];
    }
    if (changes < 2 || (changes == 2 && is_half(first))) {
        return CORNER_NONE;
    }
    if (changes == 2) {
        return empty > AROUND / 2 ? CORNER_WEAK : CORNER_STRONG;
    }
    return changes == 3 && is_half(empty) ? CORNER_WEAK : CORNER_STRONG;
}
