// bench/rod_cases.h
// The rods that bench_rod measures, and how it measures. Sections from closed forms: needs
// rodsolver and base only.
#pragma once

#include "bench/bench.h"
#include "rodsolver/rod.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static const double pi = 3.14159265358979323846;
static const double length = 0.12;

// --- laws

enum { LAW_NODES = 25 };

// classical K of the annulus with a stiff sector of this width about +x
static inline mat6 annulus_stiffness(double soft, double stiff, double width)
{
    const double outer = 4e-3, inner = 3.2e-3, shear = 1 / (2 * 1.45); // G / E
    const double area = (pow(outer, 2) - pow(inner, 2)) / 2,
                 first = (pow(outer, 3) - pow(inner, 3)) / 3;
    const double second = (pow(outer, 4) - pow(inner, 4)) / 4;
    const double xx = (width + sin(width)) / 2, yy = (width - sin(width)) / 2;
    const double EA = area * (soft * (2 * pi - width) + stiff * width);
    const double x = first * 2 * sin(width / 2) * (stiff - soft) / EA;
    const double EIy = second * (soft * (pi - xx) + stiff * xx) - EA * x * x;
    const double EIx = second * (soft * (pi - yy) + stiff * yy);
    const double diagonal[6] = {shear * EA, shear * EA, EA, EIx, EIy, shear * (EIx + EIy)};
    mat6 K = {0};
    for (int i = 0; i < 6; i++) {
        K.a[i][i] = diagonal[i];
    }
    return beam_law_move(K, -x, 0, 0);
}

// the paper's helical prototype: the sector turns by pi and narrows from pi/4 to pi/8
static inline status helical_law(law_along *out)
{
    status st = OK;
    TRY(law_along_make(length, 1, LAW_NODES, out));
    for (int i = 0; i < LAW_NODES; i++) {
        const double t = law_along_node(out, 0, i) / length;
        out->law[i].K = annulus_stiffness(0.66e6, 15.93e6, pi / 4 - pi / 8 * t);
        out->turn[i] = pi * t;
    }

done:
    return st;
}

static inline status homogeneous_law(law_along *out)
{
    status st = OK;
    TRY(law_along_make(length, 1, 1, out));
    out->law[0].K = annulus_stiffness(0.66e6, 0.66e6, 1);

done:
    return st;
}

// --- tendons

enum { MOST_TENDONS = 200 };

static inline double one_turn(const void *expression, double s)
{
    return *(const double *)expression + 2 * pi * s / length;
}

// n tendons around the wall, straight or in one full turn
static inline void place_tendons(int n, bool turning, tendon_spec *out)
{
    static double start[MOST_TENDONS];
    for (int i = 0; i < n; i++) {
        start[i] = pi / 2 + 2 * pi * i / n;
        out[i] = (tendon_spec){.radius = field_constant(3.6e-3)};
        out[i].angle =
            turning ? (field){.at = one_turn, .expression = &start[i]} : field_constant(start[i]);
    }
}

typedef struct rod_case_at {
    const char *name;
    status (*law)(law_along *);
    int ntendon;
    bool turning;
    double tension[3]; // of the first tendons [N]
    double force[3];   // on the tip, keeping its direction [N]
} rod_case_at;

static inline rod_request bench_request(const rod_case_at *c, const double *tension)
{
    return (rod_request){.tension = tension,
                         .tip_space = {{c->force[0], c->force[1], c->force[2], 0, 0, 0}},
                         .cold = true};
}

// --- a rod at one tolerance

typedef struct bench_rod {
    law_along law;
    tendon_spec tendons[MOST_TENDONS];
    double tension[MOST_TENDONS];
    rod *rod;
    rod_state *state;
} bench_rod;

static inline void bench_rod_free(bench_rod *b)
{
    rod_state_free(b->state);
    rod_free(b->rod);
    law_along_free(&b->law);
}

static inline status bench_rod_make(const rod_case_at *c, double tolerance, int npanel,
                                    bench_rod *b)
{
    status st = OK;
    const rod_options options = {.tolerance = tolerance, .npanel = npanel};
    TRY(c->law(&b->law));
    place_tendons(c->ntendon, c->turning, b->tendons);
    for (int i = 0; i < c->ntendon; i++) {
        b->tension[i] = c->tension[i % 3] * (c->ntendon > 3 ? 3.0 / c->ntendon : 1);
    }
    const rod_spec spec = {.law = &b->law, .ntendon = c->ntendon, .tendons = b->tendons};
    TRY(rod_make(&spec, &options, &b->rod));
    TRY(rod_state_make(b->rod, &b->state));

done:
    return st;
}

// --- times

typedef struct quartiles {
    double low, median, high; // [us]
} quartiles;

static inline double microseconds(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e6 * (double)t.tv_sec + 1e-3 * (double)t.tv_nsec;
}

static inline int compare_times(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// Of one solve, in samples of `repeats` each. Cold: always the same request from rest. Warm: from
// the last answer, all tensions and wrenches going up and down by a percent.
static inline status bench_times(rod_state *state, const rod_request *request, int ntendon,
                                 int repeats, quartiles *out)
{
    enum { SAMPLES = 301 };
    status st = OK;
    double time[SAMPLES], scaled[MOST_TENDONS] = {0};
    rod_solution solution = {0};
    rod_request q = *request;
    q.tension = scaled;
    for (int i = 0; i < SAMPLES; i++) {
        const double start = microseconds();
        for (int k = 0; k < repeats; k++) {
            const double factor = request->cold ? 1 : 1 + 0.01 * (k % 2);
            for (int j = 0; j < ntendon; j++) {
                scaled[j] = factor * request->tension[j];
            }
            for (int c = 0; c < 6; c++) {
                q.tip_space.a[c] = factor * request->tip_space.a[c];
            }
            TRY(rod_solve(state, &q, &solution));
        }
        time[i] = (microseconds() - start) / repeats;
    }
    qsort(time, SAMPLES, sizeof *time, compare_times);
    *out = (quartiles){time[SAMPLES / 4], time[SAMPLES / 2], time[3 * SAMPLES / 4]};

done:
    return st;
}
