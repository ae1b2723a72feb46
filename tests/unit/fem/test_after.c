// tests/unit/fem/test_after.c
// Runs made up from a beam whose law is known: what is found in them must be that law.
#include "base/memory.h"
#include "fem/after.h"
#include "fem/after_line.h"
#include "tests/test.h"

#include <string.h>

static const double LENGTH = 0.8, RULE_TOLERANCE = 1e-11;
enum { RULE = 24 };

// --- a plate of two squares, the right one three times as stiff: EA = 4, centroid x = 1/4

static const material materials[2] = {{.E = 1, .nu = 0.3}, {.E = 3, .nu = 0.1}};

static void two_squares(mesh *m)
{
    const shape quad = SHAPE_QUAD;
    const int two = 2, conn[2][4] = {{0, 1, 3, 4}, {1, 2, 4, 5}};
    CHECK_OK(mesh_make(1, 6, 1, &quad, &two, m));
    for (int i = 0; i < 6; i++) {
        m->xyz[3 * i] = i % 3 - 1;
        m->xyz[3 * i + 1] = i / 3 - 0.5;
    }
    for (int i = 0; i < 8; i++) {
        m->block[0].conn[i] = conn[i / 4][i % 4];
        m->block[0].material[i / 4] = i / 4;
    }
}

// --- the beam: F in the section's axes, which turn at a rate

typedef struct beam {
    mat6 F;
    double rate, length;
} beam;

static mat6 some_compliance(void)
{
    mat6 F = {0};
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            F.a[i][j] = 0.1 * sin(3.0 * (i + j) + i * j);
        }
    }
    F = mat6_symmetric(F);
    for (int i = 0; i < 6; i++) {
        F.a[i][i] = 1 + 0.3 * i;
    }
    return F;
}

static vec6 turned(mat3 R, vec6 w)
{
    const vec3 n = mat3_mul_vec(R, vec6_linear(w)), m = mat3_mul_vec(R, vec6_angular(w));
    return (vec6){{n.a[0], n.a[1], n.a[2], m.a[0], m.a[1], m.a[2]}};
}

static vec6 wrench_at(double from, vec6 w, double s)
{
    return wrench_about(w, (vec3){{0, 0, from}}, (vec3){{0, 0, s}});
}

// strain in the base's axes for a wrench on the tip
static vec6 strain_at(const beam *b, vec6 tip, double s)
{
    const mat3 A = mat3_rot_z(b->rate * s);
    return turned(A, mat6_mul_vec(b->F, turned(mat3_transpose(A), wrench_at(b->length, tip, s))));
}

static vec3 rotation_at(const beam *b, vec6 tip, double s)
{
    double x[RULE], g[RULE];
    vec3 q = {0};
    gauss_legendre(RULE, x, g);
    for (int k = 0; k < RULE; k++) {
        const vec6 e = strain_at(b, tip, s * (1 + x[k]) / 2);
        q = vec3_add_scaled(q, g[k] * s / 2, vec6_angular(e));
    }
    return q;
}

// t' = v - e_z x q
static vec6 motion_at(const beam *b, vec6 tip, double s)
{
    double x[RULE], g[RULE];
    const vec3 q = rotation_at(b, tip, s);
    vec3 t = {0};
    gauss_legendre(RULE, x, g);
    for (int k = 0; k < RULE; k++) {
        const double at = s * (1 + x[k]) / 2;
        const vec3 r = rotation_at(b, tip, at), v = vec6_linear(strain_at(b, tip, at));
        t = vec3_add_scaled(t, g[k] * s / 2, vec3_sub(v, vec3_cross((vec3){{0, 0, 1}}, r)));
    }
    return (vec6){{t.a[0], t.a[1], t.a[2], q.a[0], q.a[1], q.a[2]}};
}

static vec6 unit(int j)
{
    vec6 w = {0};
    w.a[j] = 1;
    return w;
}

