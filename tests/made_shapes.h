// tests/made_shapes.h
// Synthetic "measured" shapes of the paper's two prototypes, by a route of their own: the sector's
// integrals in closed form, the local balance of a pulled tendon by iteration, friction and pose
// marched along the rod by Runge and Kutta's classical method. Nothing of section/ or rodsolver/.
//
// What they were made with differs from the cases that they go with: tendons at 3.65 mm instead of
// 3.6 mm, and with friction. The errors of a scan are added: 0.05 mm, going together over 5 mm.
#pragma once

#include <math.h>
#include <stdio.h>
#include <string.h>

#define MADE_PI 3.14159265358979323846

enum { MADE_STEPS = 1200, MADE_POINTS = 61, MADE_SHAPES = 11 };

static const double made_E[2] = {0.66e6, 15.93e6}, made_nu = 0.45;
static const double made_outer = 4e-3, made_inner = 3.2e-3, made_length = 0.12;
static const double made_radius = 3.65e-3, made_friction = 0.05;
static const double made_sigma = 0.05e-3, made_correlation = 5e-3;

typedef struct made_shape {
    const char *file;
    int helical;
    double angle, tension; // of the one tendon that is pulled [rad], [N]
} made_shape;

static const made_shape made_shapes[MADE_SHAPES] = {
    {"constant_nc_t1_0.49N.csv", 0, 0, 0.49},       {"constant_nc_t1_0.67N.csv", 0, 0, 0.67},
    {"constant_nc_t1_0.98N.csv", 0, 0, 0.98},       {"constant_nc_t2_0.49N.csv", 0, MADE_PI, 0.49},
    {"constant_nc_t2_0.67N.csv", 0, MADE_PI, 0.67}, {"constant_nc_t2_0.98N.csv", 0, MADE_PI, 0.98},
    {"helical_nc_0.49N.csv", 1, MADE_PI / 2, 0.49}, {"helical_nc_0.69N.csv", 1, MADE_PI / 2, 0.69},
    {"helical_nc_0.98N.csv", 1, MADE_PI / 2, 0.98}, {"helical_nc_1.47N.csv", 1, MADE_PI / 2, 1.47},
    {"helical_nc_1.96N.csv", 1, MADE_PI / 2, 1.96},
};

typedef struct made_section {
    double EA, GA, EI[2], GJ; // about the stiffness centre; EI[0] about the sector's own axis
    double centre, turn;      // distance of the stiffness centre from the axis, and its direction
} made_section;

// paper's Eq. 11, 12 and 18 to 20 with the limits as they should be
static inline made_section made_section_at(const made_shape *shape, double s)
{
    const double width = shape->helical ? MADE_PI / 4 - MADE_PI / 8 * s / made_length : MADE_PI / 8;
    const double r2 = pow(made_outer, 2) - pow(made_inner, 2);
    const double r3 = pow(made_outer, 3) - pow(made_inner, 3);
    const double r4 = pow(made_outer, 4) - pow(made_inner, 4);
    const double more = made_E[1] - made_E[0];
    made_section c = {.turn = shape->helical ? MADE_PI * s / made_length : MADE_PI};
    c.EA = made_E[0] * MADE_PI * r2 + more * width * r2 / 2;
    c.centre = more * 2 * sin(width / 2) * r3 / 3 / c.EA;
    c.EI[0] = made_E[0] * MADE_PI * r4 / 4 + more * (width - sin(width)) * r4 / 8;
    c.EI[1] = made_E[0] * MADE_PI * r4 / 4 + more * (width + sin(width)) * r4 / 8 -
              c.EA * c.centre * c.centre;
    const double shear = 1 / (2 * (1 + made_nu));
    c.GA = shear * c.EA;
    c.GJ = shear * (c.EI[0] + c.EI[1]);
    return c;
}

static inline void made_cross(const double *a, const double *b, double *c)
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

// The strains (v, u) of the geometric centreline under a tendon of that tension, and the tendon's
// direction t in the section: n = -T t and the moment of it about the stiffness centre, turned into
// the sector's own axes, give u and v; these give t again.
static inline void made_strain(const made_shape *shape, double s, double tension, double v[3],
                               double u[3], double t[3])
{
    const made_section c = made_section_at(shape, s);
    const double cs = cos(c.turn), sn = sin(c.turn);
    const double centre[3] = {c.centre * cs, c.centre * sn, 0};
    const double place[3] = {made_radius * cos(shape->angle), made_radius * sin(shape->angle), 0};
    const double arm[3] = {place[0] - centre[0], place[1] - centre[1], 0};
    memcpy(t, (const double[3]){0, 0, 1}, 3 * sizeof *t);
    double change = 1;
    for (int k = 0; k < 400 && change > 1e-15; k++) {
        const double n[3] = {-tension * t[0], -tension * t[1], -tension * t[2]};
        double m[3], lever[3], carried[3];
        made_cross(arm, n, m);
        const double own[2] = {(cs * m[0] + sn * m[1]) / c.EI[0],
                               (-sn * m[0] + cs * m[1]) / c.EI[1]};
        u[0] = cs * own[0] - sn * own[1];
        u[1] = sn * own[0] + cs * own[1];
        u[2] = m[2] / c.GJ;
        made_cross(u, centre, lever);
        v[0] = n[0] / c.GA - lever[0];
        v[1] = n[1] / c.GA - lever[1];
        v[2] = 1 + n[2] / c.EA - lever[2];
        made_cross(u, place, carried);
        double size = 0;
        for (int i = 0; i < 3; i++) {
            size += (v[i] + carried[i]) * (v[i] + carried[i]);
        }
        change = 0;
        for (int i = 0; i < 3; i++) {
            const double next = (v[i] + carried[i]) / sqrt(size);
            change = fmax(change, fabs(next - t[i]));
            t[i] = next;
        }
    }
}

