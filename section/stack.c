// section/stack.c
#include "section/stack.h"

#include "base/memory.h"

#include <math.h>

// a rod may be longer than its stack by this part: rounding of the case's numbers
static const double same_length = 1e-9;

static status check(const section_case *c, double length)
{
    const double stack = section_own_length(c);
    if (length > stack * (1 + same_length)) {
        return status_fail(ERR_INPUT,
                           "section: the stack of %d slices is %.6g mm thick, %.6g mm are needed",
                           drawing_slice_count(c->drawing), 1e3 * stack, 1e3 * length);
    }
    if (field_varies(&c->turn) || field_varies(&c->scale)) {
        return status_fail(ERR_INPUT, "section: turn and scale of a stack cannot vary along s; "
                                      "pattern_turn says how the pattern in its slices turns");
    }
    return OK;
}

// first slices of the runs that reach into the length; *count of them
static status find_runs(const drawing *d, double layer, double length, int *first, int *count)
{
    const int slices = (int)fmin(ceil(length / layer * (1 - same_length)), drawing_slice_count(d));
    *count = 0;
    for (int i = 0, last = -1; i < slices; i++) {
        const int same = drawing_slice_at(d, (i + 0.5) * layer);
        if (same != last) {
            first[(*count)++] = i;
        }
        last = same;
    }
    return *count > 0 ? OK : status_fail(ERR_BUG, "a stack without slices");
}

status stack_laws(section_store *store, double length, law_along *out)
{
    status st = OK;
    const section_case *c = store->request;
    const double layer = section_own_length(c) / drawing_slice_count(c->drawing);
    int *first = NULL, count = 0;
    law_along along = {0};
    TRY(check(c, length));
    TRY(TAKE(first, (size_t)drawing_slice_count(c->drawing)));
    TRY(find_runs(c->drawing, layer, length, first, &count));
    TRY(law_along_make(length, count, 1, &along));
    for (int k = 1; k < count; k++) {
        along.edge[k] = first[k] * layer;
    }
    for (int k = 0; k < count; k++) {
        solved_section one = {0};
        TRY(section_store_law(store, law_along_node(&along, k, 0), &one));
        along.law[k] = one.turned;
        along.turn[k] = one.place.turn;
        section_place_free(&one.place);
    }
    *out = along;
    along = (law_along){0};

done:
    law_along_free(&along);
    free(first);
    return st;
}
