// fem/segment.c
#include "fem/segment.h"

#include "base/memory.h"
#include "fem/section_law.h"

#include <math.h>
#include <string.h>

// a point this near to the centroid, over the section's radius, is the centroid: rounding and the
// mesh's own geometry
static const double CENTROID_TOLERANCE = 1e-4;

void segment_result_free(segment_result *r)
{
    for (int i = 0; r->load && i < r->nload; i++) {
        free(r->load[i].displacement);
        free(r->load[i].stress);
        free(r->load[i].slice);
    }
    free(r->load);
    segment_body_free(&r->body);
    *r = (segment_result){0};
}

int segment_rank(void)
{
    const char *rank = getenv("OMPI_COMM_WORLD_RANK");
    return rank ? (int)strtol(rank, NULL, 10) : 0;
}

// --- one load from the unit solutions

typedef struct combination {
    int n;
    double c[9]; // of the run's solutions
} combination;

static status uniform_combination(const segment_run *run, double radius, const segment_load *load,
                                  const double *point, combination *out)
{
    const double *centroid = run->by_area.centroid;
    const double away = hypot(point[0] - centroid[0], point[1] - centroid[1]);
    if ((point[0] != 0 || point[1] != 0) && away > CENTROID_TOLERANCE * radius) {
        return status_fail(ERR_INPUT,
                           "load '%s': a uniform traction acts at the area's centroid (%.6g, %.6g) "
                           "mm, not at (%.6g, %.6g) mm",
                           load->name, 1e3 * centroid[0], 1e3 * centroid[1], 1e3 * point[0],
                           1e3 * point[1]);
    }
    if (load->moment[0] != 0 || load->moment[1] != 0 || load->moment[2] != 0) {
        return status_fail(ERR_INPUT, "load '%s': a uniform traction has no moment", load->name);
    }
    *out = (combination){.n = 9};
    memcpy(out->c + 6, load->force, sizeof load->force);
    return OK;
}

// the wrench about the origin
static combination wrench_combination(const segment_load *load, const double *point)
{
    const double *f = load->force, *m = load->moment, x = point[0], y = point[1];
    return (combination){
        .n = 6,
        .c = {f[0], f[1], f[2], m[0] + y * f[2], m[1] - x * f[2], m[2] + x * f[1] - y * f[0]}};
}

static double energy(const segment_run *run, const combination *k)
{
    double twice = 0;
    if (k->n == 6) {
        const mat6 C = segment_run_compliance(run);
        for (int i = 0; i < 6; i++) {
            for (int j = 0; j < 6; j++) {
                twice += k->c[i] * C.a[i][j] * k->c[j];
            }
        }
        return twice / 2;
    }
    double work[3][3];
    segment_run_uniform_work(run, work);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            twice += k->c[6 + i] * work[i][j] * k->c[6 + j];
        }
    }
    return twice / 2;
}

static status keep_displacement(const segment_run *run, const combination *k, double **out)
{
    status st = OK;
    const size_t all = 3 * (size_t)run->nplane * (size_t)run->nlevel;
    TRY(TAKE(*out, all));
    for (int j = 0; j < k->n; j++) {
        for (size_t i = 0; k->c[j] != 0 && i < all; i++) {
            (*out)[i] += k->c[j] * run->u[(size_t)j * all + i];
        }
    }

done:
    return st;
}

static void fill_load(const segment_run *run, const middle *mid, const combination *k,
                      segment_load_result *out)
{
    vec6 q = {0};
    for (int j = 0; j < k->n; j++) {
        q = vec6_add(q, vec6_scale(k->c[j], run->motion[(j + 1) * run->nlevel - 1]));
        out->mid_curvature[0] += k->c[j] * mid->curvature[j][0];
        out->mid_curvature[1] += k->c[j] * mid->curvature[j][1];
    }
    const double *centre = run->by_E.centroid;
    out->shortening = -(q.a[NZ] + q.a[MX] * centre[1] - q.a[MY] * centre[0]);
    memcpy(out->tip_displacement, q.a, 3 * sizeof *q.a);
    memcpy(out->tip_rotation, q.a + 3, 3 * sizeof *q.a);
    out->strain_energy = energy(run, k);
}

