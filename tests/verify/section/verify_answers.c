// tests/verify/section/verify_answers.c
// Mass, kern, shear stiffness and warping constant of a section against closed forms.
#include "section/answers.h"
#include "section/kern.h"
#include "tests/verify/section/hand_meshes.h"

static const material steel = {.name = "steel", .E = 210e9, .nu = 0.3, .density = 7850};

typedef struct solved {
    mesh mesh;
    beam_law law;
    beam_centres centres;
    section_warping warping;
} solved;

static solved solve(mesh m, const material *materials)
{
    solved s = {.mesh = m};
    CHECK_OK(section_full_mesh(&s.mesh, materials, &s.law, &s.warping));
    s.centres = centres_of(&s.law);
    return s;
}

static void solved_free(solved *s)
{
    mesh_free(&s->mesh);
    section_warping_free(&s->warping);
}

static mesh outline_mesh(outline *items, int count, int order, double size)
{
    mesh m = {0};
    const section_outline o = {.count = count, .items = items, .size = 1};
    const mesh_options options = {.kind = MESH_AUTO, .order = order, .size = size};
    CHECK_OK(section_mesh_make(&o, &options, &m));
    return m;
}

static mesh rectangle_mesh(double b, double h, double x, double y, int order, double size)
{
    outline item = {.kind = KIND_RECTANGLE, .size = {b, h}, .centre = {x, y}};
    return outline_mesh(&item, 1, order, size);
}

// --- mass

static void mass_of_a_moved_rectangle(void)
{
    const double b = 6e-3, h = 2e-3, x = 3e-3, y = -1e-3, A = b * h, rho = steel.density;
    mesh m = rectangle_mesh(b, h, x, y, 1, 1e-3);
    section_mass mass = {0};
    CHECK_OK(section_mass_of(&m, &steel, &mass));
    CHECK(mass.known);
    CHECK_NEAR(mass.centre[0], x, 1e-13);
    CHECK_NEAR(mass.mass, rho * A, 1e-13);
    CHECK_NEAR(mass.mass_centre[1], y, 1e-13);
    // about its own middle diag(m, m, m, m h^2 / 12, m b^2 / 12, both); it moves as a stiffness
    // does
    mat6 own = {0};
    const double of_unit[6] = {1, 1, 1, h * h / 12, b * b / 12, (b * b + h * h) / 12};
    for (int i = 0; i < 6; i++) {
        own.a[i][i] = rho * A * of_unit[i];
    }
    CHECK_BELOW(mat6_relative_error(mass.matrix, beam_law_move(own, -x, -y, 0)), 1e-13);
    mesh_free(&m);
}

static void mass_centre_of_two_densities(void)
{
    const material two[2] = {{.E = 1e6, .density = 1000}, {.E = 1e6, .density = 3000}};
    outline items[2] = {
        {.kind = KIND_RECTANGLE, .size = {4e-3, 2e-3}, .centre = {2e-3, 0}},
        {.kind = KIND_RECTANGLE, .size = {4e-3, 2e-3}, .centre = {-2e-3, 0}, .material = 1}};
    mesh m = outline_mesh(items, 2, 1, 1e-3);
    section_mass mass = {0};
    CHECK_OK(section_mass_of(&m, two, &mass));
    CHECK_WITHIN(mass.centre[0], 0, 1e-15);
    CHECK_NEAR(mass.mass_centre[0], -1e-3, 1e-13);
    CHECK_NEAR(mass.mass, 4000 * 8e-6, 1e-13);
    const material unknown[2] = {two[0], {.E = 1e6}};
    CHECK_OK(section_mass_of(&m, unknown, &mass));
    CHECK(!mass.known && mass.mass == 0);
    mesh_free(&m);
}

// --- kern

static bool kern_has(int n, const double (*kern)[2], double x, double y, double tolerance)
{
    for (int i = 0; i < n; i++) {
        if (hypot(kern[i][0] - x, kern[i][1] - y) < tolerance) {
            return true;
        }
    }
    return false;
}

