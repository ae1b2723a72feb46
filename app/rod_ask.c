// app/rod_ask.c
#include "app/rod_ask.h"

#include "base/memory.h"

status rod_ask_make(const rod_case *rod, rod_ask *out)
{
    status st = OK;
    *out = (rod_ask){.rod = rod, .count = rod_case_solutions(rod), .base = rod_case_base(rod)};
    TRY(TAKE(out->tension, (size_t)rod->tendons.count));
    TRY(TAKE(out->pull, (size_t)rod->tendons.count));
    TRY(TAKE(out->load, (size_t)rod_case_loads(rod)));
    out->request = (rod_request){.tension = out->tension,
                                 .pull = out->pull,
                                 .load = out->load,
                                 .base = mark_given(rod->base.at) ? &out->base : NULL,
                                 .cold = true,
                                 .past = rod->past,
                                 .stability = true};

done:
    return st;
}

void rod_ask_free(rod_ask *ask)
{
    free(ask->tension);
    free(ask->pull);
    free(ask->load);
    *ask = (rod_ask){0};
}

void rod_ask_fill(rod_ask *ask, int i)
{
    rod_case_solution(ask->rod, i, ask->tension, ask->pull, ask->load);
}

bool rod_ask_limited(status st, const rod_solution *solution)
{
    return st == ERR_NUMERIC && solution->limited;
}
