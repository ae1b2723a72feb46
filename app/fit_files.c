// app/fit_files.c
// The files that a case names, so that a copy of the case elsewhere finds them.
#include "app/fit_files.h"

#include "base/memory.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// what YAML takes for a plain word in lists and maps in braces too
static bool plain(const char *path)
{
    return path[strspn(
               path, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-")] == '\0';
}

// the path, or 'the ''path''' where YAML needs quotes
static void spell(const char *path, char *out, size_t room)
{
    size_t n = 0;
    if (plain(path)) {
        (void)snprintf(out, room, "%s", path);
        return;
    }
    out[n++] = '\'';
    for (const char *p = path; *p && n + 4 < room; p++) {
        out[n++] = *p;
        if (*p == '\'') {
            out[n++] = *p;
        }
    }
    out[n++] = '\'';
    out[n] = '\0';
}

static status add_file(const case_data *c, const char *key, const char *name, settings *out)
{
    const char *path = config_path(c->config), *slash = strrchr(path, '/');
    const int folder = slash ? (int)(slash - path) + 1 : 0;
    char joined[PATH_MAX], whole[PATH_MAX], spelled[2 * PATH_MAX + 8];
    if (!name || name[0] == '/') {
        return OK;
    }
    const int n = snprintf(joined, sizeof joined, "%.*s%s", folder, path, name);
    if (n >= (int)sizeof joined || !realpath(joined, whole)) {
        return OK; // it was read a moment ago; the name stays as it is
    }
    spell(whole, spelled, sizeof spelled);
    key_text text = {.text = key};
    const parameter file = {.name = "file", .keys = {.count = 1, .items = &text}};
    return settings_add_text(out, &file, spelled);
}

status fit_files(const case_data *c, settings *out)
{
    status st = OK;
    char key[80];
    const measured_shape *shape = c->file.measured.shapes.items;
    for (int i = 0; i < c->file.measured.shapes.count; i++) {
        (void)snprintf(key, sizeof key, "measured.shapes.%d.csv", i);
        TRY(add_file(c, key, shape[i].csv.text, out));
    }
    const tendon_case *tendon = c->file.rod.tendons.items;
    for (int i = 0; i < c->file.rod.tendons.count; i++) {
        (void)snprintf(key, sizeof key, "rod.tendons.%d.path_csv", i);
        TRY(add_file(c, key, tendon[i].path_csv.text, out));
    }
    const scope_case *scope = c->file.reach.scopes.items;
    for (int i = 0; i < c->file.reach.scopes.count; i++) {
        (void)snprintf(key, sizeof key, "reach.scopes.%d.rod.file", i);
        TRY(add_file(c, key, scope[i].rod.file.text, out));
    }
    TRY(add_file(c, "reach.tissue", c->file.reach.tissue.text, out));
    TRY(add_file(c, "reach.targets", c->file.reach.targets.text, out));

done:
    return st;
}
