// tests/verify/section/campaign.h
// The error estimate of every kind of section against its true error: a reference two levels finer
// than the mesh at hand, with half the element length and two more layers towards corners.
#pragma once

#include "section/estimate.h"
#include "section/solve.h"
#include "tests/sections.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

// What the estimate must keep: the truth below this many times of it, and it below this many times
// the truth (the latter in nine of ten).
static const double most_true = 3, most_estimate = 30;

typedef struct campaign {
    int count, below, beyond; // true error beyond 3 x estimate; estimate beyond 30 x true error
} campaign;

typedef struct measured {
    beam_law law;
    mesh_options mesh; // what it was solved with
    double seconds;    // CPU of this process: mesh of a mapped section, estimate and all
} measured;

static inline double cpu_seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

static inline status sample_solve(const sample *s, const mesh_options *mesh, double tolerance,
                                  measured *out)
{
    status st = OK;
    section_case c = section_case_default();
    section_place p = {.drawn = true, .scale = 1, .turn_rate = s->turn_rate};
    material bound[SAMPLE_MATERIALS];
    section_used used = {0};
    c.mesh = *mesh;
    c.tolerance = tolerance;
    for (int i = 0; i < SAMPLE_MATERIALS; i++) {
        bound[i] = s->material[i];
        TRY(bound[i].name ? material_bind(&bound[i]) : OK);
    }
    TRY(shapes_at((shape_list){.count = s->nshape, .items = s->shape}, 0, &p.outline));
    const double begin = cpu_seconds();
    TRY(section_solve_place(&c, bound, &p, &out->law, &used));
    out->seconds = cpu_seconds() - begin;

done:
    out->mesh = used.mesh;
    section_place_free(&p);
    return st;
}

// the reference's own error is the law's, an order of magnitude below what it judges
static inline status sample_reference(const sample *s, const mesh_options *judged, beam_law *out)
{
    status st = OK;
    measured m = {0};
    mesh_options fine = mesh_options_default();
    fine.finer = 2 * fmax(judged->finer, 1);
    // more of them than a tolerance ever asks for are finer than gmsh can draw
    fine.layers =
        judged->layers + 2 < SECTION_MOST_LAYERS ? judged->layers + 2 : SECTION_MOST_LAYERS;
    TRY(sample_solve(s, &fine, 0, &m));
    *out = m.law;

done:
    return st;
}

// the entry whose true error, beyond what the reference says of itself, is largest against its
// estimate
static inline double worst_entry(const beam_law *law, const beam_law *truth)
{
    double worst = 0;
    for (int i = 0; i < 36; i++) {
        const int r = i / 6, c = i % 6;
        const double size = sqrt(truth->K.a[r][r] * truth->K.a[c][c]);
        const double error = fabs(law->K.a[r][c] - truth->K.a[r][c]) / size;
        worst = fmax(worst, (error - truth->entry_error.a[r][c]) / law->entry_error.a[r][c]);
    }
    return worst;
}

static inline void campaign_row(campaign *sum, const char *name, const char *mesh,
                                const measured *m, const beam_law *truth)
{
    const double error = mat6_relative_error(m->law.K, truth->K);
    const double worst = worst_entry(&m->law, truth), over = m->law.relative_error / error;
    const bool below = worst > most_true, beyond = over > most_estimate;
    sum->count++;
    sum->below += below;
    sum->beyond += beyond;
    printf("| %-30s | %-9s | %8.1e | %8.1e | %7.2f | %6.2f | %6.1f |%s\n", name, mesh, error,
           m->law.relative_error, over, worst, 1e3 * m->seconds,
           below    ? " true error beyond the estimate"
           : beyond ? " estimate far beyond"
                    : "");
}

static inline void campaign_head(void)
{
    printf("| section | mesh | true error | estimate | estimate / true | worst entry, true / "
           "estimate | CPU ms |\n|---|---|---|---|---|---|---|\n");
}
