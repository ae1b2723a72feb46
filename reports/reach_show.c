// reports/reach_show.c
#include "reports/reach_show.h"

#include "reach/reach_case.h"
#include "reach/scope_room.h"

#include <math.h>
#include <stdio.h>

const char *reach_joint_words(const reach_scope_result *s, int joint, char *words, size_t room)
{
    static const char *const names[] = {"insertion", "turn", "bend"};
    if (joint < SCOPE_BEND || s->arc) {
        return names[joint < SCOPE_BEND ? joint : SCOPE_BEND];
    }
    (void)snprintf(words, room, "tension %d", joint - SCOPE_BEND + 1);
    return words;
}

const char *reach_joint_unit(const reach_scope_result *s, int joint)
{
    return joint == SCOPE_INSERTION ? "m" : joint == SCOPE_TURN || s->arc ? "rad" : "N";
}

// the line's own points are on it but for rounding
static const double on_entry = 1e-9;

reach_part reach_part_of(const reach_result *r, const reach_answer *a, int point)
{
    const double *p = a->point[point];
    const vec3 x = mat3_tmul_vec(r->entry.R, vec3_sub((vec3){{p[0], p[1], p[2]}}, r->entry.p));
    const double beyond = fmax(x.a[2] - r->entry_free, 0);
    if (!(hypot(hypot(x.a[0], x.a[1]), beyond) <= SCOPE_CHANNEL_PLAY)) {
        return REACH_LOOKED_AT;
    }
    return x.a[2] < -on_entry ? REACH_OUTSIDE : r->entry_free > 0 ? REACH_CHANNEL : REACH_LOOKED_AT;
}

const char *reach_part_words(reach_part part)
{
    return part == REACH_OUTSIDE ? "outside" : part == REACH_CHANNEL ? "channel" : "looked at";
}

bool reach_one_bend(const reach_scope_result *s)
{
    int n = 0;
    for (int i = SCOPE_BEND; i < s->njoint; i++) {
        n += s->low[i] < s->high[i];
    }
    return n <= 1;
}

// Half the spacing from any bend one was looked at, and the one told of is nearer than its
// neighbours but for a spacing.
static const double of_spacing = 1.5;

static bool no_arc_comes_near(const reach_result *r, const reach_scope_result *s,
                              const reach_answer *a)
{
    const bool far =
        a->verdict == REACH_OUT_OF_REACH || (a->verdict == REACH_JOINT_LIMIT && a->joint >= 0);
    return far && s->arc && a->miss - of_spacing * s->spacing > r->tolerance;
}

bool reach_is_proved(const reach_result *r, const reach_scope_result *s, const reach_answer *a)
{
    return (a->verdict == REACH_COLLISION && a->bound < r->clearance) || no_arc_comes_near(r, s, a);
}

bool reach_is_open(const reach_result *r, const reach_scope_result *s, const reach_answer *a)
{
    return a->verdict == REACH_COLLISION && !reach_is_proved(r, s, a);
}

int reach_open_count(const reach_result *r, const reach_scope_result *s)
{
    int n = 0;
    for (int i = 0; i < r->ntarget; i++) {
        n += reach_is_open(r, s, &s->answer[i]);
    }
    return n;
}

const char *reach_told_words(const reach_result *r, const reach_scope_result *s,
                             const reach_answer *a)
{
    return reach_is_open(r, s, a) ? "collision, not proved" : reach_verdict_words(a->verdict);
}

static void not_near_words(const reach_result *r, const reach_scope_result *s,
                           const reach_answer *a, char *words, size_t room)
{
    if (s->arc) {
        (void)snprintf(words, room,
                       "%severy bend was looked at, in closed form, tips %.3g mm apart",
                       reach_is_proved(r, s, a) ? "proved: " : "", 1e3 * s->spacing);
    } else if (reach_one_bend(s)) {
        (void)snprintf(words, room,
                       "every bend was looked at, by cubics through tips %.3g mm apart",
                       1e3 * s->spacing);
    } else {
        (void)snprintf(words, room, "%d starts, tips %.3g mm apart: not proved", a->starts,
                       1e3 * s->spacing);
    }
}

static void no_room_words(const reach_result *r, const reach_scope_result *s, const reach_answer *a,
                          char *words, size_t room)
{
    if (reach_is_proved(r, s, a)) {
        (void)snprintf(words, room,
                       "proved: no pose near has more clearance than %.3g mm (%d looks)",
                       1e3 * a->bound, a->looks);
    } else if (isfinite(a->bound)) {
        (void)snprintf(
            words, room,
            "none found in %d looks; proved only that none has more clearance than %.3g mm "
            "(steps down to %.3g mm)",
            a->looks, 1e3 * a->bound, 1e3 * r->resolution);
    } else {
        (void)snprintf(words, room,
                       "none found in %d looks from %d starts, tips %.3g mm apart: "
                       "not proved",
                       a->looks, a->starts, 1e3 * s->spacing);
    }
}

const char *reach_search_words(const reach_result *r, const reach_scope_result *s,
                               const reach_answer *a, char *words, size_t room)
{
    words[0] = '\0';
    switch (a->verdict) {
    case REACH_OUT_OF_REACH:
    case REACH_JOINT_LIMIT:
        not_near_words(r, s, a, words, room);
        break;
    case REACH_COLLISION:
        no_room_words(r, s, a, words, room);
        break;
    case REACH_NO_WAY:
        (void)snprintf(words, room, "a way in was looked for in steps of %.3g mm: not proved",
                       1e3 * r->resolution);
        break;
    default:
        break;
    }
    return words;
}

const char *reach_checked_words(const reach_result *r)
{
    return r->path == REACH_INSERTION
               ? "the final poses and a way in to each of them, on which no part of the body "
                 "touches"
               : "final poses only, as the paper does: not whether the scope gets there without "
                 "touching";
}

int reach_best_scope(const reach_result *r)
{
    int best = -1;
    for (int i = 0; i < r->nscope; i++) {
        const reach_scope_result *s = &r->scope[i], *b = best >= 0 ? &r->scope[best] : NULL;
        if (!b || s->nreached > b->nreached ||
            (s->nreached == b->nreached && s->area_reached > b->area_reached)) {
            best = i;
        }
    }
    return best;
}
