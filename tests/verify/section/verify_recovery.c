// tests/verify/section/verify_recovery.c
// Recovered strains and stresses against closed forms, and their resultants against the wrench.
#include "section/extremes.h"
#include "tests/verify/section/hand_meshes.h"

// rounding of the solves
static const double rounding = 1e-10;

typedef struct recovered {
    mesh mesh;
    double turn_rate;
    beam_law law;
    section_warping warping;
    section_fields fields;
} recovered;

static recovered recover_turning(mesh m, const material *materials, double turn_rate)
{
    recovered r = {.mesh = m, .turn_rate = turn_rate};
    CHECK_OK(section_turning_mesh(&r.mesh, materials, turn_rate, &r.law, &r.warping));
    CHECK_OK(section_fields_make(&r.mesh, &r.warping, turn_rate, &r.fields));
    return r;
}

static recovered recover(mesh m, const material *materials)
{
    return recover_turning(m, materials, 0);
}

static void recovered_free(recovered *r)
{
    mesh_free(&r->mesh);
    section_warping_free(&r->warping);
    section_fields_free(&r->fields);
}

static section_extremes extremes_of(const recovered *r, const material *materials, vec6 wrench)
{
    section_extremes e[2];
    section_extremes_find(&r->fields, materials, 2, &wrench, e);
    return e[0];
}

static mesh outline_mesh(outline *items, int count, int order, double size)
{
    mesh m = {0};
    const section_outline o = {.count = count, .items = items, .size = 1};
    const mesh_options options = {.kind = MESH_AUTO, .order = order, .size = size};
    CHECK_OK(section_mesh_make(&o, &options, &m));
    return m;
}

static const material steel[2] = {{.name = "steel", .E = 210e9, .nu = 0.3},
                                  {.name = "more", .E = 100e9, .nu = 0.3}};
static const material unequal[2] = {{.E = 1e6, .nu = 0.45}, {.E = 2e7, .nu = 0.1}};

// --- the wrench again, by a rule of its own

static vec6 resultant(const recovered *r, const material *materials, int j)
{
    vec6 sum = {0};
    plane p = {0};
    CHECK_OK(plane_make(&r->mesh, 4 * r->mesh.order, &p));
    for (int k = 0; k < r->mesh.block[0].nelem; k++) {
        plane_element e;
        CHECK_OK(plane_element_at(&p, 0, k, &e));
        for (int q = 0; q < e.npoint; q++) {
            const mat6 strain = section_strains(&p, &e, q, &r->warping, r->turn_rate);
            vec6 column, s;
            for (int i = 0; i < 6; i++) {
                column.a[i] = strain.a[i][j];
            }
            const double x = p.centre[0] + p.length * e.x[q], y = p.centre[1] + p.length * e.y[q];
            const int frame = section_frame_of(&r->mesh.block[0], k);
            s = mat6_mul_vec(section_stress_law(&r->mesh, materials, e.material, frame, x, y),
                             column);
            const double dA = p.length * p.length * e.dA[q];
            const double part[6] = {s.a[XZ],     s.a[YZ],      s.a[ZZ],
                                    y * s.a[ZZ], -x * s.a[ZZ], x * s.a[YZ] - y * s.a[XZ]};
            for (int i = 0; i < 6; i++) {
                sum.a[i] += part[i] * dA;
            }
        }
    }
    plane_free(&p);
    return sum;
}

// largest miss over the six unit wrenches, a moment of 1 N m being that of 250 N at 4 mm
static double resultant_miss(mesh m, const material *materials, double turn_rate)
{
    recovered r = recover_turning(m, materials, turn_rate);
    double most = 0;
    for (int j = 0; j < 6; j++) {
        const vec6 sum = resultant(&r, materials, j);
        for (int i = 0; i < 6; i++) {
            const double size = (i < 3 ? 1 : 4e-3) / (j < 3 ? 1 : 4e-3);
            most = fmax(most, fabs(sum.a[i] - (i == j)) / size);
        }
    }
    recovered_free(&r);
    return most;
}

