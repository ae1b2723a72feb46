// bench/bench_draw.c
// CPU time against error, both axes logarithmic: bench_draw NAME POINTS.csv DIR writes DIR/NAME.svg
// and .png. A line of the file is "series,cpu_ms,error"; a line "#x#y" names other axes.
#include "base/memory.h"
#include "reports/figure_kit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_POINTS = 1000, MOST_SERIES = 16, NAME_SIZE = 48 };

typedef struct point {
    int series;
    double x, y; // decades
} point;

typedef struct chart {
    int npoint, nseries;
    point *point;
    char series[MOST_SERIES][NAME_SIZE];
    char axis[2][NAME_SIZE];
} chart;

static int series_index(chart *c, const char *name)
{
    for (int i = 0; i < c->nseries; i++) {
        if (strcmp(c->series[i], name) == 0) {
            return i;
        }
    }
    if (c->nseries < MOST_SERIES) {
        (void)snprintf(c->series[c->nseries++], NAME_SIZE, "%.*s", NAME_SIZE - 1, name);
    }
    return c->nseries - 1;
}

// a name may hold commas: the numbers are the last two fields
static bool read_point(chart *c, char *line)
{
    for (int i = 0; i < 2; i++) {
        char *comma = strrchr(line, ',');
        if (!comma) {
            return false;
        }
        *comma = '\0';
        char *end = comma + 1;
        const double value = strtod(comma + 1, &end);
        if (end == comma + 1 || !(value > 0) || !isfinite(value)) {
            return false;
        }
        *(i ? &c->point[c->npoint].x : &c->point[c->npoint].y) = log10(value);
    }
    c->point[c->npoint++].series = series_index(c, line);
    return true;
}

static int by_time(const void *a, const void *b)
{
    const point *p = a, *q = b;
    return p->series != q->series ? p->series - q->series : (p->x > q->x) - (p->x < q->x);
}

static status read_points(const char *path, chart *c)
{
    status st = OK;
    char line[256];
    FILE *file = fopen(path, "r");
    if (!file) {
        return status_fail(ERR_FILE, "%s: cannot be read", path);
    }
    TRY(TAKE(c->point, MOST_POINTS));
    while (c->npoint < MOST_POINTS && fgets(line, sizeof line, file)) {
        if (sscanf(line, "#%47[^#]#%47[^\n]", c->axis[0], c->axis[1]) != 2) {
            // errors of exactly 0 have no place on a logarithmic axis
            (void)read_point(c, line);
        }
    }
    if (c->npoint == 0) {
        TRY(status_fail(ERR_FILE, "%s: holds no points", path));
    }
    qsort(c->point, (size_t)c->npoint, sizeof *c->point, by_time);

done:
    (void)fclose(file);
    return st;
}

// the inks come round: then hollow
static void mark_at(canvas *c, double x, double y, int series)
{
    const colour ink = colour_series(series % 8);
    canvas_circle(c, x, y, 3);
    if (series < 8) {
        canvas_fill(c, ink);
    } else {
        canvas_fill_stroke(c, PAPER, ink, 1.4);
    }
}

static void curve(canvas *c, const plot *p, const chart *data, int series)
{
    const colour ink = colour_series(series % 8);
    int n = 0;
    for (int i = 0; i < data->npoint; i++) {
        const point *q = &data->point[i];
        if (q->series == series) {
            (n++ ? canvas_line : canvas_move)(c, plot_x(p, q->x), plot_y(p, q->y));
        }
    }
    canvas_stroke(c, ink, 1.6);
    for (int i = 0; i < data->npoint; i++) {
        const point *q = &data->point[i];
        if (q->series == series) {
            mark_at(c, plot_x(p, q->x), plot_y(p, q->y), series);
        }
    }
}

// whole decades around all points
static void decades(const chart *data, plot *p)
{
    *p = (plot){.at = p->at, INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (int i = 0; i < data->npoint; i++) {
        const point *q = &data->point[i];
        p->x0 = fmin(p->x0, floor(q->x));
        p->x1 = fmax(p->x1, floor(q->x) + 1);
        p->y0 = fmin(p->y0, floor(q->y));
        p->y1 = fmax(p->y1, floor(q->y) + 1);
    }
}

static status draw(canvas *c, const void *data)
{
    const chart *all = data;
    plot p = {.at = {60, 16, 420, 360}};
    decades(all, &p);
    plot_decades(c, &p, all->axis[0], all->axis[1]);
    for (int i = 0; i < all->nseries; i++) {
        const double y = p.at.y + 12 + 18 * i, x = p.at.x + p.at.w + 16;
        curve(c, &p, all, i);
        mark_at(c, x, y - 4, i);
        say(c, x + 10, y, LOOK_SMALL, "%s", all->series[i]);
    }
    return OK;
}

int main(int argc, char **argv)
{
    status st = OK;
    chart data = {.axis = {"CPU time, ms", "relative error"}};
    if (argc != 4) {
        fprintf(stderr, "usage: bench_draw NAME POINTS.csv DIR\n");
        return 2;
    }
    TRY(read_points(argv[2], &data));
    TRY(picture_write(&(picture){.name = argv[1],
                                 .title = "CPU time against error",
                                 .width = 680,
                                 .height = 430,
                                 .draw = draw,
                                 .data = &data},
                      argv[3]));

done:
    free(data.point);
    if (st != OK) {
        fprintf(stderr, "bench_draw: %s\n", status_message());
    }
    return st != OK;
}
