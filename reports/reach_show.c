// reports/reach_show.c
#include "reports/reach_show.h"

#include "reach/reach_case.h"

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

bool reach_is_proved(const reach_result *r, const reach_answer *a)
{
    return a->verdict == REACH_COLLISION && a->bound < r->clearance;
}

static void not_near_words(const reach_scope_result *s, const reach_answer *a, char *words,
                           size_t room)
{
    if (s->njoint == SCOPE_BEND + 1) {
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
    if (reach_is_proved(r, a)) {
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
        not_near_words(s, a, words, room);
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
