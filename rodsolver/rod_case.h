// rodsolver/rod_case.h
// What a case file says about the rod.
#pragma once

#include "base/key.h"
#include "rodsolver/rod.h"

enum { ROD_CASE_TENDONS = 256 }; // as many as a case may have

typedef struct rod_case {
    mark at;
    double length;     // [m]
    key_list tendons;  // of tendon_spec
    key_rows tensions; // [nsolution][ntendon] [N], >= 0
    int frame; // rod_frame in which the rod is solved; the shape is the geometric centreline in
               // both
    double tolerance; // |p - p_exact| / L wanted at the tip
    int points;       // of the shape that is written
} rod_case;

extern const key_table rod_keys; // `rod`
rod_case rod_case_default(void);

// Contradictions that no single key shows (tension rows and tendons, end beyond the tip): ERR_INPUT
// and the place.
status rod_case_check(const rod_case *c, mark *where);
