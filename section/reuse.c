// section/reuse.c
#include "section/reuse.h"

#include "base/memory.h"
#include "section/solve.h"

// outlines nearer than this part of their size are one: contrast times this stays below 1e-10 of K
static const double same_outline = 1e-12;

void section_store_free(section_store *store)
{
    for (int i = 0; i < store->count; i++) {
        section_outline_free(&store->solved[i].outline);
    }
    free(store->solved);
    store->solved = NULL;
    store->count = store->capacity = 0;
}

static status make_room(section_store *store)
{
    status st = OK;
    solved_section *more = NULL;
    if (store->count < store->capacity) {
        return OK;
    }
    const int capacity = 2 * store->capacity + 16;
    TRY(TAKE(more, (size_t)capacity));
    for (int i = 0; i < store->count; i++) {
        more[i] = store->solved[i];
    }
    free(store->solved);
    store->solved = more;
    store->capacity = capacity;

done:
    return st;
}

static const solved_section *find(const section_store *store, const section_outline *o)
{
    for (int i = 0; i < store->count; i++) {
        double angle = 0;
        if (section_outline_is_turned(&store->solved[i].outline, o, same_outline, &angle)) {
            return &store->solved[i];
        }
    }
    return NULL;
}

static status solve_new(section_store *store, section_outline *o)
{
    status st = OK;
    solved_section new = {0};
    bool meshed = false;
    TRY(make_room(store));
    TRY(section_solve_outline(store->request, store->materials, o, &new.turned, &meshed));
    new.turned.K = beam_law_move(new.turned.K, 0, 0, o->turn);
    new.outline = *o; // ownership passes
    *o = (section_outline){0};
    store->meshed = store->meshed || meshed;
    store->solved[store->count++] = new;

done:
    return st;
}

status section_store_law(section_store *store, double s, beam_law *turned, double *turn,
                         bool *has_symmetry)
{
    status st = OK;
    section_outline o = {0};
    const key_list *shapes = &store->request->shapes;
    TRY(shapes_at((shape_list){.count = shapes->count, .items = shapes->items}, s, &o));
    *turn = o.turn;
    *has_symmetry = o.has_symmetry;
    const solved_section *found = find(store, &o);
    if (!found) {
        TRY(solve_new(store, &o));
        found = &store->solved[store->count - 1];
    }
    *turned = found->turned;

done:
    section_outline_free(&o);
    return st;
}
