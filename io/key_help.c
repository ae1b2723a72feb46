// io/key_help.c
// One line for a key that somebody wrote.
#include "io/key_names.h"
#include "io/key_words.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// limits beyond these, and those of angles, only keep out mistakes of unit: nobody needs to be told
static const double LEAST_TOLD = 1e-6, MOST_TOLD = 1e5;
// an explanation longer than this ends at its first stop
enum { LONG_ABOUT = 95, SHORT_ABOUT = 20 };

static bool names_all_choices(const key *k)
{
    char choice[KEY_NAME_TEXT];
    for (const char *p = k->choices; *p; p += *p == '|') {
        const size_t n = strcspn(p, "|");
        (void)snprintf(choice, sizeof choice, "%.*s", (int)n, p);
        if (!strstr(k->about, choice)) {
            return false;
        }
        p += n;
    }
    return true;
}

static size_t length_told(const key *k)
{
    const char *about = k->about;
    const size_t whole = strlen(about);
    if (k->kind == KEY_CHOICE) {
        return whole; // each choice has its word there
    }
    for (const char *stop = strstr(about, "; "); whole > LONG_ABOUT && stop;
         stop = strstr(stop + 1, "; ")) {
        if (stop - about >= SHORT_ABOUT) {
            return (size_t)(stop - about);
        }
    }
    return whole;
}

static void limits(const key *k, const unit *u, char words[KEY_WORDS])
{
    const double low = unit_from_si(u, k->min), high = unit_from_si(u, k->max);
    const char *space = u->name[0] ? " " : "";
    const bool lowest = low == 0 || fabs(low) >= LEAST_TOLD, highest = fabs(high) <= MOST_TOLD;
    words[0] = '\0';
    if ((k->min == 0 && k->max == 0) || k->dimension == DIM_ANGLE || fabs(low) > MOST_TOLD ||
        low == high) {
        return;
    }
    if (lowest && highest) {
        (void)snprintf(words, KEY_WORDS, "; %.6g to %.6g%s%s", low, high, space, u->name);
    } else if (highest) {
        (void)snprintf(words, KEY_WORDS, "; at most %.6g%s%s", high, space, u->name);
    }
}

// "clamped, free_to_contract or free: "
static size_t list_choices(const char *choices, char words[KEY_WORDS])
{
    size_t n = 0;
    const char *last = strrchr(choices, '|');
    for (const char *p = choices; *p && n < KEY_WORDS - 8; p++) {
        n += (size_t)snprintf(words + n, KEY_WORDS - n, "%.*s",
                              *p != '|'   ? 1
                              : p == last ? 4
                                          : 2,
                              *p != '|'   ? p
                              : p == last ? " or "
                                          : ", ");
    }
    return n + (size_t)snprintf(words + n, KEY_WORDS - n, ": ");
}

void key_help(const key *k, const unit *u, char words[KEY_WORDS])
{
    char range[KEY_WORDS];
    size_t n = 0;
    words[0] = '\0';
    if (k->kind == KEY_CHOICE && !names_all_choices(k)) {
        n = list_choices(k->choices, words);
    }
    n += (size_t)snprintf(words + n, KEY_WORDS - n, "%.*s", (int)length_told(k), k->about);
    limits(k, u, range);
    if (n < KEY_WORDS) {
        n += (size_t)snprintf(words + n, KEY_WORDS - n, "%s", range);
    }
    if (n < KEY_WORDS && k->initial && k->initial[0] && !k->required) {
        (void)snprintf(words + n, KEY_WORDS - n, "; default %s", k->initial);
    }
}
