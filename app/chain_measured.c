// app/chain_measured.c
// The rod's solutions against the shapes that were measured of them.
#include "app/chain.h"
#include "app/measured_case.h"
#include "app/warnings.h"
#include "base/memory.h"
#include "reports/measured_show.h"

#include <math.h>
#include <string.h>

// of the rod's length: what a parabola takes for one curvature, wide enough that a scanner's noise
// of 0.05 mm leaves 1 per metre on a rod of 120 mm
#define BEND_WINDOW 0.2

// A solution's centreline in the frame of its base, docs/theory.md (9.50).
typedef struct own_line {
    vec3 *p, *slope;
    double *along;
    model_line line;
} own_line;

static void own_line_free(own_line *m)
{
    free(m->p);
    free(m->slope);
    free(m->along);
}

static status own_line_make(const rod_result *rod, const struct rod_run *run, own_line *m)
{
    status st = OK;
    const pose *base = &run->shape[0];
    const size_t n = (size_t)rod->npoint;
    TRY(TAKE(m->p, n));
    TRY(TAKE(m->slope, n));
    TRY(TAKE(m->along, n));
    for (size_t i = 0; i < n; i++) {
        const vec3 v = {{run->stretch[i][0], run->stretch[i][1], 1 + run->stretch[i][2]}};
        m->p[i] = mat3_tmul_vec(base->R, vec3_sub(run->shape[i].p, base->p));
        m->slope[i] = mat3_tmul_vec(base->R, mat3_mul_vec(run->shape[i].R, v));
    }
    m->line = (model_line){rod->npoint, run->s, m->p, m->slope, m->along};
    model_line_lengths(&m->line, m->along);

done:
    return st;
}

// of the section at s, in the frame of the base
static mat3 turn_at(const rod_result *rod, const struct rod_run *run, double s)
{
    int i = 0;
    while (i + 2 < rod->npoint && run->s[i + 1] <= s) {
        i++;
    }
    const double part = (s - run->s[i]) / (run->s[i + 1] - run->s[i]);
    const mat3 a = run->shape[i].R, step = mat3_mul(mat3_transpose(a), run->shape[i + 1].R);
    const mat3 R = mat3_mul(a, so3_exp(vec3_scale(part, so3_log(step))));
    return mat3_mul(mat3_transpose(run->shape[0].R), R);
}

static status fill_points(const rod_result *rod, const own_line *m, const centreline *matched,
                          double window, measured_line *out)
{
    status st = OK;
    const struct rod_run *run = &rod->run[out->solution];
    const size_t n = (size_t)matched->count;
    TRY(measured_line_room(out, matched->count));
    memcpy(out->s, matched->s, n * sizeof *out->s);
    memcpy(out->sigma, matched->sigma, n * sizeof *out->sigma);
    memcpy(out->p, matched->p, n * sizeof *out->p);
    centreline_bend(matched, window, out->bend, out->bend_sigma);
    for (size_t i = 0; i < n; i++) {
        out->model[i] = model_line_at(&m->line, matched->s[i]);
        out->bend[i] = mat3_tmul_vec(turn_at(rod, run, matched->s[i]), out->bend[i]);
    }

done:
    return st;
}

static void name_line(const rod_result *rod, const measured_shape *shape, measured_line *out)
{
    // with its folder: `scan` calls all its files alike
    const char *file = shape->csv.text, *at = strrchr(file, '/');
    while (at > file && at[-1] != '/') {
        at--;
    }
    (void)snprintf(out->file, sizeof out->file, "%s", at ? at : file);
    if (shape->name) {
        (void)snprintf(out->name, sizeof out->name, "%s", shape->name);
    } else {
        (void)snprintf(out->name, sizeof out->name, "solution %d of %d", shape->index + 1,
                       rod->nsolution);
    }
}

// --- another solution that the line was perhaps measured of

// A mistaken pair lies centimetres off; a model that misses, or close tensions, by less than this.
#define FAR_OFF 0.02 // of the rod's length, rms
#define FAR_NEARER 5

