// fem/face.c
#include "fem/face.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// arclengths nearer than this to a level, of the body's length, are at it
static const double AT_LEVEL = 1e-9;

static bool is_wall(int face)
{
    return face >= FACE_OUTSIDE;
}

static bool loop_is_of(const face_border *f, int loop, int face)
{
    return f->face[loop] == face || (face == FACE_INSIDE && f->face[loop] >= FACE_HOLE);
}

// arclengths of a part within a layer
static bool part_in_layer(const body *b, const face_part *part, int layer, double *from, double *to)
{
    *from = fmax(part->from, b->level[layer * b->order]);
    *to = fmin(part->to, b->level[(layer + 1) * b->order]);
    return *to - *from > AT_LEVEL * b->length;
}

static status no_such_face(int face)
{
    if (face == FACE_INSIDE) {
        return status_fail(ERR_INPUT, "the section has no holes: it has no inside face");
    }
    return status_fail(ERR_INPUT, "the section has no hole %d", face - FACE_HOLE + 1);
}

status face_check(const body *b, const face_part *part)
{
    status st = OK;
    face_border f = {0};
    bool found = !is_wall(part->face);
    for (int layer = 0; layer < b->nlayer && !found; layer++) {
        double from, to;
        if (b->spec.matter && !part_in_layer(b, part, layer, &from, &to)) {
            continue;
        }
        face_border_free(&f);
        TRY(face_border_make(b, layer, &f));
        for (int k = 0; k < f.nloop; k++) {
            found = found || loop_is_of(&f, k, part->face);
        }
        if (!b->spec.matter) {
            break;
        }
    }
    if (!found) {
        TRY(no_such_face(part->face));
    }

done:
    face_border_free(&f);
    return st;
}

// --- patches

// normal and area at point q from the slopes of the patch's nodes along its two directions
static void add_point(const body *b, face_patch *p, int q, const double (*slope)[2], double weight)
{
    vec3 u = {0}, v = {0};
    for (int i = 0; i < p->nnode; i++) {
        vec3 x;
        body_node(b, p->plane_node[i], p->level[i], x.a);
        u = vec3_add_scaled(u, slope[i][0], x);
        v = vec3_add_scaled(v, slope[i][1], x);
    }
    const vec3 n = vec3_cross(u, v);
    const double size = vec3_norm(n);
    p->dA[q] = weight * size;
    for (int d = 0; d < 3; d++) {
        p->normal[q][d] = n.a[d] / size;
    }
}

static void wall_patch(const body *b, const element *edge, const border_side *s, int layer,
                       double from, double to, face_patch *p)
{
    int node[ELEMENT_MAX_ORDER + 1];
    const int across = border_side_nodes(b, s, node), along = b->order + 1;
    const double begin = b->level[layer * b->order], end = b->level[(layer + 1) * b->order];
    const double half = (to - from) / (end - begin),
                 middle = (from + to - begin - end) / (end - begin);
    double x[ELEMENT_MAX_ORDER + 2], wx[ELEMENT_MAX_ORDER + 2];
    double z[ELEMENT_MAX_ORDER + 2], wz[ELEMENT_MAX_ORDER + 2];
    // one point more than a product of two basis functions needs, for curved sides
    gauss_legendre(across + 1, x, wx);
    gauss_legendre(along + 1, z, wz);
    p->layer = layer;
    p->nnode = across * along;
    p->npoint = 0;
    for (int i = 0; i < p->nnode; i++) {
        p->plane_node[i] = node[i % across];
        p->level[i] = layer * b->order + i / across;
    }
    for (int q = 0; q < (across + 1) * (along + 1); q++) {
        double N[ELEMENT_MAX_ORDER + 1], dN[ELEMENT_MAX_ORDER + 1], slope[FACE_MAX_NODES][2];
        double L[ELEMENT_MAX_ORDER + 1], dL[ELEMENT_MAX_ORDER + 1];
        const double at = middle + half * z[q / (across + 1)];
        element_basis(edge, &x[q % (across + 1)], N, dN);
        element_basis(&b->line, &at, L, dL);
        for (int i = 0; i < p->nnode; i++) {
            p->N[q][i] = N[i % across] * L[i / across];
            slope[i][0] = dN[i % across] * L[i / across];
            slope[i][1] = N[i % across] * dL[i / across];
        }
        add_point(b, p, q, (const double(*)[2])slope,
                  half * wx[q % (across + 1)] * wz[q / (across + 1)]);
        p->npoint++;
    }
}

