// reports/wall_view.c
#include "reports/wall_view.h"

#include "base/memory.h"
#include "reports/figure_kit.h"

#include <math.h>
#include <stdlib.h>

enum { RIM = 3 }; // raster points around it

void wall_free(wall *w)
{
    free(w->normal);
    *w = (wall){0};
}

static vec3 vertex_of(const wall *w, int i)
{
    return (vec3){{w->vertex[i][0], w->vertex[i][1], w->vertex[i][2]}};
}

status wall_make(int nvertex, const double (*vertex)[3], int ntriangle, const int (*triangle)[3],
                 wall *out)
{
    status st = OK;
    wall w = {nvertex, ntriangle, vertex, triangle, NULL};
    TRY(TAKE(w.normal, (size_t)nvertex));
    for (int t = 0; t < ntriangle; t++) {
        const vec3 a = vertex_of(&w, triangle[t][0]);
        const vec3 n = vec3_cross(vec3_sub(vertex_of(&w, triangle[t][1]), a),
                                  vec3_sub(vertex_of(&w, triangle[t][2]), a));
        for (int k = 0; k < 9; k++) {
            w.normal[triangle[t][k / 3]][k % 3] += n.a[k % 3];
        }
    }
    for (int i = 0; i < nvertex; i++) {
        double *n = w.normal[i];
        const double size = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int k = 0; k < 3; k++) {
            n[k] = size > 0 ? n[k] / size : 0;
        }
    }
    *out = w;

done:
    return st;
}

void wall_view_free(wall_view *v)
{
    free(v->thick);
    free(v->near);
    free(v->far);
    free(v->near_light);
    free(v->far_light);
    *v = (wall_view){0};
}

static void lay_out(const wall *w, int most, wall_view *v)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < w->nvertex; i++) {
        const vec3 seen = camera_see(&v->camera, vertex_of(w, i));
        for (int d = 0; d < 2; d++) {
            low[d] = fmin(low[d], seen.a[d]);
            high[d] = fmax(high[d], seen.a[d]);
        }
    }
    const double size[2] = {high[0] - low[0], high[1] - low[1]};
    v->step = fmax(size[0], size[1]) / most;
    if (!(v->step > 0 && isfinite(v->step))) {
        return;
    }
    v->nx = (int)(size[0] / v->step) + 2 * RIM + 1;
    v->ny = (int)(size[1] / v->step) + 2 * RIM + 1;
    v->low[0] = low[0] - RIM * v->step;
    v->low[1] = low[1] - RIM * v->step;
}

// --- one triangle

typedef struct seen_corner {
    double x, y, z; // in steps, in steps, [m]
    double light;
    int vertex;
} seen_corner;

// twice the area of a, b, p; of an edge that two triangles share the same number but for its sign
static double side_of(const seen_corner *a, const seen_corner *b, double x, double y)
{
    const bool turn = a->vertex > b->vertex;
    const seen_corner *p = turn ? b : a, *q = turn ? a : b;
    const double twice = (q->x - p->x) * (y - p->y) - (q->y - p->y) * (x - p->x);
    return turn ? -twice : twice;
}

static void put_point(wall_view *v, int k, double depth, double light, bool faces)
{
    v->thick[k] += faces ? depth : -depth;
    if (depth > v->near[k]) {
        v->near[k] = depth;
        v->near_light[k] = light;
    }
    if (depth < v->far[k]) {
        v->far[k] = depth;
        v->far_light[k] = light;
    }
}

static void put_triangle(wall_view *v, const seen_corner c[3])
{
    const double twice = side_of(&c[0], &c[1], c[2].x, c[2].y);
    if (!(fabs(twice) > 0 && isfinite(twice))) {
        return;
    }
    const double way = twice > 0 ? 1 : -1;
    const int i0 = (int)fmax(0, floor(fmin(fmin(c[0].x, c[1].x), c[2].x)));
    const int j0 = (int)fmax(0, floor(fmin(fmin(c[0].y, c[1].y), c[2].y)));
    const int i1 = (int)fmin(v->nx - 1, ceil(fmax(fmax(c[0].x, c[1].x), c[2].x)));
    const int j1 = (int)fmin(v->ny - 1, ceil(fmax(fmax(c[0].y, c[1].y), c[2].y)));
    for (int j = j0; j <= j1; j++) {
        for (int i = i0; i <= i1; i++) {
            double share[3];
            bool in = true;
            for (int k = 0; k < 3; k++) {
                share[k] = side_of(&c[(k + 1) % 3], &c[(k + 2) % 3], i, j);
                // on an edge: in one of its two triangles, or where the wall folds in both or none
                const bool rises = c[(k + 1) % 3].vertex > c[(k + 2) % 3].vertex;
                in = in && (way * share[k] > 0 || (share[k] == 0 && rises == (way > 0)));
            }
            if (in) {
                const double sum = share[0] + share[1] + share[2];
                double depth = 0, light = 0;
                for (int k = 0; k < 3; k++) {
                    depth += share[k] / sum * c[k].z;
                    light += share[k] / sum * c[k].light;
                }
                put_point(v, i + v->nx * j, depth, fabs(light), twice > 0);
            }
        }
    }
}

