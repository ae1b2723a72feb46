// tests/verify/app/solved_body.h
// A case's text -> the tip compliance of its body, clamped and capped, the direct way.
#pragma once

#include "fem/way.h"
#include "tests/unit/app/made_body.h"

typedef struct solved {
    made m;
    way_run run;
    mat6 C; // of the tip
} solved;

static inline void solve(const char *section, const char *rest, segment_mesh ask, int nlayer,
                         double grading, solved *out)
{
    *out = (solved){0};
    const status made = make_graded(section, rest, ask, nlayer, grading, &out->m);
    CHECK_OK(made);
    if (made != OK) {
        return;
    }
    const body *b = &out->m.body;
    const segment_problem p = {.body = b, .base = BASE_CLAMPED, .tip = TIP_RIGID};
    const way_wants wants = {.middle = b->length / 2, .middle_half = b->length / 8};
    CHECK_OK(way_direct(&p, &wants, &out->run));
    for (int i = 0; i < 36 && out->run.motion; i++) {
        out->C.a[i % 6][i / 6] =
            out->run.motion[i / 6 * out->run.nlevel + out->run.nlevel - 1].a[i % 6];
    }
}

static inline void done_with(solved *s)
{
    way_run_free(&s->run);
    unmake(&s->m);
}
