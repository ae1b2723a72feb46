// io/override.c
#include "io/override.h"

#include "base/nearest.h"
#include "io/case_text.h"
#include "io/key_names.h"
#include "io/yaml_door.h"

#include <stdlib.h>
#include <string.h>

typedef struct override {
    config *cfg;
    mark at;
    const char *path; // what is left of it
    const char *name; // the part before, for messages
} override;

// length of the path's next part: the longest key of the map that it begins with (keys may hold
// points), else to the next point
static size_t part_length(const node *map, const char *path)
{
    size_t length = strcspn(path, ".");
    if (map->kind == NODE_MAP) {
        for (const node *entry = map->first; entry; entry = entry->next) {
            const size_t n = strlen(entry->key);
            const bool fits =
                strncmp(path, entry->key, n) == 0 && (path[n] == '.' || path[n] == '\0');
            length = fits && n > length ? n : length;
        }
    }
    return length;
}

static node *entry_of(const node *map, const char *name)
{
    for (node *entry = map->first; entry; entry = entry->next) {
        if (strcmp(entry->key, name) == 0) {
            return entry;
        }
    }
    return NULL;
}

static node *item_at(const node *list, long index)
{
    node *item = list->first;
    for (long i = 0; item && i < index; i++) {
        item = item->next;
    }
    return item;
}

// by number from 0, or by the item's own key `name`
static status find_item(const override *o, const node *list, const char *part, node **out)
{
    char *end = NULL;
    *out = NULL;
    const bool number = part[0] >= '0' && part[0] <= '9';
    const long index = number ? strtol(part, &end, 10) : 0;
    if (number && *end == '\0') {
        *out = item_at(list, index);
        if (!*out) {
            return config_fail(o->cfg, o->at, "'%s' has %d entries, counted from 0",
                               shortened(o->name).a, list->count);
        }
        return OK;
    }
    char words[NEAREST_WORDS];
    nearest near = nearest_to(part);
    for (node *item = list->first; item; item = item->next) {
        const node *name = item->kind == NODE_MAP ? entry_of(item, "name") : NULL;
        if (name && name->kind == NODE_SCALAR) {
            nearest_offer(&near, name->text, name->text);
        }
        if (name && name->kind == NODE_SCALAR && strcmp(name->text, part) == 0) {
            *out = item;
            return OK;
        }
    }
    return config_fail(
        o->cfg, o->at, "'%s' is a list: no entry is named '%s', and '%s' is no number%s",
        shortened(o->name).a, shortened(part).a, shortened(part).a, nearest_words(&near, words));
}

// a new map entry at the end
static status append(const override *o, node *map, const char *key, node **out)
{
    if (++o->cfg->nnode > CONFIG_MAX_NODES) {
        return config_fail(o->cfg, o->at, "more than %d values: not a case", CONFIG_MAX_NODES);
    }
    const status st = ARENA_TAKE(o->cfg->memory, *out, 1);
    if (st == OK) {
        node **end = &map->first;
        while (*end) {
            end = &(*end)->next;
        }
        **out = (node){.kind = NODE_MAP, .key = key, .at = o->at, .key_at = o->at};
        *end = *out;
        map->count++;
    }
    return st;
}

// the same key in another unit gives way to the new one
static void remove_other_units(node *map, const node *kept)
{
    for (node **at = &map->first; *at;) {
        const node *entry = *at;
        if (entry != kept && entry->kind != NODE_MAP && key_same_base(entry->key, kept->key)) {
            *at = entry->next;
            map->count--;
        } else {
            at = &(*at)->next;
        }
    }
}

// one step down the path: *n becomes the entry of the next part, made where it is missing
static status descend(override *o, node **n)
{
    status st = OK;
    const char *part = NULL;
    node *next = NULL;
    const size_t length = part_length(*n, o->path);
    if (length == 0) {
        return config_fail(o->cfg, o->at, "--set wants KEY=VALUE, with KEY like rod.length_mm");
    }
    TRY(arena_copy(o->cfg->memory, o->path, length, &part));
    if ((*n)->kind == NODE_SCALAR) {
        TRY(config_fail(o->cfg, o->at, "'%s' is a single value and has no '%s'",
                        shortened(o->name).a, shortened(part).a));
    }
    if ((*n)->kind == NODE_LIST) {
        TRY(find_item(o, *n, part, &next));
    } else {
        next = entry_of(*n, part);
        if (!next) {
            TRY(append(o, *n, part, &next));
        }
        next->key_at = o->at;
        remove_other_units(*n, next);
    }
    o->name = part;
    o->path += length;
    if (o->path[0] == '.' && (++o->path)[0] == '\0') {
        TRY(config_fail(o->cfg, o->at, "--set wants KEY=VALUE, with KEY like rod.length_mm"));
    }
    *n = next;

done:
    return st;
}

// the entry keeps its key and its place among its neighbours
static void replace_value(node *n, const node *value)
{
    const node old = *n;
    *n = *value;
    n->key = old.key;
    n->key_at = old.key_at;
    n->next = old.next;
}

static status apply(config *cfg, int i)
{
    status st = OK;
    node *n = cfg->root, *value = NULL;
    override o = {.cfg = cfg, .at = case_mark(i, (mark){1, 1}), .name = "the case"};
    const char *text = cfg->overrides[i], *equals = strchr(text, '=');
    if (!equals || equals == text) {
        return config_fail(cfg, o.at, "--set wants KEY=VALUE, with KEY like rod.length_mm");
    }
    TRY(case_text_check(cfg, text, strlen(text), i));
    TRY(yaml_read(cfg, equals + 1, strlen(equals + 1), i, &value));
    TRY(arena_copy(cfg->memory, text, (size_t)(equals - text), &o.path));
    while (o.path[0]) {
        TRY(descend(&o, &n));
    }
    const node nothing = {.kind = NODE_SCALAR, .text = "", .plain = true, .at = o.at};
    replace_value(n, value ? value : &nothing);

done:
    return st;
}

status override_apply(config *cfg)
{
    status st = OK;
    for (int i = 0; i < cfg->noverride && st == OK; i++) {
        st = apply(cfg, i);
    }
    return st;
}
