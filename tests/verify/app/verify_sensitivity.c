// What moves the answer: the rod's own derivatives against whole solves close by, on both
// prototypes and both models of the section; random samples against the propagation of small
// errors.
#include "app/chain.h"
#include "app/sensitivity.h"
#include "base/memory.h"

#include "tests/test.h"

#include <string.h>
#include <unistd.h>

enum { TEXT = 4000, SEEDS = 8, SIZES = 3 };

static const char *const constant =
    "{sector: {outer_radius_mm: 4, inner_radius_mm: 3.2, mid_angle_rad: pi, width_rad: pi/8}, "
    "material: stiff}";
static const char *const helical =
    "{sector: {outer_radius_mm: 4, inner_radius_mm: 3.2, mid_angle_rad: pi*s/L, width_rad: pi/4 - "
    "(pi/8)*(s/L)}, material: stiff}";

typedef struct kind {
    const char *model, *sector, *angle, *loads;
    double friction, tension, tolerance;
} kind;

// the case with a block of its own behind it
static void write_case(const kind *k, const char *block, char text[TEXT])
{
    (void)snprintf(text, TEXT,
                   "format: 1\n"
                   "title: trial\n"
                   "materials:\n"
                   "  soft: {E_MPa: 0.66, nu: 0.4}\n"
                   "  stiff: {E_MPa: 15.93, nu: 0.4}\n"
                   "section:\n"
                   "  model: %s\n"
                   "  shapes:\n"
                   "    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3.2}, material: soft}\n"
                   "    - %s\n"
                   "rod:\n"
                   "  length_mm: 120\n"
                   "  tolerance: %g\n"
                   "  rest: {curvature_x_per_m: 1}\n"
                   "  tendons:\n"
                   "    - {name: t, radius_mm: 3.6, angle_rad: %s, friction: %g}\n"
                   "  tensions_N: [[%g]]\n"
                   "%s"
                   "sensitivity:\n%s",
                   k->model, k->sector, k->tolerance, k->angle, k->friction, k->tension, k->loads,
                   block);
}

// solved; the caller frees both
static void study(const char *text, case_data *c, run_result *r)
{
    char path[] = "/tmp/sensitivity.XXXXXX";
    const command cmd = {.quiet = true, .first_rank = true};
    const int file = mkstemp(path);
    *c = (case_data){0};
    *r = (run_result){0};
    CHECK(file >= 0 && write(file, text, strlen(text)) == (ssize_t)strlen(text));
    (void)close(file);
    CHECK_OK(case_open(&(case_request){.path = path}, c));
    CHECK_OK(chain_run(&cmd, c, (chain_parts){.rod = true, .sensitivity = true}, r));
    (void)unlink(path);
}

static void end_study(case_data *c, run_result *r)
{
    run_result_free(r);
    case_free(c);
}

// --- derivatives

// ranges of a thousandth: the middle between both ends is off the derivative by the square of that,
// and two solves agree to 1e-11 L
static const char near_by[] =
    "  parameters:\n"
    "    - {name: radius, keys: [rod.tendons.t.radius_mm], low: 3.5964, high: 3.6036}\n"
    "    - {name: friction, keys: [rod.tendons.t.friction], low: 0.0999, high: 0.1001}\n"
    "    - {name: E, keys: [materials.stiff.E_MPa], low: 15.914, high: 15.946}\n"
    "    - {name: nu, keys: [materials.soft.nu, materials.stiff.nu], low: 0.3996, high: 0.4004}\n"
    "    - {name: curvature, keys: [rod.rest.curvature_x_per_m], low: 0.99, high: 1.01}\n"
    "    - {name: angle, keys: [rod.tendons.t.angle_deg], low: 89.99, high: 90.01}\n";
static const double secant_error = 2e-5;
// what hardly moves the tip is a difference of two solves' last digits [m]
static const double hardly = 1e-9;

static void derivatives_are_those_of_solves(const kind *k)
{
    char text[TEXT];
    case_data c;
    run_result r;
    write_case(k, near_by, text);
    study(text, &c, &r);
    for (int i = 0; i < r.sensitivity.nmover; i++) {
        const mover *p = &r.sensitivity.mover[i];
        const move *m = sensitivity_move(&r.sensitivity, i, 0);
        const double range = p->end[MOVER_HIGH].value - p->end[MOVER_LOW].value;
        double off = 0, size = 0;
        for (int a = 0; a < 3; a++) {
            const double secant = m->moved[MOVER_HIGH][a] - m->moved[MOVER_LOW][a];
            off = hypot(off, secant - range * m->rate[a]);
            size = hypot(size, secant);
        }
        const double bend = m->bend[MOVER_HIGH] - m->bend[MOVER_LOW];
        printf("%-9s %-9s %-9s mu %.1f: tip %9.2e m, derivative off by %.1e; bend off by %.1e rad; "
               "its own estimate %.1e\n",
               k->model, k->sector == helical ? "helical" : "constant", p->name, k->friction, size,
               off / size, fabs(bend - range * m->bend_rate), m->rate_error);
        CHECK(p->no_rate[0] == 0);
        if (!(size < hardly)) {
            CHECK_BELOW(off, secant_error * size);
            const double bend_off = fabs(bend - range * m->bend_rate);
            CHECK_BELOW(bend_off, secant_error * (fabs(bend) + size / 0.12));
            CHECK_BELOW(m->rate_error, 1e-4);
        }
    }
    end_study(&c, &r);
}

