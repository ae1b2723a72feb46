// measure/table_units.h
// The units that tables may have: those of the keys of a case, and those that bench machines write.
#pragma once

#include "base/key.h"

typedef struct table_unit {
    const char *name;
    dimension d; // DIM_COUNT: known as a unit, of nothing that is read (seconds)
    double factor;
} table_unit;

// False where `name` (count bytes) is no unit that is known.
bool table_unit_find(const char *name, size_t count, table_unit *out);

// The value in SI; whole parts of an SI unit by division, so that 3.6 mm is the double next to
// 0.0036.
double table_unit_si(table_unit u, double value);

// "mm, m, cm, um": those of a dimension that a person would write.
void table_unit_words(dimension d, char *words, size_t size);