static mat6 window_energy(const beam *b, double centre, double half)
{
    double x[RULE], g[RULE];
    mat6 U = {0};
    gauss_legendre(RULE, x, g);
    for (int k = 0; k < RULE; k++) {
        const double s = centre + half * x[k];
        const mat3 back = mat3_rot_z(-b->rate * s);
        for (int i = 0; i < 6; i++) {
            const vec6 wi = turned(back, wrench_at(centre, unit(i), s));
            for (int j = 0; j < 6; j++) {
                const vec6 wj = turned(back, wrench_at(centre, unit(j), s));
                U.a[i][j] += g[k] * half * vec6_dot(wi, mat6_mul_vec(b->F, wj));
            }
        }
    }
    return U;
}

// --- the run that such a beam would give

typedef struct made {
    mesh plane;
    double *layer;
    body body;
    segment_problem problem;
    way_wants wants;
    way_run run;
    after after;
} made;

static void made_free(made *m)
{
    after_free(&m->after);
    body_free(&m->body);
    mesh_free(&m->plane);
    free(m->layer);
    free(m->run.z);
    free(m->run.motion);
    free(m->run.resultant);
    free(m->run.work);
}

static void make_body(made *m, const beam *b, int order, int nlayer, double length)
{
    two_squares(&m->plane);
    CHECK_OK(TAKE(m->layer, (size_t)nlayer + 1));
    for (int i = 0; i <= nlayer; i++) { // not all of one height
        const double t = (double)i / nlayer;
        m->layer[i] = length * (t + 0.3 * t * (1 - t));
    }
    const body_spec spec = {.plane = &m->plane,
                            .materials = materials,
                            .order = order,
                            .nlayer = nlayer,
                            .layer = m->layer,
                            .turn_rate = b->rate};
    CHECK_OK(body_make(&spec, &m->body));
}

// ncut 0: at the body's levels
static void make_run(made *m, const beam *b, int ncut)
{
    way_run *r = &m->run;
    *r = (way_run){.ncolumn = 6, .nlevel = ncut ? ncut : m->body.nlevel};
    const size_t n = (size_t)r->nlevel;
    CHECK_OK(TAKE(r->z, n));
    CHECK_OK(TAKE(r->motion, 6 * n));
    CHECK_OK(TAKE(r->resultant, 6 * n));
    CHECK_OK(TAKE(r->work, 36));
    for (int i = 0; i < r->nlevel; i++) {
        const double t = (double)i / (r->nlevel - 1);
        r->z[i] = ncut ? b->length * t * t * (3 - 2 * t) : m->body.level[i];
    }
    for (int j = 0; j < 6; j++) {
        for (int i = 0; i < r->nlevel; i++) {
            r->motion[j * r->nlevel + i] = motion_at(b, unit(j), r->z[i]);
            r->resultant[j * r->nlevel + i] = wrench_at(b->length, unit(j), r->z[i]);
        }
        for (int i = 0; i < 6; i++) {
            r->work[6 * i + j] = r->motion[(j + 1) * r->nlevel - 1].a[i];
        }
    }
    m->wants = (way_wants){.middle = b->length / 2, .middle_half = b->length / 8};
    r->energy = window_energy(b, m->wants.middle, m->wants.middle_half);
}

static void make(made *m, const beam *b, int order, int nlayer, int ncut)
{
    *m = (made){0};
    make_body(m, b, order, nlayer, b->length);
    make_run(m, b, ncut);
    m->problem = (segment_problem){.body = &m->body, .base = BASE_CLAMPED, .tip = TIP_RIGID};
    CHECK_OK(after_make(&m->problem, &m->run, &m->wants, &m->after));
}

static void check_mat6(mat6 found, mat6 wanted, double tolerance)
{
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            CHECK_WITHIN(found.a[i][j], wanted.a[i][j], tolerance);
        }
    }
}

// --- slopes

static vec6 power(double z, int degree)
{
    return (vec6){{pow(z, degree), 1, -z}};
}

