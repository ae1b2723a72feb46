// measure/gsl_spline_door.c
#include "measure/gsl_spline_door.h"

#include "base/door.h"

#include <string.h>

status gsl_spline_door_open(const gsl_spline_door **out)
{
    status st = OK;
    door_function found = NULL;
    gsl_spline_door_getter get = NULL;
    TRY(door_open("gsl", GSL_SPLINE_DOOR_SYMBOL, &found));
    memcpy(&get, &found, sizeof get);
    *out = get();

done:
    return st;
}
