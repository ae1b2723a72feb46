// app/segment_source.h
// What a case offers the 3D segment: meshes of the section at its base, and the body that stands on
// one: along the rod's shape at rest, the section as it changes, or the slices of a stack.
#pragma once

#include "app/case.h"

// The case must outlive it. ERR_INPUT ("FILE:LINE:COL: error: ...") where the segment reaches
// beyond a stack, or where the section is none along it. segment_source_free also after a failure.
status segment_source_make(const case_data *c, segment_source *out);
void segment_source_free(segment_source *source);

// Whether the case keeps the section of the base though it changes along the rod, or though the rod
// is bent or twisted at rest; for a warning.
bool segment_source_keeps_prism(const case_data *c);