// a polynomial of one degree more than the layers hold keeps its slope, and of any up to four
// through cuts
static void slopes_of_polynomials_are_exact(void)
{
    enum { LAYERS = 6 };
    for (int p = 0; p <= 4; p++) {
        const int n = p ? LAYERS * p + 1 : 17, degree = p ? p + 1 : 4;
        double z[32], node[ELEMENT_MAX_ORDER + 1] = {0};
        vec6 f[32], slope[32];
        if (p) {
            gauss_lobatto_nodes(p + 1, node);
        }
        for (int i = 0; i < n; i++) {
            const int layer = p ? (i < n - 1 ? i / p : LAYERS - 1) : i;
            const double a = layer * layer + 1.0, h = 2 * layer + 1.0;
            z[i] = p ? a + h * (node[i - layer * p] + 1) / 2 : a;
            z[i] *= p ? 0.05 : 0.01;
            f[i] = power(z[i], degree);
        }
        const after_line line = {.n = n, .z = z, .order = p};
        CHECK_OK(line_slopes(&line, f, slope));
        for (int i = 0; i < n; i++) {
            // for layers the values are a polynomial's that they do not hold: its interpolant's
            // slope is right at the Gauss points
            CHECK_NEAR(slope[i].a[0], degree * pow(z[i], degree - 1), 1e-10);
            CHECK_WITHIN(slope[i].a[1], 0, 1e-11);
            CHECK_NEAR(slope[i].a[2], -1, 1e-11);
        }
        // least squares of a straight line: its own slope
        const vec6 mean = line_mean_slope(&line, f, 0.8, 0.4);
        CHECK_WITHIN(mean.a[1], 0, 1e-12);
        CHECK_NEAR(mean.a[2], -1, 1e-12);
    }
}

// --- the law

static void the_law_comes_back(void)
{
    const beam beams[2] = {{some_compliance(), 0, LENGTH}, {some_compliance(), 4, LENGTH}};
    for (int k = 0; k < 2; k++) {
        for (int cuts = 0; cuts < 2; cuts++) {
            made m;
            beam_law law = {0};
            mat6 K, F;
            make(&m, &beams[k], 3, 4, cuts ? 33 : 0);
            check_mat6(m.after.F, beams[k].F, 1e-12);
            CHECK_OK(after_middle(&m.after, &law));
            CHECK_NEAR(law.area, 2, 1e-13);
            // in the base's axes: turned with the middle
            CHECK(mat6_inverse_spd(law.K, &F));
            CHECK(mat6_inverse_spd(beams[k].F, &K));
            const vec6 w = {{1, 2, 3, 4, 5, 6}};
            const mat3 A = mat3_rot_z(beams[k].rate * LENGTH / 2);
            const vec6 e = turned(A, mat6_mul_vec(beams[k].F, turned(mat3_transpose(A), w)));
            for (int i = 0; i < 6; i++) {
                CHECK_NEAR(mat6_mul_vec(F, w).a[i], e.a[i], 1e-11);
            }
            made_free(&m);
        }
    }
}

static void no_ends_take_no_length(void)
{
    const beam beams[2] = {{some_compliance(), 0, LENGTH}, {some_compliance(), 4, LENGTH}};
    for (int k = 0; k < 2; k++) {
        made m;
        double length[6];
        make(&m, &beams[k], 3, 4, 0);
        CHECK_OK(after_end_length(&m.after, length));
        for (int i = 0; i < 6; i++) {
            CHECK_WITHIN(length[i], 0, RULE_TOLERANCE);
        }
        made_free(&m);
    }
}

// the tip of a beam that is shorter by `less`, as seen through rigid ends
static void ends_take_what_was_cut_off(void)
{
    const double less = 0.13;
    beam b = {.length = LENGTH};
    made m;
    double length[6];
    mat6 C = {0};
    for (int i = 0; i < 6; i++) {
        b.F.a[i][i] = 1 + 0.3 * i;
    }
    make(&m, &b, 3, 4, 0);
    const mat6 mid = window_energy(&b, LENGTH / 2, (LENGTH - less) / 2);
    for (int j = 0; j < 6; j++) { // wrench at the tip -> at the middle -> motion -> at the tip
        const vec6 w = wrench_at(LENGTH, unit(j), LENGTH / 2), q = mat6_mul_vec(mid, w);
        const vec3 t =
            vec3_add(vec6_linear(q), vec3_cross(vec6_angular(q), (vec3){{0, 0, LENGTH / 2}}));
        for (int i = 0; i < 3; i++) {
            C.a[i][j] = t.a[i];
            C.a[3 + i][j] = q.a[3 + i];
        }
    }
    m.after.compliance = C;
    CHECK_OK(after_end_length(&m.after, length));
    for (int i = 0; i < 6; i++) {
        CHECK_NEAR(length[i], less, RULE_TOLERANCE);
    }
    made_free(&m);
}

