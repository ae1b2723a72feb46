// app/compare_frames.c
// The rod in the NC frame against the GC frame.
#include "app/compare_rows.h"
#include "app/rod_ask.h"
#include "base/memory.h"

#include <math.h>

enum { FRAME_POINTS = 61 };

// Both frames describe one rod. Where the law is known exactly (constant, or in closed form) both
// are solved to exact_rod of the length and may be this far apart [m]: rounding of a shape made of
// a few hundred exponentials, and the two solves.
static const double exact_rod = 1e-12, exact_apart = 1e-12;

// solutions of a sweep that are looked at, from the first
enum { MOST_COMPARED = 24 };

// one rod, solved in both frames
typedef struct both_frames {
    rod *rod[2];
    rod_state *state[2];
    rod_ask ask;
    pose *shape[2]; // [FRAME_POINTS]
} both_frames;

static void both_free(both_frames *b)
{
    for (int i = 0; i < 2; i++) {
        rod_state_free(b->state[i]);
        rod_free(b->rod[i]);
        free(b->shape[i]);
    }
    rod_ask_free(&b->ask);
}

static status both_make(const case_data *c, const run_result *r, double accuracy, both_frames *b)
{
    status st = OK;
    const rod_spec spec = rod_case_spec(&c->file.rod, &r->section.along);
    TRY(rod_ask_make(&c->file.rod, &b->ask));
    for (int i = 0; i < 2; i++) {
        const rod_options options = {.frame = i ? FRAME_NC : FRAME_GC, .tolerance = accuracy};
        TRY(rod_make(&spec, &options, &b->rod[i]));
        TRY(rod_state_make(b->rod[i], &b->state[i]));
        TRY(TAKE(b->shape[i], FRAME_POINTS));
    }

done:
    return st;
}

// the largest distance between the two shapes of solution i [m]; none where it ends at a limit
// point
static status frames_apart(both_frames *b, int i, double *apart)
{
    status st = OK;
    double s[FRAME_POINTS];
    rod_ask_fill(&b->ask, i);
    b->ask.request.stability = false;
    for (int k = 0; k < 2; k++) {
        rod_solution solution = {0};
        st = rod_solve(b->state[k], &b->ask.request, &solution);
        if (rod_ask_limited(st, &solution)) {
            status_clear();
            return OK;
        }
        TRY(st);
        TRY(rod_shape(b->state[k], FRAME_POINTS, s, b->shape[k]));
    }
    for (int k = 0; k < FRAME_POINTS; k++) {
        *apart = fmax(*apart, vec3_norm(vec3_sub(b->shape[0][k].p, b->shape[1][k].p)));
    }

done:
    return st;
}

// over the solutions that the case asks for
static status frames_all(const case_data *c, const run_result *r, double accuracy, double *apart)
{
    status st = OK;
    both_frames b = {0};
    *apart = 0;
    TRY(both_make(c, r, accuracy, &b));
    for (int i = 0; i < b.ask.count && i < MOST_COMPARED; i++) {
        TRY(frames_apart(&b, i, apart));
    }

done:
    both_free(&b);
    return st;
}

status compare_frames(const case_data *c, run_result *r)
{
    status st = OK;
    const rod_case *rc = &c->file.rod;
    const law_along *along = &r->section.along;
    const bool exact = !r->section.effort.meshed || along->npanel * along->nnode == 1;
    double largest = 0;
    compare_row *row =
        compare_add(r, "nm", "rod: largest distance, NC frame to GC frame (of length)");
    if (rod_case_solutions(rc) == 0) {
        compare_skip(row, "the case has no tensions");
        return OK;
    }
    if (section_own_length(&c->file.section) > 0 && along->npanel * along->nnode > 1) {
        compare_skip(row, "the stiffness centre jumps from slice to slice, no curve follows it");
        return OK;
    }
    if (exact && frames_all(c, r, exact_rod, &largest) == OK) {
        compare_judge(row, 1e9 * largest, 0, largest / rc->length,
                      (tolerance){fmax(exact_apart / rc->length, 2 * exact_rod),
                                  "1e-12 m: the law is exact, both solved to 1e-12"});
        return OK;
    }
    status_clear();
    TRY(case_place(c, frames_all(c, r, rc->tolerance, &largest), rod_case_rows(rc)));
    compare_judge(row, 1e9 * largest, 0, largest / rc->length,
                  (tolerance){2 * rc->tolerance,
                              exact ? "the rod refuses 1e-12: each shape is within the case's own "
                                      "tolerance"
                                    : "each shape is within the case's own rod tolerance"});

done:
    return st;
}