static void kern_of_a_rectangle_is_a_rhombus(void)
{
    const double b = 6e-3, h = 2e-3, x = 1e-3, y = 4e-3, eps = 1e-10 * b;
    int n = 0;
    double(*kern)[2] = NULL;
    solved s = solve(rectangle_mesh(b, h, x, y, 3, 0.7e-3), &steel);
    CHECK_OK(section_kern(&s.mesh, &s.law, &n, &kern));
    CHECK(n == 4);
    CHECK(kern_has(n, (const double(*)[2])kern, x + b / 6, y, eps));
    CHECK(kern_has(n, (const double(*)[2])kern, x - b / 6, y, eps));
    CHECK(kern_has(n, (const double(*)[2])kern, x, y + h / 6, eps));
    CHECK(kern_has(n, (const double(*)[2])kern, x, y - h / 6, eps));
    free(kern);
    solved_free(&s);
}

static void kern_of_circles(void)
{
    const double ro = 4e-3, ri = 3e-3;
    for (int hollow = 0; hollow < 2; hollow++) {
        outline item = {
            .kind = hollow ? KIND_ANNULUS : KIND_DISC, .outer = ro, .inner = hollow ? ri : 0};
        const double wanted = hollow ? (ro * ro + ri * ri) / (4 * ro) : ro / 4;
        int n = 0;
        double(*kern)[2] = NULL;
        solved s = solve(outline_mesh(&item, 1, 4, 1e-3), &steel);
        CHECK_OK(section_kern(&s.mesh, &s.law, &n, &kern));
        CHECK_ABOVE(n, 60);
        for (int i = 0; i < n; i++) {
            // corners stand out by 1 / cos of half the angle between two nodes
            CHECK_NEAR(hypot(kern[i][0], kern[i][1]), wanted, 3e-3);
            const double *a = kern[i], *b = kern[(i + 1) % n];
            CHECK_ABOVE(a[0] * b[1] - a[1] * b[0], 0); // counter-clockwise
        }
        free(kern);
        solved_free(&s);
    }
}

// Any section: a force at a corner of the kern strains one side of the hull by nothing and all the
// rest the same way.
static void kern_leaves_no_tension_in_a_composite(void)
{
    prototype p;
    material two[2];
    mesh m = {0};
    prototype_materials(0.3, 0.3, two);
    prototype_set(&p, 2, 0.7, 0.9);
    const mesh_options options = {.kind = MESH_MAPPED, .order = 4, .size = 1e-3};
    CHECK_OK(section_mesh_make(&p.all, &options, &m));
    solved s = solve(m, two);
    int n = 0;
    double(*kern)[2] = NULL;
    mat6 F;
    CHECK_OK(section_kern(&s.mesh, &s.law, &n, &kern));
    CHECK(mat6_inverse_spd(s.law.K, &F));
    CHECK_ABOVE(n, 20);
    for (int k = 0; k < n; k++) {
        const double force[3] = {0, 0, -1}, none[3] = {0};
        const vec6 e = mat6_mul_vec(F, section_wrench_at_origin(kern[k], force, none));
        double low = 0, high = -1;
        for (int i = 0; i < s.mesh.nnode; i++) {
            const double *x = s.mesh.xyz + 3 * i;
            const double strain = e.a[NZ] + x[1] * e.a[MX] - x[0] * e.a[MY];
            low = fmin(low, strain);
            high = fmax(high, strain);
        }
        CHECK_WITHIN(high / low, 0, 1e-8); // rounding of K and of the hull's flat corners
    }
    free(kern);
    solved_free(&s);
}

// --- shear

