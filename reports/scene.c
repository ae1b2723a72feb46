// reports/scene.c
#include "reports/scene.h"

#include "base/memory.h"
#include "reports/scene_page.h"
#include "reports/scene_parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

// --- the head

static void put_choices(scene *s, const scene_spec *spec)
{
    json_array(s->j, "choices");
    for (int i = 0; i < spec->nchoice; i++) {
        const scene_choice *c = &spec->choice[i];
        json_object(s->j, NULL);
        json_text(s->j, "name", c->name);
        json_flag(s->j, "all", c->all);
        json_integer(s->j, "first", c->first);
        scene_put_names(s, "options", c->noption, c->option);
        json_object_end(s->j);
    }
    json_array_end(s->j);
}

static void put_head(scene *s, const scene_spec *spec)
{
    enum { KNOTS = 9 };
    colour ramp[KNOTS];
    for (int i = 0; i < KNOTS; i++) {
        ramp[i] = colour_ramp((double)i / (KNOTS - 1));
    }
    json_object(s->j, NULL);
    json_text(s->j, "unit", "mm");
    json_real(s->j, "size", 1e3 * spec->size);
    json_reals(s->j, "low", 3,
               (double[]){1e3 * spec->low[0], 1e3 * spec->low[1], 1e3 * spec->low[2]});
    scene_put_names(s, "layers", spec->nlayer, spec->layer);
    json_array(s->j, "on");
    for (int i = 0; i < spec->nlayer; i++) {
        json_flag(s->j, NULL, spec->on[i]);
    }
    json_array_end(s->j);
    put_choices(s, spec);
    if (spec->value_name) {
        json_object(s->j, "ramp");
        json_text(s->j, "name", spec->value_name);
        json_real(s->j, "most", spec->value_most);
        scene_put_colours(s, "colours", KNOTS, ramp);
        scene_put_colour(s, "below", INK_ACCENT);
        scene_put_colour(s, "none", NOT_LOOKED_AT);
        json_object_end(s->j);
    }
    json_flag(s->j, "byValue", spec->by_value);
    if (spec->factor.name) {
        json_object(s->j, "factor");
        json_text(s->j, "name", spec->factor.name);
        json_real(s->j, "most", spec->factor.most);
        json_real(s->j, "first", spec->factor.first);
        json_object_end(s->j);
    }
    json_array(s->j, "items");
}

void scene_free(scene *s)
{
    if (s) {
        (void)(s->j ? json_close(s->j) : OK);
        (void)(s->stream ? fclose(s->stream) : 0);
        free(s->text);
        free(s);
    }
}

status scene_open(const scene_spec *spec, scene **out)
{
    status st = OK;
    scene *s = NULL;
    TRY(TAKE(s, 1));
    for (int d = 0; d < 3; d++) {
        s->low[d] = spec->low[d];
    }
    s->size = spec->size;
    s->value_most = spec->value_most;
    s->name = spec->name;
    s->stream = open_memstream(&s->text, &s->length);
    if (!s->stream) {
        TRY(status_fail(ERR_RESOURCE, "not enough memory for a scene"));
    }
    TRY(json_open(s->stream, &s->j));
    put_head(s, spec);
    *out = s;
    s = NULL;

done:
    scene_free(s);
    return st;
}

// --- things

status scene_wall(scene *s, scene_place at, int nvertex, const double (*vertex)[3], int ntriangle,
                  const int (*triangle)[3], colour ink)
{
    status st = OK;
    scene_begin(s, "wall", at);
    scene_put_colour(s, "colour", ink);
    TRY(scene_put_places(s, "points", nvertex, vertex));
    TRY(scene_put_triangles(s, ntriangle, triangle));
    json_object_end(s->j);

done:
    return st;
}

status scene_paint(scene *s, scene_place at, int nvertex, const unsigned char *kind, int nink,
                   const colour *ink)
{
    status st = OK;
    scene_begin(s, "paint", at);
    scene_put_colours(s, "colours", nink, ink);
    TRY(scene_put_bytes(s, "kinds", kind, (size_t)nvertex));
    json_object_end(s->j);

done:
    return st;
}

static status put_tube(scene *s, int nframe, int npoint, const double (*point)[3], double radius,
                       colour ink)
{
    json_integer(s->j, "frames", nframe);
    json_real(s->j, "radius", 1e3 * radius);
    scene_put_colour(s, "colour", ink);
    return scene_put_places(s, "points", nframe * npoint, point);
}

status scene_tube(scene *s, scene_place at, int npoint, const double (*point)[3],
                  const double *value, double radius, colour ink)
{
    status st = OK;
    if (npoint < 1 || !scene_are_numbers(3 * (size_t)npoint, point[0])) {
        return OK;
    }
    scene_begin(s, "tube", at);
    TRY(put_tube(s, 1, npoint, point, radius, ink));
    TRY(value ? scene_put_values(s, "values", npoint, value) : OK);
    json_object_end(s->j);

done:
    return st;
}

status scene_motion(scene *s, scene_place at, int nframe, int npoint, const double (*point)[3],
                    double radius, colour ink, const char *name)
{
    status st = OK;
    if (nframe < 1 || npoint < 1 ||
        !scene_are_numbers(3 * (size_t)nframe * (size_t)npoint, point[0])) {
        return OK;
    }
    scene_begin(s, "tube", at);
    json_text(s->j, "name", name);
    TRY(put_tube(s, nframe, npoint, point, radius, ink));
    json_object_end(s->j);

done:
    return st;
}

status scene_line(scene *s, scene_place at, int npoint, const double (*point)[3], colour ink)
{
    status st = OK;
    if (npoint < 1 || !scene_are_numbers(3 * (size_t)npoint, point[0])) {
        return OK;
    }
    scene_begin(s, "line", at);
    scene_put_colour(s, "colour", ink);
    TRY(scene_put_places(s, "points", npoint, point));
    json_object_end(s->j);

done:
    return st;
}

status scene_points(scene *s, scene_place at, int npoint, const double (*point)[3], double radius,
                    const unsigned char *kind, int nink, const colour *ink,
                    const char *const *label)
{
    status st = OK;
    if (npoint < 1 || !scene_are_numbers(3 * (size_t)npoint, point[0])) {
        return OK;
    }
    scene_begin(s, "points", at);
    json_real(s->j, "radius", 1e3 * radius);
    scene_put_colours(s, "colours", nink, ink);
    TRY(scene_put_places(s, "points", npoint, point));
    TRY(scene_put_bytes(s, "kinds", kind, (size_t)npoint));
    if (label) {
        scene_put_names(s, "labels", npoint, label);
    }
    json_object_end(s->j);

done:
    return st;
}

status scene_words(scene *s, scene_place at, const char *words)
{
    scene_begin(s, "words", at);
    json_text(s->j, "words", words);
    json_object_end(s->j);
    return OK;
}

status scene_key(scene *s, int layer, colour ink, const char *words)
{
    scene_begin(s, "key", scene_in(layer));
    scene_put_colour(s, "colour", ink);
    json_text(s->j, "words", words);
    json_object_end(s->j);
    return OK;
}

// --- into the page

status scene_close(scene *s, const char *caption, bytes *page)
{
    status st = OK;
    json_array_end(s->j);
    json_object_end(s->j);
    json *j = s->j;
    s->j = NULL;
    TRY(json_close(j));
    if (fflush(s->stream) != 0) {
        TRY(status_fail(ERR_RESOURCE, "not enough memory for a scene"));
    }
    TRY(scene_figure(s->name, s->text, s->length, caption, page));

done:
    return st;
}
