// What stands before the pieces of C in docs/rod_api.md.
#include "rodsolver/rod.h"

extern law_along law;

void pieces(mat6 K, tendon_spec *tendons, double *tension, double s, vec6 *column);
void pieces(mat6 K, tendon_spec *tendons, double *tension, double s, vec6 *column)
{
    (void)K, (void)tendons, (void)tension, (void)s, (void)column;
