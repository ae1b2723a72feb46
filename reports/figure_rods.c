// reports/figure_rods.c
// The shapes for all tensions: two projections at one scale, and the view from aside.
#include "reports/figure_rod_style.h"
#include "reports/figures.h"
#include "reports/segment_surface.h"

#include <math.h>
#include <stdio.h>

static const double side = 28, head = 74, sheet_width = 1000;
static const double axis_left = 56, axis_below = 40, gap = 18;
static const double space_width = 320; // of the view from aside
static const double pad = 0.06;        // of the range, around the shapes

typedef struct rods_sheet {
    const run_result *r;
    double least[3], most[3]; // of all shapes and the straight rod [mm]
    double low[3], high[3];   // of the axes [mm]
    double scale;             // points per mm of the projections
    double height;            // of the panels [points]
    double legend;
} rods_sheet;

static vec3 place(const rods_sheet *s, int solution, int point)
{
    return vec3_scale(1e3, s->r->rod.run[solution].shape[point].p);
}

static void measure(rods_sheet *s)
{
    const rod_result *rod = &s->r->rod;
    s->most[2] = s->r->rod_length * 1e3;
    for (int i = 0; i < rod->nsolution; i++) {
        for (int k = 0; k < rod->npoint; k++) {
            const vec3 p = place(s, i, k);
            for (int d = 0; d < 3; d++) {
                s->least[d] = fmin(s->least[d], p.a[d]);
                s->most[d] = fmax(s->most[d], p.a[d]);
            }
        }
    }
    const double size = fmax(s->most[2] - s->least[2], 1e-6);
    for (int d = 0; d < 3; d++) {
        // room for the base's mark on both sides
        s->low[d] = fmin(s->least[d], d < 2 ? -pad * size : 0);
        s->high[d] = fmax(s->most[d], d < 2 ? pad * size : 0);
        range_pad(&s->low[d], &s->high[d], pad, 0.3 * size);
    }
}

static void arrange(rods_sheet *s)
{
    const double tallest = 430, least = 260;
    const double wide = s->high[0] - s->low[0] + s->high[1] - s->low[1];
    const double room = sheet_width - 2 * side - space_width - 2 * (axis_left + gap);
    s->scale = fmin(room / wide, tallest / (s->high[2] - s->low[2]));
    s->height = fmax(s->scale * (s->high[2] - s->low[2]), least);
    s->legend = rod_legend_height(&s->r->rod);

    // what is left over widens the axes at the same scale
    const double spare = (room / s->scale - wide) / 4,
                 taller = s->height / s->scale - (s->high[2] - s->low[2]);
    for (int d = 0; d < 2; d++) {
        s->low[d] -= spare;
        s->high[d] += spare;
    }
    s->low[2] -= taller / 2;
    s->high[2] += taller / 2;
}

// --- projections ---

static void straight_rod(canvas *c, double x0, double y0, double x1, double y1)
{
    canvas_dash(c, 4, 3);
    canvas_segment(c, x0, y0, x1, y1);
    canvas_stroke(c, INK_SOFT, 1.2);
    canvas_dash(c, 0, 0);
}

static void tip_mark(canvas *c, double x, double y, colour ink)
{
    canvas_circle(c, x, y, 4);
    canvas_fill_stroke(c, ink, (colour){1, 1, 1, 1}, 1.3);
}

// x against z (axis 0) or y against z (axis 1)
static void projection(canvas *c, const rods_sheet *s, int axis, box at)
{
    const rod_result *rod = &s->r->rod;
    const plot p = {at, s->low[axis], s->high[axis], s->low[2], s->high[2]};
    plot_frame(c, &p, axis == 0 ? "x, mm" : "y, mm", "z, mm");
    canvas_clip(c, at.x, at.y, at.w, at.h);
    straight_rod(c, plot_x(&p, 0), plot_y(&p, 0), plot_x(&p, 0),
                 plot_y(&p, s->r->rod_length * 1e3));
    for (int i = 0; i < rod->nsolution; i++) {
        for (int k = 0; k < rod->npoint; k++) {
            const vec3 q = place(s, i, k);
            if (k == 0) {
                canvas_move(c, plot_x(&p, q.a[axis]), plot_y(&p, q.a[2]));
            } else {
                canvas_line(c, plot_x(&p, q.a[axis]), plot_y(&p, q.a[2]));
            }
        }
        canvas_stroke(c, rod_ink(rod, i), 2.2);
    }
    for (int i = 0; i < rod->nsolution; i++) {
        const vec3 tip = place(s, i, rod->npoint - 1);
        tip_mark(c, plot_x(&p, tip.a[axis]), plot_y(&p, tip.a[2]), rod_ink(rod, i));
    }
    canvas_rectangle(c, plot_x(&p, 0) - 9, plot_y(&p, 0), 18, 5);
    canvas_fill(c, INK);
    canvas_unclip(c);
}

