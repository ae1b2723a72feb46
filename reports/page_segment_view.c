// reports/page_segment_view.c
// The segment in space under each of its loads: by displacement or by material, with a slider for
// how much larger than they are its displacements are drawn.
#include "base/memory.h"
#include "reports/figure_segment_view.h"
#include "reports/page_kit.h"
#include "reports/scene.h"
#include "reports/segment_skin.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { LOADS = 8, INKS = 16, NAME = 160, LAYER_SEGMENT = 0, LAYER_FORCE, LAYERS };

typedef struct segment_space {
    const run_result *r;
    scene *s;
    int nload;
    char name[LOADS][NAME];
    segment_skin skin[LOADS];
    double largest; // displacement of all [mm]
    double magnify; // as the drawn picture has it
} segment_space;

static scene_place place_of(int layer, int load)
{
    return (scene_place){layer, {SCENE_ANY, load, SCENE_ANY}};
}

static status put_words(segment_space *w, int load)
{
    const segment_load_result *l = &w->r->segment.load[load];
    const double degree = 180 / acos(-1.0);
    char words[700];
    (void)snprintf(
        words, sizeof words,
        "%s: acts at (%s, %s) mm. Shortening %s mm, tip angle %s deg, tip twist %s deg, mid "
        "curvature (%s, %s) 1/m; largest displacement at the surface %s mm.",
        w->name[load], number_fixed(1e3 * l->point[0], 4).text,
        number_fixed(1e3 * l->point[1], 4).text, number_fixed(1e3 * l->shortening, 5).text,
        number_fixed(degree * hypot(l->tip_rotation[0], l->tip_rotation[1]), 4).text,
        number_fixed(degree * l->tip_rotation[2], 4).text,
        number_fixed(l->mid_curvature[0], 4).text, number_fixed(l->mid_curvature[1], 4).text,
        number_digits(1e3 * segment_largest(&w->r->segment.body, l, SURFACE_DISPLACEMENT), 4).text);
    return scene_words(w->s, place_of(LAYER_SEGMENT, load), words);
}

// a line to where the load acts on the tip at rest, from where it comes
static status put_force(segment_space *w, int load)
{
    const segment_load_result *l = &w->r->segment.load[load];
    const double size =
        sqrt(l->force[0] * l->force[0] + l->force[1] * l->force[1] + l->force[2] * l->force[2]);
    double point[2][3];
    if (!(size > 0)) {
        return OK;
    }
    for (int d = 0; d < 3; d++) {
        point[0][d] = d < 2 ? l->point[d] : w->r->segment_length;
        point[1][d] = point[0][d] - 0.3 * w->r->segment_length * l->force[d] / size;
    }
    return scene_line(w->s, place_of(LAYER_FORCE, load), 2, (const double(*)[3])point, INK_ACCENT);
}

static status put_load(segment_space *w, int load)
{
    status st = OK;
    const segment_skin *k = &w->skin[load];
    double *value = NULL;
    TRY(TAKE(value, (size_t)k->nvertex));
    for (int i = 0; i < k->nvertex; i++) {
        value[i] = 1e3 * k->value[i];
    }
    TRY(scene_moved(w->s, place_of(LAYER_SEGMENT, load), k->nvertex, (const double(*)[3])k->move,
                    value, w->name[load]));
    TRY(put_force(w, load));
    TRY(put_words(w, load));

done:
    free(value);
    return st;
}

