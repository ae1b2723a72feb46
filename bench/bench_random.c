// bench/bench_random.c
// 2,000 random rods under a dead tip force, from rest, each checked by the second method; CPU time
// of one solve. Exit code 1 where one is wrong, silent or refused, or where the median is missed.
// bench_random FIRST LAST: those problems of either kind only.
#include "bench/bench.h"
#include "tests/verify/rodsolver/random_rods.h"

enum { PROBLEMS = 2000, PLANE = 500 };

static const double target = 300; // [us]

static int by_time(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static int times(const char *what, int n, double *time)
{
    qsort(time, (size_t)n, sizeof *time, by_time);
    printf("%s: CPU us per solve, from rest, tip to %.0e m:\n%10s %10s %10s %10s %10s\n", what,
           RANDOM_TOLERANCE * RANDOM_LENGTH, "least", "quartile", "median", "quartile", "most");
    printf("%10.1f %10.1f %10.1f %10.1f %10.1f\n", time[0], time[n / 4], time[n / 2],
           time[3 * n / 4], time[n - 1]);
    return bench_target("random rods, tip force, from rest, median", time[n / 2], target, "us");
}

int main(int argc, char **argv)
{
    static random_rods rods;
    static double time[PROBLEMS];
    int bad = 0;
    const bool some = argc == 3;
    const int first = some ? atoi(argv[1]) : 0, last = some ? atoi(argv[2]) : PROBLEMS;
    status st = OK;
    TRY(random_rods_make(&rods));
    const random_count space = random_run(&rods, random_at, first, last, some ? NULL : time);
    const random_count plane = random_run(&rods, random_plane_at, first, some ? last : PLANE, NULL);
    random_print("force of any direction", &space);
    random_print("all in one plane", &plane);
    bad += bench_target("random rods wrong, silent, refused or unchecked",
                        random_failures(&space) + random_failures(&plane), 0, "");
    if (!some) {
        bad += times("force of any direction", PROBLEMS, time);
    }

done:
    if (st != OK) {
        fprintf(stderr, "bench_random: %s\n", status_message());
    }
    random_rods_free(&rods);
    return st != OK || bad > 0;
}
