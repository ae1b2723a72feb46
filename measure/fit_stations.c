// measure/fit_stations.c
// Where measured lines are looked at, and where the model is there.
#include "base/memory.h"
#include "measure/fit_inside.h"

#include <math.h>
#include <string.h>

// --- stations of the measured lines

static double span(const centreline *c)
{
    return c->s[c->count - 1] - c->s[0];
}

// as dense as the line itself, up to a limit
static double own_step(const centreline *c)
{
    const int n = c->count < FIT_MOST_STATIONS ? c->count : FIT_MOST_STATIONS;
    return span(c) / (n - 1);
}

// One step for all lines: what goes together along them is counted in steps.
static double common_step(const fit_problem *p)
{
    double step = 0;
    for (int k = 0; k < p->nshape; k++) {
        step = fmax(step, own_step(p->shape[k].line));
    }
    return step;
}

static int nearest(const centreline *c, double s, int from)
{
    int i = from;
    while (i + 1 < c->count && fabs(c->s[i + 1] - s) <= fabs(c->s[i] - s)) {
        i++;
    }
    return i;
}

// the line's direction at a station, over a stretch that noise does not turn
static const double direction_share = 0.04;

static vec3 chord(const centreline *c, double s)
{
    const double half = direction_share * span(c);
    const double a = fmax(s - half, c->s[0]), b = fmin(s + half, c->s[c->count - 1]);
    return vec3_sub(centreline_at(c, b), centreline_at(c, a));
}

void fit_set_across(fit_station *t, vec3 d)
{
    d = vec3_scale(1 / vec3_norm(d), d);
    const int thin = fabs(d.a[0]) < 0.7 ? 0 : 1;
    vec3 other = {{0}};
    other.a[thin] = 1;
    vec3 n = vec3_add_scaled(other, -vec3_dot(other, d), d);
    n = vec3_scale(1 / vec3_norm(n), n);
    t->across[0] = n;
    t->across[1] = vec3_cross(d, n);
}

// what moves a whole scan at once is an unknown of its own unless the base is held
static double sigma_of(const fit *f, const centreline *c, int i)
{
    return f->problem->base == FIT_BASE_FIXED ? c->sigma[i] : centreline_own_sigma(c, i);
}

static bool tells_sigma(const fit *f, const centreline *c)
{
    bool all = true;
    for (int i = 0; i < c->count; i++) {
        all = all && sigma_of(f, c, i) > 0;
    }
    return all;
}

static void add_shape(fit *f, int shape)
{
    const centreline *c = f->problem->shape[shape].line;
    const bool told = tells_sigma(f, c);
    const int n = 1 + (int)(span(c) / f->step + 0.5);
    int last = -1;
    for (int k = 0; k < n && f->nall < f->problem->nshape * FIT_MOST_STATIONS; k++) {
        const int i = nearest(c, c->s[0] + k * f->step, last < 0 ? 0 : last);
        if (i == last) {
            continue; // a gap in the line
        }
        last = i;
        fit_station *t = &f->all[f->nall++];
        *t = (fit_station){.shape = shape, .s = c->s[i], .at = c->p[i]};
        t->sigma = told ? sigma_of(f, c, i) : NAN;
        fit_set_across(t, chord(c, t->s));
    }
}

void fit_use(fit *f, int stride)
{
    int shape = -1, k = 0;
    f->nuse = 0;
    for (int i = 0; i < f->nall; i++) {
        const bool first = f->all[i].shape != shape;
        k = first ? 0 : k + 1;
        shape = f->all[i].shape;
        if (k % stride == 0) {
            f->all[i].first = first;
            f->use[f->nuse++] = i;
        }
    }
}

static void set_scales(fit *f)
{
    for (int i = 0; i < f->problem->nunknown; i++) {
        const fit_unknown *u = &f->problem->unknown[i];
        const bool bounded = isfinite(u->lower) && isfinite(u->upper);
        const double own = u->start != 0 ? fabs(u->start) : 1;
        f->scale[i] = bounded ? u->upper - u->lower : own;
        f->x[i] = u->start;
        f->free[i] = i;
    }
    f->nfree = f->problem->nunknown;
}

static status check(const fit_problem *p)
{
    for (int k = 0; k < p->nshape; k++) {
        const centreline *c = p->shape[k].line;
        if (c->count < 4 || !(span(c) > 0)) {
            return status_fail(ERR_INPUT, "the shape '%.60s' has %d points: too few to fit to",
                               p->shape[k].name, c->count);
        }
    }
    return OK;
}

status fit_make(const fit_problem *problem, fit *out)
{
    status st = OK;
    fit f = {.problem = problem, .sigma = 1e-4};
    const size_t n = (size_t)problem->nunknown, k = (size_t)problem->nshape;
    TRY(check(problem));
    TRY(gsl_fit_door_open(&f.door));
    TRY(TAKE(f.all, k * FIT_MOST_STATIONS));
    TRY(TAKE(f.use, k * FIT_MOST_STATIONS));
    TRY(TAKE(f.scale, n));
    TRY(TAKE(f.x, n));
    TRY(TAKE(f.at, n));
    TRY(TAKE(f.free, n));
    TRY(TAKE(f.p, k * FIT_POINTS));
    TRY(TAKE(f.tip, k));
    f.step = common_step(problem);
    for (int i = 0; i < problem->nshape; i++) {
        add_shape(&f, i);
        const double told = problem->shape[i].line->correlation_length;
        if (told > f.length) {
            f.length = told;
            f.length_from = FIT_BY_LINE;
        }
    }
    TRY(TAKE(f.q, (size_t)f.nall));
    TRY(TAKE(f.slope, (size_t)f.nall));
    TRY(TAKE(f.dq, n * (size_t)f.nall));
    f.nbase = problem->base == FIT_BASE_FIXED    ? 0
              : problem->base == FIT_BASE_COMMON ? 1
                                                 : problem->nshape;
    set_scales(&f);
    fit_use(&f, 1);
    *out = f;
    f = (fit){0};

done:
    fit_free(&f);
    return st;
}

