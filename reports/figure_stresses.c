// reports/figure_stresses.c
// One row for every wrench on the section: the largest principal strain and the von Mises stress in
// colours, the places of each material's largest marked.
#include "base/memory.h"
#include "reports/figure_kit.h"
#include "reports/figures.h"
#include "section/extremes.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ROWS_SHOWN = 4 };

// Cells of one colour, at most: a picture of more is slow to show, and ParaView has them all.
enum { MOST_CELLS = 10000, MOST_CELLS_OF_ONE = 60000 };

static const double side = 28, head = 70, row_height = 330, panel_width = 462, bar = 13;

typedef struct stress_sheet {
    const run_result *r;
    const section_answers *answers;
    int nrow;
    double *value; // [nodes] of the panel at hand
} stress_sheet;

// one panel: values over the section, their colours from 0 to the largest
typedef struct map {
    const mesh *mesh;
    const double *value;
    double largest;
    double scale, x0, y0; // points per m, and where the origin stands
} map;

static void fit(map *p, box at)
{
    double low[2] = {DBL_MAX, DBL_MAX}, high[2] = {-DBL_MAX, -DBL_MAX};
    p->largest = 0;
    for (int i = 0; i < p->mesh->nnode; i++) {
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], p->mesh->xyz[3 * (size_t)i + (size_t)k]);
            high[k] = fmax(high[k], p->mesh->xyz[3 * (size_t)i + (size_t)k]);
        }
        p->largest = fmax(p->largest, p->value[i]);
    }
    const double w = fmax(high[0] - low[0], DBL_MIN), h = fmax(high[1] - low[1], DBL_MIN);
    p->scale = fmin(at.w / w, at.h / h);
    p->x0 = at.x + at.w / 2 - p->scale * (low[0] + high[0]) / 2;
    p->y0 = at.y + at.h / 2 + p->scale * (low[1] + high[1]) / 2;
}

// a cell of straight sides in the colour of its corners' mean
static void cell(canvas *c, const map *p, const int *conn, int n, const int *corner)
{
    double sum = 0;
    for (int i = 0; i < n; i++) {
        const int node = conn[corner[i]];
        const double *at = p->mesh->xyz + 3 * (size_t)node;
        const double x = p->x0 + p->scale * at[0], y = p->y0 - p->scale * at[1];
        sum += p->value[node] / n;
        if (i == 0) {
            canvas_move(c, x, y);
        } else {
            canvas_line(c, x, y);
        }
    }
    canvas_close(c);
    const colour ink = colour_ramp(p->largest > 0 ? sum / p->largest : 0);
    canvas_fill_stroke(c, ink, ink, 0.4); // the stroke closes the seams between cells
}

static void quad_cells(canvas *c, const map *p, const int *conn)
{
    const int n = p->mesh->order;
    for (int j = 0; j < n; j++) {
        for (int i = 0; i < n; i++) {
            const int a = i + (n + 1) * j;
            cell(c, p, conn, 4, (const int[]){a, a + 1, a + n + 2, a + n + 1});
        }
    }
}

static void triangle_cells(canvas *c, const map *p, const int *conn)
{
    const int n = p->mesh->order;
    for (int j = 0, row = 0; j < n; row += n + 1 - j, j++) {
        const int above = row + n + 1 - j;
        for (int i = 0; i < n - j; i++) {
            cell(c, p, conn, 3, (const int[]){row + i, row + i + 1, above + i});
            if (i + 1 < n - j) {
                cell(c, p, conn, 3, (const int[]){row + i + 1, above + i + 1, above + i});
            }
        }
    }
}

static void cells(canvas *c, const map *p)
{
    for (int b = 0; b < p->mesh->nblock; b++) {
        const mesh_block *block = &p->mesh->block[b];
        for (int e = 0; e < block->nelem; e++) {
            const int *conn = block->conn + (size_t)e * (size_t)block->per_elem;
            if (block->shape == SHAPE_QUAD) {
                quad_cells(c, p, conn);
            } else {
                triangle_cells(c, p, conn);
            }
        }
    }
}

static void colour_bar(canvas *c, const map *p, box at, double unit)
{
    const int cuts = 100;
    for (int i = 0; i < cuts; i++) {
        canvas_rectangle(c, at.x, at.y + at.h * (cuts - 1 - i) / cuts, at.w, at.h / cuts + 0.5);
        canvas_fill(c, colour_ramp((i + 0.5) / cuts));
    }
    for (int i = 0; i <= 4; i++) {
        const double y = at.y + at.h * (1 - i / 4.0);
        canvas_segment(c, at.x + at.w, y, at.x + at.w + 4, y);
        canvas_stroke(c, INK_SOFT, 0.8);
        say(c, at.x + at.w + 8, y + 3.7, LOOK_TICK, "%s",
            number_short(p->largest * unit * i / 4, 3).text);
    }
}

