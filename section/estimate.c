// section/estimate.c
#include "section/estimate.h"

#include "section/corners.h"
#include "section/section.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// Rounding of the solves, relative: turning and moving a section shows 5e-13 to 5e-12.
static const double rounding_level = 1e-11;

// Order 1 against order 2: order 2 itself keeps up to a third of the error of order 1.
static const double linear_margin = 1.5;

// --- smooth fields, and meshes that shrink towards corners

// Away from corners each order takes the same part of what the one before has left, so the error is
// d1 r, r = d1 / d2. The first orders flatter: no faster decay than this is believed. The margin
// covers decays that still slow down.
static const double least_ratio = 0.01, least_ratio_of_3 = 0.005, smooth_margin = 3;
// elements that grow away from a corner by a factor each gain less
static const double least_ratio_of_layers = 0.05;
// where an edge's curvature jumps, the field has the exponent 2, and no mesh shrinks towards it
static const double exponent_of_bends = 2;

// without a second difference (order 2)
static const double assumed_ratio = 0.25;

static double smooth_left(int p, double least, double d1, double d2)
{
    const double r = p == 2 ? assumed_ratio : d2 > d1 ? d1 / d2 : 1;
    return smooth_margin * d1 * fmax(r, least);
}

// What order p keeps next to corners, over what the last layer of elements there has taken at order
// p - 1; where there is no layer yet, over what the first one would take. A layer takes all but
// 0.03 to 0.12 of what the ones before have left (in energy 5^(-2 lambda), lambda >= 2/3 at strong
// corners), an order all but (1 - 1/p)^(4 lambda).
static const double of_last_layer[] = {0, 0.02, 0.1}, of_first_layer[] = {0, 0.1, 0.4};

// |a - b|_ij / sqrt(a_ii a_jj)
static mat6 difference(mat6 a, mat6 b)
{
    mat6 d;
    for (int i = 0; i < 36; i++) {
        const int row = i / 6, column = i % 6;
        d.a[row][column] =
            fabs(a.a[row][column] - b.a[row][column]) / sqrt(a.a[row][row] * a.a[column][column]);
    }
    return d;
}

// the place of the largest entry in a row after row; of a NaN where there is one
static int place_of_largest(mat6 a)
{
    int place = 0;
    for (int i = 0; i < 36; i++) {
        const double x = a.a[i / 6][i % 6], most = a.a[place / 6][place % 6];
        place = x <= most || isnan(most) ? place : i;
    }
    return place;
}

static double largest(mat6 a)
{
    const int i = place_of_largest(a);
    return a.a[i / 6][i % 6];
}

// No entry is said to be better than this part of the worst: the differences of single entries may
// be small by accident.
static const double best_entry = 0.1;

// Compliances of finite elements err to one side, so errors of K make a definite matrix: an entry's
// is at most the geometric mean of its diagonals'. Rounding is in all of them.
static void set_errors(mat6 part, double rounding, beam_law *law)
{
    mat6 *e = &law->entry_error;
    const double least = best_entry * largest(part);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            const double bound = fmax(sqrt(part.a[i][i] * part.a[j][j]), part.a[i][j]);
            e->a[i][j] = fmax(bound, least) + rounding;
        }
    }
    law->relative_error = largest(*e);
}

// What the estimate is made of.
typedef struct trial {
    beam_law law;
    double rounding;
    mat6 smooth, corner; // relative, by entry
} trial;

static status solve_order(const mesh_solver *s, const mesh *m, int order, mat6 *K)
{
    status st = OK;
    mesh other = {0};
    beam_law law = {0};
    TRY(mesh_of_order(m, order, &other));
    TRY(s->solve(s->what, &other, &law));
    *K = law.K;

done:
    mesh_free(&other);
    return st;
}

// how much of the differences to the next lower order is left, by the largest of them
static double part_left(const mesh_solver *s, const mesh_options *options, const corners *found,
                        int p, mat6 to_lower, mat6 to_lowest)
{
    const int i = place_of_largest(to_lower);
    const double d1 = to_lower.a[i / 6][i % 6], d2 = to_lowest.a[i / 6][i % 6];
    const bool corner = found->strongest != CORNER_NONE;
    const double least = corner ? least_ratio_of_layers : p == 3 ? least_ratio_of_3 : least_ratio;
    const double bent = found->bends ? pow((p - 1.0) / p, 4 * exponent_of_bends) : 0;
    const bool geometric = !corner || (s->graded && !(options->size > 0));
    const double left =
        geometric ? smooth_left(p, fmax(least, bent), d1, d2) : section_error_left(p, d1, d2);
    return d1 > 0 ? left / d1 : 0;
}

