// app/reach_run.c
// Which targets a scope reaches, docs/theory.md section 10: search, then what is told of the pose.
#include "app/reach_run.h"

#include "app/reach_target.h"
#include "app/reach_tell.h"
#include "base/memory.h"
#include "base/team.h"
#include "reach/reach_map.h"

#include <math.h>
#include <string.h>
#include <sys/resource.h>

// A resolution is a twentieth of the tolerance: what is left undivided is far less than what the
// tip may be off.
static const double of_tolerance = 0.05;

double reach_resolution(double tolerance)
{
    return fmin(search_options_default().resolution, of_tolerance * tolerance);
}

// --- all targets

static status heard(void *context, int done, int count)
{
    const reach_work *w = context;
    char words[120];
    (void)count;
    (void)snprintf(words, sizeof words, "scope %.60s: %d of %d targets", w->scope->scope.name,
                   w->first + done, w->how->scene->ntarget);
    if (w->how->cmd) {
        command_progress(w->how->cmd, words);
    }
    return OK;
}

// targets at a time: a way in takes 40 kB
enum { CHUNK = 256 };

static status keep_found(const reach_work *w, const target_found *found, reach_answer *a)
{
    status st = OK;
    const bool body = w->how->bodies && found->answer.verdict != REACH_FAILED;
    *a = found->answer;
    TRY(reach_answer_room(a, body ? REACH_BODY_POINTS : 0, found->npath));
    memcpy(a->path, found->path, (size_t)found->npath * sizeof *a->path);

done:
    return st;
}

static status search_all(reach_work *w, reach_scope_result *out)
{
    status st = OK;
    const team_options team = {.workers = w->how->workers, .heard = heard, .context = w};
    const size_t size = target_found_size(w);
    const int ntarget = w->how->scene->ntarget;
    unsigned char *found = NULL;
    TRY(TAKE(found, CHUNK * size));
    for (w->first = 0; w->first < ntarget; w->first += CHUNK) {
        const int n = ntarget - w->first < CHUNK ? ntarget - w->first : CHUNK;
        memset(found, 0, CHUNK * size);
        TRY(team_map(reach_target, w, n, size, &team, found));
        for (int i = 0; i < n; i++) {
            const target_found *one =
                (const target_found *)(const void *)(found + (size_t)i * size);
            TRY(keep_found(w, one, &out->answer[w->first + i]));
        }
    }

done:
    free(found);
    return st;
}

// --- the map

static bool map_heard(void *context, double share)
{
    const reach_work *w = context;
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
static status study_map(reach_work *w, reach_scope_result *out)
{
    status st = OK;
    const reach_study *how = w->how;
    const reach_case *r = &how->c->file.reach;
    reach_map_options options = reach_map_options_default();
    reach_map_answer found = {.state = out->state};
    options.near = w->scope->scope.radius + r->clearance + r->tolerance;
    options.stop = map_heard;
    options.context = w;
    options.most_looks = how->map_looks > 0 ? how->map_looks : options.most_looks;
    options.resolution = how->map_looks > 0 ? how->map_resolution : options.resolution;
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

static void tell_scope(const reach_work *w, reach_scope_result *out)
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
    reach_work w = {0};
    const int ntarget = how->scene->ntarget;
    const double begin = cpu_seconds();
    TRY(reach_work_make(how, s, &w));
    tell_scope(&w, out);
    TRY(search_all(&w, out));
    TRY(reach_tell_strains(how, s, w.strains, out));
    for (int i = 0; i < ntarget; i++) {
        TRY(how->bodies ? reach_tell_body(how, w.state, &out->answer[i]) : OK);
        reach_tell_reason(how, s, &out->answer[i]);
    }
    count_reached(ntarget, out);
    TRY(how->nmap > 0 ? study_map(&w, out) : OK);
    reach_tell_tendons(s, ntarget, out);
    out->seconds = cpu_seconds() - begin;

done:
    reach_work_free(&w);
    return st;
}

// --- the maps of several scopes, side by side

typedef struct maps {
    reach_study how; // without progress, which a worker does not tell
    const command *cmd;
    reach_scope *scope;
} maps;

// plain bytes, as a worker hands them over
typedef struct map_found {
    reach_scope_result told; // numbers of the map alone
    int state[];             // [nmap]
} map_found;

static status map_of_scope(void *context, int item, void *result)
{
    status st = OK;
    const maps *m = context;
    map_found *found = result;
    reach_work w = {0};
    const double begin = cpu_seconds();
    found->told = (reach_scope_result){.state = found->state};
    TRY(reach_work_make(&m->how, &m->scope[item], &w));
    TRY(study_map(&w, &found->told));
    found->told.seconds = cpu_seconds() - begin;

done:
    reach_work_free(&w);
    return reach_scope_tell(m->how.c, m->scope[item].said, st);
}

static status maps_heard(void *context, int done, int count)
{
    const maps *m = context;
    char words[80];
    (void)snprintf(words, sizeof words, "reach maps: %d of %d scopes", done, count);
    if (m->cmd) {
        command_progress(m->cmd, words);
    }
    return OK;
}

static void keep_map(int nmap, const map_found *found, reach_scope_result *out)
{
    memcpy(out->state, found->state, (size_t)nmap * sizeof *out->state);
    out->area_reached = found->told.area_reached;
    out->area_undecided = found->told.area_undecided;
    out->area_error = found->told.area_error;
    out->map_spacing = found->told.map_spacing;
    out->seconds += found->told.seconds;
}

status reach_study_maps(const reach_study *how, int n, reach_scope *scopes, reach_scope_result *out)
{
    status st = OK;
    maps m = {.how = *how, .cmd = how->cmd, .scope = scopes};
    const team_options team = {.workers = how->workers, .heard = maps_heard, .context = &m};
    // a whole number of structs, so that each begins where one may
    const size_t states = (size_t)how->nmap * sizeof(int), one = sizeof(map_found);
    const size_t size = one + (states + one - 1) / one * one;
    unsigned char *found = NULL;
    m.how.cmd = NULL;
    m.how.bodies = false; // no pose is told, and no strain of one
    TRY(TAKE(found, (size_t)n * size));
    TRY(team_map(map_of_scope, &m, n, size, &team, found));
    for (int i = 0; i < n; i++) {
        keep_map(how->nmap, (const map_found *)(const void *)(found + (size_t)i * size), &out[i]);
    }

done:
    free(found);
    return st;
}
