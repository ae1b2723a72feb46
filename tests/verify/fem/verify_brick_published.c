// Published benchmarks: NAFEMS LE1, LE10 and LE11 (The Standard NAFEMS Benchmarks, 1990), and the
// twisted beam of MacNeal and Harder (Finite Elements in Analysis and Design 1, 1985).
#include "tests/body_solve.h"
#include "tests/grid_mesh.h"

static const double PI = 3.14159265358979323846;

static void show(const char *what, double wanted, double ours, double tolerance)
{
    about("%s", what);
    printf("%-52s published %12.6g, ours %12.6g, ratio %.4f\n", what, wanted, ours, ours / wanted);
    CHECK_NEAR(ours, wanted, tolerance);
}

static bool near(double a, double b)
{
    return fabs(a - b) < 1e-6;
}

static bool on_x0(const double *x)
{
    return near(x[0], 0);
}

static bool on_y0(const double *x)
{
    return near(x[1], 0);
}

static bool on_z0(const double *x)
{
    return near(x[2], 0);
}

typedef struct model {
    mesh plane;
    body body;
    equations s;
} model;

static void model_make(const grid *g, body_spec spec, model *m)
{
    *m = (model){0};
    grid_make(g, &m->plane);
    spec.plane = &m->plane;
    if (spec.shape.place) {
        spec.shape.self = &m->plane;
    }
    CHECK_OK(body_make(&spec, &m->body));
    equations_make(&m->body, &m->s);
    assemble(&m->s);
}

static void model_free(model *m)
{
    equations_free(&m->s);
    body_free(&m->body);
    mesh_free(&m->plane);
}

// --- LE1 and LE10: a quarter of an elliptic plate with an elliptic hole [m, MPa]

// elements become smaller towards D, where the stress is steepest
static void ellipses(const double *from, double *to)
{
    const double u = from[0] * (0.5 + 0.5 * from[0]);
    const double t = PI / 2 * from[1] * (0.5 + 0.5 * from[1]), c = cos(t), s = sin(t);
    to[0] = (1 - u) * 2 * c + u * 3.25 * c;
    to[1] = (1 - u) * s + u * 2.75 * s;
}

static bool on_outer(const double *x)
{
    return near(pow(x[0] / 3.25, 2) + pow(x[1] / 2.75, 2), 1);
}

static bool on_outer_middle(const double *x)
{
    return on_outer(x) && near(x[2], 0.3);
}

static const material steel = {.E = 210e3, .nu = 0.3};

static void elliptic_membrane(bool triangles)
{
    model m;
    const grid g = {4, 5, 4, triangles, NULL, ellipses};
    // thin, and u_z linear through the thickness: plane stress
    const double layer[2] = {0, 0.01}, D[3] = {2, 0, 0};
    model_make(&g, (body_spec){.materials = &steel, .order = 1, .nlayer = 1, .layer = layer}, &m);
    hold_where(&m.s, on_x0, 0);
    hold_where(&m.s, on_y0, 1);
    hold_where(&m.s, on_z0, 2);
    partial_load pull = {.s = &m.s, .where = on_outer, .pressure = -10};
    load_where(&pull, FACE_OUTSIDE);
    solve(&m.s);
    show(triangles ? "LE1 sigma_yy at D [MPa], prisms" : "LE1 sigma_yy at D [MPa], hexahedra", 92.7,
         stress_near(&m.s, D).stress[1], 2e-3);
    model_free(&m);
}

static void elliptic_plate(bool triangles, bool mixed)
{
    model m;
    char name[64];
    const grid g = {3, 4, 4, triangles, NULL, ellipses};
    const double layer[4] = {0, 0.3, 0.5, 0.6}, D[3] = {2, 0, 0.6};
    model_make(
        &g,
        (body_spec){.materials = &steel, .order = 3, .nlayer = 3, .layer = layer, .mixed = mixed},
        &m);
    hold_where(&m.s, on_x0, 0);
    hold_where(&m.s, on_y0, 1);
    hold_where(&m.s, on_outer, 0);
    hold_where(&m.s, on_outer, 1);
    hold_where(&m.s, on_outer_middle, 2);
    const face_pressure press = {.on = {FACE_TIP, 0, 0}, .pressure = 1};
    CHECK_OK(face_add_load(&m.body, &press, 0, 3, m.s.f));
    solve(&m.s);
    snprintf(name, sizeof name, "LE10 sigma_yy at D [MPa], %s%s",
             triangles ? "prisms" : "hexahedra", mixed ? ", mixed" : "");
    show(name, -5.38, stress_near(&m.s, D).stress[1], mixed ? 1.5e-2 : 6e-3);
    model_free(&m);
}

// --- LE11: a body of revolution, sphere below, taper, cylinder above; T = r + z

static const double SPHERE = 0.70710678118654752, TAPER = 1.39710678118654752,
                    TOP = 1.79710678118654752;
static const double EXPANSION = 2.3e-4;

// meridian: u from the inside out, v up through the three parts
static void meridian(const double *from, double *to)
{
    const double u = from[0], v = 8 * from[1], rim = sqrt(1.4 * 1.4 - SPHERE * SPHERE);
    if (v <= 3) {
        const double a = PI / 4 * v / 3, b = asin(SPHERE / 1.4) * v / 3;
        to[0] = (1 - u) * cos(a) + u * 1.4 * cos(b);
        to[1] = (1 - u) * sin(a) + u * 1.4 * sin(b);
    } else if (v <= 6) {
        const double t = (v - 3) / 3;
        to[0] = (1 - u) * SPHERE + u * (rim + (1 - rim) * t);
        to[1] = SPHERE + (TAPER - SPHERE) * t;
    } else {
        to[0] = (1 - u) * SPHERE + u;
        to[1] = TAPER + (TOP - TAPER) * (v - 6) / 2;
    }
}

