// fem/apply.h
// K u without K: elements are integrated anew at every product, many columns at once. Strains are
// found level by level in the plane, then along the layers, as products of small dense matrices.
// docs/theory.md (5.14a)
//
// A field on levels from..to-1 is [level][direction][plane node][column]: `block` is the length of
// one level.
#pragma once

#include "fem/body.h"

typedef struct apply apply;

// For the layers from first to last - 1 of a body without `matter` and not `mixed`; their levels
// must be held. ERR_NUMERIC where det J <= 0, ERR_INPUT where a graded modulus is not positive.
status apply_make(const body *b, int first_layer, int last_layer, apply **out);
void apply_free(apply *a); // NULL is nothing

// f += K u over layers of those above; u and f begin at the level at which first_layer begins.
status apply_layers(apply *a, int first_layer, int last_layer, int ncol, const double *u,
                    double *f);

// Multiplications and additions of one product by one column, of all layers; for the cost model and
// the note on scaling.
double apply_flops(const apply *a);