static void shear_stiffness_of_an_annulus(void)
{
    const double ro = 4e-3, ri = 3.2e-3, nu = steel.nu, m2 = pow(ri / ro, 2);
    outline item = {.kind = KIND_ANNULUS, .outer = ro, .inner = ri};
    solved s = solve(outline_mesh(&item, 1, 4, 1e-3), &steel);
    section_axes axes = {0};
    CHECK_OK(section_axes_of(&s.law, &s.centres, &axes));
    const double a = pow(1 + nu, 2) * pow(1 + m2, 2);
    const double k =
        6 * a /
        ((7 + 14 * nu + 8 * nu * nu) * pow(1 + m2, 2) + 4 * m2 * (5 + 10 * nu + 4 * nu * nu));
    const double wanted = k * material_shear_modulus(&steel) * pi * (ro * ro - ri * ri);
    CHECK_NEAR(axes.shear_stiffness[0], wanted, 1e-7);
    CHECK_NEAR(axes.shear_stiffness[1], wanted, 1e-7);
    CHECK_WITHIN(axes.shear_angle, s.centres.principal_angle, 0);
    solved_free(&s);
}

// turned by 0.5 and away from the origin: the same stiffnesses along axes turned by 0.5
static void axes_turn_with_the_section(void)
{
    const double b = 6e-3, h = 2e-3, angle = 0.5;
    solved flat = solve(rectangle_mesh(b, h, 0, 0, 4, 1e-3), &steel);
    outline item = {.kind = KIND_RECTANGLE, .size = {b, h}, .centre = {5e-3, 1e-3}, .angle = angle};
    solved turned = solve(outline_mesh(&item, 1, 4, 1e-3), &steel);
    section_axes a = {0}, c = {0};
    CHECK_OK(section_axes_of(&flat.law, &flat.centres, &a));
    CHECK_OK(section_axes_of(&turned.law, &turned.centres, &c));
    CHECK_BELOW(mat6_relative_error(c.K_principal, a.K_principal), 1e-9);
    for (int i = 0; i < 2; i++) {
        CHECK_NEAR(c.shear_stiffness[i], a.shear_stiffness[i], 1e-9);
        CHECK_NEAR(a.shear_stiffness[i], flat.law.K.a[i][i], 1e-9);
    }
    CHECK_WITHIN(a.shear_angle, 0, 1e-9);
    CHECK_NEAR(c.shear_angle, angle, 1e-9);
    solved_free(&flat);
    solved_free(&turned);
}

// --- warping constant

static double warping_constant(const solved *s)
{
    double EI = 0;
    CHECK_OK(section_warping_constant(&s->mesh, &steel, &s->warping, &EI));
    return EI / steel.E;
}

// omega = -(a^2 - b^2) / (a^2 + b^2) x y
static void warping_of_an_ellipse(void)
{
    const double a = 6e-3, b = 2e-3;
    outline item = {.kind = KIND_DISC, .outer = a};
    mesh m = outline_mesh(&item, 1, 4, 2e-3);
    for (int i = 0; i < m.nnode; i++) {
        m.xyz[3 * i] += 3e-3; // the axes' linear part must go
        m.xyz[3 * i + 1] *= b / a;
    }
    solved s = solve(m, &steel);
    const double part = (a * a - b * b) / (a * a + b * b);
    CHECK_NEAR(warping_constant(&s), part * part * pi * pow(a * b, 3) / 24, 1e-6);
    solved_free(&s);
}

// Saint-Venant's series of a rectangle b x t, |x| < t/2, |y| < b/2, integrated by Simpson's rule
static double series_constant(double b, double t)
{
    enum { N = 200 };
    double sum = 0;
    for (int i = 0; i <= N; i++) {
        for (int j = 0; j <= N; j++) {
            const double x = t / 2 * i / N, y = b / 2 * j / N;
            double omega = x * y, sign = 1;
            for (int n = 1; n < 80; n += 2, sign = -sign) {
                const double q = n * pi / t;
                // sinh(q y) / cosh(q b / 2), without overflow
                const double ratio =
                    exp(q * (y - b / 2)) * (1 - exp(-2 * q * y)) / (1 + exp(-q * b));
                omega -= sign * 8 * t * t / pow(n * pi, 3) * ratio * sin(q * x);
            }
            const double wi = i == 0 || i == N ? 1 : i % 2 ? 4 : 2;
            const double wj = j == 0 || j == N ? 1 : j % 2 ? 4 : 2;
            sum += wi * wj * omega * omega;
        }
    }
    return 4 * sum * (t / 2 / N) * (b / 2 / N) / 9;
}

