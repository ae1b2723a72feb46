// tests/fuzz/fuzz_shapes.c
// fuzz_shapes SECONDS [SEED]: random outlines, degenerate ones among them, each meshed in a child
// process. Always a mesh that passes the checks, or an error with a text; never a crash, never
// longer than a minute.
#include "base/door.h"
#include "tests/shapes.h"

#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { MOST_SHAPES = 7, MOST_CORNERS = 9, TIME_LIMIT = 60 };

typedef struct source {
    uint64_t state;
    double last[8]; // lengths drawn before, to be met again exactly or almost
    int nlast;
} source;

// xorshift64*
static uint64_t draw(source *r)
{
    r->state ^= r->state >> 12;
    r->state ^= r->state << 25;
    r->state ^= r->state >> 27;
    return r->state * 2685821657736338717u;
}

static int below(source *r, int n)
{
    return (int)(draw(r) >> 33) % n;
}

static double uniform(source *r, double low, double high)
{
    return low + (high - low) * (double)(draw(r) >> 11) / 9007199254740992.0;
}

static double strange(source *r)
{
    const double odd[] = {0, -1, NAN, INFINITY, 1e300, 1e-300, 1e6, 1e-12, 1e-7};
    return odd[below(r, (int)(sizeof odd / sizeof *odd))];
}

// mostly within a few mm; sometimes an earlier one again, or one that all but equals it
static double any_length(source *r, double low, double high)
{
    double x = uniform(r, low, high);
    const int how = below(r, 40);
    if (how == 0) {
        x = strange(r);
    } else if (how < 10 && r->nlast > 0) {
        x = r->last[below(r, r->nlast)];
    } else if (how < 14 && r->nlast > 0) {
        x = r->last[below(r, r->nlast)] * (1 + pow(10, -uniform(r, 3, 14)));
    } else if (how < 22) {
        x = round(x * 2) / 2;
    }
    r->last[r->nlast < 8 ? r->nlast++ : below(r, 8)] = x;
    return x;
}

static double any_angle(source *r)
{
    const int how = below(r, 30);
    if (how == 0) {
        return strange(r);
    }
    return how < 12 ? PI / 8 * below(r, 33) : uniform(r, -7, 7);
}

static shape_spec any_shape(source *r, double *corner)
{
    const int material = below(r, 4) - 1;
    const double outer = any_length(r, 0.3, 4), inner = any_length(r, 0, 3);
    shape_spec s = {0};
    double x = 0, y = 0;
    if (below(r, 3) == 0) {
        x = any_length(r, -2, 2);
        y = any_length(r, -2, 2);
    }
    switch (below(r, 10)) {
    case 6:
        return an_ellipse(outer, inner, any_angle(r), x, y, material);
    case 7:
        s = a_rounded_rectangle(outer, inner, any_length(r, 0, fmin(outer, inner) / 2),
                                any_angle(r), material);
        s.rounded_rectangle.centre[0] = fixed(x);
        s.rounded_rectangle.centre[1] = fixed(y);
        return s;
    case 8:
        s = an_ellipse(inner / 4, outer / 8, any_angle(r), any_length(r, -3, 3), y, material);
        return in_array(s, 1 + below(r, 5), any_angle(r), below(r, 3) > 0);
    case 9:
        return lumens_on_a_circle(outer / 10, 1 + below(r, 6), inner, any_angle(r), material);
    case 0:
        s = an_annulus(fmax(outer, inner), fmin(outer, inner), material);
        break;
    case 1:
    case 2:
        s = a_sector(fmax(outer, inner), fmin(outer, inner), any_angle(r), fabs(any_angle(r)) / 2,
                     material);
        break;
    case 3:
        return a_disc(outer, x, y, material);
    case 4:
        return a_rectangle(outer, inner, any_angle(r), x, y, material);
    default: {
        const int n = 3 + below(r, MOST_CORNERS - 2);
        for (int i = 0; i < n; i++) {
            // mostly star-shaped, so that most of them do not cross themselves
            const double a = 2 * PI * i / n + (below(r, 8) == 0 ? uniform(r, 0, 3) : 0);
            const double radius = any_length(r, 0.5, 4);
            corner[2 * i] = radius * cos(a);
            corner[2 * i + 1] = radius * sin(a);
        }
        const bool smooth = below(r, 2) == 0;
        s = smooth ? a_spline(n, corner, material) : a_polygon(n, corner, material);
        polygon_spec *drawn = smooth ? &s.spline : &s.polygon;
        drawn->angle = fixed(any_angle(r));
        drawn->centre[0] = fixed(x);
        drawn->centre[1] = fixed(y);
        return s;
    }
    }
    ring_spec *ring = mark_given(s.sector.at) ? &s.sector : &s.annulus;
    ring->centre[0] = fixed(x);
    ring->centre[1] = fixed(y);
    return s;
}

