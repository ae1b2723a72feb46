// tests/fuzz/mutate.h
// Mutated files for a reader: bytes, numbers, lines and lengths of sound files are spoiled, each is
// read, and the reader must answer in time with OK or with one line; nothing else may appear in the
// folder.
#pragma once

#include "base/status.h"

#include <dirent.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { MUTANT_SECONDS = 20 };

typedef struct mutant_seed {
    const unsigned char *bytes;
    size_t count;
} mutant_seed;

// Reads one file of the folder; all that it made is freed again. A message stays in status_message.
typedef status (*mutant_reader)(const char *directory, const char *name, void *context);

typedef struct mutant_plan {
    int nseed;
    const mutant_seed *seeds;
    const char *suffix; // ".msh"
    mutant_reader read;
    void *context;
    uint64_t state; // of the random numbers; any but 0
} mutant_plan;

// xorshift64*
static inline uint64_t mutant_draw(mutant_plan *p)
{
    p->state ^= p->state >> 12;
    p->state ^= p->state << 25;
    p->state ^= p->state >> 27;
    return p->state * 2685821657736338717u;
}

static inline size_t mutant_below(mutant_plan *p, size_t n)
{
    return n > 0 ? (size_t)(mutant_draw(p) >> 11) % n : 0;
}

typedef struct mutant {
    unsigned char *bytes; // room for `room`
    size_t count, room;
} mutant;

// replaces `gone` bytes at `at` by `new`
static inline void mutant_replace(mutant *m, size_t at, size_t gone, const void *new, size_t count)
{
    if (at + gone > m->count || m->count - gone + count > m->room) {
        return;
    }
    memmove(m->bytes + at + count, m->bytes + at + gone, m->count - at - gone);
    memcpy(m->bytes + at, new, count);
    m->count += count - gone;
}

static inline void mutant_spoil_number(mutant_plan *p, mutant *m)
{
    static const char *const odd[] = {
        "-1",     "0",          "99999999999999999999", "2147483647", "nan", "-inf", "1e999",
        "1e-300", "4294967296", "-2147483648",          "1e18",       "3",   "0x10", "",
        "1.5",    "1000000000"};
    size_t at = mutant_below(p, m->count), gone = 0;
    while (at < m->count && !(m->bytes[at] >= '0' && m->bytes[at] <= '9')) {
        at++;
    }
    while (at + gone < m->count && strchr("0123456789.eE+-", m->bytes[at + gone]) &&
           m->bytes[at + gone] != 0) {
        gone++;
    }
    const char *new = odd[mutant_below(p, sizeof odd / sizeof *odd)];
    mutant_replace(m, at, gone, new, strlen(new));
}

// a piece of the file goes, comes twice, or lands elsewhere; whole lines half of the time
static inline void mutant_move_piece(mutant_plan *p, mutant *m)
{
    unsigned char piece[256];
    size_t from = mutant_below(p, m->count), count = 1 + mutant_below(p, sizeof piece - 1);
    if (mutant_below(p, 2)) {
        while (from > 0 && m->bytes[from - 1] != '\n') {
            from--;
        }
        count = 0;
        while (from + count < m->count && count + 1 < sizeof piece &&
               (count == 0 || m->bytes[from + count - 1] != '\n')) {
            count++;
        }
    }
    count = from + count > m->count ? m->count - from : count;
    memcpy(piece, m->bytes + from, count);
    if (mutant_below(p, 3)) {
        mutant_replace(m, from, count, "", 0);
    }
    if (mutant_below(p, 2)) {
        mutant_replace(m, mutant_below(p, m->count), 0, piece, count);
    }
}

static inline void mutant_change(mutant_plan *p, mutant *m)
{
    static const char *const words[] = {
        "$",    "\n",       "\n\n", " ",     "\"",      "SystemCall \"id\";",
        "%s%n", "\xff\xfe", "$End", "EOF\n", "../../x", "-"};
    const char *word = words[mutant_below(p, sizeof words / sizeof *words)];
    switch (mutant_below(p, 7)) {
    case 0: // a bit
        if (m->count > 0) {
            m->bytes[mutant_below(p, m->count)] ^= (unsigned char)(1u << mutant_below(p, 8));
        }
        break;
    case 1: // a byte
        if (m->count > 0) {
            m->bytes[mutant_below(p, m->count)] = (unsigned char)mutant_below(p, 256);
        }
        break;
    case 2: // cut short
        if (mutant_below(p, 4) == 0) {
            m->count = mutant_below(p, m->count + 1);
        }
        break;
    case 3:
        mutant_move_piece(p, m);
        break;
    case 4:
        mutant_replace(m, mutant_below(p, m->count), 0, word, strlen(word));
        break;
    default:
        mutant_spoil_number(p, m);
    }
}

