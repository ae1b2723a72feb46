// A pattern that turns: theta(z) = exp(T_k z) theta(0) is a sum of exp(l z) with l = 0 for n_z and
// m_z, and l = i k, -i k, each with a Jordan block of two, for the rest. docs/theory.md
// (3.9)-(3.14)
#include "base/beam_law.h"
#include "base/memory.h"
#include "section/full.h"

#include <complex.h>
#include <string.h>

typedef double complex number;

// The fields of exp(i k z): one factor of P, X = P^-1 (R - i k L), S = A - (R - i k L)^H X.
typedef struct wave_work {
    stiffness_factor factor;
    number *X;     // [KEPT][3 nnode]
    number *Y;     // [3 nnode] P^-1 of the second right-hand side
    double *first; // [nnode][3][2] w of the first field, as pairs
    number S[KEPT][KEPT];
} wave_work;

static void wave_work_free(wave_work *f)
{
    stiffness_factor_free(&f->factor);
    free(f->X);
    free(f->Y);
    free(f->first);
}

// a^H b, a as pairs
static number conjugate_dot(size_t n, const double *a, const number *b)
{
    number sum = 0;
    for (size_t i = 0; i < n; i++) {
        sum += conj(a[2 * i] + a[2 * i + 1] * I) * b[i];
    }
    return sum;
}

// L D L^H of a Hermitian S in place, false where it is not positive definite; it is small and its
// entries are alike in size, all lengths being scaled
static bool factor_small(number S[KEPT][KEPT])
{
    for (int j = 0; j < KEPT; j++) {
        for (int k = 0; k < j; k++) {
            S[j][j] -= S[j][k] * conj(S[j][k]) * creal(S[k][k]);
        }
        if (!(creal(S[j][j]) > 0)) {
            return false;
        }
        for (int i = j + 1; i < KEPT; i++) {
            for (int k = 0; k < j; k++) {
                S[i][j] -= S[i][k] * conj(S[j][k]) * creal(S[k][k]);
            }
            S[i][j] /= creal(S[j][j]);
        }
    }
    return true;
}

static void solve_small(number L[KEPT][KEPT], number *x)
{
    for (int i = 0; i < KEPT; i++) {
        for (int k = 0; k < i; k++) {
            x[i] -= L[i][k] * x[k];
        }
    }
    for (int i = KEPT - 1; i >= 0; i--) {
        x[i] /= creal(L[i][i]);
        for (int k = i + 1; k < KEPT; k++) {
            x[i] -= conj(L[k][i]) * x[k];
        }
    }
}

static status condense_wave(const warping_problem *p, wave_work *f)
{
    status st = OK;
    const size_t n = 3 * (size_t)p->E.nnode;
    TRY(TAKE(f->X, KEPT * n));
    TRY(TAKE(f->Y, n));
    TRY(TAKE(f->first, 2 * n));
    TRY(stiffness_factor_make(&p->E, true, &f->factor));
    TRY(stiffness_solve(&f->factor, KEPT, p->wave, (double *)f->X));
    for (size_t i = 0; i < KEPT; i++) {
        for (size_t j = 0; j < KEPT; j++) {
            f->S[i][j] = p->A.a[FIRST_KEPT + i][FIRST_KEPT + j] -
                         conjugate_dot(n, p->wave + 2 * i * n, f->X + j * n);
        }
    }
    if (!factor_small(f->S)) {
        TRY(status_fail(ERR_NUMERIC,
                        "section: the stiffness of its turning pattern is not positive definite"));
    }

done:
    return st;
}

// w = Y - X psi at an unknown, Y may be NULL
static number field_at_unknown(const wave_work *f, size_t n, const number *Y, const number *psi,
                               size_t u)
{
    number w = Y ? Y[u] : 0;
    for (size_t k = 0; k < KEPT; k++) {
        w -= f->X[k * n + u] * psi[k];
    }
    return w;
}

// Two columns of the solution: real part and, times `sign`, imaginary part of a field.
static void set_columns(const warping_problem *p, const wave_work *f, const number *Y,
                        const number *psi, int real, int imaginary, double sign, full_solution *s)
{
    const size_t n = 3 * (size_t)s->nnode;
    for (int k = 0; k < KEPT; k++) {
        s->psi.a[FIRST_KEPT + k][real] = creal(psi[k]);
        s->psi.a[FIRST_KEPT + k][imaginary] = sign * cimag(psi[k]);
    }
    for (int i = 0; i < 3 * s->nnode; i++) {
        const number w =
            field_at_unknown(f, n, Y, psi, (size_t)stiffness_unknown(&p->E, i / 3, i % 3));
        s->w[6 * i + real] = creal(w);
        s->w[6 * i + imaginary] = sign * cimag(w);
    }
}

// (3.13): T_k v1 = i k v1 with v1 = m_x + i m_y, so real and imaginary part are the columns of m_x
// and m_y.
static void solve_first(const warping_problem *p, wave_work *f, full_solution *s)
{
    number psi[KEPT] = {0, 1, I, 0};
    solve_small(f->S, psi);
    set_columns(p, f, NULL, psi, MX, MY, 1, s);
}

// (3.14): T_k v2 = i k v2 + v1 with v2 = n_y - i n_x, whose four kept components are zero.
static status solve_second(warping_problem *p, wave_work *f, full_solution *s)
{
    status st = OK;
    const size_t n = 3 * (size_t)s->nnode;
    double psi1[6][2], moved[6][2];
    number psi[KEPT];
    for (size_t u = 0; u < n; u++) {
        f->first[2 * u] = s->w[6 * u + MX];
        f->first[2 * u + 1] = s->w[6 * u + MY];
    }
    for (int i = 0; i < 6; i++) {
        psi1[i][0] = s->psi.a[i][MX];
        psi1[i][1] = s->psi.a[i][MY];
    }
    TRY(warping_second_sides(p, f->first, psi1, (double *)f->Y, moved));
    TRY(stiffness_solve(&f->factor, 1, (double *)f->Y, (double *)f->Y));
    for (size_t i = 0; i < KEPT; i++) {
        psi[i] = -(moved[FIRST_KEPT + i][0] + moved[FIRST_KEPT + i][1] * I) -
                 conjugate_dot(n, p->wave + 2 * i * n, f->Y);
    }
    solve_small(f->S, psi);
    set_columns(p, f, f->Y, psi, NY, NX, -1, s);

done:
    return st;
}

// (3.11), l = 0: n_z and m_z
static status solve_still(const warping_problem *p, full_solution *s)
{
    status st = OK;
    stiffness_factor f = {0};
    double *X = NULL;
    mat6 S;
    static const int column[2] = {NZ, MZ};
    TRY(TAKE(X, 3 * KEPT * (size_t)s->nnode));
    TRY(stiffness_factor_make(&p->E, false, &f));
    TRY(full_condense(p, &f, X, &S));
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 6; i++) {
            s->psi.a[i][column[k]] = S.a[i][column[k]];
        }
        full_set_column(p, X, column[k], s);
    }

done:
    stiffness_factor_free(&f);
    free(X);
    return st;
}

status full_solve_turning(warping_problem *p, full_solution *s)
{
    status st = OK;
    wave_work f = {0};
    s->nnode = p->E.nnode;
    TRY(TAKE(s->w, 18 * (size_t)s->nnode));
    TRY(solve_still(p, s));
    TRY(condense_wave(p, &f));
    solve_first(p, &f, s);
    TRY(solve_second(p, &f, s));

done:
    wave_work_free(&f);
    return st;
}
