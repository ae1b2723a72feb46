// Nonlinear least squares against NIST's Statistical Reference Datasets (StRD, Nonlinear
// Regression: Misra1a of lower and Thurber of higher difficulty): certified parameters, standard
// deviations and residual sums of squares, https://www.itl.nist.gov/div898/strd/nls/
#include "measure/gsl_door.h"
#include "tests/test.h"

#include <math.h>
#include <string.h>

enum { MOST = 40, MOST_PARAMETERS = 7 };

typedef struct dataset {
    const char *name;
    int n, p;
    double y[MOST], x[MOST];
    double start[2][MOST_PARAMETERS], value[MOST_PARAMETERS], deviation[MOST_PARAMETERS];
    double sum; // of squared residuals
    double (*model)(const double *b, double x, double *db);
} dataset;

static double misra(const double *b, double x, double *db)
{
    const double e = exp(-b[1] * x);
    db[0] = 1 - e;
    db[1] = b[0] * x * e;
    return b[0] * (1 - e);
}

static double thurber(const double *b, double x, double *db)
{
    const double above = b[0] + x * (b[1] + x * (b[2] + x * b[3]));
    const double below = 1 + x * (b[4] + x * (b[5] + x * b[6]));
    for (int i = 0; i < 4; i++) {
        db[i] = pow(x, i) / below;
    }
    for (int i = 1; i < 4; i++) {
        db[3 + i] = -above * pow(x, i) / (below * below);
    }
    return above / below;
}

static const dataset misra1a = {
    .name = "Misra1a",
    .n = 14,
    .p = 2,
    .y = {10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82, 50.76, 55.05, 61.01, 66.40, 75.47,
          81.78},
    .x = {77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4, 434.8, 477.3, 536.8, 593.1, 689.1,
          760.0},
    .start = {{500, 0.0001}, {250, 0.0005}},
    .value = {2.3894212918E+02, 5.5015643181E-04},
    .deviation = {2.7070075241E+00, 7.2668688436E-06},
    .sum = 1.2455138894E-01,
    .model = misra,
};

static const dataset thurber37 = {
    .name = "Thurber",
    .n = 37,
    .p = 7,
    .y = {80.574,   84.248,   87.264,   87.195,   89.076,   89.608,   89.868,   90.101,
          92.405,   95.854,   100.696,  101.060,  401.672,  390.724,  567.534,  635.316,
          733.054,  759.087,  894.206,  990.785,  1090.109, 1080.914, 1122.643, 1178.351,
          1260.531, 1273.514, 1288.339, 1327.543, 1353.863, 1414.509, 1425.208, 1421.384,
          1442.962, 1464.350, 1468.705, 1447.894, 1457.628},
    .x = {-3.067, -2.981, -2.921, -2.912, -2.840, -2.797, -2.702, -2.699, -2.633, -2.481,
          -2.363, -2.322, -1.501, -1.460, -1.274, -1.212, -1.100, -1.046, -0.915, -0.714,
          -0.566, -0.545, -0.400, -0.309, -0.109, -0.103, 0.010,  0.119,  0.377,  0.790,
          0.963,  1.006,  1.115,  1.572,  1.841,  2.047,  2.200},
    .start = {{1000, 1000, 400, 40, 0.7, 0.3, 0.03}, {1300, 1500, 500, 75, 1, 0.4, 0.05}},
    .value = {1.2881396800E+03, 1.4910792535E+03, 5.8323836877E+02, 7.5416644291E+01,
              9.6629502864E-01, 3.9797285797E-01, 4.9727297349E-02},
    .deviation = {4.6647963344E+00, 3.9571156086E+01, 2.8698696102E+01, 5.5675370270E+00,
                  3.1333340687E-02, 1.4984928198E-02, 6.5842344623E-03},
    .sum = 5.6427082397E+03,
    .model = thurber,
};