// rms distance at the line's stations [m]; INFINITY where the two have nothing in common
static status distance_from(const rod_result *rod, int solution, const measured_shape *shape,
                            const shape_way *way, double *rms)
{
    status st = OK;
    own_line m = {0};
    centreline matched = {0};
    double longer = 0, squares = 0;
    bool tip = false;
    int n = 0;
    TRY(own_line_make(rod, &rod->run[solution], &m));
    TRY(shape_match(&m.line, &shape->line, way, &matched, &tip, &longer));
    for (int i = 0; i < matched.count && matched.s[i] <= m.line.s[m.line.count - 1]; i++) {
        const vec3 d = vec3_sub(model_line_at(&m.line, matched.s[i]), matched.p[i]);
        squares += vec3_dot(d, d);
        n++;
    }
    *rms = n > 0 ? sqrt(squares / n) : INFINITY;

done:
    centreline_free(&matched);
    own_line_free(&m);
    return st;
}

// a line of a free turn may lie near to anything that is as bent
static status find_better(const rod_result *rod, double length, const measured_shape *shape,
                          const shape_way *way, measured_line *line)
{
    status st = OK;
    double own = 0, best = INFINITY, other = 0;
    line->better = -1;
    line->better_rms = NAN;
    if (line->turn_free || line->error.rms < FAR_OFF * length) {
        return OK;
    }
    TRY(distance_from(rod, line->solution, shape, way, &own));
    for (int i = 0; i < rod->nsolution; i++) {
        TRY(distance_from(rod, i, shape, way, &other));
        if (other < best && FAR_NEARER * other < own) {
            best = other;
            line->better = i;
            line->better_rms = other;
        }
    }

done:
    return st;
}

static void without_uncertainty(shape_error *e)
{
    e->tip_sigma = e->tip_angle_sigma = e->shape_sigma = NAN;
}

static status compare_shape(const rod_result *rod, const measured_case *given,
                            const measured_shape *shape, double length, measured_line *out)
{
    status st = OK;
    own_line m = {0};
    centreline matched = {0};
    double longer = 0;
    const shape_way way = {given->arclength, shape->tip};
    out->solution = shape->index;
    name_line(rod, shape, out);
    TRY(own_line_make(rod, &rod->run[shape->index], &m));
    TRY(shape_match(&m.line, &shape->line, &way, &matched, &out->tip, &longer));
    TRY(shape_error_find(&m.line, &matched, out->tip, &out->error));
    out->error.longer = longer;
    out->turn_free = shape->line.turn_free;
    if (out->turn_free) {
        without_uncertainty(&out->error);
    }
    TRY(find_better(rod, length, shape, &way, out));
    TRY(fill_points(rod, &m, &matched, BEND_WINDOW * length, out));

done:
    centreline_free(&matched);
    own_line_free(&m);
    return st;
}

static void warn_line(const command *cmd, const case_data *c, mark at, const run_result *r,
                      const measured_line *line)
{
    char words[MEASURED_NOTES];
    measured_line_notes(r, line, words, sizeof words);
    if (words[0]) {
        warn_at(cmd, c, at, "%s: %s", line->name, words);
    }
}

status chain_measured(const command *cmd, const case_data *c, run_result *out)
{
    status st = OK;
    const measured_case *given = &c->file.measured;
    const measured_shape *shape = given->shapes.items;
    measured_result *m = &out->measured;
    m->synthetic = given->synthetic;
    m->paper = given->paper;
    m->arclength = given->arclength;
    m->tolerance = given->tolerance;
    m->window = BEND_WINDOW * out->rod_length;
    (void)snprintf(m->source, sizeof m->source, "%s", given->source ? given->source : "");
    TRY(TAKE(m->line, (size_t)given->shapes.count));
    for (int i = 0; i < given->shapes.count; i++) {
        m->nline = i + 1;
        st = compare_shape(&out->rod, given, &shape[i], out->rod_length, &m->line[i]);
        TRY(case_place(c, st, shape[i].at));
        warn_line(cmd, c, shape[i].at, out, &m->line[i]);
    }
    out->has_measured = true;

done:
    return st;
}
