// tests/unit/reach/test_design.c
#include "reach/design.h"
#include "reach/ranks.h"
#include "tests/test.h"

#include <fcntl.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

// --- a planted optimum: disks of targets whose one common place is known

enum { TARGETS = 9, N = 3 };

typedef struct toy {
    double centre[N];
    int calls; // in this process
    int fail_after;
    bool hole; // a part of the box has no answer
} toy;

// Target t counts where x lies within its radius of the centre; radii grow, so that the score is a
// staircase of plateaus whose top step is a ball of radius 0.03 about the centre. The tie-breaker
// is as an inverse's misses are, and far weaker than one step.
static status staircase(void *context, const double *x, double *goal, double *score)
{
    toy *t = context;
    double d = 0, soft = 0;
    t->calls++;
    if (t->fail_after > 0 && t->calls > t->fail_after) {
        return status_fail(ERR_INTERRUPTED, "interrupted");
    }
    if (t->hole && x[0] > 0.6 && x[1] < 0.5) {
        return status_fail(ERR_NUMERIC, "no equilibrium");
    }
    for (int i = 0; i < N; i++) {
        d += (x[i] - t->centre[i]) * (x[i] - t->centre[i]);
    }
    d = sqrt(d);
    *goal = 0;
    for (int k = 0; k < TARGETS; k++) {
        const double miss = d - 0.03 * (k + 1);
        *goal += miss <= 0;
        soft += miss <= 0 ? 1 : 1 / (1 + miss / 0.1);
    }
    *score = *goal + 0.5 * soft / TARGETS;
    return OK;
}

static const double lower[N] = {0, -1, 2}, upper[N] = {1, 1, 3}, start[N] = {0.5, 0, 2.5};
static const toy planted = {.centre = {0.81, -0.63, 2.17}};

static design_problem problem(toy *t)
{
    return (design_problem){.nparameter = N,
                            .lower = lower,
                            .upper = upper,
                            .start = start,
                            .score = staircase,
                            .context = t,
                            .per_goal = 1,
                            .islands = 4,
                            .evaluations = 200,
                            .seed = 1,
                            .workers = 1,
                            .problem = hash_begin()};
}

static bool same_trials(const design_answer *a, const design_answer *b)
{
    bool same = a->islands == b->islands && a->evaluations == b->evaluations && a->best == b->best;
    for (int i = 0; same && i < a->islands * a->evaluations; i++) {
        const design_trial *s = &a->trial[i], *t = &b->trial[i];
        same = memcmp(s->x, t->x, sizeof s->x) == 0 && s->evaluation == t->evaluation &&
               s->island == t->island && memcmp(&s->score, &t->score, sizeof s->score) == 0 &&
               memcmp(&s->goal, &t->goal, sizeof s->goal) == 0;
    }
    return same;
}

static void a_planted_optimum_is_found_from_every_seed(void)
{
    int found = 0;
    for (int seed = 1; seed <= 20; seed++) {
        toy t = planted;
        design_answer a;
        design_problem p = problem(&t);
        p.seed = seed;
        CHECK_OK(design_search(&p, &a));
        const design_trial *best = &a.trial[a.best];
        CHECK(best->goal == TARGETS);
        CHECK(a.failed == 0 && a.reused == 0 && a.done == 800 && t.calls == 800);
        for (int i = 0; i < N; i++) {
            CHECK_WITHIN(best->x[i], planted.centre[i], 0.03);
        }
        // the first design of all is the case's own
        CHECK(memcmp(a.trial[0].x, start, sizeof start) == 0);
        found += best->goal == TARGETS;
        design_answer_free(&a);
    }
    CHECK(found == 20);
}

static void designs_without_an_answer_are_the_worst(void)
{
    toy t = planted;
    t.hole = true; // the planted place is in it
    design_answer a;
    design_problem p = problem(&t);
    CHECK_OK(design_search(&p, &a));
    const double *x = a.trial[a.best].x;
    CHECK(a.failed > 0 && a.failed < a.done);
    CHECK(!(x[0] > 0.6 && x[1] < 0.5));
    CHECK(!isnan(a.trial[a.best].score));
    design_answer_free(&a);
}

static status never(void *context, const double *x, double *goal, double *score)
{
    (void)context;
    (void)x;
    (void)goal;
    (void)score;
    return status_fail(ERR_NUMERIC, "no section");
}

static void a_search_without_any_answer_fails(void)
{
    toy t = planted;
    design_answer a;
    design_problem p = problem(&t);
    p.score = never;
    p.evaluations = 20;
    CHECK(design_search(&p, &a) == ERR_NUMERIC);
    CHECK(strstr(status_message(), "none of the 80 designs"));
    status_clear();
}