// x of the section is the radius, y is z, so that it is swept from y = 0 towards y < 0
static status revolve(const void *self, double s, double *xyz, mat3 *axes, double origin[3])
{
    const mesh *plane = (const mesh *)self;
    const double c = cos(s), d = -sin(s);
    *axes = (mat3){{{c, 0, d}, {d, 0, -c}, {0, 1, 0}}};
    memset(origin, 0, 3 * sizeof *origin);
    for (int i = 0; i < plane->nnode; i++) {
        const double *from = plane->xyz + 3 * (size_t)i;
        xyz[3 * i] = from[0] * c;
        xyz[3 * i + 1] = from[0] * d;
        xyz[3 * i + 2] = from[1];
    }
    return OK;
}

static bool on_top(const double *x)
{
    return near(x[2], TOP);
}

static double free_stress(const double *x) // of a free expansion by T, all held
{
    return steel.E / (1 - 2 * steel.nu) * EXPANSION * (hypot(x[0], x[1]) + x[2]);
}

static void add_expansion(brick *w, int layer, void *self)
{
    const equations *s = (const equations *)self;
    int number[BRICK_MAX_DOFS];
    CHECK_OK(brick_geometry(w, layer));
    brick_places(w);
    element_unknowns(w, layer, number);
    for (int q = 0; q < w->nq; q++) {
        const double p = w->dV[q] * free_stress(w->place[q]);
        const double *g = w->grad + 3 * (size_t)q * (size_t)w->n;
        for (int i = 0; i < 3 * w->n; i++) {
            s->f[number[i]] += p * g[i % 3 * w->n + i / 3];
        }
    }
}

static void heated_body(bool triangles)
{
    model m;
    const double layer[3] = {0, PI / 4, PI / 2}, A[3] = {1, 0, 0};
    const grid g = {2, 8, 3, triangles, NULL, meridian};
    model_make(&g,
               (body_spec){.materials = &steel,
                           .order = 4,
                           .nlayer = 2,
                           .layer = layer,
                           .shape = {.place = revolve}},
               &m);
    hold_where(&m.s, on_x0, 0);
    hold_where(&m.s, on_y0, 1);
    hold_where(&m.s, on_z0, 2);
    hold_where(&m.s, on_top, 2);
    each_element(&m.body, add_expansion, &m.s);
    solve(&m.s);
    // z is the section's y
    show(triangles ? "LE11 sigma_zz at A [MPa], prisms" : "LE11 sigma_zz at A [MPa], hexahedra",
         -105, stress_near(&m.s, A).stress[1] - free_stress(A), 6e-3);
    model_free(&m);
}

// --- the twisted beam: 12 long, 1.1 x 0.32, turning by a quarter [in, psi]

static void strip(const double *from, double *to)
{
    to[0] = 1.1 * (from[0] - 0.5);
    to[1] = 0.32 * (from[1] - 0.5);
}

static void twisted_beam(bool triangles, int order, int layers)
{
    static const material metal = {.E = 29e6, .nu = 0.22};
    static const char *const names[2] = {"out of the tip's plane", "in the tip's plane"};
    static const double wanted[2] = {0.001754, 0.005424};
    for (int d = 0; d < 2; d++) {
        model m;
        char name[80];
        double layer[16], u[3];
        const grid g = {2, 1, order, triangles, NULL, strip};
        for (int k = 0; k <= layers; k++) {
            layer[k] = 12.0 * k / layers;
        }
        model_make(&g,
                   (body_spec){.materials = &metal,
                               .order = order,
                               .nlayer = layers,
                               .layer = layer,
                               .turn_rate = PI / 2 / 12},
                   &m);
        for (int k = 0; k < 3; k++) {
            hold_where(&m.s, on_z0, k);
        }
        face_pressure shear = {.on = {FACE_TIP, 0, 0}};
        shear.traction[d] = 1 / (1.1 * 0.32);
        CHECK_OK(face_add_load(&m.body, &shear, 0, layers, m.s.f));
        solve(&m.s);
        displacement_at(&m.s, (const double[3]){0, 0, 12}, u);
        snprintf(name, sizeof name, "twisted beam %s [in], %s, p = %d", names[d],
                 triangles ? "prisms" : "hexahedra", order);
        // the published values are a beam's
        show(name, wanted[d], u[d], 6e-3);
        model_free(&m);
    }
}

int main(void)
{
    against(BY_PUBLISHED, "NAFEMS LE1, LE10, LE11 (The Standard NAFEMS Benchmarks, 1990); MacNeal "
                          "and Harder, Finite Elem. Anal. Des. 1 (1985)");
    elliptic_membrane(false);
    elliptic_membrane(true);
    elliptic_plate(false, false);
    elliptic_plate(true, false);
    elliptic_plate(false, true);
    heated_body(false);
    heated_body(true);
    twisted_beam(false, 2, 12);
    twisted_beam(false, 4, 4);
    twisted_beam(true, 3, 6);
    return test_failures != 0;
}
