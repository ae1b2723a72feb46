// tests/unit/rodsolver/test_rod_allocation.c
// rod_solve, what is asked after it and the rows of rod_batch allocate nothing: every allocation of
// this program is counted.
#include "tests/unit/rodsolver/prototypes.h"

#include <stddef.h>

static long allocations;

#if defined(__SANITIZE_ADDRESS__)
// the sanitizer owns malloc and offers hooks instead
int __sanitizer_install_malloc_and_free_hooks(void (*)(const volatile void *, size_t),
                                              void (*)(const volatile void *));
static void count(const volatile void *p, size_t size)
{
    (void)p;
    (void)size;
    allocations++;
}
static void ignore(const volatile void *p)
{
    (void)p;
}
static void start_counting(void)
{
    CHECK(__sanitizer_install_malloc_and_free_hooks(count, ignore) > 0);
}
#else
// the program's own malloc stands before the C library's
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t n, size_t size);
void *__libc_realloc(void *p, size_t size);
void *malloc(size_t size)
{
    allocations++;
    return __libc_malloc(size);
}
void *calloc(size_t n, size_t size)
{
    allocations++;
    return __libc_calloc(n, size);
}
void *realloc(void *p, size_t size)
{
    allocations++;
    return __libc_realloc(p, size);
}
static void start_counting(void)
{
}
#endif

static double quarter_turn(const void *expression, double s)
{
    (void)expression;
    return PROTOTYPE_PI / 2 * s / 0.12;
}

static void solving_allocates_nothing(int frame)
{
    enum { POINTS = 13 };
    const prototype p = helical_nc();
    law_along law = {0};
    prototype_law(&p, &law);
    tendon_spec tendon[3] = {straight_tendon("a", 3.6e-3, 0), straight_tendon("b", 3.6e-3, 2),
                             straight_tendon("c", 3.6e-3, 4)};
    tendon[1].angle = (field){.at = quarter_turn};
    tendon[2].end = 0.05;
    const long before_make = allocations;
    const made_rod r = make_rod(&law, 3, tendon, (rod_options){.frame = frame, .tolerance = 1e-9});
    CHECK(allocations > before_make); // the counter works

    const double tension[4][3] = {{0.98, 0, 0}, {0.3, 0.4, 0.5}, {0, 0, 1}, {3.9, 0, 0}};
    double length[3], s[POINTS];
    pose shape[POINTS];
    for (int i = 0; i < 4; i++) {
        rod_solution out = {.tendon_length = length};
        vec6 xi;
        const long before = allocations;
        const status solved = solve_tensions(r.state, tension[i], &out);
        const status shaped = rod_shape(r.state, POINTS, s, shape);
        const status strained = rod_strain_at(r.state, 0.03, &xi);
        const long taken = allocations - before;
        CHECK_OK(solved);
        CHECK_OK(shaped);
        CHECK_OK(strained);
        CHECK(taken == 0);
    }
    free_rod(r);
    law_along_free(&law);
}

// twenty tendons, then the same rod under a load, from the last answer and from rest
static void many_tendons_and_loads_allocate_nothing(void)
{
    enum { MANY = 20 };
    const prototype p = helical_nc();
    law_along law = {0};
    prototype_law(&p, &law);
    tendon_spec tendon[MANY];
    double tension[MANY];
    for (int i = 0; i < MANY; i++) {
        tendon[i] = straight_tendon("of many", 3.6e-3, 0.3 * i);
        tension[i] = 0.01 * i;
    }
    tendon[3].angle = (field){.at = quarter_turn};
    const made_rod r = make_rod(&law, MANY, tendon, (rod_options){.tolerance = 1e-6});
    for (int i = 0; i < 6; i++) {
        const rod_request request = {.tension = tension,
                                     .tip_space = {{i % 3 == 2 ? 0.01 : 0}},
                                     .stability = i == 2,
                                     .cold = i < 3};
        rod_solution out = {0};
        vec6 xi;
        const long before = allocations;
        const status solved = rod_solve(r.state, &request, &out);
        const status strained = rod_strain_at(r.state, 0.03, &xi);
        CHECK(allocations == before);
        CHECK_OK(solved);
        CHECK_OK(strained);
    }
    free_rod(r);
    law_along_free(&law);
}

