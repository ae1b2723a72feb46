// tests/verify/measure/verify_tube_refused.c
// What is no tube, or contradicts what is said of it, is refused with one line that says why.
#include "tests/verify/measure/tube_trial.h"

#include <string.h>

static const made_scan usual = {
    .radius = 4e-3, .count = 20000, .noise = 0.05e-3, .missing = 0.1, .stray = 0.05, .seed = 3};

enum { POINTS = 20000 };

// one line, of a kind that the program's exit code tells
static void is_refused(const char *what, const point_cloud *cloud, const tube_options *o,
                       status wanted, const char *words)
{
    about("%s", what);
    centreline line = {0};
    tube_report report;
    const clock_t start = clock();
    const status st = tube_centreline(cloud, o, &line, &report);
    printf("%-40s %d %s (%.2f s)\n", what, st, status_message(),
           (double)(clock() - start) / CLOCKS_PER_SEC);
    CHECK(st == wanted);
    CHECK(strstr(status_message(), words) != NULL);
    CHECK(strchr(status_message(), '\n') == NULL);
    CHECK(line.count == 0);
    status_clear();
    centreline_free(&line);
}

static double random_of(unsigned long *state)
{
    *state = *state * 6364136223846793005UL + 1442695040888963407UL;
    return (double)(*state >> 11) / 9007199254740992.0;
}

// 0: a volume, 1: a plane, 2: a ball of 20 mm, 3: a ball of 4 mm, 4: a cone, 5: one place
static void fill(int kind, point_cloud *c)
{
    unsigned long state = 7;
    for (size_t i = 0; i < c->count; i++) {
        const double x = random_of(&state) - 0.5, y = random_of(&state) - 0.5;
        const double z = random_of(&state) - 0.5, turn = 2 * M_PI * y, flat = sqrt(1 - 4 * x * x);
        const double ball = kind == 2 ? 20e-3 : 4e-3, n = 1e-4 * (z + random_of(&state) - 0.5);
        const double places[][3] = {
            {0.1 * x, 0.1 * y, 0.1 * z},
            {0.1 * x, 0.1 * y, n},
            {(ball + n) * flat * cos(turn), (ball + n) * flat * sin(turn), (ball + n) * 2 * x},
            {(ball + n) * flat * cos(turn), (ball + n) * flat * sin(turn), (ball + n) * 2 * x},
            {40e-3 * (x + 0.5) * cos(turn), 40e-3 * (x + 0.5) * sin(turn), 0.06 * x},
            {1e-3, 2e-3, 3e-3}};
        memcpy(c->p[i], places[kind], sizeof c->p[i]);
    }
}

static void what_is_no_tube(void)
{
    const char *names[] = {"a volume",       "a plane", "a ball of 20 mm",
                           "a ball of 4 mm", "a cone",  "one place"};
    point_cloud c = {.count = POINTS, .p = malloc(POINTS * sizeof *c.p)};
    for (int kind = 0; kind < 6 && c.p; kind++) {
        fill(kind, &c);
        for (int known = 0; known < 4; known++) {
            char words[80];
            tube_options o = known & 1 ? trial_options(4e-3) : tube_options_default();
            o.radius = known & 2 ? 4e-3 : NAN;
            (void)snprintf(words, sizeof words, "%s%s%s", names[kind],
                           known & 1 ? ", base known" : "", known & 2 ? ", radius known" : "");
            is_refused(words, &c, &o, ERR_FILE, "no tube");
        }
    }
    const tube_options o = trial_options(4e-3);
    c.count = 0;
    is_refused("no point", &c, &o, ERR_FILE, "no tube");
    c.count = 1;
    is_refused("one point", &c, &o, ERR_FILE, "no tube");
    c.count = 500;
    for (size_t i = 0; i < c.count && c.p; i++) {
        c.p[i][i % 3] = i % 2 ? (double)NAN : (double)INFINITY;
    }
    is_refused("no numbers", &c, &o, ERR_FILE, "no tube");
    point_cloud_free(&c);
}

