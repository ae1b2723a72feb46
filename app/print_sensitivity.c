// app/print_sensitivity.c
// What moves the answer, for people: parameters by how far they move the tip.
#include "app/print.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SHOWN_SOLUTIONS = 12, NAME = 28 };
static const double degrees = 180 / 3.14159265358979323846;

static void print_number(int width, const char *format, double value)
    __attribute__((format(printf, 2, 0)));
static void print_number(int width, const char *format, double value)
{
    char text[40] = "-";
    if (!isnan(value)) {
        (void)snprintf(text, sizeof text, format, value);
    }
    printf(" %*s", width, text);
}

// "0, 0.98 N"; pulled lengths where they were given
static void print_given(const run_result *r, int solution)
{
    const struct rod_run *run = &r->rod.run[solution];
    for (int i = 0; i < r->rod.ntendon; i++) {
        const bool pulled = !isnan(run->pull[i]);
        printf("%s%.6g %s", i ? ", " : ": ", pulled ? 1e3 * run->pull[i] : run->tension[i],
               pulled ? "mm" : "N");
    }
    for (int i = 0; i < r->rod.nload; i++) {
        printf("%s%s x%.4g", i || r->rod.ntendon ? ", " : ": ", r->rod.load_name[i], run->load[i]);
    }
}

static void print_head(void)
{
    printf("%-*s %12s %22s | %9s %9s %7s | %8s %8s | %11s %9s\n", NAME, "parameter", "as it is",
           "from, to", "tip mm", "", "% of L", "bend deg", "", "tip mm per", "it alone");
    printf("%-*s %12s %22s | %9s %9s %7s | %8s %8s | %11s %9s\n", NAME, "", "", "", "at from",
           "at to", "", "at from", "at to", "unit", "is off");
}

static void print_range(const mover *p)
{
    char range[2 * MOVER_TEXT + 8];
    if (p->discrete) {
        (void)snprintf(range, sizeof range, "%s", p->end[MOVER_HIGH].text);
    } else {
        (void)snprintf(range, sizeof range, "%s, %s", p->end[MOVER_LOW].text,
                       p->end[MOVER_HIGH].text);
    }
    char name[MOVER_NAME + MOVER_UNIT + 4];
    (void)snprintf(name, sizeof name, "%s%s%s", p->name, p->unit[0] ? ", " : "", p->unit);
    printf("%-*.*s %12.12s %22s |", NAME, NAME, name, p->text, range);
}

// the larger of both ends
static double nonlinearity(const run_result *r, const mover *p, const move *m)
{
    return fmax(move_nonlinearity(p, m, MOVER_LOW, r->rod_length),
                move_nonlinearity(p, m, MOVER_HIGH, r->rod_length));
}

static void print_move(const run_result *r, const mover *p, const move *m)
{
    print_range(p);
    print_number(9, "%.3f", 1e3 * move_size(m, MOVER_LOW));
    print_number(9, "%.3f", 1e3 * move_size(m, MOVER_HIGH));
    print_number(7, "%.2f", 100 * move_largest(m) / r->rod_length);
    printf(" |");
    print_number(8, "%+.3f", print_shown(degrees * m->bend[MOVER_LOW], 1e-3));
    print_number(8, "%+.3f", print_shown(degrees * m->bend[MOVER_HIGH], 1e-3));
    printf(" |");
    print_number(11, "%.5g", 1e3 * hypot(hypot(m->rate[0], m->rate[1]), m->rate[2]));
    print_number(9, "%.1f%%", 100 * nonlinearity(r, p, m));
    (void)putchar('\n');
}

static void print_solution(const run_result *r, int solution)
{
    const sensitivity_result *s = &r->sensitivity;
    const struct rod_run *run = &r->rod.run[s->solution[solution]];
    int order[MOST_MOVERS];
    printf("\nsolution %d", s->solution[solution] + 1);
    print_given(r, s->solution[solution]);
    printf("; tip (%.3f, %.3f, %.3f) mm, bend %.2f deg\n", print_shown(1e3 * run->tip.p.a[0], 1e-3),
           print_shown(1e3 * run->tip.p.a[1], 1e-3), print_shown(1e3 * run->tip.p.a[2], 1e-3),
           degrees * run->total_bend_rad);
    print_head();
    sensitivity_sort(s, solution, order);
    for (int i = 0; i < s->nmover; i++) {
        print_move(r, &s->mover[order[i]], sensitivity_move(s, order[i], solution));
    }
}

