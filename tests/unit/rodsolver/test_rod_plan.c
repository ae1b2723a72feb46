// tests/unit/rodsolver/test_rod_plan.c
// What a plan holds before anything is solved: edges, shape at rest, loads at the stations, and how
// large it is.
#include "rodsolver/rod_plan.h"
#include "tests/unit/rodsolver/prototypes.h"

static double growing(const void *expression, double s)
{
    return *(const double *)expression * s;
}

static rod *rod_of(const rod_spec *spec, rod_options options)
{
    rod *r = NULL;
    CHECK_OK(rod_make(spec, &options, &r));
    return r;
}

static rod_solution at_rest(const rod *r)
{
    rod_solution out = {0};
    rod_state *state = NULL;
    CHECK_OK(rod_state_make(r, &state));
    CHECK_OK(rod_solve(state, &(rod_request){0}, &out));
    rod_state_free(state);
    return out;
}

// curvature and twist at rest: a helix in closed form, in both frames, in one exponential where
// nothing varies
static void rest_shape_is_a_helix(void)
{
    const prototype straight = constant_nc(), turning = helical_nc();
    const rest_shape rest = {.curvature_x = field_constant(12), .twist = field_constant(30)};
    const pose wanted = se3_exp((vec6){{0, 0, 0.12, 12 * 0.12, 0, 30 * 0.12}});
    for (int k = 0; k < 4; k++) {
        law_along law = {0};
        prototype_law(k < 2 ? &straight : &turning, &law);
        const rod_spec spec = {.law = &law, .rest = rest};
        rod *r = rod_of(&spec, (rod_options){.frame = k % 2, .tolerance = 1e-12});
        const rod_solution out = at_rest(r);
        CHECK_WITHIN(distance(out.tip.p, wanted.p), 0, 1e-12 * 0.12);
        CHECK_WITHIN(rotation_difference(out.tip.R, wanted.R), 0, 1e-11);
        // without tendons and in the GC frame nothing that matters varies, but the law does
        CHECK(r->plans[0].uniform == (k == 0 || k == 1));
        CHECK(out.energy == 0 && out.residual == 0);
        rod_free(r);
        law_along_free(&law);
    }
}

// the curvature jumps and varies: two frames, one rod; a tendon pulls
static void frames_agree_on_curved_rods(void)
{
    const prototype p = helical_nc();
    const double rate = 200;
    law_along law = {0};
    prototype_law(&p, &law);
    const tendon_spec t[2] = {straight_tendon("a", 3.6e-3, 1), straight_tendon("b", 3.6e-3, 4)};
    const rod_spec spec = {.law = &law,
                           .rest = {.curvature_x = field_constant(-8),
                                    .curvature_y = {.at = growing, .expression = &rate},
                                    .twist = field_constant(15)},
                           .ntendon = 2,
                           .tendons = t};
    const double tau[2] = {0.7, 0.2};
    rod_solution out[2] = {0};
    for (int frame = FRAME_GC; frame <= FRAME_NC; frame++) {
        rod_state *state = NULL;
        rod *r = rod_of(&spec, (rod_options){.frame = frame, .tolerance = 1e-12});
        CHECK_OK(rod_state_make(r, &state));
        CHECK_OK(solve_tensions(state, tau, &out[frame]));
        rod_state_free(state);
        rod_free(r);
    }
    CHECK_WITHIN(distance(out[0].tip.p, out[1].tip.p), 0, 1e-12);
    CHECK_WITHIN(rotation_difference(out[0].tip.R, out[1].tip.R), 0, 1e-11);
    CHECK_NEAR(out[1].energy, out[0].energy, 1e-9);
    law_along_free(&law);
}

static bool is_break(const rod *r, double s)
{
    for (int i = 0; i < r->nbreak; i++) {
        if (fabs(r->breaks[i] - s) < 1e-15) {
            return true;
        }
    }
    return false;
}

