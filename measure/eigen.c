// measure/eigen.c
#include "measure/eigen.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

typedef struct eigen_work {
    int n;
    double a[EIGEN_MOST][EIGEN_MOST], v[EIGEN_MOST][EIGEN_MOST]; // v: rows are the vectors
} eigen_work;

// The rotation of p and q after which a[p][q] is zero.
static void rotate(eigen_work *w, int p, int q)
{
    const double theta = (w->a[q][q] - w->a[p][p]) / (2 * w->a[p][q]);
    const double t = copysign(1, theta) / (fabs(theta) + sqrt(theta * theta + 1));
    const double c = 1 / sqrt(t * t + 1), s = t * c;
    for (int k = 0; k < w->n; k++) {
        const double kp = w->a[k][p], kq = w->a[k][q];
        w->a[k][p] = c * kp - s * kq;
        w->a[k][q] = s * kp + c * kq;
    }
    for (int k = 0; k < w->n; k++) {
        const double pk = w->a[p][k], qk = w->a[q][k], vp = w->v[p][k], vq = w->v[q][k];
        w->a[p][k] = c * pk - s * qk;
        w->a[q][k] = s * pk + c * qk;
        w->v[p][k] = c * vp - s * vq;
        w->v[q][k] = s * vp + c * vq;
    }
}

static bool sweep(eigen_work *w)
{
    bool any = false;
    for (int p = 0; p < w->n; p++) {
        for (int q = p + 1; q < w->n; q++) {
            // what is left is below rounding of its diagonal
            const double size = 1e-17 * (fabs(w->a[p][p]) + fabs(w->a[q][q]));
            if (fabs(w->a[p][q]) > size) {
                rotate(w, p, q);
                any = true;
            }
        }
    }
    return any;
}

void eigen_symmetric(int n, const double *a, double value[EIGEN_MOST],
                     double vector[EIGEN_MOST][EIGEN_MOST])
{
    enum { MOST_SWEEPS = 50 }; // five are usual
    eigen_work w = {.n = n};
    for (int i = 0; i < n; i++) {
        memcpy(w.a[i], a + i * n, (size_t)n * sizeof *a);
        w.v[i][i] = 1;
    }
    for (int i = 0; i < MOST_SWEEPS && sweep(&w); i++) {
    }
    bool taken[EIGEN_MOST] = {false};
    for (int i = 0; i < n; i++) {
        int least = -1;
        for (int k = 0; k < n; k++) {
            least = !taken[k] && (least < 0 || w.a[k][k] < w.a[least][least]) ? k : least;
        }
        taken[least] = true;
        value[i] = w.a[least][least];
        memcpy(vector[i], w.v[least], sizeof w.v[least]);
    }
}
