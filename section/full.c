// section/full.c
#include "base/memory.h"
#include "section/section.h"
#include "section/warping.h"

#include <math.h>
#include <string.h>

// What rounding may put the compliance off by, relative as in (6.1), judged by how far the stresses
// miss the unit wrenches. The equations make the two equal, so what remains is the rounding of the
// matrix and its solves: 1e-13 in sound sections, and more as moduli or lengths grow apart. It goes
// into the law's error; beyond this rounding has taken over.
static const double rounding_limit = 1e-2;

typedef struct full_solution {
    int nnode;
    double *w, *dw; // [nnode][3][6]
    mat6 psi, dpsi;
} full_solution;

static void full_solution_free(full_solution *s)
{
    free(s->w);
    free(s->dw);
    *s = (full_solution){0};
}

// E^-1 of columns [ncolumn][3 nnode], one factorization for all of them
typedef struct full_work {
    cholesky *factor;
    int *permutation;
    double *X;      // [6][3 nnode] E^-1 R
    double *Y;      // [2][3 nnode] E^-1 of the second right-hand sides
    double *slopes; // [nnode][3][2] w' of the columns n_x and n_y
    mat6 S; // A - R^T E^-1 R without the shears, which E relaxes to nothing; their diagonal is 1
} full_work;

static void full_work_free(full_work *f)
{
    cholesky_free(f->factor);
    free(f->permutation);
    free(f->X);
    free(f->Y);
    free(f->slopes);
}

static double dot(int n, const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < n; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

// The six rigid motions that strain nothing: translations and the turn about z have psi = 0 and are
// held by the pins; a tilt w_z = x or y goes with a shear psi of -1, so psi_nx = psi_ny = 0 holds
// it. Four columns of R remain.
static status factor_and_condense(warping_problem *p, full_work *f)
{
    status st = OK;
    const int n = 3 * p->E.nnode;
    TRY(TAKE(f->permutation, (size_t)n));
    TRY(TAKE(f->X, 6 * (size_t)n));
    TRY(TAKE(f->Y, 2 * (size_t)n));
    TRY(TAKE(f->slopes, 2 * (size_t)n));
    TRY(stiffness_order(&p->E, f->permutation));
    TRY(cholesky_make(&p->E.matrix, f->permutation, &f->factor));
    TRY(cholesky_solve(f->factor, 4, p->R + 2 * (size_t)n, f->X + 2 * (size_t)n));
    f->S = mat6_identity();
    for (int i = 2; i < 6; i++) {
        for (int j = 2; j < 6; j++) {
            f->S.a[i][j] =
                p->A.a[i][j] - dot(n, p->R + (size_t)i * (size_t)n, f->X + (size_t)j * (size_t)n);
        }
    }
    if (!mat6_inverse_spd(mat6_symmetric(f->S), &f->S)) {
        TRY(status_fail(ERR_NUMERIC, "section: its stretching, bending and twisting stiffness is "
                                     "not positive definite"));
    }

done:
    return st;
}

// (3.2): only the transverse forces change the wrench along the rod
static mat6 end_wrench_slope(void)
{
    mat6 T = {0};
    T.a[MX][NY] = 1;
    T.a[MY][NX] = -1;
    return T;
}

// psi = S^-1 right without the shears
static mat6 condensed_strains(const full_work *f, mat6 right)
{
    for (int k = 0; k < 6; k++) {
        right.a[NX][k] = right.a[NY][k] = 0;
    }
    return mat6_mul(f->S, right);
}

// nodal field [nnode][3][ncolumn] = Y - X psi, where Y [ncolumn][3 nnode] may be NULL
static void nodal_field(int nnode, int ncolumn, const double *X, const mat6 *psi, const double *Y,
                        double *out)
{
    const size_t n = 3 * (size_t)nnode;
    for (int i = 0; i < nnode; i++) {
        for (int c = 0; c < 3; c++) {
            const size_t u = (size_t)warping_unknown(nnode, i, c);
            for (int k = 0; k < ncolumn; k++) {
                double sum = Y && k < 2 ? Y[(size_t)k * n + u] : 0;
                for (int j = 2; j < 6; j++) {
                    sum -= X[(size_t)j * n + u] * psi->a[j][k];
                }
                out[(3 * i + c) * ncolumn + k] = sum;
            }
        }
    }
}

static status solve_columns(warping_problem *p, full_work *f, full_solution *s)
{
    status st = OK;
    const int nnode = p->E.nnode, n = 3 * nnode;
    double dpsi[6][2], moved[6][2];
    s->nnode = nnode;
    TRY(TAKE(s->w, 6 * (size_t)n));
    TRY(TAKE(s->dw, 6 * (size_t)n));

    // (3.3): psi' = S^-1 T, w' = -X psi'
    s->dpsi = condensed_strains(f, end_wrench_slope());
    nodal_field(nnode, 6, f->X, &s->dpsi, NULL, s->dw);
    nodal_field(nnode, 2, f->X, &s->dpsi, NULL, f->slopes);
    for (int i = 0; i < 6; i++) {
        dpsi[i][0] = s->dpsi.a[i][NX];
        dpsi[i][1] = s->dpsi.a[i][NY];
    }

    // (3.4): psi = S^-1 (1 - L^T w' - R^T Y), w = Y - X psi
    TRY(warping_second_sides(p, f->slopes, dpsi, f->Y, moved));
    TRY(cholesky_solve(f->factor, 2, f->Y, f->Y));
    mat6 right = mat6_identity();
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < 2; k++) {
            right.a[i][k] -=
                moved[i][k] + dot(n, p->R + (size_t)i * (size_t)n, f->Y + (size_t)k * (size_t)n);
        }
    }
    s->psi = condensed_strains(f, right);
    nodal_field(nnode, 6, f->X, &s->psi, f->Y, s->w);

