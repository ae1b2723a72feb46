// fem/segment_inner_keys.h
// The key tables below `fem`.
#pragma once

#include "fem/segment.h"

extern const key_table segment_load_keys, segment_spring_keys, segment_hold_keys,
    segment_tip_spring_keys;
