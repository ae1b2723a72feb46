// rodsolver/rod_plan.c
#include "rodsolver/rod_plan.h"

#include "base/memory.h"

#include <math.h>

pose centre_frame_pose(const centre_frame *f)
{
    return (pose){.R = mat3_rot_z(f->phi), .p = {{f->p[0], f->p[1], 0}}};
}

// docs/theory.md (4.1): Ad(T^-1) xi* + (T^-1 T')^vee: in the stiffness-centre frame the rod is a
// curved backbone even where it is straight itself
static vec6 rest_in_frame(vec6 rest, const centre_frame *f)
{
    const double c = cos(f->phi), z = sin(f->phi), *w = rest.a + 3;
    const double vx = rest.a[0] - w[2] * f->p[1] + f->dp[0];
    const double vy = rest.a[1] + w[2] * f->p[0] + f->dp[1];
    return (vec6){{c * vx + z * vy, -z * vx + c * vy, rest.a[2] + w[0] * f->p[1] - w[1] * f->p[0],
                   c * w[0] + z * w[1], -z * w[0] + c * w[1], w[2] + f->dphi}};
}

void station_law(const struct rod *r, double s, const centre_frame *frame, mat6 *K, vec6 *rest)
{
    law_along_at(r->law, s, K, NULL);
    *rest = (vec6){{0, 0, 1, field_at(&r->rest.curvature_x, s), field_at(&r->rest.curvature_y, s),
                    field_at(&r->rest.twist, s)}};
    if (frame) {
        *K = beam_law_move(*K, frame->p[0], frame->p[1], frame->phi);
        *rest = rest_in_frame(*rest, frame);
    }
}

// the tendon seen from the stiffness-centre frame: R^T (r - p), differentiated
static tendon_place place_in_frame(tendon_place r, const centre_frame *f)
{
    const double c = cos(f->phi), z = sin(f->phi);
    const double x = r.x - f->p[0], y = r.y - f->p[1];
    const double dx = r.dx - f->dp[0], dy = r.dy - f->dp[1];
    const tendon_place q = {.x = c * x + z * y, .y = -z * x + c * y};
    return (tendon_place){
        .x = q.x,
        .y = q.y,
        .dx = c * dx + z * dy + f->dphi * q.y,
        .dy = -z * dx + c * dy - f->dphi * q.x,
    };
}

// pairs of panels in the stretch k so that the whole rod gets about npanel panels
static int pairs_in_stretch(const struct rod *r, int k, int npanel)
{
    const double share = (r->breaks[k + 1] - r->breaks[k]) / r->length;
    // a stretch that asks for 2.0000001 panels gets two
    const int npair = (int)ceil(share * npanel / 2 - 1e-6);
    return npair > 1 ? npair : 1;
}

static status take_arrays(const struct rod *r, plan *p)
{
    status st = OK;
    const size_t n = (size_t)p->nstation;
    TRY(TAKE(p->pair_edge, 2 * (size_t)p->npair));
    TRY(TAKE(p->s, n));
    TRY(TAKE(p->K, n));
    TRY(TAKE(p->K_row, 21 * n + ROW_PADDING));
    TRY(TAKE(p->rest, 6 * n + ROW_PADDING));
    TRY(TAKE(p->tendon, (size_t)r->ntendon));
    if (r->options.frame == FRAME_NC) {
        TRY(TAKE(p->frame, n));
        TRY(TAKE(p->turn, 4 * n + ROW_PADDING));
    }

done:
    return st;
}

static void lay_stations(const struct rod *r, int npanel, plan *p)
{
    int pair = 0, station = 0;
    for (int k = 0; k + 1 < r->nbreak; k++) {
        const int npair = pairs_in_stretch(r, k, npanel);
        const double a = r->breaks[k], step = (r->breaks[k + 1] - a) / npair;
        for (int j = 0; j < npair; j++, pair++) {
            const double left = a + j * step;
            p->pair_edge[2 * pair] = left;
            p->pair_edge[2 * pair + 1] = j + 1 == npair ? r->breaks[k + 1] : a + (j + 1) * step;
            for (int i = 0; i < PAIR_STATIONS; i++, station++) {
                const double t = gauss_point[i % GAUSS_STATIONS] + i / GAUSS_STATIONS;
                p->s[station] = left + step / 2 * t;
            }
        }
    }
}

