// reports/page_rod_view.c
// The rod's solutions in space: each with its section around it, by material or by strain, its
// tendons, and its numbers in words.
#include "base/memory.h"
#include "reports/figure_rod_style.h"
#include "reports/page_kit.h"
#include "reports/page_rod_parts.h"
#include "reports/rod_outline.h"
#include "reports/scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    RINGS = 61,     // along a rod
    SOLUTIONS = 60, // that can be chosen
    TENDONS = 8,    // that are drawn
    NAME = 256,     // of a solution
    LAYER_ROD = 0,  // the layers
    LAYER_TENDONS,
    LAYER_REST,
    LAYERS,
    CHOICE_COLOUR = 0, // the choices
    CHOICE_SOLUTION,
    CHOICES
};

typedef struct rod_space {
    const run_result *r;
    scene *s;
    rod_outline outline;
    int nsolution, solution[SOLUTIONS];
    char name[SOLUTIONS][NAME];
    int nring, ring[RINGS];
    double (*strain)[3]; // [nsolution][nring] of the axis [%], and its slopes [% / m]
    double most;         // size of the strain [%]
} rod_space;

static const struct rod_run *run_of(const rod_space *w, int shown)
{
    return &w->r->rod.run[w->solution[shown]];
}

static scene_place place_of(int layer, int shown)
{
    return (scene_place){layer, {SCENE_ANY, shown, SCENE_ANY}};
}

// --- strain: what the section's law answers to its wrench, e = K^-1 f; along z it is
// eps + kappa_x y - kappa_y x

static void strain_at(const rod_space *w, const struct rod_run *run, int point, double out[3])
{
    mat6 K, lower;
    vec6 e = {{0, 0, run->stretch[point][2], run->curvature[point][0], run->curvature[point][1]}};
    if (w->r->has_section && w->r->section.along.law) {
        law_along_at(&w->r->section.along, run->s[point], &K, NULL);
        e = mat6_cholesky(K, &lower) ? mat6_cholesky_solve(&lower, run->wrench[point]) : e;
    }
    out[0] = 100 * e.a[2];
    out[1] = -100 * e.a[4];
    out[2] = 100 * e.a[3];
}

static status find_strains(rod_space *w)
{
    status st = OK;
    TRY(TAKE(w->strain, (size_t)w->nsolution * (size_t)w->nring));
    for (int i = 0; i < w->nsolution; i++) {
        for (int k = 0; k < w->nring; k++) {
            double *e = w->strain[i * w->nring + k];
            strain_at(w, run_of(w, i), w->ring[k], e);
            const double turn = w->outline.turn[k], c = cos(turn), s = sin(turn);
            for (int p = 0; p < w->outline.npoint; p++) {
                const double *at = w->outline.point[p];
                w->most = fmax(w->most, fabs(e[0] + e[1] * (c * at[0] - s * at[1]) +
                                             e[2] * (s * at[0] + c * at[1])));
            }
        }
    }
    w->most = w->most > 0 && isfinite(w->most) ? w->most : 1;

done:
    return st;
}

// --- things

static status put_tendons(rod_space *w, int shown)
{
    status st = OK;
    const rod_result *rod = &w->r->rod;
    const struct rod_run *run = run_of(w, shown);
    for (int t = 0; t < rod->ntendon && t < TENDONS; t++) {
        double point[RINGS][3];
        int n = 0;
        for (int k = 0; k < w->nring && run->s[w->ring[k]] <= rod->tendon_end[t] * (1 + 1e-9);
             k++) {
            const pose *at = &run->shape[w->ring[k]];
            const double *place = rod->tendon_path[t * rod->npoint + w->ring[k]];
            const vec3 p = vec3_add(at->p, mat3_mul_vec(at->R, (vec3){{place[0], place[1], 0}}));
            for (int d = 0; d < 3; d++) {
                point[n][d] = p.a[d];
            }
            n++;
        }
        TRY(n > 1 ? scene_line(w->s, place_of(LAYER_TENDONS, shown), n, (const double(*)[3])point,
                               INK_ACCENT)
                  : OK);
    }

done:
    return st;
}

static status put_words(rod_space *w, int shown)
{
    const struct rod_run *run = run_of(w, shown);
    const double *tip = run->tip.p.a;
    const int decimals = rod_decimals(w->r);
    char words[800];
    (void)snprintf(
        words, sizeof words,
        "Solution %d: %s. Tip at (%s, %s, %s) mm, bend %s deg, largest strain %s %%%s%s",
        w->solution[shown] + 1, w->name[shown], number_fixed(1e3 * tip[0], decimals).text,
        number_fixed(1e3 * tip[1], decimals).text, number_fixed(1e3 * tip[2], decimals).text,
        number_fixed(run->total_bend_rad * 180 / acos(-1.0), 2).text,
        number_digits(100 * run->largest_strain, 3).text,
        result_beyond_linear(w->r, run) >= 0 ? ", past what keeps it linear" : "",
        run->fraction < 1  ? "; it stops at a limit point."
        : run->stable == 0 ? "; unstable."
                           : ".");
    return scene_words(w->s, place_of(LAYER_ROD, shown), words);
}

