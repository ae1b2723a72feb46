// reports/page_reach_view.c
// A reach study as a scene: the tissue, what of it is reached, targets, and every scope's body at
// every target with the way in.
#include "base/memory.h"
#include "reports/coarse_surface.h"
#include "reports/figure_reach.h"
#include "reports/near_points.h"
#include "reports/page_kit.h"
#include "reports/reach_show.h"
#include "reports/rod_show.h"
#include "reports/scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    TRIANGLES = 10000,  // of the tissue: the page stays small
    TARGETS = 120,      // that are shown
    BODY_POINTS = 48,   // of a body
    MOST_POINTS = 60000 // of all bodies and ways together
};

enum { LAYER_TISSUE, LAYER_MAP, LAYER_BODIES, LAYER_TARGETS, LAYER_LINE, LAYERS };
enum { CHOICE_SCOPE, CHOICE_TARGET, CHOICES };

typedef struct reach_scene {
    const reach_result *r;
    scene *s;
    coarse_surface tissue;
    int ntarget, target[TARGETS];
    char target_name[TARGETS][REACH_NAME + 16], number[TARGETS][16];
    int points; // still to be given out
} reach_scene;

static scene_place place_of(int layer, int scope, int target)
{
    return (scene_place){layer, {scope, target, SCENE_ANY}};
}

// --- the tissue

static status put_map(reach_scene *w, const near_points *near, int scope, unsigned char *kind)
{
    const reach_scope_result *s = &w->r->scope[scope];
    const colour ink[] = {REACH_NO, REACH_YES, REACH_OPEN};
    for (int i = 0; i < w->tissue.nvertex; i++) {
        const int k = near_points_find(near, reach_vec(w->tissue.vertex[i]));
        const int state = k >= 0 ? s->state[k] : MAP_UNDECIDED;
        kind[i] = (unsigned char)(state >= 0 && state <= MAP_UNDECIDED ? state : MAP_UNDECIDED);
    }
    return scene_paint(w->s, place_of(LAYER_MAP, scope, SCENE_ANY), w->tissue.nvertex, kind, 3,
                       ink);
}

static status put_tissue(reach_scene *w)
{
    status st = OK;
    near_points near = {0};
    unsigned char *kind = NULL;
    const coarse_surface *t = &w->tissue;
    TRY(scene_wall(w->s, scene_in(LAYER_TISSUE), t->nvertex, (const double(*)[3])t->vertex,
                   t->ntriangle, (const int(*)[3])t->triangle, TISSUE));
    TRY(near_points_make(w->r->nmap, (const double(*)[3])w->r->map_point, &near));
    TRY(TAKE(kind, (size_t)t->nvertex));
    for (int i = 0; i < w->r->nscope; i++) {
        TRY(w->r->scope[i].state ? put_map(w, &near, i, kind) : OK);
    }
    if (w->r->nmap > 0) {
        TRY(scene_key(w->s, LAYER_MAP, REACH_YES, "wall that the tip reaches"));
        TRY(scene_key(w->s, LAYER_MAP, REACH_NO, "proved not to be reached"));
        TRY(scene_key(w->s, LAYER_MAP, REACH_OPEN, "undecided"));
    }

done:
    near_points_free(&near);
    free(kind);
    return st;
}

// --- targets

static status put_targets(reach_scene *w, int scope, double radius)
{
    status st = OK;
    const colour ink[] = {INK_ACCENT, REACH_YES};
    double point[TARGETS][3];
    unsigned char kind[TARGETS];
    const char *label[TARGETS];
    for (int i = 0; i < w->ntarget; i++) {
        const int k = w->target[i];
        for (int d = 0; d < 3; d++) {
            point[i][d] = w->r->target[k][d];
        }
        kind[i] = w->r->scope[scope].answer[k].verdict == REACH_REACHED;
        label[i] = w->number[i];
    }
    TRY(scene_points(w->s, place_of(LAYER_TARGETS, scope, SCENE_ANY), w->ntarget,
                     (const double(*)[3])point, radius, kind, 2, ink, label));

done:
    return st;
}

