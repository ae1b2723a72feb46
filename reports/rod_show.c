// reports/rod_show.c
#include "reports/rod_show.h"

#include "base/memory.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    SHAPES_OF_A_SWEEP = 24,  // more cover each other
    SHAPES_OTHERWISE = 60,   // as many as a sheet bears
    DETAILS_OF_A_SWEEP = 3,  // first, middle and last
    DETAILS_OTHERWISE = 4,   // arrows on more cover each other
    LEAST_SWEEP = 8,         // solutions in a line that is worth a curve of its tips
    POINTS_OF_A_CURVE = 501, // finer than the paper
    FAMILIES_UP_TO = 240,    // solutions that are told apart by what pulls them
    TURNS_PER_SOLUTIONS = 8, // a line that turns around more often is no sweep but chance
};

double rod_quantity_value(const struct rod_run *run, rod_quantity q)
{
    switch (q.kind) {
    case GIVEN_TENSION:
        return isnan(run->pull[q.index]) ? run->tension[q.index] : 0;
    case GIVEN_PULL:
        return isnan(run->pull[q.index]) ? 0 : 1e3 * run->pull[q.index];
    default:
        return run->load[q.index];
    }
}

const char *rod_quantity_unit(rod_quantity q)
{
    static const char *const units[GIVEN_KINDS] = {"N", "mm", ""};
    return units[q.kind];
}

void rod_quantity_name(const rod_result *rod, rod_quantity q, char *text, size_t size)
{
    static const char *const forms[GIVEN_KINDS] = {"tension of %s", "%s drawn", "factor of %s"};
    const char *name = q.kind == GIVEN_LOAD ? rod->load_name[q.index] : rod->tendon_name[q.index];
    (void)snprintf(text, size, forms[q.kind], name);
}

// --- lines of a sweep

static int quantity_count(const rod_result *rod)
{
    return 2 * rod->ntendon + rod->nload;
}

static rod_quantity quantity_at(const rod_result *rod, int i)
{
    if (i < rod->ntendon) {
        return (rod_quantity){GIVEN_TENSION, i};
    }
    i -= rod->ntendon;
    return i < rod->ntendon ? (rod_quantity){GIVEN_PULL, i}
                            : (rod_quantity){GIVEN_LOAD, i - rod->ntendon};
}

static bool changes(const rod_result *rod, int solution, rod_quantity q)
{
    return rod_quantity_value(&rod->run[solution], q) !=
           rod_quantity_value(&rod->run[solution - 1], q);
}

// whether the same quantities change from a - 1 to a and from b - 1 to b
static bool same_step(const rod_result *rod, int a, int b)
{
    for (int i = 0; i < quantity_count(rod); i++) {
        const rod_quantity q = quantity_at(rod, i);
        if (changes(rod, a, q) != changes(rod, b, q)) {
            return false;
        }
    }
    return true;
}

// tensions before pulled lengths before factors; of these the one that goes furthest
static rod_quantity find_lead(const rod_result *rod, int first, int count)
{
    rod_quantity lead = {GIVEN_TENSION, 0};
    double most = 0;
    for (int i = 0; i < quantity_count(rod); i++) {
        const rod_quantity q = quantity_at(rod, i);
        double low = INFINITY, high = -INFINITY;
        for (int k = first; k < first + count; k++) {
            low = fmin(low, rod_quantity_value(&rod->run[k], q));
            high = fmax(high, rod_quantity_value(&rod->run[k], q));
        }
        if (high - low > most && (most == 0 || q.kind == lead.kind)) {
            most = high - low;
            lead = q;
        }
    }
    return lead;
}

static bool is_sweep(const rod_result *rod, const rod_line *l)
{
    int turns = 0;
    double before = 0;
    for (int k = l->first + 1; k < l->first + l->count; k++) {
        const double step = rod_quantity_value(&rod->run[k], l->lead) -
                            rod_quantity_value(&rod->run[k - 1], l->lead);
        turns += step * before < 0;
        before = step != 0 ? step : before;
    }
    return l->count >= LEAST_SWEEP && TURNS_PER_SOLUTIONS * turns <= l->count;
}

static status find_lines(rod_show *s)
{
    status st = OK;
    const rod_result *rod = s->rod;
    TRY(TAKE(s->line, (size_t)rod->nsolution));
    for (int i = 0; i < rod->nsolution; i++) {
        rod_line *l = s->nline > 0 ? &s->line[s->nline - 1] : NULL;
        if (l && (l->count == 1 || same_step(rod, i, i - 1))) {
            l->count++;
        } else {
            s->line[s->nline++] = (rod_line){.first = i, .count = 1};
        }
    }
    for (int i = 0; i < s->nline; i++) {
        s->line[i].lead = find_lead(rod, s->line[i].first, s->line[i].count);
        s->sweep = s->sweep || is_sweep(rod, &s->line[i]);
    }

done:
    return st;
}

int rod_show_line_of(const rod_show *s, int solution)
{
    int low = 0, high = s->nline;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        *(s->line[middle].first <= solution ? &low : &high) = middle;
    }
    return low;
}

// --- which are drawn

int rod_spread(int n, int most, int *out)
{
    const int count = n < most ? n : most;
    for (int i = 0; i < count; i++) {
        out[i] = count == 1 ? n - 1 : (int)lround((double)i * (n - 1) / (count - 1));
    }
    return count;
}