static void contradictions(const made_line *line)
{
    point_cloud c = {0};
    CHECK_OK(made_cloud(line, &usual, &c));
    tube_options o = trial_options(4.5e-3);
    is_refused("4.5 mm given, 4 mm there", &c, &o, ERR_INPUT, "4.5 mm, contradicts");
    o = trial_options(3.7e-3);
    is_refused("3.7 mm given, 4 mm there", &c, &o, ERR_INPUT, "3.7 mm, contradicts");
    o = trial_options(-1);
    is_refused("a negative radius", &c, &o, ERR_INPUT, "positive");
    o = trial_options(4e-3);
    o.direction = (vec3){{0, 0, 0}};
    is_refused("no direction", &c, &o, ERR_INPUT, "direction");
    o = trial_options(4e-3);
    o.base = (vec3){{0.1, 0.2, -0.3}};
    is_refused("the base elsewhere", &c, &o, ERR_FILE, "at the base");
    for (size_t i = 0; i < c.count; i++) {
        for (int d = 0; d < 3; d++) {
            c.p[i][d] *= 1e3;
        }
    }
    o = trial_options(4e-3);
    is_refused("millimetres taken for metres", &c, &o, ERR_FILE, "no tube");
    point_cloud_free(&c);
}

// 1 % off: believed, and told
static void a_slightly_wrong_radius_is_told(const made_line *line)
{
    const tube_options o = trial_options(4.08e-3), right = trial_options(4.0e-3);
    tube_trial t = trial_of(line, &usual, &o), u = trial_of(line, &usual, &right);
    trial_print("4.08 mm given, 4 mm there", &t);
    CHECK(t.st == OK && t.report.radius_differs);
    CHECK(u.st == OK && !u.report.radius_differs);
    CHECK_WITHIN(t.report.radius_free, 4e-3, 0.02e-3);
    trial_free(&t);
    trial_free(&u);
}

static void the_tube_at_the_base_is_taken(const made_line *line)
{
    point_cloud one = {0}, two = {0};
    CHECK_OK(made_cloud(line, &usual, &one));
    CHECK_OK(made_cloud(line, &usual, &two));
    point_cloud both = {.p = malloc((one.count + two.count) * sizeof *both.p)};
    for (size_t i = 0; i < one.count + two.count && both.p; i++) {
        const bool first = i % 2 == 0 ? i / 2 < one.count : i / 2 >= two.count;
        const size_t at =
            i / 2 < one.count && i / 2 < two.count ? i / 2 : i - (first ? two.count : one.count);
        for (int d = 0; d < 3; d++) {
            both.p[i][d] = first ? one.p[at][d] : two.p[at][d] + (d == 1 ? 30e-3 : 0);
        }
        both.count++;
    }
    tube_options o = tube_options_default();
    is_refused("two tubes, the base not known", &both, &o, ERR_FILE, "two tubes");
    o.radius = 4e-3;
    is_refused("two tubes, the base not known", &both, &o, ERR_FILE, "two tubes");
    o = trial_options(4e-3);
    tube_trial t = {0};
    CHECK_OK(tube_centreline(&both, &o, &t.line, &t.report));
    if (t.line.count) {
        trial_compare(line, &t);
    }
    trial_print("two tubes, the base known", &t);
    CHECK_BELOW(t.rms, 0.03e-3);
    CHECK_BELOW(t.tip, 0.1e-3);
    trial_free(&t);
    point_cloud_free(&one);
    point_cloud_free(&two);
    point_cloud_free(&both);
}

int main(void)
{
    against(BY_MADE_DATA, "synthetic clouds of what is no tube");
    static made_line line;
    made_line_make(0.12, made_prototype, NULL, &line);
    what_is_no_tube();
    contradictions(&line);
    a_slightly_wrong_radius_is_told(&line);
    the_tube_at_the_base_is_taken(&line);
    return test_failures != 0;
}
