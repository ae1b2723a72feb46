// reports/sensitivity_result.c
#include "reports/sensitivity_result.h"

#include "base/memory.h"

#include <math.h>

status sensitivity_result_make(int nmover, int nsolution, sensitivity_result *out)
{
    status st = OK;
    sensitivity_result r = {.nmover = nmover, .nsolution = nsolution};
    TRY(TAKE(r.mover, (size_t)nmover));
    TRY(TAKE(r.solution, (size_t)nsolution));
    TRY(TAKE(r.move, (size_t)nmover * (size_t)nsolution));
    *out = r;
    r = (sensitivity_result){0};

done:
    sensitivity_result_free(&r);
    return st;
}

static void monte_carlo_free(monte_carlo *m)
{
    free(m->used);
    free(m->spread);
    free(m->share);
    *m = (monte_carlo){0};
}

status monte_carlo_make(const sensitivity_result *r, monte_carlo *out)
{
    status st = OK;
    monte_carlo m = {0};
    const size_t n = (size_t)r->nsolution;
    TRY(TAKE(m.used, n));
    TRY(TAKE(m.spread, n * SPREAD_QUANTITIES));
    TRY(TAKE(m.share, n * SPREAD_QUANTITIES * (size_t)r->nmover));
    *out = m;
    m = (monte_carlo){0};

done:
    monte_carlo_free(&m);
    return st;
}

void sensitivity_result_free(sensitivity_result *r)
{
    free(r->mover);
    free(r->solution);
    free(r->move);
    monte_carlo_free(&r->monte_carlo);
    *r = (sensitivity_result){0};
}

const move *sensitivity_move(const sensitivity_result *r, int mover, int solution)
{
    return &r->move[(size_t)mover * (size_t)r->nsolution + (size_t)solution];
}

const sample_spread *sensitivity_spread(const sensitivity_result *r, int solution, int quantity)
{
    return &r->monte_carlo.spread[(size_t)solution * SPREAD_QUANTITIES + (size_t)quantity];
}

const double *sensitivity_share(const sensitivity_result *r, int solution, int quantity)
{
    const size_t row = (size_t)solution * SPREAD_QUANTITIES + (size_t)quantity;
    return &r->monte_carlo.share[row * (size_t)r->nmover];
}

static double norm3(const double *a)
{
    return hypot(hypot(a[0], a[1]), a[2]);
}

double move_size(const move *m, int end)
{
    return norm3(m->moved[end]);
}

double move_linear(const mover *p, const move *m, int end)
{
    return norm3(m->rate) * fabs(p->end[end].value - p->value);
}

// two solves agree to this part of the length
static const double solves_agree = 1e-6;

double move_nonlinearity(const mover *p, const move *m, int end, double length)
{
    const double step = p->end[end].value - p->value;
    double off[3];
    for (int i = 0; i < 3; i++) {
        off[i] = m->moved[end][i] - step * m->rate[i];
    }
    const double size = move_size(m, end);
    return size > solves_agree * length ? norm3(off) / size : NAN;
}

double move_largest(const move *m)
{
    const double low = move_size(m, MOVER_LOW), high = move_size(m, MOVER_HIGH);
    return fmax(isnan(low) ? 0 : low, isnan(high) ? 0 : high);
}

// by insertion: parameters are few, and equal ones stay as the case has them
void sensitivity_sort(const sensitivity_result *r, int solution, int *order)
{
    for (int i = 0; i < r->nmover; i++) {
        int k = i;
        const double size = move_largest(sensitivity_move(r, i, solution));
        while (k > 0 && move_largest(sensitivity_move(r, order[k - 1], solution)) < size) {
            order[k] = order[k - 1];
            k--;
        }
        order[k] = i;
    }
}
