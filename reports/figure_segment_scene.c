// reports/figure_segment_scene.c
// The view, the magnification and the scales that all loads of a segment share.
#include "reports/figure_segment_view.h"

#include "reports/fig4_paper.h"

#include <float.h>
#include <math.h>

static const double elevation = 0.33; // of the eye [rad]
// the plane of the largest deflection is turned away from the paper by this [rad]
static const double aside = 0.30;

// drawn at true scale when that shows anything
static const double visible_part = 0.02, wanted_part = 0.08; // of the segment's length

static double choose_azimuth(const run_result *r)
{
    double best = 0, angle = 0;
    for (int i = 0; i < r->segment.nload; i++) {
        const double *u = r->segment.load[i].tip_displacement;
        if (hypot(u[0], u[1]) > best) {
            best = hypot(u[0], u[1]);
            angle = atan2(u[1], u[0]);
        }
    }
    const double pi = acos(-1.0);
    if (best <= 1e-3 * r->segment_length) {
        angle = 0;
    }
    // the same line, seen with x to the right rather than to the left
    return (angle > pi / 2 ? angle - pi : angle <= -pi / 2 ? angle + pi : angle) - aside;
}

static void grow(segment_scene *s, vec3 p)
{
    const vec3 seen = camera_see(&s->camera, p);
    for (int k = 0; k < 2; k++) {
        s->low[k] = fmin(s->low[k], seen.a[k]);
        s->high[k] = fmax(s->high[k], seen.a[k]);
    }
}

static void measure(segment_scene *s)
{
    const run_result *r = s->r;
    for (int k = 0; k < 2; k++) {
        s->low[k] = DBL_MAX;
        s->high[k] = -DBL_MAX;
    }
    const segment_body *b = &r->segment.body;
    for (int i = 0; i < b->nlevel * b->plane.nnode; i++) {
        const double *x = b->node + 3 * (size_t)i;
        const vec3 at = {{x[0], x[1], x[2]}};
        grow(s, at);
        for (int l = 0; l < r->segment.nload; l++) {
            const double *u = r->segment.load[l].displacement + 3 * (size_t)i;
            grow(s, vec3_add(at, vec3_scale(s->magnify, (vec3){{u[0], u[1], u[2]}})));
        }
    }
}

status segment_scene_make(const run_result *r, surface_value value, segment_scene *out)
{
    status st = OK;
    segment_scene s = {
        .r = r, .magnify = 1, .value = value, .fig4 = fig4_is(r) && value == SURFACE_DISPLACEMENT};
    const segment_body *body = &r->segment.body;
    double moves = 0;

    TRY(plane_edges_make(&r->segment.body.plane, &s.edges));
    TRY(plane_loops_make(&s.edges, PLANE_WHOLE, &s.loops));
    for (int i = 0; i < s.edges.count; i++) {
        const plane_edge *e = &s.edges.edge[i];
        s.borders = s.borders || (e->other >= 0 && e->other != e->material);
    }
    s.camera = camera_from(choose_azimuth(r), elevation);
    for (int l = 0; l < r->segment.nload; l++) {
        const segment_load_result *load = &r->segment.load[l];
        moves = fmax(moves, segment_largest(body, load, SURFACE_DISPLACEMENT));
        s.largest = fmax(s.largest, segment_largest(body, load, value));
    }
    if (moves > 0 && moves < visible_part * r->segment_length) {
        s.magnify = nice_step(wanted_part * r->segment_length / moves, 1);
    }
    measure(&s);
    *out = s;
    s = (segment_scene){0};

done:
    segment_scene_free(&s);
    return st;
}

void segment_scene_free(segment_scene *s)
{
    plane_edges_free(&s->edges);
    plane_loops_free(&s->loops);
    *s = (segment_scene){0};
}

colour segment_colour(const segment_scene *s, double value, double light)
{
    const colour flat = colour_ramp(s->largest > 0 ? value / s->largest : 0);
    // a narrow range of shade keeps the colour readable against its bar
    const double shade = 0.84 + 0.18 * fmax(light, 0);
    const colour dark = {0, 0, 0, 1};
    return shade < 1 ? colour_mix(dark, flat, shade) : colour_mix(flat, PAPER, shade - 1);
}
