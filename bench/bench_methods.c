// bench/bench_methods.c
// Four methods on the same rods under a dead tip force at the same error: shooting, multiple
// shooting, spectral strain, and the solver's own; on a homogeneous rod and on one with jumps.
// docs/decisions/0012
#include "bench/bench.h"
#include "bench/methods_shooting.h"
#include "bench/methods_spectral.h"
#include "tests/verify/rodsolver/random_rods.h"

enum { PROBLEMS = 202, TIMES = 3, MULTIPLE = 4 };

static const double wanted = 1e-6; // error of the tip [m]
static const double same = 5e-3;   // tips nearer than that are of the same equilibrium [m]

typedef struct problem {
    method_load load;
    vec3 tip;
} problem;

typedef struct tally {
    int right, other, failed, steps;
    double error, time[PROBLEMS]; // worst of the right ones [m]; CPU time, all problems [us]
} tally;

// the two of the published annulus, then random ones; their tips by the second method
static status problems_make(const rod_spec *spec, problem *out)
{
    status st = OK;
    shooting coarse = {0}, fine = {0};
    TRY(shoot_make(spec, RANDOM_STEPS, &coarse));
    TRY(shoot_make(spec, 2 * RANDOM_STEPS, &fine));
    for (int k = 0; k < PROBLEMS; k++) {
        random_problem p = random_at(k);
        if (k < 2) {
            p = (random_problem){.tension = {0.5 * k}, .tip = {{0, 0.02}}};
        }
        const rod_request rq = {.tension = p.tension, .tip_space = p.tip};
        const shoot_answer a = shoot_solve(&coarse, &fine, &rq, 1);
        if (!a.solved || a.ncritical > 0) {
            TRY(status_fail(ERR_BUG, "problem %d: the second method finds no answer", k));
        }
        memcpy(out[k].load.tension, p.tension, sizeof p.tension);
        memcpy(out[k].load.force, p.tip.a, sizeof out[k].load.force);
        out[k].tip = a.tip.p;
    }

done:
    shoot_free(&coarse);
    shoot_free(&fine);
    return st;
}

static void count(tally *t, const problem *p, int k, bool solved, vec3 tip, double time)
{
    const double error = vec3_norm(vec3_sub(tip, p->tip));
    t->time[k] = time;
    if (!solved) {
        t->failed++;
    } else if (error < same) {
        t->right++;
        t->error = fmax(t->error, error);
    } else {
        t->other++;
    }
}

typedef bool (*way)(const method *m, const method_load *load, double *x, int *steps);

static tally run(const method *m, const problem *problems, way go, int times)
{
    tally t = {0};
    static double x[METHOD_UNKNOWNS];
    for (int k = 0; k < PROBLEMS; k++) {
        double time = HUGE_VAL;
        bool solved = false;
        int steps = 0;
        for (int i = 0; i < times; i++) {
            const double start = random_cpu_us();
            steps = 0;
            solved = go(m, &problems[k].load, x, &steps);
            time = fmin(time, random_cpu_us() - start);
        }
        t.steps += steps;
        count(&t, &problems[k], k, solved, m->tip(m->self, 1, x), time);
    }
    return t;
}

