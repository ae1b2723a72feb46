// app/reach_run.c
// Which targets a scope reaches, docs/theory.md section 10: search, then what is told of the pose.
#include "app/reach_run.h"

#include "app/reach_tell.h"
#include "base/memory.h"
#include "base/team.h"
#include "reach/reach_map.h"
#include "reach/scope_room.h"

#include <math.h>
#include <string.h>
#include <sys/resource.h>

// Parts of the resolution: how well a look knows the body's room, which is from above, so that what
// is proved is proved; and how well that of a pose is known that is told, which decides.
static const double of_look = 0.05, of_answer = 0.005;

// A resolution is a twentieth of the tolerance: what is left undivided is far less than what the
// tip may be off.
static const double of_tolerance = 0.05;

double reach_resolution(double tolerance)
{
    return fmin(search_options_default().resolution, of_tolerance * tolerance);
}

// --- one target, in a worker

typedef struct scope_work {
    const reach_study *how;
    const reach_scope *scope;
    inverse *inverse;
    scope_state *state;
    scope_room room;
    room_probe probe; // of that
    search_options options;
    int first; // target of the first item
} scope_work;

static status measure_pose(const scope_work *w, reach_answer *a)
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

static status search_target(const scope_work *w, vec3 target, reach_answer *a)
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

static status one_target(void *context, int item, void *result)
{
    const scope_work *w = context;
    reach_answer *a = result;
    const double *p = w->how->scene->target[w->first + item];
    *a = (reach_answer){.clearance = NAN,
                        .s = NAN,
                        .miss = NAN,
                        .bound = INFINITY,
                        .joint = -1,
                        .strain = NAN,
                        .path_clearance = NAN};
    const status st = search_target(w, (vec3){{p[0], p[1], p[2]}}, a);
    if (st == ERR_NUMERIC) {
        a->verdict = REACH_FAILED;
        (void)snprintf(a->why, sizeof a->why, "%s", status_message());
        status_clear();
        return OK;
    }
    return st;
}

// --- all targets

static status heard(void *context, int done, int count)
{
    const scope_work *w = context;
    char words[120];
    (void)snprintf(words, sizeof words, "scope %.60s: %d of %d targets", w->scope->scope.name, done,
                   count);
    if (w->how->cmd) {
        command_progress(w->how->cmd, words);
    }
    return OK;
}

static status make_work(const reach_study *how, const reach_scope *s, scope_work *w)
{
    status st = OK;
    const reach_case *r = &how->c->file.reach;
    const double skin = r->tip == REACH_TIP_SKIN ? s->scope.radius : 0;
    const double resolution = reach_resolution(r->tolerance);
    *w = (scope_work){.how = how, .scope = s, .options = search_options_default()};
    w->options.tolerance = r->tolerance + skin;
    w->options.resolution = resolution;
    w->room = (scope_room){.tree = how->scene->tree,
                           .tolerance = of_look * resolution,
                           .free_entry = how->scene->free,
                           .shaft_free = how->scene->shaft_free,
                           .leave = r->clearance};
    w->probe = scope_room_probe(&w->room);
    TRY(scope_state_make(&s->scope, &how->scene->entry, &w->state));
    TRY(inverse_make(&s->scope, &w->inverse));

done:
    return st;
}

// --- the map

static bool map_heard(void *context, double share)
{
    const scope_work *w = context;
    char words[120];
    (void)snprintf(words, sizeof words, "scope %.60s: reach map, %.0f %%", w->scope->scope.name,
                   100 * share);
    if (w->how->cmd) {
        command_progress(w->how->cmd, words);
    }
    return false;
}

static double share_of(const reach_study *how, const reach_scope_result *r, int state)
{
    int n = 0;
    for (int i = 0; i < how->nmap; i++) {
        n += r->state[i] == state;
    }
    return (double)n / how->nmap;
}

// a place of the wall is reached where the tip's skin comes within the tolerance of what is to be
// left
static status study_map(scope_work *w, reach_scope_result *out)
{
    status st = OK;
    const reach_study *how = w->how;
    const reach_case *r = &how->c->file.reach;
    reach_map_options options = reach_map_options_default();
    reach_map_answer found = {.state = out->state};
    options.near = w->scope->scope.radius + r->clearance + r->tolerance;
    options.stop = map_heard;
    options.context = w;
    TRY(reach_map(w->inverse, w->state, &w->probe, how->nmap, how->map, &options, &found));
    out->area_reached = share_of(how, out, MAP_REACHED);
    out->area_undecided = share_of(how, out, MAP_UNDECIDED);
    out->area_error = sqrt(out->area_reached * (1 - out->area_reached) / how->nmap);
    out->map_spacing = found.spacing;

done:
    return st;
}

static double cpu_seconds(void)
{
    double sum = 0;
    for (int who = 0; who < 2; who++) {
        struct rusage use;
        if (getrusage(who == 0 ? RUSAGE_SELF : RUSAGE_CHILDREN, &use) == 0) {
            sum += (double)use.ru_utime.tv_sec + 1e-6 * (double)use.ru_utime.tv_usec;
        }
    }
    return sum;
}

static void tell_scope(const scope_work *w, reach_scope_result *out)
{
    const scope *s = &w->scope->scope;
    (void)snprintf(out->name, sizeof out->name, "%s", s->name);
    (void)snprintf(out->kind, sizeof out->kind, "%s", w->scope->kind);
    (void)snprintf(out->limit_note, sizeof out->limit_note, "%s", w->scope->limit_note);
    out->arc = !s->rod;
    out->length = s->length;
    out->radius = s->radius;
    out->njoint = s->njoint;
    memcpy(out->low, s->low, sizeof out->low);
    memcpy(out->high, s->high, sizeof out->high);
    out->spacing = inverse_spacing(w->inverse);
}

static void count_reached(int ntarget, reach_scope_result *out)
{
    out->nreached = 0;
    for (int i = 0; i < ntarget; i++) {
        out->nreached += out->answer[i].verdict == REACH_REACHED;
    }
}

status reach_study_scope(const reach_study *how, reach_scope *s, reach_scope_result *out)
{
    status st = OK;
    scope_work w = {0};
    const int ntarget = how->scene->ntarget;
    const double begin = cpu_seconds();
    TRY(make_work(how, s, &w));
    tell_scope(&w, out);
    const team_options team = {.workers = how->workers, .heard = heard, .context = &w};
    TRY(team_map(one_target, &w, ntarget, sizeof *out->answer, &team, out->answer));
    TRY(reach_tell_strains(how, s, out));
    for (int i = 0; i < ntarget; i++) {
        TRY(how->bodies ? reach_tell_body(how, w.state, &out->answer[i]) : OK);
        reach_tell_reason(how, s, &out->answer[i]);
    }
    count_reached(ntarget, out);
    TRY(how->nmap > 0 ? study_map(&w, out) : OK);
    out->seconds = cpu_seconds() - begin;

done:
    inverse_free(w.inverse);
    scope_state_free(w.state);
    return st;
}
