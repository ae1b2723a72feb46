// io/yaml_door.c
#include "io/yaml_door.h"

#include "io/case_text.h"
#include "io/name_set.h"
#include "io/utf8.h"

#include <string.h>
#include <yaml.h>

enum { MAX_KEYS_OF_MAP = 100000 }; // far above what any key table takes

typedef struct level {
    node *map; // or list
    node *last;
} level;

typedef struct builder {
    config *cfg;
    const char *text;
    size_t length;
    int override;
    yaml_parser_t parser;
    level stack[CONFIG_MAX_DEPTH];
    int depth;
    int ndocument;
    const char *key; // read, and waiting for its value
    mark key_at;
    name_set names;
    node *root;
} builder;

static mark place(const builder *b, yaml_mark_t at)
{
    return case_mark(b->override, (mark){(int)at.line + 1, (int)at.column + 1});
}

static status refuse(const builder *b, const yaml_event_t *event, const char *words)
{
    return config_fail(b->cfg, place(b, event->start_mark), "%s", words);
}

// libyaml's words, and what they mean to who wrote the case
static const char *plain_words(const char *words)
{
    static const char *const known[][2] = {
        {"mapping values are not allowed in this context",
         "a ': ' where no key can stand; look at the indentation and the line above, or put the "
         "text in quotes"},
        {"did not find expected ',' or ']'", "',' or ']' is missing"},
        {"did not find expected ',' or '}'", "',' or '}' is missing"},
        {"did not find expected key", "a key is expected here; look at the indentation"},
        {"did not find expected '-' indicator",
         "an entry with '- ' is expected here; look at the indentation"},
        {"did not find expected node content", "a value is missing"},
        {"did not find expected <document start>",
         "nothing can follow here; look at the indentation"},
        {"could not find expected ':'", "a ':' is missing behind the key"},
        {"block sequence entries are not allowed in this context",
         "no list can begin with '- ' here; put it on lines of its own"},
        {"found unexpected end of stream", "the closing quote is missing"},
        {"found unknown escape character",
         "'\\' begins a special character in double quotes; take single ones"},
        {"while parsing a flow sequence", "in the list"},
        {"while parsing a flow mapping", "in the map"},
        {"while parsing a block mapping", "in the map"},
        {"while parsing a block collection", "in the list"},
        {"while scanning a quoted scalar", "of the text"},
        {"while scanning a simple key", "of what"},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        if (strcmp(words, known[i][0]) == 0) {
            return known[i][1];
        }
    }
    return words;
}

static status syntax_error(const builder *b)
{
    const yaml_parser_t *p = &b->parser;
    if (p->error == YAML_MEMORY_ERROR) {
        return status_fail(ERR_RESOURCE, "out of memory while reading YAML");
    }
    const mark at = place(b, p->problem_mark);
    const char *problem = plain_words(p->problem ? p->problem : "unreadable");
    if (strstr(problem, "cannot start any token")) {
        const unsigned point = case_text_at(b->text, b->length, (int)p->problem_mark.line + 1,
                                            (int)p->problem_mark.column + 1);
        if (point == '\t') {
            return config_fail(b->cfg, at, "a tab where YAML wants spaces");
        }
        if (point > ' ' && point < 0x7F) {
            return config_fail(b->cfg, at, "not valid YAML: '%c' cannot begin a value; quote it",
                               (char)point);
        }
    }
    if (p->context && b->override < 0 && p->context_mark.line != p->problem_mark.line) {
        return config_fail(b->cfg, at, "not valid YAML: %s (%s that begins on line %d)", problem,
                           plain_words(p->context), (int)p->context_mark.line + 1);
    }
    return config_fail(b->cfg, at, "not valid YAML: %s", problem);
}

// the key that was read before belongs to this value
static status name_entry(builder *b, const node *map, node *n)
{
    const node *before = NULL;
    n->key = b->key;
    n->key_at = b->key_at;
    b->key = NULL;
    if (map->count == MAX_KEYS_OF_MAP) {
        return config_fail(b->cfg, n->key_at, "more than %d keys in one map: not a case",
                           MAX_KEYS_OF_MAP);
    }
    const status st = name_set_add(&b->names, map, n, &before);
    if (st == OK && before) {
        return config_fail(b->cfg, n->key_at, "key '%s' is given twice, first on line %d",
                           shortened(n->key).a, b->override < 0 ? before->key_at.line : 1);
    }
    return st;
}

// the new node becomes the root, or the next entry of the list or map that is open
static status attach(builder *b, const yaml_event_t *event, node *n)
{
    n->at = place(b, event->start_mark);
    if (b->depth == 0) {
        b->root = n;
        return OK;
    }
    level *top = &b->stack[b->depth - 1];
    const status st = top->map->kind == NODE_MAP ? name_entry(b, top->map, n) : OK;
    if (st != OK) {
        return st;
    }
    *(top->last ? &top->last->next : &top->map->first) = n;
    top->last = n;
    top->map->count++;
    return OK;
}

static status new_node(builder *b, const yaml_event_t *event, node **out)
{
    if (++b->cfg->nnode > CONFIG_MAX_NODES) {
        return config_fail(b->cfg, place(b, event->start_mark), "more than %d values: not a case",
                           CONFIG_MAX_NODES);
    }
    return ARENA_TAKE(b->cfg->memory, *out, 1);
}

