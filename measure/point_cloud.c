// measure/point_cloud.c
#include "measure/point_cloud.h"

#include <stdlib.h>

void point_cloud_free(point_cloud *c)
{
    free(c->p);
    *c = (point_cloud){0};
}
