// The iterative way against the direct one on prisms, turned and tapered bodies of any material,
// with each base and tip; its iterations do not grow with the mesh, nor with the steepest grading.
#include "fem/way.h"
#include "tests/unit/fem/brick_cases.h"
#include "tests/verify/fem/polar_mesh.h"

typedef struct trial {
    const char *what;
    int base, tip;
    double twist, taper, bend; // [rad/m], [1/m], [1/m]
    int material;              // of the soft part; the stiff sector is isotropic
    double contrast;
    int most;    // iterations
    bool winds;  // the mesh turns, and the sections' axes do not
    bool shared; // one of those that several ranks do too
} trial;

static status winding_place(const void *self, double s, double *xyz, mat3 *axes, double origin[3])
{
    const status st = bar_place(self, s, xyz, axes, origin);
    *axes = mat3_mul(*axes, mat3_rot_z(-((const bar *)self)->twist * s));
    return st;
}

typedef struct model {
    mesh plane;
    double layer[65];
    bar how;
    body b;
    segment_problem p;
} model;

static void model_free(model *m)
{
    body_free(&m->b);
    mesh_free(&m->plane);
}

static void make_layers(const polar_segment *s, double *layer)
{
    double level[ELEMENT_MAX_ORDER * 64 + 1];
    graded_levels(s->layers, s->order, s->grading, s->length, level);
    for (int k = 0; k <= s->layers; k++) {
        layer[k] = level[k * s->order];
    }
}

static void model_make(const polar_segment *s, const trial *t, const material *materials, model *m)
{
    CHECK_OK(polar_mesh(s, &m->plane));
    make_layers(s, m->layer);
    m->how = (bar){.plane = &m->plane, .twist = t->twist, .taper = t->taper, .bend = t->bend};
    body_spec spec = {.plane = &m->plane,
                      .materials = materials,
                      .order = s->order,
                      .nlayer = s->layers,
                      .layer = m->layer};
    if (t->twist != 0 || t->taper != 0 || t->bend != 0) {
        spec.shape = (body_shape){.self = &m->how, .place = t->winds ? winding_place : bar_place};
    }
    CHECK_OK(body_make(&spec, &m->b));
    static const load_column weight = {.body_force = {3e3, -2e3, 1e4}};
    m->p = (segment_problem){
        .body = &m->b, .base = t->base, .tip = t->tip, .nextra = 1, .extra = &weight};
}

static double worst_difference(const way_run *a, const way_run *b)
{
    double worst = 0;
    const int top = a->nlevel - 1, n = a->ncolumn;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            const double scale =
                sqrt(b->motion[i * b->nlevel + top].a[i] * b->motion[j * b->nlevel + top].a[j]);
            worst = fmax(worst, fabs(a->motion[i * a->nlevel + top].a[j] -
                                     b->motion[i * b->nlevel + top].a[j]) /
                                    scale);
            worst = fmax(worst, fabs(a->energy.a[i][j] - b->energy.a[i][j]) /
                                    sqrt(b->energy.a[i][i] * b->energy.a[j][j]));
            worst = fmax(worst, fabs(a->work[n * i + j] - b->work[n * i + j]) /
                                    sqrt(b->work[n * i + i] * b->work[n * j + j]));
        }
    }
    // what comes beside the unit wrenches, against its own size
    for (int k = 6 * a->nlevel; k < n * a->nlevel; k++) {
        const vec6 own = b->motion[(k / a->nlevel + 1) * a->nlevel - 1];
        const vec6 off = vec6_sub(a->motion[k], b->motion[k]);
        worst = fmax(worst, sqrt(vec6_dot(off, off) / vec6_dot(own, own)));
    }
    return worst;
}

static void both_ways_agree(const trial *t)
{
    polar_segment s = fig4_segment();
    s.order = 2;
    s.layers = 6;
    material materials[2], all[MATERIALS];
    make_materials(all);
    materials[0] = all[t->material];
    materials[1] = (material){.E = t->contrast * 0.66e6, .nu = 0.3};
    CHECK_OK(material_bind(&materials[1]));
    model m = {0};
    way_run direct = {0}, iterative = {0};
    model_make(&s, t, materials, &m);
    const way_wants wants = {.middle = s.length / 2, .middle_half = s.length / 8};
    CHECK_OK(way_direct(&m.p, &wants, &direct));
    CHECK_OK(way_iterative(&m.p, &wants, &iterative));
    const double worst = worst_difference(&iterative, &direct);
    printf("%-44s %lld dofs, %3d iterations, residual %.1e, from the direct way %.1e\n", t->what,
           iterative.dofs, iterative.iterations, iterative.residual, worst);
    CHECK(iterative.dofs == direct.dofs);
    CHECK_AT_MOST(iterative.iterations, t->most);
    // the energy norm's tolerance, and what a direct solution has of rounding
    CHECK_WITHIN(worst, 0, 1e-9);
    way_run_free(&direct);
    way_run_free(&iterative);
    model_free(&m);
}