// Along the rod: R (9, by rows), p (3), tension, arclength as it lies.
enum { MADE_STATE = 14, MADE_P = 9, MADE_T = 12, MADE_S = 13 };

// How fast the tendon's direction turns in space, where the tension falls at that rate.
static inline double made_tendon_turn(const made_shape *shape, double s, double tension,
                                      double falling)
{
    const double h = 1e-4 * made_length;
    const double a = fmax(s - h, 0), b = fmin(s + h, made_length);
    double v[3], u[3], t[3], before[3], after[3], turn[3], size = 0;
    made_strain(shape, a, tension - falling * (a - s), v, u, before);
    made_strain(shape, b, tension - falling * (b - s), v, u, after);
    made_strain(shape, s, tension, v, u, t);
    made_cross(u, t, turn);
    for (int i = 0; i < 3; i++) {
        turn[i] += (after[i] - before[i]) / (b - a);
        size += turn[i] * turn[i];
    }
    return sqrt(size);
}

static inline void made_slopes(const made_shape *shape, double s, const double *y, double *dy)
{
    double v[3], u[3], t[3], falling = 0;
    made_strain(shape, s, y[MADE_T], v, u, t);
    for (int i = 0; i < 3; i++) {
        made_cross(y + 3 * i, u, dy + 3 * i);
        dy[MADE_P + i] = y[3 * i] * v[0] + y[3 * i + 1] * v[1] + y[3 * i + 2] * v[2];
    }
    for (int k = 0; k < 4; k++) {
        falling = made_friction * y[MADE_T] * made_tendon_turn(shape, s, y[MADE_T], falling);
    }
    dy[MADE_T] = -falling;
    dy[MADE_S] = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static inline void made_step(const made_shape *shape, double s, double h, double *y)
{
    static const double part[4] = {0, 0.5, 0.5, 1}, weight[4] = {1, 2, 2, 1};
    double k[MADE_STATE] = {0}, sum[MADE_STATE] = {0};
    for (int stage = 0; stage < 4; stage++) {
        double at[MADE_STATE];
        for (int i = 0; i < MADE_STATE; i++) {
            at[i] = y[i] + h * part[stage] * k[i];
        }
        made_slopes(shape, s + h * part[stage], at, k);
        for (int i = 0; i < MADE_STATE; i++) {
            sum[i] += weight[stage] * k[i];
        }
    }
    for (int i = 0; i < MADE_STATE; i++) {
        y[i] += h / 6 * sum[i];
    }
}

// Rows (arclength as it lies, x, y, z) [m] at MADE_POINTS places, without errors; steps: how many
// the march takes, a multiple of MADE_POINTS - 1.
static inline void made_line(const made_shape *shape, int steps, double (*row)[4])
{
    double y[MADE_STATE] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    y[MADE_T] = shape->tension;
    const int stride = steps / (MADE_POINTS - 1);
    for (int i = 0; i <= steps; i++) {
        if (i % stride == 0) {
            double *out = row[i / stride];
            out[0] = y[MADE_S];
            memcpy(out + 1, y + MADE_P, 3 * sizeof *out);
        }
        if (i < steps) {
            made_step(shape, made_length * i / steps, made_length / steps, y);
        }
    }
}

// --- errors of a scan, the same for the same seed everywhere

static inline double made_uniform(unsigned *state)
{
    *state = (*state * 1664525u + 1013904223u) & 0xffffffffu;
    return (*state >> 8) / 16777216.0;
}

// twelve uniform numbers make one that is close to normal
static inline double made_normal(unsigned *state)
{
    double sum = -6;
    for (int i = 0; i < 12; i++) {
        sum += made_uniform(state);
    }
    return sum;
}

static inline void made_errors(unsigned seed, double (*row)[4])
{
    unsigned state = 12345u + 977u * seed;
    double error[3] = {0};
    for (int i = 0; i < MADE_POINTS; i++) {
        const double step = i > 0 ? row[i][0] - row[i - 1][0] : INFINITY;
        const double kept = exp(-step / made_correlation);
        for (int d = 0; d < 3; d++) {
            error[d] = kept * error[d] + sqrt(1 - kept * kept) * made_normal(&state);
            row[i][1 + d] += made_sigma * error[d];
        }
    }
}

static inline void made_rows(int which, double (*row)[4])
{
    made_line(&made_shapes[which], MADE_STEPS, row);
    made_errors((unsigned)which, row);
}

static inline void made_write(int which, FILE *f)
{
    double row[MADE_POINTS][4];
    made_rows(which, row);
    fprintf(f,
            "# SYNTHETIC: computed by tests/made_shapes.h, not measured on any robot. Tendon at "
            "%.2f mm, friction %.2f,\n# errors of %.2f mm that go together over %.0f mm.\n"
            "s_mm,x_mm,y_mm,z_mm,sigma_mm\n",
            1e3 * made_radius, made_friction, 1e3 * made_sigma, 1e3 * made_correlation);
    for (int i = 0; i < MADE_POINTS; i++) {
        fprintf(f, "%.4f,%.4f,%.4f,%.4f,%.2f\n", 1e3 * row[i][0], 1e3 * row[i][1], 1e3 * row[i][2],
                1e3 * row[i][3], 1e3 * made_sigma);
    }
}
