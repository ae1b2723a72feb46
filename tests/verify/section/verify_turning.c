// Sections whose pattern turns along the rod, docs/theory.md (3.9)-(3.14): against another code's
// table, against a helical wire in closed form, and against what symmetry says.
#include "tests/verify/section/hand_meshes.h"
#include "tests/verify/section/turning_table.h"

#include "base/dense.h"

static beam_law turning_law(const mesh *m, const material *materials, double rate)
{
    beam_law law = {0};
    CHECK_OK(section_turning_mesh(m, materials, rate, &law, NULL));
    return law;
}

static mesh prototype_mesh(double width, const mesh_options *options)
{
    prototype p;
    mesh m = {0};
    prototype_set(&p, 2, 0, width);
    CHECK_OK(section_mesh_make(&p.all, options, &m));
    return m;
}

// Where the material changes at the free surface the field is singular, and a fast pattern feels
// it. The table is that of a mesh too: two meshes as fine as it, of different order, give every
// row.
static void agrees_with_the_table(void)
{
    material two[2];
    prototype_materials(0.3, 0.3, two);
    for (size_t k = 0; k < sizeof turning_table / sizeof *turning_table; k++) {
        const turning_row *r = &turning_table[k];
        const mat6 wanted = from_mm(turning_stiffness(r));
        static const mesh_options like[2] = {{.kind = MESH_MAPPED, .order = 3, .size = 3e-4},
                                             {.kind = MESH_MAPPED, .order = 4, .size = 5e-4}};
        double error[2];
        for (int i = 0; i < 2; i++) {
            mesh m = prototype_mesh(r->width, &like[i]);
            error[i] = mat6_relative_error(turning_law(&m, two, 1e3 * r->rate).K, wanted);
            CHECK_BELOW(error[i], 2e-5);
            mesh_free(&m);
        }
        printf("sector %.3f rad, rate %.4f rad/mm: K %.2e, %.2e\n", r->width, r->rate, error[0],
               error[1]);
    }
}

// Meshes that are graded deeply into the singular places agree among themselves, across orders. So
// does the table with them while the rate is small; at 0.157 rad/mm it is 1.7e-4 off.
static void graded_meshes_go_beyond_the_table(void)
{
    static const int rows[2] = {2, 5};
    static const mesh_options graded[2] = {
        {.kind = MESH_MAPPED, .order = 4, .layers = 4, .finer = 2},
        {.kind = MESH_MAPPED, .order = 3, .layers = 6, .finer = 2}};
    material two[2];
    prototype_materials(0.3, 0.3, two);
    for (int k = 0; k < 2; k++) {
        const turning_row *r = &turning_table[rows[k]];
        mat6 K[2];
        for (int i = 0; i < 2; i++) {
            mesh m = prototype_mesh(r->width, &graded[i]);
            K[i] = turning_law(&m, two, 1e3 * r->rate).K;
            mesh_free(&m);
        }
        const double among = mat6_relative_error(K[1], K[0]);
        const double off = mat6_relative_error(from_mm(turning_stiffness(r)), K[0]);
        printf("rate %.4f rad/mm: orders 3 and 4 %.2e, the table %.2e\n", r->rate, among, off);
        CHECK_BELOW(among, 1e-5);
        CHECK_BELOW(off, (k == 0 ? 2e-5 : 2e-4));
    }
}

// T K T of a diagonal T
static mat6 with_signs(mat6 K, const double *sign)
{
    for (int i = 0; i < 36; i++) {
        K.a[i / 6][i % 6] *= sign[i / 6] * sign[i % 6];
    }
    return K;
}

static void place_lopsided(double u, double v, double *xyz)
{
    const double angle = 2.2 * (1 - u), r = 2e-3 + 2e-3 * v;
    xyz[0] = r * cos(angle) + 1e-3;
    xyz[1] = 1.3 * r * sin(angle) - 2e-3 + 3e-4 * u;
    xyz[2] = 0;
}

static int lower_part(double u, double v)
{
    return u < 0.3 && v < 0.6;
}

static const lattice lopsided = {
    .order = 3, .n0 = 8, .n1 = 4, .place = place_lopsided, .material = lower_part};
static const material soft_and_stiff[2] = {{.E = 1e6, .nu = 0.42}, {.E = 2e7, .nu = 0.3}};

