// tests/fuzz/fuzz_config.c
// fuzz_config SECONDS [SEED]: mutated cases and overrides are read; each is taken or refused with
// one line, quickly.
//
// The input that is being read lies in /tmp/stiffaxis-test-PID.yaml: after a crash it is still
// there.
#include "io/config.h"
#include "tests/unit/io/case_file.h"

#include <stdint.h>

enum { ROOM = 16 << 10, MAX_CHANGES = 6 };

static const double MAX_SECONDS = 2; // for one case of at most ROOM bytes, under sanitizers

static const char *const seeds[] = {
    small_text,
    "format: 1\nmaterials: {a: {E_MPa: 1e3, nu: 0.3}}\nloads: [{force_N: [0, 0, -1/2], at: "
    "geometric_centre}]\n",
    "format: 1\nmaterials:\n  \"two words\": {E_kPa: 2*pi, nu: min(0.3, 0.4)}\nrod:\n  length_cm: "
    "12\n  tendons:\n"
    "  - radius_mm: 3 + sin(2*pi*s/L)^2\n    angle_deg: \"s < L/2 ? 90 : 180\"\n    end_mm: L\n",
    "title: |\n  several\n  lines\nformat: '1'\nmaterials: {}\nrod: {length_mm: 1e2, tensions_mN: "
    "[1, 2],\n  points: 3}\n",
};

static const char *const pieces[] = {
    "[",
    "]",
    "{",
    "}",
    ": ",
    "- ",
    "? ",
    ", ",
    "\n",
    "\n  ",
    "\t",
    "#",
    "&a ",
    "*a",
    "!!str ",
    "|\n",
    ">-\n",
    "'",
    "\"",
    "\\",
    "%",
    "---\n",
    "...\n",
    "@",
    "`",
    "s",
    "L",
    "pi",
    "sin(",
    "min(",
    ")",
    "(",
    "/0",
    "^",
    "**",
    "? :",
    "==",
    "=",
    "1e309",
    "nan",
    "-",
    ".",
    "0x",
    "_mm",
    "_m",
    "_",
    "length_m: 1\n",
    "<<: ",
    "\xEF\xBB\xBF",
    "\xC3\xA9",
    "\xFF",
    "\xE2\x80\xA8",
    "\xC2\x85",
    "true",
    "null",
    "~",
    "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[",
    "99999999999999999999",
};

static const char *const overrides[] = {
    "rod.length_mm=100",
    "rod.tensions_N=[[0.5,0]]",
    "section.shapes.1.sector.width_rad=pi/16",
    "materials.soft.E_kPa=500",
    "rod.tendons.t2.radius_mm=s",
    "title=",
    "loads.0={force_N: [1,2,3]}",
    "rod.length_m=0.1",
};

enum {
    NSEED = sizeof seeds / sizeof *seeds,
    NPIECE = sizeof pieces / sizeof *pieces,
    NOVERRIDE = sizeof overrides / sizeof *overrides,
};

typedef struct input {
    size_t length;
    char a[ROOM];
} input;

// xorshift64*
static uint64_t next(uint64_t *state)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return *state * 2685821657736338717u;
}

static size_t below(uint64_t *state, size_t n)
{
    return n ? (size_t)(next(state) >> 11) % n : 0;
}

static void splice(input *in, size_t at, size_t removed, const char *piece, size_t added)
{
    if (in->length - removed + added >= ROOM) {
        return;
    }
    memmove(in->a + at + added, in->a + at + removed, in->length - at - removed);
    memcpy(in->a + at, piece, added);
    in->length = in->length - removed + added;
}

// a digit becomes something that may still be arithmetic: gets past YAML, to the values
static void change_gently(input *in, uint64_t *state)
{
    static const char *const values[] = {"0", "7",  "-",  "(1)", ".",     "e2", "s",
                                         "L", "pi", "/3", "+1",  "1e308", "*L", "^s"};
    for (size_t tries = 0; tries < 100; tries++) {
        const size_t at = below(state, in->length);
        const char *value = values[below(state, sizeof values / sizeof *values)];
        if (in->a[at] >= '0' && in->a[at] <= '9') {
            splice(in, at, below(state, 2), value, strlen(value));
            return;
        }
    }
}

