#include "meshes/extension.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// Triangles are the stiffer the smaller they are, by this power of their area: at 0 small ones turn
// over first, at 1 large ones do.
static const double STIFFENING = 0.25;

void extension_free(extension *e)
{
    free(e->triangle);
    free(e->weight);
    free(e->row);
    free(e->first);
    free(e->start);
    free(e->factor);
    *e = (extension){0};
}

// --- weights: half the cotangents of the angles

static status weigh(extension *e, const double *xyz)
{
    double mean = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (int t = 0; t < e->ntriangle; t++) {
            double side[3][2];
            for (int k = 0; k < 3; k++) {
                const double *a = xyz + 3 * (size_t)e->triangle[t][(k + 1) % 3];
                const double *b = xyz + 3 * (size_t)e->triangle[t][(k + 2) % 3];
                side[k][0] = b[0] - a[0];
                side[k][1] = b[1] - a[1];
            }
            const double area = (side[0][0] * side[1][1] - side[0][1] * side[1][0]) / 2;
            if (!(area > 0)) {
                return status_fail(ERR_NUMERIC, "a mesh to follow the section with is inverted");
            }
            mean += pass == 0 ? area / e->ntriangle : 0;
            const double stiff = pow(mean / area, STIFFENING);
            for (int k = 0; k < 3; k++) {
                const double *u = side[(k + 1) % 3], *v = side[(k + 2) % 3];
                e->weight[t][k] = -(u[0] * v[0] + u[1] * v[1]) / (4 * area) * stiff;
            }
        }
    }
    return OK;
}

// --- an order of the free nodes in which neighbours are near: Cuthill and McKee's, reversed

typedef struct neighbours {
    int *start, *of; // [nnode + 1]; those of a node, some of them twice
} neighbours;

static status find_neighbours(const extension *e, neighbours *n)
{
    status st = OK;
    int *end = NULL;
    TRY(TAKE(n->start, (size_t)e->nnode + 1));
    TRY(TAKE(end, (size_t)e->nnode));
    TRY(TAKE(n->of, 6 * (size_t)e->ntriangle));
    for (int i = 0; i < 3 * e->ntriangle; i++) {
        n->start[e->triangle[i / 3][i % 3] + 1] += 2;
    }
    for (int i = 0; i < e->nnode; i++) {
        n->start[i + 1] += n->start[i];
        end[i] = n->start[i];
    }
    for (int i = 0; i < 3 * e->ntriangle; i++) {
        const int *t = e->triangle[i / 3], at = t[i % 3];
        n->of[end[at]++] = t[(i + 1) % 3];
        n->of[end[at]++] = t[(i + 2) % 3];
    }

done:
    free(end);
    return st;
}

// breadth first from a node, numbers from `next` on; *last is the node reached last
static int number_from(const extension *e, const neighbours *n, int from, int next, int *row,
                       int *queue, int *last)
{
    int done = 0, count = 0;
    row[from] = next;
    queue[count++] = from;
    while (done < count) {
        const int at = queue[done++];
        for (int k = n->start[at]; k < n->start[at + 1]; k++) {
            const int to = n->of[k];
            if (e->row[to] >= 0 && row[to] < 0) {
                row[to] = next + count;
                queue[count++] = to;
            }
        }
    }
    *last = queue[count - 1];
    return count;
}

// e->row is 0 at free nodes and -1 at given ones before; numbers after
static status number_rows(extension *e, const neighbours *n)
{
    status st = OK;
    int *row = NULL, *queue = NULL, next = 0;
    TRY(TAKE(row, (size_t)e->nnode));
    TRY(TAKE(queue, (size_t)e->nnode));
    for (int i = 0; i < e->nnode; i++) {
        row[i] = -1;
    }
    for (int i = 0; i < e->nnode; i++) {
        if (e->row[i] < 0 || row[i] >= 0) {
            continue;
        }
        int last = i;
        const int count = number_from(e, n, i, next, row, queue, &last);
        // again from the far end: narrower
        for (int k = 0; k < count; k++) {
            row[queue[k]] = -1;
        }
        next += number_from(e, n, last, next, row, queue, &last);
    }
    e->nfree = next;
    for (int i = 0; i < e->nnode; i++) {
        e->row[i] = e->row[i] < 0 ? -1 : next - 1 - row[i];
    }

done:
    free(row);
    free(queue);
    return st;
}

// --- the factor

static double *entry(const extension *e, int i, int j)
{
    return &e->factor[e->start[i] + (size_t)(j - e->first[i])];
}

