// app/fit_files.h
#pragma once

#include "app/case.h"
#include "app/parameter.h"

// Settings that name the case's measured shapes and tendon paths by their whole paths, after those
// in *out; a fitted case is written elsewhere than the case.
status fit_files(const case_data *c, settings *out);
