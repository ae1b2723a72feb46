// tests/unit/fem/test_segment_case.c
// Contradictions between loads, ends, springs and holds; what a case's entries become.
#include "fem/segment.h"
#include "tests/test.h"

#include <math.h>
#include <string.h>

// the first choices of the key `face`
enum { ON_BASE, ON_TIP, ON_OUTSIDE, ON_INSIDE, ON_HOLE_1 };

typedef struct made_case {
    segment_case c;
    segment_load load[2];
    segment_pressure pressure;
    segment_spring spring;
    segment_hold hold;
    double held[3], moved[3], turned[3];
} made_case;

// 20 mm, a push at the tip; nothing else is asked for
static void make(made_case *m)
{
    *m = (made_case){.c = segment_case_default()};
    m->c.at = (mark){3, 1};
    m->c.length = 20e-3;
    m->load[0] =
        (segment_load){.at = {10, 5}, .name = "push", .force = {0, 0, -0.5}, .at_kind = -1};
    m->c.loads = (key_list){.count = 1, .items = m->load};
    m->pressure = (segment_pressure){
        .at = {20, 9}, .face = ON_INSIDE, .range = {0, INFINITY}, .pressure = 1e4};
    m->spring =
        (segment_spring){.at = {30, 9}, .face = ON_OUTSIDE, .range = {0, INFINITY}, .normal = 1e9};
    m->hold = (segment_hold){.at = {40, 9}, .face = ON_OUTSIDE, .range = {0, INFINITY}};
    m->hold.motion = (key_rows){.nrow = 1, .ncol = 3, .a = m->held};
}

static void add_pressure(made_case *m)
{
    m->load[0].pressures = (key_list){.count = 1, .items = &m->pressure};
}

static void add_spring(made_case *m)
{
    m->c.springs = (key_list){.count = 1, .items = &m->spring};
}

static void add_hold(made_case *m)
{
    m->c.holds = (key_list){.count = 1, .items = &m->hold};
}

static void add_motion(made_case *m)
{
    m->load[0].tip_motion = (segment_motion){
        .at = {50, 9},
        .translation = {.nrow = 1, .ncol = 3, .a = m->moved},
        .rotation = {.nrow = 1, .ncol = 3, .a = m->turned},
    };
    for (int d = 0; d < 3; d++) {
        m->moved[d] = m->turned[d] = NAN;
    }
}

static void passes(const made_case *m)
{
    mark where = {0};
    CHECK_OK(segment_case_check(&m->c, &where));
}

static void fails_at(const made_case *m, int line, const char *words)
{
    mark where = {0};
    CHECK(segment_case_check(&m->c, &where) == ERR_INPUT);
    CHECK(where.line == line);
    CHECK(strstr(status_message(), words) != NULL);
    if (!strstr(status_message(), words)) {
        fprintf(stderr, "%s\n", status_message());
    }
    status_clear();
}

static void everything_that_acts_is_a_load(void)
{
    made_case m;
    make(&m);
    memset(m.load[0].force, 0, sizeof m.load[0].force);
    fails_at(&m, 10, "nor anything else that acts");
    add_pressure(&m);
    passes(&m);
    m.load[0].pressures.count = 0;
    m.load[0].body_force[1] = 3;
    passes(&m);
    m.load[0].body_force[1] = 0;
    m.load[0].acceleration[2] = -9.81;
    passes(&m);
    m.c.way = WAY_DOUBLING;
    fails_at(&m, 10, "method doubling");
}

static void faces_lie_on_the_segment(void)
{
    made_case m;
    make(&m);
    add_pressure(&m);
    m.pressure.range[0] = 5e-3;
    m.pressure.range[1] = 20e-3;
    passes(&m);
    m.pressure.range[1] = 21e-3;
    fails_at(&m, 20, "21 mm lies beyond the segment's 20 mm");
    m.pressure.range[1] = 5e-3;
    fails_at(&m, 20, "no part of a wall");
    m.pressure.range[1] = INFINITY;
    m.pressure.range[0] = 20e-3;
    fails_at(&m, 20, "beyond");
    m.pressure.face = ON_TIP;
    fails_at(&m, 20, "an end has no heights");
    m.pressure.range[0] = 0;
    passes(&m);
    m.pressure.face = ON_BASE;
    fails_at(&m, 20, "on the base, which is held");
    m.pressure.face = ON_HOLE_1;
    m.pressure.pressure = 0;
    fails_at(&m, 20, "a pressure of zero");
}