// a batch makes its states: the same for ten rows and for a thousand
static void rows_of_a_batch_allocate_nothing(void)
{
    enum { ROWS = 1000 };
    const prototype p = helical_nc();
    law_along law = {0};
    prototype_law(&p, &law);
    const tendon_spec tendon[2] = {straight_tendon("a", 3.6e-3, 0),
                                   straight_tendon("b", 3.6e-3, 2)};
    static double tension[2 * ROWS];
    static pose tip[ROWS];
    for (int i = 0; i < 2 * ROWS; i++) {
        tension[i] = 1e-3 * (i % 700);
    }
    const made_rod r = make_rod(&law, 2, tendon, (rod_options){.tolerance = 1e-6});
    long taken[2];
    int failed = 0;
    for (int k = 0; k < 2; k++) {
        const long before = allocations;
        CHECK_OK(rod_batch(r.rod, 1, k == 0 ? 10 : ROWS, tension, NULL, tip, NULL, &failed));
        taken[k] = allocations - before;
        CHECK(failed == 0);
    }
    CHECK(taken[0] > 0 && taken[0] == taken[1]);
    free_rod(r);
    law_along_free(&law);
}

// every kind of load, friction and a pulled length; warm and cold, past limit points, with all
// that may be asked afterwards
static void loaded_rods_allocate_nothing(int frame)
{
    enum { POINTS = 13, TENDONS = 2, LOADS = 3 };
    const prototype p = helical_nc();
    law_along law = {0};
    prototype_law(&p, &law);
    for (int i = 0; i < law.npanel * law.nnode; i++) {
        law.law[i].mass = 0.02;
    }
    tendon_spec tendon[TENDONS] = {straight_tendon("rubbing", 3.6e-3, 0),
                                   straight_tendon("pulled", 3.6e-3, 2)};
    tendon[0].friction = 0.1;
    tendon[1].EA = 200;
    const point_load tip = {.s = 0.12, .force = {0, 5e-3, 0}};
    const line_load wind = {.from = 0.02, .force = {field_constant(0.02)}};
    const rod_spec spec = {.law = &law,
                           .ntendon = TENDONS,
                           .npoint_load = 1,
                           .nline_load = 1,
                           .tendons = tendon,
                           .point_loads = &tip,
                           .line_loads = &wind,
                           .gravity = {0, 0, -9.81}};
    rod *r = NULL;
    rod_state *state = NULL;
    CHECK_OK(rod_make(&spec, &(rod_options){.frame = frame, .tolerance = 1e-7}, &r));
    CHECK_OK(rod_state_make(r, &state));

    double tension[TENDONS] = {0.3, 0}, pull[TENDONS] = {NAN, 1e-3}, s[POINTS], found[TENDONS];
    double slope[TENDONS * TENDONS];
    pose shape[POINTS];
    vec6 column[TENDONS], by_pull[TENDONS], by_load[LOADS], wrench;
    mat6 space, body, base;
    const rod_derivatives all = {column, by_pull, by_load, &space, &body, &base, slope};
    rod_request request = {.tension = tension, .tip_body = {{1e-3, 0, 0, 0, 0, 1e-6}}};
    for (int i = 0; i < 6; i++) {
        rod_solution out = {.tension = found};
        request.cold = i == 0 || i == 4;
        request.pull = i % 2 ? pull : NULL;
        request.stability = i > 2;
        request.past = i > 3;
        tension[0] += 0.02;
        const long before = allocations;
        const status solved = rod_solve(state, &request, &out);
        const status derived = rod_derive(state, 0.1, &all);
        const status told = rod_wrench_at(state, 0.03, &wrench, found);
        const status shaped = rod_shape(state, POINTS, s, shape);
        const long taken = allocations - before;
        CHECK_OK(solved);
        CHECK_OK(derived);
        CHECK_OK(told);
        CHECK_OK(shaped);
        CHECK(taken == 0);
    }
    rod_state_free(state);
    rod_free(r);
    law_along_free(&law);
}

int main(void)
{
    start_counting();
    many_tendons_and_loads_allocate_nothing();
    rows_of_a_batch_allocate_nothing();
    solving_allocates_nothing(FRAME_GC);
    solving_allocates_nothing(FRAME_NC);
    loaded_rods_allocate_nothing(FRAME_GC);
    loaded_rods_allocate_nothing(FRAME_NC);
    return test_failures != 0;
}
