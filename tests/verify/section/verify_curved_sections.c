// Sections with curved outlines against closed forms: torsion of ellipses and elliptic tubes
// (Saint-Venant), and what symmetry says of lumens around a circle.
#include "base/dense.h"
#include "section/section.h"
#include "tests/dxf.h"
#include "tests/shapes.h"
#include "tests/test.h"

static const material rubber = {.name = "rubber", .E = 2e6, .nu = 0.4};

static beam_law law_of(int n, shape_spec *shapes)
{
    section_case c = section_case_default();
    beam_law law = {0};
    c.shapes = (key_list){.count = n, .items = shapes};
    CHECK_OK(section_solve(&c, &rubber, 0, 0, &law));
    return law;
}

// GJ = G pi a^3 b^3 / (a^2 + b^2) (1 - k^4), k the inner over the outer ellipse
static void elliptic_tubes_twist_as_they_should(void)
{
    const double a = 3e-3, ratio[] = {0.9, 0.5, 0.2}, hole[] = {0, 0.5, 0.8};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const double b = ratio[i] * a, k = hole[j], solid = 1 - pow(k, 4);
            shape_spec s[] = {an_ellipse(a, b, 0.3, 0, 0, 0),
                              an_ellipse(fmax(k, 0.1) * a, fmax(k, 0.1) * b, 0.3, 0, 0, -1)};
            const beam_law law = law_of(k > 0 ? 2 : 1, s);
            beam_centres c = {0};
            CHECK_OK(beam_law_centres(&law, &c));
            const double GJ = rubber.E / 2.8 * PI * pow(a * b, 3) / (a * a + b * b) * solid;
            const double EA = rubber.E * PI * a * b * (1 - k * k);
            const double EI = rubber.E * PI / 4 * solid * a * b;
            printf("ellipse %.1f, hole %.1f: GJ %8.1e, EA %8.1e, EI %8.1e and %8.1e; said %.1e\n",
                   ratio[i], k, c.GJ / GJ - 1, c.EA / EA - 1,
                   fmax(c.EI[0], c.EI[1]) / (EI * a * a) - 1,
                   fmin(c.EI[0], c.EI[1]) / (EI * b * b) - 1, law.relative_error);
            CHECK_NEAR(c.EA, EA, 1e-10);
            CHECK_NEAR(fmax(c.EI[0], c.EI[1]), EI * a * a, 1e-10);
            CHECK_NEAR(fmin(c.EI[0], c.EI[1]), EI * b * b, 1e-10);
            // the warping is a polynomial: the curved elements miss it by their geometry only
            CHECK_NEAR(c.GJ, GJ, 1e-10);
        }
    }
}

// six-fold symmetry: bending and shear alike in all directions, nothing coupled
static void lumens_around_a_circle_leave_the_section_isotropic(void)
{
    shape_spec s[] = {a_disc(2e-3, 0, 0, 0), lumens_on_a_circle(0.3e-3, 6, 1.3e-3, 0.2, -1)};
    const beam_law law = law_of(2, s);
    const double *k = law.K.a[0];
    const double tolerance = fmax(1e-9, law.relative_error);
    printf("six lumens: shear %.1e, bending %.1e\n", k[6 * NX + NX] / k[6 * NY + NY] - 1,
           k[6 * MX + MX] / k[6 * MY + MY] - 1);
    CHECK_NEAR(k[6 * NX + NX], k[6 * NY + NY], tolerance);
    CHECK_NEAR(k[6 * MX + MX], k[6 * MY + MY], tolerance);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < i; j++) {
            CHECK_WITHIN(law.K.a[i][j], 0, tolerance * sqrt(law.K.a[i][i] * law.K.a[j][j]));
        }
    }
    // the same drawn as an array, and one by one
    shape_spec array[] = {s[0], in_array(a_disc(0.3e-3, 1.3e-3, 0, -1), 6, 0.2, true)};
    shape_spec alone[7] = {s[0]};
    for (int i = 0; i < 6; i++) {
        const double angle = 0.2 + i * PI / 3;
        alone[1 + i] = a_disc(0.3e-3, 1.3e-3 * cos(angle), 1.3e-3 * sin(angle), -1);
    }
    CHECK_BELOW(mat6_relative_error(law_of(2, array).K, law.K), 1e-9);
    CHECK_BELOW(mat6_relative_error(law_of(7, alone).K, law.K), 1e-9);
}

// the prototype's section as a drawing of circles, arcs and lines, and as shapes on the same free
// mesh
static void a_drawing_has_the_stiffness_of_its_shapes(void)
{
    static dxf_paper paper;
    shape_spec s[] = {an_annulus(4e-3, 3.2e-3, 0), a_sector(4e-3, 3.2e-3, PI, PI / 8, 1)};
    section_case shapes = section_case_default(), drawn = shapes;
    beam_law one = {0}, two = {0};
    shapes.shapes = (key_list){.count = 2, .items = s};
    shapes.mesh.size = drawn.mesh.size = 0.4e-3;
    dxf_tube(&paper, 15);
    CHECK_OK(dxf_open_text(paper.text, paper.count, NULL, 0, &drawn.drawing));
    CHECK_OK(section_solve(&shapes, dxf_materials, 0, 0, &one));
    CHECK_OK(section_solve(&drawn, dxf_materials, 0, 0, &two));
    const double miss = mat6_relative_error(two.K, one.K);
    const double said = one.relative_error + two.relative_error;
    printf("drawing against shapes: K %.1e, said %.1e\n", miss, said);
    CHECK_BELOW(miss, said);
    CHECK_BELOW(said, 1e-3);
    CHECK_NEAR(two.K.a[NZ][NZ], one.K.a[NZ][NZ], 1e-9);
    section_case_release(&drawn);
}

int main(void)
{
    against(BY_CLOSED_FORM, "Saint-Venant: elliptic tubes in torsion");
    elliptic_tubes_twist_as_they_should();
    against(BY_SYMMETRY, "six-fold symmetry of lumens");
    lumens_around_a_circle_leave_the_section_isotropic();
    against(BY_SECOND_WAY, "the same section from shapes");
    a_drawing_has_the_stiffness_of_its_shapes();
    return test_failures != 0;
}