static void a_free_base_needs_a_hold(void)
{
    made_case m;
    make(&m);
    m.c.base = BASE_FREE;
    fails_at(&m, 3, "nothing else holds");
    add_spring(&m);
    passes(&m);
    m.spring.normal = 0;
    fails_at(&m, 30, "no stiffness");
    m.c.springs.count = 0;
    add_hold(&m);
    m.hold.face = ON_BASE;
    passes(&m);
    m.c.base = BASE_CLAMPED;
    fails_at(&m, 40, "on the base, which is held");
}

static void a_free_tip_takes_nothing(void)
{
    made_case m;
    make(&m);
    m.c.tip = TIP_FREE;
    fails_at(&m, 10, "nothing acts on a free tip");
    memset(m.load[0].force, 0, sizeof m.load[0].force);
    add_pressure(&m);
    passes(&m);
    add_motion(&m);
    m.moved[2] = 1e-3;
    fails_at(&m, 50, "a motion needs a tip");
    m.load[0].tip_motion.at.line = 0;
    m.load[0].tip_motion.translation.nrow = m.load[0].tip_motion.rotation.nrow = 0;
    m.c.tip_spring = (segment_tip_spring){.at = {60, 3}, .translation = {1, 0, 0}};
    fails_at(&m, 60, "a spring needs a tip");
    m.c.tip = TIP_RIGID;
    passes(&m);
    m.c.tip_spring.translation[0] = 0;
    fails_at(&m, 60, "no stiffness");
}

static void a_direction_is_moved_or_loaded(void)
{
    made_case m;
    make(&m);
    add_motion(&m);
    fails_at(&m, 50, "leaves every direction free");
    m.moved[0] = 1e-3;
    passes(&m);
    m.moved[2] = 0;
    fails_at(&m, 50, "a motion and a force along z in the same direction");
    m.load[0].force[2] = 0;
    passes(&m);
    m.turned[1] = 0.1;
    m.load[0].moment[1] = 1e-3;
    fails_at(&m, 50, "a motion and a moment about y in the same direction");
    m.load[0].moment[1] = 0;
    m.load[0].at_kind = 1;
    fails_at(&m, 50, "leave `at` out");
}

static void motions_of_holds_belong_to_a_load(void)
{
    made_case m;
    make(&m);
    m.load[0].holds_move = true;
    fails_at(&m, 10, "no `holds` to move");
    add_hold(&m);
    fails_at(&m, 10, "every hold's motion is zero");
    m.held[1] = 2e-3;
    passes(&m);
    m.load[0].holds_move = false;
    fails_at(&m, 40, "the hold moves in no load");
    m.held[0] = m.held[1] = m.held[2] = NAN;
    fails_at(&m, 40, "leaves every direction free");
    m.held[1] = 0;
    m.hold.face = ON_TIP;
    fails_at(&m, 40, "rigid cap");
    m.c.tip = TIP_E_PROPORTIONAL;
    passes(&m);
}

static void entries_become_what_solvers_take(void)
{
    made_case m;
    make(&m);
    const face_part base = segment_face_part(ON_BASE, m.hold.range);
    const face_part hole = segment_face_part(ON_HOLE_1 + 2, m.hold.range);
    CHECK(base.face == FACE_BASE && hole.face == FACE_HOLE + 2 && isinf(hole.to));
    m.held[0] = NAN;
    m.held[1] = 0;
    m.held[2] = 3;
    const face_hold hold = segment_face_hold(&m.hold);
    CHECK(hold.on.face == FACE_OUTSIDE && hold.mask == 6);
    CHECK(hold.motion[0] == 0 && hold.motion[1] == 0 && hold.motion[2] == 3);
    double motion[6];
    CHECK(!segment_tip_motion(&m.load[0], motion) && isnan(motion[0]) && isnan(motion[5]));
    add_motion(&m);
    m.turned[0] = 0.5;
    CHECK(segment_tip_motion(&m.load[0], motion) && motion[3] == 0.5 && isnan(motion[2]));
    m.spring.tangential = 4;
    const face_spring spring = segment_face_spring(&m.spring);
    CHECK(!spring.axes && spring.stiffness[0] == 1e9 && spring.stiffness[2] == 4);
    const face_pressure pressure = segment_face_pressure(&m.pressure);
    CHECK(pressure.on.face == FACE_INSIDE && pressure.pressure == 1e4);
}

int main(void)
{
    everything_that_acts_is_a_load();
    faces_lie_on_the_segment();
    a_free_base_needs_a_hold();
    a_free_tip_takes_nothing();
    a_direction_is_moved_or_loaded();
    motions_of_holds_belong_to_a_load();
    entries_become_what_solvers_take();
    return test_failures != 0;
}
