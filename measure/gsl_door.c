// measure/gsl_door.c
#include "measure/gsl_door.h"

#include "base/door.h"

#include <string.h>

status gsl_fit_door_open(const gsl_fit_door **out)
{
    status st = OK;
    door_function found = NULL;
    gsl_fit_door_getter get = NULL;
    TRY(door_open("gsl", GSL_FIT_DOOR_SYMBOL, &found));
    memcpy(&get, &found, sizeof get);
    *out = get();

done:
    return st;
}

status gsl_random_door_open(const gsl_random_door **out)
{
    status st = OK;
    door_function found = NULL;
    gsl_random_door_getter get = NULL;
    TRY(door_open("gsl", GSL_RANDOM_DOOR_SYMBOL, &found));
    memcpy(&get, &found, sizeof get);
    *out = get();

done:
    return st;
}

status gsl_linear_door_open(const gsl_linear_door **out)
{
    status st = OK;
    door_function found = NULL;
    gsl_linear_door_getter get = NULL;
    TRY(door_open("gsl", GSL_LINEAR_DOOR_SYMBOL, &found));
    memcpy(&get, &found, sizeof get);
    *out = get();

done:
    return st;
}
