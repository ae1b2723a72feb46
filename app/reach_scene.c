// app/reach_scene.c
#include "app/reach_scene.h"

#include "app/reach_case.h"
#include "app/reach_run.h"
#include "base/memory.h"
#include "io/disk.h"
#include "measure/table.h"
#include "reach/surface_line.h"
#include "reach/surface_read.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

// --- the tissue

// what is wrong in the file, and where the case names it
static status file_place(const case_data *c, status st, mark at)
{
    char words[1024], place[CONFIG_PLACE_TEXT];
    if (st != ERR_FILE || strstr(status_message(), ": error: ")) {
        return case_place(c, st, at);
    }
    (void)snprintf(words, sizeof words, "%s", status_message());
    config_place_text(c->config, at, place);
    status_clear();
    return status_fail(st, "%serror: %s", place, words);
}

static status read_tissue(const case_data *c, reach_scene *out)
{
    status st = OK;
    const reach_case *r = &c->file.reach;
    char folder[PATH_MAX], path[2 * PATH_MAX];
    case_folder(c, folder, sizeof folder);
    const bool alone = r->tissue.text[0] == '/';
    st = disk_join(path, sizeof path, "%s%s", alone ? "" : folder, r->tissue.text);
    TRY(case_place(c, st, r->tissue.at));
    (void)snprintf(out->path, sizeof out->path, "%s", r->tissue.text);
    const surface_options options = {.path = path, .merge = r->merge};
    st = surface_read(&options, reach_unit_metres(r->tissue_unit), &out->tissue, &out->report);
    TRY(file_place(c, st, r->tissue.at));
    TRY(distance_tree_make(&out->tissue, &out->tree));

done:
    return st;
}

// --- the line

// of the widest scope, with what is to be left beside it, and a little more to be found in a search
static double widest_room(const case_data *c)
{
    const reach_case *r = &c->file.reach;
    double widest = 0;
    for (int i = 0; i < r->scopes.count; i++) {
        widest = fmax(widest, case_scope(c, i)->radius);
    }
    return widest + r->clearance + 2 * reach_resolution(r->tolerance);
}

// Steps along the line are as long as the wall is sure to be too near, but never shorter than this
// part of the shaft's radius, or of the line's way through the tissue.
static const double least_of_radius = 1e-2, least_of_way = 1e-4;
// Where a shaft comes out of its channel it has next to no room, in all poses. What they have is
// told from where the line has this much more, over the radius, as long as its room only grows.
static const double room_to_grow = 0.5;

static double room_along(const reach_scene *s, double t)
{
    const vec3 z = mat3_mul_vec(s->entry.R, (vec3){{0, 0, 1}});
    return distance_to(s->tree, vec3_add(s->entry.p, vec3_scale(t, z))).distance;
}

// from 0 to `to` along the line: where the wall is first `room` away, or `to`
static double first_room(const reach_scene *s, double room, double least, double to)
{
    double t = 0;
    while (t < to) {
        const double here = room_along(s, t);
        if (here >= room && here >= 0) {
            return t;
        }
        t += fmax(room - here, least);
    }
    return to;
}

// Where the line has most room from 0 to `to`. The distance to the wall changes by no more than the
// way along the line: it is right to half a step.
static double most_room(const reach_scene *s, double to, double *at)
{
    enum { STEPS = 2000 };
    double most = -INFINITY;
    for (int i = 0; i <= STEPS; i++) {
        const double t = to * i / STEPS, here = room_along(s, t);
        *at = here > most ? t : *at;
        most = fmax(most, here);
    }
    return most;
}

// on from t as long as there is more room, until there is so much
static double while_growing(const reach_scene *s, double room, double least, double t, double to)
{
    for (double here = room_along(s, t); here < room && t + least < to;) {
        const double next = room_along(s, t + least);
        if (next <= here) {
            break;
        }
        t += least;
        here = next;
    }
    return t;
}

static status fail_room(const case_data *c, const reach_scene *s, double room, double most,
                        double at)
{
    return config_fail(c->config, c->file.reach.entry.at,
                       "the entry line has nowhere room for a shaft of %.4g mm radius: at most "
                       "%.4g mm, %.4g mm from the point%s",
                       1e3 * room, 1e3 * most, 1e3 * at,
                       room > surface_diagonal(&s->tissue) ? "; is the unit another one?" : "");
}

static status find_free(const case_data *c, const surface_passage *passage, int n, reach_scene *s)
{
    const entry_case *e = &c->file.reach.entry;
    const double room = widest_room(c), last = n > 0 ? passage[n - 1].along : -1;
    if (n == 0) {
        return config_fail(c->config, e->at,
                           "the entry line misses the tissue (%s): are point and "
                           "direction in its frame?",
                           s->path);
    }
    if (last <= 0) {
        return config_fail(c->config, e->at,
                           "the entry line leads away from the tissue (%s): it leaves it %.4g mm "
                           "behind the point; does it go the other way?",
                           s->path, -1e3 * last);
    }
    s->free = e->free;
    if (!isnan(e->free)) {
        return OK;
    }
    const double least = fmax(least_of_radius * room, least_of_way * last);
    s->free = first_room(s, room, least, last);
    if (s->free >= last) {
        const double most = most_room(s, last, &s->free);
        if (most < room) {
            return fail_room(c, s, room, most, s->free);
        }
    }
    s->shaft_free = while_growing(s, (1 + room_to_grow) * room, least, s->free, last);
    return OK;
}