static void put_wall(const wall *w, wall_view *v)
{
    for (int t = 0; t < w->ntriangle; t++) {
        seen_corner c[3];
        for (int k = 0; k < 3; k++) {
            const int i = w->triangle[t][k];
            const vec3 p = camera_see(&v->camera, vertex_of(w, i));
            const double *n = w->normal[i];
            c[k] = (seen_corner){(p.a[0] - v->low[0]) / v->step, (p.a[1] - v->low[1]) / v->step,
                                 p.a[2], vec3_dot(v->camera.eye, (vec3){{n[0], n[1], n[2]}}), i};
        }
        put_triangle(v, c);
    }
}

status wall_view_make(const wall *w, const camera *c, int most, wall_view *out)
{
    status st = OK;
    wall_view v = {.camera = *c};
    lay_out(w, most, &v);
    const size_t n = (size_t)v.nx * (size_t)v.ny;
    TRY(TAKE(v.thick, n));
    TRY(TAKE(v.near, n));
    TRY(TAKE(v.far, n));
    TRY(TAKE(v.near_light, n));
    TRY(TAKE(v.far_light, n));
    for (size_t k = 0; k < n; k++) {
        v.near[k] = -INFINITY;
        v.far[k] = INFINITY;
    }
    if (n > 0) {
        put_wall(w, &v);
    }
    *out = v;
    v = (wall_view){0};

done:
    wall_view_free(&v);
    return st;
}

vec3 wall_view_place(const wall_view *v, int k, bool near)
{
    const double x = v->low[0] + v->step * (k % v->nx), y = v->low[1] + v->step * (k / v->nx);
    vec3 p = vec3_scale(x, v->camera.right);
    p = vec3_add_scaled(p, y, v->camera.up);
    return vec3_add_scaled(p, near ? v->near[k] : v->far[k], v->camera.eye);
}

// --- as an X-ray shows it

void wall_shade_free(wall_shade *s)
{
    contours_free(&s->outline);
    for (int i = 0; i < SHADES; i++) {
        contours_free(&s->level[i]);
    }
    *s = (wall_shade){0};
}

status wall_shade_make(const wall_view *v, int nlevel, double slack, wall_shade *out)
{
    status st = OK;
    const int n = v->nx * v->ny;
    wall_shade s = {.nlevel = nlevel < SHADES ? nlevel : SHADES};
    raster inside = {v->nx, v->ny, NULL}, smooth = inside;
    double most = 0;
    TRY(TAKE(inside.value, (size_t)n));
    TRY(TAKE(smooth.value, (size_t)n));
    for (int k = 0; k < n; k++) {
        inside.value[k] = v->near[k] > -INFINITY;
        most = fmax(most, v->thick[k]);
    }
    raster_smooth(&inside, &smooth);
    TRY(contours_make(&smooth, 0.5, slack, 4, &s.outline));
    raster_smooth(&(raster){v->nx, v->ny, v->thick}, &inside);
    raster_smooth(&inside, &smooth);
    for (int i = 0; i < s.nlevel && most > 0; i++) {
        TRY(contours_make(&smooth, most * (i + 0.8) / (s.nlevel + 0.6), 2 * slack, 20,
                          &s.level[i]));
    }
    *out = s;
    s = (wall_shade){0};

done:
    wall_shade_free(&s);
    free(inside.value);
    free(smooth.value);
    return st;
}

void wall_shade_draw(canvas *c, const wall_shade *s, double x, double y, double step)
{
    contours_path(c, &s->outline, x, y, step);
    canvas_fill_stroke(c, TISSUE_PALE, TISSUE_RIM, 0.9);
    for (int i = 0; i < s->nlevel; i++) {
        contours_path(c, &s->level[i], x, y, step);
        canvas_fill(c, colour_mix(TISSUE_PALE, TISSUE_DEEP, (i + 1.0) / s->nlevel));
    }
}
