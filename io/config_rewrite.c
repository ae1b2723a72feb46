// io/config_rewrite.c
// A case file with other values in place: everything else stays as its writer left it.
#include "base/memory.h"
#include "io/case_text.h"
#include "io/case_tree.h"
#include "io/yaml_door.h"

#include <stdio.h>
#include <string.h>

typedef struct edit {
    size_t from, length; // in the text as read
    const char *value;
} edit;

typedef struct rewrite {
    const config *from;
    config tree; // the text alone, without overrides
    int nedit;
    edit *edits;
    char *left; // settings that found no place, as comment lines
    size_t left_length;
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

// --- edits

static status leave(rewrite *w, const char *setting)
{
    status st = OK;
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

static status add_setting(rewrite *w, const char *setting)
{
    const char *equals = strchr(setting, '=');
    edit e = {0};
    if (!equals || strchr(equals, '\n') ||
        !place_of(w->from, find(w->tree.root, setting, (size_t)(equals - setting)), &e)) {
        return leave(w, setting);
    }
    e.value = equals + 1;
    for (int i = 0; i < w->nedit; i++) {
        if (w->edits[i].from == e.from) { // the last one holds
            w->edits[i] = e;
            return OK;
        }
    }
    int i = w->nedit++;
    for (; i > 0 && w->edits[i - 1].from > e.from; i--) {
        w->edits[i] = w->edits[i - 1];
    }
    w->edits[i] = e;
    return OK;
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
                      size_t *length)
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

done:
    arena_free(w.tree.memory);
    free(w.edits);
    free(w.left);
    return st;
}