static status misfit(void *context, const double *x, double *r, double *jacobian)
{
    const dataset *d = context;
    for (int i = 0; i < d->n; i++) {
        double db[MOST_PARAMETERS];
        r[i] = d->model(x, d->x[i], db) - d->y[i];
        for (int k = 0; jacobian && k < d->p; k++) {
            jacobian[i * d->p + k] = db[k];
        }
    }
    return OK;
}

// seven digits of the eleven that NIST certifies: QR of the Jacobian leaves some of them
static const double digits = 1e-7;

static void agrees_with_nist(const gsl_fit_door *door, const dataset *d, int start)
{
    double x[MOST_PARAMETERS], covariance[MOST_PARAMETERS * MOST_PARAMETERS];
    dataset copy = *d;
    least_squares problem = {d->n, d->p, misfit, &copy, 1e-12, 500};
    least_squares_answer answer = {.covariance = covariance};
    memcpy(x, d->start[start], sizeof x);
    CHECK_OK(door->least_squares(&problem, x, &answer));
    const double s2 = answer.cost / (d->n - d->p);
    double worst = 0;
    for (int k = 0; k < d->p; k++) {
        const double deviation = sqrt(s2 * covariance[k * d->p + k]);
        CHECK_NEAR(x[k], d->value[k], digits);
        CHECK_NEAR(deviation, d->deviation[k], digits);
        worst = fmax(worst, fabs(x[k] / d->value[k] - 1));
        worst = fmax(worst, fabs(deviation / d->deviation[k] - 1));
    }
    CHECK_NEAR(answer.cost, d->sum, digits);
    printf("%s from start %d: %d steps, worst relative difference %.1e\n", d->name, start + 1,
           answer.steps, worst);
}

// a sum of two parameters: nothing tells them apart
static status sum_of_two(void *context, const double *x, double *r, double *jacobian)
{
    (void)context;
    for (int i = 0; i < 5; i++) {
        r[i] = (x[0] + x[1]) * i - 2 * i + (i % 2);
        for (int k = 0; jacobian && k < 2; k++) {
            jacobian[2 * i + k] = i;
        }
    }
    return OK;
}

static status refuses(void *context, const double *x, double *r, double *jacobian)
{
    (void)context, (void)x, (void)r, (void)jacobian;
    return status_fail(ERR_INTERRUPTED, "stopped");
}

static void tells_what_cannot_be_fitted(const gsl_fit_door *door)
{
    double x[2] = {0, 0}, covariance[4];
    least_squares_answer answer = {.covariance = covariance};
    const least_squares sum = {5, 2, sum_of_two, NULL, 1e-10, 100};
    CHECK(door->least_squares(&sum, x, &answer) == ERR_NUMERIC);
    CHECK(strstr(status_message(), "cannot be told"));
    status_clear();
    const least_squares few = {1, 2, sum_of_two, NULL, 1e-10, 100};
    CHECK(door->least_squares(&few, x, &answer) == ERR_NUMERIC);
    status_clear();
    const least_squares stops = {5, 2, refuses, NULL, 1e-10, 100};
    CHECK(door->least_squares(&stops, x, &answer) == ERR_INTERRUPTED);
    status_clear();
}

static void eigenvalues_of_two(const gsl_fit_door *door)
{
    const double a[4] = {2, 1, 1, 2};
    double value[2], vector[4];
    CHECK_OK(door->eigen(2, a, value, vector));
    CHECK_NEAR(value[0], 1, 1e-14);
    CHECK_NEAR(value[1], 3, 1e-14);
    CHECK_NEAR(vector[0], -vector[2], 1e-14);
}

int main(void)
{
    const gsl_fit_door *door = NULL;
    CHECK_OK(gsl_fit_door_open(&door));
    if (door) {
        for (int start = 0; start < 2; start++) {
            agrees_with_nist(door, &misra1a, start);
            agrees_with_nist(door, &thurber37, start);
        }
        tells_what_cannot_be_fitted(door);
        eigenvalues_of_two(door);
    }
    return test_failures != 0;
}
