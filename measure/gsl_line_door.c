// measure/gsl_line_door.c
#include "measure/gsl_line_door.h"

#include "base/door.h"

#include <string.h>

status gsl_line_door_open(const gsl_line_door **out)
{
    status st = OK;
    door_function found = NULL;
    gsl_line_door_getter get = NULL;
    TRY(door_open("gsl", GSL_LINE_DOOR_SYMBOL, &found));
    memcpy(&get, &found, sizeof get);
    *out = get();

done:
    return st;
}
