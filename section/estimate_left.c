// section/estimate_left.c
#include "section/estimate.h"

#include <math.h>

// Errors are taken to fall like p^-a. Corners where materials meet a free edge, and re-entrant
// ones, give a = 2 to 5, and the low orders fall faster before these show: no faster decay than
// this is believed, no slower one is known.
static const double fastest_decay = 3, slowest_decay = 1;
// without a second difference: a re-entrant corner gives 8/3
static const double assumed_decay = 2;
// Where materials meet, and at re-entrant corners, the decay slows down with the order: what is
// left was 0.6 to 1.4 of what the last three orders promise (catheter, angle). Nobody is served by
// an estimate that is too small.
static const double slowing_margin = 2;
// the ratio d1 / d2 that errors c p^-a give
static double ratio_of_decay(int p, double a)
{
    const double e0 = pow(p, -a), e1 = pow(p - 1, -a), e2 = pow(p - 2, -a);
    return (e1 - e0) / (e2 - e1);
}

double section_error_left(int p, double d1, double d2)
{
    double slow = slowest_decay, fast = fastest_decay;
    double a = assumed_decay, margin = 1;
    if (p > 2 && d2 > 0) {
        margin = slowing_margin;
        // the ratio falls as the decay gets faster; a hundredth is more than an estimate needs
        for (int i = 0; i < 10; i++) {
            a = (slow + fast) / 2;
            if (ratio_of_decay(p, a) > d1 / d2) {
                slow = a;
            } else {
                fast = a;
            }
        }
    }
    const double e0 = pow(p, -a), e1 = pow(p - 1, -a);
    return margin * d1 * e0 / (e1 - e0);
}
