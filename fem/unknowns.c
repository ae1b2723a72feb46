// fem/unknowns.c
#include "fem/unknowns.h"

#include "base/memory.h"

#include <limits.h>
#include <string.h>

void unknowns_free(unknowns *u)
{
    free(u->start);
    free(u->number);
    free(u->held);
    free(u->motion);
    *u = (unknowns){0};
}

// --- who has which layers

static double layer_matter(const body_spec *s, int layer)
{
    const int *matter =
        s->matter ? s->matter + (size_t)layer * (size_t)mesh_element_count(s->plane) : NULL;
    double nodes = 0;
    for (int k = 0, index = 0; k < s->plane->nblock; k++) {
        const mesh_block *block = &s->plane->block[k];
        for (int e = 0; e < block->nelem; e++, index++) {
            nodes += !matter || matter[index] >= 0 ? block->per_elem : 0;
        }
    }
    return nodes;
}

// the first layer of a rank: as much matter below it as its share of the whole, one layer for each
// rank at least
static int first_layer(const body_spec *s, int rank, int size, double all)
{
    const int most = s->nlayer - (size - rank);
    int layer = 0;
    double below = 0;
    for (; layer < most; layer++) {
        const double here = layer_matter(s, layer);
        if (layer >= rank && below + here / 2 >= all * rank / size) {
            break;
        }
        below += here;
    }
    return layer;
}

level_share level_share_of(const body_spec *spec, int rank, int size)
{
    const int n = spec->nlayer, busy = size < n ? size : n, top = n * spec->order;
    level_share s = {.rank = rank, .size = size, .first_layer = n, .last_layer = n};
    double all = 0;
    if (rank >= busy) {
        s.first = s.last = s.to = top + 1;
        s.from = top;
        return s;
    }
    for (int layer = 0; layer < n; layer++) {
        all += layer_matter(spec, layer);
    }
    const bool last = rank == busy - 1;
    s.first_layer = rank == 0 ? 0 : first_layer(spec, rank, busy, all);
    s.last_layer = last ? n : first_layer(spec, rank + 1, busy, all);
    s.first = s.first_layer * spec->order;
    s.last = s.last_layer * spec->order + (last ? 1 : 0);
    s.from = (s.first_layer > 0 ? s.first_layer - 1 : 0) * spec->order;
    s.to = s.last_layer * spec->order + 1;
    return s;
}

// --- numbering

static bool is_clamped(const segment_problem *p, int level)
{
    return p->base == BASE_CLAMPED && level == 0;
}

static int level_blocks(const segment_problem *p, const unknowns *u, int level)
{
    if (is_clamped(p, level) || unknowns_follow_cap(u, level)) {
        return 0;
    }
    if (!u->body->spec.matter) {
        return u->nplane;
    }
    int count = 0;
    for (int i = 0; i < u->nplane; i++) {
        count += body_node_is_used(u->body, i, level);
    }
    return count;
}

static status number_levels(const segment_problem *p, unknowns *u)
{
    status st = OK;
    double count = u->cap ? 2 : 0;
    TRY(TAKE(u->start, (size_t)u->nlevel + 1));
    for (int level = 0; level < u->nlevel; level++) {
        const int here = level_blocks(p, u, level);
        count += here;
        if (3 * count > INT_MAX) { // the libraries count rows with int
            TRY(status_fail(ERR_RESOURCE,
                            "segment: more than %.3g unknowns are too many: take fewer "
                            "fem.layers, a lower fem.order or a larger fem.size_mm",
                            3 * count));
        }
        u->start[level + 1] = u->start[level] + here;
    }
    u->nblock = (int)count;
    u->cap_block = u->cap ? u->start[u->nlevel] : -1;

done:
    return st;
}

static status number_nodes(unknowns *u)
{
    status st = OK;
    const level_share *s = &u->share;
    TRY(TAKE(u->number, (size_t)(s->to - s->from) * (size_t)u->nplane));
    for (int level = s->from; level < s->to; level++) {
        int next = 0;
        for (int i = 0; i < u->nplane; i++) {
            const bool used = body_node_is_used(u->body, i, level);
            u->number[unknowns_index(u, i, level)] = used ? next++ : -1;
        }
    }

done:
    return st;
}

