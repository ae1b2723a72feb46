// app/chain_total_bend.c
#include "app/chain.h"

#include <math.h>

double chain_total_bend(int npose, const pose *shape)
{
    const vec3 base = {{shape[0].R.a[0][2], shape[0].R.a[1][2], shape[0].R.a[2][2]}};
    vec3 before = {{0, 0, 0}}; // direction in which the last tangent left the base's
    double total = 0, sign = 1;
    for (int i = 1; i < npose; i++) {
        const vec3 t = {{shape[i].R.a[0][2], shape[i].R.a[1][2], shape[i].R.a[2][2]}};
        const double along = vec3_dot(t, base);
        const vec3 aside = vec3_sub(t, vec3_scale(along, base));
        const double angle = atan2(vec3_norm(aside), along); // 0 to pi

        // passing the base's tangent or its opposite turns the direction around: unfold there
        sign = vec3_dot(aside, before) < 0 ? -sign : sign;
        const double turns = round((total - sign * angle) / (2 * M_PI));
        total = sign * angle + 2 * M_PI * turns;
        before = vec3_norm(aside) > 0 ? aside : before;
    }
    return fabs(total);
}
