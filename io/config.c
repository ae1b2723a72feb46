// io/config.c
#include "io/config.h"

#include "base/memory.h"
#include "io/case_text.h"
#include "io/case_tree.h"
#include "io/override.h"
#include "io/utf8.h"
#include "io/yaml_door.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

// of a message's parts, so that the whole fits into what base/status keeps
enum { PATH_SHOWN = 300, OVERRIDE_SHOWN = 120, WORDS_SHOWN = 600 };

static status copy_overrides(config *cfg, int count, const char *const *overrides)
{
    status st = OK;
    TRY(ARENA_TAKE(cfg->memory, cfg->overrides, (size_t)count));
    cfg->noverride = count;
    for (int i = 0; i < count; i++) {
        TRY(arena_copy(cfg->memory, overrides[i], strlen(overrides[i]), &cfg->overrides[i]));
    }

done:
    return st;
}

static status read_tree(config *cfg)
{
    status st = OK;
    TRY(case_text_check(cfg, cfg->text, cfg->length, -1));
    TRY(yaml_read(cfg, cfg->text, cfg->length, -1, &cfg->root));
    if (!cfg->root) {
        TRY(config_fail(cfg, (mark){1, 1}, "the case is empty"));
    }
    if (cfg->root->kind != NODE_MAP) {
        TRY(config_fail(cfg, cfg->root->at, "a case is a map of keys (`format: 1` ...), not a %s",
                        cfg->root->kind == NODE_LIST ? "list" : "single value"));
    }
    TRY(override_apply(cfg));

done:
    return st;
}

status config_open(const char *path, int noverride, const char *const *overrides, config **out)
{
    status st = OK;
    config *cfg = NULL;
    *out = NULL;
    TRY(TAKE(cfg, 1));
    TRY(arena_make(&cfg->memory));
    TRY(calculator_make(&cfg->arithmetic));
    TRY(TAKE(cfg->path, strlen(path) + 1));
    memcpy(cfg->path, path, strlen(path));
    TRY(copy_overrides(cfg, noverride, overrides));
    TRY(case_text_load(cfg));
    TRY(read_tree(cfg));
    *out = cfg;
    cfg = NULL;

done:
    config_free(cfg);
    return st;
}

void config_free(config *cfg)
{
    if (cfg) {
        calculator_free(cfg->arithmetic);
        arena_free(cfg->memory);
        free(cfg->text);
        free(cfg->path);
    }
    free(cfg);
}

const char *config_path(const config *cfg)
{
    return cfg->path;
}

const char *config_text(const config *cfg, size_t *length)
{
    *length = cfg->length;
    return cfg->text;
}

void config_set_length(config *cfg, double L_m)
{
    cfg->length_m = L_m;
    cfg->has_length = true;
}

short_text shortened(const char *text)
{
    short_text out;
    const size_t room = sizeof out.a - 1, length = strlen(text);
    if (length <= room) {
        memcpy(out.a, text, length + 1);
    } else {
        (void)snprintf(out.a, sizeof out.a, "%.*s...", (int)room - 3, text);
    }
    return out;
}

// '?' for what would break the line or play with the terminal, and for a character that was cut in
// two
static void make_plain(char *text)
{
    char *to = text;
    for (size_t left = strlen(text); left > 0;) {
        uint32_t point = 0;
        const int n = utf8_read(text, left, &point);
        if (n > 0 && utf8_is_plain(point)) {
            memmove(to, text, (size_t)n);
            to += n;
        } else {
            *to++ = '?';
        }
        text += n ? n : 1;
        left -= (size_t)(n ? n : 1);
    }
    *to = '\0';
}

// the end of a long path says more than its beginning
static void path_words(const config *cfg, char *words, size_t size)
{
    const char *path = strcmp(cfg->path, "-") == 0 ? "<stdin>" : cfg->path;
    const size_t length = strlen(path);
    if (length < size) {
        (void)snprintf(words, size, "%s", path);
    } else {
        (void)snprintf(words, size, "...%s", path + length - (size - 4));
    }
    make_plain(words);
}

void config_place_text(const config *cfg, mark at, char text[CONFIG_PLACE_TEXT])
{
    char where[PATH_SHOWN];
    const int i = at.line - OVERRIDE_LINE;
    if (i >= 0 && i < cfg->noverride) {
        (void)snprintf(where, OVERRIDE_SHOWN, "%s", cfg->overrides[i]);
        make_plain(where);
        (void)snprintf(text, CONFIG_PLACE_TEXT, "--set '%s': ", where);
        return;
    }
    path_words(cfg, where, sizeof where);
    (void)snprintf(text, CONFIG_PLACE_TEXT, "%s:%d:%d: ", where, at.line > 0 ? at.line : 1,
                   at.column > 0 ? at.column : 1);
}

status config_fail(const config *cfg, mark at, const char *format, ...)
{
    char words[WORDS_SHOWN], where[CONFIG_PLACE_TEXT];
    va_list args;
    va_start(args, format);
    (void)vsnprintf(words, sizeof words, format, args);
    va_end(args);
    make_plain(words);
    config_place_text(cfg, at, where);
    return status_fail(ERR_INPUT, "%serror: %s", where, words);
}
