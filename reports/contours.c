// reports/contours.c
#include "reports/contours.h"

#include "base/memory.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

// a crossing lies between raster point k and the next one in x (id k) or in y (id n + k)
typedef struct tracer {
    const raster *r;
    double level;
    int n;
    int *next;         // [2 n] the crossing that follows; -1: none
    double (*loop)[2]; // [2 n] of the loop that is traced
    bool *keep;        // [2 n] its points that stay
    int *stack;        // [2 n]
} tracer;

void contours_free(contours *c)
{
    free(c->start);
    free(c->at);
    *c = (contours){0};
}

static bool above(const tracer *t, int i, int j)
{
    return i > 0 && j > 0 && i < t->r->nx - 1 && j < t->r->ny - 1 &&
           t->r->value[i + t->r->nx * j] >= t->level;
}

// --- which crossing follows which: what is above lies on the left

static int along_x(const tracer *t, int i, int j)
{
    return i + t->r->nx * j;
}

static int along_y(const tracer *t, int i, int j)
{
    return t->n + i + t->r->nx * j;
}

static bool middle_above(const tracer *t, int i, int j)
{
    const double *v = t->r->value + i + t->r->nx * j;
    return (v[0] + v[1] + v[t->r->nx] + v[t->r->nx + 1]) / 4 >= t->level;
}

static void link_cell(tracer *t, int i, int j)
{
    const int south = along_x(t, i, j), north = along_x(t, i, j + 1), west = along_y(t, i, j),
              east = along_y(t, i + 1, j);
    const int side[4] = {south, east, north, west}; // side k lies between corner k and k + 1
    const bool corner[4] = {above(t, i, j), above(t, i + 1, j), above(t, i + 1, j + 1),
                            above(t, i, j + 1)};
    const bool saddle = corner[0] == corner[2] && corner[1] == corner[3] && corner[0] != corner[1];
    const bool joined = saddle && middle_above(t, i, j);
    for (int k = 0; k < 4; k++) {
        // a line leaves the cell where, going round it, what is above begins
        if (corner[k] && !corner[(k + 1) % 4]) {
            // it leaves through side k; it came in where `above` began
            int from = (k + 3) % 4;
            while (corner[from]) {
                from = (from + 3) % 4;
            }
            if (joined) {
                from = (k + 1) % 4; // round the corner below, not round the one above
            }
            t->next[side[k]] = side[from];
        }
    }
}

static void crossing(const tracer *t, int id, double at[2])
{
    const int k = id % t->n, i = k % t->r->nx, j = k / t->r->nx, in_y = id >= t->n;
    const double a = t->r->value[k], b = t->r->value[in_y ? k + t->r->nx : k + 1];
    const double share = (t->level - a) / (b - a);
    const double part = share >= 0 && share <= 1 ? share : 0.5;
    at[0] = i + (in_y ? 0 : part);
    at[1] = j + (in_y ? part : 0);
}

// --- fewer points

static double off_line(const double p[2], const double a[2], const double b[2])
{
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = hypot(dx, dy);
    return length > 0 ? fabs(dx * (p[1] - a[1]) - dy * (p[0] - a[0])) / length
                      : hypot(p[0] - a[0], p[1] - a[1]);
}

// of first .. last (taken modulo n) those that the line between its ends misses by more than slack
static void keep_between(tracer *t, int n, int first, int last, double slack)
{
    int depth = 0;
    t->stack[depth++] = first;
    t->stack[depth++] = last;
    while (depth > 0) {
        const int b = t->stack[--depth], a = t->stack[--depth];
        double most = slack;
        int at = -1;
        for (int k = a + 1; k < b; k++) {
            const double off = off_line(t->loop[k % n], t->loop[a], t->loop[b % n]);
            if (off > most) {
                most = off;
                at = k;
            }
        }
        if (at >= 0) {
            t->keep[at % n] = true;
            t->stack[depth++] = a;
            t->stack[depth++] = at;
            t->stack[depth++] = at;
            t->stack[depth++] = b;
        }
    }
}

