// bench/bench_rod.c
// Time of one rod solve against the true error of its tip.
#include "bench/rod_cases.h"

enum { REFERENCE_PANELS = 384 }; // error below 1e-13 of the length

static const rod_case_at helical_one = {"helical, 1 tendon", helical_law, 1, false, {0.98}, {0}};
static const rod_case_at straight_one = {
    "homogeneous, 1 tendon", homogeneous_law, 1, false, {0.98}, {0}};
// of the references: straight annulus, tip force across
static const rod_case_at force_only = {"homogeneous, force", homogeneous_law, 1, false, {0},
                                       {0, 0.02, 0}};
static const rod_case_at force_and_tendon = {
    "homogeneous, 1 tendon, force", homogeneous_law, 1, false, {0.5}, {-0.02, 0, 0}};
static const rod_case_at loaded_cases[] = {
    {"homogeneous, 3 tendons, force",
     homogeneous_law,
     3,
     false,
     {0.5, 0.3, 0.1},
     {0.01, 0.01, -0.01}},
    {"helical, 1 tendon, force", helical_law, 1, false, {0.98}, {0, 0.02, 0}},
    {"helical, 3 turning, force", helical_law, 3, true, {0.98, 0.49, 0.2}, {0, 0.02, 0}},
};
static const rod_case_at cases[] = {
    {"homogeneous, 3 tendons", homogeneous_law, 3, false, {0.98, 0.49, 0.2}, {0}},
    {"helical, 2 tendons", helical_law, 2, false, {0.98, 0.49}, {0}},
    {"helical, 3 tendons", helical_law, 3, false, {0.98, 0.49, 0.2}, {0}},
    {"helical, 2 turning tendons", helical_law, 2, true, {0.98, 0.49}, {0}},
    {"helical, 3 turning tendons", helical_law, 3, true, {0.98, 0.49, 0.2}, {0}},
    {"helical, 20 turning tendons", helical_law, 20, true, {0.98, 0.49, 0.2}, {0}},
    {"helical, 200 turning tendons", helical_law, 200, true, {0.98, 0.49, 0.2}, {0}},
};

typedef struct figure {
    quartiles cold, warm;   // [us]
    double error, estimate; // [m]
    int panels, steps;
} figure;

static status reference_tip(const rod_case_at *c, vec3 *tip)
{
    status st = OK;
    static bench_rod b;
    rod_solution out = {0};
    b = (bench_rod){0};
    TRY(bench_rod_make(c, 0, REFERENCE_PANELS, &b));
    const rod_request request = bench_request(c, b.tension);
    TRY(rod_solve(b.state, &request, &out));
    *tip = out.tip.p;

done:
    bench_rod_free(&b);
    return st;
}

static status measure(const rod_case_at *c, double tolerance, vec3 exact, figure *f)
{
    status st = OK;
    static bench_rod b;
    rod_solution out = {0};
    const int repeats = c->ntendon > 3 ? 2 : 20;
    b = (bench_rod){0};
    TRY(bench_rod_make(c, tolerance, 0, &b));
    rod_request request = bench_request(c, b.tension);
    TRY(rod_solve(b.state, &request, &out));
    f->error = vec3_norm(vec3_sub(out.tip.p, exact));
    f->estimate = out.relative_error * length;
    f->panels = rod_panel_count(b.state);
    f->steps = out.iterations;
    TRY(bench_times(b.state, &request, c->ntendon, repeats, &f->cold));
    request.cold = false;
    TRY(bench_times(b.state, &request, c->ntendon, repeats, &f->warm));

done:
    bench_rod_free(&b);
    return st;
}

// time against error; with the scatter from the first to the third quartile
static status table(const rod_case_at *c)
{
    status st = OK;
    vec3 exact;
    TRY(reference_tip(c, &exact));
    printf("\n%s\n%10s %7s %11s %11s %6s %24s %24s\n", c->name, "tolerance", "panels",
           "tip error m", "estimate m", "steps", "cold us", "warm us");
    const double finest = c->ntendon > 20 ? 5e-10 : 5e-12;
    for (double tolerance = 1e-4; tolerance > finest; tolerance /= 10) {
        figure f = {0};
        TRY(measure(c, tolerance, exact, &f));
        printf("%10.0e %7d %11.2e %11.2e %6d %8.2f (%6.2f-%6.2f) %8.2f (%6.2f-%6.2f)\n", tolerance,
               f.panels, f.error, f.estimate, f.steps, f.cold.median, f.cold.low, f.cold.high,
               f.warm.median, f.warm.low, f.warm.high);
        bench_point(c->name, 1e-3 * f.cold.median, f.error / length);
    }

done:
    return st;
}

// medians of solves that are asked for this error, NaN where they do not keep it
static status times_for(const rod_case_at *c, double error, double *cold, double *warm)
{
    status st = OK;
    vec3 exact;
    figure f = {0};
    TRY(reference_tip(c, &exact));
    TRY(measure(c, error / length, exact, &f));
    *cold = f.error <= error ? f.cold.median : NAN;
    *warm = f.error <= error ? f.warm.median : NAN;

done:
    return st;
}

static status time_for(const rod_case_at *c, double error, double *time)
{
    double warm;
    return times_for(c, error, time, &warm);
}

// --- under load

// independent figures of these two tips, good to 1e-11 m
static const vec3 force_only_tip = {{0, 0.07852296901404067, 0.08310723449111658}};
// the second one seen with its tendon at +y
static const vec3 force_and_tendon_tip = {
    {-0.06225301055928794, 0.054729954587487015, 0.023125766351884125}};

