// meshes/dxf_entity.h
// Entities of a DXF file -> pieces of curves.
#pragma once

#include "meshes/dxf.h"
#include "meshes/dxf_text.h"

// Adds what the entity draws to the plan; of a POLYLINE the entities up to its SEQEND too. Notes
// and dimensions draw nothing. ERR_FILE for what is damaged or has no outline.
status dxf_entity_draw(dxf_text *t, dxf_entity *e, dxf_plan *p);

// SPLINE of degree 1 to 3 without weights, exact: one cubic per interval of its knots.
status dxf_spline_draw(const dxf_text *t, const dxf_entity *e, dxf_plan *p);
