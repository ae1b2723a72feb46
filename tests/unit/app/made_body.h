// tests/unit/app/made_body.h
// A case's text -> its body.
#pragma once

#include "app/segment_source.h"
#include "tests/unit/app/body_volume.h"

#include <string.h>
#include <unistd.h>

static const double PI = 3.14159265358979323846;

static const char start[] =
    "format: 1\n"
    "materials: {soft: {E_MPa: 0.66, nu: 0.3}, stiff: {E_MPa: 15.93, nu: "
    "0.3}, plain: {E_MPa: 1, nu: 0},\n"
    "  wood: {E1_MPa: 10, E2_MPa: 1, E3_MPa: 0.8, nu12: 0.3, nu13: 0.3, nu23: 0.3, G12_MPa: 0.7, "
    "G13_MPa: 0.7, G23_MPa: 0.3},\n"
    "  graded: {E_MPa: 1 + 200*x, nu: 0.3}, along: {E_MPa: 1 + 10*s, nu: 0}}\n"
    "section:\n";
static const char annulus[] =
    "    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3.2}, material: soft}\n";

enum { MOST_LAYERS = 400 };

typedef struct made {
    case_data c;
    segment_source source;
    mesh plane;
    body_spec spec;
    body body;
} made;

static inline status read_case(const char *section, const char *rest, case_data *c)
{
    char path[] = "/tmp/stiffaxis-test-XXXXXX";
    const int number = mkstemp(path);
    FILE *file = number < 0 ? NULL : fdopen(number, "w");
    CHECK(file != NULL);
    fprintf(file, "%s%s%s", start, section, rest);
    CHECK(fclose(file) == 0);
    status_clear();
    const status st = case_open(&(case_request){.path = path}, c);
    (void)unlink(path);
    return st;
}

// layer: [nlayer + 1] over the length, from 0 to 1
static inline status make_on(const char *section, const char *rest, segment_mesh ask, int nlayer,
                             const double *layer, made *m)
{
    status st = OK;
    double s[MOST_LAYERS + 1];
    *m = (made){0};
    TRY(read_case(section, rest, &m->c));
    TRY(segment_source_make(&m->c, &m->source));
    TRY(m->source.plane(m->source.self, &ask, &m->plane));
    m->spec = (body_spec){.plane = &m->plane,
                          .materials = m->source.materials,
                          .order = ask.order,
                          .nlayer = nlayer,
                          .layer = s};
    for (int i = 0; i <= nlayer && nlayer <= MOST_LAYERS; i++) {
        s[i] = m->c.file.fem.length * layer[i];
    }
    if (m->source.fixed_layers) {
        m->spec.nlayer = m->source.nlayer;
        m->spec.layer = m->source.layer;
    }
    if (m->source.course) {
        TRY(m->source.course(m->source.self, &m->plane, &m->spec));
    }
    TRY(body_make(&m->spec, &m->body));

done:
    return st;
}

// layers that grow towards the middle, all alike where grading is 1: middle over end
static inline status make_graded(const char *section, const char *rest, segment_mesh ask,
                                 int nlayer, double grading, made *m)
{
    double layer[MOST_LAYERS + 1] = {0};
    for (int i = 0; i < nlayer; i++) {
        const int from_end = i < nlayer - 1 - i ? i : nlayer - 1 - i;
        layer[i + 1] = layer[i] + pow(grading, from_end / ((nlayer - 1) / 2 + 1e-9));
    }
    for (int i = 0; i <= nlayer; i++) {
        layer[i] /= layer[nlayer];
    }
    return make_on(section, rest, ask, nlayer, layer, m);
}

static inline status make(const char *section, const char *rest, segment_mesh ask, int nlayer,
                          made *m)
{
    return make_graded(section, rest, ask, nlayer, 1, m);
}

static inline void unmake(made *m)
{
    body_free(&m->body);
    if (m->source.release) {
        m->source.release(m->source.self, &m->spec);
    }
    mesh_free(&m->plane);
    segment_source_free(&m->source);
    case_free(&m->c);
}

static const segment_mesh fine = {.order = 4, .size = 0.6e-3};
