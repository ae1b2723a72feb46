// tests/verify/rodsolver/random_rods.h
// Random rods under a dead tip force, each solved from rest and checked by the second method: the
// homogeneous annulus, three tendons at 120 degrees. Loading grows proportionally from rest.
#pragma once

#include "tests/rod_shooting_more.h"

#include <stdint.h>
#include <stdio.h>
#include <time.h>

enum { RANDOM_TENDONS = 3, RANDOM_STEPS = 12, RANDOM_REPEATS = 3 };

#define RANDOM_PI 3.14159265358979323846
// between the two methods' tips [m], their critical fractions, and the tip of ours against the
// exact one over the length
#define RANDOM_TIP 1e-7
#define RANDOM_FRACTION 1e-4
#define RANDOM_TOLERANCE 5e-7
#define RANDOM_LENGTH 0.12

typedef enum verdict {
    VERDICT_RIGHT,       // the same tip, and nothing critical on the way, by both
    VERDICT_LIMIT,       // the same first limit point, by both
    VERDICT_BIFURCATION, // the same first bifurcation, by both
    VERDICT_WRONG,       // an answer, but another one
    VERDICT_SILENT,      // what is critical on the way was not told, or not where it is
    VERDICT_REFUSED,     // neither an answer nor a critical point, and told so
    VERDICTS
} verdict;

static const char *const verdict_name[VERDICTS] = {"right", "limit",  "bifurcation",
                                                   "wrong", "silent", "refused"};

typedef struct random_problem {
    double tension[RANDOM_TENDONS];
    vec6 tip;
} random_problem;

// splitmix64 of problem and draw: any problem can be looked at alone
static inline double random_draw(int problem, int draw)
{
    uint64_t x = ((uint64_t)problem * 64 + (uint64_t)draw + 1) * 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return (double)((x ^ (x >> 31)) >> 11) / 9007199254740992.0;
}

// tensions to 1 N in even problems, to 0.33 N in odd ones; every direction of the force is as
// likely
static inline random_problem random_at(int problem)
{
    random_problem p = {0};
    for (int i = 0; i < RANDOM_TENDONS; i++) {
        p.tension[i] = (problem % 2 == 0 ? 1 : 0.33) * random_draw(problem, i);
    }
    const double z = 2 * random_draw(problem, 3) - 1,
                 turn = 2 * RANDOM_PI * random_draw(problem, 4);
    const double force = 0.02 * random_draw(problem, 5), across = sqrt(1 - z * z);
    p.tip.a[0] = force * across * cos(turn);
    p.tip.a[1] = force * across * sin(turn);
    p.tip.a[2] = force * z;
    return p;
}

// in the plane of the first tendon, where symmetry leaves bifurcations their place
static inline random_problem random_plane_at(int problem)
{
    random_problem p = {.tension = {random_draw(problem, 0)}};
    const double turn = 2 * RANDOM_PI * random_draw(problem, 1);
    const double force = (problem % 2 == 0 ? 0.08 : 0.02) * random_draw(problem, 2);
    p.tip.a[0] = force * sin(turn);
    p.tip.a[2] = force * cos(turn);
    return p;
}

typedef struct random_rods {
    law_along law;
    tendon_spec tendon[RANDOM_TENDONS];
    rod_spec spec;
    shooting coarse, fine;
    rod *r;
    rod_state *state;
} random_rods;

static inline status random_law(law_along *out)
{
    status st = OK;
    const double outer = 4e-3, inner = 3.2e-3, E = 0.66e6, G = E / 2.9;
    const double A = RANDOM_PI * (outer * outer - inner * inner);
    const double I = RANDOM_PI / 4 * (pow(outer, 4) - pow(inner, 4));
    const double diagonal[6] = {G * A, G * A, E * A, E * I, E * I, 2 * G * I};
    TRY(law_along_make(RANDOM_LENGTH, 1, 1, out));
    for (int i = 0; i < 6; i++) {
        out->law[0].K.a[i][i] = diagonal[i];
    }

done:
    return st;
}

// out keeps pointers into itself: it must not move
static inline status random_rods_make(random_rods *out)
{
    status st = OK;
    const rod_options options = {.tolerance = RANDOM_TOLERANCE};
    *out = (random_rods){0};
    TRY(random_law(&out->law));
    for (int i = 0; i < RANDOM_TENDONS; i++) {
        out->tendon[i].radius = field_constant(3.6e-3);
        out->tendon[i].angle = field_constant(2 * RANDOM_PI * i / RANDOM_TENDONS);
    }
    out->spec = (rod_spec){.law = &out->law, .ntendon = RANDOM_TENDONS, .tendons = out->tendon};
    TRY(shoot_make(&out->spec, RANDOM_STEPS, &out->coarse));
    TRY(shoot_make(&out->spec, 2 * RANDOM_STEPS, &out->fine));
    TRY(rod_make(&out->spec, &options, &out->r));
    TRY(rod_state_make(out->r, &out->state));

done:
    return st;
}

static inline void random_rods_free(random_rods *r)
{
    rod_state_free(r->state);
    rod_free(r->r);
    shoot_free(&r->coarse);
    shoot_free(&r->fine);
    law_along_free(&r->law);
}

typedef struct random_result {
    verdict verdict;
    double time,
        off; // CPU time of our solve [us], the best of RANDOM_REPEATS; distance of tips [m]
    status st;
    rod_solution ours;
    shoot_answer second;
    bool checked; // whether the second method knows the answer to a tenth of RANDOM_TIP
} random_result;

