// fem/direct.c
// The way by sparse factors of the whole: any body, any supports. docs/theory.md (5.13)
#include "fem/direct.h"

#include "base/memory.h"
#include "fem/direct_matrix.h"
#include "fem/level_forces.h"
#include "fem/refined_solve.h"

#include <math.h>
#include <string.h>
#include <time.h>

static double cpu_seconds(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

typedef struct direct {
    bool multigrid; // in place of factors
    const petsc_door *door;
    const segment_problem *p;
    unknowns u;
    level_loads loads;
    petsc_matrix *matrix;
    petsc_factors factors;
    int ncolumn;
    size_t rows; // 3 x this rank's blocks
    double *f;   // [ncolumn][rows] loads
    double *b;   // the same without what held directions that move put on the others
    double *x;   // solutions
    way_field field;
    level_forces inner;
} direct;

static void direct_free(direct *d)
{
    if (d->matrix) {
        d->door->matrix_free(d->matrix);
    }
    free(d->f);
    free(d->b);
    free(d->x);
    free(d->field.u);
    level_forces_free(&d->inner);
    level_loads_free(&d->loads);
    unknowns_free(&d->u);
}

static bool column_moves(const segment_problem *p, int column)
{
    return column >= 6 && p->extra[column - 6].holds_move;
}

static bool any_column_moves(const segment_problem *p)
{
    bool any = false;
    for (int j = 0; j < problem_columns(p); j++) {
        any = any || column_moves(p, j);
    }
    return any;
}

// --- unknowns -> displacements -> forces

// (all)
static void expand(direct *d, const double *x)
{
    const unknowns *u = &d->u;
    for (int j = 0; j < d->ncolumn; j++) {
        const double *mine = x + (size_t)j * d->rows;
        const double *cap =
            unknowns_has_tip(u) && u->cap ? mine + 3 * (u->cap_block - u->first) : NULL;
        for (int level = u->share.first; level < u->share.last; level++) {
            unknowns_expand(u, level, mine + 3 * (size_t)(u->start[level] - u->first), cap,
                            column_moves(d->p, j), way_field_level(&d->field, j, level));
        }
    }
    way_field_exchange(&d->field);
}

// (all) f - K u, element by element
static status residual(void *self, const double *x, double *r)
{
    status st = OK;
    direct *d = (direct *)self;
    expand(d, x);
    TRY(d->door->agree(level_forces_find(&d->field, &d->inner)));
    for (int j = 0; j < d->ncolumn; j++) {
        double *to = r + (size_t)j * d->rows;
        const double *f = d->f + (size_t)j * d->rows;
        unknowns_gather(&d->u, d->inner.force + way_field_offset(&d->field, j, d->u.share.from),
                        to);
        for (size_t i = 0; i < d->rows; i++) {
            to[i] = f[i] - to[i];
        }
    }

done:
    return st;
}

// --- work

static double dot(size_t n, const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

// of the forces of column j that hold held directions, on their motion
static double held_work(const direct *d, int j)
{
    const unknowns *u = &d->u;
    const size_t n = 3 * (size_t)u->nplane;
    double sum = 0;
    for (int level = u->share.first; level < u->share.last; level++) {
        const double *motion = u->motion + 3 * unknowns_index(u, 0, level);
        sum += dot(n, motion, d->inner.force + way_field_offset(&d->field, j, level));
    }
    return sum;
}

// u_i^T K u_j: of loads, and of what holds moving directions
static status find_work(const direct *d, way_run *run)
{
    status st = OK;
    const size_t n = (size_t)d->ncolumn;
    TRY(d->door->agree(TAKE(run->work, n * n)));
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j < n; j++) {
            double *w = &run->work[i * n + j];
            *w = dot(d->rows, d->x + i * d->rows, d->f + j * d->rows);
            if (d->u.motion && column_moves(d->p, (int)i)) {
                *w += held_work(d, (int)j);
            }
        }
    }
    d->door->sum((int)(n * n), run->work);

done:
    return st;
}

static status fill(direct *d, const way_wants *wants, way_run *run)
{
    status st = OK;
    expand(d, d->x);
    if (d->p->base == BASE_FREE_TO_CONTRACT) {
        TRY(way_field_centre(&d->field));
    }
    TRY(way_fill(&d->field, &d->inner, wants, run));
    TRY(find_work(d, run));

done:
    return st;
}

// --- the whole

static status take_room(direct *d)
{
    status st = OK;
    const size_t all = (size_t)d->ncolumn * d->rows;
    TRY(TAKE(d->f, all));
    TRY(TAKE(d->b, all));
    TRY(TAKE(d->x, all));
    TRY(TAKE(d->field.u, way_field_offset(&d->field, d->ncolumn, d->u.share.from)));
    TRY(level_forces_take(&d->field, &d->inner));
    level_loads_gather(&d->loads, d->p, &d->u, d->f);

done:
    return st;
}

// Refuses before hours and the machine's memory are spent on what cannot end well.
static status check_room(const direct *d, int size)
{
    const way_cost cost = way_cost_direct(d->p, size);
    if (cost.bytes * size > d->door->memory()) {
        return status_fail(ERR_RESOURCE,
                           "segment: the factors of %.3g million unknowns would take about %.3g "
                           "GB, more memory than there is: take fewer fem.layers, a lower "
                           "fem.order, a larger fem.size_mm or another fem.method",
                           3e-6 * (double)body_node_count(d->p->body), 1e-9 * cost.bytes * size);
    }
    return OK;
}

