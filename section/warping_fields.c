// What follows from nodal fields: the right-hand sides of the second system, and the energy.
#include "base/beam_law.h"
#include "section/strains.h"
#include "section/warping.h"

#include <string.h>

enum { MOST = ELEMENT_MAX_PLANE_NODES };

// sum N_i field_i, nodal fields of `width` numbers
static inline void gather(const plane_element *e, const double *N, int width, const double *field,
                          double *out)
{
    memset(out, 0, (size_t)width * sizeof *out);
    for (int i = 0; i < e->nnode; i++) {
        const double c = N[i], *from = field + (size_t)e->node[i] * (size_t)width;
        for (int k = 0; k < width; k++) {
            out[k] += c * from[k];
        }
    }
}

// --- right-hand sides of the second system

// With S N w and the strains of the first field, (3.14) is int N^T S^T stress - B^T slope_stress.
static void second_stresses(double rate, double x, double y, const double *w, const double *wx,
                            const double *wy, const mat6 *Q, double psi[6][2], double *stress,
                            double *slope_stress)
{
    double strain[12], slope[12] = {0}, turned[6];
    for (int c = 0; c < 3; c++) { // i k w
        turned[2 * c] = -rate * w[2 * c + 1];
        turned[2 * c + 1] = rate * w[2 * c];
    }
    set_rigid_strains(2, x, y, psi[0], strain);
    add_warping_strains(2, rate, x, y, w, wx, wy, strain);
    add_slope_strains(2, 2, turned, strain);
    multiply_stiffness(Q, 2, strain, stress);
    add_slope_strains(2, 1, w, slope);
    multiply_stiffness(Q, 2, slope, slope_stress);
}

// one element's share, local [nnode][2][3]
static void second_sides(const warping_problem *p, const plane_element *e, matter_element *at,
                         const double *w, double psi[6][2], double local[MOST][2][3],
                         double moved[6][2])
{
    const int n = e->nnode;
    for (int q = 0; q < e->npoint; q++) {
        double wx[6], wy[6], value[6], stress[12], slope_stress[12];
        const double x = e->x[q], y = e->y[q], c = at->weight[q];
        const mat6 *Q = matter_stiffness(&p->matter, &p->plane, e, q, at);
        gather(e, e->Nx + q * n, 6, w, wx);
        gather(e, e->Ny + q * n, 6, w, wy);
        gather(e, e->N + q * n, 6, w, value);
        second_stresses(p->rate, x, y, value, wx, wy, Q, psi, stress, slope_stress);
        add_resultants(2, x, y, c, slope_stress, moved[0]);
        for (int i = 0; i < n; i++) {
            const node_values v = node_at(e, q, i, p->rate);
            for (int k = 0; k < 2; k++) {
                add_slope_force(v.N, c, 2, k, stress, local[i][k]);
                add_node_force(&v, p->rate, -c, 2, k, slope_stress, local[i][k]);
            }
        }
    }
}

static void scatter(const warping_problem *p, const plane_element *e, double local[MOST][2][3],
                    double *right)
{
    for (int i = 0; i < e->nnode; i++) {
        for (int c = 0; c < 3; c++) {
            double *to = right + 2 * (size_t)stiffness_unknown(&p->E, e->node[i], c);
            to[0] += local[i][0][c];
            to[1] += local[i][1][c];
        }
    }
}

status warping_second_sides(warping_problem *p, const double *w, double psi[6][2], double *right,
                            double moved[6][2])
{
    status st = OK;
    const mesh *m = p->plane.mesh;
    memset(right, 0, 6 * (size_t)m->nnode * sizeof *right);
    memset(moved, 0, 12 * sizeof(double));
    for (int b = 0; b < m->nblock; b++) {
        for (int k = 0; k < m->block[b].nelem; k++) {
            plane_element e;
            matter_element at;
            double local[MOST][2][3] = {{{0}}};
            TRY(plane_element_at(&p->plane, b, k, &e));
            TRY(matter_at(&p->matter, &p->plane, &e, &at));
            second_sides(p, &e, &at, w, psi, local, moved);
            scatter(p, &e, local, right);
        }
    }
    for (int i = 0; i < 4; i++) {
        right[2 * p->pins.unknown[i]] = right[2 * p->pins.unknown[i] + 1] = 0;
    }

done:
    return st;
}

// --- energy

// w T_k, of the values [3][6] at a point
static inline void move_along(double rate, const double *w, double *dw)
{
    for (int c = 0; c < 3; c++) {
        const double *v = w + 6 * c;
        const double slope[6] = {-rate * v[NY] - v[MY], rate * v[NX] + v[MX], 0,
                                 -rate * v[MY],         rate * v[MX],         0};
        memcpy(dw + 6 * c, slope, sizeof slope);
    }
}

static inline void add_energy(double c, const double *strain, const double *stress, double *F)
{
    for (int r = 0; r < 6; r++) {
        for (int i = 0; i < 6; i++) {
            const double a = c * strain[6 * r + i];
            for (int j = 0; j < 6; j++) {
                F[6 * i + j] += a * stress[6 * r + j];
            }
        }
    }
}

static void element_energy(const warping_problem *p, const plane_element *e, matter_element *at,
                           const double *w, const mat6 *psi, double *F, double *resultant)
{
    const int n = e->nnode;
    for (int q = 0; q < e->npoint; q++) {
        double wx[18], wy[18], value[18], slope[18], strain[36], stress[36];
        const double x = e->x[q], y = e->y[q], c = at->weight[q];
        gather(e, e->Nx + q * n, 18, w, wx);
        gather(e, e->Ny + q * n, 18, w, wy);
        gather(e, e->N + q * n, 18, w, value);
        move_along(p->rate, value, slope);
        set_rigid_strains(6, x, y, psi->a[0], strain);
        add_warping_strains(6, p->rate, x, y, value, wx, wy, strain);
        add_slope_strains(6, 1, slope, strain);
        multiply_stiffness(matter_stiffness(&p->matter, &p->plane, e, q, at), 6, strain, stress);
        add_energy(c, strain, stress, F);
        add_resultants(6, x, y, c, stress, resultant);
    }
}

status warping_energy(warping_problem *p, const double *w, const mat6 *psi, mat6 *F,
                      mat6 *resultant)
{
    status st = OK;
    const mesh *m = p->plane.mesh;
    *F = *resultant = (mat6){0};
    for (int b = 0; b < m->nblock; b++) {
        for (int k = 0; k < m->block[b].nelem; k++) {
            plane_element e;
            matter_element at;
            TRY(plane_element_at(&p->plane, b, k, &e));
            TRY(matter_at(&p->matter, &p->plane, &e, &at));
            element_energy(p, &e, &at, w, psi, F->a[0], resultant->a[0]);
        }
    }
    *F = mat6_symmetric(*F);

done:
    return st;
}
