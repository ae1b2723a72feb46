// app/print_reach.c
#include "app/print.h"
#include "reports/reach_show.h"

#include <math.h>
#include <stdio.h>

static const double degree = 0.017453292519943295;

// a number in its column, "-" where it is not known
static void put(int width, int digits, double value)
{
    isfinite(value) ? printf(" %*.*f", width, digits, value) : printf(" %*s", width, "-");
}

static void print_scene(const reach_result *r)
{
    printf("%stissue %s: %d triangles, %.4g cm2, %.4g ml%s%s\n", r->synthetic ? "SYNTHETIC " : "",
           r->tissue, r->ntriangle, 1e4 * r->area, 1e6 * r->volume, r->source[0] ? ": " : "",
           r->source);
    printf("entry at (%.4g, %.4g, %.4g) mm along (%.4g, %.4g, %.4g), the first %.4g mm not looked "
           "at\n",
           1e3 * r->entry.p.a[0], 1e3 * r->entry.p.a[1], 1e3 * r->entry.p.a[2], r->entry.R.a[0][2],
           r->entry.R.a[1][2], r->entry.R.a[2][2], 1e3 * r->entry_free);
    printf("reached: the tip's %s within %.4g mm, %.4g mm beside the body left at least; checked: "
           "%s\n",
           r->tip == REACH_TIP_SKIN ? "skin" : "centre", 1e3 * r->tolerance, 1e3 * r->clearance,
           r->path == REACH_INSERTION ? "the whole way in" : "the final pose, not the way there");
}

static void print_joints(const reach_scope_result *s)
{
    printf("scope %s: %s, tip %.4g mm, radius %.4g mm; insertion %.4g to %.4g mm, turn %.4g to "
           "%.4g deg",
           s->name, s->kind, 1e3 * s->length, 1e3 * s->radius, 1e3 * s->low[SCOPE_INSERTION],
           1e3 * s->high[SCOPE_INSERTION], s->low[SCOPE_TURN] / degree,
           s->high[SCOPE_TURN] / degree);
    const bool rod = !s->arc;
    for (int i = SCOPE_BEND; i < s->njoint; i++) {
        printf(rod ? ", tension %.4g to %.4g N" : ", bend %.4g to %.4g deg",
               s->low[i] / (rod ? 1 : degree), s->high[i] / (rod ? 1 : degree));
    }
    (void)putchar('\n');
    if (s->limit_note[0]) {
        printf("  %s\n", s->limit_note);
    }
}

static void print_answer(const reach_result *r, const reach_scope_result *s, int i)
{
    const reach_answer *a = &s->answer[i];
    char words[REACH_WORDS];
    const bool rod = !s->arc;
    printf("  %-16.40s %-13s", r->target_name[i], reach_verdict_words(a->verdict));
    put(9, 3, 1e3 * a->miss);
    put(10, 3, 1e3 * a->clearance);
    put(10, 2, 1e3 * a->q[SCOPE_INSERTION]);
    put(9, 1, a->q[SCOPE_TURN] / degree);
    for (int i = SCOPE_BEND; i < s->njoint; i++) {
        put(9, rod ? 4 : 1, a->q[i] / (rod ? 1 : degree));
    }
    if (rod) {
        put(8, 2, 100 * a->strain);
    }
    const char *thorough = reach_search_words(r, s, a, words, sizeof words);
    printf("%s%s%s%s\n", a->why[0] ? "  " : "", a->why, thorough[0] ? "; " : "", thorough);
}

static void print_scope(const reach_result *r, const reach_scope_result *s)
{
    const bool rod = !s->arc;
    char joint[24];
    print_joints(s);
    if (r->ntarget > 0) {
        printf("  %-16s %-13s %9s %10s %10s %9s", "target", "", "miss mm", "room mm", "insert mm",
               "turn deg");
        for (int i = SCOPE_BEND; i < s->njoint; i++) {
            (void)snprintf(joint, sizeof joint, s->njoint > SCOPE_BEND + 1 ? "pull%d N" : "pull N",
                           i - SCOPE_BEND + 1);
            printf(" %9s", rod ? joint : "bend deg");
        }
        printf(rod ? " %8s\n" : "\n", "strain %");
    }
    for (int i = 0; i < r->ntarget; i++) {
        print_answer(r, s, i);
    }
}

static void print_comparison(const reach_result *r)
{
    printf("%-32s %16s%s %10s\n", "scope", "reached", r->nmap > 0 ? "    share of area" : "",
           "CPU s");
    for (int i = 0; i < r->nscope; i++) {
        const reach_scope_result *s = &r->scope[i];
        printf("%-32.60s %8d of %4d", s->name, s->nreached, r->ntarget);
        if (r->nmap > 0) {
            printf("  %5.1f +- %.1f %%", 100 * s->area_reached, 100 * s->area_error);
        }
        printf(" %10.2f\n", s->seconds);
    }
    if (r->ntarget > 0) {
        printf("the paper's Table IV, on a patient's anatomy that is not published: constant "
               "curvature %d of %d, helical %d of %d\n",
               PAPER_REACH_CONSTANT_CURVATURE, PAPER_REACH_TARGETS, PAPER_REACH_HELICAL,
               PAPER_REACH_TARGETS);
    }
}

void print_reach(const run_result *run)
{
    const reach_result *r = &run->reach;
    if (!r->there) {
        return;
    }
    print_scene(r);
    for (int i = 0; i < r->nscope; i++) {
        print_scope(r, &r->scope[i]);
    }
    print_comparison(r);
}
