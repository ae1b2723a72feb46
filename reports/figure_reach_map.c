// reports/figure_reach_map.c
// What of the wall each scope's tip reaches: the near half from outside, the far half from inside.
#include "base/memory.h"
#include "reports/figure_reach.h"
#include "reports/figures.h"
#include "reports/near_points.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { RASTER = 260, HALVES = 2, SIDES = 2, PANELS = HALVES * SIDES, STATES = 3, LIGHTS = 3 };

static const double side = 28, head = 96, foot = 52, sheet_width = 1000, gap = 24, title = 46,
                    highest = 330;
static const int shown_view[SIDES] = {1, 2}; // of reach_camera

// the near or the far half of the wall on one view
typedef struct map_half {
    const wall_view *view;
    bool near;
    int *sample;            // [nx ny] the map's sample nearest to the wall there; -1: outside
    contours outline;       // of the wall
    contours light[LIGHTS]; // where it is turned away from the eye, more and more
} map_half;

typedef struct map_sheet {
    const run_result *r;
    wall_view view[SIDES];
    map_half half[PANELS];
    contours *state; // [nscope][PANELS][STATES]
    double scale, row;
} map_sheet;

static colour state_ink(int state)
{
    return state == MAP_REACHED ? WALL_YES : state == MAP_NOT_REACHED ? WALL_NO : WALL_OPEN;
}

// --- the wall

static status trace_light(map_half *h)
{
    status st = OK;
    const wall_view *v = h->view;
    const size_t n = (size_t)v->nx * (size_t)v->ny;
    raster inside = {v->nx, v->ny, NULL}, smooth = inside;
    TRY(TAKE(inside.value, n));
    TRY(TAKE(smooth.value, n));
    for (size_t k = 0; k < n; k++) {
        inside.value[k] = v->near[k] > -INFINITY;
    }
    raster_smooth(&inside, &smooth);
    TRY(contours_make(&smooth, 0.5, 0.3, 4, &h->outline));
    for (size_t k = 0; k < n; k++) {
        inside.value[k] =
            v->near[k] > -INFINITY ? 1 - (h->near ? v->near_light : v->far_light)[k] : 0;
    }
    raster_smooth(&inside, &smooth);
    raster_smooth(&smooth, &inside);
    for (int i = 0; i < LIGHTS; i++) {
        TRY(contours_make(&inside, 0.25 * (i + 1), 0.4, 12, &h->light[i]));
    }

done:
    free(inside.value);
    free(smooth.value);
    return st;
}

static status find_samples(const near_points *near, map_half *h)
{
    status st = OK;
    const wall_view *v = h->view;
    TRY(TAKE(h->sample, (size_t)v->nx * (size_t)v->ny));
    for (int k = 0; k < v->nx * v->ny; k++) {
        h->sample[k] =
            v->near[k] > -INFINITY ? near_points_find(near, wall_view_place(v, k, h->near)) : -1;
    }

done:
    return st;
}

// --- a scope's states on it

static status trace_state(const map_half *h, const reach_scope_result *s, int state, contours *out)
{
    status st = OK;
    const int n = h->view->nx * h->view->ny;
    raster mask = {h->view->nx, h->view->ny, NULL}, smooth = mask;
    TRY(TAKE(mask.value, (size_t)n));
    TRY(TAKE(smooth.value, (size_t)n));
    for (int k = 0; k < n; k++) {
        mask.value[k] = h->sample[k] >= 0 && s->state[h->sample[k]] == state;
    }
    raster_smooth(&mask, &smooth);
    // specks of a few samples are kept, those of less are not
    TRY(contours_make(&smooth, 0.5, 0.5, 6, out));

done:
    free(mask.value);
    free(smooth.value);
    return st;
}

static contours *state_of(const map_sheet *w, int scope, int panel, int state)
{
    return &w->state[(scope * PANELS + panel) * STATES + state];
}

// --- drawing

static void draw_half(canvas *c, const map_sheet *w, int scope, int panel, double x, double y)
{
    const map_half *h = &w->half[panel];
    const double step = w->scale * h->view->step;
    contours_path(c, &h->outline, x, y, step);
    canvas_fill(c, state_ink(MAP_UNDECIDED));
    for (int state = 0; state < MAP_UNDECIDED; state++) {
        contours_path(c, state_of(w, scope, panel, state), x, y, step);
        canvas_fill(c, state_ink(state));
    }
    for (int i = 0; i < LIGHTS; i++) {
        contours_path(c, &h->light[i], x, y, step);
        canvas_fill(c, (colour){0.1, 0.1, 0.15, 0.11});
    }
    contours_path(c, &h->outline, x, y, step);
    canvas_stroke(c, INK_SOFT, 0.8);
}

