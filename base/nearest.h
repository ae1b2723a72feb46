// base/nearest.h
// "did you mean ...?": the known name that is nearest to what was written.
#pragma once

enum { NEAREST_NAME = 64, NEAREST_WORDS = NEAREST_NAME + 24 };

typedef struct nearest {
    const char *written;
    int distance; // of `best`; one more than is near enough while there is none
    char best[NEAREST_NAME];
} nearest;

nearest nearest_to(const char *written);

// `candidate` is compared, `shown` is what a message will say.
void nearest_offer(nearest *n, const char *candidate, const char *shown);

// " (did you mean 'X'?)", or "" when nothing is near.
const char *nearest_words(const nearest *n, char words[NEAREST_WORDS]);

// Insertions, removals, replacements and swaps of neighbours that turn one into the other; both
// under NEAREST_NAME bytes, else a large number. Capital and small letters count as the same.
int nearest_distance(const char *a, const char *b);