// --- bodies

static status put_body(reach_scene *w, int scope, int shown, const reach_answer *a)
{
    status st = OK;
    const reach_scope_result *s = &w->r->scope[scope];
    const scene_place at = place_of(LAYER_BODIES, scope, shown);
    int pick[BODY_POINTS];
    double point[BODY_POINTS][3], room[BODY_POINTS];
    const int n = a->npoint > 1 ? rod_spread(a->npoint, BODY_POINTS, pick) : 0;
    if (n < 2 || w->points < n) {
        return OK;
    }
    for (int i = 0; i < n; i++) {
        for (int d = 0; d < 3; d++) {
            point[i][d] = a->point[pick[i]][d];
        }
        room[i] = reach_part_of(w->r, a, pick[i]) == REACH_LOOKED_AT ? 1e3 * a->room[pick[i]] : NAN;
    }
    w->points -= n;
    TRY(scene_tube(w->s, at, n, (const double(*)[3])point, room, s->radius,
                   a->verdict == REACH_REACHED ? REACH_YES : REACH_NO));
    if (a->nway > 1 && w->points >= a->nway * REACH_WAY_POINTS) {
        w->points -= a->nway * REACH_WAY_POINTS;
        TRY(scene_motion(w->s, at, a->nway, REACH_WAY_POINTS, (const double(*)[3])a->way[0],
                         s->radius, REACH_YES, "way in"));
    }

done:
    return st;
}

static status put_words(reach_scene *w, int scope, int shown, const reach_answer *a)
{
    char words[800], room[160] = "", way[160] = "";
    if (isfinite(a->clearance)) {
        (void)snprintf(room, sizeof room, ", least clearance %s mm at s = %s mm",
                       number_fixed(1e3 * a->clearance, 3).text, number_fixed(1e3 * a->s, 1).text);
    }
    if (isfinite(a->path_clearance)) {
        (void)snprintf(way, sizeof way, ", on the way in %s mm",
                       number_fixed(1e3 * a->path_clearance, 3).text);
    }
    (void)snprintf(words, sizeof words, "Target %s: %s%s%s; the tip is %s mm from it%s%s.",
                   w->target_name[shown], reach_told_words(w->r, &w->r->scope[scope], a), room, way,
                   isfinite(a->miss) ? number_fixed(1e3 * a->miss, 3).text : "–",
                   a->why[0] ? ". " : "", a->why);
    return scene_words(w->s, place_of(LAYER_BODIES, scope, shown), words);
}

static status put_scope(reach_scene *w, int scope)
{
    status st = OK;
    const reach_scope_result *s = &w->r->scope[scope];
    char count[REACH_TEXT], words[480];
    (void)snprintf(words, sizeof words, "%s (%s): %s.", s->name, s->kind,
                   reach_count_words(w->r, scope, count));
    TRY(scene_words(w->s, place_of(LAYER_BODIES, scope, SCENE_ANY), words));
    for (int i = 0; i < w->ntarget; i++) {
        const reach_answer *a = &s->answer[w->target[i]];
        TRY(put_body(w, scope, i, a));
        TRY(put_words(w, scope, i, a));
    }

done:
    return st;
}

// --- all of it

static void find_box(const reach_result *r, scene_spec *spec)
{
    scene_box box = scene_box_empty();
    for (int i = 0; i < r->nvertex; i++) {
        scene_box_add(&box, r->vertex[i]);
    }
    // twice the tissue: shafts outside, and bodies that leave it
    scene_box_put(&box, 2, 0, spec);
}

static double value_most(const reach_result *r)
{
    double radius = 0;
    for (int i = 0; i < r->nscope; i++) {
        radius = fmax(radius, r->scope[i].radius);
    }
    return radius > 0 ? 3e3 * radius : 1;
}

