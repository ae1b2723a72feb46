// fem/segment_run.c
#include "fem/segment_run.h"

#include "base/memory.h"
#include "fem/assembly.h"
#include "fem/refined_solve.h"

#include <string.h>
#include <time.h>

void segment_run_free(segment_run *run)
{
    free(run->u);
    free(run->motion);
    section_fit_free(&run->by_E);
    section_fit_free(&run->by_area);
    *run = (segment_run){0};
}

static double wall_seconds(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// a uniform traction acts at the area's centroid
static vec6 uniform_wrench(const section_fit *area, int direction)
{
    const double x = area->centroid[0], y = area->centroid[1];
    const vec6 wrench[3] = {{{1, 0, 0, 0, 0, -y}}, {{0, 1, 0, 0, 0, x}}, {{0, 0, 1, y, -x, 0}}};
    return wrench[direction];
}

// resultant of the tip's load number j
static vec6 resultant(const segment_run *run, int j)
{
    vec6 w = {0};
    if (j < 6) {
        w.a[j] = 1;
        return w;
    }
    return uniform_wrench(&run->by_area, j - 6);
}

static void add_forces(const section_fit *fit, const double *coefficient, const supports *s,
                       int level, double *b)
{
    const size_t n = (size_t)fit->nplane;
    for (int j = 0; j < 6; j++) {
        const double *force = fit->force + (size_t)j * 3 * n;
        for (size_t i = 0; coefficient[j] != 0 && i < n; i++) {
            double *to = b + 3 * (size_t)supports_block(s, (int)i, level);
            for (int d = 0; d < 3; d++) {
                if (!supports_is_held(s, (int)i, level, d)) {
                    to[d] += coefficient[j] * force[3 * i + (size_t)d];
                }
            }
        }
    }
}

// right-hand side of one tip load; a base free to contract answers transverse forces and torsion by
// an E-proportional traction, the multiplier of "no mean motion". docs/theory.md (5.8)
static void load_vector(const segment_run *run, const supports *s, int j, double *b)
{
    const vec6 w = resultant(run, j);
    if (s->cap) {
        double *cap = b + 3 * (size_t)s->cap_block;
        for (int i = 0; i < 6; i++) {
            cap[i] = i < 3 ? w.a[i] : w.a[i] / s->radius;
        }
    } else {
        add_forces(j < 6 ? &run->by_E : &run->by_area, w.a, s, s->nlevel - 1, b);
    }
    if (s->held) {
        const double balance[6] = {-w.a[NX], -w.a[NY], 0, 0, 0, -w.a[MZ]};
        add_forces(&run->by_E, balance, s, 0, b);
    }
}

// takes the base's E-weighted mean motion in its plane out of all levels
static void centre_on_base(const segment_run *run, const mesh *plane, double *u)
{
    const vec6 q = section_fit_motion(&run->by_E, u);
    for (int level = 0; level < run->nlevel; level++) {
        for (int i = 0; i < run->nplane; i++, u += 3) {
            const double x = plane->xyz[3 * (size_t)i], y = plane->xyz[3 * (size_t)i + 1];
            u[0] -= q.a[0] - q.a[5] * y;
            u[1] -= q.a[1] + q.a[5] * x;
        }
    }
}

static status expand(segment_run *run, const column *c, const supports *s, const double *x)
{
    status st = OK;
    const size_t all = 3 * column_node_count(c), nlevel = (size_t)run->nlevel;
    TRY(TAKE(run->u, (size_t)run->nsolution * all));
    TRY(TAKE(run->motion, (size_t)run->nsolution * nlevel));
    for (int j = 0; j < run->nsolution; j++) {
        double *u = run->u + (size_t)j * all;
        supports_expand(s, c->plane, x + (size_t)j * 3 * (size_t)s->nblock, u);
        if (s->held) {
            centre_on_base(run, c->plane, u);
        }
        for (int level = 0; level < run->nlevel; level++) {
            run->motion[(size_t)j * nlevel + (size_t)level] =
                section_fit_motion(&run->by_E, segment_run_level(run, j, level));
        }
    }

done:
    return st;
}

typedef struct product {
    const petsc_door *door;
    petsc_matrix *matrix;
    size_t n, ncol;
    const double *b;
} product;

static status residual(void *self, const double *x, double *r)
{
    status st = OK;
    const product *p = (const product *)self;
    double *rows = NULL;
    long double *y = NULL;
    TRY(TAKE(rows, p->n * p->ncol));
    TRY(TAKE(y, p->n * p->ncol));
    for (size_t i = 0; i < p->n * p->ncol; i++) {
        rows[i % p->n * p->ncol + i / p->n] = x[i];
    }
    TRY(p->door->matrix_multiply(p->matrix, (int)p->ncol, rows, y));
    for (size_t i = 0; i < p->n * p->ncol; i++) {
        r[i] = (double)(p->b[i] - y[i % p->n * p->ncol + i / p->n]);
    }

done:
    free(rows);
    free(y);
    return st;
}

// by each rank's rows, and whole again
static status solve_rows(const petsc_door *door, petsc_matrix *matrix, double norm,
                         supports_share share, size_t unknowns, int nrhs, const double *b,
                         double *x, double *relative)
{
    status st = OK;
    double *mine = NULL, *found = NULL;
    const size_t first = 3 * (size_t)share.first, n = 3 * (size_t)(share.last - share.first);
    TRY(TAKE(mine, n * (size_t)nrhs));
    TRY(TAKE(found, n * (size_t)nrhs));
    for (size_t j = 0; j < (size_t)nrhs; j++) {
        memcpy(mine + j * n, b + j * unknowns + first, n * sizeof *b);
    }
    product p = {door, matrix, n, (size_t)nrhs, mine};
    const refined_system system = {door, matrix, norm, n, nrhs, mine, residual, &p};
    refined_answer answer = {0};
    TRY(refined_solve(&system, found, &answer));
    *relative = answer.residual;
    for (size_t j = 0; j < (size_t)nrhs; j++) {
        memcpy(x + j * unknowns + first, found + j * n, n * sizeof *b);
        door->sum((int)unknowns, x + j * unknowns);
    }

done:
    free(mine);
    free(found);
    return st;
}

static status solve(const petsc_door *door, const column *c, const supports *s, segment_run *run)
{
    status st = OK;
    petsc_matrix *matrix = NULL;
    double *b = NULL, *x = NULL;
    petsc_factors factors = {0};
    int rank = 0, size = 1;
    const size_t unknowns = 3 * (size_t)s->nblock, nrhs = (size_t)run->nsolution;

    TRY(door->start(&rank, &size));
    const double begin = wall_seconds();
    TRY(assembly_make(door, c, s, rank, size, &matrix));
    run->assemble_seconds = wall_seconds() - begin;
    TRY(TAKE(b, nrhs * unknowns));
    TRY(TAKE(x, nrhs * unknowns));
    for (int j = 0; j < run->nsolution; j++) {
        load_vector(run, s, j, b + (size_t)j * unknowns);
    }
    const double assembled = wall_seconds();
    TRY(door->matrix_factor(matrix, &factors));
    const double factored = wall_seconds();
    TRY(solve_rows(door, matrix, factors.norm, supports_share_of(s, rank, size), unknowns,
                   run->nsolution, b, x, &run->residual));
    run->factor_seconds = factored - assembled;
    run->solve_seconds = wall_seconds() - factored;
    run->dofs = (int)unknowns;
    TRY(expand(run, c, s, x));

done:
    if (matrix) {
        door->matrix_free(matrix);
    }
    free(b);
    free(x);
    return st;
}

status segment_run_make(const petsc_door *door, const column *c, int base, int tip,
                        segment_run *out)
{
    status st = OK;
    supports s = {0};
    segment_run run = {
        .nsolution = tip == TIP_UNIFORM ? 9 : 6, .nplane = c->plane->nnode, .nlevel = c->nlevel};

    TRY(section_fit_make(c, WEIGHT_E, &run.by_E));
    TRY(section_fit_make(c, WEIGHT_ONE, &run.by_area));
    TRY(supports_make(c, base == BASE_CLAMPED, tip == TIP_RIGID, &s));
    TRY(solve(door, c, &s, &run));
    *out = run;
    run = (segment_run){0};

done:
    supports_free(&s);
    segment_run_free(&run);
    return st;
}

mat6 segment_run_compliance(const segment_run *run)
{
    mat6 C = {0};
    for (int j = 0; j < 6; j++) {
        const vec6 q = run->motion[(j + 1) * run->nlevel - 1];
        for (int i = 0; i < 6; i++) {
            C.a[i][j] = q.a[i];
        }
    }
    return mat6_symmetric(C);
}

void segment_run_uniform_work(const segment_run *run, double (*work)[3])
{
    for (int j = 0; j < 3; j++) {
        const vec6 q =
            section_fit_motion(&run->by_area, segment_run_level(run, 6 + j, run->nlevel - 1));
        for (int i = 0; i < 3; i++) {
            work[i][j] = vec6_dot(uniform_wrench(&run->by_area, i), q);
        }
    }
}
