#include "meshes/pixel_chain.h"

#include "base/memory.h"

// A corner whose two straight sides are at least as long is meant, not a stair [pixels].
enum { MEANT_SIDE = 5 };

// What a corner of pixels is to the boundaries.
enum { OFF, HELD, FREE, DONE };

static const int step[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

void pixel_chains_free(pixel_chains *c)
{
    free(c->chain);
    free(c->points);
    *c = (pixel_chains){0};
}

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

// a point is free where the boundary goes on to two sides and the corner is not meant
static int kind_of_point(const pixel_image *p, int i, int j)
{
    int count = 0, way[4] = {0};
    for (int k = 0; k < 4; k++) {
        if (is_side(p, i, j, k)) {
            way[count++] = k;
        }
    }
    const bool bends = count == 2 && way[1] - way[0] != 2;
    if (bends && runs_straight(p, i, j, way[0]) && runs_straight(p, i, j, way[1])) {
        return HELD;
    }
    return count == 0 ? OFF : count == 2 ? FREE : HELD;
}

typedef struct tracer {
    const pixel_image *image;
    unsigned char *kind; // of every point
    pixel_chains out;
    int npoint;
} tracer;

static void add_point(tracer *t, int point)
{
    t->out.points[t->npoint++] = point;
    t->out.chain[t->out.count].count++;
}

// Follows the boundary that leaves a point in direction k, to a held point or around to where it
// began.
static void follow(tracer *t, int i, int j, int k)
{
    const int width = t->image->n[0] + 1, begin = j * width + i;
    t->out.chain[t->out.count] = (pixel_chain){.point = t->out.points + t->npoint};
    add_point(t, begin);
    for (;;) {
        i += step[k][0];
        j += step[k][1];
        const int at = j * width + i;
        if (at == begin && t->kind[at] != HELD) {
            t->out.chain[t->out.count].closed = true;
            break;
        }
        add_point(t, at);
        if (t->kind[at] == HELD) {
            break;
        }
        t->kind[at] = DONE;
        const int back = (k + 2) % 4;
        for (int next = 0; next < 4; next++) {
            if (next != back && is_side(t->image, i, j, next)) {
                k = next;
                break;
            }
        }
    }
    t->out.count++;
}

// chains that leave points of this kind
static void follow_from(tracer *t, int kind)
{
    const int *n = t->image->n, width = n[0] + 1;
    for (int j = 0; j <= n[1]; j++) {
        for (int i = 0; i <= n[0]; i++) {
            for (int k = 0; k < 4; k++) {
                const int a = i + step[k][0], b = j + step[k][1];
                if (t->kind[j * width + i] == kind && is_side(t->image, i, j, k) &&
                    t->kind[b * width + a] == FREE) {
                    t->kind[j * width + i] = (unsigned char)(kind == FREE ? DONE : HELD);
                    follow(t, i, j, k);
                }
            }
        }
    }
}

status pixel_chains_make(const pixel_image *p, pixel_chains *out)
{
    status st = OK;
    tracer t = {.image = p};
    const size_t width = (size_t)p->n[0] + 1, height = (size_t)p->n[1] + 1;
    size_t nfree = 0;

    TRY(TAKE(t.kind, width * height));
    for (size_t at = 0; at < width * height; at++) {
        const int i = (int)(at % width), j = (int)(at / width);
        t.kind[at] = (unsigned char)kind_of_point(p, i, j);
        nfree += t.kind[at] == FREE;
    }
    // every chain has a free point, and two held ones at most
    TRY(TAKE(t.out.points, 3 * nfree));
    TRY(TAKE(t.out.chain, nfree));
    follow_from(&t, HELD);
    follow_from(&t, FREE);
    *out = t.out;
    t.out = (pixel_chains){0};

done:
    free(t.kind);
    pixel_chains_free(&t.out);
    return st;
}
