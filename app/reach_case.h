// app/reach_case.h
// What a case says of where its scopes reach, checked without a look at its files.
#pragma once

#include "app/case.h"

bool case_has_reach(const case_data *c);
status case_need_reach(const case_data *c);

// After the rod is bound. Mistakes come with their place.
status case_reach_check(const case_data *c);

const scope_case *case_scope(const case_data *c, int i);

// Whether a scope's tip is a rod, and whether it is this case's own.
bool case_scope_is_rod(const scope_case *s);
bool case_scope_is_own(const scope_case *s);
