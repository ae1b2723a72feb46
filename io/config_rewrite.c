// io/config_rewrite.c
// A case file with other values in place: everything else stays as its writer left it.
#include "base/memory.h"
#include "io/case_text.h"
#include "io/case_tree.h"
#include "io/key_names.h"
#include "io/yaml_door.h"

#include <stdio.h>
#include <string.h>

typedef struct edit {
    size_t from, length; // in the text as read; length 0: put in front of what stands there
    const char *setting; // whose it is
    const char *value;
} edit;

typedef struct rewrite {
    const config *from;
    config tree; // the text alone, without overrides
    int nedit;
    edit *edits;
    char *left; // settings that found no place, as comment lines
    size_t left_length;
    int nleft;
} rewrite;

// --- places

static const node *next_node(const node *n, const char *part, size_t length)
{
    long index = 0, at = 0;
    char *end = NULL;
    if (n->kind == NODE_SCALAR) {
        return NULL;
    }
    index = part[0] >= '0' && part[0] <= '9' ? strtol(part, &end, 10) : -1;
    const bool number = index >= 0 && end == part + length;
    for (const node *item = n->first; item; item = item->next, at++) {
        const char *name = n->kind == NODE_MAP ? item->key : NULL;
        for (const node *own = n->kind == NODE_LIST && item->kind == NODE_MAP ? item->first : NULL;
             own; own = own->next) {
            if (strcmp(own->key, "name") == 0 && own->kind == NODE_SCALAR) {
                name = own->text;
            }
        }
        const bool named = name && strncmp(name, part, length) == 0 && name[length] == '\0';
        if (named || (n->kind == NODE_LIST && number && at == index)) {
            return item;
        }
    }
    return NULL;
}

static const node *find(const node *n, const char *path, size_t length)
{
    while (n && length > 0) {
        const char *dot = memchr(path, '.', length);
        const size_t part = dot ? (size_t)(dot - path) : length;
        n = next_node(n, path, part);
        path += part + (dot != NULL);
        length -= part + (dot != NULL);
    }
    return n;
}

// the byte at a line and column, counted in characters; length where there is none
static size_t offset_of(const char *text, size_t length, mark at)
{
    size_t i = case_text_bom(text, length);
    for (int line = 1; line < at.line && i < length; i++) {
        line += text[i] == '\n';
    }
    for (int column = 1; column < at.column && i < length; i++) {
        column += i + 1 < length && ((unsigned char)text[i + 1] & 0xC0) != 0x80;
    }
    return i;
}

// whether the value stands at its place letter by letter, so that it can be replaced there
static bool place_of(const config *cfg, const node *n, edit *out)
{
    if (!n || n->kind != NODE_SCALAR || !n->plain) {
        return false;
    }
    out->length = strlen(n->text);
    out->from = offset_of(cfg->text, cfg->length, n->at);
    return out->length > 0 && out->from + out->length <= cfg->length &&
           memcmp(cfg->text + out->from, n->text, out->length) == 0;
}

// whether nothing but blanks and dashes of lists stands before this place on its line
static bool begins_line(const char *text, size_t from)
{
    while (from > 0 && (text[from - 1] == ' ' || text[from - 1] == '-')) {
        from--;
    }
    return from == 0 || text[from - 1] == '\n';
}

static status spell(rewrite *w, edit *e, const char *key, const char *value, const char *behind,
                    int indent)
{
    status st = OK;
    char *text = NULL;
    const size_t room =
        strlen(key) + strlen(value) + strlen(behind) + (size_t)(indent > 0 ? indent : 0) + 3;
    TRY(ARENA_TAKE(w->tree.memory, text, room));
    (void)snprintf(text, room, "%s: %s%s%*s", key, value, behind, indent, "");
    e->value = text;

done:
    return st;
}

// a key that its map does not have: in place of the same one in another unit, or as the first one.
// *found false where neither can be done.
static status place_of_new(rewrite *w, const node *map, const char *key, const char *value, edit *e,
                           bool *found)
{
    const config *cfg = w->from;
    const node *first = map && map->kind == NODE_MAP ? map->first : NULL;
    for (const node *entry = first; entry; entry = entry->next) {
        if (key_same_base(entry->key, key)) {
            edit old = {0};
            *found = place_of(cfg, entry, &old);
            e->from = offset_of(cfg->text, cfg->length, entry->key_at);
            e->length = old.from + old.length - e->from;
            return *found ? spell(w, e, key, value, "", 0) : OK;
        }
    }
    if (first) {
        const bool flow = cfg->text[offset_of(cfg->text, cfg->length, map->at)] == '{';
        e->from = offset_of(cfg->text, cfg->length, first->key_at);
        *found = flow || begins_line(cfg->text, e->from);
        return flow ? spell(w, e, key, value, ", ", 0)
                    : spell(w, e, key, value, "\n", first->key_at.column - 1);
    }
    return OK;
}