static inline double random_cpu_us(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e6 * (double)t.tv_sec + 1e-3 * (double)t.tv_nsec;
}

static inline verdict random_judge(const random_result *r)
{
    const bool met = r->ours.ncritical > 0, there = r->second.ncritical > 0;
    if (r->st != OK && !met) {
        return VERDICT_REFUSED;
    }
    if (there) {
        const rod_critical *a = &r->ours.critical[0];
        const shoot_critical *b = &r->second.critical[0];
        if (!met || a->kind != b->kind || fabs(a->fraction - b->fraction) > RANDOM_FRACTION) {
            return VERDICT_SILENT;
        }
        // what lies behind the first one must be the same path, too
        if (fabs(r->ours.fraction - r->second.fraction) > RANDOM_FRACTION ||
            (r->second.fraction == 1 && r->off > RANDOM_TIP)) {
            return VERDICT_WRONG;
        }
        return b->kind == CRITICAL_LIMIT ? VERDICT_LIMIT : VERDICT_BIFURCATION;
    }
    // an unstable answer, or a critical point that is not there, would be wrong too
    const bool stable = r->ours.stable == (r->second.negative == 0 ? 1 : 0);
    return r->st == OK && r->off <= RANDOM_TIP && !met && stable ? VERDICT_RIGHT : VERDICT_WRONG;
}

static inline random_result random_solve(random_rods *rods, const random_problem *p)
{
    random_result r = {.time = HUGE_VAL};
    const rod_request rq = {.tension = p->tension, .tip_space = p->tip, .cold = true};
    for (int i = 0; i < RANDOM_REPEATS; i++) {
        status_clear();
        const double start = random_cpu_us();
        r.st = rod_solve(rods->state, &rq, &r.ours);
        r.time = fmin(r.time, random_cpu_us() - start);
    }
    r.second = shoot_solve(&rods->coarse, &rods->fine, &rq, 1);
    r.off = vec3_norm(vec3_sub(r.ours.tip.p, r.second.tip.p));
    r.checked = r.second.solved && (r.second.fraction < 1 || r.second.error <= RANDOM_TIP / 10);
    r.verdict = random_judge(&r);
    return r;
}

// all that is needed to look at one problem again
static inline void random_tell(int problem, const random_problem *p, const random_result *r)
{
    printf("problem %d: %s, tensions %.9g %.9g %.9g N, force %.9g %.9g %.9g N\n", problem,
           verdict_name[r->verdict], p->tension[0], p->tension[1], p->tension[2], p->tip.a[0],
           p->tip.a[1], p->tip.a[2]);
    printf(
        "  ours: status %d (%s), tip %.9g %.9g %.9g m, fraction %.9g, stable %d, estimate %.2g, %d "
        "iterations\n",
        (int)r->st, r->st == OK ? "" : status_message(), r->ours.tip.p.a[0], r->ours.tip.p.a[1],
        r->ours.tip.p.a[2], r->ours.fraction, r->ours.stable, r->ours.relative_error,
        r->ours.iterations);
    for (int i = 0; i < r->ours.ncritical; i++) {
        printf("    %s at %.9g, %d negative behind it\n",
               r->ours.critical[i].kind == CRITICAL_LIMIT ? "limit point" : "bifurcation",
               r->ours.critical[i].fraction, r->ours.critical[i].negative);
    }
    printf("  second method: tip %.9g %.9g %.9g m (error %.1e), %.2e m away, fraction %.9g, %d "
           "negative\n",
           r->second.tip.p.a[0], r->second.tip.p.a[1], r->second.tip.p.a[2], r->second.error,
           r->off, r->second.fraction, r->second.negative);
    for (int i = 0; i < r->second.ncritical; i++) {
        printf("    %s at %.9g\n",
               r->second.critical[i].kind == CRITICAL_LIMIT ? "limit point" : "bifurcation",
               r->second.critical[i].fraction);
    }
}

typedef struct random_count {
    int problems, unchecked, count[VERDICTS];
    double worst; // distance of tips where both have an answer [m]
} random_count;

// problems first .. last - 1; time [last - first] of ours [us], may be NULL
static inline random_count random_run(random_rods *rods, random_problem (*make)(int), int first,
                                      int last, double *time)
{
    random_count n = {0};
    for (int k = first; k < last; k++) {
        const random_problem p = make(k);
        const random_result r = random_solve(rods, &p);
        n.problems++;
        n.count[r.verdict]++;
        n.unchecked += r.checked ? 0 : 1;
        n.worst = r.verdict == VERDICT_RIGHT ? fmax(n.worst, r.off) : n.worst;
        if (time) {
            time[k - first] = r.time;
        }
        if (r.verdict >= VERDICT_WRONG || !r.checked) {
            random_tell(k, &p, &r);
        }
    }
    return n;
}

static inline int random_failures(const random_count *n)
{
    return n->count[VERDICT_WRONG] + n->count[VERDICT_SILENT] + n->count[VERDICT_REFUSED] +
           n->unchecked;
}

static inline void random_print(const char *what, const random_count *n)
{
    printf("%s, %d problems:", what, n->problems);
    for (int v = 0; v < VERDICTS; v++) {
        printf(" %s %d%s", verdict_name[v], n->count[v], v + 1 < VERDICTS ? "," : "");
    }
    printf("; unchecked %d; tips at most %.1e m apart\n", n->unchecked, n->worst);
}
