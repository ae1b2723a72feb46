// measure/measured_keys.h
// What a case says about shapes that were measured.
#pragma once

#include "base/key.h"
#include "measure/shape_error.h"

enum { MEASURED_SHAPES = 64 }; // as many as a case may have

typedef enum measured_paper { PAPER_NONE, PAPER_TABLE_2, PAPER_TABLE_3 } measured_paper;

typedef struct measured_shape {
    mark at;
    const char *name; // NULL where not given
    key_text csv;
    key_rows tensions; // one row; of the solution that it belongs to ...
    int solution;      // ... or its number from 1; 0: not given
    int tip;           // shape_tip
    int index;         // of the rod's solution, from 0: filled when the case is bound ...
    centreline line;   // ... as this: as the file has it, sigma and correlation filled in
} measured_shape;

typedef struct measured_case {
    mark at;
    bool synthetic;     // not from a bench: the case says so, or one of its files
    const char *source; // NULL where not given
    int paper;          // measured_paper: whose published errors stand beside
    int arclength;      // shape_arclength
    double sigma;       // where a file has none [m]; 0: unknown
    double correlation; // length over which errors go together [m]; 0: as a file says, else
                        // from station to station they do not
    double tolerance;   // of tip error over length and of shape error; 0: no verdict
    key_list shapes;    // of measured_shape
} measured_case;

extern const key_table measured_keys; // `measured`

// Reads the files of all shapes. ERR_FILE with the file's line; *where the key of one that cannot
// be read.
status measured_case_read(measured_case *c, const char *directory, double length, mark *where);
void measured_case_release(measured_case *c);
