// app/fit_files.h
#pragma once

#include "app/case.h"
#include "app/parameter.h"

// Settings that name the case's measured shapes, tendon paths, tissue, targets and scopes' cases by
// their whole paths, after those in *out; a fitted or designed case is written elsewhere.
status fit_files(const case_data *c, settings *out);
