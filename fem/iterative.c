// fem/iterative.c
// The way by conjugate gradients, without the body's matrix, on any number of ranks.
// docs/theory.md (5.14)
#include "fem/iterative.h"

#include "base/memory.h"
#include "fem/blas.h"
#include "fem/direct.h"
#include "fem/level_forces.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

static double cpu_seconds(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void iterative_free(iterative *w)
{
    plane_forms_free(&w->forms);
    section_modes_free(&w->modes);
    apply_free(w->product);
    separable_free(w->separable);
    coarse_free(w->coarse);
    double *const fields[] = {w->b, w->x, w->r, w->z, w->d, w->q, w->turned, w->y, w->above};
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        free(fields[i]);
    }
    free(w->level);
}

bool iterative_is_plain(const segment_problem *p)
{
    const body_spec *s = &p->body->spec;
    return !s->matter && !s->mixed && p->nspring == 0 && p->nhold == 0 && p->base != BASE_FREE;
}

// --- right-hand sides

// nodal forces on a rigid cap with unit resultants
static status load_cap(const iterative *w)
{
    status st = OK;
    const body *b = w->p->body;
    const size_t n3 = w->block / (size_t)w->ncol, ncol = (size_t)w->ncol;
    double *rigid = NULL, *to = w->b + w->own - w->block;
    mat6 G = {0}, inverse;
    TRY(TAKE(rigid, 6 * n3));
    section_rigid(b, b->nlevel - 1, rigid);
    for (size_t i = 0; i < n3; i++) {
        for (int r = 0; r < 36; r++) {
            G.a[r / 6][r % 6] += rigid[6 * i + (size_t)r / 6] * rigid[6 * i + (size_t)r % 6];
        }
    }
    if (!mat6_inverse_spd(G, &inverse)) {
        TRY(status_fail(ERR_NUMERIC, "segment: the tip has no extent"));
    }
    for (size_t i = 0; i < n3; i++) {
        for (size_t j = 0; j < 6; j++) { // rotations of the rigid motions are over the radius
            const double unit = j < 3 ? 1 : 1 / b->radius;
            for (size_t k = 0; k < 6; k++) {
                to[i * ncol + j] += rigid[6 * i + k] * inverse.a[k][j] * unit;
            }
        }
    }

done:
    free(rigid);
    return st;
}

static status take_loads(iterative *w, const level_loads *loads)
{
    const level_share *s = &w->share;
    const size_t n = (size_t)w->p->body->plane->nnode, ncol = (size_t)w->ncol;
    const size_t held = (size_t)(s->to - s->from);
    for (size_t j = 0; j < ncol; j++) {
        for (int level = s->first; level < s->last; level++) {
            const double *from = loads->force + (j * held + (size_t)(level - s->from)) * 3 * n;
            double *to = w->b + (size_t)(level - s->first) * w->block + j;
            for (size_t i = 0; i < 3 * n; i++) {
                to[(i % 3 * n + i / 3) * ncol] = from[i];
            }
        }
    }
    const bool has_tip = s->first < s->last && s->last == w->p->body->nlevel;
    return w->cap && has_tip ? load_cap(w) : OK;
}

// --- set up

static status take_levels(iterative *w)
{
    status st = OK;
    const level_share *s = &w->share;
    const size_t size = (size_t)s->size;
    double *first = NULL;
    TRY(w->door->agree(TAKE(first, size)));
    TRY(w->door->agree(TAKE(w->level, size + 1)));
    first[s->rank] = s->first;
    w->door->sum(s->size, first);
    for (size_t r = 0; r < size; r++) {
        w->level[r] = (int)first[r];
    }
    w->level[size] = w->p->body->nlevel;

done:
    free(first);
    return st;
}

static status take_fields(iterative *w)
{
    status st = OK;
    double **const fields[] = {&w->b, &w->x, &w->r, &w->z, &w->d, &w->q};
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        TRY(TAKE(*fields[i], w->own + w->block));
    }
    TRY(TAKE(w->above, w->block));
    if (!w->p->body->prism) {
        TRY(TAKE(w->turned, w->own));
    }

done:
    return st;
}

// what a rank makes for itself
static status make_alone(iterative *w)
{
    status st = OK;
    const body *b = w->p->body;
    TRY(take_fields(w));
    TRY(plane_forms_make(b, &w->forms));
    TRY(section_modes_make(w->plane_door, b, &w->forms, &w->modes));
    TRY(apply_make(b, w->share.first_layer, w->share.last_layer, &w->product));

done:
    return st;
}

