// reports/figure_along.c
#include "reports/figure_along.h"

#include <math.h>
#include <stdio.h>

enum { COLUMNS = 3 };

static const double side = 28, head = 74, sheet_width = 1000, panel_height = 168;
static const double axis_left = 62, axis_below = 50, gap = 8, caption = 20, foot_row = 20;
// what is smaller beside the largest of its group is drawn as the nothing that it is
static const double nothing_part = 1e-9;

static double value_at(const along_sheet *s, const along_panel *p, int shown, int point)
{
    const rod_result *rod = &s->r->rod;
    return p->value(rod, &rod->run[s->show->shown[shown]], point, p->index);
}

static double largest_of(const along_sheet *s, int group)
{
    double most = 0;
    for (int k = 0; k < s->npanel; k++) {
        for (int i = 0; s->panel[k].group == group && i < s->show->nshown; i++) {
            for (int point = 0; point < s->r->rod.npoint;
                 point = rod_next_point(&s->r->rod, point)) {
                most = fmax(most, fabs(value_at(s, &s->panel[k], i, point)));
            }
        }
    }
    return most;
}

static plot panel_plot(const along_sheet *s, const along_panel *panel, box at)
{
    plot p = {at, 0, s->r->rod_length * 1e3, 0, 0};
    for (int i = 0; i < s->show->nshown; i++) {
        for (int k = 0; k < s->r->rod.npoint; k = rod_next_point(&s->r->rod, k)) {
            const double v = value_at(s, panel, i, k);
            p.y0 = fmin(p.y0, v);
            p.y1 = fmax(p.y1, v);
        }
    }
    const double most = largest_of(s, panel->group);
    if (fmax(-p.y0, p.y1) <= nothing_part * most) {
        p.y0 = most > 0 ? -0.1 * most : -1;
        p.y1 = -p.y0;
    }
    range_pad(&p.y0, &p.y1, 0.06, 1e-300);
    return p;
}

static void panel_draw(canvas *c, const along_sheet *s, const along_panel *panel, box at)
{
    const plot p = panel_plot(s, panel, at);
    const double end = panel->to > 0 ? panel->to * (1 + 1e-9) : INFINITY;
    say_within(c, at.x, at.y - 7, at.w, LOOK_HEADING, panel->name);
    plot_frame(c, &p, "arclength s, mm", panel->label);
    canvas_clip(c, at.x, at.y, at.w, at.h);
    for (int i = 0; i < s->show->nshown; i++) {
        const int solution = s->show->shown[i];
        const struct rod_run *run = &s->r->rod.run[solution];
        for (int k = 0; k < s->r->rod.npoint && run->s[k] <= end;
             k = rod_next_point(&s->r->rod, k)) {
            const double x = plot_x(&p, run->s[k] * 1e3), y = plot_y(&p, value_at(s, panel, i, k));
            if (k == 0) {
                canvas_move(c, x, y);
            } else {
                canvas_line(c, x, y);
            }
        }
        canvas_stroke(c, s->show->ink[solution], s->show->sweep ? 1.4 : 2);
    }
    canvas_unclip(c);
}

static int places(const along_sheet *s)
{
    return s->npanel + (s->first != NULL);
}

static double panels_height(const along_sheet *s)
{
    return (places(s) + COLUMNS - 1) / COLUMNS * (panel_height + axis_below + caption);
}

static bool some_only(const along_sheet *s)
{
    return s->show->nshown < s->r->rod.nsolution;
}

static double sheet_height(const along_sheet *s)
{
    const int lines = (s->remark != NULL) + some_only(s);
    return head + panels_height(s) + rod_legend_height(s->show) + 24 + foot_row * lines;
}

static void notes(canvas *c, const along_sheet *s)
{
    const double y = sheet_height(s) - 12;
    if (some_only(s)) {
        char which[80];
        rod_show_words(s->show, which, sizeof which);
        say(c, side, y - (s->remark ? foot_row : 0), LOOK_SMALL, "Curves of %s.", which);
    }
    if (s->remark) {
        say(c, side, y, LOOK_SMALL, "%s", s->remark);
    }
}

static status draw(canvas *c, const void *data)
{
    const along_sheet *s = data;
    const double width =
        (sheet_width - 2 * side - COLUMNS * axis_left - (COLUMNS - 1) * gap) / COLUMNS;

    say(c, side, 36, LOOK_TITLE, "%s", s->title);
    say_within(c, side, 56, sheet_width - 2 * side, LOOK_SMALL, s->r->title);
    for (int i = 0; i < places(s); i++) {
        const double x = side + axis_left + (i % COLUMNS) * (width + gap + axis_left);
        const double y = head + caption + (i / COLUMNS) * (panel_height + axis_below + caption);
        const box at = {x, y, width, panel_height};
        if (s->first && i == 0) {
            s->first(c, s, at);
        } else {
            panel_draw(c, s, &s->panel[i - (s->first != NULL)], at);
        }
    }
    rod_legend(c, s->show, (box){side, head + panels_height(s), sheet_width - 2 * side + 28, 0},
               s->note);
    notes(c, s);
    return OK;
}

status along_write(const along_sheet *s, const char *dir)
{
    char which[80], title[200];
    rod_show_words(s->show, which, sizeof which);
    (void)snprintf(title, sizeof title, "%s, of %s", s->alt, which);
    const picture p = {
        .name = s->name,
        .title = title,
        .width = sheet_width,
        .height = sheet_height(s),
        .draw = draw,
        .data = s,
    };
    return picture_write(&p, dir);
}
