// tests/unit/fem/test_corner_strength.c
#include "fem/corner_strength.h"
#include "tests/test.h"

#include <complex.h>
#include <math.h>

// published to four digits
static void known_values(void)
{
    CHECK_WITHIN(corner_strength(0.3), 0.7112, 5e-5);
    CHECK_WITHIN(corner_strength(0.5), 0.5946, 5e-5);
    CHECK_NEAR(corner_strength(0), 1, 1e-12);
    CHECK(corner_strength(-0.3) == 1);
}

// The field itself, in Muskhelishvili's potentials A z^lambda and B z^lambda: B from the fixed
// face, then the force on the free face for A = 1 and A = i. Both vanish together where their
// determinant does.
static double determinant(double nu, double lambda)
{
    const double kappa = 3 - 4 * nu, w = acos(0);
    double complex force[2];
    for (int k = 0; k < 2; k++) {
        const double complex A = k ? I : 1, B = kappa * conj(A) - lambda * A;
        force[k] = A * cexp(I * lambda * w) + lambda * conj(A) * cexp(I * (2 - lambda) * w) +
                   conj(B) * cexp(-I * lambda * w);
    }
    return creal(force[0]) * cimag(force[1]) - cimag(force[0]) * creal(force[1]);
}

static void the_field_fits_both_faces(void)
{
    for (int i = 1; i <= 50; i++) {
        const double nu = 0.01 * i, at = corner_strength(nu);
        CHECK(at > 0.5 && at < 1);
        CHECK_WITHIN(determinant(nu, at), 0, 1e-12);
        CHECK(fabs(determinant(nu, at + 0.01)) > 1e-3);
        CHECK(at < corner_strength(nu - 0.01)); // the stiffer in volume, the more singular
        // nothing more singular
        for (double lambda = 0.05; lambda < at - 0.01; lambda += 0.01) {
            CHECK(determinant(nu, lambda) * determinant(nu, 0.04) > 0);
        }
    }
}

int main(void)
{
    known_values();
    the_field_fits_both_faces();
    return test_failures != 0;
}
