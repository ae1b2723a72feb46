// measure/tensile_pool.c
// Replicates: one number of several samples, and which of them stand out.
#include "measure/tensile_inside.h"

#include <math.h>

enum { HALVINGS = 200 };

typedef struct spread {
    double weight, mean, excess; // excess: sum w (E - mean)^2
} spread;

static spread spread_at(int n, const tensile_answer *a, const bool *used, double between)
{
    spread s = {0, 0, 0};
    for (int i = 0; i < n; i++) {
        if (used[i]) {
            const double e = a[i].standard_error, w = 1 / (e * e + between);
            s.weight += w;
            s.mean += w * a[i].E;
        }
    }
    s.mean /= s.weight;
    for (int i = 0; i < n; i++) {
        const double e = a[i].standard_error, d = a[i].E - s.mean;
        s.excess += used[i] ? d * d / (e * e + between) : 0;
    }
    return s;
}

// the variance between samples with which what is seen is what is expected: excess = k - 1   (9.86)
static double paule_mandel(int n, const tensile_answer *a, const bool *used, int k)
{
    double low = 0, high = 0;
    if (spread_at(n, a, used, 0).excess <= k - 1) {
        return 0;
    }
    for (int i = 0; i < n; i++) {
        high = fmax(high, a[i].E * a[i].E);
    }
    for (int i = 0; i < HALVINGS; i++) {
        const double middle = 0.5 * (low + high);
        if (spread_at(n, a, used, middle).excess > k - 1) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return 0.5 * (low + high);
}

// the median of the linear ranges: each has the error of its line
static double middle_range(int n, const tensile_answer *a, const bool *used, int k)
{
    double middle = 0;
    for (int i = 0; i < n; i++) {
        int less = 0, same = 0; // places that i takes in the order
        for (int j = 0; j < n; j++) {
            less += used[j] && a[j].linear_strain < a[i].linear_strain;
            same += used[j] && a[j].linear_strain == a[i].linear_strain;
        }
        if (used[i] && less <= (k - 1) / 2 && (k - 1) / 2 < less + same) {
            middle = a[i].linear_strain;
        }
    }
    return middle;
}

status tensile_pool_of(int n, const tensile_answer *a, const bool *used, const tensile_rule *rule,
                       tensile_pool *out)
{
    status st = OK;
    const gsl_random_door *random = NULL;
    tensile_pool p = {.between = NAN, .next = NAN};
    int only = -1;
    TRY(gsl_random_door_open(&random));
    for (int i = 0; i < n; i++) {
        if (used[i]) {
            p.n++;
            p.own = hypot(p.own, a[i].standard_error);
            only = i;
        }
    }
    if (p.n == 0) {
        TRY(status_fail(ERR_FILE, "no curve is left for a modulus"));
    }
    if (p.n == 1) {
        p.E = a[only].E;
        p.standard_error = a[only].standard_error;
        p.freedom = a[only].freedom;
    } else {
        const double between = paule_mandel(n, a, used, p.n);
        const spread s = spread_at(n, a, used, between);
        p.E = s.mean;
        p.freedom = p.n - 1;
        p.between = sqrt(between);
        // never less than the curves' own errors
        p.standard_error = sqrt(fmax(s.excess / p.freedom, 1) / s.weight);
        p.next = random->student(rule->share, p.n) * p.standard_error * sqrt(p.n / (p.n + 1.0));
    }
    p.own /= sqrt(p.n);
    p.linear_strain = middle_range(n, a, used, p.n);
    const double half = p.standard_error * random->student(rule->share, p.freedom);
    p.interval[0] = p.E - half;
    p.interval[1] = p.E + half;
    *out = p;

done:
    return st;
}

// the one furthest from the mean of those that are left, and its distance in standard deviations
static double furthest(int n, const tensile_answer *a, const bool *outlier, int k, int *which)
{
    double mean = 0, square = 0, most = -1;
    for (int i = 0; i < n; i++) {
        mean += outlier[i] ? 0 : a[i].E / k;
    }
    for (int i = 0; i < n; i++) {
        const double d = outlier[i] ? 0 : fabs(a[i].E - mean);
        square += d * d / (k - 1);
        if (!outlier[i] && d > most) {
            most = d;
            *which = i;
        }
    }
    return square > 0 ? most / sqrt(square) : 0;
}

status tensile_outliers(int n, const tensile_answer *a, bool *outlier)
{
    status st = OK;
    const gsl_random_door *random = NULL;
    TRY(gsl_random_door_open(&random));
    for (int i = 0; i < n; i++) {
        outlier[i] = false;
    }
    for (int k = n; k >= 4; k--) {
        int which = 0;
        const double g = furthest(n, a, outlier, k, &which);
        const double t = random->student(1 - 0.05 / k, k - 2);
        if (g <= (k - 1) / sqrt(k) * sqrt(t * t / (k - 2 + t * t))) {
            break;
        }
        outlier[which] = true;
    }

done:
    return st;
}
