#include "section/full.h"

#include "base/beam_law.h"
#include "base/memory.h"

void full_solution_free(full_solution *s)
{
    free(s->w);
    *s = (full_solution){0};
}

static double dot(size_t n, const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

// The six rigid motions that strain nothing: translations and the turn about z have psi = 0 and are
// held by the pins; a tilt w_z = x or y goes with a shear psi of -1, so psi_nx = psi_ny = 0 holds
// it. Four columns of R remain.
status full_condense(const warping_problem *p, const stiffness_factor *f, double *X, mat6 *S)
{
    status st = OK;
    const size_t n = 3 * (size_t)p->E.nnode;
    mat6 s = mat6_identity();
    TRY(stiffness_solve(f, KEPT, p->R, X));
    for (int i = 0; i < KEPT; i++) {
        for (int j = 0; j < KEPT; j++) {
            s.a[FIRST_KEPT + i][FIRST_KEPT + j] = p->A.a[FIRST_KEPT + i][FIRST_KEPT + j] -
                                                  dot(n, p->R + (size_t)i * n, X + (size_t)j * n);
        }
    }
    if (!mat6_inverse_spd(mat6_symmetric(s), S)) {
        TRY(status_fail(ERR_NUMERIC, "section: its stretching, bending and twisting stiffness is "
                                     "not positive definite"));
    }
    S->a[NX][NX] = S->a[NY][NY] = 0;

done:
    return st;
}

void full_set_column(const warping_problem *p, const double *X, int j, full_solution *s)
{
    const size_t n = 3 * (size_t)p->E.nnode;
    for (int i = 0; i < p->E.nnode; i++) {
        for (int c = 0; c < 3; c++) {
            const size_t u = (size_t)stiffness_unknown(&p->E, i, c);
            double sum = 0;
            for (size_t k = 0; k < KEPT; k++) {
                sum -= X[k * n + u] * s->psi.a[FIRST_KEPT + k][j];
            }
            s->w[6 * (3 * i + c) + j] = sum;
        }
    }
}

// the bending columns as pairs: m_x takes the place of the real part, m_y of the imaginary
static void bending_pair(const full_solution *s, double *w, double psi[6][2])
{
    for (int u = 0; u < 3 * s->nnode; u++) {
        w[2 * u] = s->w[6 * u + MX];
        w[2 * u + 1] = s->w[6 * u + MY];
    }
    for (int i = 0; i < 6; i++) {
        psi[i][0] = s->psi.a[i][MX];
        psi[i][1] = s->psi.a[i][MY];
    }
}

// (3.4): n_y makes the slopes of m_x, n_x those of -m_y. Y [2][3 nnode] is E^-1 of the right-hand
// sides.
static status add_shear_columns(warping_problem *p, const stiffness_factor *f, const double *X,
                                mat6 S, full_solution *s)
{
    status st = OK;
    const size_t n = 3 * (size_t)s->nnode;
    static const int column[2] = {NY, NX};
    static const double sign[2] = {1, -1};
    double psi[6][2], moved[6][2], *pair = NULL, *Y = NULL;
    TRY(TAKE(pair, 2 * n));
    TRY(TAKE(Y, 2 * n));
    bending_pair(s, Y, psi);
    TRY(warping_second_sides(p, Y, psi, pair, moved));
    for (size_t u = 0; u < 2 * n; u++) {
        Y[u % 2 * n + u / 2] = sign[u % 2] * pair[u];
    }
    TRY(stiffness_solve(f, 2, Y, Y));
    for (size_t k = 0; k < 2; k++) {
        vec6 right = {{0}};
        for (int i = 0; i < KEPT; i++) {
            right.a[FIRST_KEPT + i] =
                -sign[k] * moved[FIRST_KEPT + i][k] - dot(n, p->R + (size_t)i * n, Y + k * n);
        }
        right = mat6_mul_vec(S, right);
        for (int i = 0; i < 6; i++) {
            s->psi.a[i][column[k]] = right.a[i];
        }
        full_set_column(p, X, column[k], s);
        for (int i = 0; i < 3 * s->nnode; i++) {
            s->w[6 * i + column[k]] += Y[k * n + (size_t)stiffness_unknown(&p->E, i / 3, i % 3)];
        }
    }

done:
    free(pair);
    free(Y);
    return st;
}

status full_solve_prismatic(warping_problem *p, full_solution *s)
{
    status st = OK;
    stiffness_factor f = {0};
    double *X = NULL;
    mat6 S;
    s->nnode = p->E.nnode;
    TRY(TAKE(X, 3 * KEPT * (size_t)s->nnode));
    TRY(TAKE(s->w, 18 * (size_t)s->nnode));
    TRY(stiffness_factor_make(&p->E, false, &f));
    TRY(full_condense(p, &f, X, &S));
    s->psi = S;
    for (int j = FIRST_KEPT; j < 6; j++) {
        full_set_column(p, X, j, s);
    }
    TRY(add_shear_columns(p, &f, X, S, s));

done:
    stiffness_factor_free(&f);
    free(X);
    return st;
}

status section_turning_mesh(const mesh *m, const material *materials, double turn_rate,
                            beam_law *out, section_warping *warping)
{
    status st = OK;
    warping_problem p = {0};
    full_solution s = {0};

    TRY(warping_problem_make(m, materials, turn_rate, &p));
    TRY(p.rate == 0 ? full_solve_prismatic(&p, &s) : full_solve_turning(&p, &s));
    TRY(full_law(&p, &s, out));
    if (warping) {
        TRY(full_warping_in_si(&p, &s, warping));
    }

done:
    full_solution_free(&s);
    warping_problem_free(&p);
    return st;
}

status section_full_mesh(const mesh *m, const material *materials, beam_law *out,
                         section_warping *warping)
{
    return section_turning_mesh(m, materials, 0, out, warping);
}
