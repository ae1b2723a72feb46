// bench/bench.h
// What the benchmarks share: CPU time, verdicts on targets, and points for the pictures.
#pragma once

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

// user and system time of this process [ms]
static inline double bench_cpu_ms(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

// "PASS what: 5.2 of 20 ms (x 0.26)"; 1 where it fails, a NaN too
static inline int bench_target(const char *what, double value, double most, const char *unit)
{
    const int fails = !(value <= most);
    printf("%s  %s: %.3g, at most %.3g %s", fails ? "FAIL" : "PASS", what, value, most, unit);
    if (most > 0) {
        printf(" (x %.2g)", value / most);
    }
    printf("\n");
    return fails;
}

static inline FILE *bench_points_file(void)
{
    const char *path = getenv("STIFFAXIS_BENCH_POINTS");
    return path ? fopen(path, "a") : NULL;
}

// What the axes of this benchmark's picture are, where they are not CPU time [ms] and relative
// error; before its first point.
static inline void bench_axes(const char *x, const char *y)
{
    FILE *file = bench_points_file();
    if (file) {
        (void)fprintf(file, "#%s#%s\n", x, y);
        (void)fclose(file);
    }
}

// One point of the picture, also of a value that others report. bench.sh names the file; without it
// nothing is written.
static inline void bench_point(const char *series, double x, double y)
{
    FILE *file = bench_points_file();
    if (file) {
        (void)fprintf(file, "%s,%.6g,%.6g\n", series, x, y);
        (void)fclose(file);
    }
}
