// section/known.c
#include "section/known.h"

#include "base/memory.h"

static void add_frame(hash *h, const material_frame *f)
{
    hash_int(h, f->polar);
    hash_reals(h, 2, f->centre);
    hash_reals(h, 9, f->axes.a[0]);
}

static void add_material(hash *h, const material *m)
{
    const double constants[] = {m->E,    m->nu,      m->E1,          m->E2,         m->E3,
                                m->G12,  m->G13,     m->G23,         m->nu12,       m->nu13,
                                m->nu23, m->density, m->fibre_angle, m->plane_angle};
    hash_int(h, m->kind);
    hash_reals(h, (int)(sizeof constants / sizeof *constants), constants);
    hash_reals(h, m->stiffness.nrow * m->stiffness.ncol, m->stiffness.a);
}

static void add_piece(hash *h, const carrier *c)
{
    const double ends[] = {c->from, c->to};
    hash_int(h, (int)c->kind);
    hash_reals(h, 8, c->p[0]);
    hash_reals(h, 2, ends);
}

static void add_outline(hash *h, const section_outline *o)
{
    hash_int(h, o->count);
    hash_real(h, o->turn);
    for (int k = 0; k < o->count; k++) {
        const outline *s = &o->items[k];
        const double numbers[] = {s->centre[0], s->centre[1], s->outer,   s->inner, s->mid_angle,
                                  s->width,     s->size[0],   s->size[1], s->angle};
        hash_int(h, s->kind);
        hash_int(h, s->material);
        hash_reals(h, (int)(sizeof numbers / sizeof *numbers), numbers);
        hash_int(h, s->nloop);
        for (int i = 0; i < s->nloop; i++) {
            const int first = s->loop_start[i], count = s->loop_start[i + 1] - first;
            hash_int(h, count);
            if (s->kind == KIND_POLYGON) {
                hash_reals(h, 2 * count, s->point + 2 * first);
            }
        }
        const int pieces = s->kind == KIND_LOOPS ? s->loop_start[s->nloop] : 0;
        for (int i = 0; i < pieces; i++) {
            add_piece(h, &s->piece[i]);
        }
        hash_int(h, s->has_frame);
        if (s->has_frame) {
            add_frame(h, &s->frame);
        }
    }
}

static void add_mesh(hash *h, const mesh *m)
{
    hash_int(h, m->order);
    hash_reals(h, 3 * m->nnode, m->xyz);
    for (int b = 0; b < m->nblock; b++) {
        const mesh_block *k = &m->block[b];
        const size_t n = (size_t)k->nelem;
        hash_int(h, (int)k->shape);
        hash_int(h, k->nelem);
        hash_bytes(h, k->conn, n * (size_t)k->per_elem * sizeof *k->conn);
        hash_bytes(h, k->material, n * sizeof *k->material);
        if (k->frame) {
            hash_bytes(h, k->frame, n * sizeof *k->frame);
        }
    }
    for (int k = 0; k < m->nframe; k++) {
        add_frame(h, &m->frame[k]);
    }
}

status section_fingerprint(const section_case *c, const material *materials, const section_place *p,
                           hash *out, bool *known)
{
    status st = OK;
    mesh m = {0};
    hash h = hash_begin();
    *known = c->nmaterial > 0;
    hash_text(&h, STIFFAXIS_VERSION);
    hash_int(&h, c->model);
    hash_int(&h, c->mesh.kind);
    hash_int(&h, c->mesh.order);
    hash_int(&h, c->mesh.order_chosen);
    hash_real(&h, c->mesh.size);
    hash_real(&h, c->tolerance);
    hash_real(&h, p->turn_rate);
    for (int i = 0; i < c->nmaterial; i++) {
        *known = *known && !materials[i].modulus.at;
        add_material(&h, &materials[i]);
    }
    if (p->drawn && *known) {
        add_outline(&h, &p->outline);
    } else if (*known) {
        TRY(section_place_mesh(c, p, &c->mesh, &m));
        add_mesh(&h, &m);
    }
    *out = h;

done:
    mesh_free(&m);
    return st;
}

int section_known_find(const section_known *k, hash key)
{
    for (int i = 0; i < k->count; i++) {
        if (hash_is(k->key[i], key)) {
            return i;
        }
    }
    return -1;
}

status section_known_add(section_known *k, hash key, const beam_law *law, const mesh_options *mesh)
{
    status st = OK;
    hash *keys = NULL;
    beam_law *laws = NULL;
    mesh_options *meshes = NULL;
    if (k->count == k->capacity) {
        const int capacity = 2 * k->capacity + 16;
        TRY(TAKE(keys, (size_t)capacity));
        TRY(TAKE(laws, (size_t)capacity));
        TRY(TAKE(meshes, (size_t)capacity));
        for (int i = 0; i < k->count; i++) {
            keys[i] = k->key[i];
            laws[i] = k->law[i];
            meshes[i] = k->mesh[i];
        }
        const int count = k->count;
        section_known_free(k);
        *k = (section_known){count, capacity, keys, laws, meshes};
        keys = NULL;
        laws = NULL;
        meshes = NULL;
    }
    k->key[k->count] = key;
    k->law[k->count] = *law;
    k->mesh[k->count] = *mesh;
    k->count++;

done:
    free(keys);
    free(laws);
    free(meshes);
    return st;
}

void section_known_free(section_known *k)
{
    free(k->key);
    free(k->law);
    free(k->mesh);
    *k = (section_known){0};
}
