// measure/material_test.h
// Files of tensile tests to one material: curves out of their columns, a modulus of each, all of
// them pooled.
#pragma once

#include "base/key.h"
#include "measure/table.h"
#include "measure/tensile.h"

typedef struct material_settings {
    mark at;
    const char *name;                  // of the material; NULL: from the first file
    const char *source;                // one line on where the data comes from; NULL: none
    double gauge_length, area;         // [m], [m^2]; 0: from the file
    double width, thickness, diameter; // [m] of the cross section, instead of the area
    double departure;                  // see tensile_rule
    double nu;                         // for the block to paste; NAN: not given
    int outliers;                      // OUTLIERS_KEEP, OUTLIERS_LEAVE_OUT
} material_settings;

enum { OUTLIERS_KEEP, OUTLIERS_LEAVE_OUT };

extern const key_table material_settings_keys;

enum { MATERIAL_LABEL = 96, MATERIAL_MOST = 200, MATERIAL_WARNINGS = 16 };

// what readings are divided by, and where that comes from
typedef struct material_size {
    double value;  // [m] or [m^2]; 0: nothing is divided
    char from[64]; // "option --set", "line 5", "lines 3 and 4"; "" where nothing is divided
} material_size;

typedef struct material_specimen {
    char label[MATERIAL_LABEL]; // "bar_1.csv", "bars.csv: B"
    material_size length, area;
    char strain_of[128]; // what its strains rest on: "the unit '%' of 'strain'"
    tensile_curve curve;
    tensile_answer answer;
    bool outlier, used;
} material_specimen;

typedef struct material_result {
    char name[64];
    char source[160]; // "" where nothing is known
    bool synthetic;   // the files say so
    int n;
    material_specimen *specimen; // [MATERIAL_MOST]
    tensile_rule rule;
    tensile_pool pool;  // of those used
    tensile_pool other; // with the outliers where they are left out, without where they are kept
    int noutlier;
    double nu; // NAN: not given
    int nwarning;
    char warning[MATERIAL_WARNINGS][400]; // what to look at, for people
} material_result;

// ERR_FILE "FILE:LINE: words" for files that are no tests, ERR_INPUT where a setting is missing.
status material_measure(int nfile, const char *const *paths, const material_settings *s,
                        material_result *out);
void material_result_free(material_result *r);

// Kept once; those beyond MATERIAL_WARNINGS are not told.
void material_warn(material_result *r, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

// What a table's extensions and forces are divided by (material_sizes.c): settings first, then the
// lines above its names; a warning where both are there and differ.
status material_gauge_length(const table *t, const material_settings *s, material_result *r,
                             material_size *out);
status material_area(const table *t, const material_settings *s, material_result *r,
                     material_size *out);

// The curves of one file, added to r->specimen (material_curves.c).
status material_curves(const char *path, const material_settings *s, material_result *r);
