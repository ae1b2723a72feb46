// reports/scene.c
#include "reports/scene.h"

#include "base/memory.h"
#include "io/json.h"
#include "reports/base64.h"
#include "reports/scene_page.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct scene {
    double low[3], size;
    double value_most;
    const char *name;
    char *text; // of the JSON document, by open_memstream
    size_t length;
    FILE *stream;
    json *j;
};

// --- packed numbers

static uint16_t step_of(const scene *s, double x, int d)
{
    const double step = round((x - s->low[d]) / s->size * UINT16_MAX);
    return step > 0 ? (step < UINT16_MAX ? (uint16_t)step : UINT16_MAX) : 0;
}

static status put_packed(scene *s, const char *key, const void *data, size_t count)
{
    status st = OK;
    bytes text = {0};
    TRY(base64_append(&text, data, count));
    json_text(s->j, key, text.data ? text.data : "");

done:
    bytes_free(&text);
    return st;
}

static status put_words(scene *s, const char *key, size_t n, const uint16_t *word)
{
    status st = OK;
    bytes text = {0};
    TRY(base64_append_words(&text, word, n));
    json_text(s->j, key, text.data ? text.data : "");

done:
    bytes_free(&text);
    return st;
}

static status put_places(scene *s, const char *key, int n, const double (*point)[3])
{
    status st = OK;
    uint16_t *word = NULL;
    TRY(TAKE(word, 3 * (size_t)n));
    for (int i = 0; i < 3 * n; i++) {
        word[i] = step_of(s, point[i / 3][i % 3], i % 3);
    }
    TRY(put_words(s, key, 3 * (size_t)n, word));

done:
    free(word);
    return st;
}

// 0: less than 0; 1 .. 254: from 0 to value_most; 255: no number
static status put_values(scene *s, const char *key, int n, const double *value)
{
    status st = OK;
    unsigned char *step = NULL;
    TRY(TAKE(step, (size_t)n));
    for (int i = 0; i < n; i++) {
        const double share = value[i] / s->value_most;
        step[i] = value[i] < 0 ? 0 : (unsigned char)(1 + 253 * (share < 1 ? share : 1));
        step[i] = isnan(value[i]) ? 255 : step[i];
    }
    TRY(put_packed(s, key, step, (size_t)n));

done:
    free(step);
    return st;
}

static unsigned part_of(double x)
{
    return (unsigned)lround(255 * fmin(fmax(x, 0), 1));
}

static void put_colour(scene *s, const char *key, colour c)
{
    char text[8];
    (void)snprintf(text, sizeof text, "#%02x%02x%02x", part_of(c.r), part_of(c.g), part_of(c.b));
    json_text(s->j, key, text);
}

static void put_colours(scene *s, const char *key, int n, const colour *c)
{
    json_array(s->j, key);
    for (int i = 0; i < n; i++) {
        put_colour(s, NULL, c[i]);
    }
    json_array_end(s->j);
}

static void put_names(scene *s, const char *key, int n, const char *const *name)
{
    json_array(s->j, key);
    for (int i = 0; i < n; i++) {
        json_text(s->j, NULL, name[i]);
    }
    json_array_end(s->j);
}

// --- the head

static void put_choices(scene *s, const scene_spec *spec)
{
    json_array(s->j, "choices");
    for (int i = 0; i < spec->nchoice; i++) {
        const scene_choice *c = &spec->choice[i];
        json_object(s->j, NULL);
        json_text(s->j, "name", c->name);
        json_flag(s->j, "all", c->all);
        put_names(s, "options", c->noption, c->option);
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
    put_names(s, "layers", spec->nlayer, spec->layer);
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
        put_colours(s, "colours", KNOTS, ramp);
        put_colour(s, "below", INK_ACCENT);
        put_colour(s, "none", INK_FAINT);
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

static void begin(scene *s, const char *kind, scene_place at)
{
    json_object(s->j, NULL);
    json_text(s->j, "kind", kind);
    json_integer(s->j, "layer", at.layer);
    json_array(s->j, "at");
    for (int i = 0; i < SCENE_CHOICES; i++) {
        json_integer(s->j, NULL, at.option[i]);
    }
    json_array_end(s->j);
}

static status put_triangles(scene *s, int n, const int (*triangle)[3])
{
    status st = OK;
    uint16_t *word = NULL;
    TRY(TAKE(word, 3 * (size_t)n));
    for (int i = 0; i < 3 * n; i++) {
        word[i] = (uint16_t)triangle[i / 3][i % 3];
    }
    TRY(put_words(s, "triangles", 3 * (size_t)n, word));

done:
    free(word);
    return st;
}

status scene_wall(scene *s, scene_place at, int nvertex, const double (*vertex)[3], int ntriangle,
                  const int (*triangle)[3], colour ink)
{
    status st = OK;
    begin(s, "wall", at);
    put_colour(s, "colour", ink);
    TRY(put_places(s, "points", nvertex, vertex));
    TRY(put_triangles(s, ntriangle, triangle));
    json_object_end(s->j);

done:
    return st;
}

status scene_paint(scene *s, scene_place at, int nvertex, const unsigned char *kind, int nink,
                   const colour *ink)
{
    status st = OK;
    begin(s, "paint", at);
    put_colours(s, "colours", nink, ink);
    TRY(put_packed(s, "kinds", kind, (size_t)nvertex));
    json_object_end(s->j);

done:
    return st;
}

static status put_tube(scene *s, int nframe, int npoint, const double (*point)[3], double radius,
                       colour ink)
{
    json_integer(s->j, "frames", nframe);
    json_real(s->j, "radius", 1e3 * radius);
    put_colour(s, "colour", ink);
    return put_places(s, "points", nframe * npoint, point);
}

status scene_tube(scene *s, scene_place at, int npoint, const double (*point)[3],
                  const double *value, double radius, colour ink)
{
    status st = OK;
    begin(s, "tube", at);
    TRY(put_tube(s, 1, npoint, point, radius, ink));
    TRY(value ? put_values(s, "values", npoint, value) : OK);
    json_object_end(s->j);

done:
    return st;
}

status scene_motion(scene *s, scene_place at, int nframe, int npoint, const double (*point)[3],
                    double radius, colour ink, const char *name)
{
    status st = OK;
    begin(s, "tube", at);
    json_text(s->j, "name", name);
    TRY(put_tube(s, nframe, npoint, point, radius, ink));
    json_object_end(s->j);

done:
    return st;
}

status scene_line(scene *s, scene_place at, int npoint, const double (*point)[3], colour ink)
{
    status st = OK;
    begin(s, "line", at);
    put_colour(s, "colour", ink);
    TRY(put_places(s, "points", npoint, point));
    json_object_end(s->j);

done:
    return st;
}

status scene_points(scene *s, scene_place at, int npoint, const double (*point)[3], double radius,
                    const unsigned char *kind, int nink, const colour *ink,
                    const char *const *label)
{
    status st = OK;
    begin(s, "points", at);
    json_real(s->j, "radius", 1e3 * radius);
    put_colours(s, "colours", nink, ink);
    TRY(put_places(s, "points", npoint, point));
    TRY(put_packed(s, "kinds", kind, (size_t)npoint));
    if (label) {
        put_names(s, "labels", npoint, label);
    }
    json_object_end(s->j);

done:
    return st;
}

status scene_words(scene *s, scene_place at, const char *words)
{
    begin(s, "words", at);
    json_text(s->j, "words", words);
    json_object_end(s->j);
    return OK;
}

status scene_key(scene *s, int layer, colour ink, const char *words)
{
    begin(s, "key", scene_in(layer));
    put_colour(s, "colour", ink);
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
