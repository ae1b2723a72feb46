// tests/campaign.h
// A campaign of many random cases: the whole of it with the argument `full` (./run bench
// reach_full), a part of it in every check.
#pragma once

#include <stdbool.h>
#include <string.h>

static inline bool campaign_is_full(int argc, char **argv)
{
    return argc > 1 && strcmp(argv[1], "full") == 0;
}
