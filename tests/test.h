// tests/test.h
// A test is a small program whose functions are sentences; main returns test_failures != 0.
#pragma once

#include "base/status.h"
#include "tests/record.h"

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

// Memory is watched here: of a campaign a few runs do, its numbers are for the build that users
// run.
static inline bool test_is_watched(void)
{
#ifdef __SANITIZE_ADDRESS__
    return true;
#else
    return false;
#endif
}

// what a check judges goes to its record too, tests/record.h
#define RECORD(text, value_, wanted_, error_, tolerance_, holds_)                                  \
    do {                                                                                           \
        static record_place place_ = {.file = __FILE__, .line = __LINE__, .what = text};           \
        record(&place_, __func__,                                                                  \
               (record_numbers){.value = value_,                                                   \
                                .wanted = wanted_,                                                 \
                                .error = error_,                                                   \
                                .tolerance = tolerance_,                                           \
                                .holds = holds_});                                                 \
    } while (0)

// a number that has only a lower bound
#define RECORD_LEAST(text, value_, least_, holds_)                                                 \
    do {                                                                                           \
        static record_place place_ = {.file = __FILE__, .line = __LINE__, .what = text};           \
        record(&place_, __func__,                                                                  \
               (record_numbers){.value = value_,                                                   \
                                .wanted = least_,                                                  \
                                .error = value_ < least_ ? least_ - value_ : 0,                    \
                                .tolerance = 0,                                                    \
                                .holds = holds_,                                                   \
                                .least = true});                                                   \
    } while (0)

// what has no number; a number goes to one of those below, which tell it
#define CHECK(condition)                                                                           \
    do {                                                                                           \
        const bool holds_ = (condition);                                                           \
        RECORD(#condition, NAN, NAN, NAN, NAN, holds_);                                            \
        if (!holds_) {                                                                             \
            test_failures++;                                                                       \
            printf("%s:%d: %s does not hold\n", __FILE__, __LINE__, #condition);                   \
        }                                                                                          \
    } while (0)

// |value - wanted| <= tolerance * |wanted|; written so that a NaN fails
#define CHECK_NEAR(value, wanted, tolerance)                                                       \
    do {                                                                                           \
        const double v_ = (value), w_ = (wanted), t_ = (tolerance);                                \
        const bool holds_ = fabs(v_ - w_) <= t_ * fabs(w_);                                        \
        RECORD(#value, v_, w_, fabs(v_ - w_), t_ *fabs(w_), holds_);                               \
        if (!holds_) {                                                                             \
            test_failures++;                                                                       \
            printf("%s:%d: %s = %.15g, wanted %.15g, relative difference %.3g > %.3g\n", __FILE__, \
                   __LINE__, #value, v_, w_, fabs(v_ - w_) / fabs(w_), t_);                        \
        }                                                                                          \
    } while (0)

// |value - wanted| <= tolerance, in the value's own unit
#define CHECK_WITHIN(value, wanted, tolerance)                                                     \
    do {                                                                                           \
        const double v_ = (value), w_ = (wanted), t_ = (tolerance);                                \
        const bool holds_ = fabs(v_ - w_) <= t_;                                                   \
        RECORD(#value, v_, w_, fabs(v_ - w_), t_, holds_);                                         \
        if (!holds_) {                                                                             \
            test_failures++;                                                                       \
            printf("%s:%d: %s = %.15g, wanted %.15g, difference %.3g > %.3g\n", __FILE__,          \
                   __LINE__, #value, v_, w_, fabs(v_ - w_), t_);                                   \
        }                                                                                          \
    } while (0)

// an error, and how large it may be: value < bound, or <=
#define CHECK_BELOW(value, bound)                                                                  \
    do {                                                                                           \
        const double v_ = (value), t_ = (bound);                                                   \
        const bool holds_ = v_ < t_;                                                               \
        RECORD(#value, v_, 0, v_ < 0 ? 0 : v_, t_, holds_);                                        \
        if (!holds_) {                                                                             \
            test_failures++;                                                                       \
            printf("%s:%d: %s = %.9g is not below %.9g\n", __FILE__, __LINE__, #value, v_, t_);    \
        }                                                                                          \
    } while (0)

#define CHECK_AT_MOST(value, bound)                                                                \
    do {                                                                                           \
        const double v_ = (value), t_ = (bound);                                                   \
        const bool holds_ = v_ <= t_;                                                              \
        RECORD(#value, v_, 0, v_ < 0 ? 0 : v_, t_, holds_);                                        \
        if (!holds_) {                                                                             \
            test_failures++;                                                                       \
            printf("%s:%d: %s = %.9g is not at most %.9g\n", __FILE__, __LINE__, #value, v_, t_);  \
        }                                                                                          \
    } while (0)

// a number, and how large it must be: value > bound, or >=
#define CHECK_ABOVE(value, bound)                                                                  \
    do {                                                                                           \
        const double v_ = (value), t_ = (bound);                                                   \
        const bool holds_ = v_ > t_;                                                               \
        RECORD_LEAST(#value, v_, t_, holds_);                                                      \
        if (!holds_) {                                                                             \
            test_failures++;                                                                       \
            printf("%s:%d: %s = %.9g is not above %.9g\n", __FILE__, __LINE__, #value, v_, t_);    \
        }                                                                                          \
    } while (0)

#define CHECK_AT_LEAST(value, bound)                                                               \
    do {                                                                                           \
        const double v_ = (value), t_ = (bound);                                                   \
        const bool holds_ = v_ >= t_;                                                              \
        RECORD_LEAST(#value, v_, t_, holds_);                                                      \
        if (!holds_) {                                                                             \
            test_failures++;                                                                       \
            printf("%s:%d: %s = %.9g is not at least %.9g\n", __FILE__, __LINE__, #value, v_, t_); \
        }                                                                                          \
    } while (0)

#define CHECK_OK(call)                                                                             \
    do {                                                                                           \
        if ((call) != OK) {                                                                        \
            test_failures++;                                                                       \
            RECORD(#call, NAN, NAN, NAN, NAN, false);                                              \
            printf("%s:%d: %s failed: %s\n", __FILE__, __LINE__, #call, status_message());         \
            status_clear();                                                                        \
        }                                                                                          \
    } while (0)

// least-squares slope of log(error) over log(h): the observed order
static inline double slope_of(int n, const double *h, const double *error)
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

// the slope, its points told
static inline double slope_told(const char *function, const char *what, const char *over, int n,
                                const double *h, const double *error)
{
    const double slope = slope_of(n, h, error);
    record_series(function, what, over, n, h, error, slope);
    return slope;
}

#define observed_order(n, h, error) slope_told(__func__, #error, #h, n, h, error)