static void share_rows(unknowns *u)
{
    const level_share *s = &u->share;
    u->first = s->first < s->last ? u->start[s->first] : u->nblock;
    u->last = s->last == u->nlevel || s->first == s->last ? u->nblock : u->start[s->last];
}

status unknowns_make(const segment_problem *p, level_share share, unknowns *out)
{
    status st = OK;
    const body *b = p->body;
    unknowns u = {.body = b,
                  .share = share,
                  .cap = p->tip == TIP_RIGID,
                  .nplane = b->plane->nnode,
                  .nlevel = b->nlevel,
                  .radius = b->radius};

    if (b->first > share.from || b->last < share.to) {
        TRY(status_fail(ERR_BUG, "segment: levels %d to %d are not held", share.from, share.to));
    }
    TRY(number_levels(p, &u));
    if (b->spec.matter) {
        TRY(number_nodes(&u));
    }
    if (share.to == u.nlevel) {
        body_origin(b, u.nlevel - 1, u.cap_origin);
    }
    share_rows(&u);
    TRY(unknowns_hold(p, &u));
    *out = u;
    u = (unknowns){0};

done:
    unknowns_free(&u);
    return st;
}

// --- unknowns -> displacements

void unknowns_cap_motion(const unknowns *u, int plane_node, double T[3][6])
{
    double r[3];
    body_node(u->body, plane_node, u->nlevel - 1, r);
    for (int d = 0; d < 3; d++) {
        r[d] = (r[d] - u->cap_origin[d]) / u->radius;
    }
    const double motion[3][6] = {
        {1, 0, 0, 0, r[2], -r[1]}, {0, 1, 0, -r[2], 0, r[0]}, {0, 0, 1, r[1], -r[0], 0}};
    memcpy(T, motion, sizeof motion);
}

static void follow_cap(const unknowns *u, const double *cap, double *to)
{
    for (int i = 0; i < u->nplane; i++, to += 3) {
        double T[3][6];
        unknowns_cap_motion(u, i, T);
        for (int d = 0; d < 3; d++) {
            to[d] = 0;
            for (int k = 0; k < 6; k++) {
                to[d] += T[d][k] * cap[k];
            }
        }
    }
}

void unknowns_expand(const unknowns *u, int level, const double *blocks, const double *cap,
                     bool moves, double *displacement)
{
    if (unknowns_follow_cap(u, level)) {
        follow_cap(u, cap, displacement);
        return;
    }
    for (int i = 0; i < u->nplane; i++) {
        const int block = unknowns_block(u, i, level);
        double *to = displacement + 3 * (size_t)i;
        memset(to, 0, 3 * sizeof *to);
        for (int d = 0; block >= 0 && d < 3; d++) {
            const size_t at = 3 * unknowns_index(u, i, level) + (size_t)d;
            if (unknowns_is_held(u, i, level, d)) {
                to[d] = moves && u->motion ? u->motion[at] : 0;
            } else {
                to[d] = blocks[3 * (size_t)(block - u->start[level]) + (size_t)d];
            }
        }
    }
}

// --- nodal forces -> right-hand side

void unknowns_add_force(const unknowns *u, int plane_node, int level, const double *force,
                        double *b)
{
    if (unknowns_follow_cap(u, level)) {
        double T[3][6];
        unknowns_cap_motion(u, plane_node, T);
        for (int k = 0; k < 6 && unknowns_has_tip(u); k++) {
            b[3 * (u->cap_block - u->first) + k] +=
                T[0][k] * force[0] + T[1][k] * force[1] + T[2][k] * force[2];
        }
        return;
    }
    const int block = unknowns_block(u, plane_node, level);
    for (int d = 0; block >= u->first && block < u->last && d < 3; d++) {
        if (!unknowns_is_held(u, plane_node, level, d)) {
            b[3 * (size_t)(block - u->first) + (size_t)d] += force[d];
        }
    }
}

void unknowns_gather(const unknowns *u, const double *force, double *b)
{
    memset(b, 0, 3 * (size_t)(u->last - u->first) * sizeof *b);
    for (int level = u->share.first; level < u->share.last; level++) {
        for (int i = 0; i < u->nplane; i++) {
            unknowns_add_force(u, i, level, force + 3 * unknowns_index(u, i, level), b);
        }
    }
}
