// app/print_design.c
#include "app/print.h"
#include "reach/reach_case.h"

#include <math.h>
#include <stdio.h>

static void print_goal(const reach_design_result *d, const char *what, double goal, double score,
                       int ntarget)
{
    if (isnan(goal)) {
        printf("%-12s no answer\n", what);
    } else if (d->goal == DESIGN_TARGETS) {
        printf("%-12s %4.0f of %d targets, score %.6f\n", what, goal, ntarget, score);
    } else {
        printf("%-12s %6.2f %% of the area, score %.6f\n", what, 100 * goal, score);
    }
}

// A search ends that near a bound, of its range, where it would go on beyond
static const double at_bound = 1e-4;

static const char *bound_words(const reach_design_result *d, int i, double value)
{
    const double near = at_bound * (d->upper[i] - d->lower[i]);
    return value <= d->lower[i] + near   ? " (at its lower bound)"
           : value >= d->upper[i] - near ? " (at its upper bound)"
                                         : "";
}

void print_design(const run_result *run)
{
    const reach_result *r = &run->reach;
    const reach_design_result *d = &r->design;
    print_reach(run);
    if (!d->there) {
        return;
    }
    const reach_design_row *best = &d->row[d->best];
    printf("design of scope %s: %d designs on %d islands, seed %d, %d of them without an answer\n",
           print_plain(d->scope).text, d->evaluations, d->islands, d->seed, d->failed);
    print_goal(d, "at first", d->start_goal, d->start_score, r->ntarget);
    print_goal(d, "found", best->goal, best->score, r->ntarget);
    if (best->goal <= d->start_goal) {
        printf("no more %s than at first\n", d->goal == DESIGN_AREA ? "area" : "targets");
    }
    printf("%-24s %12s %12s %12s %12s\n", "parameter", "lower", "upper", "at first", "found");
    for (int i = 0; i < d->nparameter; i++) {
        printf("%-24s %12.6g %12.6g %12.6g %12.6g %s%s\n", d->name[i], d->lower[i], d->upper[i],
               d->start[i], best->value[i], print_plain(d->unit[i]).text,
               bound_words(d, i, best->value[i]));
    }
}