// what lanes read
static void store_law(plan *p, size_t i)
{
    const size_t n = (size_t)p->nstation;
    size_t entry = 0;
    for (int j = 0; j < 6; j++) {
        for (int k = 0; k <= j; k++) {
            p->K_row[entry++ * n + i] = p->K[i].a[j][k];
        }
    }
    if (p->frame) {
        const centre_frame *f = &p->frame[i];
        p->turn[i] = cos(f->phi);
        p->turn[n + i] = sin(f->phi);
        p->turn[2 * n + i] = f->p[0];
        p->turn[3 * n + i] = f->p[1];
    }
}

static status fill_laws(const struct rod *r, plan *p)
{
    const size_t n = (size_t)p->nstation;
    double phi = r->law->turn[0];
    for (size_t i = 0; i < n; i++) {
        centre_frame *frame = NULL;
        if (p->frame) {
            frame = &p->frame[i];
            law_along_centre_frame(r->law, p->s[i], phi, frame);
            phi = frame->phi;
        }
        vec6 rest;
        station_law(r, p->s[i], frame, &p->K[i], &rest);
        store_law(p, i);
        for (size_t c = 0; c < 6; c++) {
            if (!isfinite(rest.a[c])) {
                return status_fail(ERR_INPUT, "rod: the shape at rest is not finite at s = %g mm",
                                   1e3 * p->s[i]);
            }
            p->rest[c * n + i] = rest.a[c];
        }
    }
    return OK;
}

vec6 station_gather(const double *rows, int n, int i)
{
    vec6 x;
    for (int c = 0; c < 6; c++) {
        x.a[c] = rows[(size_t)c * (size_t)n + (size_t)i];
    }
    return x;
}

static void store_secular(const secular_station *s, size_t n, size_t i, double *row)
{
    for (size_t j = 0; j < 3; j++) {
        row[(ROW_M + j) * n + i] = s->m[j];
        row[(ROW_B + j) * n + i] = s->b[j];
        for (size_t c = 0; c < 6; c++) {
            row[(ROW_G + 3 * c + j) * n + i] = s->G[c][j];
        }
    }
}

static void fill_secular(const plan *p, const mat6 *F, int i, plan_tendon *t)
{
    const vec6 rest = station_gather(p->rest, p->nstation, i);
    secular_station station;
    secular_prepare(F, &rest, &t->place[i], &station);
    store_secular(&station, (size_t)t->nstation, (size_t)i, t->row);
    const double critical = secular_critical(&station);
    if (critical < t->critical) {
        t->critical = critical;
        t->critical_at = p->s[i];
    }
}

static status fill_tendon(const tendon_spec *spec, const spline *table, const plan *p,
                          const mat6 *F, plan_tendon *t)
{
    status st = OK;
    routing path = {0};
    while (t->nstation < p->nstation && p->s[t->nstation] < spec->end) {
        t->nstation++;
    }
    const size_t n = (size_t)t->nstation;
    TRY(TAKE(t->place, n));
    TRY(TAKE(t->place_row, 4 * n + ROW_PADDING));
    TRY(TAKE(t->row, SECULAR_ROWS * n + ROW_PADDING));
    t->critical = HUGE_VAL;
    for (int i = 0; i < t->nstation; i++) {
        if (i % PAIR_STATIONS == 0) {
            const double *edge = &p->pair_edge[2 * (i / PAIR_STATIONS)];
            routing_make(spec, table, edge[0], edge[1], &path);
        }
        t->place[i] = routing_at(&path, p->s[i]);
        if (p->frame) {
            t->place[i] = place_in_frame(t->place[i], &p->frame[i]);
        }
        const tendon_place *q = &t->place[i];
        if (!isfinite(q->x) || !isfinite(q->y) || !isfinite(q->dx) || !isfinite(q->dy)) {
            TRY(status_fail(ERR_INPUT, "rod: tendon '%s' has no finite place at s = %g mm",
                            spec->name ? spec->name : "?", 1e3 * p->s[i]));
        }
        const double coordinate[4] = {q->x, q->y, q->dx, q->dy};
        for (size_t j = 0; j < 4; j++) {
            t->place_row[j * n + (size_t)i] = coordinate[j];
        }
        fill_secular(p, &F[i], i, t);
    }

done:
    return st;
}

