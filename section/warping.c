// section/warping.c
#include "section/warping.h"

#include "base/beam_law.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

enum { XX, YY, ZZ, YZ, XZ, XY };

void warping_problem_free(warping_problem *p)
{
    plane_free(&p->plane);
    stiffness_free(&p->E);
    free(p->R);
    *p = (warping_problem){0};
}

// S Z of docs/theory.md (2.1) and (3.1): strains of unit generalized strains
static mat6 rigid_strains(double x, double y)
{
    mat6 SZ = {0};
    SZ.a[XZ][NX] = SZ.a[YZ][NY] = SZ.a[ZZ][NZ] = 1;
    SZ.a[ZZ][MX] = y;
    SZ.a[ZZ][MY] = -x;
    SZ.a[XZ][MZ] = -y;
    SZ.a[YZ][MZ] = x;
    return SZ;
}

static mat6 scaled_stiffness(const warping_problem *p, int index)
{
    return mat6_scale(1 / p->modulus, material_stiffness(&p->materials[index]));
}

// --- E, R, A

// (B_i)^T stress, the node's share of the in-plane derivatives
static void add_gradient_part(const double *stress, int stride, double Nx, double Ny, double *to)
{
    to[0] += Nx * stress[XX * stride] + Ny * stress[XY * stride];
    to[1] += Ny * stress[YY * stride] + Nx * stress[XY * stride];
    to[2] += Nx * stress[XZ * stride] + Ny * stress[YZ * stride];
}

// R is gathered per node first: [nnode of the element][6][3]
static void add_rigid_part(warping_problem *p, const plane_element *e, const mat6 *Q, double *R)
{
    const int n = e->nnode;
    for (int q = 0; q < e->npoint; q++) {
        const mat6 SZ = rigid_strains(e->x[q], e->y[q]);
        const mat6 stress = mat6_scale(e->dA[q], mat6_mul(*Q, SZ));
        p->A = mat6_add(p->A, mat6_mul(mat6_transpose(SZ), stress));
        p->area += e->dA[q];
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < 6; k++) {
                add_gradient_part(&stress.a[0][k], 6, e->Nx[q * n + i], e->Ny[q * n + i],
                                  R + 18 * i + 3 * k);
            }
        }
    }
}

static void scatter(const warping_problem *p, const plane_element *e, int ncolumn,
                    const double *local, double *global)
{
    const int nnode = p->E.nnode;
    for (int i = 0; i < e->nnode; i++) {
        for (int k = 0; k < ncolumn; k++) {
            for (int c = 0; c < 3; c++) {
                global[(size_t)k * (size_t)(3 * nnode) +
                       (size_t)warping_unknown(nnode, e->node[i], c)] +=
                    local[3 * ncolumn * i + 3 * k + c];
            }
        }
    }
}

static void clear_pins(const warping_problem *p, int ncolumn, double *global)
{
    for (int k = 0; k < ncolumn; k++) {
        for (int i = 0; i < 4; i++) {
            global[(size_t)k * (size_t)(3 * p->E.nnode) + (size_t)p->pins.unknown[i]] = 0;
        }
    }
}

static status add_elements(warping_problem *p)
{
    status st = OK;
    const mesh *m = p->plane.mesh;
    double local[ELEMENT_MAX_PLANE_NODES * 18];
    for (int b = 0; b < m->nblock; b++) {
        for (int k = 0; k < m->block[b].nelem; k++) {
            plane_element e;
            TRY(plane_element_at(&p->plane, b, k, &e));
            const mat6 Q = scaled_stiffness(p, e.material);
            stiffness_add(&p->E, &e, Q.a[XX][YY], Q.a[XY][XY]);
            memset(local, 0, sizeof local);
            add_rigid_part(p, &e, &Q, local);
            scatter(p, &e, 6, local, p->R);
        }
    }

done:
    return st;
}

static double largest_modulus(const mesh *m, const material *materials)
{
    double most = 0;
    for (int b = 0; b < m->nblock; b++) {
        for (int k = 0; k < m->block[b].nelem; k++) {
            most = fmax(most, materials[m->block[b].material[k]].E);
        }
    }
    return most;
}

status warping_problem_make(const mesh *m, const material *materials, warping_problem *out)
{
    status st = OK;
    warping_problem p = {.materials = materials, .modulus = largest_modulus(m, materials)};

    // the energy of the straight element has degree 2 p; p + 1 points each way keep order 2 p on
    // curved ones, and are the 2 x 2 rule of the bilinear quad
    TRY(plane_make(m, 2 * m->order + 1, &p.plane));
    TRY(stiffness_make(m, &p.E));
    TRY(TAKE(p.R, 18 * (size_t)m->nnode));
    TRY(add_elements(&p));
    p.A = mat6_symmetric(p.A);
    p.pins = stiffness_choose_pins(&p.plane);
    stiffness_pin(&p.E, &p.pins);
    clear_pins(&p, 6, p.R);
    *out = p;
    p = (warping_problem){0};

done:
    warping_problem_free(&p);
    return st;
}

// --- fields at a quadrature point

