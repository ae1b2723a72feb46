// measure/tensile_loading.c
// From a record of a test to the points of its first loading.
#include "measure/tensile_inside.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// The strain turns back where it falls by this share of all of it, and by so many standard
// deviations of its own noise; the sample has failed where the stress falls by that share from the
// better half of its peak.
static const double turn = 0.02, turn_limit = 8, failure = 0.5;
// a spike, and a slip, in robust standard deviations
static const double spike_limit = 8, slip_limit = 10, slip_least = 0.02;
// a slack as long as this share of the strain is cut off
static const double slack_least = 0.2;

enum { SLIP_SIDE = 8, SLACK_FIRST = 9 };

status tensile_curve_make(int n, tensile_curve *out)
{
    status st = OK;
    tensile_curve c = {.n = n};
    TRY(TAKE(c.strain, (size_t)n));
    TRY(TAKE(c.stress, (size_t)n));
    *out = c;
    c = (tensile_curve){0};

done:
    tensile_curve_free(&c);
    return st;
}

void tensile_curve_free(tensile_curve *c)
{
    free(c->strain);
    free(c->stress);
    *c = (tensile_curve){0};
}

static void keep(tensile_curve *c, double strain, double stress)
{
    c->strain[c->n] = strain;
    c->stress[c->n++] = stress;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(int n, double *a)
{
    qsort(a, (size_t)n, sizeof *a, ascending);
    return n % 2 ? a[n / 2] : 0.5 * (a[n / 2 - 1] + a[n / 2]);
}

// a record of compression has both signs the other way
static void turn_signs(tensile_curve *c, tensile_answer *a)
{
    int far = 0;
    for (int i = 0; i < c->n; i++) {
        far = fabs(c->strain[i] - c->strain[0]) > fabs(c->strain[far] - c->strain[0]) ? i : far;
    }
    a->turned = c->strain[far] < c->strain[0] && c->stress[far] < c->stress[0];
    for (int i = 0; a->turned && i < c->n; i++) {
        c->strain[i] = -c->strain[i];
        c->stress[i] = -c->stress[i];
    }
}

// the strain's noise, from its second differences: steady motion has none
static status strain_noise(const tensile_curve *c, double *noise)
{
    status st = OK;
    double *size = NULL;
    *noise = 0;
    TRY(TAKE(size, (size_t)c->n));
    for (int i = 1; i + 1 < c->n; i++) {
        size[i - 1] = fabs(c->strain[i - 1] - 2 * c->strain[i] + c->strain[i + 1]);
    }
    *noise = c->n > 2 ? 1.4826 / sqrt(6) * median(c->n - 2, size) : 0;

done:
    free(size);
    return st;
}

// up to the largest strain before it first turns back, or the largest stress before it fails
static void cut_loading(tensile_curve *c, double noise, tensile_answer *a)
{
    double low = INFINITY, high = -INFINITY, most = -INFINITY;
    for (int i = 0; i < c->n; i++) {
        low = fmin(low, c->strain[i]);
        high = fmax(high, c->strain[i]);
        most = fmax(most, c->stress[i] - c->stress[0]);
    }
    const double back = fmax(turn * (high - low), turn_limit * noise);
    int top = 0, peak = 0, end = c->n;
    for (int i = 0; i < c->n && end == c->n; i++) {
        top = c->strain[i] > c->strain[top] ? i : top;
        peak = c->stress[i] > c->stress[peak] ? i : peak;
        const double rise = c->stress[peak] - c->stress[0];
        if (c->strain[i] < c->strain[top] - back) {
            end = top + 1;
        } else if (rise > 0.5 * most && c->stress[i] < c->stress[peak] - failure * most) {
            end = peak + 1;
        }
    }
    a->unloads = end < c->n;
    c->n = end;
}

static void drop_first(tensile_curve *c, int count)
{
    c->n -= count;
    memmove(c->strain, c->strain + count, (size_t)c->n * sizeof(double));
    memmove(c->stress, c->stress + count, (size_t)c->n * sizeof(double));
}

// The strain begins to rise where it was lowest: what stands before is rest, or settling
static void cut_rest(tensile_curve *c)
{
    int low = 0;
    for (int i = 1; i < c->n; i++) {
        low = c->strain[i] < c->strain[low] ? i : low;
    }
    drop_first(c, low);
}

// The sample is slack up to where the stress, on its way to the peak, is last as low as it was at
// first. A short slack is left to the choice of the stretch, as the toe is                 (9.88)
static void cut_slack(tensile_curve *c)
{
    double first[SLACK_FIRST];
    int peak = 0, slack = 0;
    if (c->n < 4 * SLACK_FIRST) {
        return;
    }
    memcpy(first, c->stress, sizeof first);
    const double level = median(SLACK_FIRST, first);
    for (int i = 1; i < c->n; i++) {
        peak = c->stress[i] > c->stress[peak] ? i : peak;
    }
    for (int i = SLACK_FIRST; i < peak; i++) {
        slack = c->stress[i] <= level ? i : slack;
    }
    const double long_enough = slack_least * (c->strain[c->n - 1] - c->strain[0]);
    drop_first(c, c->strain[slack] - c->strain[0] > long_enough ? slack : 0);
}

// points that stand out from the line between their neighbours
static status drop_spikes(tensile_curve *c, tensile_answer *a)
{
    status st = OK;
    double *off = NULL, *size = NULL;
    const int n = c->n;
    TRY(TAKE(off, (size_t)n + 1));
    TRY(TAKE(size, (size_t)n + 1));
    for (int i = 1; i + 1 < n; i++) {
        off[i] = c->stress[i] - 0.5 * (c->stress[i - 1] + c->stress[i + 1]);
        size[i - 1] = fabs(off[i]);
    }
    const double limit = n > 2 ? spike_limit * 1.4826 * median(n - 2, size) : INFINITY;
    c->n = 0;
    for (int i = 0; i < n; i++) {
        // a spike's neighbours stand out by half as much, to the other side
        const bool spike = i > 0 && i + 1 < n && fabs(off[i]) > limit && limit > 0 &&
                           fabs(off[i]) > 1.5 * fabs(off[i - 1]) &&
                           fabs(off[i]) > 1.5 * fabs(off[i + 1]) && off[i] * off[i - 1] <= 0 &&
                           off[i] * off[i + 1] <= 0;
        a->nspike += spike;
        if (!spike) {
            keep(c, c->strain[i], c->stress[i]);
        }
    }

done:
    free(off);
    free(size);
    return st;
}

static void drop_duplicates(tensile_curve *c, tensile_answer *a)
{
    const int n = c->n;
    c->n = 0;
    for (int i = 0; i < n; i++) {
        const bool again = i > 0 && c->n > 0 && c->strain[i] == c->strain[c->n - 1] &&
                           c->stress[i] == c->stress[c->n - 1];
        a->nduplicate += again;
        if (!again) {
            keep(c, c->strain[i], c->stress[i]);
        }
    }
}

// how much the stress is lower behind i than the points before let expect
static double step_at(const tensile_curve *c, int i)
{
    const int m = SLIP_SIDE;
    double before[SLIP_SIDE], behind[SLIP_SIDE], rise[2 * SLIP_SIDE];
    int n = 0;
    for (int k = 1; k < m; k++) {
        rise[n++] = c->stress[i - k] - c->stress[i - k - 1];
        rise[n++] = c->stress[i + k] - c->stress[i + k - 1];
    }
    const double each = median(n, rise);
    for (int k = 0; k < m; k++) {
        before[k] = c->stress[i - 1 - k] + k * each;
        behind[k] = c->stress[i + k] - k * each;
    }
    return median(m, before) + each - median(m, behind);
}

static status cut_at_slip(tensile_curve *c, tensile_answer *a)
{
    status st = OK;
    double *step = NULL, *size = NULL, most = 0;
    const int n = c->n, side = SLIP_SIDE;
    int slip = -1;
    a->slip = NAN;
    if (n < 6 * side) {
        return OK;
    }
    TRY(TAKE(step, (size_t)n));
    TRY(TAKE(size, (size_t)n));
    for (int i = 0; i < n; i++) {
        most = fmax(most, fabs(c->stress[i]));
    }
    for (int i = side; i + side < n; i++) {
        step[i] = step_at(c, i);
        size[i - side] = fabs(step[i]);
    }
    const double limit = slip_limit * 1.4826 * median(n - 2 * side, size);
    for (int i = side; i + side < n && slip < 0; i++) {
        if (step[i] > fmax(limit, slip_least * most)) {
            slip = i;
        }
    }
    if (slip > 0) {
        // the whole of the step's surroundings: where it is largest
        int top = slip;
        for (int i = slip; i < slip + side && i + side < n; i++) {
            top = step[i] > step[top] ? i : top;
        }
        a->slip = c->strain[top];
        c->n = slip;
    }

done:
    free(step);
    free(size);
    return st;
}

status tensile_loading(const tensile_curve *c, tensile_curve *out, tensile_answer *a)
{
    status st = OK;
    tensile_curve l = {0};
    double noise = 0;
    TRY(tensile_curve_make(c->n, &l));
    l.n = 0;
    for (int i = 0; i < c->n; i++) {
        if (isfinite(c->strain[i]) && isfinite(c->stress[i])) {
            keep(&l, c->strain[i], c->stress[i]);
        }
    }
    if (l.n > 0) {
        turn_signs(&l, a);
        drop_duplicates(&l, a);
        TRY(drop_spikes(&l, a));
        TRY(strain_noise(&l, &noise));
        cut_loading(&l, noise, a);
        cut_rest(&l);
        cut_slack(&l);
        TRY(cut_at_slip(&l, a));
    }
    a->nloading = l.n;
    if (l.n < TENSILE_FEWEST) {
        TRY(status_fail(ERR_FILE, "%d point%s of a first loading: %d or more are needed", l.n,
                        l.n == 1 ? "" : "s", TENSILE_FEWEST));
    }
    if (!(l.strain[l.n - 1] > l.strain[0])) {
        TRY(status_fail(ERR_FILE, "the strain does not rise"));
    }
    *out = l;
    l = (tensile_curve){0};

done:
    tensile_curve_free(&l);
    return st;
}

status tensile_thin(const tensile_curve *c, double end, int most, tensile_curve *out)
{
    status st = OK;
    tensile_curve t = {0};
    int n = 0;
    while (n < c->n && c->strain[n] <= end) {
        n++;
    }
    const int each = 1 + (n - 1) / most;
    TRY(tensile_curve_make(n / each + 1, &t));
    t.n = 0;
    for (int i = 0; i + each <= n; i += each) {
        double strain = 0, stress = 0;
        for (int k = i; k < i + each; k++) {
            strain += c->strain[k] / each;
            stress += c->stress[k] / each;
        }
        keep(&t, strain, stress);
    }
    *out = t;
    t = (tensile_curve){0};

done:
    tensile_curve_free(&t);
    return st;
}
