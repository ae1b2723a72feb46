// reach/nlopt_door.c
#include "reach/nlopt_door.h"

#include "base/door.h"

#include <string.h>

status nlopt_door_open(const nlopt_door **out)
{
    status st = OK;
    door_function found = NULL;
    nlopt_door_getter get = NULL;
    TRY(door_open("nlopt", NLOPT_DOOR_SYMBOL, &found));
    memcpy(&get, &found, sizeof get);
    *out = get();

done:
    return st;
}