static void print_reasons(const sensitivity_result *s)
{
    for (int k = 0; k < s->nmover; k++) {
        const mover *p = &s->mover[k];
        for (int end = 0; end < MOVER_ENDS; end++) {
            if (p->end[end].why[0]) {
                printf("%s = %s: %s\n", print_plain(p->name).text, p->end[end].text,
                       p->end[end].why);
            }
        }
        if (p->no_rate[0]) {
            printf("%s: no derivative, %s\n", print_plain(p->name).text, p->no_rate);
        }
    }
}

// --- random samples

// heads are told whole
static int share_width(const mover *p)
{
    const int length = (int)strlen(p->name);
    return length < 12 ? 12 : length;
}

static void print_spread(const sensitivity_result *s, int solution, int quantity)
{
    static const char *const names[SPREAD_QUANTITIES] = {"tip x mm", "tip y mm", "tip z mm",
                                                         "tip off mm", "bend deg"};
    const sample_spread *a = sensitivity_spread(s, solution, quantity);
    const double *share = sensitivity_share(s, solution, quantity);
    const double unit = quantity == SPREAD_BEND ? degrees : 1e3;
    printf("%-12s", names[quantity]);
    print_number(9, "%.3f", print_shown(unit * a->mean, 1e-3));
    print_number(9, "%.3f", unit * a->deviation);
    print_number(9, "%.3f", print_shown(unit * a->low, 1e-3));
    print_number(9, "%.3f", print_shown(unit * a->median, 1e-3));
    print_number(9, "%.3f", print_shown(unit * a->high, 1e-3));
    printf(" |");
    for (int k = 0; k < s->nmover; k++) {
        if (s->mover[k].drawn) {
            print_number(share_width(&s->mover[k]), "%.1f", 100 * share[k]);
        }
    }
    print_number(7, "%.1f", 100 * a->rest);
    (void)putchar('\n');
}

static void print_spreads(const run_result *r, int solution)
{
    const sensitivity_result *s = &r->sensitivity;
    const monte_carlo *m = &s->monte_carlo;
    printf("\nsolution %d", s->solution[solution] + 1);
    print_given(r, s->solution[solution]);
    printf("; %d samples%s", m->used[solution], m->used[solution] < m->nsample ? "!" : "");
    printf("\n%-12s %9s %9s %9s %9s %9s |", "", "mean", "deviation", "5 %", "50 %", "95 %");
    for (int k = 0; k < s->nmover; k++) {
        if (s->mover[k].drawn) {
            printf(" %*s", share_width(&s->mover[k]), s->mover[k].name);
        }
    }
    printf(" %7s\n", "other");
    for (int q = 0; q < SPREAD_QUANTITIES; q++) {
        print_spread(s, solution, q);
    }
}

static void print_monte_carlo(const run_result *r)
{
    const sensitivity_result *s = &r->sensitivity;
    const monte_carlo *m = &s->monte_carlo;
    bool lost = false;
    printf(
        "\nMonte Carlo: %d samples, seed %d; every sample is solved. Right: shares of the variance "
        "in %%, first order, by a sum of one polynomial of degree %d per parameter\n",
        m->nsample, m->seed, m->degree);
    for (int i = 0; i < s->nsolution && i < SHOWN_SOLUTIONS; i++) {
        print_spreads(r, i);
        lost = lost || m->used[i] < m->nsample;
    }
    printf(
        "shares are estimates from %d samples, each good to +- %.0f or so: they may add up to more "
        "than 100\n",
        m->nsample, 100 / sqrt(m->nsample));
    if (lost) {
        printf(
            "! samples without an answer (a tendon that eats its length, a limit point) are left "
            "out\n");
    }
}

void print_sensitivity(const run_result *r)
{
    const sensitivity_result *s = &r->sensitivity;
    if (!r->has_sensitivity) {
        return;
    }
    printf("what moves the tip of '%s': %d parameter%s, one at a time%s\n", r->title, s->nmover,
           s->nmover == 1 ? "" : "s",
           s->own_list ? " (the case names none: the list for any case)" : "");
    for (int i = 0; i < s->nsolution && i < SHOWN_SOLUTIONS; i++) {
        print_solution(r, i);
    }
    if (s->nsolution > SHOWN_SOLUTIONS) {
        printf("\nthe first %d of %d solutions are shown\n", SHOWN_SOLUTIONS, s->nsolution);
    }
    print_reasons(s);
    if (s->monte_carlo.nsample > 0) {
        print_monte_carlo(r);
    }
}
