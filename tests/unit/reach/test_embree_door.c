// tests/unit/reach/test_embree_door.c
#include "base/door.h"
#include "reach/embree_door.h"

#include "tests/test.h"

#include <stdbool.h>
#include <string.h>

enum { N = 10, COUNT = N * N * N };

// boxes of half the spacing at the points of a grid
static const double spacing = 1e-3, half = 0.25e-3, corner[3] = {5, -3, 0.1};

static void grid_box(const void *none, int i, double low[3], double high[3])
{
    const int at[3] = {i % N, i / N % N, i / (N * N)};
    (void)none;
    for (int d = 0; d < 3; d++) {
        low[d] = corner[d] + spacing * at[d] - half;
        high[d] = corner[d] + spacing * at[d] + half;
    }
}

static double gap(int i, const double p[3])
{
    double low[3], high[3], sum = 0;
    grid_box(NULL, i, low, high);
    for (int d = 0; d < 3; d++) {
        const double x = fmax(0, fmax(low[d] - p[d], p[d] - high[d]));
        sum += x * x;
    }
    return sqrt(sum);
}

typedef struct visit {
    const double *p;
    double radius, best;
    int count, most;
    bool seen[COUNT];
} visit;

static double mark(void *context, int i)
{
    visit *v = context;
    v->count++;
    v->seen[i] = true;
    return v->count == v->most ? -1 : v->radius;
}

static double approach(void *context, int i)
{
    visit *v = context;
    v->count++;
    v->best = fmin(v->best, gap(i, v->p));
    return v->best;
}

static double draw(unsigned *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0;
}

static void everything_within_a_radius_is_visited(const embree_door *door, const box_tree *t)
{
    unsigned state = 1;
    static visit v;
    for (int k = 0; k < 200; k++) {
        double p[3];
        for (int d = 0; d < 3; d++) {
            p[d] = corner[d] + spacing * (14 * draw(&state) - 2);
        }
        v = (visit){.p = p, .radius = 2 * spacing * draw(&state)};
        door->near(t, p, v.radius, mark, &v);
        int missed = 0, superfluous = 0;
        for (int i = 0; i < COUNT; i++) {
            missed += !v.seen[i] && gap(i, p) <= v.radius;
            superfluous += v.seen[i] && gap(i, p) > v.radius + 2e-7;
        }
        CHECK(missed == 0);
        CHECK(superfluous < COUNT / 4);
    }
}

static void the_nearest_is_found_with_few_visits(const embree_door *door, const box_tree *t)
{
    unsigned state = 2;
    int visits = 0;
    static visit v;
    for (int k = 0; k < 200; k++) {
        double p[3], least = INFINITY;
        for (int d = 0; d < 3; d++) {
            p[d] = corner[d] + spacing * (20 * draw(&state) - 5);
        }
        for (int i = 0; i < COUNT; i++) {
            least = fmin(least, gap(i, p));
        }
        v = (visit){.p = p, .best = INFINITY};
        door->near(t, p, INFINITY, approach, &v);
        CHECK(v.best == least);
        visits += v.count;
    }
    CHECK(visits < 200 * 30);
}

static void it_ends_when_told(const embree_door *door, const box_tree *t)
{
    static visit v;
    v = (visit){.radius = INFINITY, .most = 3};
    door->near(t, corner, INFINITY, mark, &v);
    CHECK(v.count == 3);
    v = (visit){.radius = INFINITY};
    door->near(t, corner, INFINITY, mark, &v);
    CHECK(v.count == COUNT);
}

static void point_box(const void *none, int i, double low[3], double high[3])
{
    (void)none;
    (void)i;
    memcpy(low, corner, sizeof corner);
    memcpy(high, corner, sizeof corner);
}

static void one_item_without_size_is_found(const embree_door *door)
{
    box_tree *t = NULL;
    static visit v;
    v = (visit){.radius = 0};
    CHECK_OK(door->make(1, point_box, NULL, &t));
    door->near(t, corner, 0, mark, &v);
    CHECK(v.count == 1);
    door->free(t);
    door->free(NULL);
}

int main(void)
{
    const embree_door *door = NULL;
    box_tree *t = NULL;
    CHECK(!door_is_open("embree"));
    CHECK_OK(embree_door_open(&door));
    CHECK(door_is_open("embree"));
    CHECK_OK(door->make(COUNT, grid_box, NULL, &t));
    everything_within_a_radius_is_visited(door, t);
    the_nearest_is_found_with_few_visits(door, t);
    it_ends_when_told(door, t);
    one_item_without_size_is_found(door);
    door->free(t);
    return test_failures != 0;
}
