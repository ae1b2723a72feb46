// tests/verify/section/stress.h
// Sections at the ends of what can be asked: contrast, thin walls, Poisson's ratios, sizes, far
// from the origin, slivers. In each the error stays within the estimate, or there is a refusal.
#pragma once

#include "section/solve.h"
#include "tests/sections.h"

#include <math.h>
#include <stdio.h>

typedef struct stress_case {
    const char *what;
    double value;
    sample s;
    mat6 K;          // the truth; NaN where it is not known in closed form
    bool from_finer; // the truth is the same section two levels finer
    int layers;      // more of them towards corners in the truth
} stress_case;

typedef struct stress_count {
    int rows, outside, refused;
} stress_count;

static inline mat6 nothing_known(void)
{
    mat6 K;
    for (int i = 0; i < 36; i++) {
        K.a[i / 6][i % 6] = i / 6 == i % 6 ? NAN : 0;
    }
    return K;
}

// (3.7), about the centre; seen from the origin where the centre is at (x, 0)
static inline mat6 annulus_law(double E, double nu, double outer, double inner, double x)
{
    // differences of squares as products: thin walls lose no digits
    const double d2 = (outer - inner) * (outer + inner), s2 = outer * outer + inner * inner;
    const double A = PI * d2, I = PI / 4 * d2 * s2, G = E / (2 * (1 + nu));
    const double m = inner / outer, q = (1 + m * m) * (1 + m * m);
    const double k = 6 * (1 + nu) * (1 + nu) * q /
                     ((7 + 14 * nu + 8 * nu * nu) * q + 4 * m * m * (5 + 10 * nu + 4 * nu * nu));
    mat6 K = nothing_known();
    K.a[NX][NX] = K.a[NY][NY] = k * G * A;
    K.a[NZ][NZ] = E * A;
    K.a[MX][MX] = K.a[MY][MY] = E * I;
    K.a[MZ][MZ] = 2 * G * I;
    // the frame at the origin sees the centre at x
    return beam_law_move(K, -x, 0, 0);
}

// EA, EI and GJ of a rectangle; its shears are not known
static inline mat6 rectangle_law(double E, double nu, double width, double height)
{
    const double a = fmax(width, height), b = fmin(width, height), A = a * b;
    double sum = 0;
    for (int n = 1; n < 40; n += 2) {
        sum += tanh(n * PI * a / (2 * b)) / pow(n, 5);
    }
    mat6 K = nothing_known();
    K.a[NZ][NZ] = E * A;
    K.a[MX][MX] = E * A * height * height / 12;
    K.a[MY][MY] = E * A * width * width / 12;
    K.a[MZ][MZ] = E / (2 * (1 + nu)) * a * b * b * b * (1.0 / 3 - 64 * b / (a * pow(PI, 5)) * sum);
    return K;
}

static inline stress_case stress_ring(const char *what, double value, double size, double part,
                                      double nu, double x)
{
    stress_case c = {.what = what, .value = value};
    c.s.material[0] = isotropic(1e6, nu);
    shape_spec ring = an_annulus(size, size * (1 - part), 0);
    ring.annulus.centre[0] = fixed(x);
    sample_add(&c.s, ring);
    c.K = annulus_law(1e6, nu, size, size * (1 - part), x);
    return c;
}

// a stiff core in a soft shell: EA, EI and GJ of both, the shears are not known
static inline stress_case stress_core(double contrast)
{
    stress_case c = {.what = "ring in ring, contrast", .value = contrast};
    c.s.material[0] = isotropic(1e6, 0.3);
    c.s.material[1] = isotropic(1e6 * contrast, 0.3);
    sample_add(&c.s, an_annulus(5e-3, 2e-3, 0));
    sample_add(&c.s, an_annulus(3e-3, 2e-3, 1));
    c.K = annulus_law(1e6, 0.3, 5e-3, 3e-3, 0);
    c.K = mat6_add(c.K, annulus_law(1e6 * contrast, 0.3, 3e-3, 2e-3, 0));
    c.K.a[NX][NX] = c.K.a[NY][NY] = NAN;
    return c;
}

static inline stress_case stress_sector(const char *what, double value, double contrast, double nu,
                                        double width)
{
    stress_case c = {.what = what, .value = value, .from_finer = true};
    // in a narrow sector more layers only add rounding
    c.layers = width > 1e-2 ? 2 : 0;
    sample_sector(&c.s, width, contrast, nu);
    c.K = nothing_known();
    return c;
}

static inline stress_case stress_strip(double part)
{
    stress_case c = {.what = "strip, thickness / width", .value = part};
    sample_box(&c.s, 10e-3, 10e-3 * part, 0, 0.3);
    c.K = rectangle_law(1e6, 0.3, 10e-3, 10e-3 * part);
    return c;
}

// stretch and bending of a rectangle about the origin, its centre at (0, y); exact with one
// Poisson's ratio all over the section
static inline void add_bar(mat6 *K, double E, double width, double height, double y)
{
    const double A = width * height;
    K->a[NZ][NZ] += E * A;
    K->a[NZ][MX] = K->a[MX][NZ] += E * A * y;
    K->a[MX][MX] += E * A * (height * height / 12 + y * y);
    K->a[MY][MY] += E * A * width * width / 12;
}

