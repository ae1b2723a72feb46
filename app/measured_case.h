// app/measured_case.h
// The measured shapes of a case: their files, and the rod's solutions that they belong to.
#pragma once

#include "app/case.h"

bool case_has_measured(const case_data *c);

// Reads the files and finds the solutions; the case's rod is bound already. Mistakes come with
// their place.
status case_measured_bind(case_data *c, const char *directory);

status case_need_measured(const case_data *c);