// --- from aside ---

typedef struct space {
    canvas *c;
    camera camera;
    double x0, y0, scale; // points of the origin, points per mm
    double floor, step;   // [mm]
    double low[2], high[2];
} space;

static void to_paper(const space *v, vec3 p, double at[2])
{
    const vec3 seen = camera_see(&v->camera, p);
    at[0] = v->x0 + v->scale * seen.a[0];
    at[1] = v->y0 - v->scale * seen.a[1];
}

static void space_segment(const space *v, vec3 from, vec3 to)
{
    double a[2], b[2];
    to_paper(v, from, a);
    to_paper(v, to, b);
    canvas_segment(v->c, a[0], a[1], b[0], b[1]);
}

static void grow(const space *v, vec3 p, double low[2], double high[2])
{
    const vec3 seen = camera_see(&v->camera, p);
    for (int k = 0; k < 2; k++) {
        low[k] = fmin(low[k], seen.a[k]);
        high[k] = fmax(high[k], seen.a[k]);
    }
}

// The floor's whole grid cells around the shapes, and a scale that fits all of it into the box.
static space space_fit(canvas *c, const rods_sheet *s, box at)
{
    space v = {.c = c, .camera = camera_from(-0.62, 0.42)};
    const rod_result *rod = &s->r->rod;
    double low[2] = {0, 0}, high[2] = {0, 0};

    v.step = nice_step(s->r->rod_length * 1e3, 6);
    v.floor = floor(s->least[2] / v.step + 1e-9) * v.step;
    for (int d = 0; d < 2; d++) {
        v.low[d] = fmin(floor(s->least[d] / v.step), -1) * v.step;
        v.high[d] = fmax(ceil(s->most[d] / v.step), 1) * v.step;
    }
    for (int corner = 0; corner < 4; corner++) {
        grow(
            &v,
            (vec3){{corner & 1 ? v.high[0] : v.low[0], corner & 2 ? v.high[1] : v.low[1], v.floor}},
            low, high);
    }
    for (int i = 0; i < rod->nsolution; i++) {
        for (int k = 0; k < rod->npoint; k++) {
            grow(&v, place(s, i, k), low, high);
        }
    }
    grow(&v, (vec3){{0, 0, s->r->rod_length * 1e3}}, low, high);
    v.scale = fmin((at.w - 16) / (high[0] - low[0]), (at.h - 40) / (high[1] - low[1]));
    v.x0 = at.x + at.w / 2 - v.scale * (low[0] + high[0]) / 2;
    v.y0 = at.y + at.h / 2 + 8 + v.scale * (low[1] + high[1]) / 2;
    return v;
}

static void floor_grid(const space *v)
{
    for (int d = 0; d < 2; d++) {
        const int n = (int)lround((v->high[d] - v->low[d]) / v->step);
        for (int i = 0; i <= n; i++) {
            vec3 a = {{v->low[0], v->low[1], v->floor}}, b = {{v->high[0], v->high[1], v->floor}};
            a.a[d] = b.a[d] = v->low[d] + i * v->step;
            space_segment(v, a, b);
        }
    }
    canvas_stroke(v->c, INK_GRID, 0.9);
}

static void space_axes(const space *v, double length)
{
    static const char *const name[] = {"x", "y", "z"};
    text_look look = look_haloed(look_aligned(look_inked(LOOK_TEXT, INK_SOFT), TEXT_CENTRE));
    look.style = TEXT_ITALIC;
    for (int d = 0; d < 3; d++) {
        vec3 tip = {{0}};
        double a[2], b[2];
        tip.a[d] = d == 2 ? length : 2 * v->step;
        to_paper(v, (vec3){{0}}, a);
        to_paper(v, tip, b);
        if (d == 2) {
            straight_rod(v->c, a[0], a[1], b[0], b[1]);
        } else {
            arrow(v->c, a[0], a[1], b[0], b[1], INK_SOFT, 1.2);
        }
        const double size = fmax(hypot(b[0] - a[0], b[1] - a[1]), 1);
        say(v->c, b[0] + 11 * (b[0] - a[0]) / size, b[1] + 11 * (b[1] - a[1]) / size + 4, look,
            "%s", name[d]);
    }
}