void rod_show_words(const rod_show *s, char *words, size_t size)
{
    if (s->nshown == s->rod->nsolution) {
        (void)snprintf(words, size, "all solutions");
    } else {
        (void)snprintf(words, size, "%d of %d solutions, %s", s->nshown, s->rod->nsolution,
                       s->sweep ? "spread over the sweep" : "at equal steps");
    }
}

static status choose(rod_show *s)
{
    status st = OK;
    const int n = s->rod->nsolution;
    TRY(TAKE(s->shown, SHAPES_OTHERWISE));
    s->nshown = rod_spread(n, s->sweep ? SHAPES_OF_A_SWEEP : SHAPES_OTHERWISE, s->shown);
    s->ndetail = rod_spread(n, s->sweep ? DETAILS_OF_A_SWEEP : DETAILS_OTHERWISE, s->detail);

done:
    return st;
}

// --- colours

typedef struct pull {
    uint64_t who;    // pulls or loads the rod: equal for solutions of one family
    double strength; // by which a family is ordered
} pull;

static void mix(uint64_t *hash, unsigned number)
{
    *hash = (*hash ^ number) * UINT64_C(1099511628211);
}

static pull pull_of(const rod_show *s, int solution)
{
    const struct rod_run *run = &s->rod->run[solution];
    pull p = {0};
    double load = 0;
    for (int i = 0; i < s->rod->ntendon; i++) {
        if (run->tension[i] > 0) {
            mix(&p.who, (unsigned)i + 1);
            p.strength += run->tension[i];
        }
    }
    for (int i = 0; i < s->rod->nload; i++) {
        if (run->load[i] != 0) {
            mix(&p.who, (unsigned)i + 1001);
            load += fabs(run->load[i]);
        }
    }
    // loads order those that are pulled alike
    p.strength += s->factors_vary ? 1e-6 * load : 0;
    return p;
}

typedef struct family {
    int number, count; // of the family, of families
    int rank, size;    // within it
} family;

static family family_of(const pull *pulls, int n, int solution)
{
    family f = {0};
    const pull own = pulls[solution];
    for (int i = 0; i < n; i++) {
        bool first = true;
        for (int k = 0; k < i && first; k++) {
            first = pulls[k].who != pulls[i].who;
        }
        if (pulls[i].who == own.who) {
            f.number = first ? f.count : f.number;
            f.size++;
            f.rank += pulls[i].strength < own.strength ||
                      (pulls[i].strength == own.strength && i < solution);
        }
        f.count += first;
    }
    return f;
}

static colour family_ink(const pull *pulls, int n, int solution)
{
    const family f = family_of(pulls, n, solution);
    const double part = f.size > 1 ? (double)f.rank / (f.size - 1) : 1;
    if (pulls[solution].who == 0) {
        return INK_FAINT;
    }
    if (f.count == 1 && f.size > 1) {
        return colour_ramp(0.8 - 0.8 * part);
    }
    const colour hue = colour_series(f.number);
    return colour_mix(PAPER, hue, 0.45 + 0.55 * part);
}

// of a sweep: along its one line, or one for each of its lines
static colour sweep_ink(const rod_show *s, int solution)
{
    const int line = rod_show_line_of(s, solution);
    const int part = s->nline > 1 ? line : solution, of = s->nline > 1 ? s->nline : s->line->count;
    return s->nline > 1 && s->nline <= 8 ? colour_series(line)
                                         : colour_ramp(0.8 - 0.8 * part / fmax(of - 1, 1));
}

static status give_inks(rod_show *s)
{
    status st = OK;
    const int n = s->rod->nsolution;
    pull *pulls = NULL;
    TRY(TAKE(s->ink, (size_t)n));
    TRY(TAKE(pulls, (size_t)n));
    for (int i = 0; i < n; i++) {
        pulls[i] = pull_of(s, i);
    }
    for (int i = 0; i < n; i++) {
        s->ink[i] = s->sweep              ? sweep_ink(s, i)
                    : n <= FAMILIES_UP_TO ? family_ink(pulls, n, i)
                                          : colour_ramp(0.8 - 0.8 * i / (n - 1));
    }

done:
    free(pulls);
    return st;
}

static bool factors_vary(const rod_result *rod)
{
    for (int i = 0; i < rod->nsolution; i++) {
        for (int k = 0; k < rod->nload; k++) {
            if (rod->run[i].load[k] != 1) {
                return true;
            }
        }
    }
    return false;
}

status rod_show_make(const rod_result *rod, rod_show *out)
{
    status st = OK;
    rod_show s = {.rod = rod, .factors_vary = factors_vary(rod)};
    TRY(find_lines(&s));
    TRY(choose(&s));
    TRY(give_inks(&s));
    *out = s;
    s = (rod_show){0};

done:
    rod_show_free(&s);
    return st;
}

void rod_show_free(rod_show *s)
{
    free(s->line);
    free(s->shown);
    free(s->ink);
    *s = (rod_show){0};
}

int rod_next_point(const rod_result *rod, int k)
{
    const int stride = 1 + (rod->npoint - 1) / POINTS_OF_A_CURVE, last = rod->npoint - 1;
    return k == last ? rod->npoint : k + stride < last ? k + stride : last;
}