static void change(input *in, uint64_t *state)
{
    if (below(state, 2) == 0) {
        change_gently(in, state);
        return;
    }
    char copy[256];
    const size_t at = below(state, in->length + 1), left = in->length - at;
    const size_t n = below(state, left < sizeof copy ? left + 1 : sizeof copy);
    const char *piece = pieces[below(state, NPIECE)];
    const char byte = (char)next(state);
    switch (below(state, 6)) {
    case 0:
        splice(in, at, left > 0, &byte, 1);
        break;
    case 1:
        splice(in, at, n, "", 0);
        break;
    case 2:
        splice(in, at, 0, piece, strlen(piece));
        break;
    case 3:
        splice(in, at, n < 8 ? n : 8, piece, strlen(piece));
        break;
    case 4: // the same again, somewhere else
        memcpy(copy, in->a + at, n);
        splice(in, below(state, in->length + 1), 0, copy, n);
        break;
    default: // many times the same
        for (size_t i = 0; i < n; i++) {
            splice(in, at, 0, piece, strlen(piece));
        }
    }
}

static void start_from(input *in, const char *seed, uint64_t *state)
{
    in->length = 0;
    splice(in, 0, 0, seed, strlen(seed));
    for (size_t i = 1 + below(state, 1 + below(state, MAX_CHANGES)); i > 0; i--) {
        change(in, state);
    }
    in->a[in->length] = '\0';
}

// values along the rod are asked for as a solver would
static void use(const small_case *c)
{
    const small_tendon *tendon = c->rod.tendons.items;
    for (int i = 0; i < c->rod.tendons.count; i++) {
        (void)(field_at(&tendon[i].radius, 0.01) + field_at(&tendon[i].angle, 0.02));
    }
}

static const char *complaint(status st, double seconds)
{
    const char *message = status_message();
    if (st != OK && st != ERR_INPUT) {
        return "neither taken nor refused";
    }
    if (st == ERR_INPUT && (!strstr(message, ": error: ") || strchr(message, '\n'))) {
        return "not one line with 'error:'";
    }
    return seconds > MAX_SECONDS ? "too slow" : NULL;
}

static bool read_one(uint64_t *state, long *ntaken)
{
    static input text, set;
    config *cfg = NULL;
    small_case c;
    const char *const override = set.a;
    start_from(&text, seeds[below(state, NSEED)], state);
    start_from(&set, overrides[below(state, NOVERRIDE)], state);
    case_file_write(text.a, text.length);
    const double start = cpu_seconds();
    const status st = case_file_read(case_file_path, below(state, 4) == 0, &override, &c, &cfg);
    if (st == OK) {
        use(&c);
        (*ntaken)++;
    }
    config_free(cfg);
    const char *wrong = complaint(st, cpu_seconds() - start);
    if (wrong) {
        printf("%s: %s: %d %s\n", case_file_path, wrong, st, status_message());
    }
    status_clear();
    return !wrong;
}

int main(int argc, char **argv)
{
    const double seconds = argc > 1 ? strtod(argv[1], NULL) : 1;
    const uint64_t seed = argc > 2 ? strtoull(argv[2], NULL, 10) : (uint64_t)time(NULL);
    uint64_t state = seed * 2654435761u + 88172645463325252u;
    const double end = (double)time(NULL) + seconds;
    long nread = 0, ntaken = 0;
    printf("fuzz_config: seed %llu\n", (unsigned long long)seed);
    for (; (double)time(NULL) < end; nread++) {
        if (!read_one(&state, &ntaken)) {
            return 1;
        }
    }
    (void)remove(case_file_path);
    printf("fuzz_config: %ld cases read, %ld of them taken\n", nread, ntaken);
    return 0;
}