static void every_kind_has_its_derivatives(void)
{
    static const char no_load[] = "";
    static const char load[] = "  loads:\n"
                               "    - {name: weight, force_N: [0.003, -0.002, 0]}\n";
    const kind kinds[] = {
        {"classical", constant, "pi/2", no_load, 0.1, 0.5, 1e-11},
        {"classical", helical, "pi/2", no_load, 0.1, 0.98, 1e-11},
        {"full", constant, "pi/2", no_load, 0.1, 0.3, 1e-11},
        {"full", constant, "pi/2", load, 0.1, 0.3, 1e-11},
        {"classical", helical, "pi/2", load, 0.1, 0.98, 1e-11},
    };
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        derivatives_are_those_of_solves(&kinds[i]);
    }
}

// --- random samples

static const kind bent = {"classical", constant, "pi/2", "", 0, 0.3, 1e-6};

static void sample(int n, int seed, double part, run_result *r, case_data *c)
{
    char block[1000], text[TEXT];
    (void)snprintf(block, sizeof block,
                   "  parameters:\n"
                   "    - {name: radius, keys: [rod.tendons.t.radius_mm], low: %.9g, high: %.9g}\n"
                   "    - {name: E, keys: [materials.stiff.E_MPa], distribution: normal, sigma: "
                   "%.9g}\n"
                   "  monte_carlo: {samples: %d, seed: %d}\n",
                   3.6 - 0.1 * part, 3.6 + 0.1 * part, 1.6 * part, n, seed);
    write_case(&bent, block, text);
    study(text, c, r);
}

// deviations of the parameters: uniform over its range, and normal
static double linear_deviation(const sensitivity_result *s, int axis, double share[2])
{
    const double own[2] = {
        (s->mover[0].end[1].value - s->mover[0].end[0].value) / sqrt(12.0),
        s->mover[1].sigma,
    };
    double sum = 0;
    for (int i = 0; i < 2; i++) {
        const double part = own[i] * sensitivity_move(s, i, 0)->rate[axis];
        share[i] = part * part;
        sum += share[i];
    }
    share[0] /= sum;
    share[1] /= sum;
    return sqrt(sum);
}

static void small_errors_propagate_linearly(void)
{
    case_data c;
    run_result r;
    const int n = 400;
    sample(n, 7, 0.01, &r, &c);
    const sensitivity_result *s = &r.sensitivity;
    CHECK(s->monte_carlo.used[0] == n);
    for (int q = SPREAD_X; q <= SPREAD_Z; q++) {
        double share[2];
        const double wanted = linear_deviation(s, q, share);
        const sample_spread *a = sensitivity_spread(s, 0, q);
        const double *found = sensitivity_share(s, 0, q);
        printf("%d: deviation %.5g m, by derivatives %.5g; shares %.4f %.4f, by derivatives %.4f "
               "%.4f; left %.1e\n",
               q, a->deviation, wanted, found[0], found[1], share[0], share[1], a->rest);
        // four deviations of what n samples know of a deviation and of a share
        CHECK_NEAR(a->deviation, wanted, 4 / sqrt(2.0 * n));
        CHECK_BELOW(fabs(found[0] - share[0]), 4 / sqrt(n));
        CHECK_BELOW(fabs(found[1] - share[1]), 4 / sqrt(n));
        CHECK_BELOW(a->rest, 1e-3);
        // of a normal and a uniform sum: between the two
        CHECK_ABOVE(a->high - a->mean, 1.4 * wanted);
        CHECK_BELOW(a->high - a->mean, 1.9 * wanted);
        const double at = r.rod.run[0].tip.p.a[q];
        CHECK_BELOW(fabs(a->mean - at), 4 * wanted / sqrt(n) + 0.05 * wanted);
    }
    end_study(&c, &r);
}

static void means_converge_by_the_root_of_the_samples(void)
{
    const int sizes[SIZES] = {10, 30, 90};
    double n[SIZES], error[SIZES];
    for (int i = 0; i < SIZES; i++) {
        n[i] = sizes[i];
        error[i] = 0;
        for (int seed = 1; seed <= SEEDS; seed++) {
            case_data c;
            run_result r;
            sample(sizes[i], 100 * i + seed, 0.01, &r, &c);
            const double off =
                sensitivity_spread(&r.sensitivity, 0, SPREAD_Z)->mean - r.rod.run[0].tip.p.a[2];
            error[i] += off * off / SEEDS;
            end_study(&c, &r);
        }
        error[i] = sqrt(error[i]);
        printf("%4d samples: mean off by %.3g m rms of %d seeds\n", sizes[i], error[i], SEEDS);
    }
    // the rms of eight seeds is known to a quarter
    CHECK_NEAR(observed_order(SIZES, n, error), -0.5, 0.4);
}

static void a_seed_is_the_same_bits(void)
{
    case_data c[3];
    run_result r[3];
    const int seed[3] = {11, 11, 12};
    for (int i = 0; i < 3; i++) {
        sample(30, seed[i], 1, &r[i], &c[i]);
    }
    const size_t size = SPREAD_QUANTITIES * sizeof(sample_spread);
    CHECK(memcmp(r[0].sensitivity.monte_carlo.spread, r[1].sensitivity.monte_carlo.spread, size) ==
          0);
    CHECK(memcmp(r[0].sensitivity.monte_carlo.spread, r[2].sensitivity.monte_carlo.spread, size) !=
          0);
    for (int i = 0; i < 3; i++) {
        end_study(&c[i], &r[i]);
    }
}

int main(void)
{
    against(BY_SECOND_WAY, "whole solves close by; propagation of small errors");
    every_kind_has_its_derivatives();
    small_errors_propagate_linearly();
    means_converge_by_the_root_of_the_samples();
    a_seed_is_the_same_bits();
    return test_failures != 0;
}