static void the_answer_does_not_depend_on_the_workers_but_on_the_seed(void)
{
    toy t = planted;
    design_answer one, two, other;
    design_problem p = problem(&t);
    CHECK_OK(design_search(&p, &one));
    p.workers = 2;
    CHECK_OK(design_search(&p, &two));
    CHECK(same_trials(&one, &two));
    p.seed = 2;
    CHECK_OK(design_search(&p, &other));
    CHECK(!same_trials(&one, &other));
    design_answer_free(&one);
    design_answer_free(&two);
    design_answer_free(&other);
}

// --- the log

static char folder[] = "/tmp/test_design_XXXXXX", path[64];

static long file_size(void)
{
    struct stat s;
    return stat(path, &s) == 0 ? (long)s.st_size : -1;
}

static void write_file(const char *mode, const char *words)
{
    FILE *f = fopen(path, mode);
    CHECK(f && fputs(words, f) >= 0 && fclose(f) == 0);
}

static void an_interrupted_search_goes_on_where_it_ended(void)
{
    design_answer whole, rest;
    for (int workers = 1; workers <= 2; workers++) {
        toy t = planted;
        t.hole = true; // failures stand in the log too
        design_problem p = problem(&t);
        CHECK_OK(design_search(&p, &whole));

        t.calls = 0;
        t.fail_after = 130; // in a worker: of its first island
        p.log = path;
        p.workers = workers;
        CHECK(design_search(&p, &rest) == ERR_INTERRUPTED);
        status_clear();
        write_file("a", "0,131,3,3.4"); // and the machine went down in the middle of a line
        t.fail_after = t.calls = 0;
        CHECK_OK(design_search(&p, &rest));
        CHECK(same_trials(&whole, &rest));
        CHECK(rest.reused >= 130 && rest.reused < 400 && rest.done == 800);
        if (workers == 1) {
            CHECK(t.calls == 800 - rest.reused);
        }
        design_answer_free(&rest);
        // all of it again: nothing is computed, nothing is written
        const long size = file_size();
        t.calls = 0;
        CHECK_OK(design_search(&p, &rest));
        CHECK(same_trials(&whole, &rest) && rest.reused == 800 && t.calls == 0);
        CHECK(file_size() == size);
        design_answer_free(&rest);
        design_answer_free(&whole);
        CHECK(unlink(path) == 0);
    }
}

static void refuse(const design_problem *p, status wanted, const char *words)
{
    design_answer a;
    const long size = file_size();
    CHECK(design_search(p, &a) == wanted);
    if (!strstr(status_message(), words)) {
        printf("'%s' does not say '%s'\n", status_message(), words);
        test_failures++;
    }
    CHECK(file_size() == size);
    status_clear();
}

// a log with this line in it
static void damaged(const design_problem *p, const char *line)
{
    toy t = planted;
    design_answer a;
    design_problem fine = problem(&t);
    CHECK(unlink(path) == 0);
    fine.islands = 1;
    fine.evaluations = 2;
    fine.log = path;
    CHECK_OK(design_search(&fine, &a));
    design_answer_free(&a);
    write_file("a", line);
    refuse(p, ERR_FILE, ":4: is no line of a design search with 3 parameters");
}

static void a_first_line_that_was_cut_off_is_written_again(void)
{
    toy t = planted;
    design_answer a;
    design_problem p = problem(&t);
    p.islands = 1;
    p.evaluations = 2;
    p.log = path;
    CHECK_OK(design_search(&p, &a));
    design_answer_free(&a);
    const long size = file_size();
    for (long cut = 0; cut < 60; cut += 7) { // the head has 60 bytes
        CHECK(truncate(path, cut) == 0);
        CHECK_OK(design_search(&p, &a));
        CHECK(a.reused == 0 && file_size() == size);
        design_answer_free(&a);
    }
    // another search's head is not this one's, cut or not
    CHECK(truncate(path, 58) == 0);
    hash_int(&p.problem, 1);
    refuse(&p, ERR_INPUT, "belongs to the search of another case");
    CHECK(unlink(path) == 0);
}

static void two_searches_do_not_write_one_log(void)
{
    toy t = planted;
    design_answer a;
    design_problem p = problem(&t);
    p.islands = 1;
    p.evaluations = 2;
    p.log = path;
    CHECK_OK(design_search(&p, &a));
    design_answer_free(&a);
    const int other = open(path, O_RDONLY);
    CHECK(other >= 0 && flock(other, LOCK_EX | LOCK_NB) == 0);
    p.evaluations = 4;
    refuse(&p, ERR_RESOURCE, "log: another design search is writing this log");
    CHECK(close(other) == 0);
    CHECK_OK(design_search(&p, &a));
    CHECK(a.reused == 2);
    design_answer_free(&a);
    CHECK(unlink(path) == 0);
}