static status put_solid(segment_space *w)
{
    status st = OK;
    const segment_skin *k = &w->skin[0];
    colour ink[INKS];
    bool used[INKS] = {false};
    for (int m = 0; m < INKS; m++) {
        ink[m] = colour_material(m);
    }
    for (int i = 0; i < k->nvertex; i++) {
        used[k->material[i] % INKS] = true;
    }
    TRY(scene_solid(w->s, scene_in(LAYER_SEGMENT), k->nvertex, (const double(*)[3])k->at,
                    k->ntriangle, (const int(*)[3])k->triangle, k->material, INKS, ink));
    for (int m = 0; m < INKS && m < w->r->nmaterial; m++) {
        TRY(used[m] ? scene_key(w->s, LAYER_SEGMENT, ink[m], w->r->materials[m].name) : OK);
    }
    TRY(scene_key(w->s, LAYER_FORCE, INK_ACCENT, "where the force acts"));

done:
    return st;
}

// --- all of it

// all that is drawn at the largest factor
static void find_box(const segment_space *w, scene_spec *spec)
{
    scene_box box = scene_box_empty();
    for (int i = 0; i < w->skin[0].nvertex; i++) {
        scene_box_add(&box, w->skin[0].at[i]);
    }
    scene_box_put(&box, 1.5, 0, spec);
}

static status open_scene(segment_space *w)
{
    static const char *const layer[LAYERS] = {"segment", "force"};
    static const char *const colours[] = {"material", "displacement"};
    const bool on[LAYERS] = {true, true};
    const char *name[LOADS];
    for (int i = 0; i < w->nload; i++) {
        name[i] = w->name[i];
    }
    const scene_choice choice[] = {{"Colour by", 2, colours, false, 1},
                                   {"Load", w->nload, name, false, 0}};
    scene_spec spec = {.name = "The deformed segment in space",
                       .nlayer = LAYERS,
                       .layer = layer,
                       .on = on,
                       .nchoice = 2,
                       .choice = choice,
                       .value_name = "displacement, size in mm",
                       .value_most = w->largest > 0 ? w->largest : 1,
                       .by_value = true,
                       .factor = {"Displacements times", 2 * w->magnify, w->magnify}};
    find_box(w, &spec);
    return scene_is_possible(&spec) ? scene_open(&spec, &w->s) : OK;
}

static bool all_is_here(const run_result *r)
{
    const segment_body *b = &r->segment.body;
    bool here = r->segment.nload > 0 && b->nlevel > 1 && b->first == 0 && b->last == b->nlevel;
    for (int i = 0; here && i < r->segment.nload; i++) {
        here = r->segment.load[i].displacement != NULL;
    }
    return here;
}

static status take_skins(segment_space *w)
{
    status st = OK;
    segment_scene drawn = {0};
    TRY(segment_scene_make(w->r, SURFACE_DISPLACEMENT, &drawn));
    w->magnify = drawn.magnify;
    w->largest = 1e3 * drawn.largest;
    w->nload = w->r->segment.nload < LOADS ? w->r->segment.nload : LOADS;
    for (int i = 0; i < w->nload; i++) {
        const segment_load_result *l = &w->r->segment.load[i];
        (void)snprintf(w->name[i], NAME, "%.150s", l->name ? l->name : "load");
        TRY(segment_skin_make(&w->r->segment.body, l, &w->skin[i]));
    }

done:
    segment_scene_free(&drawn);
    return st;
}

status page_segment_view(bytes *page, const run_result *r)
{
    status st = OK;
    segment_space w = {.r = r};
    if (!all_is_here(r)) {
        return OK;
    }
    TRY(take_skins(&w));
    if (w.skin[0].nvertex > 0 && w.skin[0].nvertex <= UINT16_MAX) {
        TRY(open_scene(&w));
    }
    if (w.s) {
        TRY(put_solid(&w));
        for (int i = 0; i < w.nload; i++) {
            TRY(put_load(&w, i));
        }
        TRY(scene_close(w.s,
                        "Drag to turn, two fingers or shift to move; on the keyboard arrows turn, "
                        "+ and − zoom, 0 begins again. The slider multiplies the displacements.",
                        page));
    }

done:
    scene_free(w.s);
    for (int i = 0; i < LOADS; i++) {
        segment_skin_free(&w.skin[i]);
    }
    return st;
}
