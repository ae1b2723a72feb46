// fem/corner_strength.c
#include "fem/corner_strength.h"

#include <math.h>

#define PI 3.14159265358979323846

// bisections: to the last bit of a double
enum { HALVINGS = 60 };

// Zero where fixed displacements at angle 0 and no tractions at a right angle go together: (5.15)
static double condition(double kappa, double lambda)
{
    const double s = sin(lambda * PI / 2);
    return 4 * kappa * s * s + 4 * lambda * lambda - (kappa + 1) * (kappa + 1);
}

double corner_strength(double nu)
{
    const double kappa = 3 - 4 * nu; // plane strain
    double low = 0.5, high = 1;
    if (condition(kappa, high) <= 0) {
        return 1;
    }
    // it grows with lambda
    for (int i = 0; i < HALVINGS; i++) {
        const double mid = (low + high) / 2;
        *(condition(kappa, mid) < 0 ? &low : &high) = mid;
    }
    return (low + high) / 2;
}
