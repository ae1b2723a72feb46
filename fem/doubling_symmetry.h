// fem/doubling_symmetry.h
// The thin slab of a prism, and the unknowns of its cuts sorted by the symmetries that it has.
#pragma once

#include "fem/doubling_slab.h"

// One of 2^doublings slabs, from s = 0 on.
status doubling_thin_body(const body *b, int doublings, body *out);

// ERR_INPUT where nothing exchanges the slab's ends.
status doubling_slab_make(const body *thin, slab *s, cut *c);
