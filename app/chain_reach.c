// app/chain_reach.c
// Which targets the scopes of a case reach: files, scopes, searches, the result.
#include "app/chain.h"
#include "app/reach_case.h"
#include "app/reach_run.h"
#include "app/warnings.h"
#include "base/memory.h"
#include "reach/reach_map.h"

#include <string.h>

static void file_name(const char *path, char *name, size_t room)
{
    const char *slash = strrchr(path, '/');
    (void)snprintf(name, room, "%s", slash ? slash + 1 : path);
}

static status tell_scene(const case_data *c, const reach_scene *scene, int nscope,
                         reach_result *out)
{
    status st = OK;
    const reach_case *r = &c->file.reach;
    const surface *s = &scene->tissue;
    const reach_result sizes = {.nvertex = s->nvertex,
                                .ntriangle = s->ntriangle,
                                .ntarget = scene->ntarget,
                                .nmap = mark_given(r->map.at) ? r->map.points : 0,
                                .nscope = nscope};
    TRY(reach_result_make(&sizes, out));
    memcpy(out->vertex, s->vertex, (size_t)s->nvertex * sizeof *s->vertex);
    memcpy(out->triangle, s->triangle, (size_t)s->ntriangle * sizeof *s->triangle);
    if (scene->ntarget > 0) {
        const size_t n = (size_t)scene->ntarget;
        memcpy(out->target_name, scene->name, n * sizeof *scene->name);
        memcpy(out->target, scene->target, n * sizeof *scene->target);
        memcpy(out->target_depth, scene->depth, n * sizeof *scene->depth);
    }
    out->map_seed = r->map.seed;
    TRY(out->nmap > 0 ? surface_samples(s, out->nmap, r->map.seed, out->map_point) : OK);
    (void)snprintf(out->source, sizeof out->source, "%s", r->source ? r->source : "");
    file_name(scene->path, out->tissue, sizeof out->tissue);
    out->synthetic = r->synthetic;
    out->area = s->area;
    out->volume = s->volume;
    out->entry = scene->entry;
    out->entry_free = scene->free;
    out->tolerance = r->tolerance;
    out->clearance = r->clearance;
    out->resolution = reach_resolution(r->tolerance);
    out->tip = r->tip;
    out->path = r->path;
    out->paper = r->paper;

done:
    return st;
}

// what a channel leads through lies before the tissue's own space
static void warn_entry(const command *cmd, const case_data *c, const reach_scene *scene)
{
    const double inside = distance_to(scene->tree, scene->entry.p).distance;
    if (inside > 0) {
        warn_at(cmd, c, c->file.reach.entry.at,
                "the entry point lies in the hollow already, %.3g mm from its wall: nothing of the "
                "way there is looked at",
                1e3 * inside);
    }
}

// extra NULL: scope i of the case. Where it fails *s is closed.
static status run_scope(const reach_study *how, variation *base, int i, const reach_extra *extra,
                        reach_scope *s, reach_scope_result *out)
{
    status st = OK;
    TRY(reach_scope_make(how->c, base, i, extra ? extra->more : NULL, s));
    if (extra) {
        (void)snprintf(s->scope.name, sizeof s->scope.name, "%s", extra->name);
    }
    st = reach_scene_fits(how->c, how->scene, s->scope.length);
    st = st != OK ? st : reach_study_scope(how, s, out);
    if (st != OK) {
        reach_scope_free(s);
    }
    TRY(reach_scope_tell(how->c, case_scope(how->c, i), st));

done:
    return st;
}

// A scope's targets are shared out over the cores, one scope after the other; then the scopes'
// maps.
static status run_scopes(const reach_study *how, variation *base, int n, const reach_extra *extra,
                         reach_scope_result *out)
{
    status st = OK;
    reach_study targets = *how;
    reach_scope *s = NULL;
    const int all = n + (extra ? 1 : 0);
    int open = 0;
    targets.nmap = all > 1 ? 0 : how->nmap; // alone it tells how far it is
    TRY(TAKE(s, (size_t)all));
    for (int i = 0; i < all; i++, open++) {
        const bool own = i < n;
        TRY(run_scope(&targets, base, own ? i : extra->scope, own ? NULL : extra, &s[i], &out[i]));
    }
    TRY(all > 1 && how->nmap > 0 ? reach_study_maps(how, all, s, out) : OK);

done:
    for (int i = 0; i < open; i++) {
        reach_scope_free(&s[i]);
    }
    free(s);
    return st;
}

status chain_reach_with(const command *cmd, const case_data *c, const reach_extra *extra,
                        run_result *out)
{
    status st = OK;
    reach_scene scene = {0};
    variation base = {0};
    const int n = c->file.reach.scopes.count;
    reach_study how = {.c = c, .scene = &scene, .cmd = cmd, .bodies = true};
    command_progress(cmd, "tissue and targets");
    TRY(reach_scene_open(c, &scene));
    warn_entry(cmd, c, &scene);
    TRY(tell_scene(c, &scene, n + (extra ? 1 : 0), &out->reach));
    how.nmap = out->reach.nmap;
    how.map = (const double(*)[3])out->reach.map_point;
    TRY(reach_base_open(c, out->has_section ? &out->section : NULL, &base));
    TRY(run_scopes(&how, &base, n, extra, out->reach.scope));

done:
    variation_free(&base);
    reach_scene_free(&scene);
    return st;
}

status chain_reach(const command *cmd, const case_data *c, run_result *out)
{
    return chain_reach_with(cmd, c, NULL, out);
}
