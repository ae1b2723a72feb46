// reports/figure_rod_loads.c
// Arrows for what acts on a rod. Full ones keep their direction in space (dead), hollow ones turn
// with the section (followers); two heads mean a moment about the arrow.
#include "reports/figure_rod_scene.h"

#include <math.h>
#include <stdio.h>

enum { LISTED = 6 };

static const double row = 19;
static const double point_part = 0.2, line_part = 0.12; // of the scene's size, the longest arrows

static pose pose_at(const rod_result *rod, const struct rod_run *run, double s, double length)
{
    const double last = rod->npoint - 1, at = fmin(fmax(s / length * last, 0), last);
    const int k = at < last ? (int)at : rod->npoint - 2;
    const pose *a = &run->shape[k], *b = a + 1;
    return (pose){at - k < 0.5 ? a->R : b->R,
                  vec3_add(a->p, vec3_scale(at - k, vec3_sub(b->p, a->p)))};
}

static vec3 in_space(const rod_load_sketch *l, const pose *at, vec3 v)
{
    return l->frame == LOAD_BODY ? mat3_mul_vec(at->R, v) : v;
}

// --- their lengths

void rod_loads_measure(rod_scene *s)
{
    const rod_result *rod = &s->r->rod;
    for (int i = 0; i < s->show->ndetail; i++) {
        for (int j = 0; j < rod->nload; j++) {
            const rod_load_sketch *l = &rod->load_sketch[j];
            const double factor = fabs(rod->run[s->show->detail[i]].load[j]);
            double *force = l->kind == LOAD_AT_POINT ? &s->force : &s->density,
                   *moment = l->kind == LOAD_AT_POINT ? &s->moment : &s->line_moment;
            for (int k = 0; k < LOAD_PLACES; k++) {
                *force = fmax(*force, factor * vec3_norm(l->force[k]));
                *moment = fmax(*moment, factor * vec3_norm(l->moment[k]));
            }
        }
    }
}

// --- one by one

typedef struct looker {
    const rod_scene *scene;
    rod_arrow_visit *visit;
    void *data;
} looker;

// v in the load's unit, drawn `part` of the scene long where it is as large as `largest`
static void look_at(const looker *w, const rod_load_sketch *l, const pose *at, vec3 from, vec3 v,
                    double largest, double part, bool moment)
{
    const double scale = part * w->scene->size / largest;
    if (!(largest > 0) || !(vec3_norm(v) > 1e-3 * largest) || !isfinite(scale)) {
        return;
    }
    const vec3 along = vec3_scale(scale, in_space(l, at, v));
    // what pushes the tip inwards ends there: elsewhere it would hide the rod
    const vec3 inwards = mat3_mul_vec(at->R, (vec3){{0, 0, -1}});
    const bool pushes = l->kind == LOAD_AT_POINT && !moment &&
                        l->from >= w->scene->r->rod_length * (1 - 1e-9) &&
                        vec3_dot(along, inwards) > 0.7 * vec3_norm(along);
    from = pushes ? vec3_sub(from, along) : from;
    const rod_arrow a = {.from = from,
                         .to = vec3_add(from, along),
                         .follower = l->frame == LOAD_BODY,
                         .moment = moment,
                         .many = l->kind != LOAD_AT_POINT};
    w->visit(&a, w->data);
}

static void visit_load(const looker *w, const struct rod_run *run, const rod_load_sketch *l,
                       double factor)
{
    const rod_scene *s = w->scene;
    const bool point = l->kind == LOAD_AT_POINT;
    const double part = point ? point_part : line_part;
    for (int k = 0; k < (point ? 1 : LOAD_PLACES); k++) {
        const double at = l->from + (l->to - l->from) * k / (LOAD_PLACES - 1);
        const pose here = pose_at(&s->r->rod, run, at, s->r->rod_length);
        const vec3 arm = {{l->place[k][0], l->place[k][1], 0}};
        const vec3 from = vec3_scale(1e3, vec3_add(here.p, mat3_mul_vec(here.R, arm)));
        look_at(w, l, &here, from, vec3_scale(factor, l->force[k]), point ? s->force : s->density,
                part, false);
        look_at(w, l, &here, vec3_scale(1e3, here.p), vec3_scale(factor, l->moment[k]),
                point ? s->moment : s->line_moment, part, true);
    }
}