static void loads_and_breaks_are_edges(void)
{
    const prototype p = helical_nc();
    law_along law = {0};
    prototype_law(&p, &law);
    const point_load points[3] = {
        {.s = 0.031, .force = {1, 0, 0}}, {.s = 1, .moment = {0, 0, 1}}, {.s = 0}};
    const line_load lines[2] = {{.from = 0.02, .to = 0.07, .force = {[1] = {.value = 3}}},
                                {.to = 0}};
    const double breaks[2] = {0.09, 0.055};
    const rod_spec spec = {.law = &law,
                           .npoint_load = 3,
                           .point_loads = points,
                           .nline_load = 2,
                           .line_loads = lines,
                           .nbreak = 2,
                           .breaks = breaks};
    rod *r = rod_of(&spec, (rod_options){.npanel = 8});
    const double wanted[7] = {0, 0.02, 0.031, 0.055, 0.07, 0.09, 0.12};
    CHECK(r->nbreak == 7 && rod_load_count(r) == 5);
    for (int i = 0; i < 7; i++) {
        CHECK(is_break(r, wanted[i]));
    }
    const plan *q = &r->plans[0];
    CHECK_NEAR(q->pair_edge[2 * (q->point_panel[0] / 2) + 1], 0.031, 1e-15);
    CHECK(q->point_panel[0] % 2 == 1);
    CHECK(q->point_panel[1] == 2 * q->npair - 1 && q->point_panel[2] == -1);
    CHECK(r->acts[0] && r->acts[1] && !r->acts[2] && r->acts[3] && !r->acts[4]);
    for (int i = 0; i < q->nstation; i++) {
        CHECK(q->line[0][i].force.a[1] == (q->s[i] > 0.02 && q->s[i] < 0.07 ? 3 : 0));
    }
    rod_free(r);
    law_along_free(&law);
}

// the same force of a body load and the same weight, seen from both frames
static void loads_turn_with_the_frame(void)
{
    const prototype p = helical_nc();
    law_along law = {0};
    prototype_law(&p, &law);
    for (int i = 0; i < law.nnode; i++) {
        law.law[i].mass = 0.02;
        law.law[i].mass_centre[0] = 1e-3;
    }
    const line_load line = {.frame = LOAD_BODY,
                            .force = {{.value = 1}, {.value = 2}, {.value = 3}},
                            .moment = {{.value = 0.1}},
                            .place = {{.value = 2e-3}, {.value = -1e-3}}};
    const rod_spec spec = {
        .law = &law, .nline_load = 1, .line_loads = &line, .gravity = {0, -9.81, 0}};
    rod *gc = rod_of(&spec, (rod_options){.npanel = 8});
    rod *nc = rod_of(&spec, (rod_options){.npanel = 8, .frame = FRAME_NC});
    const plan *g = &gc->plans[0], *n = &nc->plans[0];
    CHECK(rod_load_count(gc) == 2);
    for (int i = 0; i < g->nstation; i++) {
        const pose T = centre_frame_pose(&n->frame[i]);
        const line_station *a = &g->line[0][i], *b = &n->line[0][i];
        CHECK_WITHIN(distance(mat3_mul_vec(T.R, b->force), a->force), 0, 1e-14);
        CHECK_WITHIN(distance(mat3_mul_vec(T.R, b->moment), a->moment), 0, 1e-15);
        const vec3 place = vec3_add(T.p, mat3_mul_vec(T.R, (vec3){{b->x, b->y, 0}}));
        CHECK_WITHIN(distance(place, (vec3){{a->x, a->y, 0}}), 0, 1e-17);
        // weight stays in the world, at the mass' centre, which turns with the pattern
        const line_station *w = &g->line[1][i], *v = &n->line[1][i];
        CHECK_NEAR(w->force.a[1], -0.02 * 9.81, 1e-14);
        CHECK_WITHIN(distance(w->force, v->force), 0, 1e-16);
        CHECK_NEAR(w->x, 1e-3 * cos(PROTOTYPE_PI * g->s[i] / 0.12), 1e-11);
        const vec3 centre = vec3_add(T.p, mat3_mul_vec(T.R, (vec3){{v->x, v->y, 0}}));
        CHECK_WITHIN(distance(centre, (vec3){{w->x, w->y, 0}}), 0, 1e-17);
    }
    rod_free(gc);
    rod_free(nc);
    law_along_free(&law);
}