static void stresses_carry_the_wrench(void)
{
    prototype p;
    mesh m = {0};
    prototype_set(&p, 2, 0.4, 1);
    const mesh_options options = {.kind = MESH_MAPPED, .order = 3, .size = 1e-3};
    CHECK_OK(section_mesh_make(&p.all, &options, &m));
    const double curved = resultant_miss(m, unequal, 0);
    outline items[2] = {
        {.kind = KIND_RECTANGLE, .size = {4e-3, 2e-3}, .centre = {2e-3, 1e-3}},
        {.kind = KIND_RECTANGLE, .size = {4e-3, 2e-3}, .centre = {-2e-3, 1e-3}, .material = 1}};
    const double straight = resultant_miss(outline_mesh(items, 2, 4, 1e-3), unequal, 0);
    const double turning = resultant_miss(outline_mesh(items, 2, 4, 1e-3), unequal, 2 * pi / 30e-3);
    printf("resultants of recovered stresses miss the unit wrenches by %.1e on straight, %.1e on "
           "curved elements; %.1e where they turn\n",
           straight, curved, turning);
    CHECK_BELOW(straight, 1e-11); // rounding
    CHECK_BELOW(turning, 1e-11);
    CHECK_BELOW(curved, 1e-8); // no rule is exact there: this one and the solve's own differ
}

// fibres wound around a bar at 30 degrees, softer towards x > 0: nothing is alike in two directions
static double softer(const void *unused, double x, double y, double s)
{
    (void)unused, (void)y, (void)s;
    return 20e9 * (1 - 50 * x);
}

static void fibres_and_grades_carry_it_too(void)
{
    material wound[2] = {{.name = "ply",
                          .E1 = 140e9,
                          .E2 = 9e9,
                          .E3 = 10e9,
                          .G12 = 5e9,
                          .G13 = 6e9,
                          .G23 = 4e9,
                          .nu12 = 0.3,
                          .nu13 = 0.32,
                          .nu23 = 0.4},
                         {.name = "graded", .E = 20e9, .nu = 0.25}};
    wound[1].modulus = (place_field){.value = 20e9, .at = softer, .across = true};
    CHECK_OK(material_bind(&wound[0]));
    CHECK_OK(material_bind(&wound[1]));
    outline items[2] = {
        {.kind = KIND_RECTANGLE, .size = {4e-3, 2e-3}, .centre = {2e-3, 1e-3}},
        {.kind = KIND_RECTANGLE, .size = {4e-3, 2e-3}, .centre = {-2e-3, 1e-3}, .material = 1}};
    mesh m = outline_mesh(items, 2, 4, 1e-3);
    CHECK_OK(mesh_take_frames(&m, 2));
    m.frame[0] = material_frame_make(0, pi / 6);
    m.frame[1] = (material_frame){
        .polar = true, .centre = {2e-3, -9e-3}, .axes = material_frame_make(0, 0.4).axes};
    // an off-axis ply's modulus, as plate theory has it
    const double c2 = 0.75, s2 = 0.25;
    const double S = c2 * c2 / 140e9 + (1 / 5e9 - 0.6 / 140e9) * s2 * c2 + s2 * s2 / 9e9;
    CHECK_NEAR(section_axial_modulus(&m, wound, 0, 0, 1e-3, 1e-3), 1 / S, 1e-12);
    CHECK_NEAR(section_axial_modulus(&m, wound, 1, 0, 1e-3, 1e-3), 19e9, 1e-12);
    for (int e = 0; e < m.block[0].nelem; e++) {
        m.block[0].frame[e] = e % 2;
    }
    const double miss = resultant_miss(m, wound, 0);
    printf("with wound fibres and a graded modulus they miss them by %.1e\n", miss);
    CHECK_BELOW(miss, 1e-9); // polar axes make integrands that no rule is exact for
}

// --- one material

