// reports/scene_parts.h
// What the files of scene.h share.
#pragma once

#include "io/json.h"
#include "reports/scene.h"

#include <stdint.h>
#include <stdio.h>

struct scene {
    double low[3], size;
    double value_most;
    double skin; // how far the last one reaches from its origin [m]
    const char *name;
    char *text; // of the JSON document, by open_memstream
    size_t length;
    FILE *stream;
    json *j;
};

bool scene_are_numbers(size_t n, const double *x);
status scene_put_bytes(scene *s, const char *key, const void *data, size_t count);
status scene_put_words(scene *s, const char *key, size_t n, const uint16_t *word);
status scene_put_places(scene *s, const char *key, int n, const double (*point)[3]);
status scene_put_values(scene *s, const char *key, int n, const double *value);
void scene_put_colour(scene *s, const char *key, colour c);
void scene_put_colours(scene *s, const char *key, int n, const colour *c);
void scene_put_names(scene *s, const char *key, int n, const char *const *name);
void scene_begin(scene *s, const char *kind, scene_place at);
status scene_put_triangles(scene *s, int n, const int (*triangle)[3]);
