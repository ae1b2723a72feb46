// app/compare_frames.c
// The rod in the NC frame against the GC frame.
#include "app/compare_rows.h"
#include "base/memory.h"

#include <math.h>

enum { FRAME_POINTS = 61 };

// Both frames describe one rod. Where the law is known exactly (constant, or in closed form) both
// are solved to exact_rod of the length and may be this far apart [m]: rounding of a shape made of
// a few hundred exponentials, and the two solves.
static const double exact_rod = 1e-12, exact_apart = 1e-12;

static status frame_shape(const case_data *c, const run_result *r, int frame, double accuracy,
                          const double *tension, pose *shape)
{
    status st = OK;
    const rod_case *rc = &c->file.rod;
    const rod_options options = {.frame = frame, .tolerance = accuracy};
    const rod_spec spec = {
        .law = &r->section.along, .ntendon = rc->tendons.count, .tendons = rc->tendons.items};
    double s[FRAME_POINTS];
    rod *one = NULL;
    rod_state *state = NULL;
    rod_solution solution = {0};
    TRY(rod_make(&spec, &options, &one));
    TRY(rod_state_make(one, &state));
    TRY(rod_solve(state, &(rod_request){.tension = tension}, &solution));
    TRY(rod_shape(state, FRAME_POINTS, s, shape));

done:
    rod_state_free(state);
    rod_free(one);
    return st;
}

// the largest distance between the two frames' shapes [m]
static status frames_apart(const case_data *c, const run_result *r, double accuracy,
                           const double *tension, double *apart)
{
    status st = OK;
    pose *gc = NULL, *nc = NULL;
    TRY(TAKE(gc, FRAME_POINTS));
    TRY(TAKE(nc, FRAME_POINTS));
    TRY(frame_shape(c, r, FRAME_GC, accuracy, tension, gc));
    TRY(frame_shape(c, r, FRAME_NC, accuracy, tension, nc));
    for (int i = 0; i < FRAME_POINTS; i++) {
        *apart = fmax(*apart, vec3_norm(vec3_sub(gc[i].p, nc[i].p)));
    }

done:
    free(gc);
    free(nc);
    return st;
}

// over all tensions of the case
static status frames_all(const case_data *c, const run_result *r, double accuracy, double *apart)
{
    status st = OK;
    const key_rows *tensions = &c->file.rod.tensions;
    *apart = 0;
    for (int i = 0; i < tensions->nrow; i++) {
        const double *tension = tensions->a + (size_t)i * (size_t)tensions->ncol;
        TRY(frames_apart(c, r, accuracy, tension, apart));
    }

done:
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
    if (rc->tensions.nrow == 0) {
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
    TRY(case_place(c, frames_all(c, r, rc->tolerance, &largest), rc->tensions.at));
    compare_judge(row, 1e9 * largest, 0, largest / rc->length,
                  (tolerance){2 * rc->tolerance,
                              exact ? "the rod refuses 1e-12: each shape is within the case's own "
                                      "tolerance"
                                    : "each shape is within the case's own rod tolerance"});

done:
    return st;
}