// an axial force through the centre of F's own bending leaves the middle uncurved, and without ends
// the tip unturned
static void centres_are_where_bending_ends(void)
{
    const beam b = {some_compliance(), 0, LENGTH};
    made m;
    double middle[2], tip[2];
    make(&m, &b, 3, 4, 0);
    CHECK_OK(after_centre(&m.after, middle));
    CHECK_OK(after_tip_centre(&m.after, tip));
    const vec6 w = {{0, 0, 1, middle[1], -middle[0], 0}}, e = mat6_mul_vec(b.F, w);
    CHECK_WITHIN(e.a[3], 0, RULE_TOLERANCE);
    CHECK_WITHIN(e.a[4], 0, RULE_TOLERANCE);
    CHECK_NEAR(tip[0], middle[0], 1e-10);
    CHECK_NEAR(tip[1], middle[1], 1e-10);
    made_free(&m);
}

// --- loads

static const double no_spring[6];

static after_ask plain(const segment_load *load, const double *point)
{
    return (after_ask){
        .load = load, .point = point, .tip_spring = no_spring, .column = -1, .uniform = -1};
}

static void load_free(segment_load_result *r)
{
    free(r->slice);
    free(r->displacement);
    *r = (segment_load_result){0};
}

static void a_slice_strains_as_its_wrench_wants(void)
{
    const beam beams[2] = {{some_compliance(), 0, LENGTH}, {some_compliance(), 2, LENGTH}};
    for (int k = 0; k < 2; k++) {
        const segment_load load = {.name = "some", .force = {1, -2, 3}, .moment = {0.5, 0.1, 2}};
        const double point[2] = {0.3, -0.2};
        const after_ask ask = plain(&load, point);
        made m;
        segment_load_result r = {0};
        make(&m, &beams[k], 3, 8, 0);
        CHECK_OK(after_load(&m.after, &ask, &r));
        const vec6 tip = {{1, -2, 3, 0.5 - 0.2 * 3, 0.1 - 0.3 * 3, 2 + 0.3 * -2 + 0.2 * 1}};
        CHECK(r.nslice == m.body.nlevel);
        for (int i = 0; i < r.nslice; i++) {
            const vec6 e = strain_at(&beams[k], tip, r.slice[i].s);
            for (int d = 0; d < 6; d++) { // cubics are what layers of order 3 hold
                CHECK_WITHIN(r.slice[i].strain.a[d], e.a[d], k ? 1e-3 : 1e-11);
                CHECK_WITHIN(r.slice[i].load.a[d], wrench_at(LENGTH, tip, r.slice[i].s).a[d],
                             1e-13);
            }
        }
        CHECK_WITHIN(r.balance, 0, 1e-14);
        const vec6 q = motion_at(&beams[k], tip, LENGTH);
        CHECK_NEAR(r.tip_displacement[0], q.a[0], 1e-11);
        CHECK_NEAR(r.tip_rotation[2], q.a[5], 1e-11);
        CHECK_NEAR(2 * r.strain_energy, vec6_dot(q, tip), 1e-11);
        // E is 1 on the left square and 3 on the right one, whose middles are at -+ 1/2; the tip
        // has turned with the pattern
        const mat3 A = mat3_rot_z(beams[k].rate * LENGTH);
        const vec3 c = mat3_mul_vec(A, (vec3){{0.25, 0, 0}});
        CHECK_NEAR(r.shortening, -(q.a[2] + q.a[3] * c.a[1] - q.a[4] * c.a[0]), 1e-11);
        load_free(&r);
        made_free(&m);
    }
}

