// fem/section_law.c
// The law of the section by strain energy, docs/theory.md (5.5).
#include "fem/section_law.h"

#include "base/memory.h"

#include <math.h>

// Half width of the window over which the energy is averaged, over the section's radius: it only
// smooths what the mesh does within a layer.
static const double WINDOW = 0.5;

typedef struct window {
    double centre, half; // [m]
} window;

// wrench at a distance below the tip from the tip's: m + distance e_z x n
static mat6 transport(double distance)
{
    mat6 T = mat6_identity();
    T.a[MX][NY] = -distance;
    T.a[MY][NX] = distance;
    return T;
}

// What is left of the six solutions near a height z, once they are combined to unit wrenches there
// and the motion of the section there is taken away: the energy would lose as many digits as the
// motion is larger than the strains.
typedef struct local_solutions {
    const column *c;
    const segment_run *run;
    mat6 combine;   // column j: coefficients of the tip's unit solutions
    vec6 motion[6]; // of the combined ones at `level`
    int level;
} local_solutions;

static local_solutions solutions_near(const column *c, const segment_run *run, double z)
{
    local_solutions s = {.c = c, .run = run};
    s.combine = transport(z - c->level[c->nlevel - 1]);
    while (s.level < c->nlevel - 1 && c->level[s.level] < z) {
        s.level++;
    }
    for (int j = 0; j < 6; j++) {
        for (int k = 0; k < 6; k++) {
            const vec6 q = run->motion[k * c->nlevel + s.level];
            s.motion[j] = vec6_add(s.motion[j], vec6_scale(s.combine.a[k][j], q));
        }
    }
    return s;
}

// nodal values of combined solution j in one element, in its lattice order
static void gather(const local_solutions *s, int j, const int *conn, int n, int layer, double *u)
{
    const int p = s->c->order;
    const double *q = s->motion[j].a;
    for (int k = layer * p; k <= (layer + 1) * p; k++) {
        const double dz = s->c->level[k] - s->c->level[s->level];
        for (int a = 0; a < n; a++, u += 3) {
            const double *x = s->c->plane->xyz + 3 * (size_t)conn[a];
            u[0] = -(q[0] + q[4] * dz - q[5] * x[1]);
            u[1] = -(q[1] + q[5] * x[0] - q[3] * dz);
            u[2] = -(q[2] + q[3] * x[1] - q[4] * x[0]);
            for (int i = 0; i < 6; i++) {
                const double *from = segment_run_level(s->run, i, k) + 3 * (size_t)conn[a];
                for (int d = 0; d < 3; d++) {
                    u[d] += s->combine.a[i][j] * from[d];
                }
            }
        }
    }
}

enum { ELEMENT_DOFS = 3 * ELEMENT_MAX_NODES };

typedef struct energy_work {
    plane_matrices plane;
    double K[ELEMENT_DOFS * ELEMENT_DOFS];
    double u[6][ELEMENT_DOFS];
} energy_work;

static void add_energy(energy_work *work, int n, mat6 *U)
{
    for (int r = 0; r < n; r++) {
        double f[6] = {0};
        const double *row = work->K + (size_t)r * (size_t)n;
        for (int j = 0; j < 6; j++) {
            for (int s = 0; s < n; s++) {
                f[j] += row[s] * work->u[j][s];
            }
        }
        for (int i = 0; i < 6; i++) {
            for (int j = 0; j < 6; j++) {
                U->a[i][j] += work->u[i][r] * f[j];
            }
        }
    }
}

// U[i][j] = int eps_i^T Q eps_j over the window, for unit wrenches at its middle
static status window_energy(const column *c, const segment_run *run, window w, mat6 *U)
{
    status st = OK;
    const local_solutions near = solutions_near(c, run, w.centre);
    energy_work *work = NULL;
    const int p = c->order;
    TRY(TAKE(work, 1));
    for (int b = 0; b < c->plane->nblock; b++) {
        const mesh_block *k = &c->plane->block[b];
        for (int e = 0; e < k->nelem; e++) {
            const int *conn = k->conn + (size_t)e * (size_t)k->per_elem, n = k->per_elem;
            TRY(plane_matrices_make(c, b, e, &work->plane));
            for (int layer = 0; layer < c->nlayer; layer++) {
                const line_matrices line =
                    line_matrices_make(c, layer, w.centre - w.half, w.centre + w.half);
                if (line.M[0][0] == 0) {
                    continue;
                }
                element_stiffness(&work->plane, &line, p, work->K);
                for (int j = 0; j < 6; j++) {
                    gather(&near, j, conn, n, layer, work->u[j]);
                }
                add_energy(work, 3 * n * (p + 1), U);
            }
        }
    }

done:
    free(work);
    return st;
}

