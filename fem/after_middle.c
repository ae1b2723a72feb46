// fem/after_middle.c
// The law of the middle from its energy, its curvature and the centre that follows.
#include "fem/after_parts.h"

#include "base/element.h"

#include <math.h>

// pivots below this, over the largest entry, are rounding
static const double SINGULAR = 1e-13;

bool after_solve(int n, double (*A)[AFTER_MOST_UNKNOWNS], double *b)
{
    double largest = 0;
    for (int i = 0; i < n * n; i++) {
        largest = fmax(largest, fabs(A[i / n][i % n]));
    }
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++) {
            best = fabs(A[i][k]) > fabs(A[best][k]) ? i : best;
        }
        if (!(fabs(A[best][k]) > SINGULAR * largest)) {
            return false;
        }
        for (int j = 0; j < n; j++) {
            const double swap = A[k][j];
            A[k][j] = A[best][j];
            A[best][j] = swap;
        }
        const double swap = b[k];
        b[k] = b[best];
        b[best] = swap;
        for (int i = k + 1; i < n; i++) {
            const double by = A[i][k] / A[k][k];
            for (int j = k; j < n; j++) {
                A[i][j] -= by * A[k][j];
            }
            b[i] -= by * b[k];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n; j++) {
            b[k] -= A[k][j] * b[j];
        }
        b[k] /= A[k][k];
    }
    return true;
}

vec6 vec6_turned(mat3 R, vec6 w)
{
    const vec3 n = mat3_mul_vec(R, vec6_linear(w)), m = mat3_mul_vec(R, vec6_angular(w));
    return (vec6){{n.a[0], n.a[1], n.a[2], m.a[0], m.a[1], m.a[2]}};
}

// --- (5.5): U = int T^T F T ds over the window, T(s) what a unit wrench at the window's centre is
// in the section's axes at s

mat6 after_transport(const section_pose *from, const section_pose *to, double unit)
{
    mat6 T = {0};
    for (int j = 0; j < 6; j++) {
        vec6 w = {0};
        w.a[j] = j < 3 ? 1 : unit;
        w = vec6_turned(from->axes, w);
        w = vec6_turned(mat3_transpose(to->axes), wrench_about(w, from->origin, to->origin));
        for (int i = 0; i < 3; i++) {
            T.a[i][j] = w.a[i];
            T.a[3 + i][j] = w.a[3 + i] / unit;
        }
    }
    return T;
}

typedef struct entry {
    int i, j;
} entry;

// the 21 of a symmetric matrix
static void upper_entries(entry list[AFTER_MOST_UNKNOWNS])
{
    for (int i = 0, n = 0; i < 6; i++) {
        for (int j = i; j < 6; j++) {
            list[n++] = (entry){i, j};
        }
    }
}

// A[r][c]: entry r of int T^T F T for F with a one at entry c
static void add_place(const mat6 *T, double weight, double (*A)[AFTER_MOST_UNKNOWNS])
{
    entry e[AFTER_MOST_UNKNOWNS];
    upper_entries(e);
    for (int r = 0; r < AFTER_MOST_UNKNOWNS; r++) {
        for (int c = 0; c < AFTER_MOST_UNKNOWNS; c++) {
            const double *a = T->a[e[c].i], *b = T->a[e[c].j];
            const double both = a[e[r].i] * b[e[r].j] + b[e[r].i] * a[e[r].j];
            A[r][c] += weight * (e[c].i == e[c].j ? both / 2 : both);
        }
    }
}

status after_find_law(after *a)
{
    status st = OK;
    enum { RULE = 12 }; // a window that turns by one radian to rounding
    double x[RULE], w[RULE], A[AFTER_MOST_UNKNOWNS][AFTER_MOST_UNKNOWNS] = {{0}},
                             b[AFTER_MOST_UNKNOWNS];
    // whatever the axes of the base, the centre's own are those of F
    const section_pose from = {.axes = mat3_identity(), .origin = a->centre.origin};
    entry e[AFTER_MOST_UNKNOWNS];
    mat6 unused;
    upper_entries(e);
    gauss_legendre(RULE, x, w);
    for (int q = 0; q < RULE; q++) {
        section_pose to;
        TRY(after_pose_at(a->problem->body, a->middle + x[q] * a->middle_half, &to));
        const mat6 T = after_transport(&from, &to, a->radius);
        add_place(&T, w[q] * a->middle_half, A);
    }
    for (int r = 0; r < AFTER_MOST_UNKNOWNS; r++) {
        const double scale = (e[r].i < 3 ? 1 : a->radius) * (e[r].j < 3 ? 1 : a->radius);
        b[r] = scale * (a->run->energy.a[e[r].i][e[r].j] + a->run->energy.a[e[r].j][e[r].i]) / 2;
    }
    if (!after_solve(AFTER_MOST_UNKNOWNS, A, b)) {
        TRY(status_fail(ERR_NUMERIC, "segment: the middle turns too fast for its window"));
    }
    for (int r = 0; r < AFTER_MOST_UNKNOWNS; r++) {
        const double scale = (e[r].i < 3 ? 1 : a->radius) * (e[r].j < 3 ? 1 : a->radius);
        a->F.a[e[r].i][e[r].j] = a->F.a[e[r].j][e[r].i] = b[r] / scale;
    }
    if (!mat6_inverse_spd(a->F, &unused)) {
        TRY(status_fail(ERR_NUMERIC, "segment: the energy at %g m gives no positive definite law",
                        a->middle));
    }

done:
    return st;
}

// diag(R, R)
static mat6 both(mat3 R)
{
    mat6 T = {0};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            T.a[i][j] = T.a[3 + i][3 + j] = R.a[i][j];
        }
    }
    return T;
}

status after_middle(const after *a, beam_law *out)
{
    *out = (beam_law){.area = a->area};
    if (!mat6_inverse_spd(a->F, &out->K)) {
        return status_fail(ERR_NUMERIC, "segment: the middle's law is not positive definite");
    }
    if (a->straight) {
        out->K = mat6_congruence(both(mat3_transpose(a->centre.axes)), out->K);
    }
    return OK;
}

// an axial force at (x, y) is the wrench n_z + y m_x - x m_y: where its curvature vanishes.
// docs/theory.md (5.4)
status after_centre(const after *a, double centre[2])
{
    const double(*kappa)[2] = (const double(*)[2])a->curvature;
    const double p = -kappa[MY][0], b = kappa[MX][0], d = -kappa[MY][1], e = kappa[MX][1];
    const double det = p * e - b * d, scale = fabs(p * e) + fabs(b * d);
    if (!(fabs(det) > 1e-12 * scale)) {
        return status_fail(ERR_NUMERIC, "segment: end moments do not bend the middle");
    }
    centre[0] = (b * kappa[NZ][1] - e * kappa[NZ][0]) / det;
    centre[1] = (d * kappa[NZ][0] - p * kappa[NZ][1]) / det;
    return OK;
}
