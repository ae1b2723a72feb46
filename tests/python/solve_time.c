// tests/python/solve_time.c
// CPU time of a warm solve by the C library alone [us], best of several: what
// tests/python/overhead.py measures Python against, with the same requests.
#include <stiffaxis/stiffaxis.h>

#include <stdio.h>
#include <time.h>

enum { ROUNDS = 20, SOLVES = 500 };

static double seconds(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(int argc, char **argv)
{
    stiffaxis_case *c = NULL;
    stiffaxis_section *section = NULL;
    stiffaxis_rod *rod = NULL;
    stiffaxis_state *state = NULL;
    stiffaxis_solution answer = {0};
    double tension[2] = {0}, best = 1e9;
    if (argc != 2 || stiffaxis_case_open(argv[1], 0, NULL, 0, &c) ||
        stiffaxis_section_make(c, &section) || stiffaxis_rod_make(section, 0, NULL, &rod) ||
        stiffaxis_state_make(rod, &state)) {
        printf("%s\n", stiffaxis_error());
        return 1;
    }
    for (int k = 0; k < ROUNDS; k++) {
        const double start = seconds();
        for (int i = 0; i < SOLVES; i++) {
            tension[0] = i % 2 ? 0.5 : 0.49;
            if (stiffaxis_solve(state, &(stiffaxis_request){.tension = tension}, &answer)) {
                return 1;
            }
        }
        const double each = 1e6 * (seconds() - start) / SOLVES;
        best = each < best ? each : best;
    }
    printf("%.9g\n", best);
    stiffaxis_state_free(state);
    stiffaxis_rod_free(rod);
    stiffaxis_section_free(section);
    stiffaxis_case_free(c);
    return 0;
}
