// rodsolver/equilibrium.c
#include "rodsolver/equilibrium.h"

status equilibrium_make(const rod *r, equilibrium **out)
{
    (void)r;
    *out = NULL;
    return OK;
}

void equilibrium_free(equilibrium *e)
{
    (void)e;
}

status equilibrium_solve(rod_state *state, const rod_request *request, rod_solution *out)
{
    (void)state;
    (void)request;
    (void)out;
    return status_fail(ERR_BUG, "rod: loads are not solved for");
}