static void ring(canvas *c, const map *p, const section_extreme *e)
{
    canvas_circle(c, p->x0 + p->scale * e->at[0], p->y0 - p->scale * e->at[1], 4);
    canvas_stroke(c, PAPER, 3);
    canvas_circle(c, p->x0 + p->scale * e->at[0], p->y0 - p->scale * e->at[1], 4);
    canvas_stroke(c, INK, 1.3);
}

static double strain_size(const section_load_answer *load, int node)
{
    vec6 strain;
    memcpy(strain.a, load->strain[node], sizeof strain.a);
    return fabs(principal_strain(&strain));
}

static double stress_size(const section_load_answer *load, int node)
{
    vec6 stress;
    memcpy(stress.a, load->stress[node], sizeof stress.a);
    return von_mises(&stress);
}

static void panel(canvas *c, const stress_sheet *s, const section_load_answer *load, bool stress,
                  box at)
{
    map p = {.mesh = &s->answers->nodes, .value = s->value};
    for (int i = 0; i < p.mesh->nnode; i++) {
        s->value[i] = stress ? stress_size(load, i) : strain_size(load, i);
    }
    fit(&p, (box){at.x + 10, at.y + 24, at.w - 110, at.h - 54});
    say(c, at.x, at.y + 8, LOOK_TEXT, "%s",
        stress ? "von Mises stress, MPa" : "largest principal strain, %");
    cells(c, &p);
    for (int m = 0; m < s->r->nmaterial; m++) {
        if (load->extreme[m].used) {
            ring(c, &p, stress ? &load->extreme[m].von_mises : &load->extreme[m].strain);
        }
    }
    colour_bar(c, &p, (box){at.x + at.w - 80, at.y + 24, bar, at.h - 54}, stress ? 1e-6 : 100);
}

static status draw(canvas *c, const void *data)
{
    const stress_sheet *s = data;
    say(c, side, 36, LOOK_TITLE, "Strain and stress at s = %s mm",
        number_short(s->r->section.station[s->answers->station].s * 1e3, 5).text);
    say_within(c, side, 56, 2 * panel_width - side, LOOK_SMALL, s->r->title);
    for (int i = 0; i < s->nrow; i++) {
        const section_load_answer *load = &s->answers->load[i];
        const double y = head + i * row_height;
        say_within(c, side, y + 14, 2 * panel_width - side, LOOK_HEADING, load->name);
        panel(c, s, load, false, (box){side, y + 24, panel_width - 10, row_height - 24});
        panel(c, s, load, true,
              (box){side + panel_width, y + 24, panel_width - 10, row_height - 24});
    }
    return OK;
}

static long cell_count(const mesh *m)
{
    long count = 0;
    for (int b = 0; b < m->nblock; b++) {
        count += (long)m->block[b].nelem * m->order * m->order;
    }
    return count;
}

status figure_stresses(const run_result *r, const char *dir)
{
    status st = OK;
    const section_answers *a = r->has_section && r->nanswer > 0 ? &r->answer[0] : NULL;
    if (!a || a->nload == 0 || a->nodes.nnode == 0) {
        return OK;
    }
    stress_sheet s = {
        .r = r,
        .answers = a,
        .nrow = a->nload < MOST_ROWS_SHOWN ? a->nload : MOST_ROWS_SHOWN,
    };
    if (2 * s.nrow * cell_count(&a->nodes) > MOST_CELLS) {
        s.nrow = (int)(MOST_CELLS / (2 * cell_count(&a->nodes)));
    }
    if (s.nrow == 0 && 2 * cell_count(&a->nodes) <= MOST_CELLS_OF_ONE && a->nload > 0) {
        s.nrow = 1; // rather slow than none
    }
    if (s.nrow == 0) {
        return OK;
    }
    TRY(TAKE(s.value, (size_t)a->nodes.nnode));
    const picture p = {
        .name = "stresses",
        .title = "Strain and stress in the section under the case's wrenches",
        .width = 2 * panel_width + 2 * side,
        .height = head + s.nrow * row_height,
        .draw = draw,
        .data = &s,
    };
    TRY(picture_write(&p, dir));

done:
    free(s.value);
    return st;
}
