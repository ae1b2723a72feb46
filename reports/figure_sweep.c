// reports/figure_sweep.c
// Where the tip goes along a sweep: its position, the bend, the largest strain, the stability.
#include "reports/figure_rod_style.h"
#include "reports/figures.h"

#include <math.h>
#include <stdio.h>

enum { PANELS = 6, COLUMNS = 3, DOTS_UP_TO = 25, MOST_POINTS = 6000 };

static const double side = 28, head = 74, sheet_width = 1000, panel_height = 190;
static const double axis_left = 62, axis_below = 50, gap = 8, caption = 20;
static const double limit_seen_from = 0.25; // of it; curves far below keep their own range

static double tip_x(const run_result *r, const struct rod_run *run)
{
    (void)r;
    return 1e3 * run->tip.p.a[0];
}

static double tip_y(const run_result *r, const struct rod_run *run)
{
    (void)r;
    return 1e3 * run->tip.p.a[1];
}

static double tip_z(const run_result *r, const struct rod_run *run)
{
    (void)r;
    return 1e3 * run->tip.p.a[2];
}

static double bend(const run_result *r, const struct rod_run *run)
{
    (void)r;
    return run->total_bend_rad * 180 / acos(-1.0);
}

static double strain(const run_result *r, const struct rod_run *run)
{
    (void)r;
    return 100 * run->largest_strain;
}

static double strain_share(const run_result *r, const struct rod_run *run)
{
    int whose = -1;
    return result_strain_share(r, run, &whose);
}

static double eigenvalue(const run_result *r, const struct rod_run *run)
{
    (void)r;
    return run->eigenvalue;
}

typedef struct sweep_panel {
    const char *name, *label;
    double (*value)(const run_result *r, const struct rod_run *run);
} sweep_panel;

static const sweep_panel panels[PANELS] = {
    {"Tip, x", "x, mm", tip_x},
    {"Tip, y", "y, mm", tip_y},
    {"Tip, z", "z, mm", tip_z},
    {"Total bend", "bend, °", bend},
    {"Largest strain over its material's limit", "strain over limit", strain_share},
    {"Smallest eigenvalue (critical at 0)", "eigenvalue (1: at rest)", eigenvalue},
};
// where no material has a limit
static const sweep_panel strain_alone = {"Largest strain of a material", "strain, %", strain};

typedef struct sweep_sheet {
    const run_result *r;
    const rod_show *show;
    char along[160]; // the label of what is swept
    int npanel;      // the last one only where any eigenvalue is known
    bool limited;    // a material has a strain up to which it is linear
} sweep_sheet;

static const sweep_panel *panel_of(const sweep_sheet *s, int panel)
{
    const sweep_panel *p = &panels[panel];
    return p->value == strain_share && !s->limited ? &strain_alone : p;
}

static double value_of(const sweep_sheet *s, int panel, int solution)
{
    return panel_of(s, panel)->value(s->r, &s->r->rod.run[solution]);
}

static double abscissa(const sweep_sheet *s, const rod_line *l, int solution)
{
    return rod_quantity_value(&s->r->rod.run[solution], l->lead);
}

static plot panel_plot(const sweep_sheet *s, int panel, box at)
{
    plot p = {at, INFINITY, -INFINITY, INFINITY, -INFINITY};
    double most = 0;
    for (int i = 0; i < s->show->nline; i++) {
        const rod_line *l = &s->show->line[i];
        for (int k = l->first; k < l->first + l->count; k++) {
            const double x = abscissa(s, l, k), y = value_of(s, panel, k);
            p.x0 = fmin(p.x0, x);
            p.x1 = fmax(p.x1, x);
            p.y0 = fmin(p.y0, y);
            p.y1 = fmax(p.y1, y);
        }
    }
    for (int i = 0; i < s->r->rod.nsolution && panel < 3; i++) {
        most = fmax(most, 1e3 * vec3_norm(s->r->rod.run[i].tip.p));
    }
    if (panel == PANELS - 1) {
        p.y0 = fmin(p.y0, 0); // where it is critical
    }
    if (panel_of(s, panel)->value == strain_share) {
        p.y0 = fmin(p.y0, 0);
        p.y1 = p.y1 > limit_seen_from ? fmax(p.y1, 1) : p.y1;
    }
    range_pad(&p.x0, &p.x1, 0.02, 1e-12);
    if (panel < 3 && p.y1 - p.y0 < 1e-9 * most) {
        p.y0 -= 0.1 * most; // nothing beside how far the tip is
        p.y1 += 0.1 * most;
    }
    range_pad(&p.y0, &p.y1, 0.06, 1e-12);
    return p;
}

static void line_draw(canvas *c, const sweep_sheet *s, const plot *p, int panel, const rod_line *l)
{
    const rod_result *rod = &s->r->rod;
    const int stride = 1 + rod->nsolution / MOST_POINTS, end = l->first + l->count;
    bool pen = false;
    for (int k = l->first; k < end; k += stride) {
        const double y = value_of(s, panel, k);
        if (!isfinite(y)) {
            pen = false;
            continue;
        }
        if (pen) {
            canvas_line(c, plot_x(p, abscissa(s, l, k)), plot_y(p, y));
        } else {
            canvas_move(c, plot_x(p, abscissa(s, l, k)), plot_y(p, y));
        }
        pen = true;
    }
    canvas_stroke(c, s->show->nline > 1 ? s->show->ink[l->first] : INK_SECOND, 1.7);
}

