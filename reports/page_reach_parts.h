// reports/page_reach_parts.h
// Parts of the page's section on where scopes reach that have a file of their own.
#pragma once

#include "reports/page_kit.h"

// reports/page_reach_rest.c: how surely a target is not reached; and what a search for a better
// design found, nothing where there was none.
status page_reach_thoroughness(bytes *page, const reach_result *r);
status page_reach_design(bytes *page, const reach_result *r, const char *dir);
