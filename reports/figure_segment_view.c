// reports/figure_segment_view.c
#include "reports/figure_segment_view.h"

#include "reports/fig4_paper.h"

#include <math.h>

static const double arrow_length = 46;
// --- on paper ---

typedef struct sheet {
    canvas *c;
    const segment_scene *s;
    double x0, y0, scale; // points of the paper's origin, points per m
} sheet;

static void to_sheet(const sheet *h, vec3 p, double at[2])
{
    const vec3 seen = camera_see(&h->s->camera, p);
    at[0] = h->x0 + h->scale * seen.a[0];
    at[1] = h->y0 - h->scale * seen.a[1];
}

static vec3 node_at(const sheet *h, int node, int level)
{
    const segment_body *b = &h->s->r->segment.body;
    const double *x = b->node + 3 * ((size_t)level * (size_t)b->plane.nnode + (size_t)node);
    return (vec3){{x[0], x[1], x[2]}};
}

static void go_to(const sheet *h, vec3 p, bool begin)
{
    double at[2];
    to_sheet(h, p, at);
    if (begin) {
        canvas_move(h->c, at[0], at[1]);
    } else {
        canvas_line(h->c, at[0], at[1]);
    }
}

// the outer boundary at one level, undeformed; holes are left off
static void ring(const sheet *h, int level)
{
    const plane_edges *e = &h->s->edges;
    const plane_loops *l = &h->s->loops;
    double N[ELEMENT_MAX_ORDER + 1];
    for (int i = 0; i < l->nloop; i++) {
        const bool hole = plane_loop_area(e, l, i) < 0;
        for (int k = l->start[i]; !hole && k < l->start[i + 1]; k++) {
            for (int cut = k > l->start[i]; cut <= 6; cut++) {
                vec3 p = {0};
                element_basis(&e->line, &(double){cut / 3.0 - 1}, N, NULL);
                for (int n = 0; n < e->line.nnode; n++) {
                    p = vec3_add_scaled(p, N[n], node_at(h, e->edge[l->order[k]].node[n], level));
                }
                go_to(h, p, cut == 0);
            }
        }
    }
}

static void undeformed_outline(const sheet *h)
{
    const segment_body *b = &h->s->r->segment.body;
    const mesh *m = &b->plane;
    int left = 0, right = 0;
    for (int i = 1; i < m->nnode; i++) {
        const vec3 r = h->s->camera.right;
        const double here = r.a[0] * m->xyz[3 * i] + r.a[1] * m->xyz[3 * i + 1];
        left = here < r.a[0] * m->xyz[3 * left] + r.a[1] * m->xyz[3 * left + 1] ? i : left;
        right = here > r.a[0] * m->xyz[3 * right] + r.a[1] * m->xyz[3 * right + 1] ? i : right;
    }
    ring(h, b->nlevel - 1);
    for (int level = 0; level < b->nlevel; level++) {
        go_to(h, node_at(h, left, level), level == 0);
    }
    for (int level = 0; level < b->nlevel; level++) {
        go_to(h, node_at(h, right, level), level == 0);
    }
    canvas_dash(h->c, 3, 2.5);
    canvas_stroke(h->c, INK_SOFT, 0.9);
    canvas_dash(h->c, 0, 0);
}

static void ground(const sheet *h)
{
    const mesh *m = &h->s->r->segment.body.plane;
    double radius = 0;
    for (int i = 0; i < m->nnode; i++) {
        radius = fmax(radius, hypot(m->xyz[3 * i], m->xyz[3 * i + 1]));
    }
    for (int k = 0; k <= 72; k++) {
        const double angle = k * acos(-1.0) / 36;
        double at[2];
        to_sheet(h, (vec3){{1.45 * radius * cos(angle), 1.45 * radius * sin(angle), 0}}, at);
        if (k == 0) {
            canvas_move(h->c, at[0], at[1]);
        } else {
            canvas_line(h->c, at[0], at[1]);
        }
    }
    canvas_close(h->c);
    canvas_fill_stroke(h->c, FLOOR, INK_GRID, 1);
}

// along the side from a to d of the facet a, b, ..., d: just inside, where its neighbour does not
// paint over it, and a little longer, so that the next one goes on from there
static void paint_border(canvas *c, const double a[2], const double b[2], const double d[2])
{
    const double wide = fmax(hypot(b[0] - a[0], b[1] - a[1]), 1.1);
    const double high = fmax(hypot(d[0] - a[0], d[1] - a[1]), 1);
    const double in[2] = {1.1 / wide * (b[0] - a[0]), 1.1 / wide * (b[1] - a[1])};
    const double on[2] = {(d[0] - a[0]) / high, (d[1] - a[1]) / high};
    canvas_segment(c, a[0] + in[0] - on[0], a[1] + in[1] - on[1], d[0] + in[0] + on[0],
                   d[1] + in[1] + on[1]);
    canvas_stroke(c, PAPER, 1.2);
}

// grown a little about its middle, so that no white shows between neighbours
static void paint_facet(const sheet *h, const facet *f)
{
    double x[4], y[4], mx = 0, my = 0;
    for (int i = 0; i < f->ncorner; i++) {
        x[i] = h->x0 + h->scale * f->at[i][0];
        y[i] = h->y0 - h->scale * f->at[i][1];
        mx += x[i] / f->ncorner;
        my += y[i] / f->ncorner;
    }
    for (int i = 0; i < f->ncorner; i++) {
        const double off = hypot(x[i] - mx, y[i] - my), by = off > 0 ? 1 + 0.45 / off : 1;
        const double px = mx + by * (x[i] - mx), py = my + by * (y[i] - my);
        if (i == 0) {
            canvas_move(h->c, px, py);
        } else {
            canvas_line(h->c, px, py);
        }
    }
    canvas_close(h->c);
    canvas_fill(h->c, segment_colour(h->s, f->value, f->light));
    if (f->border) {
        paint_border(h->c, (double[2]){x[0], y[0]}, (double[2]){x[1], y[1]},
                     (double[2]){x[f->ncorner - 1], y[f->ncorner - 1]});
    }
}