// --- edits

static status leave(rewrite *w, const char *setting)
{
    status st = OK;
    w->nleft++;
    static const char head[] = "# not written in this file: --set ";
    char *longer = NULL;
    const size_t more = sizeof head + strlen(setting) + 1;
    TRY(TAKE(longer, w->left_length + more));
    memcpy(longer, w->left ? w->left : "", w->left_length);
    w->left_length += (size_t)snprintf(longer + w->left_length, more, "%s%s\n", head, setting);
    free(w->left);
    w->left = longer;

done:
    return st;
}

static status find_place(rewrite *w, const char *setting, edit *e, bool *found)
{
    status st = OK;
    const char *equals = strchr(setting, '='), *key = setting;
    char *last = NULL;
    if (!equals || strchr(equals, '\n')) {
        return OK;
    }
    const node *n = find(w->tree.root, setting, (size_t)(equals - setting));
    e->value = equals + 1;
    *found = place_of(w->from, n, e);
    if (n) {
        return OK;
    }
    for (const char *c = setting; c < equals; c++) {
        key = *c == '.' ? c + 1 : key;
    }
    const size_t length = (size_t)(equals - key);
    const size_t parent = key > setting ? (size_t)(key - setting) - 1 : 0;
    TRY(ARENA_TAKE(w->tree.memory, last, length + 1));
    memcpy(last, key, length);
    TRY(place_of_new(w, find(w->tree.root, setting, parent), last, equals + 1, e, found));

done:
    return st;
}

static bool same_key(const char *setting, const char *other)
{
    const size_t n = strcspn(setting, "=");
    return n == strcspn(other, "=") && strncmp(setting, other, n) == 0;
}

static status add_setting(rewrite *w, const char *setting)
{
    status st = OK;
    edit e = {.setting = setting};
    bool found = false;
    TRY(find_place(w, setting, &e, &found));
    if (!found) {
        return leave(w, setting);
    }
    for (int i = 0; i < w->nedit; i++) {
        if (w->edits[i].from == e.from &&
            (e.length > 0 || same_key(w->edits[i].setting, setting))) {
            w->edits[i] = e; // the last one holds
            return OK;
        }
    }
    int i = w->nedit++;
    for (; i > 0 && w->edits[i - 1].from > e.from; i--) {
        w->edits[i] = w->edits[i - 1];
    }
    w->edits[i] = e;

done:
    return st;
}

static status put_together(const rewrite *w, char **text, size_t *length)
{
    status st = OK;
    size_t room = w->from->length + w->left_length + 2, n = 0, at = 0;
    char *out = NULL;
    for (int i = 0; i < w->nedit; i++) {
        room += strlen(w->edits[i].value);
    }
    TRY(TAKE(out, room));
    for (int i = 0; i <= w->nedit; i++) {
        const edit *e = i < w->nedit ? &w->edits[i] : NULL;
        const size_t to = e ? e->from : w->from->length;
        memcpy(out + n, w->from->text + at, to - at);
        n += to - at;
        if (e) {
            memcpy(out + n, e->value, strlen(e->value));
            n += strlen(e->value);
            at = to + e->length;
        }
    }
    if (n > 0 && out[n - 1] != '\n') {
        out[n++] = '\n';
    }
    memcpy(out + n, w->left ? w->left : "", w->left_length);
    *length = n + w->left_length;
    *text = out;

done:
    return st;
}

status config_rewrite(const config *cfg, int nsetting, const char *const *settings, char **text,
                      size_t *length, int *nleft)
{
    status st = OK;
    rewrite w = {.from = cfg, .tree = {.path = cfg->path}};
    TRY(arena_make(&w.tree.memory));
    TRY(TAKE(w.edits, (size_t)(cfg->noverride + nsetting)));
    TRY(yaml_read(&w.tree, cfg->text, cfg->length, -1, &w.tree.root));
    for (int i = 0; i < cfg->noverride; i++) {
        TRY(add_setting(&w, cfg->overrides[i]));
    }
    for (int i = 0; i < nsetting; i++) {
        TRY(add_setting(&w, settings[i]));
    }
    TRY(put_together(&w, text, length));
    *nleft = w.nleft;

done:
    arena_free(w.tree.memory);
    free(w.edits);
    free(w.left);
    return st;
}
