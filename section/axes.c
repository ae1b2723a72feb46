// section/axes.c
#include "section/answers.h"

#include <math.h>

static const double half_pi = 1.57079632679489661923;

// eigenvalues a >= b of [[xx, xy], [xy, yy]]; angle: of the first's axis
static void principal(double xx, double yy, double xy, double *a, double *b, double *angle)
{
    const double mean = (xx + yy) / 2, radius = hypot((xx - yy) / 2, xy);
    *a = mean + radius;
    *b = mean - radius;
    *angle = atan2(2 * xy, xx - yy) / 2;
}

// (3.26), from the compliance of a transverse force at the shear centre
static void shear_axes(const mat6 *F, double near, section_axes *out)
{
    const double xx = F->a[NX][NX], yy = F->a[NY][NY], xy = F->a[NX][NY];
    double soft = 0, stiff = 0, angle = 0;
    principal(xx, yy, xy, &soft, &stiff, &angle);
    if (soft - stiff <= BEAM_LAW_ISOTROPIC * soft) {
        angle = near;
    }
    const double quarters = round((near - angle) / half_pi);
    const bool swapped = fmod(fabs(quarters), 2) > 0.5;
    out->shear_angle = angle + quarters * half_pi;
    out->shear_stiffness[0] = 1 / (swapped ? stiff : soft);
    out->shear_stiffness[1] = 1 / (swapped ? soft : stiff);
}

status section_axes_of(const beam_law *law, const beam_centres *c, section_axes *out)
{
    mat6 F;
    const mat6 at_shear_centre = beam_law_move(law->K, c->shear_centre[0], c->shear_centre[1], 0);
    if (!mat6_inverse_spd(at_shear_centre, &F)) {
        return status_fail(ERR_NUMERIC, "section: its stiffness is not positive definite");
    }
    out->K_principal =
        beam_law_move(law->K, c->stiffness_centre[0], c->stiffness_centre[1], c->principal_angle);
    shear_axes(&F, c->principal_angle, out);
    return OK;
}
