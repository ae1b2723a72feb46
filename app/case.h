// app/case.h
// A whole case: the rooms' key tables put together, read, and checked for what no single room can
// see.
#pragma once

#include "app/command.h"
#include "app/fit_case.h"
#include "app/sensitivity_case.h"
#include "base/material.h"
#include "fem/segment.h"
#include "io/config.h"
#include "measure/measured_keys.h"
#include "reach/reach_case.h"
#include "rodsolver/rod.h"
#include "rodsolver/rod_case.h"
#include "section/section.h"

// What the case file holds; a part is there where mark_given(part.at).
typedef struct case_file {
    mark at;
    int format;
    const char *title;  // NULL where not given
    const char *fitted; // which of its numbers were fitted to what; NULL where none
    key_list materials; // of material
    section_case section;
    rod_case rod;
    segment_case fem;
    measured_case measured;
    sensitivity_case sensitivity;
    fit_case fit;
    reach_case reach;
} case_file;

// A case that was read. Texts and expressions belong to `config`, which lives as long as this.
typedef struct case_data {
    case_file file;
    config *config;
    double length; // of the rod, else of the segment, else up to the last station [m]; 0 without a
                   // section
    int nmaterial;
    const material *materials;
    bool allow_scripts;
} case_data;

typedef struct case_request {
    const char *path;
    const char
        *text; // the case itself, which no file holds; path is its name. NULL: read from path
    int noverride;
    const char *const *overrides; // KEY=VALUE
    bool allow_scripts;           // a `geo:` section may run
    const config *again;          // the text and overrides of this one come first; NULL: path
    bool only_rod;                // the section is not opened nor checked: it is known otherwise
} case_request;

// Reads and checks. Every mistake is ERR_INPUT, "FILE:LINE:COL: error: ...".
status case_open(const case_request *request, case_data *out);
status command_case(const command *cmd, case_data *out); // the case that a command line names
void case_free(case_data *c);

// The folder of the case file, with its last slash; "" where there is none.
void case_folder(const case_data *c, char *folder, size_t room);

bool case_has_section(const case_data *c); // only a case that has a `reach` may lack it
bool case_has_rod(const case_data *c);
bool case_has_segment(const case_data *c);
bool case_has_sensitivity(const case_data *c);

// ERR_INPUT where the case lacks the part that a command is about.
status case_need_section(const case_data *c);
status case_need_rod(const case_data *c);
status case_need_segment(const case_data *c);
// That ERR_INPUT, with the example that has such a part.
status case_lacks(const case_data *c, mark at, const char *part, const char *example);

// The case's keys, for `schema`: *root and *initial (the defaults) are filled, root->initial points
// to *initial.
void case_keys(key_table *root, case_file *initial);

// `st` as it is, unless it is ERR_INPUT, or has a place, without the case's file: then its message
// gets file, line and column, its own (status_place) or else those of `at`.
status case_place(const case_data *c, status st, mark at);