static bool same_places(const mesh *a, const mesh *b)
{
    return a->nnode == b->nnode && mesh_element_count(a) == mesh_element_count(b) &&
           memcmp(a->xyz, b->xyz, 3 * (size_t)a->nnode * sizeof *a->xyz) == 0;
}

// K at `order` on the mesh with other layers; *same where that is no other mesh
static status with_layers(const mesh_solver *s, const mesh_options *options, int more,
                          const mesh *m, int order, mat6 *K, bool *same)
{
    status st = OK;
    mesh other = {0};
    mesh_options changed = *options;
    changed.layers += more;
    TRY(s->mesh(s->what, &changed, &other));
    *same = same_places(m, &other);
    if (!*same) {
        TRY(solve_order(s, &other, order, K));
    }

done:
    mesh_free(&other);
    return st;
}

// what layers at the corners are worth at a lower order, `with` is K of it on the mesh
static status try_layers(const mesh_solver *s, const mesh_options *options, const mesh *m,
                         corner worst, int order, mat6 with, trial *t)
{
    status st = OK;
    bool same = false;
    mat6 K = with;
    double part = of_last_layer[worst];
    if (worst == CORNER_NONE || !s->graded || options->size > 0) {
        return OK;
    }
    TRY(with_layers(s, options, -1, m, order, &K, &same));
    if (same) {
        part = of_first_layer[worst];
        TRY(with_layers(s, options, 1, m, order, &K, &same));
    }
    t->corner = mat6_scale(part, difference(with, K));

done:
    return st;
}

static status try_orders(const mesh_solver *s, const mesh_options *options, const mesh *m, trial *t)
{
    status st = OK;
    const int p = m->order;
    mat6 lower = {0}, lowest = {0}, d2 = {0};
    corners found = {.strongest = CORNER_NONE};
    if (s->materials) {
        TRY(corners_find(m, s->materials, s->turning, &found));
    }
    TRY(s->solve(s->what, m, &t->law));
    TRY(solve_order(s, m, p - 1, &lower));
    const mat6 d1 = difference(t->law.K, lower);
    if (p > 2) {
        TRY(solve_order(s, m, p - 2, &lowest));
        d2 = difference(lower, lowest);
    }
    t->smooth = mat6_scale(part_left(s, options, &found, p, d1, d2), d1);
    // order 1 tells nothing of corners
    TRY(try_layers(s, options, m, found.strongest, p > 2 ? p - 1 : p, p > 2 ? lower : t->law.K, t));

done:
    return st;
}

// order 1 has no lower order: one of order 2 stands in for the truth, curved where the outlines
// are; where a file holds the mesh, the same elements
static status try_linear(const mesh_solver *s, const mesh_options *options, const mesh *m, trial *t)
{
    status st = OK;
    mesh higher = {0};
    beam_law better = {0};
    mesh_options second = *options;
    second.order = 2;
    TRY(s->solve(s->what, m, &t->law));
    TRY(s->graded ? s->mesh(s->what, &second, &higher) : mesh_of_order(m, 2, &higher));
    TRY(s->solve(s->what, &higher, &better));
    t->smooth = mat6_scale(linear_margin, difference(t->law.K, better.K));

done:
    mesh_free(&higher);
    return st;
}

static status try_options(const mesh_solver *s, const mesh_options *options, trial *t)
{
    status st = OK;
    mesh m = {0};
    *t = (trial){0};
    TRY(s->mesh(s->what, options, &m));
    TRY(m.order > 1 ? try_orders(s, options, &m, t) : try_linear(s, options, &m, t));
    t->rounding = fmax(rounding_level, t->law.relative_error);
    set_errors(mat6_add(t->smooth, t->corner), t->rounding, &t->law);

done:
    mesh_free(&m);
    return st;
}

