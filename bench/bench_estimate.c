// bench/bench_estimate.c
// Every kind of section: its error estimate against its true error, at the default mesh and at
// tolerances. Exit code 1 where the estimate breaks its promise.
#include "bench/bench.h"
#include "tests/verify/section/campaign.h"

static bool finer_than(const mesh_options *a, const mesh_options *b)
{
    return a->layers > b->layers || a->finer > b->finer;
}

// a reference for this mesh; where none so fine can be drawn, the last one and its own error stand
static void keep_finer(const sample *s, const mesh_options *judged, beam_law *truth)
{
    beam_law finer = {0};
    if (sample_reference(s, judged, &finer) == OK) {
        *truth = finer;
    } else {
        status_clear();
    }
}

static status one(int k, campaign *sum)
{
    status st = OK;
    static const double tolerance[] = {0, 1e-3, 1e-4, 1e-5, 1e-6};
    static const char *name[] = {"default", "1e-3", "1e-4", "1e-5", "1e-6"};
    sample s;
    measured last = {0};
    beam_law truth = {0};
    const mesh_options mesh = mesh_options_default();
    sample_make(k, &s);
    for (int i = 0; i < (int)(sizeof tolerance / sizeof *tolerance); i++) {
        measured m = {0};
        st = sample_solve(&s, &mesh, tolerance[i], &m);
        if (st == ERR_NUMERIC && i > 0) { // said to be out of reach
            printf("| %-30s | %-9s | refused: %s\n", s.name, name[i], status_message());
            status_clear();
            return OK;
        }
        TRY(st);
        // a mesh that serves two tolerances counts once
        if (i == 0 || mat6_relative_error(m.law.K, last.law.K) > 0) {
            if (i == 0) {
                TRY(sample_reference(&s, &m.mesh, &truth));
            } else if (finer_than(&m.mesh, &last.mesh)) {
                keep_finer(&s, &m.mesh, &truth);
            }
            campaign_row(sum, s.name, name[i], &m, &truth);
        }
        last = m;
    }

done:
    return st;
}

int main(int argc, char **argv)
{
    campaign sum = {0};
    int failed = 0;
    const int only = argc > 1 ? atoi(argv[1]) : -1;
    campaign_head();
    for (int k = 0; k < SAMPLES; k++) {
        if (only >= 0 && only != k) {
            continue;
        }
        if (one(k, &sum) != OK) {
            printf("%d: %s\n", k, status_message());
            status_clear();
            failed++;
        }
        fflush(stdout);
    }
    printf("\n%d of %d beyond 3 times the estimate, %d estimates beyond 30 times the error\n",
           sum.below, sum.count, sum.beyond);
    const int missed =
        bench_target("true errors beyond 3 times their estimate", sum.below, 0, "sections") +
        bench_target("estimates beyond 30 times their error", sum.beyond, 0.1 * sum.count,
                     "sections");
    return failed > 0 || missed > 0;
}