void rod_loads_visit(const rod_scene *s, rod_arrow_visit *visit, void *data)
{
    const rod_result *rod = &s->r->rod;
    const looker w = {s, visit, data};
    for (int i = 0; i < s->show->ndetail; i++) {
        const struct rod_run *run = &rod->run[s->show->detail[i]];
        for (int j = 0; j < rod->nload; j++) {
            if (rod->load_sketch[j].kind != LOAD_GRAVITY) {
                visit_load(&w, run, &rod->load_sketch[j], run->load[j]);
            }
        }
    }
}

// --- drawing

static void paper_arrow(canvas *c, const double a[2], const double b[2], const rod_arrow *kind)
{
    const double length = hypot(b[0] - a[0], b[1] - a[1]), back = fmin(7, 0.3 * length);
    const double ux = (b[0] - a[0]) / fmax(length, 1e-9), uy = (b[1] - a[1]) / fmax(length, 1e-9);
    void (*draw)(canvas *, double, double, double, double, colour, double) =
        kind->follower ? arrow_hollow
        : kind->many   ? arrow
                       : arrow_bordered;
    const colour ink = kind->follower ? LOAD_FOLLOWER : INK;
    const double width = kind->many ? 1 : 2.2;
    draw(c, a[0], a[1], b[0], b[1], ink, width);
    if (kind->moment) {
        draw(c, a[0], a[1], b[0] - back * ux, b[1] - back * uy, ink, width);
    }
}

static void draw_arrow(const rod_arrow *a, void *data)
{
    const rod_view *v = data;
    double from[2], to[2];
    rod_view_at(v, a->from, from);
    rod_view_at(v, a->to, to);
    paper_arrow(v->c, from, to, a);
}

void rod_loads_draw(const rod_scene *s, const rod_view *v)
{
    rod_view copy = *v;
    rod_loads_visit(s, draw_arrow, &copy);
}

static const rod_load_sketch *gravity_of(const rod_result *rod)
{
    for (int j = 0; j < rod->nload; j++) {
        if (rod->load_sketch[j].kind == LOAD_GRAVITY) {
            return &rod->load_sketch[j];
        }
    }
    return NULL;
}

typedef struct crowd {
    const rod_view *view;
    double x, y, radius;
    int count;
} crowd;

static void count_near(vec3 mm, void *data)
{
    crowd *w = data;
    double at[2];
    rod_view_at(w->view, mm, at);
    w->count += hypot(at[0] - w->x, at[1] - w->y) < w->radius;
}

// the middle of the emptiest corner
static void find_corner(const rod_scene *s, const rod_view *v, box at, double radius, double out[2])
{
    int least = -1;
    for (int i = 0; i < 4; i++) {
        crowd w = {.view = v, .radius = radius};
        w.x = i & 1 ? at.x + at.w - radius : at.x + radius;
        w.y = i & 2 ? at.y + at.h - radius : at.y + radius;
        rod_scene_points(s, count_near, &w);
        if (least < 0 || w.count < least) {
            least = w.count;
            out[0] = w.x;
            out[1] = w.y;
        }
    }
}

