// fem/petsc_plane_door.c
#include "fem/petsc_plane_door.h"

#include "base/door.h"

#include <string.h>

status petsc_plane_door_open(const petsc_plane_door **out)
{
    status st = OK;
    door_function found = NULL;
    petsc_plane_door_getter get = NULL;
    TRY(door_open("petsc", PETSC_PLANE_DOOR_SYMBOL, &found));
    memcpy(&get, &found, sizeof get);
    *out = get();

done:
    return st;
}
