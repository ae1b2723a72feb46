// reports/figure_scan.c
// A scan from three sides with the cylinders and the line that were put through it, and how well
// every place is known.
#include "reports/figure_kit.h"
#include "reports/scan_report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double sheet_width = 1000, sheet_height = 720, side = 28, head = 78;
static const double views_height = 380, view_gap = 26;

// One side: which coordinates go right and up.
typedef struct scan_view {
    int across, up;
    box at;
    double low[3], high[3]; // of what is drawn [mm]
    double scale;           // points per mm, of all views the same
} scan_view;

static double view_x(const scan_view *v, vec3 p)
{
    const double middle = (v->low[v->across] + v->high[v->across]) / 2;
    return v->at.x + v->at.w / 2 + v->scale * (1e3 * p.a[v->across] - middle);
}

static double view_y(const scan_view *v, vec3 p)
{
    const double middle = (v->low[v->up] + v->high[v->up]) / 2;
    return v->at.y + v->at.h / 2 - v->scale * (1e3 * p.a[v->up] - middle);
}

// the body with some room around it; strays farther off are cut
static void extent(const scan_result *r, double low[3], double high[3])
{
    for (int d = 0; d < 3; d++) {
        low[d] = INFINITY;
        high[d] = -INFINITY;
        for (int i = 0; i < r->line.count; i++) {
            low[d] = fmin(low[d], 1e3 * r->line.p[i].a[d]);
            high[d] = fmax(high[d], 1e3 * r->line.p[i].a[d]);
        }
        low[d] -= 2.5e3 * r->line.radius;
        high[d] += 2.5e3 * r->line.radius;
    }
}

static void cloud_draw(canvas *c, const scan_result *r, const scan_view *v)
{
    for (size_t i = 0; i < r->shown.count; i++) {
        const vec3 p = {{r->shown.p[i][0], r->shown.p[i][1], r->shown.p[i][2]}};
        const double x = view_x(v, p), y = view_y(v, p);
        const bool inside =
            x > v->at.x && x < v->at.x + v->at.w && y > v->at.y && y < v->at.y + v->at.h;
        if (inside) {
            canvas_rectangle(c, x - 0.6, y - 0.6, 1.2, 1.2);
        }
    }
    canvas_fill(c, CLOUD_POINT);
}

static vec3 tangent(const centreline *c, double s, double h)
{
    const vec3 d = vec3_sub(centreline_at(c, fmin(s + h, c->s[c->count - 1])),
                            centreline_at(c, fmax(s - h, c->s[0])));
    return vec3_scale(1 / fmax(vec3_norm(d), 1e-300), d);
}

// the rim of a cylinder: a circle across the line
static void rim(canvas *c, const scan_result *r, const scan_view *v, double s)
{
    enum { SIDES = 40 };
    const vec3 p = centreline_at(&r->line, s), t = tangent(&r->line, s, r->line.radius / 2);
    const int least = fabs(t.a[0]) < fabs(t.a[1]) ? (fabs(t.a[0]) < fabs(t.a[2]) ? 0 : 2)
                                                  : (fabs(t.a[1]) < fabs(t.a[2]) ? 1 : 2);
    vec3 e = {{0, 0, 0}};
    e.a[least] = 1;
    vec3 n = vec3_cross(t, e);
    n = vec3_scale(r->line.radius / vec3_norm(n), n);
    const vec3 b = vec3_cross(t, n);
    for (int i = 0; i <= SIDES; i++) {
        const double angle = 2 * acos(-1.0) * i / SIDES;
        const vec3 at = vec3_add_scaled(vec3_add_scaled(p, cos(angle), n), sin(angle), b);
        if (i == 0) {
            canvas_move(c, view_x(v, at), view_y(v, at));
        } else {
            canvas_line(c, view_x(v, at), view_y(v, at));
        }
    }
    canvas_stroke(c, CLOUD_TUBE, 0.9);
}

static void line_draw(canvas *c, const scan_result *r, const scan_view *v)
{
    const centreline *l = &r->line;
    for (int i = 0; i < l->count; i++) {
        if (i == 0) {
            canvas_move(c, view_x(v, l->p[i]), view_y(v, l->p[i]));
        } else {
            canvas_line(c, view_x(v, l->p[i]), view_y(v, l->p[i]));
        }
    }
    canvas_stroke(c, INK_ACCENT, 1.8);
    canvas_circle(c, view_x(v, l->p[0]), view_y(v, l->p[0]), 3);
    canvas_fill(c, INK_ACCENT);
}

static bool in_gap(const tube_report *t, double s)
{
    bool in = false;
    for (int i = 0; i < t->ngap; i++) {
        in = in || (s >= t->gap[i].from && s <= t->gap[i].to);
    }
    return in;
}