// the smallest turn of the world that brings its z onto the line: q[1] = 0 is there
static mat3 turn_onto(vec3 z)
{
    const vec3 across = {{-z.a[1], z.a[0], 0}}; // e_z x z
    const double sine = vec3_norm(across);
    const vec3 axis = sine > 0 ? vec3_scale(1 / sine, across) : (vec3){{1, 0, 0}};
    return so3_exp(vec3_scale(atan2(sine, z.a[2]), axis));
}

static status lay_line(const case_data *c, reach_scene *out)
{
    status st = OK;
    const entry_case *e = &c->file.reach.entry;
    surface_passage *passage = NULL;
    int n = 0;
    vec3 d;
    entry_direction(e, d.a);
    const vec3 z = vec3_scale(1 / vec3_norm(d), d);
    out->entry = (pose){turn_onto(z), {{e->point[0], e->point[1], e->point[2]}}};
    TRY(surface_line(&out->tissue, out->entry.p, z, &passage, &n));
    TRY(find_free(c, passage, n, out));

done:
    free(passage);
    return st;
}

// --- the targets

static status take_places(const table *t, reach_scene *out)
{
    status st = OK;
    static const char *const axis[3] = {"x", "y", "z"};
    double *x = NULL;
    for (int k = 0; k < 3; k++) {
        int column = -1;
        TRY(table_need(t, axis[k], DIM_LENGTH, &column));
        free(x);
        x = NULL;
        TRY(table_take(t, column, DIM_LENGTH, &x));
        for (int i = 0; i < t->nrow; i++) {
            if (isnan(x[i])) {
                TRY(table_fail(t, i, "a target without its %s", axis[k]));
            }
            out->target[i][k] = x[i];
        }
    }

done:
    free(x);
    return st;
}

static status take_names(const table *t, reach_scene *out)
{
    const int column = table_find(t, "name|target|label");
    for (int i = 0; i < t->nrow; i++) {
        const double word = column < 0 ? NAN : t->a[i * t->ncolumn + column];
        if (isnan(word)) {
            (void)snprintf(out->name[i], sizeof out->name[i], "%d", i + 1);
        } else {
            (void)snprintf(out->name[i], sizeof out->name[i], "%s", t->word[(int)word]);
        }
        for (int k = 0; k < i && column >= 0; k++) {
            if (strcmp(out->name[k], out->name[i]) == 0) {
                return table_fail(t, i, "two targets are called '%s'", out->name[i]);
            }
        }
    }
    return OK;
}

// the tip may be off by the tolerance, and so may a target be of the wall
static status check_inside(const case_data *c, const table *t, reach_scene *s)
{
    const reach_case *r = &c->file.reach;
    int outside = 0, worst = -1;
    for (int i = 0; i < s->ntarget; i++) {
        const double *p = s->target[i];
        s->depth[i] = distance_to(s->tree, (vec3){{p[0], p[1], p[2]}}).distance;
        if (s->depth[i] < -r->tolerance) {
            outside++;
            worst = worst < 0 || s->depth[i] < s->depth[worst] ? i : worst;
        }
    }
    if (outside == 0) {
        return OK;
    }
    return config_fail(c->config, r->targets.at,
                       "%s:%ld: target '%s' lies %.4g mm outside the tissue (%s)%s%.0d%s: has its "
                       "file another unit or frame?",
                       r->targets.text, t->line[worst], s->name[worst], -1e3 * s->depth[worst],
                       s->path, outside > 1 ? ", the farthest of " : "", outside > 1 ? outside : 0,
                       outside > 1 ? " that do" : "");
}

static status read_targets(const case_data *c, reach_scene *out)
{
    status st = OK;
    const reach_case *r = &c->file.reach;
    const table_limits limits = {
        .rows = REACH_TARGETS, .words = REACH_TARGETS, .word_columns = "name|target|label"};
    char folder[PATH_MAX];
    table t = {0};
    case_folder(c, folder, sizeof folder);
    st = table_read(folder[0] ? folder : NULL, &r->targets, &limits, &t);
    TRY(file_place(c, st, c->file.reach.targets.at));
    TRY(TAKE(out->target, (size_t)t.nrow));
    TRY(TAKE(out->name, (size_t)t.nrow));
    TRY(TAKE(out->depth, (size_t)t.nrow));
    out->ntarget = t.nrow;
    TRY(take_places(&t, out));
    TRY(take_names(&t, out));
    TRY(check_inside(c, &t, out));

done:
    table_free(&t);
    return st;
}

// --- all of it

status reach_scene_fits(const case_data *c, const reach_scene *s, double length)
{
    const status st = surface_check_size(&s->tissue, s->path, length);
    return case_place(c, st, c->file.reach.tissue.at);
}

// the first thing that a wrong unit shows in; of rods of other cases it is seen later
static status check_sizes(const case_data *c, const reach_scene *scene)
{
    status st = OK;
    for (int i = 0; i < c->file.reach.scopes.count; i++) {
        const scope_case *s = case_scope(c, i);
        if (!case_scope_is_rod(s)) {
            TRY(reach_scene_fits(c, scene, s->constant_curvature.length));
        } else if (case_scope_is_own(s)) {
            TRY(reach_scene_fits(c, scene, c->file.rod.length));
        }
    }

done:
    return st;
}

status reach_scene_open(const case_data *c, reach_scene *out)
{
    status st = OK;
    *out = (reach_scene){0};
    TRY(read_tissue(c, out));
    TRY(check_sizes(c, out));
    TRY(lay_line(c, out));
    TRY(c->file.reach.targets.text ? read_targets(c, out) : OK);
    return OK;

done:
    reach_scene_free(out);
    return st;
}

void reach_scene_free(reach_scene *s)
{
    distance_tree_free(s->tree);
    surface_free(&s->tissue);
    free(s->name);
    free(s->target);
    free(s->depth);
    *s = (reach_scene){0};
}