// the curve, or its shadow straight below on the floor
static void space_curve(const space *v, const rods_sheet *s, int solution, bool shadow)
{
    for (int k = 0; k < s->r->rod.npoint; k++) {
        vec3 p = place(s, solution, k);
        double at[2];
        p.a[2] = shadow ? v->floor : p.a[2];
        to_paper(v, p, at);
        if (k == 0) {
            canvas_move(v->c, at[0], at[1]);
        } else {
            canvas_line(v->c, at[0], at[1]);
        }
    }
    canvas_stroke(v->c, shadow ? (colour){0.72, 0.74, 0.78, 1} : rod_ink(&s->r->rod, solution),
                  shadow ? 1.2 : 2.4);
}

static void from_aside(canvas *c, const rods_sheet *s, box at)
{
    const rod_result *rod = &s->r->rod;
    const space v = space_fit(c, s, at);
    floor_grid(&v);
    for (int i = 0; i < rod->nsolution; i++) {
        const vec3 tip = place(s, i, rod->npoint - 1);
        space_curve(&v, s, i, true);
        space_segment(&v, tip, (vec3){{tip.a[0], tip.a[1], v.floor}});
        canvas_dash(c, 1, 3);
        canvas_stroke(c, INK_FAINT, 1);
        canvas_dash(c, 0, 0);
    }
    space_axes(&v, s->r->rod_length * 1e3);
    for (int i = 0; i < rod->nsolution; i++) {
        space_curve(&v, s, i, false);
    }
    for (int i = 0; i < rod->nsolution; i++) {
        double tip[2];
        to_paper(&v, place(s, i, rod->npoint - 1), tip);
        tip_mark(c, tip[0], tip[1], rod_ink(rod, i));
    }
    say(c, at.x + at.w / 2, at.y + at.h + 31, look_aligned(LOOK_SMALL, TEXT_CENTRE),
        "from aside; floor at z = %s mm, grid %s mm", number_short(v.floor, 3).text,
        number_digits(v.step, 1).text);
}

static double sheet_height(const rods_sheet *s)
{
    return head + s->height + axis_below + 26 + s->legend + 34;
}

static status draw(canvas *c, const void *data)
{
    const rods_sheet *s = data;
    const double first = s->scale * (s->high[0] - s->low[0]),
                 second = s->scale * (s->high[1] - s->low[1]);
    double x = side + axis_left;

    say(c, side, 36, LOOK_TITLE, "Shapes of the rod under its tendons");
    say_within(c, side, 56, sheet_width - 2 * side, LOOK_SMALL, s->r->title);
    projection(c, s, 0, (box){x, head, first, s->height});
    x += first + gap + axis_left;
    projection(c, s, 1, (box){x, head, second, s->height});
    from_aside(c, s, (box){sheet_width - side - space_width, head, space_width, s->height});

    const double y = head + s->height + axis_below + 24;
    rod_legend(c, &s->r->rod, (box){side, y, sheet_width - 2 * side + 28, 0}, ROD_NOTE_BEND);
    say(c, side, sheet_height(s) - 14, LOOK_SMALL,
        "Geometric centrelines, base clamped at the origin; x–z and y–z at one scale; grey: "
        "shadows on "
        "the floor. Dashed: without tension.");
    return OK;
}

status figure_rods(const run_result *r, const char *dir)
{
    rods_sheet s = {.r = r};
    if (!r->has_rod || r->rod.nsolution == 0 || r->rod.npoint < 2) {
        return OK;
    }
    measure(&s);
    arrange(&s);
    const picture p = {
        .name = "rods",
        .title = "Shapes of the rod for all tensions",
        .width = sheet_width,
        .height = sheet_height(&s),
        .draw = draw,
        .data = &s,
    };
    return picture_write(&p, dir);
}
