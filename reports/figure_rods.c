// reports/figure_rods.c
// The shapes of all solutions: two projections at one scale, and the view from aside.
#include "reports/figure_rod_scene.h"
#include "reports/figure_rod_style.h"
#include "reports/figures.h"

#include <math.h>
#include <stdio.h>

static const double side = 28, head = 74, sheet_width = 1000;
static const double axis_left = 56, axis_below = 40, gap = 18;
static const double space_width = 320; // of the view from aside
static const double pad = 0.06;        // of the range, around the shapes

typedef struct rods_sheet {
    const run_result *r;
    const rod_show *show;
    rod_scene scene;
    double low[3], high[3]; // of the axes [mm]
    double scale;           // points per mm of the projections
    double height;          // of the panels [points]
    double legend, loads;
} rods_sheet;

static void arrange(rods_sheet *s)
{
    const double tallest = 430, least = 260;
    const rod_scene *scene = &s->scene;
    for (int d = 0; d < 3; d++) {
        s->low[d] = scene->least[d];
        s->high[d] = scene->most[d];
        range_pad(&s->low[d], &s->high[d], pad, 0.3 * scene->size);
    }
    const double wide = s->high[0] - s->low[0] + s->high[1] - s->low[1];
    const double room = sheet_width - 2 * side - space_width - 2 * (axis_left + gap);
    s->scale = fmin(room / wide, tallest / (s->high[2] - s->low[2]));
    s->height = fmax(s->scale * (s->high[2] - s->low[2]), least);
    s->legend = rod_legend_height(s->show);
    s->loads = rod_loads_legend_height(&s->r->rod);

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

// x against z (axis 0) or y against z (axis 1)
static void projection(canvas *c, const rods_sheet *s, int axis, box at)
{
    const plot p = {at, s->low[axis], s->high[axis], s->low[2], s->high[2]};
    const rod_view v = {
        .c = c,
        .camera = {axis == 0 ? (vec3){{1, 0, 0}} : (vec3){{0, 1, 0}},
                   {{0, 0, 1}},
                   axis == 0 ? (vec3){{0, -1, 0}} : (vec3){{1, 0, 0}}},
        .x0 = plot_x(&p, 0),
        .y0 = plot_y(&p, 0),
        .scale = s->scale,
    };
    plot_frame(c, &p, axis == 0 ? "x, mm" : "y, mm", "z, mm");
    canvas_clip(c, at.x, at.y, at.w, at.h);
    rod_scene_draw(&s->scene, &v);
    canvas_unclip(c);
    rod_gravity_draw(&s->scene, &v, at);
}

// --- from aside ---

typedef struct space {
    rod_view view;
    double floor, step; // [mm]
    double low[2], high[2];
    double seen_low[2], seen_high[2]; // on the paper, before the scale
} space;

static void grow(vec3 p, void *data)
{
    space *v = data;
    const vec3 seen = camera_see(&v->view.camera, p);
    for (int k = 0; k < 2; k++) {
        v->seen_low[k] = fmin(v->seen_low[k], seen.a[k]);
        v->seen_high[k] = fmax(v->seen_high[k], seen.a[k]);
    }
}

// The floor's whole grid cells around the shapes, and a scale that fits all of it into the box.
static space space_fit(canvas *c, const rods_sheet *s, box at)
{
    const rod_scene *scene = &s->scene;
    space v = {.view = {.c = c, .camera = camera_from(-0.62, 0.42), .tendons = true},
               .seen_low = {INFINITY, INFINITY},
               .seen_high = {-INFINITY, -INFINITY}};
    v.step = nice_step(scene->size, 6);
    v.floor = floor(scene->least[2] / v.step + 1e-9) * v.step;
    for (int d = 0; d < 2; d++) {
        const vec3 base = vec3_scale(1e3, s->r->rod.run[0].shape[0].p);
        const double middle = round(base.a[d] / v.step);
        v.low[d] = fmin(floor(scene->least[d] / v.step), middle - 1) * v.step;
        v.high[d] = fmax(ceil(scene->most[d] / v.step), middle + 1) * v.step;
    }
    for (int i = 0; i < 4; i++) {
        grow((vec3){{i & 1 ? v.high[0] : v.low[0], i & 2 ? v.high[1] : v.low[1], v.floor}}, &v);
    }
    rod_scene_points(scene, grow, &v);
    rod_view *view = &v.view;
    view->scale = fmin((at.w - 16) / (v.seen_high[0] - v.seen_low[0]),
                       (at.h - 40) / (v.seen_high[1] - v.seen_low[1]));
    view->x0 = at.x + at.w / 2 - view->scale * (v.seen_low[0] + v.seen_high[0]) / 2;
    view->y0 = at.y + at.h / 2 + 8 + view->scale * (v.seen_low[1] + v.seen_high[1]) / 2;
    return v;
}

static void floor_grid(const space *v)
{
    enum { MOST_LINES = 60 };
    for (int d = 0; d < 2; d++) {
        const double cells = round((v->high[d] - v->low[d]) / v->step);
        for (int i = 0; cells <= MOST_LINES && i <= cells; i++) {
            vec3 a = {{v->low[0], v->low[1], v->floor}}, b = {{v->high[0], v->high[1], v->floor}};
            a.a[d] = b.a[d] = v->low[d] + i * v->step;
            rod_view_line(&v->view, a, b);
        }
    }
    canvas_stroke(v->view.c, INK_GRID, 0.9);
}

// the world's directions, at the base
static void space_axes(const space *v, vec3 base)
{
    static const char *const name[] = {"x", "y", "z"};
    text_look look = look_haloed(look_aligned(look_inked(LOOK_TEXT, INK_SOFT), TEXT_CENTRE));
    look.style = TEXT_ITALIC;
    for (int d = 0; d < 3; d++) {
        vec3 tip = base;
        double a[2], b[2];
        tip.a[d] += 2 * v->step;
        rod_view_at(&v->view, base, a);
        rod_view_at(&v->view, tip, b);
        arrow(v->view.c, a[0], a[1], b[0], b[1], INK_SOFT, 1.2);
        const double size = fmax(hypot(b[0] - a[0], b[1] - a[1]), 1);
        say(v->view.c, b[0] + 11 * (b[0] - a[0]) / size, b[1] + 11 * (b[1] - a[1]) / size + 4, look,
            "%s", name[d]);
    }
}

static vec3 on_floor(const space *v, vec3 m)
{
    return (vec3){{1e3 * m.a[0], 1e3 * m.a[1], v->floor}};
}

static void shadow(const space *v, const rod_result *rod, int solution, bool plumb)
{
    const struct rod_run *run = &rod->run[solution];
    canvas *c = v->view.c;
    for (int k = 0; k < rod->npoint; k = rod_next_point(rod, k)) {
        double at[2];
        rod_view_at(&v->view, on_floor(v, run->shape[k].p), at);
        if (k == 0) {
            canvas_move(c, at[0], at[1]);
        } else {
            canvas_line(c, at[0], at[1]);
        }
    }
    canvas_stroke(c, SHADOW, plumb ? 1.2 : 0.6);
    if (plumb) {
        rod_view_line(&v->view, vec3_scale(1e3, run->tip.p), on_floor(v, run->tip.p));
        canvas_dash(c, 1, 3);
        canvas_stroke(c, INK_FAINT, 1);
        canvas_dash(c, 0, 0);
    }
}

static void from_aside(canvas *c, const rods_sheet *s, box at)
{
    const rod_result *rod = &s->r->rod;
    const space v = space_fit(c, s, at);
    floor_grid(&v);
    for (int i = 0; i < s->show->nshown; i++) {
        shadow(&v, rod, s->show->shown[i], !s->show->sweep);
    }
    space_axes(&v, vec3_scale(1e3, rod->run[0].shape[0].p));
    rod_scene_draw(&s->scene, &v.view);
    rod_gravity_draw(&s->scene, &v.view, at);
    say(c, at.x + at.w / 2, at.y + at.h + 31, look_aligned(LOOK_SMALL, TEXT_CENTRE),
        "from aside; floor at z = %s mm, grid %s mm", number_short(v.floor, 3).text,
        number_digits(v.step, 1).text);
}

static double sheet_height(const rods_sheet *s)
{
    return head + s->height + axis_below + 26 + s->legend + s->loads + 66;
}

static void notes(canvas *c, const rods_sheet *s)
{
    const bool some = s->show->ndetail < s->show->nshown;
    const bool loads = s->r->rod.nload > 0, tendons = s->r->rod.ntendon > 0;
    char more[256], which[80] = "";
    const double y = sheet_height(s) - 46;
    const bool all = s->show->nshown == s->r->rod.nsolution;
    bool stopped = false, unstable = false;
    rod_show_words(s->show, which, sizeof which);
    for (int i = 0; i < s->show->nshown; i++) {
        const struct rod_run *run = &s->r->rod.run[s->show->shown[i]];
        stopped = stopped || run->fraction < 1;
        unstable = unstable || run->stable == 0;
    }
    say(c, side, y, LOOK_SMALL,
        "Geometric centrelines %s%s; x–z and y–z at one scale; grey: shadows on the floor.%s",
        all ? "from the base plate" : "of ", all ? "" : which,
        s->show->sweep ? " All tips are joined." : "");
    (void)snprintf(
        more, sizeof more, "%s%s%s%s%s%s", tendons ? "thin lines: tendons; " : "",
        loads ? "arrows: full ones fixed in space, hollow ones turning with the section, two heads "
                "mean a moment; "
              : "",
        some && (tendons || loads) ? "on some shapes only; " : "",
        stopped ? "hollow tip: stopped at a limit point; " : "",
        unstable ? "dashed: unstable; " : "", "dashed grey: at rest.");
    // a sentence begins large
    more[0] = (char)(more[0] - 'a' + 'A');
    (void)say_paragraph(c, side, y + 16, sheet_width - 2 * side, LOOK_SMALL, more);
}

static status draw(canvas *c, const void *data)
{
    const rods_sheet *s = data;
    const rod_result *rod = &s->r->rod;
    const double first = s->scale * (s->high[0] - s->low[0]),
                 second = s->scale * (s->high[1] - s->low[1]);
    double x = side + axis_left;

    say(c, side, 36, LOOK_TITLE, "Shapes of the rod under its %s",
        rod->nload == 0     ? "tendons"
        : rod->ntendon == 0 ? "loads"
                            : "tendons and loads");
    say_within(c, side, 56, sheet_width - 2 * side, LOOK_SMALL, s->r->title);
    projection(c, s, 0, (box){x, head, first, s->height});
    x += first + gap + axis_left;
    projection(c, s, 1, (box){x, head, second, s->height});
    from_aside(c, s, (box){sheet_width - side - space_width, head, space_width, s->height});

    const double y = head + s->height + axis_below + 24;
    rod_legend(c, s->show, (box){side, y, sheet_width - 2 * side + 28, 0}, ROD_NOTE_BEND);
    rod_loads_legend(c, rod, (box){side, y + s->legend + 6, sheet_width - 2 * side, 0});
    notes(c, s);
    return OK;
}

status figure_rods(const run_result *r, const char *dir)
{
    status st = OK;
    rod_show show = {0};
    char which[80], title[120];
    if (!r->has_rod || r->rod.nsolution == 0 || r->rod.npoint < 2) {
        return OK;
    }
    TRY(rod_show_make(&r->rod, &show));
    rods_sheet s = {.r = r, .show = &show, .scene = rod_scene_make(r, &show)};
    arrange(&s);
    rod_show_words(&show, which, sizeof which);
    (void)snprintf(title, sizeof title, "Shapes of the rod for %s", which);
    const picture p = {
        .name = "rods",
        .title = title,
        .width = sheet_width,
        .height = sheet_height(&s),
        .draw = draw,
        .data = &s,
    };
    TRY(picture_write(&p, dir));

done:
    rod_show_free(&show);
    return st;
}