static void rectangle_in_bending_and_tension(void)
{
    const double b = 20e-3, h = 8e-3, M = 30, N = 4000;
    outline item = {.kind = KIND_RECTANGLE, .size = {b, h}};
    recovered r = recover(outline_mesh(&item, 1, 2, 3e-3), steel);
    const double stress = M / (b * h * h / 6), pull = N / (b * h);
    section_extremes e = extremes_of(&r, steel, (vec6){{0, 0, 0, M, 0, 0}});
    CHECK_NEAR(e.axial_highest.value, stress, rounding);
    CHECK_NEAR(e.axial_highest.at[1], h / 2, rounding); // a positive m_x stretches y > 0
    CHECK_NEAR(e.axial_lowest.value, -stress, rounding);
    CHECK_NEAR(e.von_mises.value, stress, rounding);
    CHECK_NEAR(fabs(e.strain.value), stress / steel[0].E, rounding);

    e = extremes_of(&r, steel, (vec6){{0, 0, N, M, 0, 0}});
    CHECK_NEAR(e.axial_highest.value, pull + stress, rounding);
    CHECK_NEAR(e.axial_lowest.value, pull - stress, rounding);
    // everywhere, not only at its ends
    for (int i = 0; i < r.fields.mesh.nnode; i++) {
        const vec6 wrench = {{0, 0, N, M, 0, 0}};
        const vec6 strain = section_strain_at(&r.fields, i, &wrench);
        const vec6 s = section_stress_at(&r.fields, steel, i, &strain);
        const double wanted = pull + stress * r.fields.mesh.xyz[3 * i + 1] / (h / 2);
        CHECK_WITHIN(s.a[ZZ], wanted, rounding * stress);
        CHECK_WITHIN(s.a[XX], 0, rounding * stress);
    }
    recovered_free(&r);
}

static void annulus_in_torsion(void)
{
    const double ro = 4e-3, ri = 3.2e-3, T = 0.7;
    const double J = pi * (pow(ro, 4) - pow(ri, 4)) / 2;
    outline item = {.kind = KIND_ANNULUS, .outer = ro, .inner = ri};
    recovered r = recover(outline_mesh(&item, 1, 4, 1e-3), steel);
    const vec6 wrench = {{0, 0, 0, 0, 0, T}};
    const section_extremes e = extremes_of(&r, steel, wrench);
    // arcs by polynomials of order 4, 25 of them around
    const double mesh_error = 2e-6;
    CHECK_NEAR(e.von_mises.value, sqrt(3) * T * ro / J, mesh_error);
    CHECK_NEAR(hypot(e.von_mises.at[0], e.von_mises.at[1]), ro, mesh_error);
    const double G = material_shear_modulus(steel);
    CHECK_NEAR(fabs(e.strain.value), T * ro / J / G / 2, mesh_error);
    recovered_free(&r);
}

// tau_xz = -2 T y / (pi a b^3), tau_yz = 2 T x / (pi a^3 b)
static void ellipse_in_torsion(void)
{
    const double a = 6e-3, b = 3e-3, T = 0.7, peak = 2 * T / (pi * a * b * b);
    const vec6 wrench = {{0, 0, 0, 0, 0, T}};
    outline item = {.kind = KIND_DISC, .outer = a};
    mesh m = outline_mesh(&item, 1, 4, 2e-3);
    for (int i = 0; i < m.nnode; i++) {
        m.xyz[3 * i + 1] *= b / a;
    }
    recovered r = recover(m, steel);
    double most = 0;
    for (int i = 0; i < r.fields.mesh.nnode; i++) {
        const vec6 strain = section_strain_at(&r.fields, i, &wrench);
        const vec6 s = section_stress_at(&r.fields, steel, i, &strain);
        const double x = r.fields.mesh.xyz[3 * i] / a, y = r.fields.mesh.xyz[3 * i + 1] / b;
        most = fmax(most, hypot(s.a[XZ] + peak * y, s.a[YZ] - peak * b / a * x));
    }
    printf("ellipse in torsion: stresses off by %.1e of their peak\n", most / peak);
    CHECK_BELOW(most, 1e-4 * peak); // arcs of order 4, 2 mm long
    const section_extremes e = extremes_of(&r, steel, wrench);
    CHECK_NEAR(e.von_mises.value, sqrt(3) * peak, 1e-3); // the node nearest to the end
    CHECK_NEAR(fabs(e.von_mises.at[1]), b, 1e-2);
    recovered_free(&r);
}