done:
    return st;
}

// The stresses make the wrenches I + D instead of I. Rounding of a stiff direction's stresses is
// rounding of a soft one's strains, and the other way round: D counts by the larger ratio of the
// two compliances. Strips 1e3 to 3e3 times as long as thick have a third of it as their error.
static double compliance_error(mat6 F, mat6 resultant)
{
    double most = 0;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            const double ratio = sqrt(F.a[i][i] / F.a[j][j]);
            const double part = fabs(resultant.a[i][j] - (i == j)) * fmax(ratio, 1 / ratio);
            most = part <= most ? most : part; // a NaN must not look small
        }
    }
    return most;
}

// (3.5) and (3.6), and back to SI at the section's origin
static status law_from_energy(warping_problem *p, const full_solution *s, beam_law *out)
{
    status st = OK;
    mat6 F, K, resultant;
    TRY(warping_energy(p, s->w, s->dw, &s->psi, &F, &resultant));
    const double miss = compliance_error(F, resultant);
    if (!(miss <= rounding_limit)) {
        TRY(status_fail(ERR_NUMERIC,
                        "section: rounding puts its compliance off by %.1e: a wall is too thin for "
                        "the section's size, the materials are too far apart in stiffness, or "
                        "parts hang together by a point",
                        miss));
    }
    if (!mat6_inverse_spd(F, &K)) {
        TRY(status_fail(ERR_NUMERIC, "section: the compliance is not positive definite"));
    }
    const double a = p->plane.length, unit = p->modulus * a * a;
    for (int i = 0; i < 36; i++) {
        K.a[i / 6][i % 6] *= unit * (i / 6 < 3 ? 1 : a) * (i % 6 < 3 ? 1 : a);
    }
    *out = (beam_law){
        .K = beam_law_move(K, -p->plane.centre[0], -p->plane.centre[1], 0),
        .area = p->area * a * a,
        .relative_error = miss,
    };

done:
    return st;
}

