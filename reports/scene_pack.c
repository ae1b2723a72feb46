// reports/scene_pack.c
// How a scene writes what it holds: numbers as text of 64 letters, colours, names.
#include "reports/scene_parts.h"

#include "base/memory.h"
#include "reports/base64.h"

#include <math.h>
#include <stdlib.h>

// --- packed numbers

bool scene_are_numbers(size_t n, const double *x)
{
    for (size_t i = 0; i < n; i++) {
        if (!isfinite(x[i])) {
            return false;
        }
    }
    return true;
}

static uint16_t step_of(const scene *s, double x, int d)
{
    const double step = round((x - s->low[d]) / s->size * UINT16_MAX);
    return step > 0 ? (step < UINT16_MAX ? (uint16_t)step : UINT16_MAX) : 0;
}

// st: of what filled the text, which is freed
static status put_text(scene *s, const char *key, bytes *text, status st)
{
    if (st == OK) {
        json_text(s->j, key, text->data ? text->data : "");
    }
    bytes_free(text);
    return st;
}

status scene_put_bytes(scene *s, const char *key, const void *data, size_t count)
{
    bytes text = {0};
    return put_text(s, key, &text, base64_append(&text, data, count));
}

status scene_put_words(scene *s, const char *key, size_t n, const uint16_t *word)
{
    bytes text = {0};
    return put_text(s, key, &text, base64_append_words(&text, word, n));
}

status scene_put_places(scene *s, const char *key, int n, const double (*point)[3])
{
    status st = OK;
    uint16_t *word = NULL;
    TRY(TAKE(word, 3 * (size_t)n));
    for (int i = 0; i < 3 * n; i++) {
        word[i] = step_of(s, point[i / 3][i % 3], i % 3);
    }
    TRY(scene_put_words(s, key, 3 * (size_t)n, word));

done:
    free(word);
    return st;
}

// 0: less than 0; 1 .. 254: from 0 to value_most; 255: no number
status scene_put_values(scene *s, const char *key, int n, const double *value)
{
    status st = OK;
    unsigned char *step = NULL;
    TRY(TAKE(step, (size_t)n));
    for (int i = 0; i < n; i++) {
        const double share = value[i] / s->value_most;
        step[i] = value[i] < 0 ? 0 : (unsigned char)(1 + 253 * (share < 1 ? share : 1));
        step[i] = isnan(value[i]) ? 255 : step[i];
    }
    TRY(scene_put_bytes(s, key, step, (size_t)n));

done:
    free(step);
    return st;
}

static unsigned part_of(double x)
{
    return (unsigned)lround(255 * fmin(fmax(x, 0), 1));
}

void scene_put_colour(scene *s, const char *key, colour c)
{
    char text[8];
    (void)snprintf(text, sizeof text, "#%02x%02x%02x", part_of(c.r), part_of(c.g), part_of(c.b));
    json_text(s->j, key, text);
}

void scene_put_colours(scene *s, const char *key, int n, const colour *c)
{
    json_array(s->j, key);
    for (int i = 0; i < n; i++) {
        scene_put_colour(s, NULL, c[i]);
    }
    json_array_end(s->j);
}

void scene_put_names(scene *s, const char *key, int n, const char *const *name)
{
    json_array(s->j, key);
    for (int i = 0; i < n; i++) {
        json_text(s->j, NULL, name[i]);
    }
    json_array_end(s->j);
}

void scene_begin(scene *s, const char *kind, scene_place at)
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

status scene_put_triangles(scene *s, int n, const int (*triangle)[3])
{
    status st = OK;
    uint16_t *word = NULL;
    TRY(TAKE(word, 3 * (size_t)n));
    for (int i = 0; i < 3 * n; i++) {
        word[i] = (uint16_t)triangle[i / 3][i % 3];
    }
    TRY(scene_put_words(s, "triangles", 3 * (size_t)n, word));

done:
    free(word);
    return st;
}
