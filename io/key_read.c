// io/key_read.c
#include "io/key_value.h"

#include <stdio.h>
#include <string.h>

enum { MAX_KEYS = 64 }; // of one table

typedef struct reader {
    const config *cfg;
    const key_table *table;
    const value_key *around; // the key that the table stands behind
    const node *map;
    char *out;                   // the struct
    const node *given[MAX_KEYS]; // the entry of each key; NULL: not given
} reader;

static status read_table(const value_key *around, const node *n, const char *what, char *out);

// tables in place begin with their own defaults, unless the table around them has defaults for the
// whole struct
static void fill_defaults(const key_table *table, char *out)
{
    if (table->initial) {
        memcpy(out, table->initial, table->size);
        return;
    }
    memset(out, 0, table->size);
    for (int i = 0; i < table->nkey; i++) {
        if (table->keys[i].kind == KEY_TABLE) {
            fill_defaults(table->keys[i].table, out + table->keys[i].offset);
        }
    }
}

static status read_list(const value_key *v, const node *n, key_list *out)
{
    const bool named = v->k->kind == KEY_NAMED;
    if (n->kind != (named ? NODE_MAP : NODE_LIST)) {
        return value_mismatch(v, n, named ? "a map of names" : "a list");
    }
    const size_t size = v->k->table->size;
    char *item = NULL;
    status st = value_count(v, n, n->count);
    if (st == OK) {
        st = arena_take(v->cfg->memory, (void **)&item, (size_t)n->count, size);
    }
    *out = (key_list){.at = n->at, .count = n->count, .items = item};
    for (const node *entry = n->first; entry && st == OK; entry = entry->next) {
        const short_text name = shortened(named ? entry->key : v->written);
        char what[96];
        (void)snprintf(what, sizeof what, named ? "'%s'" : "this entry of '%s'", name.a);
        fill_defaults(v->k->table, item);
        st = read_table(v, entry, what, item);
        if (named) {
            memcpy(item, &entry->key_at, sizeof entry->key_at);
            memcpy(item + sizeof(mark), &entry->key, sizeof entry->key);
        }
        item += size;
    }
    return st;
}

static status read_inner_table(const value_key *v, const node *n, char *out)
{
    char what[96];
    (void)snprintf(what, sizeof what, "'%s'", shortened(v->written).a);
    const status st = read_table(v, n, what, out);
    memcpy(out, &n->key_at, sizeof n->key_at);
    return st;
}

static status read_name(const value_key *v, const node *n, key_text *out)
{
    out->at = n->at;
    return value_text(v, n, &out->text);
}

// a list of texts; one text alone is a list of one
static status read_texts(const value_key *v, const node *n, key_list *out)
{
    const bool list = n->kind == NODE_LIST;
    const int count = list ? n->count : 1;
    key_text *item = NULL;
    status st = value_count(v, n, count);
    if (st == OK) {
        st = arena_take(v->cfg->memory, (void **)&item, (size_t)count, sizeof *item);
    }
    *out = (key_list){.at = n->at, .count = count, .items = item};
    const node *entry = list ? n->first : n;
    for (int i = 0; i < count && st == OK; i++) {
        st = read_name(v, entry, &item[i]);
        entry = entry->next;
    }
    return st;
}

static status read_value(const value_key *v, const node *n, char *struct_start)
{
    void *out = struct_start + v->k->offset;
    switch (v->k->kind) {
    case KEY_REAL:
        return value_real(v, n, out);
    case KEY_INTEGER:
        return value_integer(v, n, out);
    case KEY_FLAG:
        return value_flag(v, n, out);
    case KEY_TEXT:
        return value_text(v, n, out);
    case KEY_NAME:
        return read_name(v, n, out);
    case KEY_CHOICE:
        return value_choice(v, n, out);
    case KEY_FIELD:
        return value_field(v, n, out);
    case KEY_PLACE:
        return value_place(v, n, out);
    case KEY_VECTOR:
        return value_vector(v, n, out);
    case KEY_FIELDS:
        return value_fields(v, n, out);
    case KEY_ROWS:
        return value_rows(v, n, out);
    case KEY_TEXTS:
        return read_texts(v, n, out);
    case KEY_TABLE:
        return read_inner_table(v, n, out);
    case KEY_LIST:
    case KEY_NAMED:
        return read_list(v, n, out);
    }
    return status_fail(ERR_BUG, "key '%s' is of no known kind", v->k->name);
}

// a key that the table around knows was put too deep
static status refuse_inner(const reader *r, const node *entry)
{
    const unit *u = NULL;
    if (!r->around->beside || !key_find(r->around->beside, entry->key, &u)) {
        return OK;
    }
    return config_fail(r->cfg, entry->key_at,
                       "unknown key '%s': it belongs one level up, beside '%s'",
                       shortened(entry->key).a, shortened(r->around->written).a);
}

static bool is_digits(const char *text)
{
    return text[0] != '\0' && text[strspn(text, "0123456789")] == '\0';
}

// {E_MPa: 0,9, nu: 0.45}: to YAML, 9 is a key
static status check_comma(const reader *r, const node *entry)
{
    const node *next = entry->next;
    const bool number = entry->kind == NODE_SCALAR && entry->plain &&
                        is_digits(entry->text + (entry->text[0] == '-'));
    if (!number || !next || !is_digits(next->key) || next->kind != NODE_SCALAR || !next->plain ||
        next->text[0]) {
        return OK;
    }
    const short_text whole = shortened(entry->text), part = shortened(next->key);
    return config_fail(r->cfg, entry->at,
                       "'%s': %s,%s are two numbers: one is wanted, with a point for the decimals",
                       shortened(entry->key).a, whole.a, part.a);
}

