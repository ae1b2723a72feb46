// base/nearest.c
#include "base/nearest.h"

#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static int smaller(int a, int b)
{
    return a < b ? a : b;
}

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

int nearest_distance(const char *a, const char *b)
{
    const size_t na = strlen(a), nb = strlen(b);
    if (na >= NEAREST_NAME || nb >= NEAREST_NAME) {
        return INT_MAX;
    }
    int row[3][NEAREST_NAME + 1];
    int *before = row[0], *last = row[1], *now = row[2];
    for (size_t j = 0; j <= nb; j++) {
        last[j] = (int)j;
    }
    for (size_t i = 1; i <= na; i++) {
        now[0] = (int)i;
        for (size_t j = 1; j <= nb; j++) {
            now[j] = smaller(smaller(last[j], now[j - 1]) + 1,
                             last[j - 1] + (lower(a[i - 1]) != lower(b[j - 1])));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                now[j] = smaller(now[j], before[j - 2] + 1);
            }
        }
        int *oldest = before;
        before = last;
        last = now;
        now = oldest;
    }
    return last[nb];
}

// one slip in three letters is still a misspelling (one in two for the shortest), more is another
// word
static int near_enough(const char *written)
{
    return (int)(strlen(written) / 3) + (strlen(written) == 2);
}

nearest nearest_to(const char *written)
{
    return (nearest){.written = written, .distance = near_enough(written) + 1};
}

// three letters or more that a name begins with: whoever stopped there meant it
static bool begins(const char *written, const char *candidate)
{
    const size_t n = strlen(written);
    for (size_t i = 0; i < n; i++) {
        if (lower(written[i]) != lower(candidate[i])) {
            return false;
        }
    }
    return n >= 3;
}

void nearest_offer(nearest *n, const char *candidate, const char *shown)
{
    int distance = nearest_distance(n->written, candidate);
    if (begins(n->written, candidate)) {
        distance = smaller(distance, near_enough(n->written));
    }
    if (distance < n->distance) {
        n->distance = distance;
        (void)snprintf(n->best, sizeof n->best, "%s", shown);
    }
}

const char *nearest_words(const nearest *n, char words[NEAREST_WORDS])
{
    words[0] = '\0';
    if (n->best[0]) {
        (void)snprintf(words, NEAREST_WORDS, " (did you mean '%s'?)", n->best);
    }
    return words;
}