static void row(canvas *c, const map_sheet *w, int scope)
{
    const reach_scope_result *s = &w->r->reach.scope[scope];
    const double y = head + w->row * scope;
    char words[400];
    (void)snprintf(words, sizeof words, "%s: %s ± %s %% of the wall reached%s%s%s", s->name,
                   number_fixed(100 * s->area_reached, 1).text,
                   number_fixed(100 * s->area_error, 1).text, s->area_undecided > 0 ? ", " : "",
                   s->area_undecided > 0 ? number_fixed(100 * s->area_undecided, 1).text : "",
                   s->area_undecided > 0 ? " % undecided" : "");
    say_within(c, side, y, sheet_width - 2 * side, LOOK_HEADING, words);
    double x = side;
    for (int p = 0; p < PANELS; p++) {
        const wall_view *v = w->half[p].view;
        const double high = w->scale * v->step * v->ny;
        say(c, x, y + 17, LOOK_SMALL, "%s",
            p % HALVES == 0 ? "from outside" : "far side, from inside");
        draw_half(c, w, scope, p, x, y + title - 12 + (w->row - title - gap + high) / 2);
        if (p % HALVES == 0) {
            reach_axes(c, &v->camera, x + 6, y + w->row - gap - 6);
        }
        x += w->scale * v->step * v->nx + gap;
    }
}

static double sheet_height(const map_sheet *w)
{
    return head + w->row * w->r->reach.nscope + foot;
}

static status draw(canvas *c, const void *data)
{
    static const int order[STATES] = {MAP_REACHED, MAP_NOT_REACHED, MAP_UNDECIDED};
    static const char *const words[STATES] = {"reached", "proved not to be reached", "undecided"};
    const map_sheet *w = data;
    const double y = sheet_height(w) - 16;
    double x = side;
    say(c, side, 36, LOOK_TITLE, "What of the wall each scope reaches");
    reach_source_line(c, side, 56, sheet_width - 2 * side, w->r);
    for (int i = 0; i < w->r->reach.nscope; i++) {
        row(c, w, i);
    }
    for (int i = 0; i < STATES; i++) {
        canvas_rectangle(c, x, y - 10, 16, 11);
        canvas_fill(c, state_ink(order[i]));
        say(c, x + 22, y, LOOK_SMALL, "%s", words[i]);
        x += 46 + canvas_text_width(c, &LOOK_SMALL, words[i]);
    }
    say(c, x, y, LOOK_SMALL, "Left pair: %s; right pair: %s. %d samples.",
        reach_camera_name(shown_view[0]), reach_camera_name(shown_view[1]), w->r->reach.nmap);
    scale_bar(c, sheet_width - side, y, 80, w->scale / 1e3);
    return OK;
}

// --- all of it

static status make_halves(map_sheet *w)
{
    status st = OK;
    const reach_result *r = &w->r->reach;
    wall tissue = {0};
    near_points near = {0};
    double width = 0, height = 0;
    TRY(wall_make(r->nvertex, (const double(*)[3])r->vertex, r->ntriangle,
                  (const int(*)[3])r->triangle, &tissue));
    TRY(near_points_make(r->nmap, (const double(*)[3])r->map_point, &near));
    for (int k = 0; k < SIDES; k++) {
        const camera c = reach_camera(shown_view[k]);
        TRY(wall_view_make(&tissue, &c, RASTER, &w->view[k]));
        width += HALVES * w->view[k].step * w->view[k].nx;
        height = fmax(height, w->view[k].step * w->view[k].ny);
    }
    for (int p = 0; p < PANELS; p++) {
        w->half[p].view = &w->view[p / HALVES];
        w->half[p].near = p % HALVES == 0;
        TRY(find_samples(&near, &w->half[p]));
        TRY(trace_light(&w->half[p]));
    }
    w->scale = fmin((sheet_width - 2 * side - (PANELS - 1) * gap) / width, highest / height);
    w->row = title + gap + w->scale * height;

done:
    wall_free(&tissue);
    near_points_free(&near);
    return st;
}

static status trace_states(map_sheet *w)
{
    status st = OK;
    const int n = w->r->reach.nscope;
    TRY(TAKE(w->state, (size_t)n * PANELS * STATES));
    for (int i = 0; i < n * PANELS * STATES; i++) {
        const int scope = i / (PANELS * STATES), panel = i / STATES % PANELS, state = i % STATES;
        const reach_scope_result *s = &w->r->reach.scope[scope];
        TRY(s->state ? trace_state(&w->half[panel], s, state, &w->state[i]) : OK);
    }

done:
    return st;
}

static void free_sheet(map_sheet *w)
{
    for (int i = 0; w->state && i < w->r->reach.nscope * PANELS * STATES; i++) {
        contours_free(&w->state[i]);
    }
    free(w->state);
    for (int p = 0; p < PANELS; p++) {
        free(w->half[p].sample);
        contours_free(&w->half[p].outline);
        for (int i = 0; i < LIGHTS; i++) {
            contours_free(&w->half[p].light[i]);
        }
    }
    for (int k = 0; k < SIDES; k++) {
        wall_view_free(&w->view[k]);
    }
}

status figure_reach_map(const run_result *r, const char *dir)
{
    status st = OK;
    map_sheet w = {.r = r};
    if (!r->reach.there || r->reach.nscope < 1 || r->reach.nmap < 1) {
        return OK;
    }
    TRY(make_halves(&w));
    TRY(trace_states(&w));
    if (isfinite(w.row) && w.row > 0) {
        const picture p = {
            .name = "reach_map",
            .title = "The wall from outside and from inside: what each scope reaches of it",
            .width = sheet_width,
            .height = sheet_height(&w),
            .draw = draw,
            .data = &w,
        };
        TRY(picture_write(&p, dir));
    }

done:
    free_sheet(&w);
    return st;
}
