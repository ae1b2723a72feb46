// reports/figure_segment_mesh.c
// The mesh of the segment: its section, and the layers from base to tip.
#include "reports/figure_kit.h"
#include "reports/figures.h"
#include "reports/plane_edges.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

// as wide as the other pictures, so that a page that fits all of them to its width has one size of
// letters: the section, the layers, and what is said of them beside (1000 units)
static const double side = 28, head = 74, picture_size = 520, bar_width = 150, words_width = 254;
static const double below = 40;
// more elements than this are a grey blur
enum { MOST_ELEMENTS = 60000, MOST_CUTS = 10 };

typedef struct sheet {
    const run_result *r;
    plane_edges edges;
} sheet;

typedef struct view {
    double scale, x0, y0;
} view;

static view fit(const mesh *m, box at)
{
    double low[2] = {DBL_MAX, DBL_MAX}, high[2] = {-DBL_MAX, -DBL_MAX};
    for (int i = 0; i < m->nnode; i++) {
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], m->xyz[3 * i + k]);
            high[k] = fmax(high[k], m->xyz[3 * i + k]);
        }
    }
    const double scale = fmin(at.w / (high[0] - low[0]), at.h / (high[1] - low[1]));
    return (view){scale, at.x + at.w / 2 - scale * (low[0] + high[0]) / 2,
                  at.y + at.h / 2 + scale * (low[1] + high[1]) / 2};
}

static void edge_path(canvas *c, const plane_edges *e, const plane_edge *edge, const view *v,
                      bool begin)
{
    const int cuts = e->line.order == 1 ? 1 : MOST_CUTS;
    for (int i = begin ? 0 : 1; i <= cuts; i++) {
        double p[2];
        plane_edge_point(e, edge, 2.0 * i / cuts - 1, p);
        const double x = v->x0 + v->scale * p[0], y = v->y0 - v->scale * p[1];
        if (i == 0) {
            canvas_move(c, x, y);
        } else {
            canvas_line(c, x, y);
        }
    }
}

static status fill_material(canvas *c, const plane_edges *e, int material, const view *v)
{
    status st = OK;
    plane_loops loops = {0};
    TRY(plane_loops_make(e, material, &loops));
    for (int l = 0; l < loops.nloop; l++) {
        for (int k = loops.start[l]; k < loops.start[l + 1]; k++) {
            edge_path(c, e, &e->edge[loops.order[k]], v, k == loops.start[l]);
        }
        canvas_close(c);
    }
    if (loops.nloop > 0) {
        canvas_fill(c, colour_mix(colour_material(material), PAPER, 0.35));
    }

done:
    plane_loops_free(&loops);
    return st;
}

static status draw_section(canvas *c, const sheet *s, box at)
{
    status st = OK;
    const view v = fit(&s->r->segment.body.plane, at);
    const double width = s->edges.count > 4000 ? 0.25 : 0.6;
    for (int m = 0; m < s->r->nmaterial; m++) {
        TRY(fill_material(c, &s->edges, m, &v));
    }
    for (int i = 0; i < s->edges.count; i++) {
        edge_path(c, &s->edges, &s->edges.edge[i], &v, true);
        canvas_stroke(c, INK, width);
    }
    scale_bar(c, at.x + at.w, at.y + at.h + 26, 90, v.scale * 1e-3);

done:
    return st;
}

// the layers' heights, base below
static void draw_layers(canvas *c, const sheet *s, box at)
{
    const segment_body *b = &s->r->segment.body;
    const double from = b->level[0], length = b->level[b->nlevel - 1] - from;
    canvas_rectangle(c, at.x, at.y, at.w, at.h);
    canvas_fill_stroke(c, FLOOR, INK, 1);
    for (int k = 1; k < b->nlayer; k++) {
        const double y = at.y + at.h * (1 - (b->level[k * b->order] - from) / length);
        canvas_segment(c, at.x, y, at.x + at.w, y);
        canvas_stroke(c, INK, b->nlayer > 200 ? 0.25 : 0.6);
    }
    const text_look look = look_aligned(look_inked(LOOK_SMALL, INK), TEXT_CENTRE);
    say(c, at.x + at.w / 2, at.y - 8, look, "tip, s = %s mm",
        number_short(b->level[b->nlevel - 1] * 1e3, 5).text);
    say(c, at.x + at.w / 2, at.y + at.h + 16, look, "base");
}

static status draw(canvas *c, const void *data)
{
    status st = OK;
    const sheet *s = data;
    const segment_body *b = &s->r->segment.body;
    const double words = side + picture_size + bar_width + 20;
    const double width = words + words_width + side;
    char text[400];
    double thin = DBL_MAX, thick = 0;
    for (int k = 0; k < b->nlayer; k++) {
        const double h = b->level[(k + 1) * b->order] - b->level[k * b->order];
        thin = fmin(thin, h);
        thick = fmax(thick, h);
    }
    say(c, side, 36, LOOK_TITLE, "The segment's mesh");
    say_within(c, side, 56, width - 2 * side, LOOK_SMALL, s->r->title);
    TRY(draw_section(c, s, (box){side, head, picture_size, picture_size - 30}));
    draw_layers(c, s, (box){side + picture_size + 70, head + 20, 56, picture_size - 50});
    (void)snprintf(
        text, sizeof text,
        "%d elements of order %d in the section's plane, %d layers of order %d, from %s mm "
        "to %s mm high; %lld unknowns.%s",
        mesh_element_count(&b->plane), b->plane.order, b->nlayer, b->order,
        number_digits(thin * 1e3, 3).text, number_digits(thick * 1e3, 3).text, s->r->segment.dofs,
        s->r->segment.way == WAY_DOUBLING
            ? " The layers are those of the fields: the solution itself comes from slabs "
              "joined to one another."
            : "");
    (void)say_paragraph(c, words, head + 40, words_width, LOOK_SMALL, text);

done:
    return st;
}

status figure_segment_mesh(const run_result *r, const char *dir)
{
    status st = OK;
    sheet s = {.r = r};
    const segment_body *b = &r->segment.body;
    if (!r->has_segment || b->plane.nnode == 0 || b->nlevel < 2 ||
        mesh_element_count(&b->plane) > MOST_ELEMENTS) {
        return OK;
    }
    TRY(plane_edges_make(&b->plane, &s.edges));
    const picture p = {
        .name = "segment_mesh",
        .title = "The mesh of the segment: the section's elements and the layers along it",
        .width = 2 * side + picture_size + bar_width + 20 + words_width,
        .height = head + picture_size + below,
        .draw = draw,
        .data = &s,
    };
    TRY(picture_write(&p, dir));

done:
    plane_edges_free(&s.edges);
    return st;
}
