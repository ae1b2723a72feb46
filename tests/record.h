// tests/record.h
// What a test judges, told: with STIFFAXIS_VERIFICATION=DIR each check leaves its numbers in
// DIR/<room>.<program>.jsonl, from the macro that judges them, so that the page of
// docs/verification.md can say nothing else than the tests. A line is one JSON object: a check, the
// rest of a place that checks often (how many, and the worst), a series whose slope is judged, or
// the end.
#pragma once

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

// what the wanted numbers of a check stand on, docs/verification.md
typedef enum verified_by {
    BY_CLOSED_FORM, // a formula, or what holds exactly
    BY_PUBLISHED,   // digits that others have printed
    BY_OTHER_CODE,  // a program that shares no line with ours
    BY_SECOND_WAY,  // another method of our own, or a much finer run
    BY_SYMMETRY,    // the same thing turned, mirrored, in other units; balances
    BY_MADE_DATA,   // data made from a truth that is known
} verified_by;

typedef struct record_numbers {
    double value, wanted, error,
        tolerance; // error and tolerance in the same unit; NaN for a bare condition
    bool holds;
    bool least; // wanted is the least that value may be
} record_numbers;

// one place in a test's text that judges, however often
typedef struct record_place {
    const char *file, *function, *what;
    int line;
    int told, rest, rest_failed;
    record_numbers worst; // of the rest
    verified_by way;      // of the rest
    const char *source;
    struct record_place *next;
} record_place;

enum { RECORD_TOLD = 40, RECORD_WORDS = 200 };

static struct {
    FILE *to;
    bool tried;
    long process;
    verified_by way;
    const char *source;
    const char *about_in; // a function
    char about[RECORD_WORDS];
    record_place *places;
} record_state;

// what the checks that follow in this function are about, as a row of a table would be named
#define about(...) record_about(__func__, __VA_ARGS__)

static inline void record_about(const char *function, const char *format, ...)
{
    va_list words;
    va_start(words, format);
    (void)vsnprintf(record_state.about, sizeof record_state.about, format, words);
    va_end(words);
    record_state.about_in = function;
}

static inline const char *record_about_of(const char *function)
{
    return record_state.about_in == function ? record_state.about : "";
}

static inline void record_text(const char *name, const char *text)
{
    FILE *to = record_state.to;
    (void)fprintf(to, ",\"%s\":\"", name);
    for (; *text; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c == '"' || c == '\\') {
            (void)fprintf(to, "\\%c", c);
        } else {
            (void)fprintf(to, c < 32 ? "\\u%04x" : "%c", c);
        }
    }
    (void)fputc('"', to);
}

static inline void record_number(const char *name, double x)
{
    if (isfinite(x)) {
        (void)fprintf(record_state.to, ",\"%s\":%.17g", name, x);
    } else {
        (void)fprintf(record_state.to, ",\"%s\":%s", name,
                      isnan(x) ? "null"
                      : x > 0  ? "1e999"
                               : "-1e999");
    }
}

// files are named from tests/ on, whatever the build's folder
static inline const char *record_from_tests(const char *path)
{
    const char *last = path;
    for (const char *p = path; (p = strstr(p, "tests/")) != NULL; p++) {
        last = p;
    }
    return last;
}

static inline void record_judged(const record_place *place, const char *about_what, verified_by way,
                                 const char *source, const record_numbers *j)
{
    static const char *const ways[] = {"closed form", "published", "other code",
                                       "second way",  "symmetry",  "made data"};
    record_text("file", record_from_tests(place->file));
    record_number("line", place->line);
    record_text("function", place->function);
    record_text("what", place->what);
    record_text("about", about_what);
    record_text("way", source ? ways[way] : "");
    record_text("source", source ? source : "");
    record_number("value", j->value);
    record_number("wanted", j->wanted);
    record_number("error", j->error);
    record_number("tolerance", j->tolerance);
    (void)fprintf(record_state.to, ",\"least\":%s,\"holds\":%s", j->least ? "true" : "false",
                  j->holds ? "true" : "false");
}

// what a place judged beyond what was told one by one
static inline void record_rest(record_place *place)
{
    if (place->rest > 0) {
        (void)fprintf(record_state.to, "{\"kind\":\"rest\",\"count\":%d,\"failed\":%d", place->rest,
                      place->rest_failed);
        record_judged(place, "", place->way, place->source, &place->worst);
        (void)fputs("}\n", record_state.to);
        place->rest = place->rest_failed = 0;
    }
}

