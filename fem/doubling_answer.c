// fem/doubling_answer.c
#include "fem/doubling_answer.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// Energies between cuts are interpolated through this many of them: in the middle they are nearly
// cubic
enum { ENERGY_POINTS = 6 };

// No answer where more than this of the work is missing: answers are asked for to 1e-4 or so
static const double MOST_MISSING = 1e-5;

// A column has no share in a part where its forces are below this of the largest: rounding
static const double NO_SHARE = 1e-13;

status doubling_answer_take(const doubling *d, way_run *run)
{
    status st = OK;
    const size_t cuts = (size_t)(1 << d->grid) + 1, columns = (size_t)d->ncolumn;
    run->ncolumn = d->ncolumn;
    run->nlevel = (int)cuts;
    TRY(TAKE(run->z, cuts));
    TRY(TAKE(run->motion, columns * cuts));
    TRY(TAKE(run->resultant, columns * cuts));
    TRY(TAKE(run->work, columns * columns));
    for (size_t i = 0; i < cuts; i++) {
        run->z[i] = d->begin + d->problem->body->length * (double)i / (double)(cuts - 1);
    }

done:
    return st;
}

// --- forces of the columns on one part

typedef struct part_loads {
    int count, *column; // columns that have a share here
    double *tip, *base; // [count][n]
    double *fit;        // [6][n]
} part_loads;

static void part_loads_free(part_loads *l)
{
    free(l->column);
    free(l->tip);
    free(l->base);
    free(l->fit);
    *l = (part_loads){0};
}

static double largest(int n, const double *x)
{
    double most = 0;
    for (int i = 0; i < n; i++) {
        most = fmax(most, fabs(x[i]));
    }
    return most;
}

static status part_loads_make(const doubling *d, int part, part_loads *out)
{
    status st = OK;
    const size_t n = (size_t)d->cut.part[part].n, dofs = 3 * (size_t)d->cut.nplane;
    TRY(TAKE(out->column, (size_t)d->ncolumn));
    TRY(TAKE(out->tip, (size_t)d->ncolumn * n));
    TRY(TAKE(out->base, (size_t)d->ncolumn * n));
    TRY(TAKE(out->fit, 6 * n));
    for (int j = 0; j < d->ncolumn; j++) {
        const double *f = d->tip_force + (size_t)j * dofs, *g = d->base_force + (size_t)j * dofs;
        double *here = out->tip + (size_t)out->count * n;
        cut_force(&d->cut, part, f, here);
        if (largest((int)n, here) > NO_SHARE * largest((int)dofs, f)) {
            cut_force(&d->cut, part, g, out->base + (size_t)out->count * n);
            out->column[out->count++] = j;
        }
    }
    for (int i = 0; i < 6; i++) {
        cut_force(&d->cut, part, d->fit + (size_t)i * dofs, out->fit + (size_t)i * n);
    }

done:
    return st;
}

// --- motions and resultants at the cuts, in the section's axes and about its origin there

static void add_motion(const doubling *d, const doubling_tree *t, const part_loads *l,
                       const slab_list *cells, int column, int cut_number, vec6 *to)
{
    const cut_part *p = &d->cut.part[t->part];
    const bool tip = cut_number == cells->count;
    const size_t at = (size_t)(cut_number - tip) * (size_t)cells->ncolumn + (size_t)column;
    const double *x = (tip ? cells->upper : cells->lower) + at * (size_t)p->n;
    double q[6] = {0};
    memcpy(q, cells->rigid + at * (size_t)p->nrigid, (size_t)p->nrigid * sizeof *q);
    if (tip) {
        doubling_tree_carry(t, ldexp(t->height, cells->doublings), ldexp(t->turn, cells->doublings),
                            cells->rigid + at * (size_t)p->nrigid, q);
    }
    for (int i = 0; i < 6; i++) {
        const double *f = l->fit + (size_t)i * (size_t)p->n;
        for (int k = 0; k < p->n; k++) {
            to->a[i] += f[k] * x[k];
        }
        for (int k = 0; k < p->nrigid; k++) {
            to->a[i] += f[p->at[k]] * q[k];
        }
    }
}

// a part's wrench about the centre along a, b, z -> about the origin in the section's axes
static void add_wrench(const cut *c, int part, const double *force, double sign, vec6 *to)
{
    const cut_part *p = &c->part[part];
    const mat3 turn = mat3_rot_z(c->angle);
    vec6 w = {0};
    for (int k = 0; k < p->nrigid; k++) {
        w.a[p->rigid[k]] = sign * force[p->at[k]];
    }
    const vec3 n = mat3_mul_vec(turn, vec6_linear(w)), m = mat3_mul_vec(turn, vec6_angular(w));
    const vec3 moment = vec3_add(m, vec3_cross((vec3){{c->centre[0], c->centre[1], 0}}, n));
    for (int i = 0; i < 3; i++) {
        to->a[i] += n.a[i];
        to->a[3 + i] += moment.a[i];
    }
}

