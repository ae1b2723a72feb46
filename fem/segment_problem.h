// fem/segment_problem.h
// The case's loads, springs and holds -> the columns of a segment_problem.
#pragma once

#include "fem/segment.h"

typedef struct problem_parts {
    segment_problem problem; // body is the caller's to set
    face_spring *spring;
    face_hold *hold;
    face_pressure *pressure; // of all columns, one after another
    load_column *extra;
    int *column; // [loads] what each load brings along beside its wrench; -1: nothing
    int uniform; // first of three columns of unit forces by uniform traction; -1: none
} problem_parts;

// With a uniform tip three columns of unit forces come first, then one per load that brings
// pressures, forces per volume or moving holds along.
status problem_parts_make(const segment_case *c, problem_parts *out);
void problem_parts_free(problem_parts *p);