static void dots(canvas *c, const sweep_sheet *s, const plot *p, int panel, const rod_line *l)
{
    const colour white = {1, 1, 1, 1};
    for (int k = l->first; k < l->first + l->count; k++) {
        const struct rod_run *run = &s->r->rod.run[k];
        const double y = value_of(s, panel, k);
        if (isfinite(y) && (s->r->rod.nsolution <= DOTS_UP_TO || run->fraction < 1)) {
            canvas_circle(c, plot_x(p, abscissa(s, l, k)), plot_y(p, y), 2.8);
            canvas_fill_stroke(c, run->fraction < 1 ? white : s->show->ink[k],
                               run->fraction < 1 ? s->show->ink[k] : white, 0.9);
        }
    }
}

// the strain up to which the material is linear
static void strain_limit(canvas *c, const plot *p)
{
    const double y = plot_y(p, 1);
    if (p->y1 < 1) {
        return;
    }
    canvas_segment(c, p->at.x, y, p->at.x + p->at.w, y);
    canvas_dash(c, 4, 3);
    canvas_stroke(c, INK_ACCENT, 1);
    canvas_dash(c, 0, 0);
    say(c, p->at.x + 5, y - 4, look_haloed(look_inked(LOOK_TICK, INK_ACCENT)), "limit");
}

static void panel_draw(canvas *c, const sweep_sheet *s, int panel, box at)
{
    const plot p = panel_plot(s, panel, at);
    say(c, at.x, at.y - 7, LOOK_HEADING, "%s", panel_of(s, panel)->name);
    plot_frame(c, &p, "", panel_of(s, panel)->label);
    say_within(c, at.x + at.w / 2, at.y + at.h + 31, at.w,
               look_aligned(look_inked(LOOK_SMALL, INK), TEXT_CENTRE), s->along);
    canvas_clip(c, at.x, at.y, at.w, at.h);
    if (panel_of(s, panel)->value == strain_share) {
        strain_limit(c, &p);
    }
    for (int i = 0; i < s->show->nline; i++) {
        line_draw(c, s, &p, panel, &s->show->line[i]);
        dots(c, s, &p, panel, &s->show->line[i]);
    }
    canvas_unclip(c);
}

static double panels_height(const sweep_sheet *s)
{
    return (s->npanel + COLUMNS - 1) / COLUMNS * (panel_height + axis_below + caption);
}

static double sheet_height(const sweep_sheet *s)
{
    return head + panels_height(s) + rod_legend_height(s->show) + 44;
}

static status draw(canvas *c, const void *data)
{
    const sweep_sheet *s = data;
    const double width =
        (sheet_width - 2 * side - COLUMNS * axis_left - (COLUMNS - 1) * gap) / COLUMNS;
    say(c, side, 36, LOOK_TITLE, "The tip along the sweep");
    say_within(c, side, 56, sheet_width - 2 * side, LOOK_SMALL, s->r->title);
    for (int i = 0; i < s->npanel; i++) {
        const double x = side + axis_left + (i % COLUMNS) * (width + gap + axis_left);
        const double y = head + caption + (i / COLUMNS) * (panel_height + axis_below + caption);
        panel_draw(c, s, i, (box){x, y, width, panel_height});
    }
    rod_legend(c, s->show, (box){side, head + panels_height(s), sheet_width - 2 * side + 28, 0},
               ROD_NOTE_NONE);
    say(c, side, sheet_height(s) - 12, LOOK_SMALL,
        "Geometric centre of the tip, in the world. Hollow dots: stopped at a limit point before "
        "all was applied.%s",
        s->limited ? " A material's limit: its linear strain." : "");
    return OK;
}

// "tension of t1, N"; where lines differ in what they sweep, its kind
static void name_abscissa(sweep_sheet *s)
{
    static const char *const kinds[GIVEN_KINDS] = {"tension, N", "length drawn, mm",
                                                   "factor of the load"};
    const rod_line *first = &s->show->line[0];
    bool same = true, same_kind = true;
    char name[2 * RESULT_NAME];
    for (int i = 1; i < s->show->nline; i++) {
        const rod_quantity q = s->show->line[i].lead;
        same = same && q.kind == first->lead.kind && q.index == first->lead.index;
        same_kind = same_kind && q.kind == first->lead.kind;
    }
    rod_quantity_name(&s->r->rod, first->lead, name, sizeof name);
    if (same) {
        const char *unit = rod_quantity_unit(first->lead);
        (void)snprintf(s->along, sizeof s->along, "%s%s%s", name, *unit ? ", " : "", unit);
    } else {
        (void)snprintf(s->along, sizeof s->along, "%s",
                       same_kind ? kinds[first->lead.kind] : "what varies, each in its unit");
    }
}

status figure_sweep(const run_result *r, const char *dir)
{
    status st = OK;
    rod_show show = {0};
    sweep_sheet s = {.r = r, .show = &show, .npanel = PANELS - 1};
    if (!r->has_rod || r->rod.nsolution == 0) {
        return OK;
    }
    TRY(rod_show_make(&r->rod, &show));
    if (!show.sweep) {
        goto done;
    }
    for (int i = 0; i < r->nmaterial; i++) {
        s.limited = s.limited || r->materials[i].linear_strain > 0;
    }
    for (int i = 0; i < r->rod.nsolution; i++) {
        s.npanel = isfinite(r->rod.run[i].eigenvalue) ? PANELS : s.npanel;
    }
    name_abscissa(&s);
    const picture p = {
        .name = "sweep",
        .title = "Tip position, bend and largest strain along the sweep",
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
