// meshes/parts.c
#include "meshes/parts.h"

#include "base/memory.h"
#include "base/nearest.h"

#include <stdio.h>
#include <string.h>

void parts_free(part_table *t)
{
    free(t->material);
    free(t->used);
    *t = (part_table){0};
}

static status fail_at(mark at, const char *before, const char *name, const nearest *near)
{
    char words[NEAREST_WORDS] = "";
    return status_fail_at(ERR_INPUT, at.line, at.column, "%s '%.100s'%s", before, name,
                          near ? nearest_words(near, words) : "");
}

static status find_material(const part_table *t, const key_text *name, int *material)
{
    *material = PART_NONE;
    if (strcmp(name->text, "none") == 0) {
        return OK;
    }
    nearest near = nearest_to(name->text);
    for (int i = 0; i < t->nmaterial; i++) {
        if (strcmp(t->materials[i].name, name->text) == 0) {
            *material = i;
            return OK;
        }
        nearest_offer(&near, t->materials[i].name, t->materials[i].name);
    }
    return fail_at(name->at, "unknown material", name->text, &near);
}

static int hex_digit(char c)
{
    const char *digits = "0123456789abcdef";
    const char *at = c ? strchr(digits, c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c) : NULL;
    return at ? (int)(at - digits) : -1;
}

bool part_read_colour(const char *text, unsigned char rgb[3])
{
    if (strlen(text) != 7 || text[0] != '#') {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        const int high = hex_digit(text[1 + 2 * i]), low = hex_digit(text[2 + 2 * i]);
        if (high < 0 || low < 0) {
            return false;
        }
        rgb[i] = (unsigned char)(16 * high + low);
    }
    return true;
}

static bool same_part(const part_spec *a, const part_spec *b)
{
    if (a->name.text || b->name.text) {
        return a->name.text && b->name.text && strcmp(a->name.text, b->name.text) == 0;
    }
    unsigned char p[3], q[3];
    return part_read_colour(a->colour.text, p) && part_read_colour(b->colour.text, q) &&
           memcmp(p, q, 3) == 0;
}

static status check_entry(const part_spec *all, int i)
{
    unsigned char rgb[3];
    const part_spec *s = &all[i];
    if (!s->name.text && !part_read_colour(s->colour.text, rgb)) {
        return fail_at(s->colour.at, "a colour is written '#rrggbb', not", s->colour.text, NULL);
    }
    for (int k = 0; k < i; k++) {
        if (same_part(&all[k], s)) {
            return fail_at(s->at,
                           "parts name this twice:", s->name.text ? s->name.text : s->colour.text,
                           NULL);
        }
    }
    return OK;
}

status parts_make(const char *what, const key_list *parts, const drawing_request *request,
                  part_table *out)
{
    status st = OK;
    part_table t = {.what = what,
                    .count = parts->count,
                    .spec = parts->items,
                    .nmaterial = request->nmaterial,
                    .materials = request->materials};
    TRY(TAKE(t.material, (size_t)t.count));
    TRY(TAKE(t.used, (size_t)t.count));
    for (int i = 0; i < t.count; i++) {
        TRY(check_entry(t.spec, i));
        TRY(find_material(&t, &t.spec[i].material, &t.material[i]));
    }
    *out = t;
    t = (part_table){0};

done:
    parts_free(&t);
    return st;
}

int part_by_name(part_table *t, const char *name)
{
    for (int i = 0; i < t->count; i++) {
        if (t->spec[i].name.text && strcmp(t->spec[i].name.text, name) == 0) {
            t->used[i] = true;
            return t->material[i];
        }
    }
    for (int i = 0; i < t->nmaterial; i++) {
        if (strcmp(t->materials[i].name, name) == 0) {
            return i;
        }
    }
    return PART_UNKNOWN;
}

int part_by_colour(part_table *t, const unsigned char rgb[3])
{
    for (int i = 0; i < t->count; i++) {
        unsigned char known[3];
        if (t->spec[i].colour.text && part_read_colour(t->spec[i].colour.text, known) &&
            memcmp(known, rgb, 3) == 0) {
            t->used[i] = true;
            return t->material[i];
        }
    }
    return PART_UNKNOWN;
}

status part_unknown(const part_table *t, const input_file *file, long line, const char *name)
{
    char words[NEAREST_WORDS];
    nearest near = nearest_to(name);
    for (int i = 0; i < t->count; i++) {
        if (t->spec[i].name.text) {
            nearest_offer(&near, t->spec[i].name.text, t->spec[i].name.text);
        }
    }
    for (int i = 0; i < t->nmaterial; i++) {
        nearest_offer(&near, t->materials[i].name, t->materials[i].name);
    }
    return input_file_fail(file, line,
                           "the %s '%.100s' has no material: `parts` does not name it%s", t->what,
                           name, nearest_words(&near, words));
}

status parts_all_used(const part_table *t, int nname, const char *const *names)
{
    for (int i = 0; i < t->count; i++) {
        const part_spec *s = &t->spec[i];
        if (t->used[i]) {
            continue;
        }
        nearest near = nearest_to(s->name.text ? s->name.text : s->colour.text);
        for (int k = 0; k < nname; k++) {
            nearest_offer(&near, names[k], names[k]);
        }
        char before[64];
        (void)snprintf(before, sizeof before, "the file has no %.40s",
                       s->name.text ? t->what : "part of colour");
        return fail_at(s->at, before, near.written, &near);
    }
    return OK;
}