static status put_solution(rod_space *w, int shown)
{
    status st = OK;
    pose shape[RINGS];
    for (int k = 0; k < w->nring; k++) {
        shape[k] = run_of(w, shown)->shape[w->ring[k]];
    }
    TRY(scene_rod(w->s, place_of(LAYER_ROD, shown), w->nring, shape,
                  (const double(*)[3])w->strain[(size_t)shown * (size_t)w->nring], w->name[shown]));
    TRY(put_tendons(w, shown));
    TRY(put_words(w, shown));

done:
    return st;
}

static status put_rest(rod_space *w)
{
    double point[RINGS][3];
    for (int k = 0; k < w->nring; k++) {
        for (int d = 0; d < 3; d++) {
            point[k][d] = w->r->rod.rest[w->ring[k]].p.a[d];
        }
    }
    return scene_line(w->s, scene_in(LAYER_REST), w->nring, (const double(*)[3])point, INK_SOFT);
}

static status put_key(rod_space *w)
{
    status st = OK;
    for (int m = 0; m < w->outline.nink; m++) {
        char words[2 * RESULT_NAME + 96];
        if (!w->outline.plain && w->outline.used[m]) {
            (void)snprintf(words, sizeof words, "%.100s", w->r->materials[m].name);
            TRY(scene_key(w->s, LAYER_ROD, w->outline.colour[m], words));
        }
    }
    TRY(w->r->rod.ntendon > 0 ? scene_key(w->s, LAYER_TENDONS, INK_ACCENT, "tendon") : OK);
    TRY(rod_rest_is_known(&w->r->rod) ? scene_key(w->s, LAYER_REST, INK_SOFT, "without load") : OK);
    if (w->outline.why[0]) {
        TRY(scene_words(w->s, scene_in(LAYER_ROD), w->outline.why));
    }

done:
    return st;
}

// --- all of it

static void find_box(const rod_space *w, scene_spec *spec)
{
    scene_box box = scene_box_empty();
    for (int i = 0; i < w->nsolution * w->nring; i++) {
        scene_box_add(&box, run_of(w, i / w->nring)->shape[w->ring[i % w->nring]].p.a);
    }
    for (int k = 0; k < w->nring && rod_rest_is_known(&w->r->rod); k++) {
        scene_box_add(&box, w->r->rod.rest[w->ring[k]].p.a);
    }
    scene_box_put(&box, 1, 4 * w->outline.radius, spec); // tendons run outside some sections
}

static status open_scene(rod_space *w)
{
    static const char *const layer[LAYERS] = {"rod", "tendons", "shape without load"};
    static const char *const colours[] = {"material", "strain"};
    const bool on[LAYERS] = {true, true, true};
    const char *name[SOLUTIONS];
    for (int i = 0; i < w->nsolution; i++) {
        name[i] = w->name[i];
    }
    const scene_choice choice[CHOICES] = {
        {"Colour by", 2, colours, false, 0},
        {"Tensions and loads", w->nsolution, name, true, w->nsolution - 1}};
    scene_spec spec = {.name = "The rod in space",
                       .nlayer = LAYERS,
                       .layer = layer,
                       .on = on,
                       .nchoice = CHOICES,
                       .choice = choice,
                       .value_name = "axial strain at the surface, size in %",
                       .value_most = w->most,
                       .by_value = true};
    find_box(w, &spec);
    return scene_is_possible(&spec) ? scene_open(&spec, &w->s) : OK;
}

static status choose(rod_space *w)
{
    status st = OK;
    rod_show show = {0};
    const rod_result *rod = &w->r->rod;
    TRY(rod_show_make(rod, &show));
    w->nsolution = rod_spread(rod->nsolution, SOLUTIONS, w->solution);
    for (int i = 0; i < w->nsolution; i++) {
        rod_label(&show, w->solution[i], w->name[i], NAME);
    }
    w->nring = rod_spread(rod->npoint, RINGS, w->ring);

done:
    rod_show_free(&show);
    return st;
}

static status put_all(rod_space *w)
{
    status st = OK;
    TRY(scene_skin(w->s,
                   &(scene_outline){w->outline.nloop, w->outline.loop,
                                    (const double(*)[2])w->outline.point, w->outline.ink,
                                    w->outline.nink, w->outline.colour},
                   w->nring, w->outline.turn));
    TRY(rod_rest_is_known(&w->r->rod) ? put_rest(w) : OK);
    TRY(put_key(w));
    for (int i = 0; i < w->nsolution; i++) {
        TRY(put_solution(w, i));
    }

done:
    return st;
}

status page_rod_view(bytes *page, const run_result *r)
{
    status st = OK;
    rod_space w = {.r = r};
    double s[RINGS];
    if (r->rod.nsolution < 1 || r->rod.npoint < 2) {
        return OK;
    }
    TRY(choose(&w));
    for (int k = 0; k < w.nring; k++) {
        s[k] = r->rod.run[0].s[w.ring[k]];
    }
    TRY(rod_outline_make(r, w.nring, s, &w.outline));
    TRY(find_strains(&w));
    TRY(open_scene(&w));
    if (w.s) {
        TRY(put_all(&w));
        TRY(scene_close(w.s,
                        "Drag to turn, two fingers or shift to move; on the keyboard arrows turn, "
                        "+ and − zoom, 0 begins again. The slider goes through the solutions. "
                        "Strain: that of the section's law, along the rod.",
                        page));
    }

done:
    scene_free(w.s);
    rod_outline_free(&w.outline);
    free(w.strain);
    return st;
}
