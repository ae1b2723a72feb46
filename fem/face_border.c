// fem/face_border.c
// The border of the matter of a layer, in closed loops.
#include "fem/face.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

void face_border_free(face_border *f)
{
    free(f->side);
    free(f->face);
    free(f->area);
    *f = (face_border){0};
}

static int lattice(shape kind, int order, int i, int j)
{
    return kind == SHAPE_QUAD ? j * (order + 1) + i : j * (order + 1) - j * (j - 1) / 2 + i;
}

int border_side_nodes(const body *b, const border_side *s, int node[ELEMENT_MAX_ORDER + 1])
{
    const mesh_block *k = &b->plane->block[s->block];
    const int *conn = k->conn + (size_t)s->e * (size_t)k->per_elem, p = b->plane->order;
    for (int t = 0; t <= p; t++) {
        const int quad[4][2] = {{t, 0}, {p, t}, {p - t, p}, {0, p - t}};
        const int triangle[3][2] = {{t, 0}, {p - t, t}, {0, p - t}};
        const int *at = k->shape == SHAPE_QUAD ? quad[s->side] : triangle[s->side];
        node[t] = conn[lattice(k->shape, p, at[0], at[1])];
    }
    return p + 1;
}

// --- sides that no other element shares

typedef struct side_ends {
    int low, high; // end nodes
    border_side side;
} side_ends;

static int by_ends(const void *a, const void *b)
{
    const side_ends *s = (const side_ends *)a, *t = (const side_ends *)b;
    return s->low != t->low ? (s->low > t->low) - (s->low < t->low)
                            : (s->high > t->high) - (s->high < t->high);
}

static int all_sides(const body *b, int layer, side_ends *all)
{
    int count = 0, node[ELEMENT_MAX_ORDER + 1];
    for (int k = 0; k < b->plane->nblock; k++) {
        const mesh_block *block = &b->plane->block[k];
        for (int e = 0; e < block->nelem; e++) {
            for (int s = 0; s < (block->shape == SHAPE_QUAD ? 4 : 3); s++) {
                if (body_material(b, k, e, layer) < 0) {
                    continue;
                }
                side_ends *to = &all[count++];
                to->side = (border_side){.block = k, .e = e, .side = s, .loop = -1};
                const int last = border_side_nodes(b, &to->side, node) - 1;
                to->low = node[0] < node[last] ? node[0] : node[last];
                to->high = node[0] < node[last] ? node[last] : node[0];
            }
        }
    }
    return count;
}

static status find_sides(const body *b, int layer, face_border *f)
{
    status st = OK;
    side_ends *all = NULL;
    TRY(TAKE(all, 4 * (size_t)mesh_element_count(b->plane)));
    const int count = all_sides(b, layer, all);
    qsort(all, (size_t)count, sizeof *all, by_ends);
    TRY(TAKE(f->side, (size_t)count));
    for (int i = 0; i < count; i++) {
        const bool before = i > 0 && by_ends(&all[i - 1], &all[i]) == 0;
        const bool after = i + 1 < count && by_ends(&all[i], &all[i + 1]) == 0;
        if (!before && !after) {
            f->side[f->nside++] = all[i].side;
        }
    }

done:
    free(all);
    return st;
}

// --- loops

typedef struct side_run {
    int from, to;       // nodes
    double leave, back; // direction of the side at its start, and backwards at its end [rad]
} side_run;

static side_run run_of(const body *b, const border_side *s)
{
    int node[ELEMENT_MAX_ORDER + 1];
    const int last = border_side_nodes(b, s, node) - 1;
    const double *x = b->plane->xyz;
    const double *first = x + 3 * (size_t)node[0], *next = x + 3 * (size_t)node[1];
    const double *end = x + 3 * (size_t)node[last], *before = x + 3 * (size_t)node[last - 1];
    return (side_run){
        .from = node[0],
        .to = node[last],
        .leave = atan2(next[1] - first[1], next[0] - first[0]),
        .back = atan2(before[1] - end[1], before[0] - end[0]),
    };
}

// Where matter touches itself at a node only, the loop keeps to the void that it runs around: the
// last side to leave, clockwise from where it came. So holes stay apart.
static int next_side(const side_run *run, const int *first, const int *chain, int at)
{
    const double full = 2 * acos(-1.0);
    double best = 0;
    int found = -1;
    for (int k = first[run[at].to]; k >= 0; k = chain[k]) {
        double turn = run[at].back - run[k].leave;
        while (turn <= 0) {
            turn += full;
        }
        if (turn > best) {
            best = turn;
            found = k;
        }
    }
    return found;
}

static double side_area(const body *b, const border_side *s)
{
    int node[ELEMENT_MAX_ORDER + 1];
    const int n = border_side_nodes(b, s, node);
    double twice = 0;
    for (int i = 0; i + 1 < n; i++) {
        const double *x = b->plane->xyz + 3 * (size_t)node[i];
        const double *y = b->plane->xyz + 3 * (size_t)node[i + 1];
        twice += x[0] * y[1] - x[1] * y[0];
    }
    return twice / 2;
}

static status trace(const body *b, face_border *f)
{
    status st = OK;
    side_run *run = NULL;
    int *first = NULL, *chain = NULL;
    TRY(TAKE(run, (size_t)f->nside));
    TRY(TAKE(chain, (size_t)f->nside));
    TRY(TAKE(first, (size_t)b->plane->nnode));
    TRY(TAKE(f->area, (size_t)f->nside));
    memset(first, 0xff, (size_t)b->plane->nnode * sizeof *first); // -1
    for (int i = 0; i < f->nside; i++) {
        run[i] = run_of(b, &f->side[i]);
        chain[i] = first[run[i].from];
        first[run[i].from] = i;
    }
    for (int i = 0; i < f->nside; i++) {
        if (f->side[i].loop >= 0) {
            continue;
        }
        for (int k = i; k >= 0 && f->side[k].loop < 0; k = next_side(run, first, chain, k)) {
            f->side[k].loop = f->nloop;
            f->area[f->nloop] += side_area(b, &f->side[k]);
        }
        f->nloop++;
    }

done:
    free(run);
    free(first);
    free(chain);
    return st;
}

// holes are numbered by their size
static status name_loops(face_border *f)
{
    status st = OK;
    TRY(TAKE(f->face, (size_t)f->nloop));
    for (int i = 0; i < f->nloop; i++) {
        f->face[i] = f->area[i] > 0 ? FACE_OUTSIDE : FACE_HOLE;
        for (int k = 0; k < f->nloop && f->area[i] <= 0; k++) {
            f->face[i] += f->area[k] < f->area[i] || (f->area[k] == f->area[i] && k < i);
        }
    }

done:
    return st;
}

status face_border_make(const body *b, int layer, face_border *out)
{
    status st = OK;
    face_border f = {0};
    TRY(find_sides(b, layer, &f));
    TRY(trace(b, &f));
    TRY(name_loops(&f));
    *out = f;
    f = (face_border){0};

done:
    face_border_free(&f);
    return st;
}