static void warping_of_rectangles(void)
{
    const double t = 1e-3;
    for (int ratio = 2; ratio <= 32; ratio *= 4) {
        const double b = ratio * t, wanted = series_constant(b, t);
        solved s = solve(rectangle_mesh(t, b, 0, 0, 4, t / 3), &steel);
        const double computed = warping_constant(&s), narrow = pow(b * t, 3) / 144;
        printf("rectangle %2d : 1: C_w over its series - 1: %8.1e, over b^3 t^3 / 144: %.4f\n",
               ratio, computed / wanted - 1, computed / narrow);
        CHECK_NEAR(computed, wanted, 1e-6);
        solved_free(&s);
        if (ratio == 32) {
            CHECK_NEAR(computed, narrow, 0.1); // the handbook's, for b >> t
        }
    }
}

// thin walls: the constant tends to the handbook's with the thickness
static void warping_of_an_i_section(void)
{
    const double h = 40e-3, b = 20e-3; // between the flanges' middles, of a flange
    double before = 1;
    for (int k = 0; k < 3; k++) {
        const double t = 2e-3 / (1 << k);
        outline items[3] = {
            {.kind = KIND_RECTANGLE, .size = {t, h}},
            {.kind = KIND_RECTANGLE, .size = {b, t}, .centre = {0, h / 2}},
            {.kind = KIND_RECTANGLE, .size = {b, t}, .centre = {0, -h / 2}},
        };
        solved s = solve(outline_mesh(items, 3, 4, 4e-3), &steel);
        const double handbook = t * pow(b, 3) / 12 * h * h / 2; // I_z h^2 / 4 of both flanges
        const double miss = fabs(warping_constant(&s) / handbook - 1);
        printf("I section, t = %.2f mm: C_w off I_z h^2 / 4 by %.2e\n", 1e3 * t, miss);
        CHECK_BELOW(miss, 0.6 * before);
        before = miss;
        solved_free(&s);
    }
    CHECK_BELOW(before, 3e-3);
}

static void warping_of_a_channel(void)
{
    const double h = 40e-3, b = 20e-3; // middle lines
    double before = 1;
    for (int k = 0; k < 3; k++) {
        const double t = 2e-3 / (1 << k);
        outline items[3] = {
            {.kind = KIND_RECTANGLE, .size = {t, h + t}, .centre = {0, 0}},
            {.kind = KIND_RECTANGLE, .size = {b, t}, .centre = {b / 2, h / 2}},
            {.kind = KIND_RECTANGLE, .size = {b, t}, .centre = {b / 2, -h / 2}},
        };
        solved s = solve(outline_mesh(items, 3, 4, 4e-3), &steel);
        const double handbook =
            t * pow(b, 3) * h * h / 12 * (3 * b * t + 2 * h * t) / (6 * b * t + h * t);
        const double miss = fabs(warping_constant(&s) / handbook - 1);
        // the shear centre's handbook distance from the web's middle, away from the flanges
        const double e = 3 * b * b / (6 * b + h);
        printf("channel, t = %.2f mm: C_w off the handbook's by %.2e, shear centre by %.2e\n",
               1e3 * t, miss, fabs(s.centres.shear_centre[0] / -e - 1));
        CHECK_BELOW(miss, 0.7 * before);
        before = miss;
        solved_free(&s);
    }
    CHECK_BELOW(before, 2e-2);
}

int main(void)
{
    against(
        BY_CLOSED_FORM,
        "rectangles, circles, ellipses, thin walls: handbook formulas and Saint-Venant's series");
    mass_of_a_moved_rectangle();
    mass_centre_of_two_densities();
    kern_of_a_rectangle_is_a_rhombus();
    kern_of_circles();
    kern_leaves_no_tension_in_a_composite();
    shear_stiffness_of_an_annulus();
    axes_turn_with_the_section();
    warping_of_an_ellipse();
    warping_of_rectangles();
    warping_of_an_i_section();
    warping_of_a_channel();
    return test_failures != 0;
}
