// tests/verify/rodsolver/verify_rod_order.c
// The quadrature on SE(3) is of order 6 in both frames, and its error estimate is honest.
#include "tests/unit/rodsolver/prototypes.h"

static double helix(const void *expression, double s)
{
    return *(const double *)expression * s;
}

typedef struct study {
    law_along law;
    tendon_spec tendon[2];
    double tension[2];
    int frame;
} study;

static rod_solution solve(const study *t, int npanel, pose shape[4])
{
    double s[4];
    rod_solution out = {0};
    const made_rod r =
        solved_rod(&t->law, 2, t->tendon, (rod_options){.frame = t->frame, .npanel = npanel},
                   t->tension, &out);
    CHECK_OK(rod_shape(r.state, 4, s, shape));
    free_rod(r);
    return out;
}

static void order_is_six(const study *t)
{
    enum { N = 4 };
    pose exact_shape[4], shape[4];
    const rod_solution exact = solve(t, 384, exact_shape);
    double h[N], tip[N], inside[N];
    about("frame %s", t->frame == FRAME_GC ? "GC" : "NC");
    printf("frame %s\n%8s %12s %12s %8s %14s\n", t->frame == FRAME_GC ? "GC" : "NC", "panels",
           "tip / L", "estimate", "ratio", "at L / 3, m");
    for (int i = 0; i < N; i++) {
        const int n = 16 << i;
        const rod_solution out = solve(t, n, shape);
        h[i] = 1.0 / n;
        tip[i] = distance(out.tip.p, exact.tip.p) / t->law.length;
        inside[i] = distance(shape[1].p, exact_shape[1].p);
        printf("%8d %12.3e %12.3e %8.2f %14.3e\n", n, tip[i], out.relative_error,
               out.relative_error / tip[i], inside[i]);
        CHECK_AT_LEAST(out.relative_error, tip[i] / 3);
        CHECK_AT_MOST(out.relative_error, 20 * tip[i]);
    }
    CHECK_WITHIN(observed_order(N, h, tip), 6.0, 0.25);
    CHECK_ABOVE(observed_order(N, h, inside), 5.5);
}

// over tensions from small to nearly all that can be pulled, on coarse plans and on fine ones
static void estimate_is_honest(study *t)
{
    pose shape[4];
    for (int k = 1; k <= 8; k++) {
        t->tension[0] = 0.5 * k;
        t->tension[1] = k % 3 == 0 ? 0.3 : 0;
        const rod_solution exact = solve(t, 512, shape);
        for (int n = 4; n <= 64; n *= 2) {
            const rod_solution out = solve(t, n, shape);
            const double error = distance(out.tip.p, exact.tip.p) / t->law.length;
            CHECK_AT_LEAST(out.relative_error, error / 3);
            // errors of a rod that is curled up may cancel at its tip: then the estimate is larger
            CHECK_AT_MOST(out.relative_error, 200 * error);
        }
    }
}

int main(void)
{
    against(BY_SECOND_WAY, "the same rod on 384 or 512 panels");
    const prototype p = helical_nc();
    const double turn = 50;
    study t = {.tendon = {straight_tendon("straight", 3.6e-3, PROTOTYPE_PI / 2),
                          straight_tendon("helix", 3.6e-3, 0)},
               .tension = {0.98, 0.3}};
    t.tendon[1].angle = (field){.at = helix, .expression = &turn};
    prototype_law(&p, &t.law);
    for (t.frame = FRAME_GC; t.frame <= FRAME_NC; t.frame++) {
        t.tension[0] = 0.98;
        t.tension[1] = 0.3;
        order_is_six(&t);
        estimate_is_honest(&t);
    }
    law_along_free(&t.law);
    return test_failures != 0;
}
