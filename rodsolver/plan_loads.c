// rodsolver/plan_loads.c
// Loads at the stations of a plan, seen from the frame of the solve.
#include "base/memory.h"
#include "rodsolver/rod_plan.h"

#include <math.h>

// a vector or place of the section seen from the stiffness-centre frame; NULL: as it is
static void turn_back(const centre_frame *f, double *x, double *y)
{
    if (f) {
        const double c = cos(f->phi), z = sin(f->phi), a = *x, b = *y;
        *x = c * a + z * b;
        *y = -z * a + c * b;
    }
}

static void see_place(const centre_frame *f, line_station *l)
{
    if (f) {
        l->x -= f->p[0];
        l->y -= f->p[1];
        turn_back(f, &l->x, &l->y);
    }
}

static line_station line_at(const line_load *load, double s, const centre_frame *f)
{
    line_station l = {.x = field_at(&load->place[0], s), .y = field_at(&load->place[1], s)};
    for (int c = 0; c < 3; c++) {
        l.force.a[c] = field_at(&load->force[c], s);
        l.moment.a[c] = field_at(&load->moment[c], s);
    }
    if (load->frame == LOAD_BODY) {
        turn_back(f, &l.force.a[0], &l.force.a[1]);
        turn_back(f, &l.moment.a[0], &l.moment.a[1]);
    }
    see_place(f, &l);
    return l;
}

static line_station gravity_at(const rod *r, double s, const centre_frame *f)
{
    double centre[2] = {0};
    const double mass = law_along_mass(r->law, s, centre);
    line_station l = {.x = centre[0], .y = centre[1]};
    for (int c = 0; c < 3; c++) {
        l.force.a[c] = mass * r->gravity[c];
    }
    see_place(f, &l);
    return l;
}

static bool line_is_finite(const line_station *l)
{
    double sum = l->x + l->y;
    for (int c = 0; c < 3; c++) {
        sum += l->force.a[c] + l->moment.a[c];
    }
    return isfinite(sum);
}

static status fill_line(const rod *r, int load, const plan *p, line_station *out)
{
    const line_load *l = load < r->nline_load ? &r->line_loads[load] : NULL;
    for (int i = 0; i < p->nstation; i++) {
        const centre_frame *f = p->frame ? &p->frame[i] : NULL;
        const double s = p->s[i];
        if (!l) {
            out[i] = gravity_at(r, s, f);
        } else if (s > l->from && s < l->to) {
            out[i] = line_at(l, s, f);
        }
        if (!line_is_finite(&out[i])) {
            return status_fail(ERR_INPUT, "rod: load '%s' is not finite at s = %g mm",
                               l && l->name ? l->name : "gravity", 1e3 * s);
        }
    }
    return OK;
}

static int nearest_panel(const plan *p, double s)
{
    // pairs begin and end where loads act, so that the nearest right end is the place itself
    int best = -1;
    double distance = fabs(s);
    for (int k = 0; k < p->npair; k++) {
        const double d = fabs(p->pair_edge[2 * k + 1] - s);
        if (d < distance) {
            best = 2 * k + 1;
            distance = d;
        }
    }
    return best;
}

static void fill_node_frames(const rod *r, plan *p)
{
    for (int k = 0; k <= 2 * p->npair; k++) {
        const double *edge = &p->pair_edge[2 * (k / 2 < p->npair ? k / 2 : p->npair - 1)];
        const double s = k == 2 * p->npair ? r->length : k % 2 ? (edge[0] + edge[1]) / 2 : edge[0];
        const int near = k == 2 * p->npair ? p->nstation - 1 : GAUSS_STATIONS * k;
        law_along_centre_frame(r->law, s, p->frame[near].phi, &p->node_frame[k]);
    }
}

status plan_fill_loads(const struct rod *r, plan *p)
{
    status st = OK;
    const int nline = r->nline_load + r->has_gravity;
    TRY(TAKE(p->line, (size_t)nline));
    TRY(TAKE(p->point_panel, (size_t)r->npoint_load));
    for (int i = 0; i < nline; i++) {
        TRY(TAKE(p->line[i], (size_t)p->nstation));
        TRY(fill_line(r, i, p, p->line[i]));
    }
    for (int i = 0; i < r->npoint_load; i++) {
        p->point_panel[i] = nearest_panel(p, r->point_loads[i].s);
    }
    if (p->frame) {
        TRY(TAKE(p->node_frame, 2 * (size_t)p->npair + 1));
        fill_node_frames(r, p);
    }

done:
    return st;
}
