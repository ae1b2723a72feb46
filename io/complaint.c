// io/complaint.c
// What is said about a case, and where.
#include "io/case_tree.h"
#include "io/config.h"
#include "io/utf8.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

// of a message's parts, so that the whole fits into what base/status keeps
enum { PATH_SHOWN = 300, OVERRIDE_SHOWN = 120, WORDS_SHOWN = 600 };

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
    utf8_make_plain(words);
}

void config_place_text(const config *cfg, mark at, char text[CONFIG_PLACE_TEXT])
{
    char where[PATH_SHOWN];
    const int i = at.line - OVERRIDE_LINE;
    if (i >= 0 && i < cfg->noverride) {
        (void)snprintf(where, OVERRIDE_SHOWN, "%s", cfg->overrides[i]);
        utf8_make_plain(where);
        (void)snprintf(text, CONFIG_PLACE_TEXT, "--set '%s': ", where);
        return;
    }
    path_words(cfg, where, sizeof where);
    if (at.line == WHOLE_FILE_LINE) {
        (void)snprintf(text, CONFIG_PLACE_TEXT, "%s: ", where);
        return;
    }
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
    utf8_make_plain(words);
    config_place_text(cfg, at, where);
    return status_fail(ERR_INPUT, "%serror: %s", where, words);
}
