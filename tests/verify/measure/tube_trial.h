// One synthetic cloud, its centreline found, and how far that lies from the known one.
#pragma once

#include "measure/tube.h"
#include "tests/test.h"
#include "tests/verify/measure/made_cloud.h"

#include <time.h>

typedef struct tube_trial {
    status st;
    double rms, worst; // of |p(s) - known p(s)| [m], over the shorter of the two lines
    double tip;        // |p(end) - known p(L)| [m]
    double seconds;    // of processor time
    centreline line;
    tube_report report;
} tube_trial;

static inline void trial_free(tube_trial *t)
{
    centreline_free(&t->line);
}

static inline void trial_compare(const made_line *known, tube_trial *t)
{
    const centreline *c = &t->line;
    int n = 0;
    for (int i = 0; i < c->count && c->s[i] <= known->length; i++, n++) {
        const double d = vec3_norm(vec3_sub(c->p[i], made_line_at(known, c->s[i]).p));
        t->rms += d * d;
        t->worst = fmax(t->worst, d);
    }
    t->rms = sqrt(t->rms / n);
    t->tip = vec3_norm(vec3_sub(c->p[c->count - 1], made_line_at(known, known->length).p));
}

static inline tube_trial trial_of(const made_line *known, const made_scan *scan,
                                  const tube_options *options)
{
    tube_trial t = {.st = OK};
    point_cloud cloud = {0};
    CHECK_OK(made_cloud(known, scan, &cloud));
    const clock_t start = clock();
    t.st = tube_centreline(&cloud, options, &t.line, &t.report);
    t.seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    point_cloud_free(&cloud);
    if (t.st == OK) {
        trial_compare(known, &t);
    }
    return t;
}

static inline void trial_print(const char *name, const tube_trial *t)
{
    if (t->st != OK) {
        printf("%-34s %s\n", name, status_message());
        return;
    }
    printf("%-34s rms %6.4f worst %6.4f tip %6.4f radius %7.4f +- %6.4f noise %6.4f sigma(L/2) "
           "%6.4f smoothing %4.1f length %8.4f +- %5.3f %2d gaps %5.2f s\n",
           name, t->rms * 1e3, t->worst * 1e3, t->tip * 1e3, t->report.radius_free * 1e3,
           t->report.radius_free_sigma * 1e3, t->report.noise * 1e3,
           t->line.sigma[t->line.count / 2] * 1e3, t->report.smoothing * 1e3,
           t->report.length * 1e3, t->report.length_sigma * 1e3, t->report.ngap, t->seconds);
}

// base plane and direction known, as after a registration
static inline tube_options trial_options(double radius)
{
    tube_options o = tube_options_default();
    o.radius = radius;
    o.base = (vec3){{0, 0, 0}};
    o.direction = (vec3){{0, 0, 1}};
    o.base_is_plane = true;
    return o;
}
