#include "meshes/pixel_smooth.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// A corner whose two straight sides are at least as long is meant, not a stair [pixels].
enum { MEANT_SIDE = 5, ROUNDS = 600 };

// Smoothing without shrinking (Taubin): a step towards the neighbours' mean, a slightly larger one
// away from it. Waves longer than some 40 pixels stay.
static const double towards = 0.5, away = -0.503;
// The true boundary passes between the centres of the pixels on its two sides.
static const double most_shift = 0.5;
// Least part of its area that a corner of a pixel keeps.
static const double least_corner = 0.1;

typedef struct joint {
    int at;        // point
    int beside[2]; // points before and after it on the boundary
} joint;

typedef struct boundary {
    const pixel_image *image;
    int njoint;
    joint *joint; // the points that may move
    double *shift;
} boundary;

static const int step[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

// whether the pixel's side that leaves a point in direction k is part of a boundary
static bool is_side(const pixel_image *p, int i, int j, int k)
{
    switch (k) {
    case 0:
        return pixel_at(p, i, j) != pixel_at(p, i, j - 1);
    case 1:
        return pixel_at(p, i, j) != pixel_at(p, i - 1, j);
    case 2:
        return pixel_at(p, i - 1, j) != pixel_at(p, i - 1, j - 1);
    default:
        return pixel_at(p, i, j - 1) != pixel_at(p, i - 1, j - 1);
    }
}

// whether the boundary runs straight for MEANT_SIDE pixels from a point in direction k
static bool runs_straight(const pixel_image *p, int i, int j, int k)
{
    for (int n = 0; n < MEANT_SIDE; n++) {
        const int a = i + n * step[k][0], b = j + n * step[k][1];
        const bool turns =
            n > 0 && (is_side(p, a, b, (k + 1) % 4) || is_side(p, a, b, (k + 3) % 4));
        if (turns || !is_side(p, a, b, k)) {
            return false;
        }
    }
    return true;
}

// points where the boundary goes on to two sides; junctions and corners that are meant stay
static bool joint_at(const pixel_image *p, int i, int j, joint *out)
{
    int count = 0, way[4] = {0};
    for (int k = 0; k < 4; k++) {
        if (is_side(p, i, j, k)) {
            way[count++] = k;
        }
    }
    if (count != 2) {
        return false;
    }
    const bool bends = way[1] - way[0] != 2;
    if (bends && runs_straight(p, i, j, way[0]) && runs_straight(p, i, j, way[1])) {
        return false;
    }
    const int width = p->n[0] + 1;
    out->at = j * width + i;
    for (int k = 0; k < 2; k++) {
        out->beside[k] = (j + step[way[k]][1]) * width + i + step[way[k]][0];
    }
    return true;
}

static status find_joints(boundary *b)
{
    status st = OK;
    joint one;
    const int *n = b->image->n;
    for (int pass = 0; pass < 2; pass++) {
        b->njoint = 0;
        for (int j = 0; j <= n[1]; j++) {
            for (int i = 0; i <= n[0]; i++) {
                if (joint_at(b->image, i, j, &one)) {
                    if (pass == 1) {
                        b->joint[b->njoint] = one;
                    }
                    b->njoint++;
                }
            }
        }
        if (pass == 0) {
            TRY(TAKE(b->joint, (size_t)b->njoint));
        }
    }

done:
    return st;
}

// one step of all joints at once: `part` of the way to the mean of the two beside; new: scratch
static void relax(const boundary *b, double part, double (*new)[2])
{
    const int width = b->image->n[0] + 1;
    for (int k = 0; k < b->njoint; k++) {
        const joint *q = &b->joint[k];
        const int place[2] = {q->at % width, q->at / width};
        for (int d = 0; d < 2; d++) {
            double mean = 0;
            for (int e = 0; e < 2; e++) {
                const int at = q->beside[e];
                const int there = d == 0 ? at % width : at / width;
                mean += (there - place[d] + b->shift[2 * (long)at + d]) / 2;
            }
            const double old = b->shift[2 * (long)q->at + d];
            new[k][d] = fmin(fmax(old + part * (mean - old), -most_shift), most_shift);
        }
    }
    for (int k = 0; k < b->njoint; k++) {
        memcpy(b->shift + 2 * (long)b->joint[k].at, new[k], sizeof new[k]);
    }
}

// --- no pixel turns over

// the least area that two sides of a moved pixel span, a whole pixel's being 1
static double least_area(const double *shift[4])
{
    static const int corner[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    double xy[4][2], least = INFINITY;
    for (int k = 0; k < 4; k++) {
        xy[k][0] = corner[k][0] + shift[k][0];
        xy[k][1] = corner[k][1] + shift[k][1];
    }
    for (int k = 0; k < 4; k++) {
        const double *o = xy[k], *a = xy[(k + 1) % 4], *c = xy[(k + 3) % 4];
        least = fmin(least, (a[0] - o[0]) * (c[1] - o[1]) - (a[1] - o[1]) * (c[0] - o[0]));
    }
    return least;
}

// halves the shifts around pixels that are bent too far; false where there was none
static bool bend_back(const pixel_image *p, double *shift)
{
    bool any = false;
    for (int j = 0; j < p->n[1]; j++) {
        for (int i = 0; i < p->n[0]; i++) {
            double *low = shift + 2 * ((long)j * (p->n[0] + 1) + i),
                   *high = low + 2 * (p->n[0] + 1);
            double *around[4] = {low, low + 2, high + 2, high};
            if (pixel_at(p, i, j) == PIXEL_NONE ||
                least_area((const double **)around) >= least_corner) {
                continue;
            }
            any = true;
            for (int k = 0; k < 4; k++) {
                around[k][0] /= 2;
                around[k][1] /= 2;
            }
        }
    }
    return any;
}

status pixel_smooth(const pixel_image *p, double **shift)
{
    status st = OK;
    boundary b = {.image = p};
    double(*new)[2] = NULL;

    TRY(TAKE(b.shift, 2 * ((size_t)p->n[0] + 1) * ((size_t)p->n[1] + 1)));
    TRY(find_joints(&b));
    TRY(TAKE(new, (size_t)b.njoint));
    for (int i = 0; i < ROUNDS; i++) {
        relax(&b, towards, new);
        relax(&b, away, new);
    }
    while (bend_back(p, b.shift)) {
    }
    *shift = b.shift;
    b.shift = NULL;

done:
    free(b.joint);
    free(b.shift);
    free(new);
    return st;
}