void rod_gravity_draw(const rod_scene *s, const rod_view *v, box at)
{
    const double half = 17, radius = 24, beside = 12;
    const rod_load_sketch *l = gravity_of(&s->r->rod);
    const double size = l ? vec3_norm(l->acceleration) : 0;
    double o[2];
    if (!(size > 0) || !isfinite(size)) {
        return;
    }
    const vec3 seen = camera_see(&v->camera, vec3_scale(half / size, l->acceleration));
    find_corner(s, v, at, radius + 8, o);
    canvas_circle(v->c, o[0], o[1], radius);
    canvas_stroke(v->c, INK_FAINT, 0.8);
    if (hypot(seen.a[0], seen.a[1]) < 0.1 * half) {
        canvas_circle(v->c, o[0], o[1], 5);
        canvas_stroke(v->c, INK, 1.6);
        canvas_circle(v->c, o[0], o[1], seen.a[2] > 0 ? 1.8 : 0.9);
        canvas_fill(v->c, INK);
    } else {
        arrow(v->c, o[0] - seen.a[0], o[1] + seen.a[1], o[0] + seen.a[0], o[1] - seen.a[1], INK,
              2.6);
    }
    say(v->c, o[0] + beside, o[1] - 6, look_inked(LOOK_SMALL, INK), "g");
}

// --- in words

static int listed(const rod_result *rod)
{
    return rod->nload < LISTED ? rod->nload : LISTED;
}

double rod_loads_legend_height(const rod_result *rod)
{
    return rod->nload == 0 ? 0 : row * ((listed(rod) + 1) / 2 + (rod->nload > LISTED)) + 6;
}

static double largest(const vec3 *v)
{
    double most = 0;
    for (int k = 0; k < LOAD_PLACES; k++) {
        most = fmax(most, vec3_norm(v[k]));
    }
    return most;
}

static void load_words(const rod_result *rod, int load, char *text, size_t size)
{
    const rod_load_sketch *l = &rod->load_sketch[load];
    const char *name = rod->load_name[load];
    const double force = largest(l->force), moment = largest(l->moment);
    const char *frame = l->frame == LOAD_BODY ? "turning with the section" : "fixed in space";
    const bool line = l->kind == LOAD_ALONG_LINE;
    char where[100], forces[60] = "", moments[60] = "";
    if (l->kind == LOAD_GRAVITY) {
        (void)snprintf(text, size, "%s: %s m/s²", name,
                       number_short(vec3_norm(l->acceleration), 4).text);
        return;
    }
    if (line) {
        (void)snprintf(where, sizeof where, "s = %s to %s mm", number_short(1e3 * l->from, 4).text,
                       number_short(1e3 * l->to, 4).text);
    } else {
        (void)snprintf(where, sizeof where, "s = %s mm", number_short(1e3 * l->from, 4).text);
    }
    if (force > 0) {
        (void)snprintf(forces, sizeof forces, "%s %s, ", number_short(force, 3).text,
                       line ? "N/m" : "N");
    }
    if (moment > 0) {
        (void)snprintf(moments, sizeof moments, "%s %s, ",
                       number_short(line ? moment : 1e3 * moment, 3).text, line ? "N" : "N mm");
    }
    (void)snprintf(text, size, "%s: %s%s%s, %s", name, forces, moments, where, frame);
}

void rod_loads_legend(canvas *c, const rod_result *rod, box at)
{
    const double width = at.w / 2;
    for (int i = 0; i < listed(rod); i++) {
        const rod_load_sketch *l = &rod->load_sketch[i];
        const double x = at.x + width * (i % 2), y = at.y + 12 + row * (i / 2);
        const double a[2] = {x, y - 4}, b[2] = {x + 24, y - 4};
        const rod_arrow kind = {.follower = l->frame == LOAD_BODY,
                                .moment = largest(l->moment) > 0 && largest(l->force) == 0,
                                .many = l->kind == LOAD_ALONG_LINE};
        char text[320];
        load_words(rod, i, text, sizeof text);
        paper_arrow(c, a, b, &kind);
        say_within(c, x + 32, y, width - 40, look_inked(LOOK_SMALL, INK), text);
    }
    if (rod->nload > LISTED) {
        say(c, at.x, at.y + 12 + row * ((LISTED + 1) / 2), LOOK_SMALL, "and %d more loads",
            rod->nload - LISTED);
    }
}
