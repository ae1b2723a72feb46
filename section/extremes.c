// section/extremes.c
#include "section/extremes.h"

#include <math.h>

static const double third_turn = 2.09439510239319549231; // 2 pi / 3

// the three roots of a symmetric tensor lie on a circle about its mean
double principal_strain(const vec6 *e)
{
    const double *a = e->a;
    const double xy = a[XY] / 2, yz = a[YZ] / 2, xz = a[XZ] / 2;
    const double mean = (a[XX] + a[YY] + a[ZZ]) / 3;
    const double x = a[XX] - mean, y = a[YY] - mean, z = a[ZZ] - mean;
    const double radius = sqrt((x * x + y * y + z * z + 2 * (xy * xy + yz * yz + xz * xz)) / 6);
    if (radius <= 0) {
        return mean;
    }
    const double det = x * (y * z - yz * yz) - xy * (xy * z - yz * xz) + xz * (xy * yz - y * xz);
    const double cube = det / (2 * radius * radius * radius);
    const double angle = acos(fmax(-1, fmin(1, cube))) / 3;
    const double high = mean + 2 * radius * cos(angle);
    const double low = mean + 2 * radius * cos(angle + third_turn);
    return fabs(high) >= fabs(low) ? high : low;
}

double von_mises(const vec6 *stress)
{
    const double *s = stress->a;
    const double a = s[XX] - s[YY], b = s[YY] - s[ZZ], c = s[ZZ] - s[XX];
    const double shear = s[YZ] * s[YZ] + s[XZ] * s[XZ] + s[XY] * s[XY];
    return sqrt((a * a + b * b + c * c) / 2 + 3 * shear);
}

static void keep(section_extreme *e, bool first, bool more, double value, const double *at)
{
    if (first || more) {
        *e = (section_extreme){value, {at[0], at[1]}};
    }
}

void section_extremes_find(const section_fields *f, const material *materials, int nmaterial,
                           const vec6 *wrench, section_extremes *out)
{
    for (int m = 0; m < nmaterial; m++) {
        out[m] = (section_extremes){0};
    }
    for (int i = 0; i < f->mesh.nnode; i++) {
        section_extremes *e = &out[f->material[i]];
        const double *at = f->mesh.xyz + 3 * (size_t)i;
        const vec6 strain = section_strain_at(f, i, wrench);
        const vec6 stress = section_stress_at(f, materials, i, &strain);
        const double principal = principal_strain(&strain), mises = von_mises(&stress);
        const double zz = stress.a[ZZ];
        const bool first = !e->used;
        keep(&e->strain, first, fabs(principal) > fabs(e->strain.value), principal, at);
        keep(&e->von_mises, first, mises > e->von_mises.value, mises, at);
        keep(&e->axial_highest, first, zz > e->axial_highest.value, zz, at);
        keep(&e->axial_lowest, first, zz < e->axial_lowest.value, zz, at);
        e->used = true;
    }
}

// no principal strain is larger than the root of the sum of all squares
static double square_sum(const vec6 *e)
{
    const double *a = e->a;
    return a[XX] * a[XX] + a[YY] * a[YY] + a[ZZ] * a[ZZ] +
           (a[YZ] * a[YZ] + a[XZ] * a[XZ] + a[XY] * a[XY]) / 2;
}

void section_largest_strain(const section_fields *f, const vec6 *wrench, section_extreme *largest,
                            bool *replaced)
{
    for (int i = 0; i < f->mesh.nnode; i++) {
        section_extreme *e = &largest[f->material[i]];
        const vec6 strain = section_strain_at(f, i, wrench);
        if (square_sum(&strain) <= e->value * e->value) {
            continue;
        }
        const double principal = principal_strain(&strain);
        if (fabs(principal) > fabs(e->value)) {
            keep(e, true, true, principal, f->mesh.xyz + 3 * (size_t)i);
            if (replaced) {
                replaced[f->material[i]] = true;
            }
        }
    }
}
