// tests/verify/app/verify_bodies.c
// Bodies that follow the section along the rod, solved: against an independent 3D code, closed
// forms and one another.
#include "tests/unit/app/stack_files.h"
#include "tests/verify/app/solved_body.h"

// An independent code's tip compliance, good to 2e-5: mm, N, rad.
static const mat6 H120 = {{
    {4524.370002339337, -708.0399020012336, 40.11089147277404, 5.859751773948503, 59.83647363340619,
     2.347238777579812},
    {-708.0399020012336, 4817.17956630691, 60.685065665430045, -57.88395100263348,
     -5.2922530336707805, 1.6546701579959064},
    {40.11089147277404, 60.685065665430045, 7.101668832756489, -0.9995435651613662,
     0.030188406830251528, -0.1276170426942785},
    {5.859751773948503, -57.88395100263348, -0.9995435651613662, 1.006645297822918,
     -0.01684495098617085, -0.03718798090070899},
    {59.83647363340619, -5.2922530336707805, 0.030188406830251528, -0.01684495098617085,
     1.016768748722489, -0.001991837743348555},
    {2.347238777579812, 1.6546701579959064, -0.1276170426942785, -0.03718798090070899,
     -0.001991837743348555, 1.7507230094507946},
}};

static mat6 in_metres(mat6 C)
{
    for (int i = 0; i < 36; i++) {
        C.a[i / 6][i % 6] *= (i / 6 < 3 ? 1e-3 : 1) * (i % 6 < 3 ? 1 : 1e3);
    }
    return C;
}

static const char helical[] =
    "  shapes:\n"
    "    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3.2}, material: soft}\n"
    "    - {sector: {outer_radius_mm: 4, inner_radius_mm: 3.2, mid_angle_rad: pi*s/L, width_rad: "
    "pi/4 - (pi/8)*(s/L)}, material: stiff}\n";

static void the_helical_robot_agrees_with_an_independent_code(void)
{
    solved s;
    const segment_mesh ask = {.order = 3, .size = 0.8e-3};
    solve(helical, "fem: {length_mm: 120, loads: []}\n", ask, 24, 30, &s);
    const double error = mat6_relative_error(s.C, in_metres(H120));
    printf("H120: %d nodes x %d levels, %lld dofs, %.1f s: %.2e\n", s.m.plane.nnode,
           s.m.body.nlevel, s.run.dofs,
           s.run.assemble_seconds + s.run.factor_seconds + s.run.solve_seconds, error);
    CHECK_BELOW(error, 2e-4); // the wanted one; 7e-5 is measured
    done_with(&s);
}

// one way by the rate, the other by nodes that are moved level by level
static void turning_by_shape_answers_as_turning_by_rate(void)
{
    const char shapes[] = "  shapes:\n    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3.2}, "
                          "material: soft}\n    - {sector: {outer_radius_mm: 4, inner_radius_mm: "
                          "3.2, mid_angle_rad: 1, width_rad: pi/4}, material: stiff}\n";
    char turning[600];
    (void)snprintf(turning, sizeof turning, "%s  turn_rad: 2*pi*s/0.03\n", shapes);
    const segment_mesh ask = {.order = 2, .size = 1.6e-3};
    solved a, b;
    solve(turning, "fem: {length_mm: 30, loads: []}\n", ask, 16, 4, &a);
    solve(shapes,
          "rod: {length_mm: 30, rest: {twist_rad_per_m: 2*pi/0.03 + 0*s}}\n"
          "fem: {length_mm: 30, loads: []}\n",
          ask, 16, 4, &b);
    CHECK(!a.m.spec.shape.place);
    CHECK_ABOVE(a.m.spec.turn_rate, 200);
    CHECK(b.m.spec.shape.place);
    const double apart = mat6_relative_error(a.C, b.C);
    printf("turning 2 pi per 30 mm, by rate and by shape: %.1e apart\n", apart);
    CHECK_BELOW(apart, 1e-9); // the solver's residual times the body's condition
    done_with(&a);
    done_with(&b);
}

// int ds / EA of a cone's wall, for walls whose slopes squared are below the tolerance
static void a_tapered_tube_stretches_as_it_should(void)
{
    const char shapes[] = "  shapes:\n    - {annulus: {outer_radius_mm: 4 - 0.01*s, "
                          "inner_radius_mm: 3}, material: plain}\n";
    const segment_mesh ask = {.order = 3, .size = 0};
    solved s;
    solve(shapes, "fem: {length_mm: 40, loads: []}\n", ask, 10, 4, &s);
    // int ds / (pi E (r^2 - c^2)), r = a - k s: ln((r - c) / (r + c)) / (2 c k pi E) from tip to
    // base
    const double E = 1e6, a = 4e-3, b = 3.6e-3, c = 3e-3, k = 0.01;
    const double wanted = (log((a - c) / (a + c)) - log((b - c) / (b + c))) / (2 * c * k * PI * E);
    printf("tapered tube: %.8g m/N, %.8g by int ds / EA\n", s.C.a[2][2], wanted);
    CHECK_NEAR(s.C.a[2][2], wanted, 1e-4);
    done_with(&s);
}

