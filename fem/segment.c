// fem/segment.c
// Rung by rung: a mesh, a body, the cheapest way to solve it, what follows from the solution, and
// how far that is from the rung below.
#include "fem/segment.h"

#include "base/memory.h"
#include "fem/after.h"
#include "fem/blas.h"
#include "fem/doubling_plan.h"
#include "fem/rungs.h"
#include "fem/segment_plan.h"
#include "fem/segment_problem.h"
#include "fem/segment_way.h"

#include <math.h>
#include <string.h>

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

// what stays the same on every rung
typedef struct climb {
    const segment_case *c;
    const segment_source *source;
    const double (*point)[2];
    problem_parts parts;
} climb;

// --- one rung

typedef struct rung {
    segment_plan plan;
    mesh plane;
    body_spec spec;
    bool has_course;
    body body;
} rung;

static void rung_free(const climb *k, rung *r)
{
    body_free(&r->body);
    if (r->has_course && k->source->release) {
        k->source->release(k->source->self, &r->spec);
    }
    mesh_free(&r->plane);
    segment_plan_free(&r->plan);
    *r = (rung){0};
}

// above this Poisson's ratio displacements alone lock, or lose digits of the pressure
static const double MIXED_FROM = 0.45;

static bool is_mixed(const climb *k)
{
    return k->c->mixed == MIXED_YES || (k->c->mixed == MIXED_AUTO && k->source->nu > MIXED_FROM);
}

static status rung_make(const climb *k, int number, rung *r)
{
    status st = OK;
    const segment_source *source = k->source;
    TRY(segment_plan_make(k->c, source, number, &r->plan));
    TRY(source->plane(source->self, &r->plan.mesh, &r->plane));
    r->spec = (body_spec){.plane = &r->plane,
                          .materials = source->materials,
                          .order = r->plan.order,
                          .nlayer = r->plan.nlayer,
                          .layer = r->plan.layer,
                          .mixed = is_mixed(k)};
    if (source->course && k->c->course == COURSE_ALONG) {
        TRY(source->course(source->self, &r->plane, &r->spec));
        r->has_course = true;
    }
    segment_share(&r->spec);
    TRY(body_make(&r->spec, &r->body));

done:
    return st;
}

// half the height of the window of the middle's energy over the section's radius: it only smooths
// what the mesh does within a layer
static const double WINDOW = 0.5;

static way_wants wants_of(const body *b, bool fields)
{
    return (way_wants){.fields = fields,
                       .middle = b->level[0] + b->length / 2,
                       .middle_half = fmin(WINDOW * b->radius, b->length / 4)};
}

static void tip_spring_of(const segment_case *c, double spring[6])
{
    memcpy(spring, c->tip_spring.translation, sizeof c->tip_spring.translation);
    memcpy(spring + 3, c->tip_spring.rotation, sizeof c->tip_spring.rotation);
}

static status take_loads(const climb *k, const after *a, const segment_body *here,
                         segment_result *out)
{
    status st = OK;
    const segment_load *loads = k->c->loads.items;
    double spring[6];
    tip_spring_of(k->c, spring);
    TRY(TAKE(out->load, (size_t)k->c->loads.count));
    out->nload = k->c->loads.count;
    for (int i = 0; i < out->nload; i++) {
        const after_ask ask = {.load = &loads[i],
                               .point = k->point[i],
                               .tip_spring = spring,
                               .column = k->parts.column[i],
                               .uniform = k->parts.uniform,
                               .here = here};
        TRY(after_load(a, &ask, &out->load[i]));
    }

done:
    return st;
}

static status solve_rung(const climb *k, rung *r, bool fields, segment_result *out)
{
    status st = OK;
    way_run run = {0};
    after a = {0};
    segment_problem problem = k->parts.problem;
    const way_wants wants = wants_of(&r->body, fields);

    problem.body = &r->body;
    TRY(segment_way_solve(k->c->way, &problem, &wants, &run, &out->way, out->why));
    TRY(after_make(&problem, &run, &wants, &a));
    TRY(after_fill(&a, out));
    TRY(after_keep_body(&problem, &run, fields, fields && k->c->stress, &out->body));
    TRY(take_loads(k, &a, fields ? &out->body : NULL, out));

done:
    after_free(&a);
    way_run_free(&run);
    return st;
}

// --- the climb

static double length_of(const double *v)
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

// Parts of what a load's tip motion would take to pull, and of what its energy would move, below
// which its own energy and motion are rounding: a body moved as a whole, a tip held still.
static const double SMALL_PART = 1e-2;

// of a load's work and of what its tip does, rotations by the radius
static double load_error(const segment_result *r, const segment_load_result *l, double radius)
{
    const mat6 *C = &r->tip_compliance;
    const double soft = fmax(C->a[NX][NX], fmax(C->a[NY][NY], C->a[NZ][NZ]));
    const double motion = length_of(l->tip_displacement) + radius * length_of(l->tip_rotation);
    const double off = l->tip_displacement_error + radius * l->tip_rotation_error;
    const double energy = fmax(l->strain_energy, SMALL_PART * motion * motion / (2 * soft));
    const double reach = fmax(motion, SMALL_PART * sqrt(2 * soft * fmax(l->strain_energy, 0)));
    // nothing at all happens under a load of nothing
    return energy > 0 && reach > 0 ? fmax(l->strain_energy_error / energy, off / reach) : 0;
}

