#include "section/warping.h"

#include "base/beam_law.h"
#include "base/memory.h"
#include "section/strains.h"

#include <string.h>

enum { MOST = ELEMENT_MAX_PLANE_NODES };

void warping_problem_free(warping_problem *p)
{
    plane_free(&p->plane);
    matter_free(&p->matter);
    stiffness_free(&p->E);
    free(p->R);
    free(p->wave);
    *p = (warping_problem){0};
}

mat6 warping_transport(double rate)
{
    mat6 T = {0};
    T.a[MX][NY] = 1;
    T.a[MY][NX] = -1;
    T.a[NX][NY] = T.a[MX][MY] = rate;
    T.a[NY][NX] = T.a[MY][MX] = -rate;
    return T;
}

// --- R and A

// one element's columns, by node: [nnode][KEPT][3]
typedef struct rigid_forces {
    double R[MOST][KEPT][3], L[MOST][KEPT][3]; // L with the rate
} rigid_forces;

static void add_mass(warping_problem *p, const plane_element *e)
{
    const double density = p->matter.materials[e->material].density;
    for (int q = 0; q < e->npoint; q++) {
        mass_add(&p->mass, density, e->dA[q], e->x[q] * e->dA[q], e->y[q] * e->dA[q]);
    }
}

static void add_rigid_part(warping_problem *p, const plane_element *e, matter_element *at,
                           rigid_forces *local)
{
    for (int q = 0; q < e->npoint; q++) {
        const double x = e->x[q], y = e->y[q];
        const mat6 SZ = rigid_strains(x, y);
        double stress[36];
        multiply_stiffness(matter_stiffness(&p->matter, &p->plane, e, q, at), 6, SZ.a[0], stress);
        add_resultants(6, x, y, at->weight[q], stress, p->A.a[0]);
        p->area += e->dA[q];
        for (int i = 0; i < e->nnode; i++) {
            const node_values v = node_at(e, q, i, p->rate);
            for (int k = 0; k < KEPT; k++) {
                add_node_force(&v, p->rate, at->weight[q], 6, FIRST_KEPT + k, stress,
                               local->R[i][k]);
                add_slope_force(v.N, p->rate * at->weight[q], 6, FIRST_KEPT + k, stress,
                                local->L[i][k]);
            }
        }
    }
}

static void scatter_rigid_part(warping_problem *p, const plane_element *e,
                               const rigid_forces *local)
{
    const size_t n = 3 * (size_t)p->E.nnode;
    for (int i = 0; i < e->nnode; i++) {
        for (int c = 0; c < 3; c++) {
            const size_t u = (size_t)stiffness_unknown(&p->E, e->node[i], c);
            for (size_t k = 0; k < KEPT; k++) {
                p->R[k * n + u] += local->R[i][k][c];
                if (p->wave) {
                    p->wave[2 * (k * n + u)] += local->R[i][k][c];
                    p->wave[2 * (k * n + u) + 1] -= local->L[i][k][c];
                }
            }
        }
    }
}

// --- elements

static status add_elements(warping_problem *p, element_blocks *blocks)
{
    status st = OK;
    const mesh *m = p->plane.mesh;
    const channel_strains channels = channel_strains_make(p->rate);
    for (int b = 0; b < m->nblock; b++) {
        for (int k = 0; k < m->block[b].nelem; k++) {
            plane_element e;
            matter_element at;
            rigid_forces local = {0};
            TRY(plane_element_at(&p->plane, b, k, &e));
            TRY(matter_at(&p->matter, &p->plane, &e, &at));
            kernel_blocks(&p->matter, &p->plane, &e, &at, &channels, blocks);
            stiffness_add(&p->E, &e, blocks);
            add_rigid_part(p, &e, &at, &local);
            scatter_rigid_part(p, &e, &local);
            add_mass(p, &e);
        }
    }

done:
    return st;
}

static void clear_pins(const warping_problem *p)
{
    const size_t n = 3 * (size_t)p->E.nnode;
    for (size_t k = 0; k < KEPT; k++) {
        for (int i = 0; i < 4; i++) {
            const size_t u = k * n + (size_t)p->pins.unknown[i];
            p->R[u] = 0;
            if (p->wave) {
                p->wave[2 * u] = p->wave[2 * u + 1] = 0;
            }
        }
    }
}

static status take_matrices(warping_problem *p)
{
    status st = OK;
    const mesh *m = p->plane.mesh;
    const bool turning = p->rate != 0;
    TRY(stiffness_make(m, !turning && !p->matter.coupled, turning, &p->E));
    TRY(TAKE(p->R, 3 * KEPT * (size_t)m->nnode));
    if (turning) {
        TRY(TAKE(p->wave, 6 * KEPT * (size_t)m->nnode));
    }

done:
    return st;
}

status warping_problem_make(const mesh *m, const material *materials, double rate,
                            warping_problem *out)
{
    status st = OK;
    element_blocks *blocks = NULL;
    warping_problem p = {0};

    // the energy of the straight element has degree 2 p; p + 1 points each way keep order 2 p on
    // curved ones, and are the 2 x 2 rule of the bilinear quad
    TRY(plane_make(m, 2 * m->order + 1, &p.plane));
    p.rate = rate * p.plane.length;
    if (rate != 0) {
        plane_use_origin(&p.plane); // about which the pattern turns
    }
    TRY(matter_make(m, materials, &p.matter));
    TRY(take_matrices(&p));
    TRY(TAKE(blocks, 1));
    TRY(add_elements(&p, blocks));
    p.A = mat6_symmetric(p.A);
    p.pins = stiffness_choose_pins(&p.E, &p.plane);
    stiffness_pin(&p.E, &p.pins);
    clear_pins(&p);
    *out = p;
    p = (warping_problem){0};

done:
    free(blocks);
    warping_problem_free(&p);
    return st;
}
