// reach/search.h
// Whether a scope reaches a target: is there a pose with the tip within `tolerance` of it, every
// joint in its limits and no part of the body in the tissue?          docs/theory.md (10.7) to
// (10.9)
//
// One bending joint: branch and bound over all three joints. In a box of joints no point of the
// body moves farther than (10.7) says, so that neither does its clearance: what is left out is
// proved to hold no pose, and "not reached" comes with the room `bound` that no pose exceeds. More:
// the family of poses at the target from starts all over the grid, each led to more room.
#pragma once

#include "reach/clearance.h"
#include "reach/inverse.h"

// How much room the body has at q; scope_bend(state, q) has been called. Negative: within the
// tissue by so much [m]. It must not change faster than the body's points move. *s: where it is
// least.
typedef struct room_probe {
    double (*at)(void *context, scope_state *state, const double *q, double *s);
    void *context;
    // the same only as far as it is wished for, which is quicker: to its tolerance from above, and
    // any number under `below` that the room does not exceed. NULL: `at` does
    double (*roughly)(void *context, scope_state *state, const double *q,
                      const clearance_wish *wish, double *s);
} room_probe;

double room_roughly(const room_probe *room, scope_state *state, const double *q,
                    const clearance_wish *wish, double *s);

typedef struct search_options {
    double tolerance;  // of the tip [m]
    double resolution; // boxes in which the body moves by less are not divided [m]
    int most_looks;    // at the room, per target; most are spent on those that stay undecided
} search_options;

search_options search_options_default(void);

typedef enum search_verdict {
    SEARCH_REACHED,
    SEARCH_OUT_OF_REACH, // no joints within the limits bring the tip near, and no limit is why
    SEARCH_JOINT_LIMIT,  // the limit of `joint` keeps the tip away
    SEARCH_COLLISION,    // the tip comes there, the body does not: it is least free at s
} search_verdict;

typedef struct search_answer {
    int verdict;       // search_verdict
    inverse_pose pose; // reached: that of the most room found; collision: of the least depth; else
                       // the nearest
    double room, s;    // of that pose [m]; of one that is too far NAN
    // No pose whose tip is near has more room than this [m]. Under 0: the target is proved not to
    // be reached; else no pose was found that does, and none has more room than a few times the
    // resolution, unless the looks ran out: not decided. INFINITY: not known, the search was from
    // starts.
    double bound;
    int joint; // of the verdict SEARCH_JOINT_LIMIT, else -1
    int looks, starts;
} search_answer;

status search_solve(const inverse *inv, scope_state *state, vec3 target, const room_probe *room,
                    const search_options *options, search_answer *out);
