// app/reach_target.c
#include "app/reach_target.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

// Parts of the resolution: how well a look knows the body's room, which is from above, so that what
// is proved is proved; how well that of a pose is known that is told, which decides; and that of a
// way's poses.
static const double of_look = 0.05, of_answer = 0.005, of_way = 0.5;

// looks at the room for one way in
enum { WAY_LOOKS = 20000 };

// --- what the work needs

status reach_work_make(const reach_study *how, reach_scope *s, reach_work *w)
{
    status st = OK;
    const reach_case *r = &how->c->file.reach;
    const double skin = r->tip == REACH_TIP_SKIN ? s->scope.radius : 0;
    const double resolution = reach_resolution(r->tolerance);
    *w = (reach_work){.how = how, .scope = s, .options = search_options_default()};
    w->options.tolerance = r->tolerance + skin;
    w->options.resolution = resolution;
    w->room = (scope_room){.tree = how->scene->tree,
                           .tolerance = of_look * resolution,
                           .free_entry = how->scene->free,
                           .shaft_free = how->scene->shaft_free,
                           .leave = r->clearance};
    w->probe = scope_room_probe(&w->room);
    if (s->v && (how->bodies || s->said->strain_limit)) {
        TRY(reach_strain_probe_make(s, &w->strains));
    }
    if (reach_strain_is_searched(s)) {
        w->probe = strained_room_probe(w->strains, &w->room, &w->strained);
    }
    TRY(scope_state_make(&s->scope, &how->scene->entry, &w->state));
    TRY(inverse_make(&s->scope, &w->inverse));

done:
    return st;
}

void reach_work_free(reach_work *w)
{
    reach_strain_probe_free(w->strains);
    inverse_free(w->inverse);
    scope_state_free(w->state);
    *w = (reach_work){0};
}

static bool wants_way(const reach_work *w)
{
    return w->how->c->file.reach.path == REACH_INSERTION;
}

size_t target_found_size(const reach_work *w)
{
    return wants_way(w) ? sizeof(target_found) : offsetof(target_found, path);
}

// --- a target

static status measure_pose(const reach_work *w, reach_answer *a)
{
    status st = OK;
    clearance c = {0};
    scope_room fine = w->room;
    fine.tolerance *= of_answer / of_look;
    TRY(scope_bend(w->state, a->q));
    scope_clearance(&fine, w->state, a->q, &c);
    a->clearance = c.least;
    a->s = c.s;
    a->verdict = c.least >= w->room.leave ? REACH_REACHED : REACH_COLLISION;

done:
    return st;
}

static status search_target(const reach_work *w, vec3 target, reach_answer *a)
{
    status st = OK;
    search_answer found;
    TRY(search_solve(w->inverse, w->state, target, &w->probe, &w->options, &found));
    a->verdict = found.verdict;
    memcpy(a->q, found.pose.q, sizeof a->q);
    a->miss = found.pose.miss;
    a->bound = found.bound + w->room.leave;
    a->joint = found.joint;
    a->looks = found.looks;
    a->starts = found.starts;
    if (found.verdict == SEARCH_REACHED || found.verdict == SEARCH_COLLISION) {
        TRY(measure_pose(w, a));
    }

done:
    return st;
}

// the same pose with all that is before it
static status find_way(const reach_work *w, target_found *out)
{
    status st = OK;
    way_answer way;
    scope_room coarse = w->room;
    coarse.tolerance *= of_way / of_look;
    const room_probe probe = scope_room_probe(&coarse);
    reach_answer *a = &out->answer;
    TRY(way_find(w->state, &probe, a->q, 0, w->options.resolution, WAY_LOOKS, &way));
    a->path_clearance = way.room + w->room.leave;
    if (!way.found) {
        a->verdict = REACH_NO_WAY;
        return OK;
    }
    out->npath = way.npose;
    memcpy(out->path, way.q, (size_t)way.npose * sizeof *out->path);

done:
    return st;
}

status reach_target(void *context, int item, void *result)
{
    const reach_work *w = context;
    target_found *found = result;
    reach_answer *a = &found->answer;
    const double *p = w->how->scene->target[w->first + item];
    *a = (reach_answer){.clearance = NAN,
                        .s = NAN,
                        .miss = NAN,
                        .bound = INFINITY,
                        .joint = -1,
                        .strain = NAN,
                        .path_clearance = NAN};
    status st = search_target(w, (vec3){{p[0], p[1], p[2]}}, a);
    if (st == OK && a->verdict == REACH_REACHED && wants_way(w)) {
        st = find_way(w, found);
    }
    if (st == ERR_NUMERIC) {
        a->verdict = REACH_FAILED;
        (void)snprintf(a->why, sizeof a->why, "%s", status_message());
        status_clear();
        return OK;
    }
    return st;
}
