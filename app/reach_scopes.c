// app/reach_scopes.c
#include "app/reach_scopes.h"

#include "app/reach_case.h"
#include "base/memory.h"
#include "io/disk.h"

#include <limits.h>
#include <math.h>
#include <string.h>

// places along a rod whose section changes that are looked at, ends included
enum { WIDTH_SAMPLES = 33 };

// a curve's outline may be drawn by chords and its numbers are rounded: so much of the radius
static const double same_radius = 1e-6;

bool reach_base_needed(const case_data *c)
{
    bool any = false;
    for (int i = 0; i < c->file.reach.scopes.count; i++) {
        any = any || case_scope_is_own(case_scope(c, i));
    }
    return any;
}

status reach_base_open(const case_data *c, const section_result *section, variation *out)
{
    *out = (variation){0};
    return reach_base_needed(c) ? variation_open(c, section, out) : OK;
}

// --- what its rod is

static status add_setting(settings *s, const char *text)
{
    status st = OK;
    char **larger = NULL;
    TRY(TAKE(larger, (size_t)s->count + 1));
    if (s->count > 0) {
        memcpy(larger, s->text, (size_t)s->count * sizeof *larger);
    }
    free(s->text);
    s->text = larger;
    s->capacity = s->count + 1;
    TRY(TAKE(s->text[s->count], strlen(text) + 1));
    memcpy(s->text[s->count++], text, strlen(text));

done:
    return st;
}

static status collect_settings(const scope_case *said, const settings *more, settings *out)
{
    status st = OK;
    for (int i = 0; i < said->rod.set.count; i++) {
        TRY(add_setting(out, ((const key_text *)said->rod.set.items + i)->text));
    }
    for (int i = 0; more && i < more->count; i++) {
        TRY(add_setting(out, more->text[i]));
    }
    (void)snprintf(out->about, sizeof out->about, "scope '%s'%s%.100s", said->name,
                   more && more->about[0] ? ", " : "", more ? more->about : "");

done:
    return st;
}

static status read_other(const case_data *c, const scope_case *said, const settings *s,
                         case_data *out)
{
    status st = OK;
    const char *file = said->rod.file.text;
    char folder[PATH_MAX], path[2 * PATH_MAX];
    case_folder(c, folder, sizeof folder);
    TRY(disk_join(path, sizeof path, "%s%s", file[0] == '/' ? "" : folder, file));
    TRY(case_open(&(case_request){.path = path,
                                  .noverride = s->count,
                                  .overrides = (const char *const *)s->text,
                                  .allow_scripts = c->allow_scripts},
                  out));
    TRY(case_need_rod(out));

done:
    return st;
}

static status open_other(const case_data *c, const scope_case *said, const settings *s,
                         reach_scope *out)
{
    status st = OK;
    TRY(read_other(c, said, s, &out->other));
    TRY(variation_open(&out->other, NULL, &out->own));
    out->v = &out->own;
    TRY(varied_make(out->v, NULL, out->other.file.at, &out->rod));

done:
    return st;
}

// what another case's own words are about has its place there
status reach_scope_tell(const case_data *c, const scope_case *said, status st)
{
    char words[1024], place[CONFIG_PLACE_TEXT];
    const bool other = case_scope_is_rod(said) && said->rod.file.text;
    const bool told = strstr(status_message(), ": error: ") != NULL;
    if (st == OK || st == ERR_INTERRUPTED || st == ERR_RESOURCE || (told && !other)) {
        return st;
    }
    (void)snprintf(words, sizeof words, "%s", status_message());
    config_place_text(c->config, said->at, place);
    status_clear();
    return status_fail(st, "%serror: scope '%s': %s", place, said->name, words);
}

static status check_tendons(const case_data *c, const scope_case *said, int ntendon)
{
    const int nrow = said->tensions.nrow;
    if (nrow != ntendon) {
        return config_fail(c->config, said->tensions.at,
                           "scope '%s': %d row%s of tensions, but its rod has %d tendon%s",
                           said->name, nrow, nrow == 1 ? "" : "s", ntendon,
                           ntendon == 1 ? "" : "s");
    }
    return OK;
}

