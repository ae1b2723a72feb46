// rodsolver/rod_inner_keys.h
// The key tables below `rod`.
#pragma once

#include "rodsolver/rod_case.h"

extern const key_table rod_tendon_keys, rod_base_keys, rod_rest_keys, rod_load_keys,
    rod_line_load_keys, rod_sweep_keys;