static double column_work(int n, const double *f, const double *u)
{
    double sum = 0;
    for (int i = 0; i < n; i++) {
        sum += f[i] * u[i];
    }
    return sum;
}

// energies of the six unit wrenches in every cell, and the largest force that is left over at a
// cut, against the most that the cells' energy allows: |f_i| <= sqrt(K_ii u^T K u)
static void add_energy(const doubling_tree *t, const part_loads *l, const slab_list *cells,
                       const double *lower, const double *upper, double *energy, way_run *run)
{
    const cut_part *p = &t->cut->part[t->part];
    const slab_stiffness *cell = t->grid > 0 ? &t->cell : &t->whole;
    const size_t n = (size_t)p->n, all = n * (size_t)cells->ncolumn;
    for (int k = 0; k < cells->count; k++) {
        for (int i = 0; i < l->count; i++) {
            const size_t at = (size_t)k * all + (size_t)i * n;
            for (int j = 0; j < l->count && l->column[i] < 6; j++) {
                const size_t to = (size_t)k * all + (size_t)j * n;
                if (l->column[j] < 6) {
                    energy[36 * k + 6 * l->column[i] + l->column[j]] +=
                        column_work((int)n, lower + at, cells->lower + to) +
                        column_work((int)n, upper + at, cells->upper + to);
                }
            }
            const double own = column_work((int)n, lower + at, cells->lower + at) +
                               column_work((int)n, upper + at, cells->upper + at);
            for (size_t m = 0; k + 1 < cells->count && m < n; m++) {
                const double left = fabs(upper[at + m] + lower[at + all + m]);
                const double stiff = (cell->P[m * n + m] + cell->N[m * n + m]) / 2;
                run->residual = fmax(run->residual, left > 0 ? left / sqrt(stiff * own) : 0);
            }
        }
    }
}

static void add_cuts(const doubling *d, const doubling_tree *t, const part_loads *l,
                     const slab_list *cells, const double *lower, const double *upper, way_run *run)
{
    const size_t n = (size_t)d->cut.part[t->part].n;
    for (int j = 0; j < l->count; j++) {
        const size_t row = (size_t)l->column[j] * (size_t)run->nlevel;
        for (int k = 0; k < run->nlevel; k++) {
            const size_t cell = (size_t)(k ? k - 1 : 0) * (size_t)cells->ncolumn + (size_t)j;
            add_motion(d, t, l, cells, j, k, &run->motion[row + (size_t)k]);
            add_wrench(&d->cut, t->part, (k ? upper : lower) + cell * n, k ? 1 : -1,
                       &run->resultant[row + (size_t)k]);
        }
    }
}

static void add_work(const doubling *d, int part, const part_loads *l, const double *u0,
                     const double *u1, double *work)
{
    const size_t n = (size_t)d->cut.part[part].n;
    for (int i = 0; i < l->count; i++) {
        for (int j = 0; j < l->count; j++) {
            work[l->column[i] * d->ncolumn + l->column[j]] +=
                column_work((int)n, l->tip + (size_t)i * n, u1 + (size_t)j * n) +
                column_work((int)n, l->base + (size_t)i * n, u0 + (size_t)j * n);
        }
    }
}

status doubling_answer_add(const doubling *d, const doubling_tree *t, double *cell_energy,
                           way_run *run)
{
    status st = OK;
    const size_t n = (size_t)d->cut.part[t->part].n;
    part_loads l = {0};
    slab_list cells = {0};
    double *u = NULL, *force = NULL;
    TRY(part_loads_make(d, t->part, &l));
    if (l.count == 0) {
        goto done;
    }
    const size_t all = n * (size_t)l.count;
    TRY(TAKE(u, 2 * all));
    TRY(doubling_tree_ends(t, (int)d->problem->base, (int)d->problem->tip, l.count, l.tip, l.base,
                           u, u + all));
    add_work(d, t->part, &l, u, u + all, run->work);
    TRY(slab_list_whole(t, l.count, u, u + all, &cells));
    for (int k = 0; k < d->grid; k++) {
        TRY(slab_list_halve(t, 0, NULL, &cells));
    }
    TRY(TAKE(force, 2 * all * (size_t)cells.count));
    double *upper = force + all * (size_t)cells.count;
    TRY(doubling_tree_forces(t, &cells, force, upper));
    add_cuts(d, t, &l, &cells, force, upper, run);
    add_energy(t, &l, &cells, force, upper, cell_energy, run);
    if (d->wants->fields) {
        TRY(doubling_fields_add(d, t, l.column, &cells, run));
    }

done:
    part_loads_free(&l);
    slab_list_free(&cells);
    free(u);
    free(force);
    return st;
}

