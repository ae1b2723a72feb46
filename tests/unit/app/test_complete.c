// tests/unit/app/test_complete.c
// What is offered while a command line is typed.
#include "app/complete.h"
#include "tests/test.h"

#include <string.h>

enum { MAX_WORDS = 8 };

static char written[1 << 16];

static const char *offered(const char *const words[MAX_WORDS])
{
    int n = 0;
    while (n < MAX_WORDS && words[n]) {
        n++;
    }
    FILE *stream = fmemopen(written, sizeof written, "w");
    written[0] = '\0'; // where nothing is offered, nothing is written
    complete(n, words, stream);
    (void)fclose(stream);
    return written;
}

#define OFFERED(...) offered((const char *const[MAX_WORDS]){__VA_ARGS__})

// whether a line begins so, up to its tab
static bool has(const char *text, const char *word)
{
    const size_t n = strlen(word);
    for (const char *p = text; p && *p; p = strchr(p, '\n') ? strchr(p, '\n') + 1 : NULL) {
        if (strncmp(p, word, n) == 0 && (p[n] == '\t' || p[n] == '\n')) {
            return true;
        }
    }
    return false;
}

static void words_are_those_of_the_tables(void)
{
    CHECK(has(OFFERED(""), "run") && has(written, "completion"));
    CHECK(has(OFFERED("ro"), "rod") && !has(written, "run"));
    CHECK(has(OFFERED("rod", "--"), "--set") && !has(written, "--markdown"));
    CHECK(has(OFFERED("schema", "--"), "--markdown") && !has(written, "--set"));
    CHECK(strcmp(OFFERED("rod", ""), ":files yaml yml\n") == 0);
    CHECK(strcmp(OFFERED("rod", "a.yaml", ""), "") == 0);
    CHECK(strcmp(OFFERED("material", "a.csv", ""), ":files csv txt dat tsv\n") == 0);
    CHECK(strcmp(OFFERED("run", "a.yaml", "--out", ""), ":directories\n") == 0);
    CHECK(has(OFFERED("man", ""), "case"));
}

static void keys_are_walked_through_maps_lists_and_names(void)
{
    CHECK(has(OFFERED("rod", "a.yaml", "--set", "ro"), "rod."));
    CHECK(has(OFFERED("--set", "rod.len"), "rod.length_mm=")); // the command may follow
    CHECK(has(OFFERED("rod", "--set", "rod.length_"), "rod.length_cm="));
    CHECK(has(OFFERED("rod", "--set", "materials.soft.E"), "materials.soft.E_MPa="));
    CHECK(has(OFFERED("rod", "--set", "rod.tendons.0.rad"), "rod.tendons.0.radius_mm="));
    CHECK(has(OFFERED("rod", "--set", "section.model="), "section.model=classical"));
}

// none of these is a key: nothing is offered, nothing is read beyond
static void nonsense_is_offered_nothing(void)
{
    char long_key[400];
    memset(long_key, 'x', sizeof long_key - 1);
    long_key[sizeof long_key - 1] = '\0';
    const char *const none[] = {"..",
                                ".",
                                "=",
                                "rod..",
                                "rod.length_mm.",
                                "rod.=",
                                "section.shapes.=",
                                "nothing.at.all",
                                "rod.length_mm=1=2",
                                long_key};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++) {
        CHECK(strcmp(OFFERED("rod", "--set", none[i]), "") == 0);
    }
    CHECK(strcmp(offered((const char *const[MAX_WORDS]){NULL}), OFFERED("")) == 0);
}

int main(void)
{
    words_are_those_of_the_tables();
    keys_are_walked_through_maps_lists_and_names();
    nonsense_is_offered_nothing();
    return test_failures != 0;
}
