// section/strain_along.c
#include "section/strain_along.h"

#include "base/memory.h"
#include "section/extremes.h"
#include "section/reuse.h"

#include <math.h>

typedef struct walk {
    section_store store;
    const law_along *law;
    const section_wrenches_along *wrenches;
    section_place *place;     // [nsample]
    bool *done;               // [nsample]
    section_extreme *largest; // [nmaterial] work
    bool *replaced;
    section_strain_place *out;
} walk;

static void walk_free(walk *w)
{
    for (int i = 0; w->place && i < w->wrenches->nsample; i++) {
        section_place_free(&w->place[i]);
    }
    free(w->place);
    free(w->done);
    free(w->largest);
    free(w->replaced);
    section_store_free(&w->store);
}

static status walk_make(const section_case *c, const material *materials, const law_along *law,
                        const section_wrenches_along *wrenches, walk *w)
{
    status st = OK;
    *w = (walk){.law = law, .wrenches = wrenches};
    TRY(section_store_make(c, materials, law->length, &w->store));
    TRY(TAKE(w->place, (size_t)wrenches->nsample));
    TRY(TAKE(w->done, (size_t)wrenches->nsample));
    TRY(TAKE(w->largest, (size_t)c->nmaterial));
    TRY(TAKE(w->replaced, (size_t)c->nmaterial));
    for (int i = 0; i < wrenches->nsample; i++) {
        TRY(section_store_place(&w->store, wrenches->s[i], &w->place[i]));
    }

done:
    return st;
}

// the fields of the section at a place
static status solve(walk *w, const section_place *p, section_fields *out)
{
    status st = OK;
    const section_case *c = w->store.request;
    const material *materials = section_store_materials(&w->store, p->s);
    mesh m = {0};
    beam_law unused = {0};
    section_warping warping = {0};
    TRY(section_place_mesh(c, p, &c->mesh, &m));
    if (c->model == MODEL_CLASSICAL) {
        mat6 K;
        law_along_at(w->law, p->s, &K, NULL);
        TRY(section_fields_classical(&m, materials, &K, out));
    } else {
        TRY(section_turning_mesh(&m, materials, p->turn_rate, &unused, &warping));
        TRY(section_fields_make(&m, &warping, p->turn_rate, out));
    }

done:
    section_warping_free(&warping);
    mesh_free(&m);
    return st;
}

// The wrench that strains the known section a as `wrench` strains b: turned back, mirrored back,
// and for lengths of a.
static vec6 carried_back(const section_place *a, const section_place *b, const section_likeness *k,
                         const vec6 *wrench)
{
    // b is R(b.turn) mirrored R(-a.turn) a; without a mirror that is R(b.turn - a.turn)
    const mat3 Rb = mat3_rot_z(b->turn), Ra = mat3_rot_z(a->turn);
    const double flip = k->mirror ? -1 : 1, scale = 1 / (k->scale * k->scale);
    vec3 n = mat3_tmul_vec(Rb, (vec3){{wrench->a[0], wrench->a[1], wrench->a[2]}});
    vec3 m = mat3_tmul_vec(Rb, (vec3){{wrench->a[3], wrench->a[4], wrench->a[5]}});
    n.a[1] *= flip; // a mirror y -> -y: forces as lengths, moments the other way round
    m.a[0] *= flip;
    m.a[2] *= flip;
    n = mat3_mul_vec(Ra, vec3_scale(scale, n));
    m = mat3_mul_vec(Ra, vec3_scale(scale / k->scale, m));
    return (vec6){{n.a[0], n.a[1], n.a[2], m.a[0], m.a[1], m.a[2]}};
}

static vec3 carried_point(const section_place *a, const section_place *b, const section_likeness *k,
                          const double *at)
{
    vec3 x = mat3_tmul_vec(mat3_rot_z(a->turn), (vec3){{at[0], at[1], 0}});
    x.a[1] *= k->mirror ? -1 : 1;
    return mat3_mul_vec(mat3_rot_z(b->turn), vec3_scale(k->scale, x));
}

static void strain_sample(walk *w, const section_fields *f, const section_place *known,
                          const section_likeness *k, int sample)
{
    const section_place *here = &w->place[sample];
    const int nmaterial = w->store.request->nmaterial;
    for (int set = 0; set < w->wrenches->nset; set++) {
        section_strain_place *out = w->out + (size_t)set * (size_t)nmaterial;
        const vec6 *wrench =
            &w->wrenches->wrench[(size_t)set * (size_t)w->wrenches->nsample + (size_t)sample];
        const vec6 back = carried_back(known, here, k, wrench);
        for (int m = 0; m < nmaterial; m++) {
            w->largest[m].value = out[m].value;
            w->replaced[m] = false;
        }
        section_largest_strain(f, &back, w->largest, w->replaced);
        for (int m = 0; m < nmaterial; m++) {
            if (w->replaced[m]) {
                const vec3 x = carried_point(known, here, k, w->largest[m].at);
                out[m] = (section_strain_place){w->largest[m].value, here->s, {x.a[0], x.a[1]}};
            }
        }
    }
}

// one solve, and every sample that it serves
static status serve(walk *w, int first)
{
    status st = OK;
    section_fields f = {0};
    TRY(solve(w, &w->place[first], &f));
    for (int i = 0; i < w->wrenches->nsample; i++) {
        section_likeness k = {0};
        bool alike = false;
        if (!w->done[i]) {
            TRY(section_store_alike(&w->store, &w->place[first], &w->place[i], &k, &alike));
        }
        if (alike) {
            strain_sample(w, &f, &w->place[first], &k, i);
            w->done[i] = true;
        }
    }

done:
    section_fields_free(&f);
    return st;
}

status section_strain_along(const section_case *c, const material *materials, const law_along *law,
                            const section_wrenches_along *wrenches, section_strain_place *out)
{
    status st = OK;
    walk w = {0};
    const int last = wrenches->nsample - 1, most = SECTION_STRAIN_SOLVES - 1;
    TRY(walk_make(c, materials, law, wrenches, &w));
    w.out = out;
    for (int i = 0; i <= most; i++) {
        const int sample = (int)((long)last * i / most);
        TRY(w.done[sample] ? OK : serve(&w, sample));
    }

done:
    walk_free(&w);
    return st;
}
