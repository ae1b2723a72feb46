// tests/rod_shooting_more.h
// The second method, part 6: conjugate points, loads that follow the body, pulled lengths and
// friction.
#pragma once

#include "tests/rod_shooting_solve.h"

static inline double shoot_det3(const double *a, const double *b, const double *c)
{
    double bc[3];
    shoot_cross(b, c, bc);
    return a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
}

static inline bool shoot_dead_case(const shooting *sh, const rod_request *rq)
{
    double total[3], force, moment;
    const shoot_case c = shoot_case_make((shooting *)sh, rq);
    return shoot_total(&c, total, &force, &moment);
}

// Negative directions of the second variation, loads fixed in space and tensions given: conjugate
// points, counted from the free end. The rotations that leave the tip's balance alone, det [phi_1
// phi_2 phi_3] = 0 where one of them leaves a section's clamp alone too. -1: loads that follow.
static inline int shoot_negative(shooting *sh, const rod_request *rq, const shoot_answer *at)
{
    shoot_case c = shoot_case_make(sh, rq);
    double y[SHOOT_SIZE] = {0}, last = 1;
    int count = 0;
    if (!shoot_dead_case(sh, rq)) {
        return -1;
    }
    c.ncolumn = 3;
    shoot_put_pose(at->tip, y);
    for (int i = 0; i < 6; i++) {
        y[AT_N + i] = at->fraction * c.tip_space[i];
    }
    for (int k = 0; k < 3; k++) {
        y[SHOOT_STATE + SHOOT_COLUMN * k + k] = 1;
    }
    for (int k = sh->nstep - 1; k >= 0; k--) {
        shoot_pass_points(&c, &sh->step[k], at->fraction, 1, y);
        if (!shoot_advance(&c, &sh->step[k], -1, at->fraction, y)) {
            return -1;
        }
        const double *phi = y + SHOOT_STATE;
        const double det = shoot_det3(phi, phi + SHOOT_COLUMN, phi + 2 * SHOOT_COLUMN);
        count += det * last < 0 ? 1 : 0;
        last = det;
    }
    return count;
}

// Everything turns with the body: from the tip backwards the answer is one march, and there is one.
// seen [nstep + 1] as of shoot_march, in the frame of the tip; may be NULL.
static inline shoot_answer shoot_follow(shooting *sh, const rod_request *rq,
                                        double (*seen)[SHOOT_SIZE])
{
    shoot_case c = shoot_case_make(sh, rq);
    shoot_answer out = {.fraction = 1, .marches = 1};
    double y[SHOOT_SIZE] = {0};
    shoot_put_pose(pose_identity(), y);
    memcpy(y + AT_N, c.tip_body, sizeof c.tip_body);
    out.solved = shoot_march(&c, -1, 1, y, seen);
    out.tip = pose_mul(c.base, pose_inverse(shoot_get_pose(y)));
    for (int i = 0; i < SHOOT_TENDONS; i++) {
        out.length[i] = -y[AT_LENGTH + i];
    }
    for (int i = 0; i < 3; i++) {
        double f[6];
        shoot_unturn(y + AT_R, y + AT_N, f);
        shoot_unturn(y + AT_R, y + AT_M, f + 3);
        memcpy(out.base_wrench, f, sizeof f);
    }
    return out;
}
