// reach/reach_case.c
#include "reach/reach_case.h"

#include <math.h>
#include <string.h>

// points of a line that are nearer than this are one [m]
static const double SAME_PLACE = 1e-9;

static const scope_case *scope_of_case(const reach_case *c, int i)
{
    return (const scope_case *)c->scopes.items + i;
}

static status check_range(const scope_case *s, const char *what, const double limit[2], double unit,
                          const char *unit_name)
{
    return limit[0] <= limit[1]
               ? OK
               : status_fail(
                     ERR_INPUT,
                     "scope '%.60s': %s from %g to %g %s is no range: the least comes first",
                     s->name, what, limit[0] / unit, limit[1] / unit, unit_name);
}

static status check_rod(const scope_case *s, mark *where)
{
    status st = OK;
    if (s->tensions.nrow == 0) {
        return status_fail(ERR_INPUT,
                           "scope '%.60s' is a rod: give the least and most tension of its "
                           "tendons, tensions_N: [[0, 2]]",
                           s->name);
    }
    *where = s->tensions.at;
    for (int i = 0; i < s->tensions.nrow; i++) {
        TRY(check_range(s, "tension", &s->tensions.a[2 * i], 1, "N"));
    }
    for (int i = 0; i < s->rod.set.count; i++) {
        const key_text *set = (const key_text *)s->rod.set.items + i;
        if (!strchr(set->text, '=')) {
            *where = set->at;
            return status_fail(ERR_INPUT, "'%.60s' sets nothing: write KEY=VALUE", set->text);
        }
    }

done:
    return st;
}

static status check_arc(const scope_case *s, mark *where)
{
    status st = OK;
    if (s->tensions.nrow > 0) {
        *where = s->tensions.at;
        return status_fail(ERR_INPUT, "scope '%.60s' has no tendons: its limits are bend_deg",
                           s->name);
    }
    if (s->strain_limit) {
        return status_fail(ERR_INPUT, "scope '%.60s' has no materials that a strain could limit",
                           s->name);
    }
    *where = s->constant_curvature.at;
    TRY(check_range(s, "bend", s->constant_curvature.bend, acos(-1.0) / 180, "degrees"));

done:
    return st;
}

static status check_scope(const reach_case *c, int i, mark *where)
{
    status st = OK;
    const scope_case *s = scope_of_case(c, i);
    *where = s->at;
    if (!s->name[0]) {
        return status_fail(ERR_INPUT, "a scope needs a name");
    }
    if (strlen(s->name) >= SCOPE_NAME) {
        return status_fail(ERR_INPUT, "the scope's name '%.20s...' is longer than %d bytes",
                           s->name, SCOPE_NAME - 1);
    }
    for (int k = 0; k < i; k++) {
        if (strcmp(scope_of_case(c, k)->name, s->name) == 0) {
            return status_fail(ERR_INPUT, "two scopes are called '%s'", s->name);
        }
    }
    TRY(check_range(s, "insertion", s->insertion, 1e-3, "mm"));
    TRY(check_range(s, "turn", s->turn, acos(-1.0) / 180, "degrees"));
    TRY(mark_given(s->rod.at) ? check_rod(s, where) : check_arc(s, where));

done:
    return st;
}

static bool towards_given(const entry_case *e)
{
    return !isnan(e->towards[0]);
}

void entry_direction(const entry_case *e, double direction[3])
{
    for (int k = 0; k < 3; k++) {
        direction[k] = towards_given(e) ? e->towards[k] - e->point[k] : e->direction[k];
    }
}

static status check_entry(const entry_case *e, mark *where)
{
    double d[3];
    *where = e->at;
    entry_direction(e, d);
    const double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    if (towards_given(e) && length < SAME_PLACE) {
        return status_fail(ERR_INPUT, "the entry line goes nowhere: point and towards are one");
    }
    return length > 0 ? OK : status_fail(ERR_INPUT, "the entry line's direction has no length");
}

status reach_case_check(const reach_case *c, mark *where)
{
    status st = OK;
    TRY(check_entry(&c->entry, where));
    *where = c->at;
    if (!c->targets.text && !mark_given(c->map.at)) {
        return status_fail(ERR_INPUT, "nothing to reach: give targets, or a map, or both");
    }
    *where = c->scopes.at;
    if (c->scopes.count == 0) {
        return status_fail(ERR_INPUT, "no scopes");
    }
    for (int i = 0; i < c->scopes.count; i++) {
        TRY(check_scope(c, i, where));
    }

done:
    return st;
}
