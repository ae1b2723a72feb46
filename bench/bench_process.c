// bench/bench_process.c
// CPU time of whole processes: bench_process RUNS LIMIT_S LABEL COMMAND [ARG...]
// Prints min, median and max of user + system time; exit code 1 when the median is above the limit.
#include "bench/bench.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MAX_RUNS = 100 };

static double seconds(struct timeval t)
{
    return (double)t.tv_sec + 1e-6 * (double)t.tv_usec;
}

// CPU seconds of one run with its output thrown away; negative when it failed
static double run_once(char **command)
{
    const pid_t child = fork();
    if (child == 0) {
        const int null = open("/dev/null", O_WRONLY);
        if (null < 0 || dup2(null, 1) < 0 || dup2(null, 2) < 0) {
            _exit(127);
        }
        execvp(command[0], command);
        _exit(127);
    }
    int state = 0;
    struct rusage usage;
    if (child < 0 || wait4(child, &state, 0, &usage) != child || !WIFEXITED(state) ||
        WEXITSTATUS(state) > 1) {
        return -1;
    }
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(int argc, char **argv)
{
    if (argc < 5) {
        fprintf(stderr, "usage: bench_process RUNS LIMIT_S LABEL COMMAND [ARG...]\n");
        return 2;
    }
    double cpu[MAX_RUNS];
    int runs = atoi(argv[1]);
    const double limit = atof(argv[2]);
    runs = runs < 1 ? 1 : runs > MAX_RUNS ? MAX_RUNS : runs;

    (void)run_once(argv + 4); // warm the page cache
    for (int i = 0; i < runs; i++) {
        cpu[i] = run_once(argv + 4);
        if (cpu[i] < 0) {
            fprintf(stderr, "%s: the command failed\n", argv[3]);
            return 2;
        }
    }
    qsort(cpu, (size_t)runs, sizeof *cpu, by_size);
    const double median = cpu[runs / 2];
    printf("%-44s %8.3f %8.3f %8.3f %8.3f\n", argv[3], cpu[0], median, cpu[runs - 1], limit);
    return bench_target(argv[3], median, limit, "s");
}
