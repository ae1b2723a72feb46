// reports/figure_section_drawing.c
// The section itself: materials, mesh, centres, principal axes.
#include "reports/figure_section.h"

#include <float.h>
#include <math.h>

typedef sketch_frame view;

static double view_x(const view *v, double x)
{
    return v->x0 + v->scale * x;
}

static double view_y(const view *v, double y)
{
    return v->y0 - v->scale * y;
}

// what a label beyond the section needs on every side [points]
static const double margin = 40;

sketch_frame sketch_frame_of(const mesh *m, box at)
{
    double low[2] = {0, 0}, high[2] = {0, 0};
    for (int i = 0; i < m->nnode; i++) {
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], m->xyz[3 * i + k]);
            high[k] = fmax(high[k], m->xyz[3 * i + k]);
        }
    }
    const double w = fmax(high[0] - low[0], DBL_MIN), h = fmax(high[1] - low[1], DBL_MIN);
    const double scale = fmin((at.w - 2 * margin) / w, (at.h - 2 * margin) / h);
    return (view){scale, at.x + at.w / 2 - scale * (low[0] + high[0]) / 2,
                  at.y + at.h / 2 + scale * (low[1] + high[1]) / 2};
}

// --- materials and mesh ---

static void edge_path(canvas *c, const plane_edges *e, const plane_edge *edge, const view *v,
                      bool on)
{
    const int cuts = e->line.order == 1 ? 1 : 2 * e->line.order + 2;
    for (int i = 0; i <= cuts; i++) {
        double p[2];
        plane_edge_point(e, edge, 2.0 * i / cuts - 1, p);
        if (i == 0 && !on) {
            canvas_move(c, view_x(v, p[0]), view_y(v, p[1]));
        } else if (i > 0) {
            canvas_line(c, view_x(v, p[0]), view_y(v, p[1]));
        }
    }
}

static void loop_path(canvas *c, const plane_edges *e, const plane_loops *l, const view *v)
{
    for (int i = 0; i < l->nloop; i++) {
        for (int k = l->start[i]; k < l->start[i + 1]; k++) {
            edge_path(c, e, &e->edge[l->order[k]], v, k > l->start[i]);
        }
        canvas_close(c);
    }
}

static void mesh_lines(canvas *c, const plane_edges *e, const view *v)
{
    const int p = e->line.order;
    int lines = 0;
    for (int i = 0; i < e->count; i++) {
        const plane_edge *edge = &e->edge[i];
        if (edge->material == edge->other && edge->node[0] < edge->node[p]) {
            edge_path(c, e, edge, v, false);
            lines++;
        }
    }
    if (lines > 0) {
        canvas_stroke(c, (colour){0.1, 0.12, 0.16, 0.16}, 0.6);
    }
}

static status regions(canvas *c, const section_sketch *s, const plane_edges *e, const view *v)
{
    status st = OK;
    plane_loops loops = {0};

    for (int m = 0; m < s->r->nmaterial; m++) {
        TRY(plane_loops_make(e, m, &loops));
        if (loops.nloop > 0) {
            loop_path(c, e, &loops, v);
            canvas_fill(c, colour_material(m));
        }
        plane_loops_free(&loops);
    }
    mesh_lines(c, e, v);
    for (int m = 0; m < s->r->nmaterial; m++) {
        TRY(plane_loops_make(e, m, &loops));
        if (loops.nloop > 0) {
            loop_path(c, e, &loops, v);
            canvas_stroke(c, INK, 1.1);
        }
        plane_loops_free(&loops);
    }

done:
    plane_loops_free(&loops);
    return st;
}

// --- centres and axes ---

// the three marks stay told apart where they coincide: the cross reaches out of the diamond, the
// dot lies in it
void mark_geometric_centre(canvas *c, double x, double y)
{
    for (int pass = 0; pass < 2; pass++) {
        const double r = pass ? 11 : 12;
        canvas_segment(c, x - r, y, x + r, y);
        canvas_segment(c, x, y - r, x, y + r);
        canvas_stroke(c, pass ? INK : PAPER, pass ? 1.7 : 4);
    }
}

void mark_stiffness_centre(canvas *c, double x, double y)
{
    canvas_circle(c, x, y, 4.4);
    canvas_fill_stroke(c, INK_ACCENT, PAPER, 1.4);
}

void mark_shear_centre(canvas *c, double x, double y)
{
    const double r = 6.5;
    for (int pass = 0; pass < 2; pass++) {
        canvas_move(c, x - r, y);
        canvas_line(c, x, y - r);
        canvas_line(c, x + r, y);
        canvas_line(c, x, y + r);
        canvas_close(c);
        canvas_stroke(c, pass ? INK_SECOND : PAPER, pass ? 1.8 : 3);
    }
}

void mark_mass_centre(canvas *c, double x, double y)
{
    const double r = 5;
    for (int pass = 0; pass < 2; pass++) {
        canvas_rectangle(c, x - r, y - r, 2 * r, 2 * r);
        canvas_stroke(c, pass ? INK_SOFT : PAPER, pass ? 1.5 : 3);
    }
}

// seen end on
void mark_tendon(canvas *c, double x, double y)
{
    canvas_circle(c, x, y, 4.2);
    canvas_fill_stroke(c, PAPER, INK, 1.3);
    canvas_circle(c, x, y, 1.5);
    canvas_fill(c, INK);
}

