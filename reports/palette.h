// reports/palette.h
// Every colour of the figures and of the views in the page, in one place.
//
// tests/unit/reports/test_palette.c holds them to what colour-blind eyes see (docs/results.md).
#pragma once

#include "reports/cairo_door.h"

// what is written and drawn with lines
extern const colour INK, INK_SOFT, INK_FAINT, INK_GRID, INK_ACCENT, INK_SECOND;
extern const colour PAPER;

// targets, bodies and the wall of a reach study
extern const colour REACH_YES, REACH_NO, REACH_OPEN; // reached, not reached, undecided
extern const colour WALL_YES, WALL_NO, WALL_OPEN;    // the same of an area, paler
extern const colour NOT_LOOKED_AT;                   // beside the ramp's colours and INK_ACCENT
extern const colour TISSUE;                          // in space
extern const colour TISSUE_PALE, TISSUE_DEEP, TISSUE_RIM; // as an X-ray shows it

extern const colour LOAD_FOLLOWER; // turns with the section; a dead one is INK
extern const colour NO_MATERIAL;
extern const colour FLOOR, SHADOW;
extern const colour CLOUD_POINT, CLOUD_TUBE, CLOUD_GAP; // of a scan

enum { PALETTE_SIZE = 8 }; // then the colours come round

colour colour_mix(colour a, colour b, double t); // t = 0: a, t = 1: b
colour colour_material(int index);               // of areas
colour colour_series(int index);                 // of lines
colour colour_ramp(double t); // dark blue to light yellow over 0..1, in even steps, ever lighter
