// base/dense.c
#include "base/dense.h"

#include <math.h>

mat6 mat6_identity(void)
{
    mat6 a = {0};
    for (int i = 0; i < 6; i++) {
        a.a[i][i] = 1;
    }
    return a;
}

mat6 mat6_add(mat6 a, mat6 b)
{
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            a.a[i][j] += b.a[i][j];
        }
    }
    return a;
}

mat6 mat6_scale(double c, mat6 a)
{
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            a.a[i][j] *= c;
        }
    }
    return a;
}

mat6 mat6_mul(mat6 a, mat6 b)
{
    mat6 c = {0};
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < 6; k++) {
            for (int j = 0; j < 6; j++) {
                c.a[i][j] += a.a[i][k] * b.a[k][j];
            }
        }
    }
    return c;
}

mat6 mat6_transpose(mat6 a)
{
    mat6 t = {0};
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            t.a[i][j] = a.a[j][i];
        }
    }
    return t;
}

mat6 mat6_symmetric(mat6 a)
{
    return mat6_scale(0.5, mat6_add(a, mat6_transpose(a)));
}

mat6 mat6_congruence(mat6 t, mat6 k)
{
    return mat6_mul(mat6_transpose(t), mat6_mul(k, t));
}

bool mat6_cholesky(mat6 a, mat6 *lower)
{
    mat6 l = {0};
    for (int j = 0; j < 6; j++) {
        double d = a.a[j][j];
        for (int k = 0; k < j; k++) {
            d -= l.a[j][k] * l.a[j][k];
        }
        if (!(d > 0)) {
            return false;
        }
        l.a[j][j] = sqrt(d);
        for (int i = j + 1; i < 6; i++) {
            double c = a.a[i][j];
            for (int k = 0; k < j; k++) {
                c -= l.a[i][k] * l.a[j][k];
            }
            l.a[i][j] = c / l.a[j][j];
        }
    }
    *lower = l;
    return true;
}

vec6 mat6_cholesky_solve(const mat6 *lower, vec6 b)
{
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < i; k++) {
            b.a[i] -= lower->a[i][k] * b.a[k];
        }
        b.a[i] /= lower->a[i][i];
    }
    for (int i = 5; i >= 0; i--) {
        for (int k = i + 1; k < 6; k++) {
            b.a[i] -= lower->a[k][i] * b.a[k];
        }
        b.a[i] /= lower->a[i][i];
    }
    return b;
}

bool mat6_inverse_spd(mat6 a, mat6 *inverse)
{
    double scale[6];
    for (int i = 0; i < 6; i++) {
        if (!(a.a[i][i] > 0) || !isfinite(a.a[i][i])) {
            return false;
        }
        scale[i] = 1 / sqrt(a.a[i][i]);
    }
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            a.a[i][j] *= scale[i] * scale[j];
        }
    }
    mat6 lower;
    if (!mat6_cholesky(a, &lower)) {
        return false;
    }
    for (int j = 0; j < 6; j++) {
        vec6 unit = {0};
        unit.a[j] = 1;
        const vec6 column = mat6_cholesky_solve(&lower, unit);
        for (int i = 0; i < 6; i++) {
            inverse->a[i][j] = column.a[i] * scale[i] * scale[j];
        }
    }
    *inverse = mat6_symmetric(*inverse);
    return true;
}

double mat6_relative_error(mat6 a, mat6 b)
{
    double worst = 0;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            const double e = fabs(a.a[i][j] - b.a[i][j]) / sqrt(fabs(b.a[i][i] * b.a[j][j]));
            // written so that a NaN wins
            worst = isnan(worst) || e <= worst ? worst : e;
        }
    }
    return worst;
}
