// tests/test.h
// A test is a small program whose functions are sentences; main returns test_failures != 0.
#pragma once

#include "base/status.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

static int test_failures;

// Whole campaigns, ./run long; the check runs a short form of them.
static inline bool test_is_long(void)
{
    return getenv("STIFFAXIS_LONG") != NULL;
}

#define CHECK(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            test_failures++;                                                                       \
            printf("%s:%d: %s does not hold\n", __FILE__, __LINE__, #condition);                   \
        }                                                                                          \
    } while (0)

// |value - wanted| <= tolerance * max(|wanted|, floor of 1e-300); written so that a NaN fails
#define CHECK_NEAR(value, wanted, tolerance)                                                       \
    do {                                                                                           \
        const double v_ = (value), w_ = (wanted), t_ = (tolerance);                                \
        if (!(fabs(v_ - w_) <= t_ * fabs(w_))) {                                                   \
            test_failures++;                                                                       \
            printf("%s:%d: %s = %.15g, wanted %.15g, relative difference %.3g > %.3g\n", __FILE__, \
                   __LINE__, #value, v_, w_, fabs(v_ - w_) / fabs(w_), t_);                        \
        }                                                                                          \
    } while (0)

// |value - wanted| <= tolerance, in the value's own unit
#define CHECK_WITHIN(value, wanted, tolerance)                                                     \
    do {                                                                                           \
        const double v_ = (value), w_ = (wanted), t_ = (tolerance);                                \
        if (!(fabs(v_ - w_) <= t_)) {                                                              \
            test_failures++;                                                                       \
            printf("%s:%d: %s = %.15g, wanted %.15g, difference %.3g > %.3g\n", __FILE__,          \
                   __LINE__, #value, v_, w_, fabs(v_ - w_), t_);                                   \
        }                                                                                          \
    } while (0)

#define CHECK_OK(call)                                                                             \
    do {                                                                                           \
        if ((call) != OK) {                                                                        \
            test_failures++;                                                                       \
            printf("%s:%d: %s failed: %s\n", __FILE__, __LINE__, #call, status_message());         \
            status_clear();                                                                        \
        }                                                                                          \
    } while (0)

// least-squares slope of log(error) over log(h): the observed order
static inline double observed_order(int n, const double *h, const double *error)
{
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int i = 0; i < n; i++) {
        const double x = log(h[i]), y = log(error[i]);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}
