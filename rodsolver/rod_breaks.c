// rodsolver/rod_breaks.c
// Where panels must end, so that everything is smooth inside them.
#include "base/memory.h"
#include "rodsolver/kinks.h"
#include "rodsolver/rod_plan.h"
#include "rodsolver/tendon_table.h"

#include <string.h>

// two edges nearer than this part of the length are one
static const double same_edge = 1e-9;

enum {
    OF_TENDON = 1 + 2 * MOST_KINKS,         // its end, its fields and its table
    LINE_FIELDS = 8,                        // force, moment, place
    OF_LINE = 2 + LINE_FIELDS * MOST_KINKS, // both ends
    OF_REST = 3 * MOST_KINKS,
};

static void add(rod *r, double s)
{
    r->breaks[r->nbreak++] = s;
}

static void add_tendon(rod *r, int i)
{
    add(r, r->spec[i].end);
    r->nbreak += kinks_of_tendon(&r->spec[i], r->breaks + r->nbreak);
    r->nbreak += tendon_table_kinks(&r->path[i], MOST_KINKS, r->breaks + r->nbreak);
}

static void add_line(rod *r, const line_load *l)
{
    const field *all[LINE_FIELDS] = {&l->force[0],  &l->force[1],  &l->force[2], &l->moment[0],
                                     &l->moment[1], &l->moment[2], &l->place[0], &l->place[1]};
    add(r, l->from);
    add(r, l->to);
    for (int i = 0; i < LINE_FIELDS; i++) {
        r->nbreak += kinks_of_field(all[i], l->from, l->to, r->breaks + r->nbreak);
    }
}

static void add_rest(rod *r)
{
    const field *all[3] = {&r->rest.curvature_x, &r->rest.curvature_y, &r->rest.twist};
    for (int i = 0; i < 3; i++) {
        r->nbreak += kinks_of_field(all[i], 0, r->length, r->breaks + r->nbreak);
    }
}

static status add_own(rod *r, const rod_spec *spec)
{
    for (int i = 0; i < spec->nbreak; i++) {
        if (!(spec->breaks[i] >= 0 && spec->breaks[i] <= r->length * (1 + same_edge))) {
            return status_fail(ERR_INPUT, "rod: a break at %g m, outside the rod of %g m",
                               spec->breaks[i], r->length);
        }
        add(r, spec->breaks[i]);
    }
    return OK;
}

static int compare_reals(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// sorted, each once, from 0 to the length
static void merge(rod *r)
{
    const int n = r->nbreak;
    qsort(r->breaks, (size_t)n, sizeof *r->breaks, compare_reals);
    r->nbreak = 0;
    for (int i = 0; i < n; i++) {
        if (r->nbreak == 0 || r->breaks[i] - r->breaks[r->nbreak - 1] > same_edge * r->length) {
            add(r, r->breaks[i]);
        }
    }
    r->breaks[0] = 0;
    r->breaks[r->nbreak - 1] = r->length;
}

status rod_find_breaks(struct rod *r, const rod_spec *spec)
{
    status st = OK;
    const int nedge = r->law->npanel + 1;
    const size_t most = (size_t)nedge + (size_t)r->ntendon * OF_TENDON + (size_t)r->npoint_load +
                        (size_t)r->nline_load * OF_LINE + OF_REST + (size_t)spec->nbreak;
    TRY(TAKE(r->breaks, most));
    memcpy(r->breaks, r->law->edge, (size_t)nedge * sizeof *r->breaks);
    r->nbreak = nedge;
    for (int i = 0; i < r->ntendon; i++) {
        add_tendon(r, i);
    }
    for (int i = 0; i < r->npoint_load; i++) {
        add(r, r->point_loads[i].s);
    }
    for (int i = 0; i < r->nline_load; i++) {
        add_line(r, &r->line_loads[i]);
    }
    add_rest(r);
    TRY(add_own(r, spec));
    merge(r);

done:
    return st;
}