static inline void record_end(void)
{
    FILE *to = record_state.to;
    if (!to || record_state.process != getpid()) {
        return;
    }
    for (record_place *p = record_state.places; p; p = p->next) {
        record_rest(p);
    }
    (void)fprintf(to, "{\"kind\":\"end\",\"cpu_s\":%.3f}\n", (double)clock() / CLOCKS_PER_SEC);
    (void)fclose(to);
    record_state.to = NULL;
}

// tests/verify/section/verify_becas.c goes to section.verify_becas.jsonl
static inline bool record_open(void)
{
    const char *dir = getenv("STIFFAXIS_VERIFICATION"), *name = __BASE_FILE__, *room = name;
    if (record_state.tried || !dir || !*dir) {
        return record_state.to != NULL;
    }
    record_state.tried = true;
    for (const char *p = name; (p = strchr(p, '/')) != NULL; p++) {
        room = name;
        name = p + 1;
    }
    char path[4096];
    const int n = snprintf(path, sizeof path, "%s/%.*s.%.*s.jsonl", dir, (int)strcspn(room, "/"),
                           room, (int)strcspn(name, "."), name);
    record_state.to = n > 0 && n < (int)sizeof path ? fopen(path, "w") : NULL;
    if (!record_state.to) {
        (void)fprintf(stderr, "cannot record into %s\n", path);
        exit(1);
    }
    record_state.process = getpid();
    (void)atexit(record_end);
    return true;
}

// The checks that follow stand on this; source is who says so, with the edition where it has one.
// Said once a function or a program.
static inline void against(verified_by way, const char *source)
{
    record_state.way = way;
    record_state.source = source;
    (void)record_open();
}

// error as a share of what is allowed, the least as a share of what there is; what is no number is
// worse than all
static inline double record_share(const record_numbers *j)
{
    if (j->least) {
        return j->wanted <= 0 && j->holds ? 0 : j->value > 0 ? j->wanted / j->value : HUGE_VAL;
    }
    if (!(j->error <= j->tolerance)) {
        return j->error / j->tolerance >= 0 ? j->error / j->tolerance : HUGE_VAL;
    }
    return j->tolerance > 0 ? j->error / j->tolerance : 0;
}

static inline void record(record_place *place, const char *function, record_numbers j)
{
    if (!record_open() || record_state.process != getpid()) {
        return;
    }
    if (!place->function) {
        place->function = function;
        place->next = record_state.places;
        record_state.places = place;
    }
    const bool bare = isnan(j.tolerance);
    if (place->told < RECORD_TOLD && !(bare && j.holds)) {
        place->told++;
        (void)fputs("{\"kind\":\"check\"", record_state.to);
        record_judged(place, record_about_of(function), record_state.way, record_state.source, &j);
        (void)fputs("}\n", record_state.to);
        return;
    }
    if (place->source != record_state.source) {
        record_rest(place);
    }
    place->way = record_state.way;
    place->source = record_state.source;
    if (place->rest == 0 || (!j.holds && place->worst.holds) ||
        (!bare && record_share(&j) > record_share(&place->worst))) {
        place->worst = j;
    }
    place->rest++;
    place->rest_failed += !j.holds;
}

// the points of a slope, before it is judged
static inline void record_series(const char *function, const char *what, const char *over, int n,
                                 const double *h, const double *error, double slope)
{
    if (!record_open() || record_state.process != getpid()) {
        return;
    }
    FILE *to = record_state.to;
    (void)fputs("{\"kind\":\"series\"", to);
    record_text("function", function);
    record_text("what", what);
    record_text("over", over);
    record_text("about", record_about_of(function));
    record_number("slope", slope);
    (void)fputs(",\"points\":[", to);
    for (int i = 0; i < n; i++) {
        const bool drawn = isfinite(h[i]) && isfinite(error[i]);
        (void)fprintf(to, i ? ",[%.9g,%.9g]" : "[%.9g,%.9g]", drawn ? h[i] : 0,
                      drawn ? error[i] : 0);
    }
    (void)fputs("]}\n", to);
}
