#include "section/section.h"

#include <stdio.h>

const char *section_effort_words(const section_effort *e, char words[SECTION_EFFORT_WORDS])
{
    const struct {
        int count;
        const char *what;
    } rest[] = {
        {e->nstored, "unchanged since the last result"},
        {e->nsame, "equal to others"},
        {e->nturned, "turned copies"},
        {e->nscaled, "scaled copies"},
        {e->nmirrored, "mirrored copies"},
    };
    int at = snprintf(words, SECTION_EFFORT_WORDS, "%d section%s solved%s", e->nsolved,
                      e->nsolved == 1 ? "" : "s", e->meshed ? "" : " in closed form, no mesh");
    for (size_t i = 0; i < sizeof rest / sizeof *rest; i++) {
        if (rest[i].count > 0 && at < SECTION_EFFORT_WORDS) {
            at += snprintf(words + at, (size_t)(SECTION_EFFORT_WORDS - at), ", %d %s",
                           rest[i].count, rest[i].what);
        }
    }
    return words;
}
