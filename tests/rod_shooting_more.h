// tests/rod_shooting_more.h
// The second method, part 7: loads that all follow the body.
#pragma once

#include "tests/rod_shooting_solve.h"

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