// Golovin's curved bar under a moment: rotation 8 M (b^2 - a^2) angle / (E N), N = (b^2 - a^2)^2 -
// (2 a b ln(b / a))^2 per thickness; Timoshenko and Goodier, Theory of Elasticity, section 29
static void a_quarter_ring_bends_as_a_curved_bar(void)
{
    const char shapes[] = "  shapes:\n    - {rectangle: {width_mm: 4, height_mm: 1}, material: "
                          "plain}\n";
    const segment_mesh ask = {.order = 3, .size = 1e-3};
    solved s, half;
    solve(shapes,
          "rod: {length_mm: 5*pi, rest: {curvature_y_per_m: 100}}\n"
          "fem: {length_mm: 5*pi, loads: []}\n",
          ask, 12, 4, &s);
    solve(shapes,
          "rod: {length_mm: 10*pi, rest: {curvature_y_per_m: 100}}\n"
          "fem: {length_mm: 10*pi, loads: []}\n",
          ask, 16, 4, &half);
    const double E = 1e6, t = 1e-3, a = 8e-3, b = 12e-3;
    const double N = pow(b * b - a * a, 2) - pow(2 * a * b * log(b / a), 2);
    const double wanted = 8 * (b * b - a * a) * PI / 2 / (E * t * N);
    const double straight = 5e-3 * PI / (E * t * pow(b - a, 3) / 12);
    // half a ring less a quarter: its ends, which are held plane, fall out
    const double quarter = half.C.a[4][4] - s.C.a[4][4];
    printf(
        "quarter ring, depth 0.4 of its radius: %.7g rad/Nm, Golovin %.7g, a straight bar %.7g\n",
        quarter, wanted, straight);
    CHECK_NEAR(quarter, wanted, 1e-5);
    done_with(&half);
    // forces and motions are about the same places: symmetric
    for (int i = 0; i < 36; i++) {
        const double scale = sqrt(s.C.a[i / 6][i / 6] * s.C.a[i % 6][i % 6]);
        CHECK_WITHIN(s.C.a[i / 6][i % 6], s.C.a[i % 6][i / 6], 1e-9 * scale);
    }
    done_with(&s);
}

// squares of a stack of equal slices are the quads of the rectangles they show; what is cut out
// only yields
static void voxels_answer_as_what_they_show(void)
{
    const slice_kind whole[SLICES] = {PLAIN, PLAIN, PLAIN, PLAIN},
                     cut[SLICES] = {PLAIN, CUT, CUT, PLAIN};
    const stack s[2] = {write_stack(whole), write_stack(cut)};
    const char shapes[] =
        "  mesh: {kind: mapped}\n  shapes:\n    - {rectangle: {width_mm: 6, "
        "height_mm: 6}, material: soft}\n    - {rectangle: {width_mm: 1, height_mm: "
        "1, centre_x_mm: -2.5, centre_y_mm: -2.5}, material: stiff}\n";
    const segment_mesh ask = {.order = 1, .size = 0.5e-3};
    solved drawn, voxel, notched;
    solve(shapes, "fem: {length_mm: 8, loads: []}\n", ask, 16, 1, &drawn);
    solve(s[0].text, "fem: {length_mm: 8, layers: 16, loads: []}\n", ask, 1, 1, &voxel);
    solve(s[1].text, "fem: {length_mm: 8, layers: 16, loads: []}\n", ask, 1, 1, &notched);
    CHECK(voxel.m.body.nlayer == 16 && voxel.m.plane.nnode == drawn.m.plane.nnode);
    const double apart = mat6_relative_error(voxel.C, drawn.C);
    printf("voxels and the same shapes: %.1e apart; notched %.3g times as soft in stretch\n", apart,
           notched.C.a[2][2] / voxel.C.a[2][2]);
    CHECK_BELOW(apart, 1e-10);
    mat6 more = mat6_add(notched.C, mat6_scale(-1, voxel.C)), lower;
    CHECK(mat6_cholesky(mat6_symmetric(more), &lower));
    for (int i = 0; i < 36; i++) {
        const mat6 C = notched.C;
        CHECK_WITHIN(C.a[i / 6][i % 6], C.a[i % 6][i / 6],
                     1e-10 * sqrt(C.a[i / 6][i / 6] * C.a[i % 6][i % 6]));
    }
    done_with(&drawn);
    done_with(&voxel);
    done_with(&notched);
    remove_stack(&s[0]);
    remove_stack(&s[1]);
}

int main(void)
{
    against(BY_OTHER_CODE,
            "3D FEM of an independent code: curved high-order hexahedra, direct solver");
    the_helical_robot_agrees_with_an_independent_code();
    against(BY_SECOND_WAY, "the same turn by rate and by shape");
    turning_by_shape_answers_as_turning_by_rate();
    against(BY_CLOSED_FORM, "int ds / EA of a cone; Golovin's curved bar (Timoshenko and Goodier, "
                            "Theory of Elasticity, section 29)");
    a_tapered_tube_stretches_as_it_should();
    a_quarter_ring_bends_as_a_curved_bar();
    against(BY_SECOND_WAY, "the same body drawn as rectangles");
    voxels_answer_as_what_they_show();
    return test_failures != 0;
}