// --- with a matrix: what layers do not share, and what holds a body elsewhere than at its base

typedef struct grid_trial {
    const char *what;
    int base, tip, order;
    bool holes, springs, mixed;
    double nu;
    bool shared;
} grid_trial;

// layers that turn their stiff sector and leave elements out
static void make_matter(const polar_segment *s, const mesh *plane, bool holes, int *matter)
{
    const int nelem = plane->block[0].nelem;
    for (int i = 0; i < s->layers * nelem; i++) {
        const int layer = i / nelem, e = i % nelem;
        matter[i] = (e + layer) % nelem < 3;
        matter[i] = holes && layer > 0 && (e + 2 * layer) % 5 == 0 ? -1 : matter[i];
    }
}

static void multigrid_agrees(const grid_trial *t)
{
    static const face_spring wall = {.on = {.face = FACE_OUTSIDE, .from = 5e-3, .to = 9e-3},
                                     .stiffness = {2e7, 1e7, 1e7}};
    static const face_hold end = {.on = {.face = FACE_BASE}, .mask = 1 << 2};
    const material materials[2] = {{.E = 0.66e6, .nu = t->nu}, {.E = 15.93e6, .nu = 0.3}};
    polar_segment s = fig4_segment();
    model m = {0};
    way_run direct = {0}, iterative = {0};
    int *matter = NULL;
    s.order = t->order;
    s.layers = 8;
    s.soft = t->order == 1 ? 24 : 12;
    s.stiff = t->order == 1 ? 4 : 2;
    s.grading = 1;
    CHECK_OK(polar_mesh(&s, &m.plane));
    make_layers(&s, m.layer);
    CHECK_OK(TAKE(matter, (size_t)(s.layers * m.plane.block[0].nelem)));
    make_matter(&s, &m.plane, t->holes, matter);
    const body_spec spec = {.plane = &m.plane,
                            .materials = materials,
                            .order = s.order,
                            .nlayer = s.layers,
                            .layer = m.layer,
                            .matter = t->mixed ? NULL : matter,
                            .mixed = t->mixed};
    CHECK_OK(body_make(&spec, &m.b));
    m.p = (segment_problem){.body = &m.b, .base = t->base, .tip = t->tip};
    if (t->springs) {
        m.p.nspring = m.p.nhold = 1;
        m.p.spring = &wall;
        m.p.hold = &end;
    }
    const way_wants wants = {.middle = s.length / 2, .middle_half = s.length / 8};
    CHECK_OK(way_direct(&m.p, &wants, &direct));
    CHECK_OK(way_iterative(&m.p, &wants, &iterative));
    const double worst = worst_difference(&iterative, &direct);
    printf("%-44s %lld dofs, %3d iterations, residual %.1e, from the direct way %.1e\n", t->what,
           iterative.dofs, iterative.iterations, iterative.residual, worst);
    CHECK(iterative.dofs == direct.dofs);
    CHECK_WITHIN(worst, 0, 1e-7); // the steps' tolerance is 1e-9 of a norm that hides soft motions
    way_run_free(&direct);
    way_run_free(&iterative);
    model_free(&m);
    free(matter);
}

// --- growth

// the proportions of one body, `across` elements through the wall and as much finer elsewhere
static int iterations_of(int across, long long *dofs)
{
    static const trial prism = {.tip = TIP_RIGID};
    static const material materials[2] = {{.E = 0.66e6, .nu = 0.3}, {.E = 15.93e6, .nu = 0.3}};
    polar_segment s = fig4_segment();
    s.order = 2;
    s.radial = across;
    s.soft = 14 * across;
    s.stiff = 2 * across;
    s.layers = 8 * across;
    model m = {0};
    way_run run = {0};
    model_make(&s, &prism, materials, &m);
    const way_wants wants = {.middle = s.length / 2, .middle_half = s.length / 8};
    CHECK_OK(way_iterative(&m.p, &wants, &run));
    const int iterations = run.iterations;
    *dofs = run.dofs;
    way_run_free(&run);
    model_free(&m);
    return iterations;
}