// where the text's first character stands in the file, when nothing was folded or escaped on the
// way
static int text_column(const yaml_event_t *event, const char *text, bool plain)
{
    const yaml_mark_t from = event->start_mark, to = event->end_mark;
    const size_t around = plain ? 0 : 2;
    const bool straight =
        from.line == to.line && to.column - from.column == utf8_count(text) + around;
    return straight ? (int)from.column + 1 + !plain : 0;
}

// What plays with a terminal or forges a line of it is in no text of a case, however it was
// written; line breaks at the end of a text go, others are blanks.
static status make_one_line(const builder *b, const yaml_event_t *event, char *text, size_t length)
{
    while (length > 0 && text[length - 1] == '\n') {
        text[--length] = '\0';
    }
    for (size_t i = 0; i < length;) {
        uint32_t point = 0;
        const int n = utf8_read(text + i, length - i, &point);
        if (point == '\n' || point == '\t') {
            text[i] = ' ';
        } else if (n == 0 || !utf8_is_plain(point)) {
            return config_fail(b->cfg, place(b, event->start_mark),
                               "the control character U+%04X in a text", (unsigned)point);
        }
        i += (size_t)(n ? n : 1);
    }
    return OK;
}

static status add_scalar(builder *b, const yaml_event_t *event)
{
    status st = OK;
    node *n = NULL;
    const char *text = NULL;
    char *value = (char *)event->data.scalar.value;
    const size_t length = event->data.scalar.length;
    const bool plain = event->data.scalar.style == YAML_PLAIN_SCALAR_STYLE;
    if (memchr(value, '\0', length)) {
        return refuse(b, event, "a NUL character inside a text");
    }
    TRY(make_one_line(b, event, value, length));
    TRY(arena_copy(b->cfg->memory, value, strlen(value), &text));
    if (b->depth > 0 && b->stack[b->depth - 1].map->kind == NODE_MAP && !b->key) {
        if (length == 0) {
            TRY(refuse(b, event, "an empty key"));
        }
        b->key = text;
        b->key_at = place(b, event->start_mark);
    } else {
        TRY(new_node(b, event, &n));
        n->text = text;
        n->plain = plain;
        n->text_column = text_column(event, text, plain);
        TRY(attach(b, event, n));
    }

done:
    return st;
}

static status begin(builder *b, const yaml_event_t *event, node_kind kind)
{
    status st = OK;
    node *n = NULL;
    if (b->depth > 0 && b->stack[b->depth - 1].map->kind == NODE_MAP && !b->key) {
        return refuse(b, event, "a key must be a plain name, not a list or a map");
    }
    if (b->depth == CONFIG_MAX_DEPTH) {
        return config_fail(b->cfg, place(b, event->start_mark), "nested deeper than %d levels",
                           CONFIG_MAX_DEPTH);
    }
    TRY(new_node(b, event, &n));
    n->kind = kind;
    TRY(attach(b, event, n));
    b->stack[b->depth++] = (level){.map = n};

done:
    return st;
}

static status check_node(const builder *b, const yaml_event_t *event, const yaml_char_t *anchor,
                         const yaml_char_t *tag)
{
    if (anchor) {
        return refuse(b, event, "a case has no anchors ('&name')");
    }
    return tag ? refuse(b, event, "a case has no tags ('!name')") : OK;
}

static status take_event(builder *b, const yaml_event_t *event)
{
    status st = OK;
    switch (event->type) {
    case YAML_DOCUMENT_START_EVENT:
        return b->ndocument++ ? refuse(b, event, "a second document; a case is one") : OK;
    case YAML_ALIAS_EVENT:
        return refuse(b, event, "a case has no aliases ('*name')");
    case YAML_SCALAR_EVENT:
        TRY(check_node(b, event, event->data.scalar.anchor, event->data.scalar.tag));
        return add_scalar(b, event);
    case YAML_SEQUENCE_START_EVENT:
        TRY(check_node(b, event, event->data.sequence_start.anchor,
                       event->data.sequence_start.tag));
        return begin(b, event, NODE_LIST);
    case YAML_MAPPING_START_EVENT:
        TRY(check_node(b, event, event->data.mapping_start.anchor, event->data.mapping_start.tag));
        return begin(b, event, NODE_MAP);
    case YAML_SEQUENCE_END_EVENT:
    case YAML_MAPPING_END_EVENT:
        b->depth--;
        return OK;
    default:
        return OK;
    }

done:
    return st;
}

status yaml_read(config *cfg, const char *text, size_t length, int override, node **root)
{
    status st = OK;
    const size_t skip = case_text_bom(text, length);
    builder b = {.cfg = cfg, .text = text, .length = length, .override = override};
    *root = NULL;
    if (!yaml_parser_initialize(&b.parser)) {
        return status_fail(ERR_RESOURCE, "out of memory while starting libyaml");
    }
    yaml_parser_set_encoding(&b.parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&b.parser, (const unsigned char *)text + skip, length - skip);
    for (yaml_event_type_t type = YAML_NO_EVENT; type != YAML_STREAM_END_EVENT;) {
        yaml_event_t event;
        if (!yaml_parser_parse(&b.parser, &event)) {
            TRY(syntax_error(&b));
        }
        type = event.type;
        st = take_event(&b, &event);
        yaml_event_delete(&event);
        TRY(st);
    }
    *root = b.root;

done:
    name_set_free(&b.names);
    yaml_parser_delete(&b.parser);
    return st;
}
