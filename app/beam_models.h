// app/beam_models.h
// The section of the 3D segment's stretch of rod under three assumptions.
#pragma once

#include "app/case.h"
#include "base/law_along.h"

enum { BEAM_CLASSICAL, BEAM_PRISMATIC, BEAM_TURNING, BEAM_MODELS };

typedef struct beam_models {
    double from;                // arclength of the segment's base [m]
    char why[BEAM_MODELS][160]; // no such law; "" where there is one
    law_along law[BEAM_MODELS]; // from 0 to beyond the segment's tip
} beam_models;

// Up to `length` above the segment's base. Classical: the paper's model; the full one, station by
// station as if nothing turned; the full one with the rate at which the pattern turns. A body that
// keeps one section has the laws of that one.
status beam_models_make(const case_data *c, double length, beam_models *out);
void beam_models_free(beam_models *m);

// Of the straight rod of that length, clamped at the segment's base.
status beam_models_compliance(const beam_models *m, int model, double length, mat6 *out);

const char *beam_model_name(int model);