// --- the whole

typedef struct load_list {
    int count;
    const segment_load *items;
    const double (*point)[2];
    int keep, tip;
} load_list;

static status solve_loads(const segment_run *run, const middle *mid, double radius,
                          const load_list *loads, segment_result *r)
{
    status st = OK;
    TRY(TAKE(r->load, (size_t)loads->count));
    r->nload = loads->count;
    for (int i = 0; i < loads->count; i++) {
        const segment_load *load = &loads->items[i];
        const bool uniform = loads->tip == TIP_UNIFORM;
        combination k = wrench_combination(load, loads->point[i]);
        if (uniform) {
            TRY(uniform_combination(run, radius, load, loads->point[i], &k));
        }
        r->load[i].name = load->name;
        memcpy(r->load[i].force, load->force, sizeof load->force);
        memcpy(r->load[i].moment, load->moment, sizeof load->moment);
        memcpy(r->load[i].point, uniform ? run->by_area.centroid : loads->point[i],
               sizeof r->load[i].point);
        fill_load(run, mid, &k, &r->load[i]);
        if (loads->keep) {
            TRY(keep_displacement(run, &k, &r->load[i].displacement));
        }
    }

done:
    return st;
}

// the point at which an axial force leaves the tip unturned: C's own equation (5.4)
static status tip_centre(mat6 C, double *centre)
{
    const double det = C.a[MX][MX] * C.a[MY][MY] - C.a[MX][MY] * C.a[MY][MX];
    if (!(det > 0)) {
        return status_fail(ERR_NUMERIC, "segment: end moments do not turn the tip");
    }
    centre[0] = (C.a[MY][NZ] * C.a[MX][MX] - C.a[MX][NZ] * C.a[MY][MX]) / det;
    centre[1] = (C.a[MY][NZ] * C.a[MX][MY] - C.a[MX][NZ] * C.a[MY][MY]) / det;
    return OK;
}

static double middle_height(const column *c)
{
    return c->level[0] + c->length / 2;
}

// the order below, where there is one whose elements are sound: *lower.nlevel stays 0 otherwise
static status lower_column(const column *c, mesh *plane, column *lower)
{
    status st = OK;
    double jacobian = 0;
    if (c->order > 1) {
        TRY(column_lower(c, c->order - 1, plane, lower));
        TRY(mesh_min_jacobian(plane, &jacobian));
    }
    if (!(jacobian > 0)) {
        column_free(lower);
    }

done:
    return st;
}

// one order lower: what changes is taken for the error, 1 (nothing known) where there is none.
// docs/theory.md (5.9)
static status estimate_error(const petsc_door *door, const column *c, const segment_case *sc,
                             segment_result *r)
{
    status st = OK;
    mesh plane = {0};
    column lower = {0};
    segment_run run = {0};
    beam_law law = {0};

    r->relative_error = r->middle.relative_error = 1;
    TRY(lower_column(c, &plane, &lower));
    if (lower.nlevel > 0) {
        TRY(segment_run_make(door, &lower, sc->base, sc->tip, &run));
        r->relative_error = mat6_relative_error(segment_run_compliance(&run), r->tip_compliance);
        TRY(section_law_at(&lower, &run, middle_height(&lower), &law));
        r->middle.relative_error = mat6_relative_error(law.K, r->middle.K);
    }

done:
    segment_run_free(&run);
    column_free(&lower);
    mesh_free(&plane);
    return st;
}

// z of the levels: layers grow geometrically from both ends
static void fill_levels(const segment_case *c, double *level)
{
    double node[ELEMENT_MAX_ORDER + 1], total = 0;
    const int most = (c->layers - 1) / 2;
    gauss_lobatto_nodes(c->order + 1, node);
    for (int pass = 0; pass < 2; pass++) {
        double z = 0;
        for (int i = 0; i < c->layers; i++) {
            const int step = i < c->layers - 1 - i ? i : c->layers - 1 - i;
            const double h = most ? pow(c->grading, (double)step / most) : 1;
            for (int k = 0; pass && k <= c->order; k++) {
                level[i * c->order + k] = (z + h * (node[k] + 1) / 2) * c->length / total;
            }
            z += h;
        }
        total = z;
    }
}