static status make_corrections(iterative *w)
{
    status st = OK;
    const body *b = w->p->body;
    const level_share *s = &w->share;
    const separable_layout layout = {.rank = s->rank,
                                     .size = s->size,
                                     .first = w->level,
                                     .base = {!w->clamped, !w->clamped && !w->guided},
                                     .tip = !w->cap};
    const coarse_spec spec = {.door = w->door,
                              .body = b,
                              .forms = &w->forms,
                              .modes = &w->modes,
                              .product = w->product,
                              .rank = s->rank,
                              .size = s->size,
                              .first = s->first,
                              .last = s->last,
                              .first_layer = s->first_layer,
                              .last_layer = s->last_layer,
                              .clamped = w->clamped,
                              .guided = w->guided,
                              .cap = w->cap,
                              .drifts = w->guided};
    TRY(w->door->agree(
        separable_make(w->plane_door, b, &w->forms, &layout, w->ncol, &w->separable)));
    TRY(coarse_make(&spec, &w->coarse));
    TRY(w->door->agree(TAKE(w->y, coarse_values(w->coarse) * (size_t)w->ncol)));

done:
    return st;
}

// --- answers

static status find_work(iterative *w, way_run *run)
{
    status st = OK;
    const size_t n = (size_t)w->ncol, run_length = w->block / 3 / n;
    TRY(w->door->agree(TAKE(run->work, n * n)));
    for (size_t at = 0; at < w->own; at += run_length * n) {
        blas_product(w->ncol, w->ncol, (int)run_length, w->b + at, w->x + at, 1, run->work);
    }
    w->door->sum((int)(n * n), run->work);

done:
    return st;
}

// [level][direction][node][column] -> nodes of one column, level by level
static void unfold(const iterative *w, const way_field *field)
{
    const size_t n = (size_t)w->p->body->plane->nnode, ncol = (size_t)w->ncol;
    for (int j = 0; j < w->ncol; j++) {
        for (int level = w->share.first; level < w->share.last; level++) {
            const double *from = w->x + (size_t)(level - w->share.first) * w->block + j;
            double *to = way_field_level(field, j, level);
            for (size_t i = 0; i < 3 * n; i++) {
                to[i] = from[(i % 3 * n + i / 3) * ncol];
            }
        }
    }
}

static status fill(iterative *w, const level_loads *loads, const way_wants *wants, way_run *run)
{
    status st = OK;
    const body *b = w->p->body;
    unknowns u = {0};
    level_forces inner = {0};
    way_field field = {
        .door = w->door, .p = w->p, .share = w->share, .unknowns = &u, .loads = loads};
    TRY(find_work(w, run));
    TRY(w->door->agree(unknowns_make(w->p, w->share, &u)));
    TRY(w->door->agree(TAKE(field.u, way_field_offset(&field, w->ncol, w->share.from))));
    unfold(w, &field);
    way_field_exchange(&field);
    TRY(w->door->agree(level_forces_take(&field, &inner)));
    TRY(w->door->agree(level_forces_find(&field, &inner)));
    if (w->guided) {
        TRY(way_field_centre(&field));
    }
    TRY(way_fill(&field, &inner, wants, run));
    run->dofs =
        3 * (long long)b->plane->nnode * (b->nlevel - (w->clamped ? 1 : 0) - (w->cap ? 1 : 0)) +
        (w->cap ? 6 : 0);
    run->residual = w->residual;
    run->iterations = w->iterations;

done:
    level_forces_free(&inner);
    unknowns_free(&u);
    free(field.u);
    return st;
}

static status solve(iterative *w, level_loads *loads, const way_wants *wants, way_run *run)
{
    status st = OK;
    int rank = 0, size = 1;
    const body *b = w->p->body;
    TRY(w->door->start(&rank, &size));
    w->share = level_share_of(&b->spec, rank, size);
    w->block = 3 * (size_t)b->plane->nnode * (size_t)w->ncol;
    w->own = (size_t)(w->share.last - w->share.first) * w->block;
    const double begin = cpu_seconds();
    TRY(take_levels(w));
    TRY(w->door->agree(make_alone(w)));
    TRY(level_loads_make(w->door, w->p, &w->share, loads));
    TRY(w->door->agree(take_loads(w, loads)));
    const double assembled = cpu_seconds();
    TRY(make_corrections(w));
    const double factored = cpu_seconds();
    TRY(iterative_solve(w, wants));
    TRY(fill(w, loads, wants, run));
    run->assemble_seconds = assembled - begin;
    run->factor_seconds = factored - assembled;
    run->solve_seconds = cpu_seconds() - factored;
    run->bytes =
        8.0 * (double)(7 * w->own) + separable_bytes(w->separable) + coarse_bytes(w->coarse);

done:
    return st;
}

status way_iterative(const segment_problem *p, const way_wants *wants, way_run *out)
{
    status st = OK;
    iterative w = {.p = p,
                   .ncol = problem_columns(p),
                   .clamped = p->base == BASE_CLAMPED,
                   .guided = p->base == BASE_FREE_TO_CONTRACT,
                   .cap = p->tip == TIP_RIGID};
    level_loads loads = {0};
    way_run run = {0};
    if (!iterative_is_plain(p)) {
        return direct_solve(p, wants, true, out);
    }
    TRY(blas_take());
    TRY(petsc_door_open(&w.door));
    TRY(petsc_plane_door_open(&w.plane_door));
    TRY(solve(&w, &loads, wants, &run));
    *out = run;
    run = (way_run){0};

done:
    way_run_free(&run);
    level_loads_free(&loads);
    iterative_free(&w);
    return st;
}
