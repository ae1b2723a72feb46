// tests/verify/fem/verify_way_direct.c
// The direct way against exact fields: the segment of uniform strain on prisms of hexahedra and
// wedges, and what every solution must obey: equilibrium of resultants, Clapeyron, Betti.
#include "base/beam_law.h"
#include "fem/way.h"
#include "tests/verify/fem/bad_mesh.h"
#include "tests/verify/fem/polar_mesh.h"

typedef struct direct_case {
    column_model m;
    double layer[65];
    body b;
    segment_problem p;
    way_wants wants;
    way_run run;
} direct_case;

static void case_free(direct_case *c)
{
    way_run_free(&c->run);
    body_free(&c->b);
    column_model_free(&c->m);
}

// a body on the model's plane mesh and layers
static void stand(direct_case *c, const material *materials, double turn_rate)
{
    const int p = c->m.plane.order, nlayer = (c->m.nlevel - 1) / p;
    for (int k = 0; k <= nlayer; k++) {
        c->layer[k] = c->m.level[k * p];
    }
    const body_spec spec = {.plane = &c->m.plane,
                            .materials = materials,
                            .order = p,
                            .nlayer = nlayer,
                            .layer = c->layer,
                            .turn_rate = turn_rate};
    CHECK_OK(body_make(&spec, &c->b));
    c->p.body = &c->b;
    c->wants =
        (way_wants){.fields = true, .middle = c->b.length / 2, .middle_half = c->b.length / 8};
}

// quads become two triangles each, order by order
static void split_quads(mesh *m)
{
    mesh t = {0};
    const int p = m->order, nelem = 2 * m->block[0].nelem;
    const shape triangle = SHAPE_TRIANGLE;
    CHECK_OK(mesh_make(p, m->nnode, 1, &triangle, &nelem, &t));
    memcpy(t.xyz, m->xyz, 3 * (size_t)m->nnode * sizeof *t.xyz);
    for (int e = 0; e < nelem; e++) {
        const int *quad = m->block[0].conn + (size_t)(e / 2) * (size_t)((p + 1) * (p + 1));
        int *to = t.block[0].conn + (size_t)e * (size_t)t.block[0].per_elem;
        t.block[0].material[e] = m->block[0].material[e / 2];
        for (int j = 0; j <= p; j++) {
            for (int i = 0; i <= p - j; i++) {
                const int k = i + (p + 1) * j;
                *to++ = e % 2 ? quad[(p + 1) * (p + 1) - 1 - k] : quad[k];
            }
        }
    }
    mesh_free(m);
    *m = t;
}

// |u - exact| over |exact|, after the motion in the plane that nothing determines
static double strain_error(const direct_case *c, const double *wrench, strain e)
{
    const int n = c->m.plane.nnode;
    double size = 0, worst = 0;
    vec6 q = {0};
    for (int pass = 0; pass < 2; pass++) {
        double turn = 0, inertia = 0;
        vec3 mean = {0};
        for (int level = 0; level < c->b.nlevel; level++) {
            for (int i = 0; i < n; i++) {
                double x[3], d[3];
                body_node(&c->b, i, level, x);
                exact_displacement(e, x[0], x[1], x[2], d);
                for (int k = 0; k < 3; k++) {
                    double u = 0;
                    for (int j = 0; j < 6; j++) {
                        u += wrench[j] * way_run_level(&c->run, n, j, level)[3 * i + k];
                    }
                    size = fmax(size, fabs(d[k]));
                    d[k] = u - d[k];
                }
                d[0] -= q.a[0] - q.a[5] * x[1];
                d[1] -= q.a[1] + q.a[5] * x[0];
                for (int k = 0; k < 3; k++) {
                    worst = pass ? fmax(worst, fabs(d[k])) : 0;
                }
                if (level == 0) {
                    mean = vec3_add(mean, (vec3){{d[0] / n, d[1] / n, 0}});
                    turn += x[0] * d[1] - x[1] * d[0];
                    inertia += x[0] * x[0] + x[1] * x[1];
                }
            }
        }
        q = (vec6){{mean.a[0], mean.a[1], 0, 0, 0, turn / inertia}};
    }
    return worst / size;
}

