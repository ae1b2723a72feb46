// app/case_segment.h
// What the map `fem` of a case needs of the rest of the case.
#pragma once

#include "app/case.h"

status case_segment_check(const case_data *c);

// ERR_INPUT at the first material of the section's shapes that has no density, which `why` needs; a
// file's materials are known with its mesh.
status case_check_densities(const case_data *c, const char *why);