static void logs_that_are_not_of_this_problem_are_not_touched(void)
{
    toy t = planted;
    design_answer a;
    design_problem p = problem(&t);
    p.islands = 1;
    p.evaluations = 10;
    p.log = path;
    CHECK_OK(design_search(&p, &a));
    design_answer_free(&a);
    hash_int(&p.problem, 1);
    refuse(&p, ERR_INPUT, "belongs to the search of another case");
    p.problem = hash_begin();
    p.nparameter = 2;
    refuse(&p, ERR_INPUT, "belongs to the search of another case");
    p.nparameter = N;
    write_file("a", "0,11,what\n");
    refuse(&p, ERR_FILE, ":12: is no line of a design search with 3 parameters");
    damaged(&p, "0,3,3,4,0.5,0,2.5\n"); // a score of another goal
    damaged(&p, "0,3,3,2.9,0.5,0,2.5\n");
    damaged(&p, "0,3,nan,3.5,0.5,0,2.5\n");
    damaged(&p, "0,3,3,nan,0.5,0,2.5\n");
    damaged(&p, "0,3,-1,-0.5,0.5,0,2.5\n");
    write_file("w", "x,y,z\n1,2,3\n");
    refuse(&p, ERR_FILE, "is no log of a design search: not touched");
    p.log = folder;
    refuse(&p, ERR_FILE, "");
    p.log = "/dev/zero";
    refuse(&p, ERR_FILE, "");
    CHECK(unlink(path) == 0);
}

static void a_log_that_cannot_be_written_is_told(void)
{
    toy t = planted;
    design_problem p = problem(&t);
    p.log = "/nowhere/at/all";
    refuse(&p, ERR_RESOURCE, "cannot write it");
}

static void what_is_no_box_is_refused(void)
{
    toy t = planted;
    const double outside[N] = {1.5, 0, 2.5};
    design_problem p = problem(&t);
    p.start = outside;
    refuse(&p, ERR_INPUT, "start = 1.5 is not within its bounds");
    p = problem(&t);
    p.upper = lower;
    refuse(&p, ERR_INPUT, "bounds");
    p = problem(&t);
    p.islands = 0;
    refuse(&p, ERR_INPUT, "islands");
}

// --- what is heard

static status listen_to(void *context, const design_news *news)
{
    design_news *last = context;
    CHECK(news->done >= last->done && news->total == 800);
    CHECK(isnan(last->score) || news->score >= last->score);
    *last = *news;
    return OK;
}

static status leave(void *context, const design_news *news)
{
    (void)context;
    return news->done > 0 ? status_fail(ERR_INTERRUPTED, "interrupted") : OK;
}

static void the_best_so_far_is_heard(void)
{
    toy t = planted;
    design_answer a;
    design_problem p = problem(&t);
    for (p.workers = 1; p.workers <= 2; p.workers++) {
        design_news last = {.score = NAN};
        p.heard = listen_to;
        p.hearer = &last;
        CHECK_OK(design_search(&p, &a));
        CHECK(last.done == 800 && last.failed == 0);
        CHECK_NEAR(last.score, a.trial[a.best].score, 1e-15);
        CHECK(last.goal == TARGETS);
        design_answer_free(&a);
        p.heard = leave;
        CHECK(design_search(&p, &a) == ERR_INTERRUPTED);
        status_clear();
    }
}

int main(int argc, char **argv)
{
    if (argc > 2) { // as tests/cli/mpirun_design.sh runs it: the search alone
        toy t = planted;
        design_answer a;
        design_problem p = problem(&t);
        p.islands = 5;
        p.log = argv[1][0] ? argv[1] : NULL;
        CHECK_OK(design_search(&p, &a));
        const bool speaks = ranks_here().rank == atoi(argv[2]);
        for (int i = 0; speaks && i < a.islands * a.evaluations; i++) {
            printf("%d %d %.17g %.17g\n", a.trial[i].island, a.trial[i].evaluation, a.trial[i].x[0],
                   a.trial[i].score);
        }
        design_answer_free(&a);
        return test_failures != 0;
    }
    CHECK(mkdtemp(folder));
    (void)snprintf(path, sizeof path, "%s/log", folder);
    a_planted_optimum_is_found_from_every_seed();
    designs_without_an_answer_are_the_worst();
    a_search_without_any_answer_fails();
    the_answer_does_not_depend_on_the_workers_but_on_the_seed();
    an_interrupted_search_goes_on_where_it_ended();
    logs_that_are_not_of_this_problem_are_not_touched();
    a_first_line_that_was_cut_off_is_written_again();
    two_searches_do_not_write_one_log();
    a_log_that_cannot_be_written_is_told();
    what_is_no_box_is_refused();
    the_best_so_far_is_heard();
    CHECK(rmdir(folder) == 0);
    return test_failures != 0;
}
