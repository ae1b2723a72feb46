// tests/rod_shooting_tendons.h
// The second method, part 7: tendons that rub, by a fixed point on what is left of each tension
// along the rod, and tendons whose drawn-out length is given, by Newton with differences on their
// tensions.
#pragma once

#include "tests/rod_shooting_more.h"

// --- friction: tau' = -mu tau |T'|, T the tangent in the frame of the world

enum { RUB_POINTS = 7, RUB_GAUSS = 4 };

static const double rub_gauss_at[RUB_GAUSS] = {0.0694318442029737, 0.3300094782075719,
                                               0.6699905217924281, 0.9305681557970263};
static const double rub_gauss_weight[RUB_GAUSS] = {0.1739274225687269, 0.3260725774312731,
                                                   0.3260725774312731, 0.1739274225687269};

// slopes at x of the polynomial through RUB_POINTS points 0, 1, 2, ...
static inline void rub_slopes(double x, double slope[RUB_POINTS])
{
    for (int i = 0; i < RUB_POINTS; i++) {
        slope[i] = 0;
        for (int j = 0; j < RUB_POINTS; j++) {
            double term = j == i ? 0 : 1.0 / (i - j);
            for (int k = 0; k < RUB_POINTS; k++) {
                term *= k == i || k == j ? 1 : (x - k) / (i - k);
            }
            slope[i] += term;
        }
    }
}

static inline bool rub_tangent(const shoot_case *c, const shoot_node *q, int tendon,
                               const double *y, double T[3])
{
    double W[6], xi[6], H[6][6], t[3];
    shoot_unturn(y + AT_R, y + AT_N, W);
    shoot_unturn(y + AT_R, y + AT_M, W + 3);
    memcpy(xi, q->rest, sizeof xi);
    if (!shoot_local(q, c->sh->spec->ntendon, c->tension, W, xi, H)) {
        return false;
    }
    (void)shoot_tangent(&q->place[tendon], xi, t);
    shoot_turn(y + AT_R, t, T);
    return true;
}

// angle through which the tangent turns from step `first + at` to part `to` of it
static inline double rub_angle(const double T[RUB_POINTS][3], double at, double to)
{
    double sum = 0;
    for (int g = 0; g < RUB_GAUSS; g++) {
        double slope[RUB_POINTS], d[3] = {0};
        rub_slopes(at + to * rub_gauss_at[g], slope);
        for (int i = 0; i < RUB_POINTS; i++) {
            for (int j = 0; j < 3; j++) {
                d[j] += slope[i] * T[i][j];
            }
        }
        sum += to * rub_gauss_weight[g] * sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    }
    return sum;
}

// new shares of one tendon from the states at the ends of steps; the largest change, or -1. A
// stretch must have at least RUB_POINTS - 1 steps
static inline double rub_along(const shoot_case *c, int tendon, double (*seen)[SHOOT_SIZE])
{
    const double mu = c->sh->spec->tendons[tendon].friction;
    const int n = c->sh->nstep;
    double angle = 0, change = 0;
    for (int k = 0; k < n && c->sh->step[k].node[2].place[tendon].share > 0; k++) {
        shoot_step *step = c->sh->step;
        int first = k, last = k, from;
        while (first > 0 && step[first - 1].stretch == step[k].stretch) {
            first--;
        }
        while (last + 1 < n && step[last + 1].stretch == step[k].stretch) {
            last++;
        }
        if (last + 1 - first < RUB_POINTS - 1) {
            return -1;
        }
        from = k - RUB_POINTS / 2 < first ? first : k - RUB_POINTS / 2;
        from = from + RUB_POINTS - 1 > last + 1 ? last + 2 - RUB_POINTS : from;
        double T[RUB_POINTS][3];
        for (int i = 0; i < RUB_POINTS; i++) {
            const bool end = from + i > last;
            const shoot_node *q = &step[end ? last : from + i].node[end ? SHOOT_NODES - 1 : 0];
            if (!rub_tangent(c, q, tendon, seen[from + i], T[i])) {
                return -1;
            }
        }
        for (int i = 0; i < SHOOT_NODES; i++) {
            shoot_place *place = &step[k].node[i].place[tendon];
            const double share =
                exp(-mu * (angle + rub_angle((const double(*)[3])T, k - from, shoot_node_at[i])));
            change = fmax(change, fabs(share - place->share));
            place->share = share;
        }
        angle += rub_angle((const double(*)[3])T, k - from, 1);
    }
    return change;
}

// states along the answer, from its base; the caller's seen [nstep + 1]
static inline bool rub_states(const shoot_case *c, const shoot_answer *a,
                              double (*seen)[SHOOT_SIZE])
{
    double y[SHOOT_SIZE] = {0};
    shoot_put_pose(c->base, y);
    memcpy(y + AT_N, a->base_wrench, sizeof a->base_wrench);
    return shoot_march(c, 1, 1, y, seen);
}

