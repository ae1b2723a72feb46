// app/print_rod.c
#include "app/print.h"

#include "app/command.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double degrees = 180 / 3.14159265358979323846;

// tendons whose numbers fit beside one another; the others stand in the JSON and the tables
enum { SHOWN_TENDONS = 6, SHOWN_LOADS = 4, SHOWN_CRITICAL = 12, NAMED = 12 };

// what the table holds beyond tensions and tips
typedef struct columns {
    int ntendon, nload;
    bool stability;
} columns;

static columns columns_of(const rod_result *rods)
{
    columns c = {.ntendon = rods->ntendon < SHOWN_TENDONS ? rods->ntendon : SHOWN_TENDONS,
                 .stability = rods->nload > 0};
    for (int i = 0; i < rods->nsolution; i++) {
        const struct rod_run *run = &rods->run[i];
        c.stability = c.stability || run->ncritical > 0 || run->stable != 1 || run->fraction < 1;
        for (int k = 0; k < rods->ntendon; k++) {
            c.stability = c.stability || !isnan(run->pull[k]);
        }
        for (int k = 0; k < rods->nload && k < SHOWN_LOADS; k++) {
            c.nload = run->load[k] != 1 && c.nload <= k ? k + 1 : c.nload;
        }
    }
    return c;
}

static void print_head(const columns *c)
{
    const int wide = 8 * c->ntendon;
    printf("\n%*s", wide > 10 ? wide : 10, c->ntendon ? "tension N" : "");
    if (c->nload) {
        printf(" %*s", 8 * c->nload, "load factor");
    }
    printf("  %29s %9s %9s", "tip x, y, z mm", "bend deg", "strain %");
    if (c->ntendon) {
        printf(" %*s", 10 * c->ntendon, "tendon mm");
    }
    printf(" %6s %8s", "steps", "error");
    if (c->stability) {
        printf(" %7s %10s %8s", "stable", "eigenvalue", "reached");
    }
    (void)putchar('\n');
}

static void print_tensions(const columns *c, const struct rod_run *run)
{
    printf("%*s", 8 * c->ntendon < 10 ? 10 - 8 * c->ntendon : 0, "");
    for (int k = 0; k < c->ntendon; k++) {
        if (result_is_slack(run, k)) {
            printf(" %7s", "slack");
        } else {
            printf(" %7.3f", run->tension[k]);
        }
    }
    for (int k = 0; k < c->nload; k++) {
        printf(" %7.4g", run->load[k]);
    }
    printf("%*s", c->nload == 1 ? 4 : c->nload ? 1 : 0, "");
}

static void print_stability(const struct rod_run *run)
{
    printf(" %7s", run->stable < 0 ? "?" : run->stable ? "yes" : "no");
    if (isnan(run->eigenvalue)) {
        printf(" %10s", "-");
    } else {
        printf(" %10.3g", run->eigenvalue);
    }
    printf(" %7.4g%s", run->fraction, run->fraction < 1 ? "!" : "");
}

static void print_run(const run_result *r, const columns *c, const struct rod_run *run)
{
    print_tensions(c, run);
    printf("  %9.4f %9.4f %9.4f %9.2f %8.2f%s", print_shown(1e3 * run->tip.p.a[0], 1e-4),
           print_shown(1e3 * run->tip.p.a[1], 1e-4), print_shown(1e3 * run->tip.p.a[2], 1e-4),
           degrees * run->total_bend_rad, 100 * run->largest_strain,
           result_beyond_linear(r, run) >= 0 ? "!" : " ");
    for (int k = 0; k < c->ntendon; k++) {
        printf(" %9.3f", 1e3 * run->tendon_length[k]);
    }
    if (isnan(run->relative_error)) {
        printf(" %6d %8s", run->iterations, "-");
    } else {
        printf(" %6d %8.1e", run->iterations, run->relative_error);
    }
    if (c->stability) {
        print_stability(run);
    }
    (void)putchar('\n');
}

static void print_names(const char *kind, int n, char (*names)[RESULT_NAME])
{
    if (n > NAMED) {
        printf(", %d %ss", n, kind);
        return;
    }
    if (n > 0) {
        printf(", %s%s", kind, n == 1 ? "" : "s");
    }
    for (int k = 0; k < n; k++) {
        printf("%s %s", k ? "," : "", names[k]);
    }
}

// limit points and bifurcations on the way
static void print_critical(const rod_result *rods)
{
    int shown = 0;
    for (int i = 0; i < rods->nsolution; i++) {
        const struct rod_run *run = &rods->run[i];
        for (int k = 0; k < run->ncritical; k++) {
            if (shown++ == SHOWN_CRITICAL) {
                printf("...\n");
                return;
            }
            printf("solution %d: %s at %.6g of its way\n", i + 1,
                   run->critical[k].kind == CRITICAL_LIMIT ? "limit point"
                                                           : "bifurcation or loss of stability",
                   run->critical[k].fraction);
        }
        if (run->fraction < 1) {
            printf("! solution %d is the shape at its limit point, where the rod snaps\n", i + 1);
        }
    }
}

// the worst of the solutions for which there is a balance
static void print_balance(const rod_result *rods)
{
    double most = NAN;
    for (int i = 0; i < rods->nsolution; i++) {
        most = fmax(most, result_energy_misfit(&rods->run[i]));
    }
    if (most >= 0) {
        printf("energy stored against work done: %.1e apart\n", most);
    }
}

void print_rods(const run_result *r)
{
    const rod_result *rods = &r->rod;
    const columns c = columns_of(rods);
    printf("rod: %.4g mm", 1e3 * r->rod_length);
    print_names("tendon", rods->ntendon, rods->tendon_name);
    print_names("load", rods->nload, rods->load_name);
    print_head(&c);
    for (int i = 0; i < rods->nsolution; i++) {
        print_run(r, &c, &rods->run[i]);
    }
    if (c.ntendon < rods->ntendon) {
        printf("the first %d of %d tendons are shown\n", c.ntendon, rods->ntendon);
    }
    print_critical(rods);
    if (c.stability) {
        print_balance(rods);
    }
    print_strains(r);
}