static void iterations_do_not_grow_with_the_mesh(void)
{
    long long few = 0, many = 0;
    const int coarse = iterations_of(1, &few), fine = iterations_of(2, &many);
    printf("%lld unknowns: %d iterations, %lld: %d\n", few, coarse, many, fine);
    CHECK_ABOVE((double)many, 6.0 * (double)few);
    CHECK_AT_MOST(fine, 1.3 * coarse);
}

// layers a thousandth as high as those in the middle
static void grading_does_not_matter(void)
{
    const trial prism = {.tip = TIP_RIGID};
    static const material materials[2] = {{.E = 0.66e6, .nu = 0.3}, {.E = 15.93e6, .nu = 0.3}};
    polar_segment s = fig4_segment();
    int found[2];
    for (int k = 0; k < 2; k++) {
        s.order = 2;
        s.layers = 16;
        s.grading = k ? 1000 : 1;
        model m = {0};
        way_run run = {0};
        model_make(&s, &prism, materials, &m);
        const way_wants wants = {.middle = s.length / 2, .middle_half = s.length / 8};
        CHECK_OK(way_iterative(&m.p, &wants, &run));
        found[k] = run.iterations;
        way_run_free(&run);
        model_free(&m);
    }
    printf("layers alike: %d iterations, graded by 1000: %d\n", found[0], found[1]);
    CHECK_AT_MOST(found[1], 1.3 * found[0]);
}

static const trial trials[] = {
    {.what = "prism, clamped, cap", .tip = TIP_RIGID, .contrast = 24, .most = 30, .shared = true},
    {.what = "prism, clamped, traction", .tip = TIP_E_PROPORTIONAL, .contrast = 24, .most = 36},
    {.what = "prism, free to contract, cap",
     .base = BASE_FREE_TO_CONTRACT,
     .contrast = 24,
     .most = 30},
    {.what = "prism, free to contract, traction",
     .base = BASE_FREE_TO_CONTRACT,
     .tip = TIP_E_PROPORTIONAL,
     .contrast = 24,
     .most = 30,
     .shared = true},
    {.what = "prism, contrast 1e6", .contrast = 1e6, .most = 30},
    {.what = "prism, orthotropic", .material = ORTHOTROPIC, .contrast = 24, .most = 60},
    {.what = "prism, graded along", .material = ALONG, .contrast = 24, .most = 60},
    {.what = "turned by 210 rad/m", .twist = 210, .contrast = 24, .most = 60},
    {.what = "a strip that winds",
     .twist = 210,
     .contrast = 24,
     .most = 60,
     .winds = true,
     .shared = true},
    {.what = "turned, tapered and bent",
     .twist = 100,
     .taper = -10,
     .bend = 20,
     .contrast = 24,
     .most = 60},
    {.what = "the same, orthotropic, traction",
     .tip = TIP_E_PROPORTIONAL,
     .twist = 100,
     .taper = -10,
     .bend = 20,
     .material = ORTHOTROPIC,
     .contrast = 24,
     .most = 60,
     .shared = true},
    {.what = "the same, free to contract",
     .base = BASE_FREE_TO_CONTRACT,
     .twist = 100,
     .taper = -10,
     .bend = 20,
     .contrast = 24,
     .most = 60},
};

static const grid_trial grids[] = {
    {.what = "stack, cap", .order = 1, .nu = 0.3},
    {.what = "stack with holes, cap", .order = 1, .nu = 0.3, .holes = true},
    {.what = "the same, traction",
     .order = 1,
     .nu = 0.3,
     .holes = true,
     .tip = TIP_E_PROPORTIONAL,
     .shared = true},
    {.what = "stack on springs, order 2",
     .order = 2,
     .nu = 0.3,
     .base = BASE_FREE,
     .springs = true,
     .shared = true},
    {.what = "mixed, nu 0.49", .order = 1, .nu = 0.49, .mixed = true, .shared = true},
};

// "shared": those alone in which ranks share something else, in a check's short form
int main(int argc, char **argv)
{
    const bool shared = argc > 1 && strcmp(argv[1], "shared") == 0 && !test_is_long();
    against(BY_SECOND_WAY, "the direct way on the same mesh");
    for (size_t i = 0; i < sizeof trials / sizeof *trials; i++) {
        if (!shared || trials[i].shared) {
            both_ways_agree(&trials[i]);
        }
    }
    for (size_t i = 0; i < sizeof grids / sizeof *grids; i++) {
        if (!shared || grids[i].shared) {
            multigrid_agrees(&grids[i]);
        }
    }
    if (!shared) {
        iterations_do_not_grow_with_the_mesh();
        grading_does_not_matter();
    }
    return test_failures != 0;
}