// A mirror across the section turns rate to -rate and leaves an isotropic section as it is.
static void turning_the_other_way_is_a_mirror_image(void)
{
    static const double sign[6] = {-1, -1, 1, 1, 1, -1};
    mesh m = lattice_mesh(&lopsided);
    const beam_law one = turning_law(&m, soft_and_stiff, 180);
    const beam_law other = turning_law(&m, soft_and_stiff, -180);
    CHECK_BELOW(mat6_relative_error(with_signs(other.K, sign), one.K), 1e-11);
    // it does depend on the sense
    CHECK_ABOVE(mat6_relative_error(other.K, one.K), 1e-2);
    mesh_free(&m);
}

// The turning section's solution is another way to the prismatic one: continuous to rounding, and
// of first order in the rate.
static void slow_turning_is_prismatic(void)
{
    mesh m = lattice_mesh(&lopsided);
    const beam_law still = turning_law(&m, soft_and_stiff, 0);
    const double rates[] = {1e-9, 1e-6, 1e-3, 1e-2};
    const double slope = mat6_relative_error(turning_law(&m, soft_and_stiff, 0.1).K, still.K) / 0.1;
    for (int k = 0; k < 4; k++) {
        const beam_law slow = turning_law(&m, soft_and_stiff, rates[k]);
        const double change = mat6_relative_error(slow.K, still.K);
        printf("rate %.0e rad/m: K changes by %.2e\n", rates[k], change);
        CHECK_WITHIN(change, slope * rates[k], 1e-2 * slope * rates[k] + 1e-11);
    }
    mesh_free(&m);
}

// A homogeneous annulus looks the same however it turns.
static void nothing_turns_in_an_annulus(void)
{
    prototype p;
    material two[2];
    mesh m = {0};
    const mesh_options options = {.kind = MESH_MAPPED, .order = 4, .size = 4e-4};
    prototype_set(&p, 1, 0, 0);
    prototype_materials(0.3, 0.3, two);
    CHECK_OK(section_mesh_make(&p.all, &options, &m));
    const beam_law still = turning_law(&m, two, 0), fast = turning_law(&m, two, 600);
    const double error = mat6_relative_error(fast.K, still.K);
    printf("annulus at 600 rad/m: K %.2e\n", error);
    CHECK_BELOW(error, 1e-8);
    mesh_free(&m);
}

// Nor in one that is wound from fibres: polar frames, all three displacements coupled.
static void nothing_turns_in_a_wound_annulus(void)
{
    material ply = {.name = "ply",
                    .E1 = 20e6,
                    .E2 = 1.4e6,
                    .E3 = 1.2e6,
                    .G12 = 0.9e6,
                    .G13 = 0.8e6,
                    .G23 = 0.5e6,
                    .nu12 = 0.42,
                    .nu13 = 0.35,
                    .nu23 = 0.3};
    prototype p;
    mesh m = {0};
    const mesh_options options = {.kind = MESH_MAPPED, .order = 4, .size = 4e-4};
    prototype_set(&p, 1, 0, 0);
    CHECK_OK(material_bind(&ply));
    CHECK_OK(section_mesh_make(&p.all, &options, &m));
    CHECK_OK(mesh_take_frames(&m, 1));
    m.frame[0] = material_frame_make(0, 0.5);
    m.frame[0].polar = true;
    for (int e = 0; e < m.block[0].nelem; e++) {
        m.block[0].frame[e] = 0;
    }
    const beam_law still = turning_law(&m, &ply, 0), fast = turning_law(&m, &ply, 600);
    const double error = mat6_relative_error(fast.K, still.K);
    printf("wound annulus at 600 rad/m: K %.2e, K[nz,mz] %.2e of its diagonal\n", error,
           still.K.a[NZ][MZ] / sqrt(still.K.a[NZ][NZ] * still.K.a[MZ][MZ]));
    CHECK_BELOW(error, 1e-8);
    CHECK_ABOVE(fabs(still.K.a[NZ][MZ]), 0.1 * sqrt(still.K.a[NZ][NZ] * still.K.a[MZ][MZ]));
    mesh_free(&m);
}

// --- a wire wound to a helix

enum { WIRE_RADIUS_UM = 50, COIL_RADIUS_UM = 5000 };