void section_warping_free(section_warping *w)
{
    free(w->w);
    free(w->dw);
    *w = (section_warping){0};
}

// Unit wrenches at the section's origin, seen scaled at the centre: theta_c = P theta_o, column by
// column, and psi_o = P^T psi_c since both do the same work.
static mat6 wrench_at_centre(const plane *p, double modulus)
{
    const double a = p->length, x = p->centre[0], y = p->centre[1];
    const double force = 1 / (modulus * a * a), moment = force / a;
    mat6 P = {0};
    for (int i = 0; i < 6; i++) {
        P.a[i][i] = i < 3 ? force : moment;
    }
    // m_c = m_o - c x n
    P.a[MX][NZ] = -y * moment;
    P.a[MY][NZ] = x * moment;
    P.a[MZ][NX] = y * moment;
    P.a[MZ][NY] = -x * moment;
    return P;
}

// generalized strains of the scaled section at its centre -> SI at the origin, for the columns
// already combined by P
static mat6 strains_at_origin(const plane *p, mat6 psi)
{
    const double a = p->length, x = p->centre[0], y = p->centre[1];
    for (int k = 0; k < 6; k++) {
        double column[6];
        for (int i = 0; i < 6; i++) {
            column[i] = psi.a[i][k] / (i < 3 ? 1 : a);
        }
        psi.a[NX][k] = column[NX] + y * column[MZ];
        psi.a[NY][k] = column[NY] - x * column[MZ];
        psi.a[NZ][k] = column[NZ] - y * column[MX] + x * column[MY];
        psi.a[MX][k] = column[MX];
        psi.a[MY][k] = column[MY];
        psi.a[MZ][k] = column[MZ];
    }
    return psi;
}

static status warping_in_si(const warping_problem *p, const full_solution *s, section_warping *out)
{
    status st = OK;
    const int nnode = s->nnode;
    const mat6 P = wrench_at_centre(&p->plane, p->modulus);
    section_warping g = {.nnode = nnode};
    TRY(TAKE(g.w, 18 * (size_t)nnode));
    TRY(TAKE(g.dw, 18 * (size_t)nnode));
    for (int u = 0; u < 3 * nnode; u++) {
        for (int j = 0; j < 6; j++) {
            double w = 0, dw = 0;
            for (int i = 0; i < 6; i++) {
                w += s->w[6 * u + i] * P.a[i][j];
                dw += s->dw[6 * u + i] * P.a[i][j];
            }
            g.w[(size_t)j * 3 * (size_t)nnode + (size_t)u] = w * p->plane.length;
            g.dw[(size_t)j * 3 * (size_t)nnode + (size_t)u] = dw;
        }
    }
    g.psi = strains_at_origin(&p->plane, mat6_mul(s->psi, P));
    // per scaled length: one more division for the slopes
    g.dpsi = mat6_scale(1 / p->plane.length, strains_at_origin(&p->plane, mat6_mul(s->dpsi, P)));
    *out = g;
    g = (section_warping){0};

done:
    section_warping_free(&g);
    return st;
}

status section_full_mesh(const mesh *m, const material *materials, beam_law *out,
                         section_warping *warping)
{
    status st = OK;
    warping_problem p = {0};
    full_work f = {0};
    full_solution s = {0};

    TRY(warping_problem_make(m, materials, &p));
    TRY(factor_and_condense(&p, &f));
    TRY(solve_columns(&p, &f, &s));
    TRY(law_from_energy(&p, &s, out));
    if (warping) {
        TRY(warping_in_si(&p, &s, warping));
    }

done:
    full_solution_free(&s);
    full_work_free(&f);
    warping_problem_free(&p);
    return st;
}

status section_turning_mesh(const mesh *m, const material *materials, double turn_rate,
                            beam_law *out, section_warping *warping)
{
    (void)turn_rate;
    return section_full_mesh(m, materials, out, warping);
}