static int by_time(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void print_row(const char *what, int size, tally *t)
{
    qsort(t->time, PROBLEMS, sizeof *t->time, by_time);
    printf("%-34s %8d %6d %6d %6d %9.1f %9.1f %9.1f %7.1f %10.1e\n", what, size, t->right, t->other,
           t->failed, t->time[PROBLEMS / 4], t->time[PROBLEMS / 2], t->time[3 * PROBLEMS / 4],
           (double)t->steps / PROBLEMS, t->error);
}

// both ways at the coarsest resolution that is good enough
static void print_method(const method *m, const problem *problems, int size)
{
    char what[64];
    tally t = run(m, problems, method_at_once, TIMES);
    (void)snprintf(what, sizeof what, "%s, at once", m->name);
    print_row(what, size, &t);
    t = run(m, problems, method_by_steps, TIMES);
    (void)snprintf(what, sizeof what, "%s, continuation", m->name);
    print_row(what, size, &t);
}

static status shooting_rows(const rod_spec *spec, const problem *problems, int cuts)
{
    status st = OK;
    shooting sh = {0};
    for (int steps = cuts; steps <= 32; steps += cuts) {
        static shot s;
        TRY(shoot_make(spec, steps, &sh));
        const rod_request nothing = {0};
        s = (shot){.sh = &sh, .cuts = cuts, .c = shoot_case_make(&sh, &nothing)};
        const method m = shot_method(&s, cuts == 1 ? "single shooting" : "multiple shooting");
        const tally t = run(&m, problems, method_by_steps, 1);
        if (t.right > 0 && t.error <= wanted) {
            print_method(&m, problems, steps);
            break;
        }
        shoot_free(&sh);
    }

done:
    shoot_free(&sh);
    return st;
}

// (dense: more than 40 points cost more than all other methods)
static void spectral_rows(const rod_spec *spec, const problem *problems)
{
    static spectral s;
    for (int points = 4; points <= SPECTRAL_POINTS; points += points < 12 ? 1 : 4) {
        spectral_make(&s, spec, points);
        const method m = spectral_method(&s);
        const tally t = run(&m, problems, method_by_steps, 1);
        if (t.right > 0 && t.error <= wanted) {
            print_method(&m, problems, points);
            return;
        }
        if (points == SPECTRAL_POINTS) {
            printf("not at %.0e m with %d points, but:\n", wanted, points);
            print_method(&m, problems, points);
        }
    }
}

static status run_ours(const rod_spec *spec, const problem *problems, double tolerance, tally *t)
{
    status st = OK;
    rod *r = NULL;
    rod_state *state = NULL;
    const rod_options options = {.tolerance = tolerance};
    TRY(rod_make(spec, &options, &r));
    TRY(rod_state_make(r, &state));
    *t = (tally){0};
    for (int k = 0; k < PROBLEMS; k++) {
        rod_request rq = {.tension = problems[k].load.tension, .cold = true};
        memcpy(rq.tip_space.a, problems[k].load.force, sizeof problems[k].load.force);
        rod_solution out = {0};
        double time = HUGE_VAL;
        bool solved = false;
        for (int i = 0; i < TIMES; i++) {
            const double start = random_cpu_us();
            solved = rod_solve(state, &rq, &out) == OK;
            time = fmin(time, random_cpu_us() - start);
            status_clear();
        }
        t->steps += out.iterations;
        count(t, &problems[k], k, solved, out.tip.p, time);
    }

done:
    rod_state_free(state);
    rod_free(r);
    return st;
}

// the loosest tolerance that is good enough; 1 where not every answer is the right one
static status our_row(const rod_spec *spec, const problem *problems, int *bad)
{
    status st = OK;
    static tally t;
    *bad = 1;
    for (double tolerance = 1e-4; tolerance > 1e-8; tolerance /= 1.5) {
        TRY(run_ours(spec, problems, tolerance, &t));
        if (t.error <= wanted) {
            char what[64];
            (void)snprintf(what, sizeof what, "ours, tolerance %.1e", tolerance);
            print_row(what, 0, &t);
            *bad = t.right < PROBLEMS;
            break;
        }
    }

done:
    return st;
}

// a middle third twenty times as stiff, and a tendon that ends at its end
static status jumps_make(const law_along *law, law_along *out)
{
    status st = OK;
    TRY(law_along_make(law->length, 3, 1, out));
    for (int k = 0; k < 3; k++) {
        out->law[k].K = mat6_scale(k == 1 ? 20 : 1, law->law[0].K);
    }

done:
    return st;
}

static status table(const char *what, const rod_spec *spec, int *bad)
{
    status st = OK;
    static problem problems[PROBLEMS];
    int ours_bad = 1;
    TRY(problems_make(spec, problems));
    printf("%s: %d rods under a dead tip force, from rest, tips to %.0e m; CPU us, Newton steps\n",
           what, PROBLEMS, wanted);
    printf("%-34s %8s %6s %6s %6s %9s %9s %9s %7s %10s\n", "method", "size", "right", "other",
           "failed", "quartile", "median", "quartile", "steps", "error m");
    TRY(shooting_rows(spec, problems, 1));
    TRY(shooting_rows(spec, problems, MULTIPLE));
    spectral_rows(spec, problems);
    TRY(our_row(spec, problems, &ours_bad));
    *bad += ours_bad;
    printf("\n");

done:
    return st;
}

int main(void)
{
    status st = OK;
    static random_rods rods;
    law_along jumps = {0};
    int bad = 0;
    TRY(random_rods_make(&rods));
    TRY(jumps_make(&rods.law, &jumps));
    TRY(table("homogeneous", &rods.spec, &bad));
    rods.tendon[1].end = 2.0 / 3 * RANDOM_LENGTH;
    rods.spec.law = &jumps;
    TRY(table("with jumps", &rods.spec, &bad));

done:
    if (st != OK) {
        fprintf(stderr, "bench_methods: %s\n", status_message());
    }
    random_rods_free(&rods);
    law_along_free(&jumps);
    return st != OK || bad;
}
