// rodsolver/rod_compliance.c
#include "base/element.h"
#include "rodsolver/rod.h"

#include <math.h>

// docs/theory.md (4.10): the wrench at the tip seen from s is P w with P = [I, 0; hat(tip - s), I],
// and the tip moves by P^T of the strain there
static mat6 integrand(const law_along *law, double tip, double s, bool *good)
{
    mat6 K, F = {0}, P = mat6_identity();
    law_along_at(law, s, &K, NULL);
    *good = *good && mat6_inverse_spd(K, &F);
    P.a[MX][NY] = -(tip - s);
    P.a[MY][NX] = tip - s;
    return mat6_congruence(P, F);
}

status rod_linear_compliance_between(const law_along *law, double from, double to, int ngauss,
                                     mat6 *out)
{
    double x[32], w[32];
    if (ngauss < 1 || ngauss > 32 || !(from >= 0) || !(to > from) ||
        to > law->length * (1 + 1e-9)) {
        return status_fail(ERR_BUG, "rod: linear compliance by %d points from %g to %g m of %g m",
                           ngauss, from, to, law->length);
    }
    gauss_legendre(ngauss, x, w);
    mat6 C = {0};
    bool good = true;
    for (int k = 0; k < law->npanel && law->edge[k] < to; k++) {
        const double a = fmax(law->edge[k], from);
        const double b = k + 1 < law->npanel ? fmin(law->edge[k + 1], to) : to;
        for (int i = 0; a < b && i < ngauss; i++) {
            const double s = (a + b) / 2 + (b - a) / 2 * x[i];
            C = mat6_add(C, mat6_scale(w[i] * (b - a) / 2, integrand(law, to, s, &good)));
        }
    }
    if (!good) {
        return status_fail(ERR_NUMERIC, "rod: the stiffness of a section is not positive definite");
    }
    *out = mat6_symmetric(C);
    return OK;
}

status rod_linear_compliance(const law_along *law, double length, int ngauss, mat6 *out)
{
    return rod_linear_compliance_between(law, 0, length, ngauss, out);
}