static void node_frames_are_those_of_the_law(void)
{
    const prototype p = helical_nc();
    law_along law = {0};
    prototype_law(&p, &law);
    const rod_spec spec = {.law = &law};
    rod *r = rod_of(&spec, (rod_options){.npanel = 10, .frame = FRAME_NC});
    const plan *q = &r->plans[0];
    CHECK(q->npair == 5);
    for (int k = 0; k <= 10; k++) {
        const double s = 0.012 * k;
        CHECK_WITHIN(fabs(remainder(q->node_frame[k].phi - PROTOTYPE_PI * s / 0.12, PROTOTYPE_PI)),
                     0, 1e-9);
        const double width = PROTOTYPE_PI / 4 - PROTOTYPE_PI / 8 * s / 0.12;
        const double *c = q->node_frame[k].p;
        CHECK_NEAR(hypot(c[0], c[1]), prototype_integrals(&p, width).x, 1e-9);
    }
    rod_free(r);
    law_along_free(&law);
}

static void plans_are_small(void)
{
    const prototype p = helical_nc();
    law_along law = {0};
    prototype_law(&p, &law);
    const tendon_spec t[3] = {straight_tendon("a", 3.6e-3, 0), straight_tendon("b", 3.6e-3, 2),
                              straight_tendon("c", 3.6e-3, 4)};
    const rod_spec spec = {.law = &law, .ntendon = 3, .tendons = t};
    for (int frame = FRAME_GC; frame <= FRAME_NC; frame++) {
        rod *r = rod_of(&spec, (rod_options){.npanel = 22, .frame = frame});
        CHECK(r->plans[0].nstation == 66);
        CHECK(rod_plan_bytes(r, 64) < 100000);
        CHECK(rod_plan_bytes(r, 64) > 66 * (36 + 6 + 1 + 3 * (4 + SECULAR_ROWS)) * sizeof(double));
        rod_free(r);
    }
    law_along_free(&law);
}

static void bad_specs_are_refused(void)
{
    const prototype p = homogeneous_tube();
    law_along law = {0};
    prototype_law(&p, &law);
    const double outside = 0.2;
    const point_load before = {.s = -0.01}, endless = {.force = {INFINITY}};
    const line_load backwards = {.from = 0.1, .to = 0.05}, nowhere = {.force = {{.value = NAN}}};
    const rod_spec specs[7] = {
        {.law = &law, .nbreak = 1, .breaks = &outside},
        {.law = &law, .npoint_load = 1, .point_loads = &before},
        {.law = &law, .npoint_load = 1, .point_loads = &endless},
        {.law = &law, .nline_load = 1, .line_loads = &backwards},
        {.law = &law, .nline_load = 1, .line_loads = &nowhere},
        {.law = &law, .rest = {.twist = field_constant(NAN)}},
        {.law = &law, .gravity = {0, NAN, 0}},
    };
    for (int i = 0; i < 7; i++) {
        rod *r = NULL;
        CHECK(rod_make(&specs[i], &(rod_options){.tolerance = 1e-9}, &r) == ERR_INPUT);
        CHECK(r == NULL);
        rod_free(r);
        status_clear();
    }
    law_along_free(&law);
}

// the stiffness centre moves over at once in the middle: no curve goes through it
static void jumps_of_the_frame_are_refused(void)
{
    const prototype p = constant_nc();
    law_along whole = {0}, law = {0};
    prototype_law(&p, &whole);
    CHECK_OK(law_along_make(0.12, 2, 1, &law));
    law.law[0] = whole.law[0];
    law.law[1] = whole.law[0];
    const rod_spec spec = {.law = &law};
    const rod_options options = {.frame = FRAME_NC, .tolerance = 1e-9};
    rod_free(rod_of(&spec, options));
    for (int i = 0; i < 6; i++) {
        law.law[1].K.a[i][4] *= i == 4 ? 1 : 0.5;
        law.law[1].K.a[4][i] *= i == 4 ? 1 : 0.5;
    }
    rod *r = NULL;
    CHECK(rod_make(&spec, &options, &r) == ERR_INPUT);
    CHECK(r == NULL);
    status_clear();
    rod_free(rod_of(&spec, (rod_options){.tolerance = 1e-9}));
    law_along_free(&law);
    law_along_free(&whole);
}

int main(void)
{
    rest_shape_is_a_helix();
    frames_agree_on_curved_rods();
    loads_and_breaks_are_edges();
    loads_turn_with_the_frame();
    node_frames_are_those_of_the_law();
    plans_are_small();
    bad_specs_are_refused();
    jumps_of_the_frame_are_refused();
    return test_failures != 0;
}
