// fem/segment_case_check.c
// Contradictions of the map `fem` that its tables cannot see.
#include "fem/segment.h"

#include <math.h>
#include <string.h>

// what the rounding of a unit may add to a height at the tip, over the length
static const double AT_TIP = 1e-12;

#define FAIL_AT(mark_, ...) status_fail_at(ERR_INPUT, (mark_).line, (mark_).column, __VA_ARGS__)

static bool is_zero(const double *v)
{
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

static bool has_wrench(const segment_load *load)
{
    return !is_zero(load->force) || !is_zero(load->moment);
}

static bool has_place(const segment_load *load)
{
    return mark_given(load->point.at) || load->at_kind >= 0;
}

// --- faces

static status check_part(const segment_case *c, mark at, int face, const double range[2])
{
    const face_part part = segment_face_part(face, range);
    if (part.face < FACE_OUTSIDE && (part.from != 0 || isfinite(part.to))) {
        return FAIL_AT(at, "an end has no heights: leave `from` and `to` out");
    }
    if (part.from >= part.to) {
        return FAIL_AT(at, "from %g to %g mm is no part of a wall", 1e3 * part.from, 1e3 * part.to);
    }
    const double last = isfinite(part.to) ? part.to : part.from;
    if (last > c->length * (1 + AT_TIP) || part.from >= c->length) {
        return FAIL_AT(at, "%g mm lies beyond the segment's %g mm", 1e3 * last, 1e3 * c->length);
    }
    return OK;
}

// the base moves only where it is free
static status check_not_on_base(const segment_case *c, mark at, int face, const double range[2],
                                const char *what)
{
    if (segment_face_part(face, range).face == FACE_BASE && c->base != BASE_FREE) {
        return FAIL_AT(at, "%s on the base, which is held: base is free for that", what);
    }
    return OK;
}

static status check_spring(const segment_case *c, const segment_spring *s)
{
    status st = OK;
    TRY(check_part(c, s->at, s->face, s->range));
    TRY(check_not_on_base(c, s->at, s->face, s->range, "a spring acts"));
    if (s->normal == 0 && s->tangential == 0) {
        st = FAIL_AT(s->at, "the spring has no stiffness: give `normal_N_per_mm3` or "
                            "`tangential_N_per_mm3`");
    }

done:
    return st;
}

static status check_hold(const segment_case *c, const segment_hold *h)
{
    status st = OK;
    const face_hold hold = segment_face_hold(h);
    TRY(check_part(c, h->at, h->face, h->range));
    TRY(check_not_on_base(c, h->at, h->face, h->range, "a hold acts"));
    if (hold.mask == 0) {
        return FAIL_AT(h->at, "the hold leaves every direction free");
    }
    if (hold.on.face == FACE_TIP && c->tip == TIP_RIGID) {
        st = FAIL_AT(h->at, "the tip is a rigid cap: move it by a load's `tip_motion`");
    }

done:
    return st;
}

static bool moves(const segment_hold *h)
{
    const face_hold hold = segment_face_hold(h);
    return !is_zero(hold.motion);
}

// --- supports of the whole

static status check_supports(const segment_case *c)
{
    status st = OK;
    const segment_spring *springs = c->springs.items;
    const segment_hold *holds = c->holds.items;
    for (int i = 0; i < c->springs.count; i++) {
        TRY(check_spring(c, &springs[i]));
    }
    for (int i = 0; i < c->holds.count; i++) {
        TRY(check_hold(c, &holds[i]));
    }
    if (c->base == BASE_FREE && c->springs.count == 0 && c->holds.count == 0) {
        return FAIL_AT(c->at, "fem: the base is free and nothing else holds the segment: give "
                              "`springs` or `holds`");
    }

done:
    return st;
}

static status check_tip_spring(const segment_case *c)
{
    const segment_tip_spring *spring = &c->tip_spring;
    if (!mark_given(spring->at)) {
        return OK;
    }
    if (c->tip == TIP_FREE || c->tip == TIP_UNIFORM) {
        return FAIL_AT(spring->at, "a spring needs a tip that is rigid or E_proportional");
    }
    return is_zero(spring->translation) && is_zero(spring->rotation)
               ? FAIL_AT(spring->at, "the tip's spring has no stiffness")
               : OK;
}

// --- loads

static status check_pressures(const segment_case *c, const segment_load *load)
{
    status st = OK;
    const segment_pressure *p = load->pressures.items;
    for (int i = 0; i < load->pressures.count; i++) {
        TRY(check_part(c, p[i].at, p[i].face, p[i].range));
        TRY(check_not_on_base(c, p[i].at, p[i].face, p[i].range, "a pressure acts"));
        if (p[i].pressure == 0 && is_zero(p[i].traction)) {
            return FAIL_AT(p[i].at, "load '%s': a pressure of zero", load->name);
        }
    }

done:
    return st;
}

// a motion is imposed where no force or moment acts
static status check_motion(const segment_case *c, const segment_load *load)
{
    static const char *const part[6] = {"force along x",  "force along y",  "force along z",
                                        "moment about x", "moment about y", "moment about z"};
    double motion[6];
    const mark at = load->tip_motion.at;
    const bool any = segment_tip_motion(load, motion);
    if (!mark_given(at)) {
        return OK;
    }
    if (!any) {
        return FAIL_AT(at, "load '%s': the tip's motion leaves every direction free", load->name);
    }
    if (c->tip == TIP_FREE || c->tip == TIP_UNIFORM) {
        return FAIL_AT(at, "load '%s': a motion needs a tip that is rigid or E_proportional",
                       load->name);
    }
    if (has_place(load)) {
        return FAIL_AT(at,
                       "load '%s': the tip's motion is that of its geometric centre, where "
                       "forces act too: leave `at` out",
                       load->name);
    }
    for (int i = 0; i < 6; i++) {
        const double acts = i < 3 ? load->force[i] : load->moment[i - 3];
        if (!isnan(motion[i]) && acts != 0) {
            return FAIL_AT(at, "load '%s': a motion and a %s in the same direction", load->name,
                           part[i]);
        }
    }
    return OK;
}

static status check_wrench(const segment_case *c, const segment_load *load)
{
    if (c->tip == TIP_FREE && (has_wrench(load) || has_place(load))) {
        return FAIL_AT(load->at, "load '%s': nothing acts on a free tip", load->name);
    }
    if (c->tip == TIP_UNIFORM && !is_zero(load->moment)) {
        return FAIL_AT(load->at, "load '%s': a uniform traction has no moment", load->name);
    }
    if (c->tip == TIP_UNIFORM && has_place(load)) {
        return FAIL_AT(load->at,
                       "load '%s': a uniform traction acts at the area's centroid; leave `at` out",
                       load->name);
    }
    return OK;
}

// what only the general solvers take: problem_is_plain of load.h
static bool is_plain(const segment_case *c, const segment_load *load)
{
    return load->pressures.count == 0 && is_zero(load->body_force) && is_zero(load->acceleration) &&
           c->springs.count == 0 && c->holds.count == 0;
}

static status check_load(const segment_case *c, const segment_load *load)
{
    status st = OK;
    if (!has_wrench(load) && load->pressures.count == 0 && is_zero(load->body_force) &&
        is_zero(load->acceleration) && !mark_given(load->tip_motion.at) && !load->holds_move) {
        return FAIL_AT(load->at,
                       "load '%s' has neither force nor moment, nor anything else that acts",
                       load->name);
    }
    TRY(check_wrench(c, load));
    TRY(check_motion(c, load));
    TRY(check_pressures(c, load));
    if (load->holds_move && c->holds.count == 0) {
        return FAIL_AT(load->at, "load '%s': there are no `holds` to move", load->name);
    }
    if (c->way == WAY_DOUBLING && !is_plain(c, load)) {
        st = FAIL_AT(load->at,
                     "load '%s': method doubling takes tip loads only, without springs and holds",
                     load->name);
    }

done:
    return st;
}

static const segment_load *find_load(const segment_load *items, int count, const char *name)
{
    for (int i = 0; i < count; i++) {
        if (strcmp(items[i].name, name) == 0) {
            return &items[i];
        }
    }
    return NULL;
}

static status check_loads(const segment_case *c)
{
    status st = OK;
    const segment_load *loads = c->loads.items;
    for (int i = 0; i < c->loads.count; i++) {
        TRY(check_load(c, &loads[i]));
        if (find_load(loads, i, loads[i].name)) {
            return FAIL_AT(loads[i].at, "there are two loads '%s'", loads[i].name);
        }
    }

done:
    return st;
}

// a motion that no load asks for would be passed over, one that moves nothing would be too
static status check_moves(const segment_case *c)
{
    const segment_load *loads = c->loads.items;
    const segment_hold *holds = c->holds.items, *moved = NULL;
    const segment_load *mover = NULL;
    for (int i = 0; i < c->holds.count && !moved; i++) {
        moved = moves(&holds[i]) ? &holds[i] : NULL;
    }
    for (int i = 0; i < c->loads.count && !mover; i++) {
        mover = loads[i].holds_move ? &loads[i] : NULL;
    }
    if (moved && !mover) {
        return FAIL_AT(moved->at, "the hold moves in no load: give one `move_holds: true`");
    }
    if (mover && !moved) {
        return FAIL_AT(mover->at, "load '%s': every hold's motion is zero", mover->name);
    }
    return OK;
}

static status check_mesh(const segment_case *c)
{
    if (c->layers == 1) {
        return FAIL_AT(c->at, "fem: one layer has no middle, layers is 2 or more");
    }
    if (c->grading != 0 && c->grading < 1) {
        return FAIL_AT(c->at, "fem: grading %g is less than 1", c->grading);
    }
    return OK;
}

status segment_case_check(const segment_case *c, mark *where)
{
    status st = OK;
    *where = c->at;
    TRY(check_mesh(c));
    TRY(check_supports(c));
    TRY(check_tip_spring(c));
    TRY(check_loads(c));
    TRY(check_moves(c));

done:
    if (st != OK) {
        (void)status_place(&where->line, &where->column);
    }
    return st;
}