// what a tolerance is about: the case's loads, else the compliance for all and the middle's law;
// its shear waits for much finer meshes than what loads do
static double judged_error(const segment_result *r, double radius)
{
    // no law where walls are held: not a number, which fmax leaves out
    double error = r->nload > 0 ? 0 : fmax(r->relative_error, r->middle.relative_error);
    for (int i = 0; i < r->nload; i++) {
        error = fmax(error, load_error(r, &r->load[i], radius));
    }
    return error;
}

static bool is_enough(const climb *k, const segment_result *r)
{
    return k->c->tolerance > 0 && r->rungs > 1 &&
           judged_error(r, k->source->radius) <= k->c->tolerance;
}

static status check_tolerance(const climb *k, const segment_result *r)
{
    if (k->c->tolerance > 0 && !is_enough(k, r)) {
        return status_fail(ERR_NUMERIC,
                           "segment: %s met to %.1e, not to the tolerance of %.1e, "
                           "with %lld unknowns on the last of %d meshes",
                           r->nload > 0 ? "loads are" : "compliance and law are",
                           judged_error(r, k->source->radius), k->c->tolerance, r->dofs, r->rungs);
    }
    return OK;
}

static void tell_plan(const rung *r, int rungs, segment_result *out)
{
    out->mesh_used = r->plan.mesh;
    out->order = r->plan.order;
    out->layers = r->plan.nlayer;
    out->plane_nodes = r->plane.nnode;
    out->rungs = rungs;
}

static void keep_step(segment_result *r)
{
    _Static_assert((int)SEGMENT_MOST_STEPS == (int)RUNG_COUNT, "a step for every rung");
    r->step[r->rungs - 1] = (segment_step){
        .dofs = (double)r->dofs,
        .seconds = r->assemble_seconds + r->factor_seconds + r->solve_seconds,
        .tip_compliance = r->tip_compliance,
    };
}

double segment_step_error(const segment_result *r, int step)
{
    const mat6 *last = &r->tip_compliance;
    double most = 0;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            const double off = fabs(r->step[step].tip_compliance.a[i][j] - last->a[i][j]);
            most = fmax(most, off / sqrt(last->a[i][i] * last->a[j][j]));
        }
    }
    return most + r->relative_error;
}

// time of the rungs below counts too
static void carry_over(const segment_result *below, segment_result *r)
{
    memcpy(r->step, below->step, (size_t)below->rungs * sizeof *r->step);
    r->assemble_seconds += below->assemble_seconds;
    r->factor_seconds += below->factor_seconds;
    r->solve_seconds += below->solve_seconds;
    r->residual = fmax(r->residual, below->residual);
}

static status climb_rung(const climb *k, int number, bool first, bool fields, segment_result *r)
{
    status st = OK;
    rung at = {0};
    segment_result now = {0};
    TRY(rung_make(k, number, &at));
    TRY(solve_rung(k, &at, fields, &now));
    now.relative_error = now.middle.relative_error = 1; // one mesh alone tells nothing
    tell_plan(&at, first ? 1 : r->rungs + 1, &now);
    keep_step(&now);
    if (!first) {
        const bool grows = now.plane_nodes > r->plane_nodes;
        after_errors(r, segment_plan_factor(k->c, k->source, number, grows),
                     segment_plan_law_factor(k->c, number), &now);
        if (!grows && r->rungs > 1) {
            after_no_better(r, &now);
        }
        carry_over(r, &now);
    }
    segment_result_free(r);
    *r = now;
    now = (segment_result){0};

done:
    segment_result_free(&now);
    rung_free(k, &at);
    return st;
}

status segment_solve(const segment_case *c, const segment_source *source, const double (*point)[2],
                     int keep_fields, segment_result *out)
{
    status st = OK;
    climb k = {.c = c, .source = source, .point = point};
    segment_result r = {0};
    const segment_climb steps = segment_climb_of(c);

    TRY(blas_room());
    TRY(problem_parts_make(c, &k.parts));
    for (int i = steps.first; i <= steps.last; i++) {
        const bool first = i == steps.first, last = i == steps.last;
        // the first is there for the estimate only
        TRY(climb_rung(&k, i, first, keep_fields && (!first || last), &r));
        if (is_enough(&k, &r)) {
            break;
        }
    }
    r.met = c->tolerance > 0;
    TRY(check_tolerance(&k, &r));
    *out = r;
    r = (segment_result){0};

done:
    problem_parts_free(&k.parts);
    segment_result_free(&r);
    return st;
}

status segment_forecast_make(const segment_case *c, const segment_source *source,
                             segment_forecast *out)
{
    status st = OK;
    climb k = {.c = c, .source = source};
    rung at = {0};
    way_cost cost = {0};
    const segment_climb steps = segment_climb_of(c);
    TRY(problem_parts_make(c, &k.parts));
    TRY(rung_make(&k, steps.first < steps.last ? steps.first + 1 : steps.last, &at));
    segment_problem problem = k.parts.problem;
    problem.body = &at.body;
    const int way = segment_way_choose(c->way, &problem, &cost, NULL);
    // a doubled slab stands for as many layers as fit on one another
    const long long levels =
        way == WAY_DOUBLING ? (long long)at.body.order << doubling_count(&at.body) : at.body.nlevel;
    *out = (segment_forecast){.order = at.plan.order,
                              .layers = at.plan.nlayer,
                              .plane_nodes = at.plane.nnode,
                              .size = at.plan.mesh.size,
                              .dofs = 3 * levels * at.plane.nnode,
                              .way = segment_way_name(way),
                              .seconds = cost.seconds,
                              .bytes = cost.bytes,
                              .fits = cost.bytes <= segment_memory()};

done:
    rung_free(&k, &at);
    problem_parts_free(&k.parts);
    return st;
}