static void end_patch(const body *b, int block, int e, bool tip, face_patch *p)
{
    const mesh_block *k = &b->plane->block[block];
    const basis_table *t = &b->plane_table[block];
    p->layer = tip ? b->nlayer - 1 : 0;
    p->nnode = t->nnode;
    p->npoint = t->npoint;
    for (int i = 0; i < t->nnode; i++) {
        p->plane_node[i] = k->conn[(size_t)e * (size_t)k->per_elem + (size_t)i];
        p->level[i] = tip ? b->nlevel - 1 : 0;
    }
    for (int q = 0; q < t->npoint; q++) {
        memcpy(p->N[q], t->N + q * t->nnode, (size_t)t->nnode * sizeof **p->N);
        add_point(b, p, q, (const double(*)[2])(t->dN + 2 * q * t->nnode), t->weight[q]);
        for (int d = 0; d < 3 && !tip; d++) {
            p->normal[q][d] = -p->normal[q][d];
        }
    }
}

static status walk_end(const body *b, bool tip, face_visit visit, void *self, face_patch *p)
{
    status st = OK;
    for (int k = 0; k < b->plane->nblock; k++) {
        for (int e = 0; e < b->plane->block[k].nelem; e++) {
            if (body_material(b, k, e, tip ? b->nlayer - 1 : 0) >= 0) {
                end_patch(b, k, e, tip, p);
                TRY(visit(self, p));
            }
        }
    }

done:
    return st;
}

static status walk_walls(const body *b, const face_part *part, int first, int last,
                         face_visit visit, void *self, face_patch *p)
{
    status st = OK;
    face_border f = {0};
    element edge = {0};
    double from, to;
    TRY(element_make(SHAPE_LINE, b->plane->order, &edge));
    for (int layer = first; layer < last; layer++) {
        if (!part_in_layer(b, part, layer, &from, &to)) {
            continue;
        }
        if (!f.side || b->spec.matter) {
            face_border_free(&f);
            TRY(face_border_make(b, layer, &f));
        }
        for (int i = 0; i < f.nside; i++) {
            if (loop_is_of(&f, f.side[i].loop, part->face)) {
                wall_patch(b, &edge, &f.side[i], layer, from, to, p);
                TRY(visit(self, p));
            }
        }
    }

done:
    face_border_free(&f);
    return st;
}

status face_walk(const body *b, const face_part *part, int first, int last, face_visit visit,
                 void *self)
{
    status st = OK;
    face_patch *p = NULL;
    TRY(face_check(b, part));
    TRY(TAKE(p, 1));
    if (is_wall(part->face)) {
        TRY(walk_walls(b, part, first, last, visit, self, p));
    } else if (part->face == FACE_BASE ? first <= 0 && last > 0
                                       : first < b->nlayer && last >= b->nlayer) {
        TRY(walk_end(b, part->face == FACE_TIP, visit, self, p));
    }

done:
    free(p);
    return st;
}

// --- nodes

typedef struct node_marker {
    const body *body;
    const face_part *part;
    int first, last;
    bool *mark;
} node_marker;

static void mark_level(const node_marker *m, const face_border *f, int level)
{
    int node[ELEMENT_MAX_ORDER + 1];
    const size_t n = (size_t)m->body->plane->nnode;
    for (int i = 0; i < f->nside; i++) {
        if (loop_is_of(f, f->side[i].loop, m->part->face)) {
            const int count = border_side_nodes(m->body, &f->side[i], node);
            for (int k = 0; k < count; k++) {
                m->mark[(size_t)(level - m->first) * n + (size_t)node[k]] = true;
            }
        }
    }
}

static status mark_walls(const node_marker *m)
{
    status st = OK;
    const body *b = m->body;
    face_border f = {0};
    const double near = AT_LEVEL * b->length;
    for (int layer = 0; layer < b->nlayer; layer++) {
        const int low = layer * b->order, high = low + b->order;
        if (high < m->first || low >= m->last || b->level[high] < m->part->from - near ||
            b->level[low] > m->part->to + near) {
            continue;
        }
        if (!f.side || b->spec.matter) {
            face_border_free(&f);
            TRY(face_border_make(b, layer, &f));
        }
        for (int level = low; level <= high; level++) {
            const double s = b->level[level];
            if (level >= m->first && level < m->last && s >= m->part->from - near &&
                s <= m->part->to + near) {
                mark_level(m, &f, level);
            }
        }
    }

done:
    face_border_free(&f);
    return st;
}

status face_nodes(const body *b, const face_part *part, int first, int last, bool *mark)
{
    status st = OK;
    const size_t n = (size_t)b->plane->nnode;
    const int level = part->face == FACE_TIP ? b->nlevel - 1 : 0;
    memset(mark, 0, (size_t)(last - first) * n * sizeof *mark);
    TRY(face_check(b, part));
    if (is_wall(part->face)) {
        const node_marker m = {b, part, first, last, mark};
        TRY(mark_walls(&m));
    } else if (level >= first && level < last) {
        for (size_t i = 0; i < n; i++) {
            mark[(size_t)(level - first) * n + i] = body_node_is_used(b, (int)i, level);
        }
    }

done:
    return st;
}