static status far_from(const rod_case_at *c, vec3 tip, double *apart)
{
    status st = OK;
    vec3 ours;
    TRY(reference_tip(c, &ours));
    *apart = fmax(*apart, vec3_norm(vec3_sub(ours, tip)));

done:
    return st;
}

static status loaded(int *missed)
{
    status st = OK;
    double cold[2], warm[2], apart = 0;
    TRY(table(&force_only));
    TRY(table(&force_and_tendon));
    for (size_t i = 0; i < sizeof loaded_cases / sizeof *loaded_cases; i++) {
        TRY(table(&loaded_cases[i]));
    }
    TRY(far_from(&force_only, force_only_tip, &apart));
    TRY(far_from(&force_and_tendon, force_and_tendon_tip, &apart));
    TRY(times_for(&force_only, 1e-6, &cold[0], &warm[0]));
    TRY(times_for(&force_and_tendon, 1e-6, &cold[1], &warm[1]));
    printf("\n");
    *missed |= bench_target("tip force: from independent figures", 1e9 * apart, 1, "nm");
    *missed |= bench_target("tip force alone to 1e-6 m, cold, median", cold[0], 150, "us");
    *missed |= bench_target("tip force and tendon to 1e-6 m, cold, median", cold[1], 150, "us");
    *missed |= bench_target("tip force alone to 1e-6 m, from the last answer", warm[0], 40, "us");
    *missed |=
        bench_target("tip force and tendon to 1e-6 m, from the last answer", warm[1], 40, "us");

done:
    return st;
}

// --- batches

enum { ROWS = 10000 };

typedef struct batch_time {
    double cpu, wall; // per row, of all threads together [us]
} batch_time;

static void fill_rows(const bench_rod *b, int ntendon, double *tension)
{
    // from nothing to the whole tension
    for (int i = 0; i < ROWS * ntendon; i++) {
        tension[i] = (double)(i / ntendon + 1) / ROWS * b->tension[i % ntendon];
    }
}

// best of seven; NAN where a row failed
static status time_batch(const rod_case_at *c, double error, int nthread, batch_time *best)
{
    status st = OK;
    static bench_rod b;
    static double tension[3 * ROWS];
    static pose tip[ROWS];
    int failed = 0;
    b = (bench_rod){0};
    *best = (batch_time){HUGE_VAL, HUGE_VAL};
    TRY(bench_rod_make(c, error / length, 0, &b));
    fill_rows(&b, c->ntendon, tension);
    for (int k = 0; k < 7; k++) {
        const double start = microseconds(), cpu = bench_cpu_ms();
        TRY(rod_batch(b.rod, nthread, ROWS, tension, NULL, tip, NULL, &failed));
        best->cpu = fmin(best->cpu, 1e3 * (bench_cpu_ms() - cpu) / ROWS);
        best->wall = fmin(best->wall, (microseconds() - start) / ROWS);
    }
    if (failed > 0) {
        *best = (batch_time){NAN, NAN};
    }

done:
    bench_rod_free(&b);
    return st;
}

static status batches(double *per_row)
{
    status st = OK;
    printf("\nbatch of %d rows at 1e-6 m, best of 7\n%-20s %8s %14s %14s\n", ROWS, "", "threads",
           "CPU us per row", "rows per s");
    for (int i = 0; i < 4; i++) {
        const rod_case_at *c = i < 2 ? &helical_one : &cases[2];
        batch_time t;
        TRY(time_batch(c, 1e-6, 1 + i % 2, &t));
        printf("%-20s %8d %14.2f %14.0f\n", c->name, 1 + i % 2, t.cpu, 1e6 / t.wall);
        *per_row = i == 0 ? t.cpu : *per_row;
    }

done:
    return st;
}

static status plan_size(double *kilobytes)
{
    status st = OK;
    static bench_rod b;
    b = (bench_rod){0};
    TRY(bench_rod_make(&cases[2], 1e-6, 22, &b)); // 66 stations
    *kilobytes = 1e-3 * (double)rod_plan_bytes(b.rod, 64);

done:
    bench_rod_free(&b);
    return st;
}

static status unloaded(int *missed)
{
    status st = OK;
    double rough = 0, fine = 0, straight = 0, row = 0, size = 0;
    TRY(table(&straight_one));
    TRY(table(&helical_one));
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        TRY(table(&cases[i]));
    }
    TRY(batches(&row));
    TRY(time_for(&helical_one, 1e-6, &rough));
    TRY(time_for(&helical_one, 1e-8, &fine));
    TRY(time_for(&straight_one, 1e-8, &straight));
    TRY(plan_size(&size));
    printf("\n");
    *missed |= bench_target("helical_nc at 0.98 N to 1e-6 m, cold, median", rough, 5, "us");
    *missed |= bench_target("helical_nc at 0.98 N to 1e-8 m, cold, median", fine, 10, "us");
    *missed |= bench_target("homogeneous straight rod, cold, median", straight, 0.5, "us");
    *missed |= bench_target("batch on helical_nc at 1e-6 m, CPU per row", row, 1e6 / 150000, "us");
    *missed |= bench_target("plan of 66 stations and 3 tendons", size, 100, "kB");

done:
    return st;
}

int main(void)
{
    status st = OK;
    int missed = 0;
    TRY(unloaded(&missed));
    TRY(loaded(&missed));

done:
    if (st != OK) {
        fprintf(stderr, "bench_rod: %s\n", status_message());
    }
    return st != OK || missed;
}
