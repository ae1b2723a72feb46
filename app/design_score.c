// app/design_score.c
#include "app/design_score.h"

#include "app/design_case.h"
#include "base/memory.h"

#include <math.h>

// A map of a design that is one of many: coarser, what is not decided counts by halves.
enum { MAP_LOOKS = 50000 };
static const double MAP_RESOLUTION = 5e-4; // [m]

static double beyond(double x)
{
    return x > 0 ? x : 0;
}

double design_closeness(const reach_answer *a, double tolerance, double clearance, double length)
{
    switch (a->verdict) {
    case REACH_OUT_OF_REACH:
    case REACH_JOINT_LIMIT:
        return length / (length + beyond(a->miss - tolerance)) / 3;
    case REACH_COLLISION:
    case REACH_NO_WAY:
        return (1 + length / (length + beyond(clearance - a->clearance))) / 3;
    case REACH_REACHED: {
        const double room = beyond(a->clearance - clearance);
        return (2 + (isfinite(room) ? room / (length + room) : 1)) / 3;
    }
    default:
        return 0;
    }
}

static status score_targets(const design_scoring *d, reach_scope *s, double *goal, double *score)
{
    status st = OK;
    const reach_case *r = &d->c->file.reach;
    const reach_study how = {.c = d->c, .scene = d->scene, .workers = 1};
    const reach_result sizes = {.ntarget = d->scene->ntarget, .nscope = 1};
    reach_result found = {0};
    double sum = 0;
    TRY(reach_result_make(&sizes, &found));
    TRY(reach_study_scope(&how, s, &found.scope[0]));
    for (int i = 0; i < sizes.ntarget; i++) {
        const double near =
            design_closeness(&found.scope[0].answer[i], r->tolerance, r->clearance, d->length);
        sum += isfinite(near) ? near : 0; // a pose without a clearance tells nothing
    }
    *goal = found.scope[0].nreached;
    *score = *goal + sum / (sizes.ntarget + 1); // below 1

done:
    reach_result_free(&found);
    return st;
}

static status score_area(const design_scoring *d, reach_scope *s, double *goal, double *score)
{
    status st = OK;
    reach_scene empty = *d->scene; // the map alone
    empty.ntarget = 0;
    const reach_study how = {.c = d->c,
                             .scene = &empty,
                             .workers = 1,
                             .nmap = d->nmap,
                             .map = (const double(*)[3])d->map,
                             .map_looks = MAP_LOOKS,
                             .map_resolution = MAP_RESOLUTION};
    const reach_result sizes = {.nmap = d->nmap, .nscope = 1};
    reach_result found = {0};
    TRY(reach_result_make(&sizes, &found));
    TRY(reach_study_scope(&how, s, &found.scope[0]));
    const double n = d->nmap;
    *goal = found.scope[0].area_reached;
    *score = n * *goal + 0.5 * n * found.scope[0].area_undecided / (n + 1);

done:
    reach_result_free(&found);
    return st;
}

status design_score(void *context, const double *x, double *goal, double *score)
{
    status st = OK;
    const design_scoring *d = context;
    settings s = {0};
    reach_scope scope = {0};
    TRY(design_settings(d->c, x, &s));
    TRY(reach_scope_make(d->c, d->base, d->scope, &s, &scope));
    TRY(reach_scene_fits(d->c, d->scene, scope.scope.length));
    TRY(d->nmap > 0 ? score_area(d, &scope, goal, score) : score_targets(d, &scope, goal, score));

done:
    reach_scope_free(&scope);
    settings_free(&s);
    return st;
}
