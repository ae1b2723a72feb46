// fem/direct.c
// The way by sparse factors of the whole: any body, any supports. docs/theory.md (5.13)
#include "fem/way.h"

#include "base/memory.h"
#include "fem/direct_matrix.h"
#include "fem/refined_solve.h"
#include "fem/way_fill.h"

#include <string.h>
#include <time.h>

static double cpu_seconds(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

typedef struct direct {
    const petsc_door *door;
    const segment_problem *p;
    unknowns u;
    level_loads loads;
    direct_matrix m;
    petsc_factors factors;
    int ncolumn;
    size_t rows;   // 3 x this rank's blocks
    double *b, *x; // [ncolumn][rows]
    double *field; // as way_field's
} direct;

static void direct_free(direct *d)
{
    if (d->m.matrix) {
        d->door->matrix_free(d->m.matrix);
    }
    free(d->m.moved);
    free(d->b);
    free(d->x);
    free(d->field);
    level_loads_free(&d->loads);
    unknowns_free(&d->u);
}

static bool column_moves(const segment_problem *p, int column)
{
    return column >= 6 && p->extra[column - 6].holds_move;
}

// --- right-hand sides

static status make_loads(direct *d)
{
    status st = OK;
    const size_t all = (size_t)d->ncolumn * d->rows;
    TRY(TAKE(d->b, all));
    TRY(TAKE(d->x, all));
    level_loads_gather(&d->loads, d->p, &d->u, d->b);
    for (int j = 0; j < d->ncolumn; j++) {
        for (size_t i = 0; d->m.moved && column_moves(d->p, j) && i < d->rows; i++) {
            d->b[(size_t)j * d->rows + i] -= d->m.moved[i];
        }
    }

done:
    return st;
}

static double dot(size_t n, const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

// u_i^T K u_j of the whole displacements: with moving holds, b = f - g and their own work,
// x_i.f_j + m_i g.x_j + m_i m_j h.  docs/theory.md (5.13)
static status find_work(const direct *d, way_run *run)
{
    status st = OK;
    const size_t n = (size_t)d->ncolumn;
    TRY(d->door->agree(TAKE(run->work, n * n)));
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j < n; j++) {
            const double *x_i = d->x + i * d->rows, *x_j = d->x + j * d->rows;
            double *w = &run->work[i * n + j];
            *w = dot(d->rows, x_i, d->b + j * d->rows);
            if (d->m.moved && column_moves(d->p, (int)j)) {
                *w += dot(d->rows, x_i, d->m.moved);
            }
            if (d->m.moved && column_moves(d->p, (int)i)) {
                *w += dot(d->rows, x_j, d->m.moved);
                *w += column_moves(d->p, (int)j) ? d->m.held_work : 0;
            }
        }
    }
    d->door->sum((int)(n * n), run->work);

done:
    return st;
}

// --- displacements

static status expand(direct *d)
{
    status st = OK;
    const unknowns *u = &d->u;
    const size_t n = 3 * (size_t)u->nplane;
    const size_t held = (size_t)way_field_levels(&u->share, d->p->body->order);
    TRY(TAKE(d->field, (size_t)d->ncolumn * held * n));
    for (int j = 0; j < d->ncolumn; j++) {
        const double *x = d->x + (size_t)j * d->rows;
        const double *cap =
            unknowns_has_tip(u) && u->cap ? x + 3 * (u->cap_block - u->first) : NULL;
        for (int level = u->share.first; level < u->share.last; level++) {
            double *to = d->field + ((size_t)j * held + (size_t)(level - u->share.first)) * n;
            unknowns_expand(u, level, x + 3 * (u->start[level] - u->first), cap,
                            column_moves(d->p, j), to);
        }
    }

done:
    return st;
}

static status fill(direct *d, const way_wants *wants, way_run *run)
{
    status st = OK;
    const level_share *share = &d->u.share;
    TRY(d->door->agree(expand(d)));
    const way_field field = {.door = d->door,
                             .p = d->p,
                             .share = *share,
                             .loads = &d->loads,
                             .nheld = way_field_levels(share, d->p->body->order),
                             .u = d->field};
    if (d->p->base == BASE_FREE_TO_CONTRACT) {
        TRY(way_field_centre(&field, d->field));
    }
    way_field_get_above(d->door, d->p->body, share, d->ncolumn, d->field);
    TRY(way_fill(&field, wants, run));
    TRY(find_work(d, run));

done:
    return st;
}

// --- the whole

static bool is_cancelled(const way_wants *wants)
{
    return wants->cancelled && wants->cancelled();
}

static status prepare(direct *d, const level_share *share)
{
    status st = OK;
    TRY(d->door->agree(unknowns_make(d->p, *share, &d->u)));
    d->ncolumn = problem_columns(d->p);
    d->rows = 3 * (size_t)(d->u.last - d->u.first);
    TRY(level_loads_make(d->door, d->p, share, &d->loads));
    TRY(direct_matrix_make(d->door, d->p, &d->u, &d->m));
    TRY(d->door->agree(make_loads(d)));

done:
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
    if (is_cancelled(wants)) {
        TRY(status_fail(ERR_INTERRUPTED, "interrupted"));
    }
    TRY(d->door->matrix_factor(d->m.matrix, &d->factors));
    const double factored = cpu_seconds();
    TRY(refined_solve(d->door, d->m.matrix, d->factors.norm, d->rows, d->ncolumn, d->b, d->x,
                      &run->residual));
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
    status st = OK;
    direct d = {.p = p};
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