static status prepare(direct *d, const level_share *share)
{
    status st = OK;
    TRY(d->door->agree(check_room(d, share->size)));
    TRY(d->door->agree(unknowns_make(d->p, *share, &d->u)));
    TRY(unknowns_check_supports(d->door, d->p, &d->u));
    d->ncolumn = problem_columns(d->p);
    d->rows = 3 * (size_t)(d->u.last - d->u.first);
    d->field = (way_field){
        .door = d->door, .p = d->p, .share = *share, .unknowns = &d->u, .loads = &d->loads};
    TRY(level_loads_make(d->door, d->p, share, &d->loads));
    TRY(direct_matrix_make(d->door, d->p, &d->u, &d->matrix));
    TRY(d->door->agree(take_room(d)));
    memcpy(d->b, d->f, (size_t)d->ncolumn * d->rows * sizeof *d->b);
    if (any_column_moves(d->p)) {
        TRY(residual(d, d->x, d->b)); // x = 0: held directions alone move
    }

done:
    return st;
}

// forces that are off by more of themselves are found anew
static const double STALE = 1e-10;

static status solve_refined(direct *d, double *worst)
{
    status st = OK;
    const refined_system s = {.door = d->door,
                              .matrix = d->matrix,
                              .norm = d->factors.norm,
                              .n = d->rows,
                              .ncol = d->ncolumn,
                              .b = d->b,
                              .residual = residual,
                              .self = d};
    refined_answer answer = {0};
    TRY(refined_solve(&s, d->x, &answer));
    *worst = answer.residual;
    if (answer.moved > STALE) {
        expand(d, d->x);
        TRY(d->door->agree(level_forces_find(&d->field, &d->inner)));
    }

done:
    return st;
}

// --- by multigrid in place of factors

// far above rounding, far below what meshes miss
static const double STEPS_LIMIT = 1e-8;

static status coarsen(direct *d)
{
    status st = OK;
    double *motions = NULL;
    TRY(d->door->agree(TAKE(motions, 6 * d->rows)));
    unknowns_rigid(&d->u, motions);
    TRY(d->door->matrix_coarsen(d->matrix, motions, &d->factors));

done:
    free(motions);
    return st;
}

// (all) per column
static void largest(const direct *d, const double *v, double *most)
{
    for (size_t c = 0; c < (size_t)d->ncolumn; c++) {
        most[c] = 0;
        for (size_t i = 0; i < d->rows; i++) {
            most[c] = fmax(most[c], fabs(v[c * d->rows + i]));
        }
    }
    d->door->largest(d->ncolumn, most);
}

static status solve_by_steps(direct *d, way_run *run)
{
    status st = OK;
    double *r = NULL, *most = NULL;
    const size_t n = (size_t)d->ncolumn;
    TRY(d->door->agree(TAKE(r, n * d->rows)));
    TRY(d->door->agree(TAKE(most, 3 * n)));
    TRY(d->door->matrix_solve(d->matrix, d->ncolumn, d->b, d->x));
    TRY(residual(d, d->x, r));
    largest(d, r, most);
    largest(d, d->x, most + n);
    largest(d, d->b, most + 2 * n);
    for (size_t c = 0; c < n; c++) {
        const double scale = d->factors.norm * most[n + c] + most[2 * n + c];
        run->residual = scale > 0 ? fmax(run->residual, most[c] / scale) : run->residual;
    }
    run->iterations = d->door->matrix_steps(d->matrix);
    if (!(run->residual <= STEPS_LIMIT)) {
        TRY(status_fail(ERR_NUMERIC,
                        "segment: conjugate gradients with multigrid end at a residual of %.2g "
                        "after %d iterations",
                        run->residual, run->iterations));
    }

done:
    free(r);
    free(most);
    return st;
}

static status solve(direct *d, const way_wants *wants, way_run *run)
{
    status st = OK;
    int rank = 0, size = 1;
    TRY(d->door->start(&rank, &size));
    const level_share share = level_share_of(&d->p->body->spec, rank, size);
    const double begin = cpu_seconds();
    TRY(prepare(d, &share));
    const double assembled = cpu_seconds();
    if (wants->cancelled && wants->cancelled()) {
        TRY(status_fail(ERR_INTERRUPTED, "interrupted"));
    }
    TRY(d->multigrid ? coarsen(d) : d->door->matrix_factor(d->matrix, &d->factors));
    const double factored = cpu_seconds();
    TRY(d->multigrid ? solve_by_steps(d, run) : solve_refined(d, &run->residual));
    TRY(fill(d, wants, run));
    run->dofs = 3 * (long long)d->u.nblock;
    run->assemble_seconds = assembled - begin;
    run->factor_seconds = factored - assembled;
    run->solve_seconds = cpu_seconds() - factored;
    run->bytes = d->factors.bytes;

done:
    return st;
}

status way_direct(const segment_problem *p, const way_wants *wants, way_run *out)
{
    return direct_solve(p, wants, false, out);
}

status direct_solve(const segment_problem *p, const way_wants *wants, bool multigrid, way_run *out)
{
    status st = OK;
    direct d = {.p = p, .multigrid = multigrid};
    way_run run = {0};
    TRY(petsc_door_open(&d.door));
    TRY(solve(&d, wants, &run));
    *out = run;
    run = (way_run){0};

done:
    way_run_free(&run);
    direct_free(&d);
    return st;
}
