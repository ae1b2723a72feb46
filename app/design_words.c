// app/design_words.c
// Arithmetic with names, and numbers in their place.
#include "app/design_case.h"
#include "base/memory.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum { NUMBER_ROOM = 32 }; // of "(%.17g)"

static bool begins_word(char c)
{
    return isalpha((unsigned char)c) || c == '_';
}

static bool goes_on(char c)
{
    return begins_word(c) || isdigit((unsigned char)c);
}

// 2, .5, 1e-3: the e of a number is no word
static size_t number_length(const char *at)
{
    size_t n = strspn(at, "0123456789.");
    if (n > 0 && (at[n] == 'e' || at[n] == 'E')) {
        const size_t sign = at[n + 1] == '+' || at[n + 1] == '-';
        const size_t digits = strspn(at + n + 1 + sign, "0123456789");
        n += digits > 0 ? 1 + sign + digits : 0;
    }
    return n;
}

static size_t word_length(const char *at)
{
    size_t n = 0;
    while (begins_word(at[0]) && goes_on(at[n])) {
        n++;
    }
    return n;
}

static int find(const char *word, size_t length, int n, const char *const *name)
{
    for (int i = 0; i < n; i++) {
        if (strlen(name[i]) == length && strncmp(name[i], word, length) == 0) {
            return i;
        }
    }
    return -1;
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\'' || c == '"';
}

// Whether the word is a key of a map, {x: 1, y: 2}, and not a part of `a ? b : c`: a brace or a
// comma stands before it, a colon behind.
static bool is_key(const char *text, const char *word, size_t length)
{
    const char *before = word, *behind = word + length;
    while (before > text && is_blank(before[-1])) {
        before--;
    }
    while (is_blank(*behind)) {
        behind++;
    }
    return *behind == ':' && before > text && (before[-1] == '{' || before[-1] == ',');
}

status design_words(const char *text, int n, const char *const *name, const double *value,
                    char **out)
{
    status st = OK;
    char *words = NULL;
    size_t used = 0;
    TRY(TAKE(words, (strlen(text) + 1) * NUMBER_ROOM));
    for (const char *at = text; *at;) {
        const size_t word = word_length(at), number = number_length(at);
        const size_t length = word + number > 0 ? word + number : 1; // one of them is 0
        const int i = word > 0 && !is_key(text, at, word) ? find(at, word, n, name) : -1;
        if (i >= 0) {
            const bool alone = strlen(text) == length;
            used +=
                (size_t)snprintf(words + used, NUMBER_ROOM, alone ? "%.17g" : "(%.17g)", value[i]);
        } else {
            memcpy(words + used, at, length);
            used += length;
        }
        at += length;
    }
    *out = words;

done:
    return st;
}
