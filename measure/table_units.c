// measure/table_units.c
#include "measure/table_units.h"

#include "io/key_names.h"

#include <stdio.h>
#include <string.h>

// beside the units of keys (io/key_names.c)
static const table_unit more[] = {
    {"", DIM_NONE, 1},
    {"-", DIM_NONE, 1},
    {"1", DIM_NONE, 1},
    {"mm/mm", DIM_NONE, 1},
    {"m/m", DIM_NONE, 1},
    {"mm_per_mm", DIM_NONE, 1},
    {"strain", DIM_NONE, 1},
    {"%", DIM_NONE, 0.01},
    {"percent", DIM_NONE, 0.01},
    {"pct", DIM_NONE, 0.01},
    {"\xc2\xb5m", DIM_LENGTH, 1e-6}, // the micro sign
    {"\xce\xbcm", DIM_LENGTH, 1e-6}, // the letter mu
    {"\xb5m", DIM_LENGTH, 1e-6},     // the micro sign of Latin-1
    {"in", DIM_LENGTH, 0.0254},
    {"inch", DIM_LENGTH, 0.0254},
    {"inches", DIM_LENGTH, 0.0254},
    {"kN", DIM_FORCE, 1e3},
    {"KN", DIM_FORCE, 1e3},
    {"gf", DIM_FORCE, 9.80665e-3},
    {"kgf", DIM_FORCE, 9.80665},
    {"lbf", DIM_FORCE, 4.4482216152605},
    {"Mpa", DIM_STRESS, 1e6},
    {"KPa", DIM_STRESS, 1e3},
    {"N/mm^2", DIM_STRESS, 1e6},
    {"N/mm2", DIM_STRESS, 1e6},
    {"N/mm\xc2\xb2", DIM_STRESS, 1e6}, // a raised 2
    {"N/mm\xb2", DIM_STRESS, 1e6},     // that of Latin-1
    {"N_per_mm2", DIM_STRESS, 1e6},
    {"N/m^2", DIM_STRESS, 1},
    {"N/m2", DIM_STRESS, 1},
    {"psi", DIM_STRESS, 6894.757293168361},
    {"ksi", DIM_STRESS, 6894757.293168361},
    {"mm^2", DIM_AREA, 1e-6},
    {"mm\xc2\xb2", DIM_AREA, 1e-6},
    {"mm\xb2", DIM_AREA, 1e-6},
    {"sq mm", DIM_AREA, 1e-6},
    {"m^2", DIM_AREA, 1},
    {"cm^2", DIM_AREA, 1e-4},
    {"in^2", DIM_AREA, 0.0254 * 0.0254},
    {"\xc2\xb0", DIM_ANGLE, 0.017453292519943295769},
    {"s", DIM_COUNT, 1},
    {"sec", DIM_COUNT, 1},
    {"ms", DIM_COUNT, 1},
    {"min", DIM_COUNT, 1},
    {"mm/min", DIM_COUNT, 1},
    {"mm/s", DIM_COUNT, 1},
    {"1/s", DIM_COUNT, 1},
    {"%/min", DIM_COUNT, 1},
    {"Hz", DIM_COUNT, 1},
    {"J", DIM_COUNT, 1},
    {"mJ", DIM_COUNT, 1},
    {"C", DIM_COUNT, 1},
    {"\xc2\xb0"
     "C",
     DIM_COUNT, 1},
};

enum { MORE = sizeof more / sizeof *more };

static bool same(const char *unit_name, const char *name, size_t count)
{
    return strlen(unit_name) == count && strncmp(unit_name, name, count) == 0;
}

bool table_unit_find(const char *name, size_t count, table_unit *out)
{
    for (int i = 0; i < MORE; i++) {
        if (same(more[i].name, name, count)) {
            *out = more[i];
            return true;
        }
    }
    for (int d = DIM_NONE + 1; d < DIM_COUNT; d++) {
        const unit *list = NULL;
        const int n = unit_list((dimension)d, &list);
        for (int i = 0; i < n; i++) {
            if (same(list[i].name, name, count)) {
                *out = (table_unit){list[i].name, (dimension)d, list[i].factor};
                return true;
            }
        }
    }
    return false;
}

double table_unit_si(table_unit u, double value)
{
    return unit_to_si(&(unit){u.name, u.factor}, value);
}

void table_unit_words(dimension d, char *words, size_t size)
{
    const unit *list = NULL;
    const int n = unit_list(d, &list);
    size_t used = 0;
    words[0] = '\0';
    if (d == DIM_NONE) {
        (void)snprintf(words, size, "%%, -, mm/mm");
        return;
    }
    for (int i = 0; i < n && used < size; i++) {
        used += (size_t)snprintf(words + used, size - used, "%s%s", i ? ", " : "", list[i].name);
    }
}