// Saint-Venant's series: tau_max in the middle of the long side, and the table's 0.246 for 2 : 1
static void rectangle_in_torsion(void)
{
    const double t = 4e-3, T = 0.3;
    for (int ratio = 1; ratio <= 4; ratio *= 2) {
        const double b = ratio * t;
        double J = 1, peak = 1;
        for (int n = 1; n < 200; n += 2) {
            J -= 192 / pow(pi, 5) * t / b * tanh(n * pi * b / (2 * t)) / pow(n, 5);
            peak -= 8 / (pi * pi) / (n * n * cosh(fmin(n * pi * b / (2 * t), 700)));
        }
        J *= b * t * t * t / 3;
        const double wanted = T * t / J * peak;
        outline item = {.kind = KIND_RECTANGLE, .size = {b, t}};
        recovered r = recover(outline_mesh(&item, 1, 4, t / 6), steel);
        const section_extremes e = extremes_of(&r, steel, (vec6){{0, 0, 0, 0, 0, T}});
        printf("rectangle %d : 1, tau_max by series over computed - 1: %.1e\n", ratio,
               wanted * sqrt(3) / e.von_mises.value - 1);
        // slopes of the warping at nodes of order 4
        CHECK_NEAR(e.von_mises.value, sqrt(3) * wanted, 1e-4);
        CHECK_WITHIN(fmin(fabs(e.von_mises.at[0]), fabs(e.von_mises.at[1])), 0, 0.1 * t);
        if (ratio == 2) {
            CHECK_NEAR(wanted, T / (0.246 * b * t * t), 2e-3); // the table's three digits
        }
        recovered_free(&r);
    }
}

// Saint-Venant's: tau_yz = (3 + 2 nu) / (8 (1 + nu)) V / I (R^2 - y^2 - (1 - 2 nu) / (3 + 2 nu)
// x^2), tau_xz = -(1 + 2 nu) / (4 (1 + nu)) V / I x y
static void circle_under_a_shear_force(void)
{
    const double R = 5e-3, V = 900, nu = steel[0].nu, I = pi * pow(R, 4) / 4;
    outline item = {.kind = KIND_DISC, .outer = R};
    recovered r = recover(outline_mesh(&item, 1, 4, 2e-3), steel);
    const vec6 wrench = {{0, V, 0, 0, 0, 0}};
    double most = 0;
    for (int i = 0; i < r.fields.mesh.nnode; i++) {
        const double x = r.fields.mesh.xyz[3 * i], y = r.fields.mesh.xyz[3 * i + 1];
        const vec6 strain = section_strain_at(&r.fields, i, &wrench);
        const vec6 s = section_stress_at(&r.fields, steel, i, &strain);
        const double yz = (3 + 2 * nu) / (8 * (1 + nu)) * V / I *
                          (R * R - y * y - (1 - 2 * nu) / (3 + 2 * nu) * x * x);
        const double xz = -(1 + 2 * nu) / (4 * (1 + nu)) * V / I * x * y;
        most = fmax(most, hypot(s.a[YZ] - yz, s.a[XZ] - xz));
    }
    const double peak = (3 + 2 * nu) / (8 * (1 + nu)) * V / I * R * R;
    printf("circle under a shear force: stresses off by %.1e of their peak\n", most / peak);
    // cubic warping on elements of order 4 with arcs of order 4
    CHECK_BELOW(most, 1e-4 * peak);
    recovered_free(&r);
}

// --- several materials

// one Poisson's ratio: the axial stress is E times a plane strain, each side with its own E
static void stress_jumps_where_materials_meet(void)
{
    const material two[2] = {{.E = 1e6, .nu = 0.3}, {.E = 2e7, .nu = 0.3}};
    outline items[2] = {
        {.kind = KIND_RECTANGLE, .size = {4e-3, 2e-3}, .centre = {2e-3, 0}},
        {.kind = KIND_RECTANGLE, .size = {4e-3, 2e-3}, .centre = {-2e-3, 0}, .material = 1}};
    recovered r = recover(outline_mesh(items, 2, 2, 1e-3), two);
    const beam_centres c = centres_of(&r.law);
    const vec6 wrench = {{0, 0, 1, 0, -c.stiffness_centre[0], 0}}; // 1 N at the stiffness centre
    int sides[2] = {0};
    for (int i = 0; i < r.fields.mesh.nnode; i++) {
        const int m = r.fields.material[i];
        const vec6 strain = section_strain_at(&r.fields, i, &wrench);
        const vec6 s = section_stress_at(&r.fields, two, i, &strain);
        CHECK_NEAR(s.a[ZZ], two[m].E / c.EA, 1e-9);
        sides[m] += fabs(r.fields.mesh.xyz[3 * i]) < 1e-9;
    }
    CHECK_ABOVE(sides[0], 0);
    CHECK(sides[0] == sides[1]); // both sides of the interface have their own
    recovered_free(&r);
}

