// rodsolver/rod_plan.c
#include "rodsolver/rod_plan.h"

#include "base/memory.h"

#include <math.h>

pose centre_frame_pose(const centre_frame *f)
{
    return (pose){.R = mat3_rot_z(f->phi), .p = {{f->p[0], f->p[1], 0}}};
}

// docs/theory.md (4.1): in the stiffness-centre frame the rod is a precurved backbone
void station_law(const struct rod *r, double s, const centre_frame *frame, mat6 *K, vec6 *rest)
{
    law_along_at(r->law, s, K, NULL);
    *rest = (vec6){{0, 0, 1, 0, 0, 0}};
    if (frame) {
        const double c = cos(frame->phi), z = sin(frame->phi);
        *K = beam_law_move(*K, frame->p[0], frame->p[1], frame->phi);
        rest->a[0] = c * frame->dp[0] + z * frame->dp[1];
        rest->a[1] = -z * frame->dp[0] + c * frame->dp[1];
        rest->a[5] = frame->dphi;
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
    TRY(TAKE(p->rest, 6 * n));
    TRY(TAKE(p->tendon, (size_t)r->ntendon));
    if (r->options.frame == FRAME_NC) {
        TRY(TAKE(p->frame, n));
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

static void fill_laws(const struct rod *r, plan *p)
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
        for (size_t c = 0; c < 6; c++) {
            p->rest[c * n + i] = rest.a[c];
        }
    }
}

static vec6 rest_at(const plan *p, int station)
{
    vec6 rest;
    for (int c = 0; c < 6; c++) {
        rest.a[c] = p->rest[(size_t)c * (size_t)p->nstation + (size_t)station];
    }
    return rest;
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

static status fill_tendon(const tendon_spec *spec, const plan *p, plan_tendon *t)
{
    status st = OK;
    routing path = {0};
    while (t->nstation < p->nstation && p->s[t->nstation] < spec->end) {
        t->nstation++;
    }
    const size_t n = (size_t)t->nstation;
    TRY(TAKE(t->place, n));
    TRY(TAKE(t->row, SECULAR_ROWS * n));
    t->critical = HUGE_VAL;
    for (int i = 0; i < t->nstation; i++) {
        if (i % PAIR_STATIONS == 0) {
            const double *edge = &p->pair_edge[2 * (i / PAIR_STATIONS)];
            routing_make(spec, edge[0], edge[1], &path);
        }
        t->place[i] = routing_at(&path, p->s[i]);
        if (p->frame) {
            t->place[i] = place_in_frame(t->place[i], &p->frame[i]);
        }
        const tendon_place *q = &t->place[i];
        if (!isfinite(q->x) || !isfinite(q->y) || !isfinite(q->dx) || !isfinite(q->dy)) {
            TRY(status_fail(ERR_INPUT, "rod: tendon '%s' has no finite place at s = %g m",
                            spec->name ? spec->name : "?", p->s[i]));
        }
        const vec6 rest = rest_at(p, i);
        secular_station station;
        TRY(secular_prepare(&p->K[i], &rest, &t->place[i], &station));
        store_secular(&station, n, (size_t)i, t->row);
        const double critical = secular_critical(&station);
        if (critical < t->critical) {
            t->critical = critical;
            t->critical_at = p->s[i];
        }
    }

done:
    return st;
}

status plan_make(const struct rod *r, int npanel, plan *out)
{
    status st = OK;
    plan p = {0};
    for (int k = 0; k + 1 < r->nbreak; k++) {
        p.npair += pairs_in_stretch(r, k, npanel);
    }
    p.nstation = PAIR_STATIONS * p.npair;
    TRY(take_arrays(r, &p));
    lay_stations(r, npanel, &p);
    fill_laws(r, &p);
    for (int i = 0; i < r->ntendon; i++) {
        TRY(fill_tendon(&r->spec[i], &p, &p.tendon[i]));
    }
    *out = p; // ownership passes only when all is well
    p = (plan){0};

done:
    plan_free(&p, r->ntendon);
    return st;
}

void plan_free(plan *p, int ntendon)
{
    for (int i = 0; p->tendon && i < ntendon; i++) {
        free(p->tendon[i].place);
        free(p->tendon[i].row);
    }
    free(p->pair_edge);
    free(p->s);
    free(p->K);
    free(p->rest);
    free(p->frame);
    free(p->tendon);
    *p = (plan){0};
}
