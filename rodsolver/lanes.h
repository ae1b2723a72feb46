// rodsolver/lanes.h
// Eight numbers beside each other: the same arithmetic for eight stations, panels or pairs at once.
#pragma once

enum { LANES = 8 };

typedef double lanes __attribute__((vector_size(LANES * sizeof(double)), may_alias));

// the same anywhere in a row of numbers
typedef double loose_lanes
    __attribute__((vector_size(LANES * sizeof(double)), may_alias, aligned(sizeof(double))));

// Rows of numbers that are read in lanes have this many behind their end: what stands in idle lanes
// is computed with and never looked at.
enum { ROW_PADDING = LANES };

// One compiled form for each width of vectors that processors have, chosen when the program starts.
// Every lane is computed alike in all of them, to the last bit
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define LANES_CODE __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define LANES_CODE
#endif

#define LANES_INLINE static inline __attribute__((always_inline))

LANES_INLINE void lanes_load(const double *row, lanes *out)
{
    *out = *(const loose_lanes *)row;
}