// energy of unit wrenches at the middle of the window, without what their moment's change within it
// adds. docs/theory.md (5.5): U / 2h = F + h^2/3 D^T F D with D n = e_z x n
static mat6 compliance_of_energy(mat6 U, window w)
{
    mat6 F = mat6_scale(1 / (2 * w.half), U);
    const double spread = w.half * w.half / 3;
    F.a[NX][NX] -= spread * F.a[MY][MY];
    F.a[NY][NY] -= spread * F.a[MX][MX];
    F.a[NX][NY] += spread * F.a[MY][MX];
    F.a[NY][NX] += spread * F.a[MX][MY];
    return mat6_symmetric(F);
}

status section_law_at(const column *c, const segment_run *run, double z, beam_law *out)
{
    status st = OK;
    mat6 U = {0};
    const double begin = c->level[0], tip = c->level[c->nlevel - 1];
    const double room = fmin(z - begin, tip - z);
    const window w = {.centre = z, .half = fmin(WINDOW * c->radius, room / 2)};

    TRY(window_energy(c, run, w, &U));
    *out = (beam_law){.area = run->by_area.weight};
    if (!mat6_inverse_spd(compliance_of_energy(U, w), &out->K)) {
        TRY(status_fail(ERR_NUMERIC, "segment: the energy at %g m gives no positive definite law",
                        z));
    }

done:
    return st;
}

// --- a column long enough that nothing of its ends reaches the middle

// Length over the section's radius, and the height of the first layer, from which they
// double. Along z the middle is a cubic at most, which elements of order 3 hold however long they
// are; the ends' layers need only die out.
static const double LONG = 32;
static const double FIRST_LAYER = 1;
enum { LONG_ORDER = 3 };

static double doubling_height(int layer, int nlayer)
{
    return pow(2, layer < nlayer - 1 - layer ? layer : nlayer - 1 - layer);
}

static status long_column(const mesh *plane, const material *materials, column *out)
{
    status st = OK;
    double *level = NULL, z = 0, node[LONG_ORDER + 1];
    const int p = LONG_ORDER;
    const double radius = column_section_radius(plane), length = LONG * radius;
    const int half = (int)ceil(log2(1 + length / 2 / (FIRST_LAYER * radius)));
    const double unit = length / 2 / (pow(2, half) - 1);
    const int nlayer = 2 * half;
    TRY(TAKE(level, (size_t)(nlayer * p + 1)));
    gauss_lobatto_nodes(p + 1, node);
    for (int layer = 0; layer < nlayer; layer++) {
        const double height = unit * doubling_height(layer, nlayer);
        for (int k = 0; k <= p; k++) {
            level[layer * p + k] = z + height * (node[k] + 1) / 2;
        }
        z += height;
    }
    TRY(column_make(plane, materials, p, nlayer * p + 1, level, out));

done:
    free(level);
    return st;
}

status section_law_solve(const petsc_door *door, const mesh *plane, const material *materials,
                         double *end_effect, beam_law *out)
{
    status st = OK;
    column c = {0};
    segment_run run = {0};
    beam_law aside = {0};

    TRY(long_column(plane, materials, &c));
    TRY(segment_run_make(door, &c, BASE_CLAMPED, TIP_RIGID, &run));
    TRY(section_law_at(&c, &run, c.length / 2, out));
    TRY(section_law_at(&c, &run, c.length / 4, &aside));
    *end_effect = mat6_relative_error(aside.K, out->K);

done:
    segment_run_free(&run);
    column_free(&c);
    return st;
}