static status assemble(extension *e)
{
    status st = OK;
    size_t total = 0;
    TRY(TAKE(e->first, (size_t)e->nfree));
    TRY(TAKE(e->start, (size_t)e->nfree));
    for (int i = 0; i < e->nfree; i++) {
        e->first[i] = i;
    }
    for (int t = 0; t < 9 * e->ntriangle; t++) {
        const int *n = e->triangle[t / 9], i = e->row[n[t % 3]], j = e->row[n[t / 3 % 3]];
        if (i >= 0 && j >= 0 && j < e->first[i]) {
            e->first[i] = j;
        }
    }
    for (int i = 0; i < e->nfree; i++) {
        e->start[i] = total;
        total += (size_t)(i - e->first[i] + 1);
    }
    TRY(TAKE(e->factor, total));
    for (int t = 0; t < 3 * e->ntriangle; t++) {
        const int *n = e->triangle[t / 3], k = t % 3;
        const int a = e->row[n[(k + 1) % 3]], b = e->row[n[(k + 2) % 3]];
        const double w = e->weight[t / 3][k];
        if (a >= 0) {
            *entry(e, a, a) += w;
        }
        if (b >= 0) {
            *entry(e, b, b) += w;
        }
        if (a >= 0 && b >= 0) {
            *entry(e, a > b ? a : b, a > b ? b : a) -= w;
        }
    }

done:
    return st;
}

// in four sums, which a compiler may take at once
static double dot(int n, const double *a, const double *b)
{
    double sum[4] = {0};
    int k = 0;
    for (; k + 4 <= n; k += 4) {
        for (int i = 0; i < 4; i++) {
            sum[i] += a[k + i] * b[k + i];
        }
    }
    for (; k < n; k++) {
        sum[0] += a[k] * b[k];
    }
    return sum[0] + sum[1] + (sum[2] + sum[3]);
}

static status factorize(extension *e)
{
    for (int i = 0; i < e->nfree; i++) {
        double *row = entry(e, i, e->first[i]);
        for (int j = e->first[i]; j <= i; j++) {
            const int from = e->first[i] > e->first[j] ? e->first[i] : e->first[j];
            const double *a = row + (from - e->first[i]), *b = entry(e, j, from);
            const double sum = row[j - e->first[i]] - (j > from ? dot(j - from, a, b) : 0);
            if (j == i && !(sum > 0)) {
                return status_fail(ERR_NUMERIC, "a mesh to follow the section with is degenerate");
            }
            row[j - e->first[i]] = j == i ? sqrt(sum) : sum / *entry(e, j, j);
        }
    }
    return OK;
}

status extension_make(int nnode, const double *xyz, int ntriangle, int (*triangle)[3],
                      const bool *given, extension *out)
{
    status st = OK;
    extension e = {.nnode = nnode, .ntriangle = ntriangle, .triangle = triangle};
    neighbours near = {0};
    TRY(TAKE(e.weight, (size_t)ntriangle));
    TRY(TAKE(e.row, (size_t)nnode));
    for (int i = 0; i < nnode; i++) {
        e.row[i] = given[i] ? -1 : 0;
    }
    TRY(weigh(&e, xyz));
    TRY(find_neighbours(&e, &near));
    TRY(number_rows(&e, &near));
    TRY(assemble(&e));
    TRY(factorize(&e));
    *out = e;
    e = (extension){0};

done:
    free(near.start);
    free(near.of);
    extension_free(&e);
    return st;
}

// --- solving

static void load(const extension *e, double (*d)[2], int c, double *b)
{
    memset(b, 0, (size_t)e->nfree * sizeof *b);
    for (int t = 0; t < 3 * e->ntriangle; t++) {
        const int *n = e->triangle[t / 3], k = t % 3;
        for (int way = 0; way < 2; way++) {
            const int to = n[(k + 1 + way) % 3], from = n[(k + 2 - way) % 3];
            if (e->row[to] >= 0 && e->row[from] < 0) {
                b[e->row[to]] += e->weight[t / 3][k] * d[from][c];
            }
        }
    }
}

void extension_fill(const extension *e, double (*d)[2], double *room)
{
    for (int c = 0; c < 2; c++) {
        load(e, d, c, room);
        for (int i = 0; i < e->nfree; i++) {
            const int first = e->first[i];
            room[i] -= dot(i - first, entry(e, i, first), room + first);
            room[i] /= *entry(e, i, i);
        }
        for (int i = e->nfree - 1; i >= 0; i--) {
            room[i] /= *entry(e, i, i);
            for (int j = e->first[i]; j < i; j++) {
                room[j] -= *entry(e, i, j) * room[i];
            }
        }
        for (int i = 0; i < e->nnode; i++) {
            if (e->row[i] >= 0) {
                d[i][c] = room[e->row[i]];
            }
        }
    }
}
