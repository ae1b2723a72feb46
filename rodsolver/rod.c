// rodsolver/rod.c
#include "base/memory.h"
#include "rodsolver/rod_plan.h"

#include <math.h>
#include <string.h>

// two edges nearer than this part of the length are one
static const double same_edge = 1e-9;

static status copy_tendons(rod *r, const tendon_spec *tendons)
{
    status st = OK;
    TRY(TAKE(r->spec, (size_t)r->ntendon));
    for (int i = 0; i < r->ntendon; i++) {
        tendon_spec *t = &r->spec[i];
        *t = tendons[i];
        if (t->end == 0) {
            t->end = r->length;
        }
        if (!(t->end > 0) || t->end > r->length * (1 + same_edge)) {
            TRY(status_fail(ERR_INPUT, "rod: tendon '%s' ends at %g m, outside the rod of %g m",
                            t->name ? t->name : "?", t->end, r->length));
        }
    }

done:
    return st;
}

static int compare_reals(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// edges of the law's panels, ends of tendons and kinks of their paths, sorted, each once
static status find_breaks(rod *r)
{
    status st = OK;
    const int nedge = r->law->npanel + 1;
    const size_t most = (size_t)nedge + (size_t)r->ntendon * (1 + ROUTING_MAX_KINKS);
    TRY(TAKE(r->breaks, most));
    memcpy(r->breaks, r->law->edge, (size_t)nedge * sizeof *r->breaks);
    size_t n = (size_t)nedge;
    for (int i = 0; i < r->ntendon; i++) {
        r->breaks[n++] = r->spec[i].end;
        n += (size_t)routing_kinks(&r->spec[i], r->breaks + n);
    }
    qsort(r->breaks, n, sizeof *r->breaks, compare_reals);
    for (size_t i = 0; i < n; i++) {
        if (r->nbreak == 0 || r->breaks[i] - r->breaks[r->nbreak - 1] > same_edge * r->length) {
            r->breaks[r->nbreak++] = r->breaks[i];
        }
    }
    r->breaks[0] = 0;
    r->breaks[r->nbreak - 1] = r->length;

done:
    return st;
}

static void end_frames(rod *r)
{
    if (r->options.frame == FRAME_NC) {
        centre_frame f;
        const plan *p = &r->plans[r->nplan - 1];
        law_along_centre_frame(r->law, 0, p->frame[0].phi, &f);
        r->base = centre_frame_pose(&f);
        law_along_centre_frame(r->law, r->length, p->frame[p->nstation - 1].phi, &f);
        r->tip = centre_frame_pose(&f);
    }
}

static status check_options(const law_along *law, int ntendon, const rod_options *options)
{
    if (ntendon < 0 || ntendon > ROD_MAX_TENDONS) {
        return status_fail(ERR_INPUT, "rod: %d tendons, at most %d are possible", ntendon,
                           ROD_MAX_TENDONS);
    }
    if (options->npanel <= 0 && !(options->tolerance >= ROD_MIN_TOLERANCE)) {
        return status_fail(ERR_INPUT, "rod: tolerance %g is below the rounding limit %g",
                           options->tolerance, ROD_MIN_TOLERANCE);
    }
    for (int i = 0; i < law->npanel * law->nnode; i++) {
        const status st = beam_law_check(&law->law[i]);
        if (st != OK) {
            return st;
        }
    }
    return OK;
}

status rod_make(const law_along *law, int ntendon, const tendon_spec *tendons,
                const rod_options *options, rod **out)
{
    status st = OK;
    rod *r = NULL;
    TRY(check_options(law, ntendon, options));
    TRY(TAKE(r, 1));
    r->law = law;
    r->options = *options;
    r->length = law->length;
    r->ntendon = ntendon;
    r->doubt = 1;
    r->base = r->tip = pose_identity();
    for (int i = 0; i < GAUSS_STATIONS; i++) {
        lie_pair_weights(2 * gauss_point[i], r->pair_weight[i]);
    }
    TRY(copy_tendons(r, tendons));
    TRY(find_breaks(r));
    if (options->npanel > 0) {
        TRY(plan_add(r, options->npanel));
    } else {
        TRY(plans_choose(r));
    }
    end_frames(r);
    *out = r; // ownership passes only when all is well
    r = NULL;

done:
    rod_free(r);
    return st;
}

void rod_free(rod *r)
{
    if (!r) {
        return;
    }
    for (int i = 0; i < r->nplan; i++) {
        plan_free(&r->plans[i], r->ntendon);
    }
    free(r->spec);
    free(r->breaks);
    free(r->xi);
    free(r->pair_pose);
    free(r);
}

int rod_panel_count(const rod *r)
{
    const plan *p = r->solved ? r->solved : &r->plans[r->first_plan[ROD_PROBES - 1]];
    return 2 * p->npair;
}

double rod_critical_tension(const rod *r, int tendon, double *s)
{
    const plan_tendon *t = &r->plans[r->nplan - 1].tendon[tendon];
    if (s) {
        *s = t->critical_at;
    }
    return t->critical;
}