static status make_meshes(const segment_case *c, const segment_source *source, segment_result *r)
{
    status st = OK;
    const segment_mesh ask = {.order = c->order, .size = c->size};
    TRY(source->plane(source->self, &ask, &r->body.plane));
    TRY(segment_check_size(c, r->body.plane.nnode));
    segment_body *b = &r->body;
    b->order = c->order;
    b->nlayer = c->layers;
    b->last = b->nlevel = c->layers * c->order + 1;
    TRY(TAKE(b->level, (size_t)b->nlevel));
    fill_levels(c, b->level);
    TRY(TAKE(b->node, 3 * (size_t)b->nlevel * (size_t)b->plane.nnode));
    for (int i = 0; i < b->nlevel * b->plane.nnode; i++) {
        const double *from = b->plane.xyz + 3 * (size_t)(i % b->plane.nnode);
        memcpy(b->node + 3 * (size_t)i, from, 2 * sizeof *from);
        b->node[3 * (size_t)i + 2] = b->level[i / b->plane.nnode];
    }

done:
    return st;
}

static status solve_column(const petsc_door *door, const segment_case *c, const column *col,
                           const load_list *list, segment_result *r)
{
    status st = OK;
    segment_run run = {0};
    middle mid = {0};
    TRY(segment_run_make(door, col, c->base, c->tip, &run));
    TRY(middle_make(col, &run, &mid));
    r->dofs = run.dofs;
    memcpy(r->stiffness_centre, mid.stiffness_centre, sizeof r->stiffness_centre);
    r->tip_compliance = segment_run_compliance(&run);
    TRY(tip_centre(r->tip_compliance, r->tip_centre));
    r->residual = run.residual;
    r->assemble_seconds = run.assemble_seconds;
    r->factor_seconds = run.factor_seconds;
    r->solve_seconds = run.solve_seconds;
    TRY(section_law_at(col, &run, middle_height(col), &r->middle));
    TRY(solve_loads(&run, &mid, col->radius, list, r));
    TRY(estimate_error(door, col, c, r));

done:
    segment_run_free(&run);
    return st;
}

status segment_solve(const segment_case *given, const segment_source *source,
                     const double (*point)[2], int keep_fields, segment_result *out)
{
    status st = OK;
    const petsc_door *door = NULL;
    column col = {0};
    segment_result r = {0};
    const segment_case c = segment_choose(given, source->radius);
    const load_list list = {.count = c.loads.count,
                            .items = c.loads.items,
                            .point = point,
                            .keep = keep_fields,
                            .tip = c.tip};

    TRY(make_meshes(&c, source, &r));
    TRY(column_make(&r.body.plane, source->materials, c.order, r.body.nlevel, r.body.level, &col));
    TRY(petsc_door_open(&door));
    TRY(solve_column(door, &c, &col, &list, &r));
    *out = r;
    r = (segment_result){0};

done:
    segment_result_free(&r);
    column_free(&col);
    return st;
}

status segment_section_law(const mesh *plane, const material *materials, beam_law *out)
{
    status st = OK;
    const petsc_door *door = NULL;
    mesh lower = {0};
    beam_law law = {0}, lower_law = {0};
    double end_effect = 0, jacobian = 0, unused = 0;

    TRY(petsc_door_open(&door));
    TRY(section_law_solve(door, plane, materials, &end_effect, &law));
    law.relative_error = 1;
    if (plane->order > 1) {
        TRY(mesh_of_order(plane, plane->order - 1, &lower));
        TRY(mesh_min_jacobian(&lower, &jacobian));
    }
    if (jacobian > 0) {
        TRY(section_law_solve(door, &lower, materials, &unused, &lower_law));
        law.relative_error = fmax(end_effect, mat6_relative_error(lower_law.K, law.K));
    }
    *out = law;

done:
    mesh_free(&lower);
    return st;
}
