// rodsolver/secular.c
#include "rodsolver/local_problem.h"

#include <math.h>

enum { MAX_STEPS = 60, MAX_SWEEPS = 30 };

// | |y| - 1 | at which the last Newton step is taken: it leaves the square of this
static const double stop_residual = 1e-8;

// one Jacobi rotation of the symmetric a in the plane (p, q), gathered in v's columns
static void rotate(mat3 *a, mat3 *v, int p, int q)
{
    if (a->a[p][q] == 0) {
        return;
    }
    const double theta = (a->a[q][q] - a->a[p][p]) / (2 * a->a[p][q]);
    const double t = (theta < 0 ? -1 : 1) / (fabs(theta) + hypot(theta, 1));
    const double c = 1 / hypot(t, 1), s = t * c;
    mat3 g = mat3_identity();
    g.a[p][p] = g.a[q][q] = c;
    g.a[p][q] = s;
    g.a[q][p] = -s;
    *a = mat3_mul(mat3_transpose(g), mat3_mul(*a, g));
    *v = mat3_mul(*v, g);
    a->a[p][q] = a->a[q][p] = 0;
}

static void symmetric_eigen(mat3 a, double value[3], mat3 *vectors)
{
    *vectors = mat3_identity();
    for (int sweep = 0; sweep < MAX_SWEEPS; sweep++) {
        if (a.a[0][1] == 0 && a.a[0][2] == 0 && a.a[1][2] == 0) {
            break;
        }
        rotate(&a, vectors, 0, 1);
        rotate(&a, vectors, 0, 2);
        rotate(&a, vectors, 1, 2);
    }
    for (int i = 0; i < 3; i++) {
        value[i] = a.a[i][i];
    }
}

void secular_prepare(const mat6 *F, const vec6 *rest, const tendon_place *r, secular_station *out)
{
    vec6 FA[3]; // columns of K^-1 A^T
    mat3 M, axes;
    tendon_place straight = *r;
    straight.dx = straight.dy = 0;
    for (int j = 0; j < 3; j++) {
        vec3 unit = {0};
        unit.a[j] = 1;
        FA[j] = mat6_mul_vec(*F, tendon_wrench(r, unit));
        const vec3 column = tendon_direction(&straight, &FA[j]);
        for (int i = 0; i < 3; i++) {
            M.a[i][j] = column.a[i];
        }
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < i; j++) {
            M.a[i][j] = M.a[j][i] = (M.a[i][j] + M.a[j][i]) / 2;
        }
    }
    symmetric_eigen(M, out->m, &axes);
    const vec3 b = mat3_tmul_vec(axes, tendon_direction(r, rest));
    for (int j = 0; j < 3; j++) {
        out->b[j] = b.a[j];
        for (int i = 0; i < 6; i++) {
            out->G[i][j] =
                FA[0].a[i] * axes.a[0][j] + FA[1].a[i] * axes.a[1][j] + FA[2].a[i] * axes.a[2][j];
        }
    }
}

double secular_critical(const secular_station *s)
{
    return vec3_norm((vec3){{s->b[0] / s->m[0], s->b[1] / s->m[1], s->b[2] / s->m[2]}});
}

// Newton on 1/|y(l)| = 1, concave and increasing in l: from the left it climbs without
// overshooting, from the right it lands on the left, and l = 0 is on the left of every solution
LANES_INLINE void secular_step(double tau, const lanes m[3], const lanes b[3], lanes *l,
                               lanes *residual)
{
    lanes square = {0}, slope = {0};
    for (int j = 0; j < 3; j++) {
        const lanes q = 1 / (*l + tau * m[j]), y = b[j] * q;
        square += y * y;
        slope += y * y * q;
    }
    for (int k = 0; k < LANES; k++) {
        const double size = sqrt(square[k]);
        const double next = (*l)[k] + (size - 1) * square[k] / slope[k];
        (*residual)[k] = fabs(size - 1);
        (*l)[k] = next > 0 ? next : 0;
    }
}

// tendon along d_0: exact where the tendon does not turn
LANES_INLINE void secular_start(double tau, const lanes m[3], const lanes b[3], lanes *start)
{
    const lanes b0 = b[0] * b[0], b1 = b[1] * b[1], b2 = b[2] * b[2];
    const lanes square = b0 + b1 + b2;
    lanes l;
    for (int k = 0; k < LANES; k++) {
        l[k] = sqrt(square[k]);
    }
    l -= tau * (b0 * m[0] + b1 * m[1] + b2 * m[2]) / square;
    for (int k = 0; k < LANES; k++) {
        l[k] = l[k] > 0 ? l[k] : 0;
    }
    *start = l;
}

LANES_CODE int secular_solve(double tau, int count, const lanes m[3], const lanes b[3], lanes y[3])
{
    lanes l, residual;
    secular_start(tau, m, b, &l);
    int steps = 0;
    double worst = HUGE_VAL;
    while (!(worst <= stop_residual)) {
        if (++steps > MAX_STEPS) {
            return -1;
        }
        secular_step(tau, m, b, &l, &residual);
        worst = 0;
        for (int k = 0; k < count; k++) {
            worst = residual[k] <= worst ? worst : residual[k];
        }
    }
    for (int j = 0; j < 3; j++) {
        y[j] = b[j] / (l + tau * m[j]);
    }
    return steps;
}
