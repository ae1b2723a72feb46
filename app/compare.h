// app/compare.h
// Two ways to the same number, side by side: difference, tolerance with its reason, verdict.
#pragma once

#include "app/case.h"
#include "app/command.h"
#include "reports/result.h"

// Adds to r->compare every comparison that the case allows; what was computed already is used. Ways
// that are not on this machine are rows that were skipped, with the reason.
status compare_all(const command *cmd, const case_data *c, run_result *r);

// ERR_TOLERANCE with the first row that is out of tolerance and how many there are.
status compare_verdict(const run_result *r);