static void simplify(tracer *t, int n, double slack)
{
    int far = 0;
    double most = -1;
    for (int k = 0; k < n; k++) {
        const double d = hypot(t->loop[k][0] - t->loop[0][0], t->loop[k][1] - t->loop[0][1]);
        t->keep[k] = false;
        if (d > most) {
            most = d;
            far = k;
        }
    }
    t->keep[0] = t->keep[far] = true;
    keep_between(t, n, 0, far, slack);
    keep_between(t, n, far, n, slack);
}

static double area_of(const tracer *t, int n)
{
    double twice = 0;
    for (int k = 0; k < n; k++) {
        const double *a = t->loop[k], *b = t->loop[(k + 1) % n];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return fabs(twice) / 2;
}

// --- all of it

static int follow(tracer *t, int from)
{
    int n = 0;
    for (int id = from, next; id >= 0; id = next) {
        crossing(t, id, t->loop[n++]);
        next = t->next[id];
        t->next[id] = -1;
    }
    return n - 1; // the first one came twice
}

static void put_loop(const tracer *t, int n, contours *out)
{
    out->start[out->nloop++] = out->npoint;
    for (int k = 0; k < n; k++) {
        if (t->keep[k]) {
            memcpy(out->at[out->npoint++], t->loop[k], sizeof t->loop[k]);
        }
    }
    out->start[out->nloop] = out->npoint;
}

static status trace(tracer *t, double slack, double least, contours *out)
{
    status st = OK;
    const size_t most = 2 * (size_t)t->n;
    TRY(TAKE(t->next, most));
    TRY(TAKE(t->loop, most + 1));
    TRY(TAKE(t->keep, most + 1));
    TRY(TAKE(t->stack, 2 * most + 8));
    TRY(TAKE(out->start, most / 4 + 2));
    TRY(TAKE(out->at, most));
    memset(t->next, -1, most * sizeof *t->next);
    for (int j = 0; j + 1 < t->r->ny; j++) {
        for (int i = 0; i + 1 < t->r->nx; i++) {
            link_cell(t, i, j);
        }
    }
    for (int id = 0; id < 2 * t->n; id++) {
        const int n = t->next[id] >= 0 ? follow(t, id) : 0;
        if (n >= 3 && area_of(t, n) >= least) {
            simplify(t, n, slack);
            put_loop(t, n, out);
        }
    }

done:
    return st;
}

status contours_make(const raster *r, double level, double slack, double least, contours *out)
{
    status st = OK;
    tracer t = {.r = r, .level = level, .n = r->nx * r->ny};
    contours c = {0};
    if (t.n > 0) {
        TRY(trace(&t, slack, least, &c));
    }
    *out = c;
    c = (contours){0};

done:
    contours_free(&c);
    free(t.next);
    free(t.loop);
    free(t.keep);
    free(t.stack);
    return st;
}

void raster_smooth(const raster *from, raster *to)
{
    static const double weight[3] = {0.25, 0.5, 0.25};
    for (int j = 0; j < from->ny; j++) {
        for (int i = 0; i < from->nx; i++) {
            double sum = 0;
            for (int k = 0; k < 9; k++) {
                const int x = i + k % 3 - 1, y = j + k / 3 - 1;
                const bool in = x >= 0 && y >= 0 && x < from->nx && y < from->ny;
                sum += in ? weight[k % 3] * weight[k / 3] * from->value[x + from->nx * y] : 0;
            }
            to->value[i + to->nx * j] = sum;
        }
    }
}

int line_simplify(int n, double (*at)[2], double slack)
{
    int left = n > 0;
    for (int from = 0, to; from + 1 < n; from = to) {
        bool near = true;
        for (to = from + 1; to + 1 < n && near; to += near) {
            for (int k = from + 1; k <= to; k++) {
                near = near && off_line(at[k], at[from], at[to + 1]) <= slack;
            }
        }
        memmove(at[left++], at[to], sizeof at[to]);
    }
    return left;
}

void contours_path(canvas *c, const contours *lines, double x, double y, double step)
{
    for (int l = 0; l < lines->nloop; l++) {
        for (int k = lines->start[l]; k < lines->start[l + 1]; k++) {
            const double px = x + step * lines->at[k][0], py = y - step * lines->at[k][1];
            if (k == lines->start[l]) {
                canvas_move(c, px, py);
            } else {
                canvas_line(c, px, py);
            }
        }
        canvas_close(c);
    }
}
