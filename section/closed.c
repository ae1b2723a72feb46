// section/closed.c
#include "base/memory.h"
#include "section/integrals.h"
#include "section/section.h"

#include <math.h>

static const double two_pi = 6.28318530717958647693;

// centres nearer than this part of the size are one
static const double concentric_tolerance = 1e-12;

static bool is_round(const outline *o)
{
    return o->kind == KIND_ANNULUS || o->kind == KIND_SECTOR || o->kind == KIND_DISC;
}

static bool is_concentric(const section_outline *o)
{
    for (int i = 0; i < o->count; i++) {
        const double dx = o->items[i].centre[0] - o->items[0].centre[0];
        const double dy = o->items[i].centre[1] - o->items[0].centre[1];
        if (!is_round(&o->items[i]) || !(hypot(dx, dy) <= concentric_tolerance * o->size)) {
            return false;
        }
    }
    return o->count > 0;
}

// one modulus per shape, without directions
static bool is_uniform(const section_outline *o, const material *materials)
{
    for (int i = 0; i < o->count; i++) {
        const material *m = o->items[i].material >= 0 ? &materials[o->items[i].material] : NULL;
        if (m && (m->kind != MATERIAL_ISOTROPIC || material_is_graded(m))) {
            return false;
        }
    }
    return true;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// The polar grid on whose cells the material is constant: radii in order, and angles in order over
// one turn. Without angles the one cell is the whole ring.
typedef struct polar_grid {
    int nradius, nangle;
    double *radius; // [2 count]
    double *angle;  // [2 count + 1], the first once more after a turn
} polar_grid;

static void polar_grid_free(polar_grid *g)
{
    free(g->radius);
    free(g->angle);
    *g = (polar_grid){0};
}

static status polar_grid_make(const section_outline *o, polar_grid *g)
{
    status st = OK;
    TRY(TAKE(g->radius, 2 * (size_t)o->count));
    TRY(TAKE(g->angle, 2 * (size_t)o->count + 1));
    for (int i = 0; i < o->count; i++) {
        const outline *s = &o->items[i];
        g->radius[g->nradius++] = s->kind == KIND_DISC ? 0 : s->inner;
        g->radius[g->nradius++] = s->outer;
        for (int side = -1; s->kind == KIND_SECTOR && side <= 1; side += 2) {
            const double edge = s->mid_angle + side * s->width / 2;
            g->angle[g->nangle++] = edge - two_pi * floor(edge / two_pi);
        }
    }
    qsort(g->radius, (size_t)g->nradius, sizeof *g->radius, by_size);
    qsort(g->angle, (size_t)g->nangle, sizeof *g->angle, by_size);
    g->angle[g->nangle] = g->angle[0] + two_pi;

done:
    return st;
}

static bool covers(const outline *s, double r, double angle)
{
    const double inner = s->kind == KIND_DISC ? 0 : s->inner;
    if (r < inner || r > s->outer) {
        return false;
    }
    return s->kind != KIND_SECTOR || fabs(remainder(angle - s->mid_angle, two_pi)) <= s->width / 2;
}

// the last shape that covers the place; -1 for none
static int ring_material_at(const section_outline *o, double r, double angle)
{
    for (int i = o->count - 1; i >= 0; i--) {
        if (covers(&o->items[i], r, angle)) {
            return o->items[i].material;
        }
    }
    return -1;
}

// Radii a to b, angles mid -+ half: int r dr dth and so on, exact. A whole ring has no first
// moments.
static moments cell_moments(double a, double b, double mid, double half, bool ring)
{
    const double r1 = (b * b - a * a) / 2, r2 = (b * b * b - a * a * a) / 3;
    const double r3 = (b * b * b * b - a * a * a * a) / 4;
    const double s1 = ring ? 0 : 2 * sin(half), s2 = ring ? 0 : sin(2 * half);
    return (moments){
        .one = r1 * 2 * half,
        .x = r2 * s1 * cos(mid),
        .y = r2 * s1 * sin(mid),
        .xx = r3 * (half + s2 * cos(2 * mid) / 2),
        .yy = r3 * (half - s2 * cos(2 * mid) / 2),
        .xy = r3 * s2 * sin(2 * mid) / 2,
    };
}

status section_classical_closed(const section_outline *o, const material *materials, beam_law *out,
                                bool *done_here)
{
    status st = OK;
    polar_grid g = {0};
    *done_here = is_concentric(o) && is_uniform(o, materials);
    if (!*done_here) {
        return OK;
    }
    TRY(polar_grid_make(o, &g));

    section_integrals sum = {.centre = {o->items[0].centre[0], o->items[0].centre[1]}};
    const bool ring = g.nangle == 0;
    for (int i = 0; i + 1 < g.nradius; i++) {
        for (int k = 0; k < (ring ? 1 : g.nangle); k++) {
            const double a = g.radius[i], b = g.radius[i + 1];
            const double mid = ring ? 0 : (g.angle[k] + g.angle[k + 1]) / 2;
            const double half = (ring ? two_pi : g.angle[k + 1] - g.angle[k]) / 2;
            const int index = ring_material_at(o, (a + b) / 2, mid);
            if (index >= 0 && b > a && half > 0) {
                const moments piece = cell_moments(a, b, mid, half, ring);
                const rod_moduli moduli = rod_moduli_of(&materials[index], NULL);
                integrals_add(&sum, &piece, &moduli, 1);
            }
        }
    }
    TRY(integrals_law(&sum, out));

done:
    polar_grid_free(&g);
    return st;
}

// docs/theory.md (2.6)
annulus_closed_form annulus_closed(const annulus_two_materials *a)
{
    const double ro = a->outer, ri = a->inner, th = a->width;
    const double rest = two_pi - th, jump = a->E_stiff - a->E_soft;
    const double weight = a->E_stiff * th + a->E_soft * rest;
    const double square = ro * ro - ri * ri, cube = ro * ro * ro - ri * ri * ri;
    const double q = square * (ro * ro + ri * ri) / 8;
    const double EA = square / 2 * weight;
    const double r_nc = 4.0 / 3 * sin(th / 2) * cube / square * jump / weight;
    const double along = q * (a->E_soft * two_pi + jump * (th - sin(th)));
    const double across = q * (a->E_soft * two_pi + jump * (th + sin(th)));
    return (annulus_closed_form){
        .EA = EA,
        .r_nc = r_nc,
        .EI_centre = {along, across - EA * r_nc * r_nc},
    };
}