// --- into the base's axes

static vec6 turned(double angle, vec6 w)
{
    const mat3 R = mat3_rot_z(angle);
    const vec3 n = mat3_mul_vec(R, vec6_linear(w)), m = mat3_mul_vec(R, vec6_angular(w));
    return (vec6){{n.a[0], n.a[1], n.a[2], m.a[0], m.a[1], m.a[2]}};
}

// the sum of the cells' energies up to the height z above the base
static void energy_up_to(const doubling *d, const double *cell_energy, double z, double *sum)
{
    const int cells = 1 << d->grid, points = cells < ENERGY_POINTS ? cells + 1 : ENERGY_POINTS;
    const double at = z / d->problem->body->length * cells;
    int first = (int)floor(at) - points / 2 + 1;
    first = first < 0 ? 0 : first > cells + 1 - points ? cells + 1 - points : first;
    double before[36] = {0};
    memset(sum, 0, 36 * sizeof *sum);
    for (int k = 0; k < first + points; k++) {
        double weight = k < first ? 0 : 1;
        for (int i = first; k >= first && i < first + points; i++) {
            weight *= i == k ? 1 : (at - i) / (k - i);
        }
        for (int m = 0; m < 36; m++) {
            sum[m] += weight * before[m];
            before[m] += k < cells ? cell_energy[36 * k + m] : 0;
        }
    }
}

// a unit wrench about the window's centre, as a wrench on the tip
static mat6 window_energy(const doubling *d, const double *cell_energy)
{
    const double centre = d->wants->middle - d->begin, half = d->wants->middle_half;
    const double lever = d->problem->body->length - centre;
    double below[36], above[36];
    mat6 sum = {0}, T = mat6_identity();
    energy_up_to(d, cell_energy, centre - half, below);
    energy_up_to(d, cell_energy, centre + half, above);
    for (int m = 0; m < 36; m++) {
        sum.a[m / 6][m % 6] = above[m] - below[m];
    }
    T.a[MY][NX] = -lever;
    T.a[MX][NY] = lever;
    return mat6_congruence(T, mat6_symmetric(sum));
}

// The cells' own energies against the work on the ends: what rounding on the way up, and back, made
// of the body's stiffness
static double work_missing(const doubling *d, const double *cell_energy, const way_run *run)
{
    double most = 0;
    for (int j = 0; j < 6; j++) {
        const double work = run->work[j * d->ncolumn + j];
        double sum = 0;
        for (int k = 0; k < 1 << d->grid; k++) {
            sum += cell_energy[36 * k + 7 * j];
        }
        most = fmax(most, fabs(sum - work) / fabs(work));
    }
    return most;
}

status doubling_answer_finish(const doubling *d, const double *cell_energy, way_run *run)
{
    const double missing = work_missing(d, cell_energy, run);
    run->residual = fmax(run->residual, missing);
    if (!(missing <= MOST_MISSING)) {
        return status_fail(ERR_NUMERIC, "segment: rounding leaves %.1e of the stiffness uncertain",
                           missing);
    }
    for (int j = 0; j < d->ncolumn; j++) {
        vec6 *motion = run->motion + (size_t)j * (size_t)run->nlevel;
        vec6 *resultant = run->resultant + (size_t)j * (size_t)run->nlevel;
        for (int k = 0; k < run->nlevel; k++) {
            const double angle = d->turn_rate * run->z[k];
            motion[k] = turned(angle, motion[k]);
            resultant[k] = turned(angle, resultant[k]);
        }
        vec6 mean = {0};
        if (d->problem->base == BASE_FREE_TO_CONTRACT) {
            const double *a = motion[0].a;
            mean = (vec6){{a[0], a[1], 0, 0, 0, a[5]}};
        }
        for (int k = 0; k < run->nlevel; k++) {
            motion[k] = vec6_sub(motion[k], mean);
        }
        if (d->wants->fields) {
            doubling_fields_finish(d, j, mean, run);
        }
    }
    run->energy = window_energy(d, cell_energy);
    return OK;
}