// curvature that a pure moment makes is the same everywhere
static void a_moment_bends_the_middle_by_F(void)
{
    const beam b = {some_compliance(), 0, LENGTH};
    const segment_load load = {.name = "moment", .moment = {0, 1, 0}};
    const double point[2] = {0, 0};
    const after_ask ask = plain(&load, point);
    made m;
    segment_load_result r = {0};
    make(&m, &b, 2, 6, 0);
    CHECK_OK(after_load(&m.after, &ask, &r));
    CHECK_NEAR(r.mid_curvature[0], b.F.a[MX][MY], 1e-11);
    CHECK_NEAR(r.mid_curvature[1], b.F.a[MY][MY], 1e-11);
    load_free(&r);
    made_free(&m);
}

static void a_miss_of_one_slice_is_told(void)
{
    const beam b = {some_compliance(), 0, LENGTH};
    const segment_load load = {.name = "pull", .force = {0, 0, 2}};
    const double point[2] = {0, 0};
    const after_ask ask = plain(&load, point);
    made m;
    segment_load_result r = {0};
    make(&m, &b, 2, 6, 0);
    m.run.resultant[2 * m.run.nlevel + 5].a[NZ] += 1e-3;
    CHECK_OK(after_load(&m.after, &ask, &r));
    CHECK_NEAR(r.balance, 1e-3, 1e-11);
    load_free(&r);
    made_free(&m);
}

// a spring takes of a force on the tip what its stiffness makes of the motion
static void a_spring_at_the_tip_takes_its_share(void)
{
    beam b = {.length = LENGTH};
    for (int i = 0; i < 6; i++) {
        b.F.a[i][i] = 1;
    }
    const segment_load load = {.name = "pull", .force = {0, 0, 2}};
    const double point[2] = {0, 0}, spring[6] = {0, 0, 5, 0, 0, 0};
    after_ask ask = plain(&load, point);
    ask.tip_spring = spring;
    made m;
    segment_load_result r = {0};
    make(&m, &b, 2, 6, 0);
    CHECK_OK(after_load(&m.after, &ask, &r));
    const double u = 2 / (1 / LENGTH + 5); // the bar and the spring side by side
    CHECK_NEAR(r.tip_displacement[2], u, 1e-12);
    CHECK_NEAR(r.slice[0].load.a[NZ], u / LENGTH, 1e-12);
    CHECK_NEAR(r.force[2], 2, 1e-15);
    load_free(&r);
    made_free(&m);
}

static void an_imposed_motion_is_met_and_its_reaction_told(void)
{
    const beam b = {some_compliance(), 0, LENGTH};
    double shift[3] = {NAN, 0.02, NAN}, turn[3] = {0.01, NAN, NAN};
    const segment_load load = {.name = "moved",
                               .force = {1, 0, -1},
                               .moment = {0, 3, 0},
                               .tip_motion = {.translation = {.nrow = 1, .ncol = 3, .a = shift},
                                              .rotation = {.nrow = 1, .ncol = 3, .a = turn}}};
    const double point[2] = {0, 0}, spring[6] = {0, 0, 2, 0, 0, 1};
    after_ask ask = plain(&load, point);
    ask.tip_spring = spring;
    made m;
    segment_load_result r = {0};
    make(&m, &b, 2, 6, 0);
    CHECK_OK(after_load(&m.after, &ask, &r));
    CHECK_NEAR(r.tip_displacement[1], 0.02, 1e-11);
    CHECK_NEAR(r.tip_rotation[0], 0.01, 1e-11);
    CHECK_NEAR(r.force[0], 1, 1e-12); // where it is free the load is what it was
    CHECK_NEAR(r.force[2], -1, 1e-12);
    CHECK_NEAR(r.moment[1], 3, 1e-12);
    CHECK_WITHIN(r.moment[2], 0, 1e-12);
    // what the segment carries answers the motion, spring and all
    vec6 w = {{r.force[0], r.force[1], r.force[2] - 2 * r.tip_displacement[2], r.moment[0],
               r.moment[1], r.moment[2] - r.tip_rotation[2]}};
    const vec6 q = mat6_mul_vec(m.after.compliance, w);
    for (int i = 0; i < 3; i++) {
        CHECK_NEAR(q.a[i], r.tip_displacement[i], 1e-10);
        CHECK_NEAR(q.a[3 + i], r.tip_rotation[i], 1e-10);
    }
    load_free(&r);
    made_free(&m);
}