static void view_draw(canvas *c, const scan_result *r, const scan_view *v)
{
    static const char axes[] = "xyz";
    const double length = r->line.s[r->line.count - 1], step = 1.5 * r->line.radius;
    canvas_clip(c, v->at.x, v->at.y, v->at.w, v->at.h);
    cloud_draw(c, r, v);
    for (double s = r->line.s[0]; s <= length; s += fmax(step, length / 200)) {
        if (in_gap(&r->tube, s)) {
            canvas_dash(c, 2, 2);
        }
        rim(c, r, v, s);
        canvas_dash(c, 0, 0);
    }
    line_draw(c, r, v);
    canvas_unclip(c);
    canvas_rectangle(c, v->at.x, v->at.y, v->at.w, v->at.h);
    canvas_stroke(c, INK_GRID, 0.9);
    say(c, v->at.x + v->at.w / 2, v->at.y + v->at.h + 15, look_aligned(LOOK_SMALL, TEXT_CENTRE),
        "%c to the right, %c up", axes[v->across], axes[v->up]);
}

// three views side by side, one scale for all of them
static void views_draw(canvas *c, const scan_result *r)
{
    static const int sides[3][2] = {{0, 2}, {1, 2}, {0, 1}};
    scan_view v[3];
    double low[3], high[3], wide = 0, scale = INFINITY, x = side;
    extent(r, low, high);
    for (int i = 0; i < 3; i++) {
        v[i] = (scan_view){.across = sides[i][0], .up = sides[i][1]};
        memcpy(v[i].low, low, sizeof low);
        memcpy(v[i].high, high, sizeof high);
        wide += high[v[i].across] - low[v[i].across];
        scale = fmin(scale, views_height / (high[v[i].up] - low[v[i].up]));
    }
    const double room = sheet_width - 2 * side - 2 * view_gap;
    scale = fmin(scale, room / wide);
    for (int i = 0; i < 3; i++) {
        const double w = (high[v[i].across] - low[v[i].across]) / wide * room;
        v[i].at = (box){x, head, w, views_height};
        v[i].scale = scale;
        view_draw(c, r, &v[i]);
        x += w + view_gap;
    }
    scale_bar(c, sheet_width - side - 8, head + views_height - 10, 90, scale);
}

static void gaps_draw(canvas *c, const scan_result *r, const plot *p)
{
    for (int i = 0; i < r->tube.ngap; i++) {
        const double x0 = plot_x(p, 1e3 * r->tube.gap[i].from);
        const double x1 = plot_x(p, 1e3 * r->tube.gap[i].to);
        canvas_rectangle(c, x0, p->at.y, fmax(x1 - x0, 1), p->at.h);
        canvas_fill(c, CLOUD_GAP);
    }
}

static void curve(canvas *c, const scan_result *r, const plot *p, const double *sigma, colour ink)
{
    for (int i = 0; i < r->line.count; i++) {
        const double x = plot_x(p, 1e3 * r->line.s[i]), y = plot_y(p, 1e3 * sigma[i]);
        if (i == 0) {
            canvas_move(c, x, y);
        } else {
            canvas_line(c, x, y);
        }
    }
    canvas_stroke(c, ink, 1.8);
}

static void sigma_draw(canvas *c, const scan_result *r)
{
    double at = 0;
    plot p = {.at = {side + 60, head + views_height + 62, sheet_width - 2 * side - 62, 140},
              .x0 = 1e3 * r->line.s[0],
              .x1 = 1e3 * r->line.s[r->line.count - 1],
              .y1 = 1.15e3 * scan_worst_sigma(r, &at)};
    p.y1 = fmax(p.y1, 1e-6);
    say(c, side, p.at.y - 14, LOOK_HEADING, "How well each place across the line is known");
    gaps_draw(c, r, &p);
    plot_frame(c, &p, "arclength s, mm", "standard deviation, mm");
    curve(c, r, &p, r->fit_sigma, colour_series(1));
    curve(c, r, &p, r->line.sigma, colour_series(0));
    const double x = p.at.x + p.at.w;
    say(c, x, p.at.y - 14, look_aligned(LOOK_SMALL, TEXT_RIGHT),
        "blue: with the frame's; orange: of the fit alone%s",
        r->tube.ngap > 0 ? "; shaded: less than a quarter of the girth was seen" : "");
}

static status scan_draw(canvas *c, const void *data)
{
    const scan_named *scan = data;
    const scan_result *r = scan->result;
    const char *slash = strrchr(scan->name, '/');
    char words[300];
    (void)snprintf(words, sizeof words, "%s%s", slash ? slash + 1 : scan->name,
                   r->synthetic ? " (synthetic: made, not measured)" : "");
    say_within(c, side, 34, sheet_width - 2 * side, LOOK_TITLE, words);
    say(c, side, 56, LOOK_SMALL,
        "grey: %zu of %zu points; blue: rims of cylinders of %s mm; red: centreline, %s mm long, "
        "dot at its base; frame %s",
        r->shown.count, r->cloud.read, number_digits(1e3 * r->line.radius, 4).text,
        number_digits(1e3 * r->tube.length, 5).text, scan_frame_words(r));
    views_draw(c, r);
    sigma_draw(c, r);
    return OK;
}

status figure_scan(const scan_named *scan, const char *directory)
{
    return picture_write(&(picture){.name = "scan",
                                    .title = "A scanned cloud and its centreline",
                                    .width = sheet_width,
                                    .height = sheet_height,
                                    .draw = scan_draw,
                                    .data = scan},
                         directory);
}