void fit_free(fit *f)
{
    free(f->all);
    free(f->use);
    free(f->scale);
    free(f->x);
    free(f->at);
    free(f->free);
    free(f->p);
    free(f->tip);
    free(f->q);
    free(f->slope);
    free(f->dq);
    *f = (fit){0};
}

// --- the model at the stations

typedef struct model {
    double h;      // between its points, of the unloaded rod [m]
    const vec3 *p; // [FIT_POINTS]
    vec3 slope[FIT_POINTS];
    double along[FIT_POINTS]; // arclength as it lies
} model;

// fourth order, at the ends too
static vec3 slope_at(const vec3 *p, double h, int i)
{
    static const double weights[3][5] = {
        {-25, 48, -36, 16, -3}, {-3, -10, 18, -6, 1}, {1, -8, 0, 8, -1}};
    const int last = FIT_POINTS - 1;
    const bool right = i > last - 2;
    const int row = right ? last - i : i < 2 ? i : 2;
    vec3 sum = {{0}};
    for (int k = 0; k < 5; k++) {
        const int j = row == 2 ? i - 2 + k : right ? last - k : k;
        sum = vec3_add_scaled(sum, (right && row < 2 ? -1 : 1) * weights[row][k] / (12 * h), p[j]);
    }
    return sum;
}

// the line as it lies: Simpson's rule, the slope in the middle that of Hermite's cubic
static void measure_model(const vec3 *p, double length, model *m)
{
    m->h = length / (FIT_POINTS - 1);
    m->p = p;
    for (int i = 0; i < FIT_POINTS; i++) {
        m->slope[i] = slope_at(p, m->h, i);
    }
    m->along[0] = 0;
    for (int i = 0; i + 1 < FIT_POINTS; i++) {
        vec3 middle = vec3_scale(1.5 / m->h, vec3_sub(p[i + 1], p[i]));
        middle = vec3_add_scaled(middle, -0.25, vec3_add(m->slope[i], m->slope[i + 1]));
        m->along[i + 1] = m->along[i] + m->h / 6 *
                                            (vec3_norm(m->slope[i]) + 4 * vec3_norm(middle) +
                                             vec3_norm(m->slope[i + 1]));
    }
}

// Hermite's cubic; beyond the ends straight on
static vec3 place_at(const model *m, double s)
{
    const int last = FIT_POINTS - 1;
    const double u = s / m->h;
    if (u < 0 || u > last) {
        const int end = u < 0 ? 0 : last;
        return vec3_add_scaled(m->p[end], s - end * m->h, m->slope[end]);
    }
    const int i = (int)u < last ? (int)u : last - 1;
    const double t = u - i;
    vec3 p = vec3_scale((1 + 2 * t) * (1 - t) * (1 - t), m->p[i]);
    p = vec3_add_scaled(p, t * t * (3 - 2 * t), m->p[i + 1]);
    p = vec3_add_scaled(p, m->h * t * (1 - t) * (1 - t), m->slope[i]);
    return vec3_add_scaled(p, m->h * t * t * (t - 1), m->slope[i + 1]);
}

// the unloaded rod's arclength where the loaded one is `along` long; *panel goes on from the last
static double unloaded(const model *m, double along, int *panel)
{
    const int last = FIT_POINTS - 1;
    while (*panel + 2 <= last && m->along[*panel + 1] < along) {
        (*panel)++;
    }
    const int i = *panel;
    const double part = (along - m->along[i]) / (m->along[i + 1] - m->along[i]);
    return m->h * (i + part);
}

status fit_places(fit *f, const double *x, vec3 *q)
{
    status st = OK;
    double length = 0;
    model m;
    const fit_problem *problem = f->problem;
    f->nsolve++;
    TRY(problem->lines(problem->context, x, f->p, &length));
    int shape = -1, panel = 0;
    double scale = 1;
    for (int i = 0; i < f->nall; i++) {
        const fit_station *t = &f->all[i];
        const fit_shape *own = &problem->shape[t->shape];
        if (t->shape != shape) {
            shape = t->shape;
            panel = 0;
            measure_model(f->p + (size_t)shape * FIT_POINTS, length, &m);
            f->tip[shape] = m.p[FIT_POINTS - 1];
            const double end = own->rest ? length : m.along[FIT_POINTS - 1];
            // tip to tip where both ends are known
            scale = own->to_tip ? end / own->line->s[own->line->count - 1] : 1;
        }
        const double s = scale * t->s;
        const double at = own->rest ? s : unloaded(&m, s, &panel);
        q[i] = place_at(&m, at);
        const int near = (int)fmin(fmax(at / m.h + 0.5, 0), FIT_POINTS - 1);
        f->slope[i] = m.slope[near];
    }

done:
    return st;
}
