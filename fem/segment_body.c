// fem/segment_body.c
// What the fields of a segment stand on.
#include "fem/after.h"

#include "base/memory.h"

#include <string.h>

void segment_body_free(segment_body *b)
{
    mesh_free(&b->plane);
    mesh_free(&b->apart);
    free(b->level);
    free(b->matter);
    free(b->node);
    *b = (segment_body){0};
}

// --- nodes apart: one for every material, or frame of it, that meets at a node

// the copies of a node, a list in the order in which they were made
typedef struct copy {
    int node, material, frame, next; // next: of the same node, -1: none
} copy;

typedef struct splitter {
    const mesh *plane;
    int *first; // [nnode] copy, -1: none yet
    copy *copy;
    int ncopy;
} splitter;

static int copy_for(splitter *s, int node, int material, int frame)
{
    int *link = &s->first[node];
    while (*link >= 0) {
        const copy *c = &s->copy[*link];
        if (c->material == material && c->frame == frame) {
            return *link;
        }
        link = &s->copy[*link].next;
    }
    s->copy[s->ncopy] = (copy){node, material, frame, -1};
    *link = s->ncopy;
    return s->ncopy++;
}

static status splitter_make(const mesh *plane, splitter *s)
{
    status st = OK;
    size_t most = 0;
    for (int b = 0; b < plane->nblock; b++) {
        most += (size_t)plane->block[b].nelem * (size_t)plane->block[b].per_elem;
    }
    *s = (splitter){.plane = plane};
    TRY(TAKE(s->first, (size_t)plane->nnode));
    TRY(TAKE(s->copy, most));
    for (int i = 0; i < plane->nnode; i++) {
        s->first[i] = -1;
    }

done:
    return st;
}

static void splitter_free(splitter *s)
{
    free(s->first);
    free(s->copy);
}

// matter by layers has no interfaces of its own in the plane: nodes stay together
static status make_apart(const mesh *plane, bool by_layers, mesh *out)
{
    status st = OK;
    splitter s = {0};
    mesh m = {0};
    TRY(mesh_copy(plane, &m));
    TRY(splitter_make(plane, &s));
    for (int b = 0; b < m.nblock; b++) {
        mesh_block *k = &m.block[b];
        for (int i = 0; i < k->nelem * k->per_elem; i++) {
            const int e = i / k->per_elem;
            k->conn[i] = copy_for(&s, k->conn[i], by_layers ? 0 : k->material[e],
                                  k->frame && !by_layers ? k->frame[e] : -1);
        }
    }
    free(m.xyz);
    m.xyz = NULL;
    TRY(TAKE(m.xyz, 3 * (size_t)s.ncopy));
    m.nnode = s.ncopy;
    for (int i = 0; i < s.ncopy; i++) {
        memcpy(m.xyz + 3 * (size_t)i, plane->xyz + 3 * (size_t)s.copy[i].node, 3 * sizeof *m.xyz);
    }
    *out = m;
    m = (mesh){0};

done:
    splitter_free(&s);
    mesh_free(&m);
    return st;
}

// --- levels

static status keep_levels(const body *b, const way_run *run, segment_body *out)
{
    status st = OK;
    const bool own = run->shared || run->own_last > run->own_first;
    const size_t nplane = (size_t)b->plane->nnode;
    out->shared = run->shared;
    out->order = b->order;
    out->nlayer = b->nlayer;
    out->nlevel = b->nlevel;
    out->first = own ? run->own_first : run->first;
    out->last = own ? run->own_last : run->last;
    TRY(TAKE(out->level, (size_t)b->nlevel));
    memcpy(out->level, b->level, (size_t)b->nlevel * sizeof *b->level);
    TRY(TAKE(out->node, 3 * nplane * (size_t)(out->last - out->first)));
    for (int level = out->first; level < out->last; level++) {
        double *to = out->node + 3 * nplane * (size_t)(level - out->first);
        for (int i = 0; i < b->plane->nnode; i++) {
            body_node(b, i, level, to + 3 * (size_t)i);
        }
    }

done:
    return st;
}

static status keep_matter(const body *b, segment_body *out)
{
    status st = OK;
    const size_t n = (size_t)b->nlayer * (size_t)mesh_element_count(b->plane);
    if (b->spec.matter) {
        TRY(TAKE(out->matter, n));
        memcpy(out->matter, b->spec.matter, n * sizeof *out->matter);
    }

done:
    return st;
}

status after_keep_body(const segment_problem *p, const way_run *run, bool fields, bool stress,
                       segment_body *out)
{
    status st = OK;
    segment_body r = {0};
    const body *b = p->body;
    TRY(mesh_copy(b->plane, &r.plane));
    TRY(fields ? keep_levels(b, run, &r) : OK);
    TRY(fields ? keep_matter(b, &r) : OK);
    TRY(fields && stress ? make_apart(b->plane, b->spec.matter != NULL, &r.apart) : OK);
    *out = r;
    r = (segment_body){0};

done:
    segment_body_free(&r);
    return st;
}