// the same law, rest and places at all stations of a pair, to the last bits of the interpolation
static bool same_as_first(const struct rod *r, const plan *p, int i)
{
    const double rounding = 1e-14;
    const int first = i - i % PAIR_STATIONS;
    for (int c = 0; c < 36; c++) {
        const int j = c / 6, k = c % 6;
        const double scale = sqrt(p->K[first].a[j][j] * p->K[first].a[k][k]);
        if (!(fabs(p->K[i].a[j][k] - p->K[first].a[j][k]) <= rounding * scale)) {
            return false;
        }
    }
    const vec6 rest = station_gather(p->rest, p->nstation, i),
               wanted = station_gather(p->rest, p->nstation, first);
    for (int c = 0; c < 6; c++) {
        if (rest.a[c] != wanted.a[c]) {
            return false;
        }
    }
    for (int t = 0; t < r->ntendon; t++) {
        const tendon_place *q = &p->tendon[t].place[i], *q0 = &p->tendon[t].place[first];
        if (i < p->tendon[t].nstation &&
            (q->x != q0->x || q->y != q0->y || q->dx != q0->dx || q->dy != q0->dy)) {
            return false;
        }
    }
    return true;
}

static status invert_laws(const plan *p, mat6 **F)
{
    status st = OK;
    TRY(TAKE(*F, (size_t)p->nstation));
    for (int i = 0; i < p->nstation; i++) {
        if (!mat6_inverse_spd(p->K[i], &(*F)[i])) {
            TRY(status_fail(
                ERR_NUMERIC,
                "rod: the stiffness of the section at s = %g mm is not positive definite",
                1e3 * p->s[i]));
        }
    }

done:
    return st;
}

static bool is_uniform(const struct rod *r, const plan *p)
{
    for (int i = 0; i < p->nstation; i++) {
        if (!same_as_first(r, p, i)) {
            return false;
        }
    }
    return true;
}

status plan_make(const struct rod *r, int npanel, plan *out)
{
    status st = OK;
    plan p = {0};
    mat6 *F = NULL; // K^-1
    for (int k = 0; k + 1 < r->nbreak; k++) {
        p.npair += pairs_in_stretch(r, k, npanel);
    }
    p.nstation = PAIR_STATIONS * p.npair;
    TRY(take_arrays(r, &p));
    lay_stations(r, npanel, &p);
    TRY(fill_laws(r, &p));
    TRY(invert_laws(&p, &F));
    for (int i = 0; i < r->ntendon; i++) {
        TRY(fill_tendon(&r->spec[i], &r->path[i], &p, F, &p.tendon[i]));
    }
    TRY(plan_fill_loads(r, &p));
    p.uniform = is_uniform(r, &p);
    *out = p; // ownership passes only when all is well
    p = (plan){0};

done:
    free(F);
    plan_free(&p, r);
    return st;
}

void plan_free(plan *p, const struct rod *r)
{
    for (int i = 0; p->tendon && i < r->ntendon; i++) {
        free(p->tendon[i].place);
        free(p->tendon[i].place_row);
        free(p->tendon[i].row);
    }
    for (int i = 0; p->line && i < r->nline_load + r->has_gravity; i++) {
        free(p->line[i]);
    }
    free(p->pair_edge);
    free(p->s);
    free(p->K);
    free(p->K_row);
    free(p->rest);
    free(p->frame);
    free(p->turn);
    free(p->node_frame);
    free(p->tendon);
    free(p->line);
    free(p->point_panel);
    *p = (plan){0};
}

int plan_pair_at(const plan *p, double s)
{
    int low = 0, high = p->npair;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (s < p->pair_edge[2 * middle]) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return low;
}
