// reach/reach_samples.c
// Places on a surface: the area in equal shares, one place in each; where in its triangle by the
// two-dimensional sequence of Roberts, whose steps are powers of the root of x^3 = x + 1.
#include "reach/reach_map.h"

#include "base/memory.h"

#include <stdint.h>

static const double step_u = 0.75487766624669276, step_v = 0.56984029099805327;

// a number in [0, 1) for a seed
static double shift_of(int seed, int which)
{
    uint64_t x = ((uint64_t)(uint32_t)seed << 8) + (uint64_t)which + 1;
    for (int i = 0; i < 3; i++) {
        x = (x ^ x >> 31) * 0x9e3779b97f4a7c15u;
        x ^= x >> 29;
    }
    return (double)(x >> 11) / 9007199254740992.0;
}

static double fraction(double x)
{
    return x - floor(x);
}

// folded over the diagonal where it would be beyond
static vec3 on_triangle(const vec3 c[3], double u, double v)
{
    const double a = u + v > 1 ? 1 - u : u, b = u + v > 1 ? 1 - v : v;
    const vec3 p = vec3_add_scaled(c[0], a, vec3_sub(c[1], c[0]));
    return vec3_add_scaled(p, b, vec3_sub(c[2], c[0]));
}

status surface_samples(const surface *s, int npoint, int seed, double (*point)[3])
{
    const double shift[3] = {shift_of(seed, 0), shift_of(seed, 1), shift_of(seed, 2)};
    double before = 0; // area of the triangles before t
    int k = 0;
    if (npoint < 0 || !(s->area > 0)) {
        return status_fail(ERR_INPUT, "%d places on a surface of %g m2", npoint, s->area);
    }
    for (int t = 0; t < s->ntriangle; t++) {
        vec3 c[3];
        surface_corners(s, t, c);
        before += vec3_norm(vec3_cross(vec3_sub(c[1], c[0]), vec3_sub(c[2], c[0]))) / 2;
        // rounding of the sum leaves nothing to do behind the last triangle
        for (; k < npoint && ((k + shift[0]) * s->area < npoint * before || t == s->ntriangle - 1);
             k++) {
            const vec3 p =
                on_triangle(c, fraction(shift[1] + k * step_u), fraction(shift[2] + k * step_v));
            for (int d = 0; d < 3; d++) {
                point[k][d] = p.a[d];
            }
        }
    }
    return OK;
}