static void tendons(canvas *c, const section_sketch *s, const view *v)
{
    for (int i = 0; s->r->has_rod && i < s->r->rod.ntendon; i++) {
        double at[2];
        if (section_tendon(s, i, at)) {
            mark_tendon(c, view_x(v, at[0]), view_y(v, at[1]));
        }
    }
}

void kern_stroke(canvas *c)
{
    canvas_dash(c, 2.5, 2.5);
    canvas_stroke(c, INK_SECOND, 1.3);
    canvas_dash(c, 0, 0);
}

static void kern(canvas *c, const section_sketch *s, const view *v)
{
    const section_answers *a = s->answers;
    for (int i = 0; a && i < a->nkern; i++) {
        const double x = view_x(v, a->kern[i][0]), y = view_y(v, a->kern[i][1]);
        if (i == 0) {
            canvas_move(c, x, y);
        } else {
            canvas_line(c, x, y);
        }
    }
    if (a && a->nkern > 0) {
        canvas_close(c);
        kern_stroke(c);
    }
}

// from one side of the section to the other along (cos, sin), a little beyond on both; the name at
// the far end
static void principal_axis(canvas *c, const section_sketch *s, const view *v, double angle,
                           const char *name)
{
    const mesh *m = &s->r->section_mesh;
    const double *centre = s->centres->stiffness_centre, ux = cos(angle), uy = sin(angle);
    double low = 0, high = 0;
    for (int i = 0; i < m->nnode; i++) {
        const double along =
            (m->xyz[3 * i] - centre[0]) * ux + (m->xyz[3 * i + 1] - centre[1]) * uy;
        low = fmin(low, along);
        high = fmax(high, along);
    }
    const double cx = view_x(v, centre[0]), cy = view_y(v, centre[1]);
    const double a = v->scale * low - 12, b = v->scale * high + 16;

    canvas_dash(c, 7, 3.5);
    canvas_segment(c, cx + a * ux, cy - a * uy, cx + (b - 8) * ux, cy - (b - 8) * uy);
    canvas_stroke(c, INK_ACCENT, 1.3);
    canvas_dash(c, 0, 0);
    arrow(c, cx + (b - 9) * ux, cy - (b - 9) * uy, cx + b * ux, cy - b * uy, INK_ACCENT, 1.3);
    text_look look = look_haloed(look_aligned(look_inked(LOOK_TEXT, INK_ACCENT), TEXT_CENTRE));
    look.style = TEXT_ITALIC;
    say(c, cx + (b + 12) * ux, cy - (b + 12) * uy + 5, look, "%s", name);
}

static void corner_axes(canvas *c, box at)
{
    const double x = at.x + 12, y = at.y + at.h - 12, length = 34;
    text_look look = look_inked(LOOK_TEXT, INK_SOFT);
    look.style = TEXT_ITALIC;
    arrow(c, x, y, x + length, y, INK_SOFT, 1.2);
    arrow(c, x, y, x, y - length, INK_SOFT, 1.2);
    say(c, x + length + 5, y + 4, look, "x");
    say(c, x - 3, y - length - 6, look, "y");
}

static void centre_path(canvas *c, const section_sketch *s, const view *v)
{
    if (s->npath == 0) {
        return;
    }
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < s->npath; i++) {
            const double x = view_x(v, s->path[i][1]), y = view_y(v, s->path[i][2]);
            if (i == 0) {
                canvas_move(c, x, y);
            } else {
                canvas_line(c, x, y);
            }
        }
        canvas_stroke(c, pass ? INK_ACCENT : PAPER, pass ? 2 : 4.5);
    }
    const double *end = s->path[s->npath - 1];
    canvas_circle(c, view_x(v, end[1]), view_y(v, end[2]), 3.6);
    canvas_fill_stroke(c, PAPER, INK_ACCENT, 1.6);
}

status section_drawing(canvas *c, const section_sketch *s, box at)
{
    status st = OK;
    plane_edges edges = {0};
    const view v = sketch_frame_of(&s->r->section_mesh, at);

    TRY(plane_edges_make(&s->r->section_mesh, &edges));
    TRY(regions(c, s, &edges, &v));
    if (!s->centres->isotropic) {
        principal_axis(c, s, &v, s->centres->principal_angle, "x′");
        principal_axis(c, s, &v, s->centres->principal_angle + 0.5 * acos(-1.0), "y′");
    }
    kern(c, s, &v);
    centre_path(c, s, &v);
    tendons(c, s, &v);
    if (s->answers && s->answers->mass.known) {
        const double *at = s->answers->mass.mass_centre;
        mark_mass_centre(c, view_x(&v, at[0]), view_y(&v, at[1]));
    }
    mark_geometric_centre(c, view_x(&v, 0), view_y(&v, 0));
    mark_shear_centre(c, view_x(&v, s->centres->shear_centre[0]),
                      view_y(&v, s->centres->shear_centre[1]));
    mark_stiffness_centre(c, view_x(&v, s->centres->stiffness_centre[0]),
                          view_y(&v, s->centres->stiffness_centre[1]));
    corner_axes(c, at);
    scale_bar(c, at.x + at.w - 10, at.y + at.h - 12, 70, v.scale * 1e-3);

done:
    plane_edges_free(&edges);
    return st;
}