// A body thinner than its own rod would be told to have room that it does not have.
static status check_width(const case_data *c, const scope_case *said, const case_data *rod)
{
    status st = OK;
    double widest = 0, at = 0;
    const section_case *section = &rod->file.section;
    const int n = section_varies(section) ? WIDTH_SAMPLES : 1;
    for (int i = 0; i < n; i++) {
        const double s = n > 1 ? rod->file.rod.length * i / (n - 1) : 0;
        double here = 0;
        TRY(reach_scope_tell(c, said, section_reach_at(section, s, &here)));
        at = here > widest ? s : at;
        widest = fmax(widest, here);
    }
    if (widest > said->radius * (1 + same_radius)) {
        st = config_fail(c->config, said->at,
                         "scope '%s': its radius is %.6g mm, but its rod's section reaches %.6g mm "
                         "from the centreline, at s = %.4g mm",
                         said->name, 1e3 * said->radius, 1e3 * widest, 1e3 * at);
    }

done:
    return st;
}

status reach_scope_check(const case_data *c, int i)
{
    status st = OK;
    settings s = {0};
    case_data other = {0};
    const scope_case *said = case_scope(c, i);
    if (!case_scope_is_rod(said)) {
        return OK;
    }
    TRY(collect_settings(said, NULL, &s));
    TRY(said->rod.file.text ? reach_scope_tell(c, said, read_other(c, said, &s, &other))
                            : variation_read(c, &s, said->rod.at, &other));
    TRY(check_tendons(c, said, other.file.rod.tendons.count));
    TRY(check_width(c, said, &other));
    if (rod_case_loads(&other.file.rod) > 0) {
        st = status_fail(ERR_INPUT, "its rod bears loads; a scope's shape may depend on its "
                                    "tendons only");
        TRY(reach_scope_tell(c, said, st));
    }

done:
    case_free(&other);
    settings_free(&s);
    return st;
}

static status make_rod_scope(const case_data *c, variation *base, const settings *more,
                             reach_scope *out)
{
    status st = OK;
    settings s = {0};
    const scope_case *said = out->said;
    TRY(collect_settings(said, more, &s));
    if (said->rod.file.text) {
        TRY(reach_scope_tell(c, said, open_other(c, said, &s, out)));
    } else {
        out->v = base;
        TRY(varied_make(base, &s, said->rod.at, &out->rod));
    }
    const case_file *f = &out->rod.c.file;
    TRY(check_tendons(c, said, f->rod.tendons.count));
    TRY(check_width(c, said, &out->rod.c));
    out->scope.rod = out->rod.rod;
    out->scope.length = f->rod.length;
    out->scope.njoint = SCOPE_BEND + f->rod.tendons.count;
    for (int i = 0; i < f->rod.tendons.count; i++) {
        out->scope.low[SCOPE_BEND + i] = said->tensions.a[2 * i];
        out->scope.high[SCOPE_BEND + i] = said->tensions.a[2 * i + 1];
    }
    (void)snprintf(out->kind, sizeof out->kind, "rod, %s K, %d tendon%s",
                   f->section.model == MODEL_CLASSICAL ? "classical" : "full", f->rod.tendons.count,
                   f->rod.tendons.count == 1 ? "" : "s");

done:
    settings_free(&s);
    return st;
}

static void make_arc_scope(reach_scope *out)
{
    const scope_arc_case *arc = &out->said->constant_curvature;
    out->scope.length = arc->length;
    out->scope.njoint = SCOPE_BEND + 1;
    out->scope.low[SCOPE_BEND] = arc->bend[0];
    out->scope.high[SCOPE_BEND] = arc->bend[1];
    (void)snprintf(out->kind, sizeof out->kind, "constant curvature");
}

status reach_scope_make(const case_data *c, variation *base, int i, const settings *more,
                        reach_scope *out)
{
    status st = OK;
    const scope_case *said = case_scope(c, i);
    *out = (reach_scope){.said = said};
    (void)snprintf(out->scope.name, sizeof out->scope.name, "%s", said->name);
    out->scope.radius = said->radius;
    for (int k = 0; k < 2; k++) {
        (k == 0 ? out->scope.low : out->scope.high)[SCOPE_INSERTION] = said->insertion[k];
        (k == 0 ? out->scope.low : out->scope.high)[SCOPE_TURN] = said->turn[k];
    }
    if (case_scope_is_rod(said)) {
        TRY(make_rod_scope(c, base, more, out));
    } else {
        make_arc_scope(out);
    }
    TRY(case_place(c, scope_check(&out->scope), said->at));
    scope_hold(&out->scope);
    if (said->strain_limit && out->scope.njoint == SCOPE_BEND + 1) {
        TRY(reach_scope_tell(c, said, reach_limit_tension(out)));
    }
    return OK;

done:
    reach_scope_free(out);
    return st;
}

void reach_scope_free(reach_scope *s)
{
    varied_free(&s->rod);
    variation_free(&s->own);
    case_free(&s->other);
    *s = (reach_scope){0};
}
