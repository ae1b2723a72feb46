// section/known.h
// Sections solved in an earlier run, found again by the content of all that their law depends on.
#pragma once

#include "base/hash.h"
#include "section/place.h"

// The fingerprint of a place with its materials, mesh options, model and tolerance, and of the
// program's version. *known false where something has no content to compare (graded materials).
status section_fingerprint(const section_case *c, const material *materials, const section_place *p,
                           hash *out, bool *known);

// Index; -1 where it is not among them.
int section_known_find(const section_known *k, hash key);
