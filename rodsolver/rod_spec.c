// rodsolver/rod_spec.c
// What rod_make keeps of a rod_spec.
#include "base/memory.h"
#include "rodsolver/rod_plan.h"
#include "rodsolver/tendon_table.h"

#include <math.h>
#include <string.h>

// two edges nearer than this part of the length are one
static const double same_edge = 1e-9;

static bool finite_all(const double *a, int n)
{
    for (int i = 0; i < n; i++) {
        if (!isfinite(a[i])) {
            return false;
        }
    }
    return true;
}

static const char *name_or_mark(const char *name)
{
    return name ? name : "?";
}

static status copy_tendons(rod *r, const tendon_spec *tendons)
{
    status st = OK;
    TRY(TAKE(r->spec, (size_t)r->ntendon));
    TRY(TAKE(r->path, (size_t)r->ntendon));
    for (int i = 0; i < r->ntendon; i++) {
        tendon_spec *t = &r->spec[i];
        *t = tendons[i];
        if (t->end == 0) {
            t->end = r->length;
        }
        if (!(t->end > 0) || t->end > r->length * (1 + same_edge)) {
            TRY(status_fail(ERR_INPUT, "rod: tendon '%s' ends at %g m, outside the rod of %g m",
                            name_or_mark(t->name), t->end, r->length));
        }
        const double numbers[3] = {t->friction, t->EA, t->outside};
        if (!finite_all(numbers, 3) || t->friction < 0 || t->EA < 0 || t->outside < 0) {
            TRY(status_fail(ERR_INPUT,
                            "rod: friction %g, EA %g N, outside length %g m of tendon '%s': not "
                            "finite or below zero",
                            t->friction, t->EA, t->outside, name_or_mark(t->name)));
        }
        TRY(tendon_table_fit(t, &r->path[i]));
    }

done:
    return st;
}

static status copy_point_loads(rod *r, const point_load *loads)
{
    status st = OK;
    TRY(TAKE(r->point_loads, (size_t)r->npoint_load));
    for (int i = 0; i < r->npoint_load; i++) {
        point_load *l = &r->point_loads[i];
        *l = loads[i];
        if (!(l->s >= 0) || !finite_all(l->force, 3) || !finite_all(l->moment, 3) ||
            !finite_all(l->place, 2)) {
            TRY(status_fail(ERR_INPUT,
                            "rod: load '%s' at s = %g mm lies before the base or is not finite",
                            name_or_mark(l->name), 1e3 * l->s));
        }
        l->s = fmin(l->s, r->length);
        for (int c = 0; c < 3; c++) {
            r->acts[i] = r->acts[i] || l->force[c] != 0 || l->moment[c] != 0;
        }
    }

done:
    return st;
}

static bool field_acts(const field *f)
{
    return field_varies(f) || f->value != 0;
}

static status copy_line_loads(rod *r, const line_load *loads)
{
    status st = OK;
    TRY(TAKE(r->line_loads, (size_t)r->nline_load));
    for (int i = 0; i < r->nline_load; i++) {
        line_load *l = &r->line_loads[i];
        *l = loads[i];
        l->to = l->to == 0 ? r->length : fmin(l->to, r->length);
        if (!(l->from >= 0) || !(l->to > l->from)) {
            TRY(status_fail(ERR_INPUT, "rod: load '%s' reaches from %g m to %g m",
                            name_or_mark(l->name), l->from, l->to));
        }
        for (int c = 0; c < 3; c++) {
            bool *acts = &r->acts[r->npoint_load + i];
            *acts = *acts || field_acts(&l->force[c]) || field_acts(&l->moment[c]);
        }
    }

done:
    return st;
}

static status check_counts(const rod_spec *spec)
{
    const int count[4] = {spec->ntendon, spec->npoint_load, spec->nline_load, spec->nbreak};
    for (int i = 0; i < 4; i++) {
        if (count[i] < 0) {
            return status_fail(ERR_INPUT, "rod: %d tendons, point loads, line loads or breaks",
                               count[i]);
        }
    }
    if (!finite_all(spec->gravity, 3)) {
        return status_fail(ERR_INPUT, "rod: gravity is not finite");
    }
    const double *g = spec->gravity;
    if ((g[0] != 0 || g[1] != 0 || g[2] != 0) && !law_along_has_mass(spec->law)) {
        return status_fail(ERR_INPUT, "rod: gravity acts on masses, and they are not known: give "
                                      "every material of the section a density");
    }
    return OK;
}

status rod_copy_spec(struct rod *r, const rod_spec *spec)
{
    status st = OK;
    TRY(check_counts(spec));
    r->law = spec->law;
    r->length = spec->law->length;
    r->rest = spec->rest;
    memcpy(r->gravity, spec->gravity, sizeof r->gravity);
    r->has_gravity = spec->gravity[0] != 0 || spec->gravity[1] != 0 || spec->gravity[2] != 0;
    r->ntendon = spec->ntendon;
    r->npoint_load = spec->npoint_load;
    r->nline_load = spec->nline_load;
    TRY(TAKE(r->acts, (size_t)rod_load_count(r)));
    if (r->has_gravity) {
        r->acts[r->npoint_load + r->nline_load] = true;
    }
    TRY(copy_tendons(r, spec->tendons));
    TRY(copy_point_loads(r, spec->point_loads));
    TRY(copy_line_loads(r, spec->line_loads));
    TRY(rod_find_breaks(r, spec));

done:
    return st;
}
