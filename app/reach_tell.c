// app/reach_tell.c
#include "app/reach_tell.h"

#include "app/reach_case.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

// --- strains

static void keep_strain(const reach_scope *s, const section_strain_place *strain, reach_answer *a)
{
    const case_data *c = &s->rod.c;
    double share = 0;
    const int worst = reach_worst_strain(s, strain, &share);
    a->strain = 0;
    for (int m = 0; m < c->nmaterial; m++) {
        a->strain = fmax(a->strain, fabs(strain[m].value));
    }
    if (reach_strain_is_searched(s) && share > 1 && a->verdict == REACH_REACHED) {
        a->verdict = REACH_JOINT_LIMIT;
        (void)snprintf(a->why, sizeof a->why, "'%.40s' is strained by %.3g %%, past its %.3g %%",
                       c->materials[worst].name, 100 * fabs(strain[worst].value),
                       100 * c->materials[worst].linear_strain);
    }
}

status reach_tell_strains(const reach_study *how, const reach_scope *s,
                          const reach_strain_probe *strains, reach_scope_result *r)
{
    status st = OK;
    section_strain_place *strain = NULL;
    if (!strains) {
        return OK;
    }
    TRY(TAKE(strain, (size_t)s->rod.c.nmaterial));
    for (int i = 0; i < how->scene->ntarget; i++) {
        reach_answer *a = &r->answer[i];
        if (a->verdict != REACH_FAILED) {
            TRY(reach_strain_at(strains, a->q, strain));
            keep_strain(s, strain, a);
        }
    }

done:
    free(strain);
    return st;
}

// --- all tendons

static void all_joints(const scope *s, int njoint, double *q)
{
    double tension[SCOPE_TENDONS];
    scope_tensions(s, q, tension);
    memcpy(q + SCOPE_BEND, tension, (size_t)(njoint - SCOPE_BEND) * sizeof *q);
}

void reach_tell_tendons(const reach_scope *s, int ntarget, reach_scope_result *r)
{
    const scope *sc = &s->scope;
    r->njoint = sc->njoint;
    for (int i = 0; i < SCOPE_TENDONS; i++) {
        r->njoint += sc->held[i];
    }
    if (r->njoint == sc->njoint) {
        return;
    }
    all_joints(sc, r->njoint, r->low);
    all_joints(sc, r->njoint, r->high);
    for (int i = 0; i < ntarget; i++) {
        reach_answer *a = &r->answer[i];
        all_joints(sc, r->njoint, a->q);
        for (int k = 0; k < a->npath; k++) {
            all_joints(sc, r->njoint, a->path[k]);
        }
        a->joint = a->joint >= SCOPE_BEND ? SCOPE_BEND + scope_tendon(sc, a->joint) : a->joint;
    }
}

// --- the body

// points of the straight shaft, and of the tip, whose last one is its end
enum { SHAFT_POINTS = 12, TIP_POINTS = REACH_BODY_POINTS - SHAFT_POINTS };

static status tell_way(scope_state *state, reach_answer *a)
{
    status st = OK;
    const double length = scope_of(state)->length;
    const int n = a->npath < REACH_WAY_STEPS ? a->npath : REACH_WAY_STEPS;
    TRY(reach_answer_way(a, n));
    for (int i = 0; i < n; i++) {
        const double *q = a->path[n > 1 ? (long)i * (a->npath - 1) / (n - 1) : 0];
        const double entry = fmin(-q[SCOPE_INSERTION], 0);
        TRY(scope_bend(state, q));
        for (int k = 0; k < REACH_WAY_POINTS; k++) {
            const double s = entry + (length - entry) * k / (REACH_WAY_POINTS - 1);
            const vec3 p = scope_point(state, q, s);
            memcpy(a->way[i][k], p.a, sizeof a->way[i][k]);
        }
    }

done:
    return st;
}

status reach_tell_body(const reach_study *how, scope_state *state, reach_answer *a)
{
    status st = OK;
    const scope *s = scope_of(state);
    if (a->npoint == 0) {
        return OK;
    }
    TRY(a->npath > 0 ? tell_way(state, a) : OK);
    TRY(scope_bend(state, a->q));
    const double entry = fmin(-a->q[SCOPE_INSERTION], 0);
    for (int i = 0; i < a->npoint; i++) {
        const double t = i - SHAFT_POINTS;
        a->along[i] = t < 0 ? -entry * t / SHAFT_POINTS : s->length * t / (TIP_POINTS - 1);
        const vec3 p = scope_point(state, a->q, a->along[i]);
        memcpy(a->point[i], p.a, sizeof a->point[i]);
        a->room[i] = distance_to(how->scene->tree, p).distance - s->radius;
    }

done:
    return st;
}

// --- words

static void joint_words(const scope *s, int joint, double value, char words[REACH_NAME])
{
    char name[SCOPE_NAME];
    const bool angle = joint == SCOPE_TURN || (joint >= SCOPE_BEND && !s->rod);
    const double unit = joint == SCOPE_INSERTION ? 1e-3 : angle ? acos(-1.0) / 180 : 1;
    const char *unit_name = joint == SCOPE_INSERTION ? "mm" : angle ? "deg" : "N";
    (void)snprintf(words, REACH_NAME, "%.30s, %.4g %s", scope_joint_name(s, joint, name),
                   value / unit, unit_name);
}

static void limit_reason(const scope *s, reach_answer *a)
{
    char words[REACH_NAME];
    if (a->joint < 0) {
        return; // a strain: told already
    }
    joint_words(s, a->joint, a->q[a->joint], words);
    (void)snprintf(a->why, sizeof a->why, "the limit of %s, leaves the tip %.3g mm away", words,
                   1e3 * a->miss);
}

static void collision_reason(double least, double length, reach_answer *a)
{
    char where[REACH_NAME];
    if (a->s < 0) {
        (void)snprintf(where, sizeof where, "on the shaft, %.3g mm before the tip", -1e3 * a->s);
    } else {
        (void)snprintf(where, sizeof where, "at s = %.3g mm of the %.3g mm that bend", 1e3 * a->s,
                       1e3 * length);
    }
    const double depth = least - a->clearance;
    (void)snprintf(a->why, sizeof a->why, "%.3g mm too near to the tissue %s", 1e3 * fmax(depth, 0),
                   where);
}

void reach_tell_reason(const reach_study *how, const reach_scope *s, reach_answer *a)
{
    const reach_case *r = &how->c->file.reach;
    if (r->tip == REACH_TIP_SKIN) {
        a->miss = fmax(a->miss - s->scope.radius, 0);
    }
    switch (a->verdict) {
    case REACH_OUT_OF_REACH:
        (void)snprintf(a->why, sizeof a->why, "the tip comes no nearer than %.3g mm",
                       1e3 * a->miss);
        break;
    case REACH_JOINT_LIMIT:
        limit_reason(&s->scope, a);
        break;
    case REACH_COLLISION:
        collision_reason(r->clearance, s->scope.length, a);
        break;
    case REACH_NO_WAY:
        (void)snprintf(a->why, sizeof a->why,
                       "no way in was found to this pose, the widest leaves %.3g mm",
                       1e3 * a->path_clearance);
        break;
    default:
        break;
    }
}
