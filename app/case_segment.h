// app/case_segment.h
// What the map `fem` of a case needs of the rest of the case.
#pragma once

#include "app/case.h"

status case_segment_check(const case_data *c);

// Whether a load of the segment accelerates it: densities are needed.
bool case_segment_accelerates(const case_data *c);

// ERR_INPUT at the first material of the section's shapes that has no density, which `why` needs; a
// file's materials are known with its mesh.
status case_check_densities(const case_data *c, const char *why);
status case_density_missing(const case_data *c, const material *m, const char *why);
#define CASE_SEGMENT_ACCELERATES "a load of the segment accelerates it"
