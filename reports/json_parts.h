// reports/json_parts.h
// Parts of the section's and the rod's documents that have a file of their own.
#pragma once

#include "reports/result.h"

// {"schema": ..., the documents' common beginning
void json_begin(json *j, const char *key, const char *schema, const run_result *r);

// The keys of a station that do not follow from its K as it stands; what was not computed is null.
status json_station_answers(json *j, const run_result *r, int station);

// "materials": of every material the largest strain, where, and its linear strain.
void json_run_strains(json *j, const run_result *r, const struct rod_run *run);