// sum N_i field_i, nodal fields of `width` numbers
static void gather(const plane_element *e, const double *N, int width, const double *field,
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

// B w, from the derivatives [3][ncolumn] along x and y
static void add_gradient_strains(int ncolumn, const double *wx, const double *wy, double *strain)
{
    const int n = ncolumn;
    for (int k = 0; k < n; k++) {
        strain[XX * n + k] += wx[k];
        strain[YY * n + k] += wy[n + k];
        strain[YZ * n + k] += wy[2 * n + k];
        strain[XZ * n + k] += wx[2 * n + k];
        strain[XY * n + k] += wy[k] + wx[n + k];
    }
}

// S N w', from the values [3][ncolumn]
static void add_slope_strains(int ncolumn, const double *dw, double *strain)
{
    const int n = ncolumn;
    for (int k = 0; k < n; k++) {
        strain[XZ * n + k] += dw[k];
        strain[YZ * n + k] += dw[n + k];
        strain[ZZ * n + k] += dw[2 * n + k];
    }
}

// [6][ncolumn] = m [6][6] times [6][ncolumn]
static void multiply(const mat6 *m, int ncolumn, const double *in, double *out)
{
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < ncolumn; k++) {
            double sum = 0;
            for (int j = 0; j < 6; j++) {
                sum += m->a[i][j] * in[j * ncolumn + k];
            }
            out[i * ncolumn + k] = sum;
        }
    }
}

// --- right-hand sides of the second system

// one element's share, local [nnode][2][3]
static void second_sides(const plane_element *e, const mat6 *Q, const double *dw, double dpsi[6][2],
                         double *local, double moved[6][2])
{
    const int n = e->nnode;
    for (int q = 0; q < e->npoint; q++) {
        double wx[6], wy[6], value[6], strain[12], stress[12], slope[12] = {0}, slope_stress[12];
        const mat6 SZ = rigid_strains(e->x[q], e->y[q]), SZt = mat6_transpose(SZ);
        gather(e, e->Nx + q * n, 6, dw, wx);
        gather(e, e->Ny + q * n, 6, dw, wy);
        gather(e, e->N + q * n, 6, dw, value);

        multiply(&SZ, 2, dpsi[0], strain);
        add_gradient_strains(2, wx, wy, strain);
        multiply(Q, 2, strain, stress);
        add_slope_strains(2, value, slope);
        multiply(Q, 2, slope, slope_stress);

        double share[12];
        multiply(&SZt, 2, slope_stress, share);
        for (int k = 0; k < 12; k++) {
            moved[k / 2][k % 2] += e->dA[q] * share[k];
        }
        for (int i = 0; i < n; i++) {
            const double a = e->dA[q], N = a * e->N[q * n + i];
            for (int k = 0; k < 2; k++) {
                double *to = local + 6 * i + 3 * k;
                to[0] += N * stress[XZ * 2 + k];
                to[1] += N * stress[YZ * 2 + k];
                to[2] += N * stress[ZZ * 2 + k];
                add_gradient_part(slope_stress + k, 2, -a * e->Nx[q * n + i], -a * e->Ny[q * n + i],
                                  to);
            }
        }
    }
}

status warping_second_sides(warping_problem *p, const double *dw, double dpsi[6][2], double *right,
                            double moved[6][2])
{
    status st = OK;
    const mesh *m = p->plane.mesh;
    double local[ELEMENT_MAX_PLANE_NODES * 6];
    memset(right, 0, 6 * (size_t)m->nnode * sizeof *right);
    memset(moved, 0, 12 * sizeof(double));
    for (int b = 0; b < m->nblock; b++) {
        for (int k = 0; k < m->block[b].nelem; k++) {
            plane_element e;
            TRY(plane_element_at(&p->plane, b, k, &e));
            const mat6 Q = scaled_stiffness(p, e.material);
            memset(local, 0, sizeof local);
            second_sides(&e, &Q, dw, dpsi, local, moved);
            scatter(p, &e, 2, local, right);
        }
    }
    clear_pins(p, 2, right);

done:
    return st;
}

// --- energy

static void element_energy(const plane_element *e, const mat6 *Q, const double *w, const double *dw,
                           const mat6 *psi, mat6 *F, mat6 *resultant)
{
    const int n = e->nnode;
    for (int q = 0; q < e->npoint; q++) {
        double wx[18], wy[18], value[18];
        const mat6 SZ = rigid_strains(e->x[q], e->y[q]);
        mat6 strain = mat6_mul(SZ, *psi);
        gather(e, e->Nx + q * n, 18, w, wx);
        gather(e, e->Ny + q * n, 18, w, wy);
        gather(e, e->N + q * n, 18, dw, value);
        add_gradient_strains(6, wx, wy, strain.a[0]);
        add_slope_strains(6, value, strain.a[0]);
        const mat6 stress = mat6_scale(e->dA[q], mat6_mul(*Q, strain));
        *F = mat6_add(*F, mat6_mul(mat6_transpose(strain), stress));
        *resultant = mat6_add(*resultant, mat6_mul(mat6_transpose(SZ), stress));
    }
}

status warping_energy(warping_problem *p, const double *w, const double *dw, const mat6 *psi,
                      mat6 *F, mat6 *resultant)
{
    status st = OK;
    const mesh *m = p->plane.mesh;
    *F = *resultant = (mat6){0};
    for (int b = 0; b < m->nblock; b++) {
        for (int k = 0; k < m->block[b].nelem; k++) {
            plane_element e;
            TRY(plane_element_at(&p->plane, b, k, &e));
            const mat6 Q = scaled_stiffness(p, e.material);
            element_energy(&e, &Q, w, dw, psi, F, resultant);
        }
    }
    *F = mat6_symmetric(*F);

done:
    return st;
}
