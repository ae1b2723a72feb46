// tests/rod_shooting_index.h
// The second method, part 5: conjugate points. The number of negative directions of the second
// variation, for loads that have a potential and tendons of given tension.
#pragma once

#include "tests/rod_shooting_path.h"

// forces fixed in space have a potential, moments have none
static inline bool shoot_has_potential(const shoot_case *c)
{
    double total[3], force, moment;
    const bool dead = shoot_total(c, total, &force, &moment);
    return dead && moment <= force * c->sh->spec->law->length;
}

static inline double shoot_det3(const double *a, const double *b, const double *c)
{
    double bc[3];
    shoot_cross(b, c, bc);
    return a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
}

// Counted from the free end: the rotations that leave the tip's balance alone, det [phi_1 phi_2
// phi_3] = 0 where one of them leaves a section's clamp alone too. -1: no convergence.
static inline int shoot_count(const shoot_case *of, double lambda, pose tip)
{
    shoot_case c = *of;
    double y[SHOOT_SIZE] = {0}, last = 1;
    int count = 0;
    c.ncolumn = 3;
    c.lambda_column = -1;
    shoot_put_pose(tip, y);
    for (int i = 0; i < 6; i++) {
        y[AT_N + i] = lambda * c.tip_space[i];
    }
    for (int k = 0; k < 3; k++) {
        y[SHOOT_STATE + SHOOT_COLUMN * k + k] = 1;
    }
    for (int k = c.sh->nstep - 1; k >= 0; k--) {
        shoot_pass_points(&c, &c.sh->step[k], lambda, 1, y);
        if (!shoot_advance(&c, &c.sh->step[k], -1, lambda, y)) {
            return -1;
        }
        const double *phi = y + SHOOT_STATE;
        const double det = shoot_det3(phi, phi + SHOOT_COLUMN, phi + 2 * SHOOT_COLUMN);
        count += det * last < 0 ? 1 : 0;
        last = det;
    }
    return count;
}
