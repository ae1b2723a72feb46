// reports/scene_bodies.c
// Rods that wear their section, and solids that move by a factor.
#include "reports/scene_parts.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

// from -most to most in 65535 steps
static uint16_t signed_step(double x, double most)
{
    const double step = most > 0 ? round((x / most + 1) / 2 * UINT16_MAX) : 0;
    return step > 0 ? (step < UINT16_MAX ? (uint16_t)step : UINT16_MAX) : 0;
}

static status put_signed(scene *s, const char *key, size_t n, const double *x, double most)
{
    status st = OK;
    uint16_t *word = NULL;
    TRY(TAKE(word, n));
    for (size_t i = 0; i < n; i++) {
        word[i] = signed_step(x[i], most);
    }
    TRY(scene_put_words(s, key, n, word));

done:
    free(word);
    return st;
}

// no number, which JSON calls null, where one of them is none
static double largest_of(size_t n, const double *x)
{
    double most = scene_are_numbers(n, x) ? 0 : NAN;
    for (size_t i = 0; i < n && !isnan(most); i++) {
        most = fmax(most, fabs(x[i]));
    }
    return most;
}

status scene_skin(scene *s, const scene_outline *o, int npoint, const double *turn)
{
    status st = OK;
    int n = 0;
    scene_begin(s, "skin", scene_in(0));
    json_array(s->j, "loops");
    for (int i = 0; i < o->nloop; i++) {
        n += o->loop[i];
        json_integer(s->j, NULL, o->loop[i]);
    }
    json_array_end(s->j);
    const double *place = n > 0 ? o->point[0] : NULL;
    const double most = largest_of(2 * (size_t)n, place);
    s->skin = most;
    json_real(s->j, "most", 1e3 * most);
    TRY(put_signed(s, "outline", 2 * (size_t)n, place, most));
    scene_put_colours(s, "colours", o->nink, o->colour);
    TRY(scene_put_bytes(s, "kinds", o->ink, (size_t)n));
    const double around = largest_of((size_t)npoint, turn);
    json_real(s->j, "around", around);
    TRY(put_signed(s, "turns", (size_t)npoint, turn, around));
    json_object_end(s->j);

done:
    return st;
}

// first and third axis: the second is their cross product
static status put_axes(scene *s, int npoint, const pose *shape)
{
    status st = OK;
    double *axis = NULL;
    TRY(TAKE(axis, 6 * (size_t)npoint));
    for (int i = 0; i < npoint; i++) {
        for (int d = 0; d < 3; d++) {
            axis[6 * i + d] = shape[i].R.a[d][0];
            axis[6 * i + 3 + d] = shape[i].R.a[d][2];
        }
    }
    TRY(put_signed(s, "axes", 6 * (size_t)npoint, axis, 1));

done:
    free(axis);
    return st;
}

// the slopes by what they are at the skin's radius
static status put_strain(scene *s, int npoint, const double (*strain)[3])
{
    status st = OK;
    double *at = NULL;
    TRY(TAKE(at, 3 * (size_t)npoint));
    for (int i = 0; i < npoint; i++) {
        at[3 * i] = strain[i][0];
        at[3 * i + 1] = strain[i][1] * s->skin;
        at[3 * i + 2] = strain[i][2] * s->skin;
    }
    const double most = largest_of(3 * (size_t)npoint, at);
    json_real(s->j, "strained", most);
    TRY(put_signed(s, "strain", 3 * (size_t)npoint, at, most));

done:
    free(at);
    return st;
}

static bool are_poses(int npoint, const pose *shape)
{
    bool all = npoint > 0;
    for (int i = 0; all && i < npoint; i++) {
        all = scene_are_numbers(3, shape[i].p.a) && scene_are_numbers(9, shape[i].R.a[0]);
    }
    return all;
}

status scene_rod(scene *s, scene_place at, int npoint, const pose *shape, const double (*strain)[3],
                 const char *name)
{
    status st = OK;
    double(*point)[3] = NULL;
    if (!are_poses(npoint, shape)) {
        return OK;
    }
    TRY(TAKE(point, (size_t)npoint));
    for (int i = 0; i < npoint; i++) {
        for (int d = 0; d < 3; d++) {
            point[i][d] = shape[i].p.a[d];
        }
    }
    scene_begin(s, "rod", at);
    json_text(s->j, "name", name);
    TRY(scene_put_places(s, "points", npoint, (const double(*)[3])point));
    TRY(put_axes(s, npoint, shape));
    TRY(put_strain(s, npoint, strain));
    json_object_end(s->j);

done:
    free(point);
    return st;
}

status scene_solid(scene *s, scene_place at, int nvertex, const double (*vertex)[3], int ntriangle,
                   const int (*triangle)[3], const unsigned char *ink, int nink,
                   const colour *colour)
{
    status st = OK;
    scene_begin(s, "solid", at);
    TRY(scene_put_places(s, "points", nvertex, vertex));
    TRY(scene_put_triangles(s, ntriangle, triangle));
    scene_put_colours(s, "colours", nink, colour);
    TRY(scene_put_bytes(s, "kinds", ink, (size_t)nvertex));
    json_object_end(s->j);

done:
    return st;
}

status scene_moved(scene *s, scene_place at, int nvertex, const double (*move)[3],
                   const double *value, const char *name)
{
    status st = OK;
    const size_t n = 3 * (size_t)nvertex;
    const double most = nvertex > 0 ? largest_of(n, move[0]) : 0;
    if (isnan(most)) {
        return OK;
    }
    scene_begin(s, "moved", at);
    json_text(s->j, "name", name);
    json_real(s->j, "most", 1e3 * most);
    TRY(put_signed(s, "moves", n, nvertex > 0 ? move[0] : NULL, most));
    TRY(scene_put_values(s, "values", nvertex, value));
    json_object_end(s->j);

done:
    return st;
}