static status read_entry(reader *r, const node *entry)
{
    status st = OK;
    value_key v = {.cfg = r->cfg, .written = entry->key, .beside = r->table};
    v.k = key_find(r->table, entry->key, &v.u);
    if (!v.k) {
        TRY(refuse_inner(r, entry));
        TRY(key_unknown(r->cfg, r->table, entry));
    }
    TRY(check_comma(r, entry));
    const node **given = &r->given[v.k - r->table->keys];
    if (*given) {
        return config_fail(r->cfg, entry->key_at, "'%s' and '%s' are the same key, in two units",
                           shortened((*given)->key).a, shortened(entry->key).a);
    }
    *given = entry;
    TRY(read_value(&v, entry, r->out));

done:
    return st;
}

static void usual_spelling(const key *k, char name[KEY_NAME_TEXT])
{
    const unit *units = NULL;
    (void)unit_list(k->dimension, &units);
    key_spelling(k, units, name);
}

// keys of one group: exactly one for a positive number, at most one for a negative
static status check_group(const reader *r, int group, const char *what)
{
    const node *first = NULL;
    char members[400] = "", name[KEY_NAME_TEXT];
    size_t used = 0;
    for (int i = 0; i < r->table->nkey; i++) {
        const node *entry = r->given[i];
        if (r->table->keys[i].one_of != group) {
            continue;
        }
        usual_spelling(&r->table->keys[i], name);
        if (used < sizeof members) {
            used += (size_t)snprintf(members + used, sizeof members - used, "%s%s",
                                     used ? ", " : "", name);
        }
        if (entry && first) {
            const bool later = entry->key_at.line > first->key_at.line ||
                               (entry->key_at.line == first->key_at.line &&
                                entry->key_at.column > first->key_at.column);
            const node *second = later ? entry : first;
            return config_fail(r->cfg, second->key_at, "'%s' and '%s' exclude each other",
                               shortened((later ? first : entry)->key).a, shortened(second->key).a);
        }
        first = entry ? entry : first;
    }
    return first || group < 0
               ? OK
               : config_fail(r->cfg, r->map->at, "one of %s is missing in %s", members, what);
}

static status check_given(const reader *r, const char *what)
{
    status st = OK;
    for (int i = 0; i < r->table->nkey && st == OK; i++) {
        const key *k = &r->table->keys[i];
        char name[KEY_NAME_TEXT];
        usual_spelling(k, name);
        if (k->required && !r->given[i]) {
            return config_fail(r->cfg, r->map->at, "key '%s' is missing in %s", name, what);
        }
        bool first_of_group = k->one_of != 0;
        for (int j = 0; j < i; j++) {
            first_of_group = first_of_group && r->table->keys[j].one_of != k->one_of;
        }
        if (first_of_group) {
            st = check_group(r, k->one_of, what);
        }
    }
    return st;
}

// `what`: the map's name in messages
static status read_table(const value_key *around, const node *n, const char *what, char *out)
{
    const config *cfg = around->cfg;
    const key_table *table = around->k->table;
    reader r = {.cfg = cfg, .table = table, .around = around, .map = n, .out = out};
    if (table->nkey > MAX_KEYS) {
        return status_fail(ERR_BUG, "table '%s' has more than %d keys", table->name, MAX_KEYS);
    }
    if (n->kind != NODE_MAP) {
        const bool nothing = n->kind == NODE_SCALAR && n->text[0] == '\0';
        return config_fail(cfg, n->at, "%s: expected a map of keys, found %s", what,
                           n->kind == NODE_LIST ? "a list"
                           : nothing            ? "nothing"
                                                : "a single value");
    }
    for (const node *entry = n->first; entry; entry = entry->next) {
        const status st = read_entry(&r, entry);
        if (st != OK) {
            return st;
        }
    }
    memcpy(out, &n->at, sizeof n->at);
    return check_given(&r, what);
}

status config_read(config *cfg, const key_table *root, void *out)
{
    fill_defaults(root, out);
    const key whole = {.kind = KEY_TABLE, .table = root};
    return read_table(&(value_key){.cfg = cfg, .k = &whole}, cfg->root, "the case", out);
}

// the entry of `map` that is spelled as the key, in any unit
static const node *find_entry(const node *map, const key *k, const unit **u)
{
    const key_table one = {.nkey = 1, .keys = k};
    for (const node *entry = map->first; entry; entry = entry->next) {
        if (key_find(&one, entry->key, u)) {
            return entry;
        }
    }
    return NULL;
}

static const node *find_map(const node *map, const char *name, size_t length)
{
    for (const node *entry = map->first; entry; entry = entry->next) {
        if (strncmp(entry->key, name, length) == 0 && entry->key[length] == '\0') {
            return entry->kind == NODE_MAP ? entry : NULL;
        }
    }
    return NULL;
}

status config_peek_real(const config *cfg, const char *dotted_path, const key *k, double *value,
                        bool *found)
{
    const node *map = cfg->root;
    const char *p = dotted_path;
    *found = false;
    while (map && *p && strcmp(p, k->name) != 0) {
        const size_t length = strcspn(p, ".");
        map = find_map(map, p, length);
        p += length + (p[length] == '.');
    }
    value_key v = {.cfg = cfg, .k = k};
    const node *entry = map ? find_entry(map, k, &v.u) : NULL;
    if (!entry) {
        return OK;
    }
    v.written = entry->key;
    *found = true;
    return value_real(&v, entry, value);
}