static void tell(int n, const shape_spec *s)
{
    section_outline o = {0};
    if (shapes_at((shape_list){.count = n, .items = s}, 0, &o) != OK) {
        return;
    }
    for (int k = 0; k < o.count; k++) {
        const outline *p = &o.items[k];
        printf(
            "  %-22s material %2d centre %.17g %.17g outer %.17g inner %.17g mid %.17g width %.17g "
            "size %.17g %.17g angle %.17g\n",
            p->called, p->material, p->centre[0], p->centre[1], p->outer, p->inner, p->mid_angle,
            p->width, p->size[0], p->size[1], p->angle);
        for (int i = 0; p->nloop > 0 && i < p->loop_start[p->nloop]; i++) {
            double x[2];
            if (p->kind == KIND_LOOPS) {
                carrier_start(&p->piece[i], x);
            } else {
                memcpy(x, p->point + 2 * i, sizeof x);
            }
            printf("            %.17g %.17g\n", x[0], x[1]);
        }
    }
    section_outline_free(&o);
}

// 0 a mesh, 1 refused by its input, 2 another error; 10 and more: wrong
static int run_case(uint64_t seed, bool talk)
{
    source r = {.state = seed * 0x9E3779B97F4A7C15u + 1};
    shape_spec s[MOST_SHAPES];
    double corner[MOST_SHAPES][2 * MOST_CORNERS];
    for (int i = 0; i < 10; i++) {
        (void)draw(&r);
    }
    const int n = 1 + below(&r, MOST_SHAPES);
    for (int k = 0; k < n; k++) {
        s[k] = any_shape(&r, corner[k]);
    }
    const double sizes[] = {0, 0, 0, 0.3, 1, 10, 0.1};
    const int order = 1 + below(&r, 4), kind = below(&r, 5) == 0 ? MESH_FREE : MESH_AUTO;
    mesh m = {0};
    if (talk) {
        tell(n, s);
        status_clear();
    }
    const status st = mesh_of(n, s, kind, order, sizes[below(&r, 7)], &m);
    if (st == OK) {
        double least = 0;
        const bool good = mesh_check(&m) == OK && mesh_min_jacobian(&m, &least) == OK &&
                          least > 0 && mesh_moments(&m, -1).a[0] > 0;
        if (talk) {
            printf("  %d shapes, order %d: %d elements, least det J %.3g\n", n, order,
                   mesh_element_count(&m), least);
        }
        mesh_free(&m);
        return good ? 0 : 10;
    }
    if (talk || (st != ERR_INPUT && st != OK)) {
        printf("case %llu: %d shapes, order %d, status %d: %s\n", (unsigned long long)seed, n,
               order, (int)st, status_message());
        (void)fflush(stdout);
    }
    return status_message()[0] == '\0' || st == ERR_BUG ? 11 : st == ERR_INPUT ? 1 : 2;
}

static int run_child(uint64_t seed)
{
    int how = 0;
    (void)fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        (void)alarm(TIME_LIMIT);
        _exit(run_case(seed, false));
    }
    if (child < 0 || waitpid(child, &how, 0) != child) {
        return 12;
    }
    return WIFEXITED(how) ? WEXITSTATUS(how) : 100 + WTERMSIG(how);
}

int main(int argc, char **argv)
{
    const double seconds = argc > 1 ? atof(argv[1]) : 10;
    uint64_t seed = argc > 2 ? strtoull(argv[2], NULL, 10) : (uint64_t)time(NULL);
    door_function unused = NULL;
    if (door_open("gmsh", "gmsh_door_mesh", &unused) != OK) {
        printf("%s\n", status_message());
        return 5;
    }
    if (seconds <= 0) { // one case, told in full
        return run_case(seed, true) >= 10;
    }
    printf("seed %llu\n", (unsigned long long)seed);
    const time_t end = time(NULL) + (time_t)seconds;
    int count[3] = {0}, wrong = 0;
    for (; time(NULL) < end; seed++) {
        const int result = run_child(seed);
        if (result < 3) {
            count[result]++;
        } else {
            wrong++;
            printf("case %llu: WRONG, %s %d\n", (unsigned long long)seed,
                   result > 100 ? "signal" : "check", result > 100 ? result - 100 : result);
        }
    }
    printf("%d meshed, %d refused, %d other errors, %d wrong\n", count[0], count[1], count[2],
           wrong);
    return wrong != 0;
}
