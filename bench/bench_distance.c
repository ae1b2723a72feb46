// bench/bench_distance.c
// Signed distances to a surface of 100 k triangles: making it, the tree, and queries by CPU time.
#include "bench/bench.h"
#include "reach/clearance.h"
#include "tests/surfaces.h"

enum { QUERIES = 1000 * 1000, M = 112, BODIES = 200 };

static double draw(unsigned *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0;
}

static vec3 draw_within(unsigned *state, double half)
{
    vec3 p;
    for (int d = 0; d < 3; d++) {
        p.a[d] = half * (2 * draw(state) - 1);
    }
    return p;
}

// microseconds per query, among all points about the surface or near it
static double time_queries(const surface *s, const distance_tree *t, bool near, double *sum)
{
    unsigned state = 7;
    const double begin = bench_cpu_ms();
    for (int i = 0; i < QUERIES; i++) {
        vec3 p = draw_within(&state, near ? 1e-3 : 55e-3);
        if (near) {
            p = vec3_add(p, surface_vertex(s, (int)(draw(&state) * s->nvertex)));
        }
        *sum += distance_to(t, p).distance;
    }
    return 1e3 * (bench_cpu_ms() - begin) / QUERIES;
}

static vec3 arc_at(const void *context, double s)
{
    const double *bend = context;
    const double k = *bend / 60e-3;
    return (vec3){{(1 - cos(k * s)) / k, 1e-3, sin(k * s) / k - 30e-3}};
}

// microseconds per body of 60 mm: free or not, and how much room to 10 um
static void time_bodies(const distance_tree *t, double us[2], double queries[2])
{
    clearance c;
    for (int whole = 0; whole < 2; whole++) {
        const double begin = bench_cpu_ms();
        queries[whole] = 0;
        for (int i = 0; i < BODIES; i++) {
            const double bend = 0.01 + 3.0 * i / BODIES;
            const body_curve b = {
                .at = arc_at, .context = &bend, .begin = 0, .end = 60e-3, .stretch = 1};
            // as a search asks for a pose's room: no more than whether there is any
            const clearance_wish wish = {.tolerance = 1e-5, .below = whole ? -INFINITY : 0};
            clearance_until(t, &b, 1.5e-3, &wish, &c);
            queries[whole] += (double)c.queries / BODIES;
        }
        us[whole] = 1e3 * (bench_cpu_ms() - begin) / BODIES;
    }
}

static status run(int *missed)
{
    status st = OK;
    made_surface m = {0};
    surface s = {0};
    surface_report r;
    distance_tree *t = NULL;
    double sum = 0, us[2], queries[2];
    made_ball(&m, M, made_bumpy);
    double begin = bench_cpu_ms();
    TRY(made_closed(&m, &s, &r));
    const double made = bench_cpu_ms() - begin;
    begin = bench_cpu_ms();
    TRY(distance_tree_make(&s, &t));
    const double tree = bench_cpu_ms() - begin;
    const double about = time_queries(&s, t, false, &sum), near = time_queries(&s, t, true, &sum);
    time_bodies(t, us, queries);
    printf("%d triangles, %d queries each (sum %.6g)\n", s.ntriangle, QUERIES, sum);
    printf("body of 60 mm: free or not %.1f us (%.0f queries), its clearance to 10 um %.1f us "
           "(%.0f queries)\n",
           us[0], queries[0], us[1], queries[1]);
    // a scope and 20 targets may take 2 s, some 10^4 bodies: 100 us for each
    *missed |= bench_target("surface of 100 k triangles made and checked, CPU", made, 500, "ms");
    *missed |= bench_target("its tree, CPU", tree, 200, "ms");
    *missed |= bench_target("body of 60 mm free or not, CPU", us[0], 100, "us");
    *missed |= bench_target("signed distance anywhere about it, CPU", about, 20, "us");
    *missed |= bench_target("signed distance within 1 mm of it, CPU", near, 5, "us");

done:
    distance_tree_free(t);
    surface_free(&s);
    made_free(&m);
    return st;
}

int main(void)
{
    int missed = 0;
    const status st = run(&missed);
    if (st != OK) {
        fprintf(stderr, "bench_distance: %s\n", status_message());
    }
    return st != OK || missed;
}