static inline void mutant_make(mutant_plan *p, mutant *m)
{
    const mutant_seed *seed = &p->seeds[mutant_below(p, (size_t)p->nseed)];
    memcpy(m->bytes, seed->bytes, seed->count);
    m->count = seed->count;
    const size_t changes = 1 + mutant_below(p, mutant_below(p, 3) ? 4 : 40);
    for (size_t i = 0; i < changes; i++) {
        mutant_change(p, m);
    }
}

// how many entries the folder has, without . and ..
static inline int mutant_entries(const char *directory)
{
    int count = 0;
    DIR *d = opendir(directory);
    while (d && readdir(d)) {
        count++;
    }
    if (d) {
        (void)closedir(d);
    }
    return count - 2;
}

static inline bool mutant_write(const char *directory, const char *name, const mutant *m)
{
    char path[512];
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    FILE *f = fopen(path, "wb");
    const bool whole = f && fwrite(m->bytes, 1, m->count, f) == m->count;
    return f && fclose(f) == 0 && whole;
}

// one file read; what is wrong with the answer, or NULL
static inline const char *mutant_judge(mutant_plan *p, const char *directory, const char *name)
{
    status_clear();
    (void)alarm(MUTANT_SECONDS); // a hang ends the program
    const status st = p->read(directory, name, p->context);
    (void)alarm(0);
    const char *words = status_message();
    const bool known =
        st == OK || st == ERR_INPUT || st == ERR_FILE || st == ERR_NUMERIC || st == ERR_RESOURCE;
    if (!known) {
        return "a status that no input may lead to";
    }
    if (st != OK && (words[0] == 0 || strchr(words, '\n'))) {
        return "an error without its one line";
    }
    return mutant_entries(directory) == 1 ? NULL : "another file in the folder";
}

// `count` mutants, or as many as `seconds` allow where count is 0. Returns how many were answered
// wrongly; a failing file is kept, and its folder named.
static inline int mutants_run(mutant_plan *p, int count, double seconds)
{
    char directory[] = "/tmp/stiffaxis-mutants-XXXXXX", name[64], path[512];
    mutant m = {.room = 1 << 16};
    int wrong = 0, done = 0, accepted = 0;
    for (int i = 0; i < p->nseed; i++) {
        m.room = p->seeds[i].count * 2 > m.room ? p->seeds[i].count * 2 : m.room;
    }
    m.bytes = malloc(m.room + 1);
    if (!m.bytes || !mkdtemp(directory)) {
        free(m.bytes);
        return 1;
    }
    (void)snprintf(name, sizeof name, "mutant%s", p->suffix);
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    const time_t begin = time(NULL);
    while (wrong == 0 && (count > 0 ? done < count : difftime(time(NULL), begin) < seconds)) {
        mutant_make(p, &m);
        const char *why = mutant_write(directory, name, &m) ? mutant_judge(p, directory, name)
                                                            : "the file could not be written";
        accepted += status_message()[0] == 0;
        done++;
        if (why) {
            (void)fprintf(stderr, "mutant %d, %s: %s (%s)\n", done, path, why, status_message());
            wrong++;
        }
    }
    (void)printf("%d mutants of %d files, %d still sound\n", done, p->nseed, accepted);
    if (wrong == 0) {
        (void)remove(path);
        (void)rmdir(directory);
    }
    free(m.bytes);
    return wrong;
}

// fuzz_x SECONDS [SEED]
static inline int mutants_main(int argc, char **argv, mutant_plan plan)
{
    const double seconds = argc > 1 ? strtod(argv[1], NULL) : 5;
    plan.state = argc > 2 ? strtoull(argv[2], NULL, 10) : (uint64_t)time(NULL);
    plan.state += plan.state == 0;
    return mutants_run(&plan, 0, seconds) != 0;
}