static void a_uniform_traction_has_its_own_place(void)
{
    const beam b = {some_compliance(), 0, LENGTH};
    const segment_load off = {.name = "off", .force = {0, 0, 1}},
                       turns = {.name = "turns", .moment = {0, 0, 1}};
    const double aside[2] = {0.25, 0}, none[2] = {0, 0};
    made m;
    segment_load_result r = {0};
    make(&m, &b, 2, 4, 0);
    after_ask ask = plain(&off, aside);
    ask.uniform = 0; // the six serve as three: only the refusals are looked at
    CHECK(after_load(&m.after, &ask, &r) == ERR_INPUT);
    status_clear();
    ask = plain(&turns, none);
    ask.uniform = 0;
    CHECK(after_load(&m.after, &ask, &r) == ERR_INPUT);
    status_clear();
    load_free(&r);
    made_free(&m);
}

// --- estimates

static void estimates_are_differences_times_a_factor(void)
{
    segment_load_result coarse_load = {.shortening = 1, .tip_rotation = {0, 3, 4}},
                        fine_load = {.shortening = 1.5};
    segment_result coarse = {.nload = 1, .load = &coarse_load, .stiffness_centre = {1, 1}},
                   fine = {.nload = 1, .load = &fine_load};
    coarse.tip_compliance = fine.tip_compliance = mat6_identity();
    coarse.middle.K = fine.middle.K = mat6_identity();
    coarse.tip_compliance.a[0][1] = 0.01;
    coarse.middle.K.a[2][4] = 0.02;
    after_errors(&coarse, 0.5, 0.75, &fine);
    CHECK_NEAR(fine.relative_error, 0.005, 1e-14);
    CHECK_NEAR(fine.middle.relative_error, 0.015, 1e-14);
    CHECK_NEAR(fine.middle.entry_error.a[2][4], 0.015, 1e-14);
    CHECK(fine.middle.entry_error.a[1][1] == 0);
    CHECK_NEAR(fine.stiffness_centre_error, 0.75 * sqrt(2), 1e-14);
    CHECK_NEAR(fine_load.shortening_error, 0.25, 1e-14);
    CHECK_NEAR(fine_load.tip_rotation_error, 2.5, 1e-14);
}

static void estimates_do_not_fall_where_nothing_new_is_seen(void)
{
    segment_load_result coarse_load = {.shortening_error = 3}, fine_load = {.shortening_error = 1};
    segment_result coarse = {.nload = 1, .load = &coarse_load, .relative_error = 2},
                   fine = {.nload = 1, .load = &fine_load, .relative_error = 1};
    coarse.middle.relative_error = 1;
    fine.middle.relative_error = 4;
    after_no_better(&coarse, &fine);
    CHECK(fine.relative_error == 2 && fine.middle.relative_error == 4);
    CHECK(fine_load.shortening_error == 3);
}

int main(void)
{
    slopes_of_polynomials_are_exact();
    the_law_comes_back();
    no_ends_take_no_length();
    ends_take_what_was_cut_off();
    centres_are_where_bending_ends();
    a_slice_strains_as_its_wrench_wants();
    a_moment_bends_the_middle_by_F();
    a_miss_of_one_slice_is_told();
    a_spring_at_the_tip_takes_its_share();
    an_imposed_motion_is_met_and_its_reaction_told();
    a_uniform_traction_has_its_own_place();
    estimates_are_differences_times_a_factor();
    estimates_do_not_fall_where_nothing_new_is_seen();
    return test_failures != 0;
}
