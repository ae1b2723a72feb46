// reach/embree_door.c
#include "reach/embree_door.h"

#include "base/door.h"

#include <string.h>

status embree_door_open(const embree_door **out)
{
    status st = OK;
    door_function found = NULL;
    embree_door_getter get = NULL;
    TRY(door_open("embree", EMBREE_DOOR_SYMBOL, &found));
    memcpy(&get, &found, sizeof get);
    *out = get();

done:
    return st;
}