static void one_strain_at_a_time(void)
{
    const vec6 pure_shear = {{0, 0, 0, 0, 3e-3, 0}}, tension = {{-1e-3, -1e-3, 4e-3, 0, 0, 0}},
               pressure = {{-2e-3, -2e-3, -2e-3, 0, 0, 0}}, nothing = {0},
               both = {{-1e-3, 2e-3, -5e-3, 0, 0, 6e-3}};
    CHECK_NEAR(fabs(principal_strain(&pure_shear)), 1.5e-3, 1e-14);
    CHECK_NEAR(principal_strain(&tension), 4e-3, 1e-14);
    CHECK_NEAR(principal_strain(&pressure), -2e-3, 1e-14);
    CHECK_WITHIN(principal_strain(&nothing), 0, 0);
    // in the plane 0.5e-3 +- sqrt(1.5^2 + 3^2) 1e-3 = 3.854e-3 and -2.854e-3; along z -5e-3
    CHECK_NEAR(principal_strain(&both), -5e-3, 1e-14);
    const vec6 shear = {{0, 0, 0, 0, 7, 0}}, hydrostatic = {{5, 5, 5, 0, 0, 0}};
    CHECK_NEAR(von_mises(&shear), 7 * sqrt(3), 1e-14);
    CHECK_WITHIN(von_mises(&hydrostatic), 0, 0);
}

// the bound that skips most principal strains must not skip the largest
static void largest_strain_is_that_of_the_extremes(void)
{
    prototype p;
    material two[2];
    mesh m = {0};
    prototype_materials(0.45, 0.3, two);
    prototype_set(&p, 2, 2, 0.5);
    const mesh_options options = {.kind = MESH_MAPPED, .order = 3, .size = 1e-3};
    CHECK_OK(section_mesh_make(&p.all, &options, &m));
    recovered r = recover(m, two);
    section_extreme largest[2] = {0};
    double most[2] = {0};
    for (int k = 0; k < 20; k++) {
        const vec6 wrench = {
            {sin(k), cos(3 * k), sin(5 * k), 1e-3 * sin(7 * k), 1e-3 * cos(k), 2e-3 * cos(11 * k)}};
        section_extremes e[2];
        section_extremes_find(&r.fields, two, 2, &wrench, e);
        section_largest_strain(&r.fields, &wrench, largest, NULL);
        for (int i = 0; i < 2; i++) {
            most[i] = fmax(most[i], fabs(e[i].strain.value));
            CHECK_WITHIN(fabs(largest[i].value), most[i], 0);
        }
    }
    recovered_free(&r);
}

// the classical model: a fibre that stretches along z and is free sideways
static void classical_fields(void)
{
    const double b = 20e-3, h = 8e-3, M = 30, T = 5;
    outline item = {.kind = KIND_RECTANGLE, .size = {b, h}};
    mesh m = outline_mesh(&item, 1, 2, 3e-3);
    beam_law law = {0};
    section_fields f = {0};
    section_extremes e[2];
    CHECK_OK(section_classical_mesh(&m, steel, &law));
    CHECK_OK(section_fields_classical(&m, steel, &law.K, &f));
    vec6 wrench = {{0, 0, 0, M, 0, 0}};
    section_extremes_find(&f, steel, 2, &wrench, e);
    CHECK_NEAR(e[0].von_mises.value, M / (b * h * h / 6), rounding);
    CHECK(!e[1].used);
    wrench = (vec6){{0, 0, 0, 0, 0, T}};
    section_extremes_find(&f, steel, 2, &wrench, e);
    const double polar = b * h * (b * b + h * h) / 12;
    CHECK_NEAR(e[0].von_mises.value, sqrt(3) * T * hypot(b, h) / 2 / polar, rounding);
    section_fields_free(&f);
    mesh_free(&m);
}

int main(void)
{
    against(BY_CLOSED_FORM,
            "the wrench that the stresses carry; Saint-Venant: circles, ellipses, rectangles");
    stresses_carry_the_wrench();
    fibres_and_grades_carry_it_too();
    rectangle_in_bending_and_tension();
    annulus_in_torsion();
    ellipse_in_torsion();
    rectangle_in_torsion();
    circle_under_a_shear_force();
    stress_jumps_where_materials_meet();
    one_strain_at_a_time();
    largest_strain_is_that_of_the_extremes();
    classical_fields();
    return test_failures != 0;
}