// borders between materials on the tip's face, which moves with the load
static void tip_borders(const sheet *h, const double *displacement)
{
    const plane_edges *e = &h->s->edges;
    const segment_body *b = &h->s->r->segment.body;
    const int top = (b->nlevel - 1) * b->plane.nnode;
    int lines = 0;
    for (int i = 0; i < e->count; i++) {
        const plane_edge *edge = &e->edge[i];
        for (int k = 0; edge->other >= 0 && edge->material < edge->other && k < e->line.nnode;
             k++) {
            const int node = 3 * (top + edge->node[k]);
            const double *x = b->node + node, *u = displacement + node;
            double at[2];
            to_sheet(h,
                     vec3_add((vec3){{x[0], x[1], x[2]}},
                              vec3_scale(h->s->magnify, (vec3){{u[0], u[1], u[2]}})),
                     at);
            if (k == 0) {
                canvas_move(h->c, at[0], at[1]);
            } else {
                canvas_line(h->c, at[0], at[1]);
            }
            lines++;
        }
    }
    if (lines > 0) {
        canvas_stroke(h->c, (colour){1, 1, 1, 0.9}, 1.1);
    }
}

// a force pushes at the point; a moment turns about an arrow of two heads that leaves it
static void draw_load(canvas *c, const double far[2], const double point[2], bool moment)
{
    if (!moment) {
        arrow_bordered(c, far[0], far[1], point[0], point[1], INK_ACCENT, 2.6);
        return;
    }
    const double back = 0.22, x = far[0] + back * (point[0] - far[0]),
                 y = far[1] + back * (point[1] - far[1]);
    arrow_bordered(c, point[0], point[1], far[0], far[1], INK_ACCENT, 2.6);
    arrow(c, point[0], point[1], x, y, INK_ACCENT, 2.6);
}

// the arrow's point stands on the tip where the load acts, moved along with the tip
static void load_arrow(const sheet *h, int load)
{
    const segment_load_result *l = &h->s->r->segment.load[load];
    const double *u = l->tip_displacement, *w = l->tip_rotation;
    const vec3 arm = {{l->point[0], l->point[1], 0}};
    const vec3 move =
        vec3_add((vec3){{u[0], u[1], u[2]}}, vec3_cross((vec3){{w[0], w[1], w[2]}}, arm));
    const vec3 point = vec3_add((vec3){{arm.a[0], arm.a[1], h->s->r->segment_length}},
                                vec3_scale(h->s->magnify, move));
    double at[2], from[2];
    to_sheet(h, point, at);

    const vec3 force = {{l->force[0], l->force[1], l->force[2]}};
    const vec3 moment = {{l->moment[0], l->moment[1], l->moment[2]}};
    const bool pure = vec3_norm(force) == 0;
    const vec3 along = pure ? moment : force;
    const double size = vec3_norm(along);
    if (size > 0) {
        const vec3 step = vec3_scale(arrow_length / h->scale / size, along);
        to_sheet(h, pure ? vec3_add(point, step) : vec3_sub(point, step), from);
        draw_load(h->c, from, at, pure);
        say(h->c, from[0] + 10, from[1] + 6, look_haloed(look_inked(LOOK_HEADING, INK_ACCENT)),
            pure ? "%s N mm" : "%s N", number_short(pure ? size * 1e3 : size, 3).text);
    }
    canvas_circle(h->c, at[0], at[1], 2.6);
    canvas_fill_stroke(h->c, INK_ACCENT, PAPER, 1);
}

static void directions(const sheet *h, box at)
{
    static const char *const name[] = {"x", "y", "z"};
    const double x = at.x + 30, y = at.y + at.h - 24;
    text_look look = look_aligned(look_inked(LOOK_TEXT, INK_SOFT), TEXT_CENTRE);
    look.style = TEXT_ITALIC;
    for (int k = 0; k < 3; k++) {
        vec3 unit = {{0}};
        unit.a[k] = 1;
        const vec3 seen = camera_see(&h->s->camera, unit);
        const double dx = 30 * seen.a[0], dy = -30 * seen.a[1], length = hypot(dx, dy);
        arrow(h->c, x, y, x + dx, y + dy, INK_SOFT, 1.1);
        if (length > 0) {
            say(h->c, x + dx + 9 * dx / length, y + dy + 9 * dy / length + 4, look, "%s", name[k]);
        }
    }
}

status segment_view(canvas *c, const segment_scene *s, int load, box at, double points_per_m)
{
    status st = OK;
    segment_surface surface = {0};
    const double *displacement = s->r->segment.load[load].displacement;
    const sheet h = {
        .c = c,
        .s = s,
        .x0 = at.x + at.w / 2 - points_per_m * (s->low[0] + s->high[0]) / 2,
        .y0 = at.y + at.h - 20 + points_per_m * s->low[1],
        .scale = points_per_m,
    };

    TRY(segment_surface_make(&s->r->segment.body, &s->r->segment.load[load], s->value, s->magnify,
                             &s->camera, &surface));
    ground(&h);
    for (int i = 0; i < surface.count; i++) {
        paint_facet(&h, &surface.facet[i]);
    }
    tip_borders(&h, displacement);
    undeformed_outline(&h);
    load_arrow(&h, load);
    directions(&h, at);

done:
    segment_surface_free(&surface);
    return st;
}
