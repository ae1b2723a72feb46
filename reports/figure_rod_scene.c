// reports/figure_rod_scene.c
#include "reports/figure_rod_scene.h"

#include <math.h>

enum { MOST_TENDONS = 12, PLATE_CORNERS = 24 };

void rod_view_at(const rod_view *v, vec3 mm, double at[2])
{
    const vec3 seen = camera_see(&v->camera, mm);
    at[0] = v->x0 + v->scale * seen.a[0];
    at[1] = v->y0 - v->scale * seen.a[1];
}

void rod_view_line(const rod_view *v, vec3 from, vec3 to)
{
    double a[2], b[2];
    rod_view_at(v, from, a);
    rod_view_at(v, to, b);
    canvas_segment(v->c, a[0], a[1], b[0], b[1]);
}

static vec3 mm(vec3 m)
{
    return vec3_scale(1e3, m);
}

// a result that was not told its shape at rest holds zeros
static bool rest_is_known(const rod_result *rod)
{
    return rod->rest && rod->rest[0].R.a[2][2] * rod->rest[0].R.a[2][2] +
                                rod->rest[0].R.a[1][2] * rod->rest[0].R.a[1][2] +
                                rod->rest[0].R.a[0][2] * rod->rest[0].R.a[0][2] >
                            0.5;
}

// --- how large it all is

static void shape_points(const rod_scene *s, rod_point_visit *visit, void *data)
{
    const rod_result *rod = &s->r->rod;
    for (int i = 0; i < s->show->nshown; i++) {
        for (int k = 0; k < rod->npoint; k = rod_next_point(rod, k)) {
            visit(mm(rod->run[s->show->shown[i]].shape[k].p), data);
        }
    }
    for (int i = 0; i < rod->nsolution && s->show->sweep; i++) {
        visit(mm(rod->run[i].tip.p), data);
    }
    for (int k = 0; k < rod->npoint && rest_is_known(rod); k = rod_next_point(rod, k)) {
        visit(mm(rod->rest[k].p), data);
    }
}

typedef struct visitor {
    rod_point_visit *visit;
    void *data;
} visitor;

static void both_ends(const rod_arrow *a, void *data)
{
    const visitor *v = data;
    v->visit(a->from, v->data);
    v->visit(a->to, v->data);
}

void rod_scene_points(const rod_scene *s, rod_point_visit *visit, void *data)
{
    visitor v = {visit, data};
    shape_points(s, visit, data);
    rod_loads_visit(s, both_ends, &v);
}

static void grow(vec3 p, void *data)
{
    rod_scene *s = data;
    for (int d = 0; d < 3; d++) {
        s->least[d] = fmin(s->least[d], p.a[d]);
        s->most[d] = fmax(s->most[d], p.a[d]);
    }
}

rod_scene rod_scene_make(const run_result *r, const rod_show *show)
{
    rod_scene s = {.r = r, .show = show};
    const vec3 base = mm(r->rod.run[0].shape[0].p);
    for (int d = 0; d < 3; d++) {
        s.least[d] = s.most[d] = base.a[d];
    }
    shape_points(&s, grow, &s);
    for (int d = 0; d < 3; d++) {
        s.size = fmax(s.size, s.most[d] - s.least[d]);
    }
    s.size = isfinite(s.size) ? fmax(s.size, 1e-9) : 1e-9;
    rod_loads_measure(&s);
    rod_scene_points(&s, grow, &s);
    return s;
}

// --- drawing

static void follow(const rod_view *v, vec3 p, bool first)
{
    double at[2];
    rod_view_at(v, p, at);
    if (first) {
        canvas_move(v->c, at[0], at[1]);
    } else {
        canvas_line(v->c, at[0], at[1]);
    }
}

static void rest_shape_line(const rod_scene *s, const rod_view *v)
{
    const rod_result *rod = &s->r->rod;
    if (!rest_is_known(rod)) {
        return;
    }
    for (int k = 0; k < rod->npoint; k = rod_next_point(rod, k)) {
        follow(v, mm(rod->rest[k].p), k == 0);
    }
    canvas_dash(v->c, 4, 3);
    canvas_stroke(v->c, INK_SOFT, 1.2);
    canvas_dash(v->c, 0, 0);
}

