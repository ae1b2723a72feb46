// section/strain_along.c
#include "section/strain_along.h"

#include "base/memory.h"
#include "section/extremes.h"
#include "section/reuse.h"

#include <math.h>
#include <string.h>

struct strains_along {
    int nsample, nmaterial, nsolve;
    section_place *place;                         // [nsample]
    section_fields fields[SECTION_STRAIN_SOLVES]; // [nsolve]
    int first[SECTION_STRAIN_SOLVES];             // the sample whose section was solved
    int *served;                                  // [nsample] by this solve, -1: by none
    section_likeness *likeness;                   // [nsample]
};

void strains_along_free(strains_along *k)
{
    if (!k) {
        return;
    }
    for (int i = 0; k->place && i < k->nsample; i++) {
        section_place_free(&k->place[i]);
    }
    for (int i = 0; i < k->nsolve; i++) {
        section_fields_free(&k->fields[i]);
    }
    free(k->place);
    free(k->served);
    free(k->likeness);
    free(k);
}

// the fields of the section at a place
static status solve(section_store *store, const law_along *law, const section_place *p,
                    section_fields *out)
{
    status st = OK;
    const section_case *c = store->request;
    const material *materials = section_store_materials(store, p->s);
    mesh m = {0};
    beam_law unused = {0};
    section_warping warping = {0};
    TRY(section_place_mesh(c, p, &c->mesh, &m));
    if (c->model == MODEL_CLASSICAL) {
        mat6 K;
        law_along_at(law, p->s, &K, NULL);
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

// one solve, and every sample that it serves
static status serve(section_store *store, const law_along *law, strains_along *k, int first)
{
    status st = OK;
    const int solve_of = k->nsolve;
    TRY(solve(store, law, &k->place[first], &k->fields[solve_of]));
    k->first[k->nsolve++] = first;
    for (int i = 0; i < k->nsample; i++) {
        bool alike = false;
        if (k->served[i] < 0) {
            TRY(section_store_alike(store, &k->place[first], &k->place[i], &k->likeness[i],
                                    &alike));
        }
        k->served[i] = alike ? solve_of : k->served[i];
    }

done:
    return st;
}

static status take_room(int nsample, int nmaterial, strains_along **out)
{
    status st = OK;
    strains_along *k = NULL;
    TRY(TAKE(k, 1));
    k->nsample = nsample;
    k->nmaterial = nmaterial;
    *out = k;
    TRY(TAKE(k->place, (size_t)nsample));
    TRY(TAKE(k->served, (size_t)nsample));
    TRY(TAKE(k->likeness, (size_t)nsample));

done:
    return st;
}

status strains_along_make(const section_case *c, const material *materials, const law_along *law,
                          int nsample, const double *s, strains_along **out)
{
    status st = OK;
    const int most = SECTION_STRAIN_SOLVES - 1;
    section_store store = {0};
    strains_along *k = NULL;
    TRY(take_room(nsample, c->nmaterial, &k));
    TRY(section_store_make(c, materials, law->length, &store));
    for (int i = 0; i < nsample; i++) {
        k->served[i] = -1;
        TRY(section_store_place(&store, s[i], &k->place[i]));
    }
    for (int i = 0; i <= most; i++) {
        const int sample = (int)((long)(nsample - 1) * i / most);
        TRY(k->served[sample] >= 0 ? OK : serve(&store, law, k, sample));
    }
    *out = k;
    k = NULL;

done:
    strains_along_free(k);
    section_store_free(&store);
    return st;
}

// --- for a wrench

// what the solve says of one of its samples
static void strain_sample(const strains_along *k, int sample, const vec6 *wrench,
                          section_extreme *largest, bool *replaced, section_strain_place *out)
{
    const section_place *here = &k->place[sample], *known = &k->place[k->first[k->served[sample]]];
    const section_likeness *like = &k->likeness[sample];
    const vec6 back = carried_back(known, here, like, wrench);
    for (int m = 0; m < k->nmaterial; m++) {
        largest[m].value = out[m].value;
        replaced[m] = false;
    }
    section_largest_strain(&k->fields[k->served[sample]], &back, largest, replaced);
    for (int m = 0; m < k->nmaterial; m++) {
        if (replaced[m]) {
            const vec3 x = carried_point(known, here, like, largest[m].at);
            out[m] = (section_strain_place){largest[m].value, here->s, {x.a[0], x.a[1]}};
        }
    }
}

status strains_along_at(const strains_along *k, const vec6 *wrench, section_strain_place *out)
{
    status st = OK;
    section_extreme *largest = NULL;
    bool *replaced = NULL;
    TRY(TAKE(largest, (size_t)k->nmaterial));
    TRY(TAKE(replaced, (size_t)k->nmaterial));
    memset(out, 0, (size_t)k->nmaterial * sizeof *out);
    for (int solved = 0; solved < k->nsolve; solved++) {
        for (int i = 0; i < k->nsample; i++) {
            if (k->served[i] == solved) {
                strain_sample(k, i, &wrench[i], largest, replaced, out);
            }
        }
    }

done:
    free(largest);
    free(replaced);
    return st;
}

status section_strain_along(const section_case *c, const material *materials, const law_along *law,
                            const section_wrenches_along *wrenches, section_strain_place *out)
{
    status st = OK;
    strains_along *k = NULL;
    TRY(strains_along_make(c, materials, law, wrenches->nsample, wrenches->s, &k));
    for (int set = 0; set < wrenches->nset; set++) {
        TRY(strains_along_at(k, wrenches->wrench + (size_t)set * (size_t)wrenches->nsample,
                             out + (size_t)set * (size_t)c->nmaterial));
    }

done:
    strains_along_free(k);
    return st;
}