// a film of another material on a bar: stretch and bending are sums, the rest from the finer mesh
static inline stress_case stress_film(double part)
{
    stress_case c = {
        .what = "film on a bar, thickness / width", .value = part, .from_finer = true, .layers = 2};
    const double t = 10e-3 * part;
    c.s.material[0] = isotropic(1e6, 0.3);
    c.s.material[1] = isotropic(1e8, 0.3);
    sample_add(&c.s, a_rectangle(10e-3, 4e-3, 0, 0, 0, 0));
    sample_add(&c.s, a_rectangle(10e-3, t, 0, 0, 2e-3 + t / 2, 1));
    c.K = nothing_known();
    c.K.a[NZ][NZ] = c.K.a[MX][MX] = c.K.a[MY][MY] = 0;
    add_bar(&c.K, 1e6, 10e-3, 4e-3, 0);
    add_bar(&c.K, 1e8, 10e-3, t, 2e-3 + t / 2);
    return c;
}

// true error over the entries that are known, relative as (6.1), less what the truth says of its
// own, and the largest against its estimate
static inline double stress_error(const beam_law *law, mat6 truth, const mat6 *own, double *worst)
{
    double error = 0;
    *worst = 0;
    for (int i = 0; i < 36; i++) {
        const int r = i / 6, c = i % 6;
        const double size = sqrt(truth.a[r][r] * truth.a[c][c]);
        const double e = fabs(law->K.a[r][c] - truth.a[r][c]) / size - own->a[r][c];
        if (isfinite(e)) {
            error = fmax(error, e);
            *worst = fmax(*worst, e / law->entry_error.a[r][c]);
        }
    }
    return error;
}

static inline status stress_solve(const stress_case *c, bool fine, beam_law *out)
{
    section_case q = section_case_default();
    q.shapes = (key_list){.count = c->s.nshape, .items = (void *)(size_t)c->s.shape};
    q.nmaterial = 3;
    q.mesh.finer = fine ? 2 : 1;
    q.mesh.layers = fine ? c->layers : 0;
    return section_solve(&q, c->s.material, 0, 0, out);
}

// the finer mesh's K, and the closed form where there is one, which has no error of its own
static inline mat6 with_known(beam_law *fine, const mat6 *known)
{
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            if (isfinite(known->a[i][i]) && isfinite(known->a[j][j])) {
                fine->K.a[i][j] = known->a[i][j];
                fine->entry_error.a[i][j] = 0;
            }
        }
    }
    return fine->K;
}

static inline void stress_row(const stress_case *c, stress_count *count)
{
    beam_law law = {0}, fine = {0};
    count->rows++;
    printf("| %s | %g |", c->what, c->value);
    if (stress_solve(c, false, &law) != OK) {
        count->refused++;
        printf(" | | | %s |\n", status_message());
        status_clear();
        return;
    }
    mat6 truth = c->K;
    if (c->from_finer && stress_solve(c, true, &fine) == OK) {
        truth = with_known(&fine, &c->K);
    }
    status_clear();
    double worst = 0;
    const double error = stress_error(&law, truth, &fine.entry_error, &worst);
    const bool within = law.relative_error < 1 && worst <= 1;
    count->outside += !within;
    printf(" %.1e | %.1e | %.2f | %s |\n", error, law.relative_error, worst,
           within ? "" : "**outside**");
}

static inline void stress_head(void)
{
    printf("| section | value | true error | estimate | worst entry, true / estimate | |\n"
           "|---|---|---|---|---|---|\n");
}

// all of them, or every third of a row
static inline stress_count stress_all(int step)
{
    stress_count n = {0};
    stress_case c;
    stress_head();
#define EACH(list, make)                                                                           \
    do {                                                                                           \
        const double values[] = list;                                                              \
        for (int i = 0; i < (int)(sizeof values / sizeof *values); i += step) {                    \
            const double v = values[i];                                                            \
            c = make;                                                                              \
            stress_row(&c, &n);                                                                    \
        }                                                                                          \
    } while (0)
#define VALUES(...) {__VA_ARGS__}
    EACH(VALUES(1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8), stress_core(v));
    EACH(VALUES(1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8),
         stress_sector("ring with a stiff sector, contrast", v, v, 0.3, PI / 8));
    EACH(VALUES(1e2, 1e4, 1e6, 1e8),
         stress_sector("the same, nu 0.45 and 0.3, contrast", v, v, 0.45, PI / 8));
    EACH(VALUES(5, 20, 50, 100, 200, 500),
         stress_ring("ring, radius / wall", v, 4e-3, 1 / v, 0.3, 0));
    EACH(VALUES(0, 0.3, 0.45, 0.49, 0.499, 0.4999), stress_ring("ring, nu", v, 4e-3, 0.2, v, 0));
    EACH(VALUES(1e-9, 1e-6, 1e-3, 1, 1e3), stress_ring("ring, radius [m]", v, v, 0.2, 0.3, 0));
    EACH(VALUES(1, 1e2, 1e3, 1e4, 1e5, 1e6),
         stress_ring("ring, distance from the origin / radius", v, 4e-3, 0.2, 0.3, 4e-3 * v));
    EACH(VALUES(1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6), stress_strip(v));
    EACH(VALUES(1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6), stress_film(v));
    EACH(VALUES(1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6),
         stress_sector("ring with a sector, its width [rad]", v, 24, 0.3, v));
#undef VALUES
#undef EACH
    return n;
}