// As shoot_solve where tendons rub; both sets of steps are changed.
static inline shoot_answer shoot_rubbing(shooting *sh, shooting *fine, const rod_request *rq)
{
    shoot_answer out = {0};
    shooting *both[2] = {sh, fine};
    double(*seen)[SHOOT_SIZE] = malloc(((size_t)fine->nstep + 1) * sizeof *seen);
    double change = 1;
    for (int turn = 0; seen && turn < 200 && change > 1e-13; turn++) {
        out = shoot_solve(sh, fine, rq, 1);
        change = 0;
        for (int b = 0; b < 2 && out.solved; b++) {
            const shoot_case c = shoot_case_make(both[b], rq);
            out.solved = rub_states(&c, &out, seen);
            for (int i = 0; i < sh->spec->ntendon && out.solved; i++) {
                const double moved = rub_along(&c, i, seen);
                out.solved = moved >= 0;
                change = fmax(change, moved);
            }
        }
        if (!out.solved) {
            break;
        }
    }
    free(seen);
    out.solved = out.solved && change <= 1e-13;
    return out;
}

// --- pulled lengths

// what the tendon lacks to reach from its anchor to the actuator: >= 0, 0 where it is taut
static inline double pull_slack(const tendon_spec *t, double rest, double length, double pull,
                                double tension)
{
    const double stretch = t->EA > 0 ? tension / t->EA * (rest + t->outside) : 0;
    return rest + stretch - pull - length;
}

typedef struct pull_problem {
    shooting *sh, *fine;
    const rod_request *rq;
    double rest[SHOOT_TENDONS]; // lengths with nothing acting
    int n, which[SHOOT_TENDONS];
} pull_problem;

static inline shoot_answer pull_answer(const pull_problem *q, const double *tension)
{
    rod_request rq = *q->rq;
    rq.tension = tension;
    return shoot_solve(q->sh, q->fine, &rq, 1);
}

// min(tension, slack) in their own units: 0 for every pulled tendon at the answer
static inline void pull_misfit(const pull_problem *q, const double *tension, const shoot_answer *a,
                               double force, double *r)
{
    const double L = q->sh->spec->law->length;
    for (int i = 0; i < q->n; i++) {
        const int j = q->which[i];
        const double slack = pull_slack(&q->sh->spec->tendons[j], q->rest[j], a->length[j],
                                        q->rq->pull[j], tension[j]);
        r[i] = fmin(tension[j] / force, slack / L);
    }
}

// tension [ntendon] in (given ones) and out; force: the size of tensions to expect [N]
static inline shoot_answer shoot_pulled(shooting *sh, shooting *fine, const rod_request *rq,
                                        double force, double *tension)
{
    pull_problem q = {.sh = sh, .fine = fine, .rq = rq};
    shoot_answer a = {0};
    // nothing acts: loads at factor 0
    const double zero[16 + SHOOT_LINES] = {0};
    const rod_request nothing = {.load = zero};
    a = shoot_solve(sh, fine, &nothing, 1);
    memcpy(q.rest, a.length, sizeof q.rest);
    for (int i = 0; i < sh->spec->ntendon; i++) {
        if (!isnan(rq->pull[i])) {
            tension[i] = 0;
            q.which[q.n++] = i;
        }
    }
    for (int step = 0; step < 60; step++) {
        double J[SHOOT_UNKNOWNS + 1][SHOOT_UNKNOWNS + 1], r[SHOOT_TENDONS], most = 0, size = 0;
        a = pull_answer(&q, tension);
        pull_misfit(&q, tension, &a, force, r);
        for (int k = 0; k < q.n; k++) {
            // one-sided where it would have to push
            const double h = 1e-5 * force, at = tension[q.which[k]], low = fmax(0, at - h);
            double u[SHOOT_TENDONS], v[SHOOT_TENDONS];
            tension[q.which[k]] = at + h;
            const shoot_answer b = pull_answer(&q, tension);
            pull_misfit(&q, tension, &b, force, u);
            tension[q.which[k]] = low;
            const shoot_answer c = pull_answer(&q, tension);
            pull_misfit(&q, tension, &c, force, v);
            tension[q.which[k]] = at;
            for (int i = 0; i < q.n; i++) {
                J[i][k] = (u[i] - v[i]) / (at + h - low);
            }
            a.solved = a.solved && b.solved && c.solved;
        }
        if (!a.solved) {
            return a;
        }
        (void)shoot_eliminate(q.n, J, r);
        for (int k = 0; k < q.n; k++) {
            most = fmax(most, fabs(r[k]));
        }
        for (int k = 0; k < q.n; k++) {
            double *at = &tension[q.which[k]];
            const double next = fmax(0, *at - r[k] * fmin(1, 0.3 * force / most));
            size = fmax(size, fabs(next - *at));
            *at = next;
        }
        if (size < 1e-12 * force) {
            return pull_answer(&q, tension);
        }
    }
    a.solved = false;
    return a;
}