static status open_scene(reach_scene *w)
{
    status st = OK;
    static const char *const layer[LAYERS] = {"tissue", "reach map", "bodies", "targets",
                                              "entry line"};
    const bool on[LAYERS] = {true, false, true, true, true};
    const char **scope = NULL, *target[TARGETS];
    TRY(TAKE(scope, (size_t)w->r->nscope));
    for (int i = 0; i < w->r->nscope; i++) {
        scope[i] = w->r->scope[i].name;
    }
    for (int i = 0; i < w->ntarget; i++) {
        target[i] = w->target_name[i];
    }
    const scene_choice choice[CHOICES] = {{"Scope", w->r->nscope, scope, false, 0},
                                          {"Target", w->ntarget, target, true, SCENE_ANY}};
    scene_spec spec = {.name = "The tissue with targets and scopes",
                       .nlayer = LAYERS,
                       .layer = layer,
                       .on = on,
                       .nchoice = CHOICES,
                       .choice = choice,
                       .value_name = "clearance, mm",
                       .value_most = value_most(w->r)};
    find_box(w->r, &spec);
    if (scene_is_possible(&spec)) {
        TRY(scene_open(&spec, &w->s));
    }

done:
    free(scope);
    return st;
}

static status put_line(reach_scene *w)
{
    const pose e = w->r->entry;
    double point[2][3], size = 0;
    for (int k = 0; k < w->r->nvertex; k++) {
        size = fmax(size, vec3_norm(vec3_sub(reach_vec(w->r->vertex[k]), e.p)));
    }
    for (int d = 0; d < 3; d++) {
        point[0][d] = e.p.a[d] - 0.4 * size * e.R.a[d][2];
        point[1][d] = e.p.a[d] + size * e.R.a[d][2];
    }
    return scene_line(w->s, scene_in(LAYER_LINE), 2, (const double(*)[3])point, INK_FAINT);
}

static status put_all(reach_scene *w)
{
    status st = OK;
    TRY(put_tissue(w));
    TRY(put_line(w));
    TRY(scene_key(w->s, LAYER_TARGETS, REACH_YES, "target reached"));
    TRY(scene_key(w->s, LAYER_TARGETS, INK_ACCENT, "not reached"));
    for (int i = 0; i < w->r->nscope; i++) {
        TRY(put_targets(w, i, 0.5 * fmax(w->r->scope[i].radius, w->r->tolerance)));
        TRY(put_scope(w, i));
    }

done:
    return st;
}

static void choose_targets(reach_scene *w)
{
    w->ntarget = rod_spread(w->r->ntarget, TARGETS, w->target);
    for (int i = 0; i < w->ntarget; i++) {
        const char *name = w->r->target_name[w->target[i]];
        (void)snprintf(w->number[i], sizeof w->number[i], "%d", w->target[i] + 1);
        (void)snprintf(w->target_name[i], sizeof w->target_name[i], "%d%s%s", w->target[i] + 1,
                       name[0] ? ": " : "", name);
    }
}

status page_reach_view(bytes *page, const run_result *r)
{
    status st = OK;
    reach_scene w = {.r = &r->reach, .points = MOST_POINTS};
    if (!r->reach.there || r->reach.nscope < 1) {
        return OK;
    }
    TRY(coarse_surface_make(r->reach.nvertex, (const double(*)[3])r->reach.vertex,
                            r->reach.ntriangle, (const int(*)[3])r->reach.triangle, TRIANGLES,
                            &w.tissue));
    choose_targets(&w);
    TRY(open_scene(&w));
    if (w.s) {
        TRY(put_all(&w));
        TRY(scene_close(
            w.s,
            "Drag to turn, two fingers or shift to move; on the keyboard arrows turn, "
            "+ and − zoom, 0 begins again. Bodies are coloured by their clearance, pale "
            "where the shaft is not looked at; "
            "the near side of the tissue is made of glass.",
            page));
    }

done:
    scene_free(w.s);
    coarse_surface_free(&w.tissue);
    return st;
}