static void curve(const rod_scene *s, const rod_view *v, int solution)
{
    const struct rod_run *run = &s->r->rod.run[solution];
    for (int k = 0; k < s->r->rod.npoint; k = rod_next_point(&s->r->rod, k)) {
        follow(v, mm(run->shape[k].p), k == 0);
    }
    if (run->stable == 0) {
        canvas_dash(v->c, 5, 2.5);
    }
    canvas_stroke(v->c, s->show->ink[solution], s->show->sweep ? 1.6 : 2.3);
    canvas_dash(v->c, 0, 0);
}

static void tip_mark(const rod_scene *s, const rod_view *v, int solution)
{
    const struct rod_run *run = &s->r->rod.run[solution];
    const colour ink = s->show->ink[solution];
    double at[2];
    rod_view_at(v, mm(run->tip.p), at);
    canvas_circle(v->c, at[0], at[1], s->show->sweep ? 2.8 : 4);
    if (run->fraction < 1) {
        canvas_fill_stroke(v->c, PAPER, ink, 1.8);
    } else {
        canvas_fill_stroke(v->c, ink, PAPER, s->show->sweep ? 0.8 : 1.3);
    }
}

// through the tips of every line of a sweep, in its colour where there are several; a very long one
// by every so many of them
static void tip_paths(const rod_scene *s, const rod_view *v)
{
    enum { MOST_POINTS = 4000 };
    const rod_result *rod = &s->r->rod;
    const int stride = 1 + rod->nsolution / MOST_POINTS;
    for (int i = 0; i < s->show->nline && s->show->sweep; i++) {
        const rod_line *l = &s->show->line[i];
        for (int k = 0; k < l->count; k += stride) {
            follow(v, mm(rod->run[l->first + k].tip.p), k == 0);
        }
        follow(v, mm(rod->run[l->first + l->count - 1].tip.p), false);
        canvas_stroke(v->c, s->show->nline > 1 ? s->show->ink[l->first] : INK, 1.1);
    }
}

static void tendon_lines(const rod_scene *s, const rod_view *v, int solution)
{
    const rod_result *rod = &s->r->rod;
    const struct rod_run *run = &rod->run[solution];
    for (int t = 0; t < rod->ntendon && t < MOST_TENDONS; t++) {
        for (int k = 0; k < rod->npoint && run->s[k] <= rod->tendon_end[t] * (1 + 1e-9);
             k = rod_next_point(rod, k)) {
            const double *place = rod->tendon_path[t * rod->npoint + k];
            const vec3 arm = mat3_mul_vec(run->shape[k].R, (vec3){{place[0], place[1], 0}});
            follow(v, mm(vec3_add(run->shape[k].p, arm)), k == 0);
        }
        canvas_stroke(v->c, INK_SOFT, 0.7);
    }
}

// a disc across the base
static void base_plate(const rod_scene *s, const rod_view *v)
{
    const pose base = s->r->rod.run[0].shape[0];
    for (int i = 0; i < PLATE_CORNERS; i++) {
        const double angle = 2 * acos(-1.0) * i / PLATE_CORNERS, radius = 0.04 * s->size;
        const vec3 arm = {{radius * cos(angle), radius * sin(angle), 0}};
        follow(v, vec3_add(mm(base.p), mat3_mul_vec(base.R, arm)), i == 0);
    }
    canvas_close(v->c);
    canvas_fill_stroke(v->c, INK_SOFT, INK, 3);
}

void rod_scene_draw(const rod_scene *s, const rod_view *v)
{
    const rod_show *show = s->show;
    rest_shape_line(s, v);
    for (int i = 0; i < show->ndetail && v->tendons; i++) {
        tendon_lines(s, v, show->detail[i]);
    }
    for (int i = 0; i < show->nshown; i++) {
        curve(s, v, show->shown[i]);
    }
    base_plate(s, v);
    tip_paths(s, v);
    rod_loads_draw(s, v);
    for (int i = 0; i < show->nshown; i++) {
        tip_mark(s, v, show->shown[i]);
    }
}