// a disc of the wire's radius about (coil radius, 0), from a square lattice
static void place_in_wire(double u, double v, double *xyz)
{
    const double a = 2 * u - 1, b = 2 * v - 1;
    xyz[0] = 1e-6 * (COIL_RADIUS_UM + WIRE_RADIUS_UM * a * sqrt(1 - b * b / 2));
    xyz[1] = 1e-6 * (WIRE_RADIUS_UM * b * sqrt(1 - a * a / 2));
    xyz[2] = 0;
}

// Compliance of a thin curved rod about the axis of its helix: the wire's normal section is an
// ellipse with half axes r along the radius and r cos(alpha) across, and the wrench moves to its
// centre.
static mat6 helix_compliance(const material *m, double rate)
{
    const double r = 1e-6 * WIRE_RADIUS_UM, R = 1e-6 * COIL_RADIUS_UM;
    const double length = sqrt(1 + R * R * rate * rate), b = r / length;
    const double E = m->E, G = E / (2 * (1 + m->nu)), A = pi * r * b;
    const double EI_radius = E * pi / 4 * r * b * b * b, EI_across = E * pi / 4 * r * r * r * b;
    const double GJ = G * pi * r * r * r * b * b * b / (r * r + b * b);
    const vec3 axis[3] = {{{1, 0, 0}}, // radius
                          {{0, 1 / length, -R * rate / length}},
                          {{0, R * rate / length, 1 / length}}}; // along the wire
    const double soft[6] = {0, 0, 1 / (E * A), 1 / EI_radius, 1 / EI_across, 1 / GJ};
    mat6 F = {0};
    for (int k = 2; k < 6; k++) {
        // the strain's part k of a unit wrench at the axis: the moment at c is m - c x n
        double part[6] = {0};
        const vec3 d = axis[k == 2 ? 2 : k - 3], c = {{R, 0, 0}}, dc = vec3_cross(d, c);
        for (int i = 0; i < 3; i++) {
            part[i] = k == 2 ? d.a[i] : -dc.a[i];
            part[3 + i] = k == 2 ? 0 : d.a[i];
        }
        for (int i = 0; i < 36; i++) {
            F.a[i / 6][i % 6] += length * soft[k] * part[i / 6] * part[i % 6];
        }
    }
    return F;
}

// Far off the centre that it turns about: with the axis wrong, or the wrench's point, nothing fits.
// Left out are the wire's curvature, (r / R)^2 = 1e-4, and its shear, so all of n_x: a force
// through the wire's centre does nothing else.
static void a_thin_helix_is_a_curved_rod(void)
{
    const lattice g = {
        .order = 3, .n0 = 4, .n1 = 4, .place = place_in_wire, .material = one_material};
    const material steel = {.E = 2e11, .nu = 0.3};
    const double rates[] = {40, -100, 200, 400}; // R rate up to 2
    mesh m = lattice_mesh(&g);
    for (int k = 0; k < 4; k++) {
        const beam_law law = turning_law(&m, &steel, rates[k]);
        mat6 F;
        CHECK(mat6_inverse_spd(law.K, &F));
        mat6 wanted = helix_compliance(&steel, rates[k]);
        for (int i = 0; i < 6; i++) {
            wanted.a[NX][i] = F.a[NX][i];
            wanted.a[i][NX] = F.a[i][NX];
        }
        const double error = mat6_relative_error(wanted, F);
        printf("helix, R rate %.1f: F %.2e\n", 1e-6 * COIL_RADIUS_UM * rates[k], error);
        CHECK_BELOW(error, 1e-3);
    }
    mesh_free(&m);
}

int main(void)
{
    against(BY_OTHER_CODE,
            "a turning section by an independent code (tests/verify/section/turning_table.h)");
    agrees_with_the_table();
    against(BY_SECOND_WAY, "graded meshes of two orders");
    graded_meshes_go_beyond_the_table();
    against(BY_SYMMETRY, "mirrored; slow turns; annuli");
    turning_the_other_way_is_a_mirror_image();
    slow_turning_is_prismatic();
    nothing_turns_in_an_annulus();
    nothing_turns_in_a_wound_annulus();
    against(BY_CLOSED_FORM, "a helical wire as a curved rod");
    a_thin_helix_is_a_curved_rod();
    return test_failures != 0;
}
