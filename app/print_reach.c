// app/print_reach.c
#include "app/print.h"
#include "io/utf8.h"
#include "reach/reach_case.h"
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
           print_plain(r->tissue).text, r->ntriangle, 1e4 * r->area, 1e6 * r->volume,
           r->source[0] ? ": " : "", print_plain(r->source).text);
    printf("entry at (%.4g, %.4g, %.4g) mm along (%.4g, %.4g, %.4g), the first %.4g mm not looked "
           "at\n",
           1e3 * r->entry.p.a[0], 1e3 * r->entry.p.a[1], 1e3 * r->entry.p.a[2], r->entry.R.a[0][2],
           r->entry.R.a[1][2], r->entry.R.a[2][2], 1e3 * r->entry_free);
    printf("reached: the tip's %s within %.4g mm, %.4g mm beside the body left at least; checked: "
           "%s\n",
           r->tip == REACH_TIP_SKIN ? "skin" : "centre", 1e3 * r->tolerance, 1e3 * r->clearance,
           r->path == REACH_INSERTION ? "the whole way in" : "the final pose, not the way there");
    if (r->nmap > 0) {
        printf("reach map: %d places on the surface (seed %d), reached where the tip's skin comes "
               "within %.4g mm\n",
               r->nmap, r->map_seed, 1e3 * (r->tolerance + r->clearance));
    }
}

static void print_joints(const reach_scope_result *s)
{
    printf("scope %s: %s, tip %.4g mm, radius %.4g mm; insertion %.4g to %.4g mm, turn %.4g to "
           "%.4g deg",
           print_plain(s->name).text, s->kind, 1e3 * s->length, 1e3 * s->radius,
           1e3 * s->low[SCOPE_INSERTION], 1e3 * s->high[SCOPE_INSERTION],
           s->low[SCOPE_TURN] / degree, s->high[SCOPE_TURN] / degree);
    const bool rod = !s->arc;
    for (int i = SCOPE_BEND; i < s->njoint; i++) {
        printf(rod ? ", tension %.4g to %.4g N" : ", bend %.4g to %.4g deg",
               s->low[i] / (rod ? 1 : degree), s->high[i] / (rod ? 1 : degree));
    }
    (void)putchar('\n');
    if (s->limit_note[0]) {
        printf("  %s\n", print_plain(s->limit_note).text);
    }
}

static int name_width(const reach_result *r)
{
    int width = 6;
    for (int i = 0; i < r->ntarget; i++) {
        const int here = (int)utf8_count(print_plain(r->target_name[i]).text);
        width = here > width ? here : width;
    }
    return width;
}

static void print_answer(const reach_result *r, const reach_scope_result *s, int i, int width)
{
    const reach_answer *a = &s->answer[i];
    const print_words name = print_plain(r->target_name[i]);
    printf("  %s%*s %-21s", name.text, width - (int)utf8_count(name.text), "",
           reach_told_words(r, s, a));
    put(8, 3, 1e3 * a->miss);
    put(8, 3, 1e3 * a->clearance);
    if (r->path == REACH_INSERTION) {
        put(8, 3, 1e3 * a->path_clearance);
    }
    put(9, 2, 1e3 * a->q[SCOPE_INSERTION]);
    put(8, 1, a->q[SCOPE_TURN] / degree);
    for (int k = SCOPE_BEND; k < s->njoint; k++) {
        put(8, s->arc ? 1 : 4, a->q[k] / (s->arc ? degree : 1));
    }
    if (!s->arc) {
        put(8, 2, 100 * a->strain);
    }
    printf("%s%s\n", a->why[0] ? "  " : "", print_plain(a->why).text);
}

static void print_names(const reach_result *r, const reach_scope_result *s, int width)
{
    char joint[24];
    printf("  %-*s %-21s %8s %8s%s %9s %8s", width, "target", "", "miss mm", "room mm",
           r->path == REACH_INSERTION ? "  on way" : "", "insert mm", "turn deg");
    for (int i = SCOPE_BEND; i < s->njoint; i++) {
        (void)snprintf(joint, sizeof joint, s->njoint > SCOPE_BEND + 1 ? "pull%d N" : "pull N",
                       i - SCOPE_BEND + 1);
        printf(" %8s", s->arc ? "bend deg" : joint);
    }
    printf(s->arc ? "\n" : " %8s\n", "strain %");
}

// how sure the targets are that are not reached: those of one verdict in one line
static void print_thoroughness(const reach_result *r, const reach_scope_result *s)
{
    char words[REACH_WORDS];
    int far = -1, touch = 0, proved = 0, looks = 0;
    double room = -INFINITY;
    for (int i = 0; i < r->ntarget; i++) {
        const reach_answer *a = &s->answer[i];
        const bool is_far =
            a->verdict == REACH_OUT_OF_REACH || (a->verdict == REACH_JOINT_LIMIT && a->joint >= 0);
        // the least sure of them
        far = is_far && (far < 0 || !reach_is_proved(r, s, a)) ? i : far;
        if (a->verdict == REACH_COLLISION) {
            touch++;
            proved += reach_is_proved(r, s, a);
            looks = a->looks > looks ? a->looks : looks;
            room = reach_is_proved(r, s, a) ? room : fmax(room, a->bound);
        }
    }
    if (far >= 0) {
        printf("  too far: %s\n", reach_search_words(r, s, &s->answer[far], words, sizeof words));
    }
    if (touch > 0) {
        printf("  collision: %d, of which %d proved; at most %d looks each, down to steps of %.3g "
               "mm",
               touch, proved, looks, 1e3 * r->resolution);
        if (proved < touch && isfinite(room)) {
            printf("; of the others no pose has more room than %.3g mm", 1e3 * room);
        }
        (void)putchar('\n');
    }
}

static void print_scope(const reach_result *r, const reach_scope_result *s)
{
    const int width = name_width(r);
    print_joints(s);
    if (r->ntarget > 0) {
        print_names(r, s, width);
    }
    for (int i = 0; i < r->ntarget; i++) {
        print_answer(r, s, i, width);
    }
    print_thoroughness(r, s);
}

static void print_comparison(const reach_result *r)
{
    printf("%-32s %16s %10s%s %10s\n", "scope", "reached", "not proved",
           r->nmap > 0 ? "    share of area                 " : "", "CPU s");
    for (int i = 0; i < r->nscope; i++) {
        const reach_scope_result *s = &r->scope[i];
        if (r->ntarget > 0) {
            printf("%-32.60s %8d of %4d %10d", print_plain(s->name).text, s->nreached, r->ntarget,
                   reach_open_count(r, s));
        } else {
            printf("%-32.60s %16s %10s", print_plain(s->name).text, "-", "-");
        }
        if (r->nmap > 0) {
            printf("  %5.1f +- %.1f %%, %4.1f %% not known", 100 * s->area_reached,
                   100 * s->area_error, 100 * s->area_undecided);
        }
        printf(" %10.2f\n", s->seconds);
    }
    if (r->paper == REACH_PAPER_TABLE_4) {
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