// the prototype's sector with one Poisson's ratio, compressed at its stiffness centre
static void uniform_strain_is_exact(int order, bool wedges)
{
    static const material materials[2] = {{.E = 0.66e6, .nu = 0.4}, {.E = 15.93e6, .nu = 0.4}};
    direct_case c = {0};
    polar_segment s = fig4_segment();
    s.order = order;
    s.layers = 6;
    s.middle = 0.3; // no plane of symmetry that is an axis
    CHECK_OK(polar_mesh(&s, &c.m.plane));
    if (wedges) {
        split_quads(&c.m.plane);
    }
    CHECK_OK(extrude_plainly(s.layers, s.grading, s.length, &c.m));
    stand(&c, materials, 0);
    c.p.base = BASE_FREE_TO_CONTRACT;
    c.p.tip = TIP_E_PROPORTIONAL;
    CHECK_OK(way_direct(&c.p, &c.wants, &c.run));
    // eps = 1 per unit of length: EA, EA y_c, -EA x_c by the mesh's own shape
    const int top = c.run.nlevel - 1;
    mat6 F = {0}, K = {0};
    for (int j = 0; j < 6; j++) {
        for (int i = 0; i < 6; i++) {
            F.a[i][j] = c.run.motion[j * c.run.nlevel + top].a[i] / c.b.length;
        }
    }
    CHECK(mat6_inverse_spd(mat6_symmetric(F), &K));
    double wrench[6] = {0};
    for (int i = 2; i < 5; i++) {
        wrench[i] = -0.02 * K.a[i][NZ];
    }
    const double error = strain_error(&c, wrench, (strain){.a = -0.02});
    printf("order %d, %s: uniform strain to %.1e\n", order, wedges ? "wedges" : "hexahedra", error);
    CHECK_WITHIN(error, 0, 1e-11);
    case_free(&c);
}

// --- what any solution obeys

// wrench of column j on the section at a height, by statics alone
static vec6 wrench_at(const direct_case *c, int j, double z)
{
    vec6 w = {0};
    w.a[j] = 1;
    const double arm = c->b.length - z;
    w.a[MX] += j == NY ? -arm : 0;
    w.a[MY] += j == NX ? arm : 0;
    return w;
}

static void resultants_balance(const direct_case *c)
{
    double worst = 0;
    for (int j = 0; j < 6; j++) {
        for (int k = 0; k < c->run.nlevel; k++) {
            const vec6 d =
                vec6_sub(c->run.resultant[j * c->run.nlevel + k], wrench_at(c, j, c->run.z[k]));
            for (int i = 0; i < 6; i++) {
                const double size = (i < 3 ? 1 : c->b.radius) / (j < 3 ? 1 : c->b.radius);
                worst = fmax(worst, fabs(d.a[i]) / size);
            }
        }
    }
    printf("  resultants miss the load by %.1e\n", worst);
    CHECK_WITHIN(worst, 0, 1e-8); // stresses out of differences of displacements
}

// work is symmetric, and with wrenches at the tip it is the tip's motion
static void work_is_the_tips_motion(const direct_case *c)
{
    const int n = c->run.ncolumn, top = c->run.nlevel - 1;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            const double scale = sqrt(c->run.work[i * n + i] * c->run.work[j * n + j]);
            CHECK_WITHIN(c->run.work[i * n + j], c->run.work[j * n + i], 1e-10 * scale);
            CHECK_WITHIN(c->run.work[i * n + j], c->run.motion[j * c->run.nlevel + top].a[i],
                         1e-9 * scale);
        }
    }
}

// the whole length as window: twice the energy of wrenches at the tip is their work
static void energy_of_the_whole_is_the_work(direct_case *c)
{
    const double L = c->b.length;
    c->wants = (way_wants){.middle = L / 2, .middle_half = L / 2};
    way_run_free(&c->run);
    CHECK_OK(way_direct(&c->p, &c->wants, &c->run));
    mat6 T = mat6_identity(); // column j: wrenches at the middle that are unit wrenches at the tip
    T.a[MX][NY] = -L / 2;
    T.a[MY][NX] = L / 2;
    const mat6 U = mat6_congruence(T, c->run.energy);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            const double *w = c->run.work;
            const int n = c->run.ncolumn;
            CHECK_WITHIN(U.a[i][j], w[i * n + j], 1e-9 * sqrt(w[i * n + i] * w[j * n + j]));
        }
    }
}

static void solutions_obey_statics(int base, int tip, double turn_rate)
{
    static const material materials[2] = {{.E = 0.66e6, .nu = 0.3}, {.E = 15.93e6, .nu = 0.45}};
    direct_case c = {0};
    polar_segment s = fig4_segment();
    s.order = 2;
    CHECK_OK(polar_model(&s, materials, base, tip, &c.m));
    stand(&c, materials, turn_rate);
    c.p.base = base;
    c.p.tip = tip;
    CHECK_OK(way_direct(&c.p, &c.wants, &c.run));
    printf("base %d, tip %d, turning by %g rad: residual %.1e\n", base, tip, turn_rate * c.b.length,
           c.run.residual);
    resultants_balance(&c);
    work_is_the_tips_motion(&c);
    energy_of_the_whole_is_the_work(&c);
    case_free(&c);
}

int main(void)
{
    against(BY_CLOSED_FORM, "uniform strain; equilibrium, Clapeyron, Betti");
    for (int order = 1; order <= ELEMENT_MAX_ORDER; order++) {
        uniform_strain_is_exact(order, false);
        uniform_strain_is_exact(order, true);
    }
    solutions_obey_statics(BASE_CLAMPED, TIP_RIGID, 0);
    solutions_obey_statics(BASE_CLAMPED, TIP_E_PROPORTIONAL, 100);
    solutions_obey_statics(BASE_FREE_TO_CONTRACT, TIP_RIGID, 100);
    return test_failures != 0;
}
