// fem/level_forces.h
// What elements and springs put on the nodes of a displaced body, level by level. docs/theory.md
// (5.13)
#pragma once

#include "fem/way_fill.h"

struct level_forces {
    // [ncolumn][to - from][nplane][3] K u of elements and springs; whole on the rank's own levels
    double *force;
    // Resultants about the base's origin, of the rank's own layers [ncolumn][layers][order + 1]: of
    // the elements' forces level by level
    vec6 *sum;
    // and of springs: of the layers' walls on the upper level [ncolumn][layers] and on the base
    // [ncolumn]; of all on the rank's own levels [ncolumn][nlevel]
    vec6 *sprung_top, *sprung_base, *sprung;
};

status level_forces_take(const way_field *f, level_forces *out);
void level_forces_free(level_forces *s);

// Of the field's u, anew. Each element is asked with its own mean rigid motion taken away: the
// rounding of its stiffness then is that of strains, not of motions along the whole body.
status level_forces_find(const way_field *f, level_forces *out);