status estimate_solve(const mesh_solver *s, const mesh_options *options, beam_law *out)
{
    trial t;
    const status st = try_options(s, options, &t);
    *out = t.law;
    return st;
}

// --- a tolerance

// meshes that are tried
enum { MOST_TRIES = 8 };

// Orders for a beginning, by the tolerance: lower ones need smaller elements, higher ones cost
// more.
static const double enough_for_2 = 1e-3, enough_for_3 = 1e-5;
// a layer at the corners takes at least this
static const double of_a_layer = 0.15;
// more than this by one step would be guessed, less is no step
static const double most_at_once = 2, least_at_once = 1.2;
// of the rounding, what meshes are still refined to
static const double above_rounding = 10;
// aimed at, of the tolerance
static const double aim = 0.5;

// Shorter elements that also grow less towards corners take the error down by about this power of
// the order.
static const double gain_of_finer = 2.5;

// What dominates is made smaller: corners by layers, the rest by the order and then by the length.
// False where nothing is left to try.
static bool refine(const trial *t, bool free_order, double tolerance, mesh_options *o)
{
    const double corner = largest(t->corner), smooth = largest(t->smooth), want = aim * tolerance;
    const mesh_options before = *o;
    double finer = 1;
    if (corner > want && o->layers < SECTION_MOST_LAYERS) {
        const int more = (int)ceil(log(want / corner) / log(of_a_layer));
        o->layers = (int)fmin(o->layers + more, SECTION_MOST_LAYERS);
    } else if (corner > want) {
        finer = least_at_once;
    }
    if (smooth > want && free_order && o->order < ELEMENT_MAX_ORDER) {
        o->order++;
    } else if (smooth > want) {
        finer = fmin(fmax(finer, pow(smooth / want, 1 / (gain_of_finer * o->order))), most_at_once);
    }
    o->finer = fmin((o->finer > 0 ? o->finer : 1) * finer, SECTION_MOST_FINER);
    return o->layers != before.layers || o->order != before.order || finer > 1;
}

static const char *what_dominates(const trial *t, double tolerance)
{
    const double corner = largest(t->corner), smooth = largest(t->smooth);
    return t->rounding >= tolerance ? "rounding"
           : corner > smooth        ? "the corners, where materials meet or edges turn"
                                    : "the elements' size";
}

// Half the step from the options that did to those that failed; false where nothing lies between.
static bool half_way(const mesh_options *did, mesh_options *o)
{
    const int layers = did->layers + (o->layers - did->layers) / 2;
    const double from = did->finer > 0 ? did->finer : 1, finer = sqrt(from * o->finer);
    const bool any = layers != o->layers || o->finer > least_at_once * from;
    o->layers = layers;
    o->finer = o->finer > least_at_once * from ? finer : o->finer;
    return any && (layers != did->layers || o->finer > from || o->order != did->order);
}

status estimate_meet(const mesh_solver *s, const mesh_options *options, bool free_order,
                     double tolerance, beam_law *out, mesh_options *used)
{
    status st = OK;
    trial t, best = {.law = {.relative_error = INFINITY}};
    mesh_options o = *options;
    if (free_order) {
        o.order = tolerance >= enough_for_2 ? 2 : tolerance >= enough_for_3 ? 3 : ELEMENT_MAX_ORDER;
    }
    bool more = true;
    for (int k = 0; k < MOST_TRIES && more && !(best.law.relative_error <= tolerance); k++) {
        const status one = try_options(s, &o, &t);
        if (one != OK && k > 0 && one != ERR_RESOURCE) {
            // no such mesh can be made or solved: a smaller step, and else what was reached counts
            status_clear();
            more = half_way(used, &o);
            continue;
        }
        TRY(one);
        if (t.law.relative_error < best.law.relative_error) {
            best = t;
            *used = o;
        }
        // below the rounding nothing is gained, but what can be reached is told
        more = refine(&t, free_order, fmax(tolerance, above_rounding * t.rounding), &o);
    }
    if (!(best.law.relative_error <= tolerance)) {
        TRY(status_fail(ERR_NUMERIC,
                        "section: K is met to %.1e, not to the tolerance of %.1e: what remains is "
                        "%s; ask for less",
                        best.law.relative_error, tolerance, what_dominates(&best, tolerance)));
    }
    *out = best.law;

done:
    return st;
}
