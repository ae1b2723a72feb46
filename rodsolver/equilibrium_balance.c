// rodsolver/equilibrium_balance.c
// Poses from strains, wrenches from poses, and the balance at every station. docs/theory.md (4.13)
// to (4.16)
#include "rodsolver/collocation.h"
#include "rodsolver/equilibrium.h"

#include <math.h>

// --- poses and wrenches

void balance_poses(equilibrium *e)
{
    const plan *p = e->plan;
    e->node_R[0] = mat3_identity();
    e->node_p[0] = (vec3){{0, 0, 0}};
    for (int k = 0; k < 2 * p->npair; k++) {
        const double h = panel_length(p, k);
        const vec6 *xi = &e->xi[GAUSS_STATIONS * k];
        station_state *state = &e->state[GAUSS_STATIONS * k];
        vec3 w[GAUSS_STATIONS];
        mat3 R[GAUSS_STATIONS];
        for (int i = 0; i < GAUSS_STATIONS; i++) {
            w[i] = vec6_angular(xi[i]);
        }
        collocate_rotation(h, e->node_R[k], w, R, &e->node_R[k + 1]);
        vec3 end = e->node_p[k];
        for (int i = 0; i < GAUSS_STATIONS; i++) {
            state[i].R = R[i];
            state[i].slope = mat3_mul_vec(R[i], vec6_linear(xi[i]));
            end = vec3_add_scaled(end, h * gauss_weight[i], state[i].slope);
        }
        e->node_p[k + 1] = end;
    }
}

// the axial vector of R dyad: sum of (R c) x f
static vec3 offset_moment(const mat3 *R, const mat3 *dyad)
{
    const mat3 x = mat3_mul(*R, *dyad);
    return (vec3){{x.a[1][2] - x.a[2][1], x.a[2][0] - x.a[0][2], x.a[0][1] - x.a[1][0]}};
}

void balance_add_load(const load_sum *l, const mat3 *R, vec3 *force, vec3 *moment)
{
    *force = vec3_add(*force, vec3_add(l->dead, mat3_mul_vec(*R, l->follower)));
    *moment = vec3_add(*moment, vec3_add(l->dead_moment, mat3_mul_vec(*R, l->follower_moment)));
    *moment = vec3_add(*moment, offset_moment(R, &l->dyad));
}

// N' = -f, M' = -p' x N - l over one panel from its right end, by the same stages
static void panel_wrenches(const equilibrium *e, int k, const load_sum *line, vec3 *N, vec3 *M)
{
    const double h = panel_length(e->plan, k);
    station_state *state = &e->state[GAUSS_STATIONS * k];
    vec3 force[GAUSS_STATIONS] = {0}, moment[GAUSS_STATIONS] = {0};
    for (int i = 0; e->lines && i < GAUSS_STATIONS; i++) {
        balance_add_load(&line[GAUSS_STATIONS * k + i], &state[i].R, &force[i], &moment[i]);
    }
    for (int i = 0; i < GAUSS_STATIONS; i++) {
        state[i].N = *N;
        for (int j = 0; e->lines && j < GAUSS_STATIONS; j++) {
            state[i].N = vec3_add_scaled(state[i].N, h * gauss_outer[i][j], force[j]);
        }
    }
    for (int i = 0; i < GAUSS_STATIONS; i++) {
        moment[i] = vec3_add(moment[i], vec3_cross(state[i].slope, state[i].N));
    }
    for (int i = 0; i < GAUSS_STATIONS; i++) {
        state[i].M = *M;
        for (int j = 0; j < GAUSS_STATIONS; j++) {
            state[i].M = vec3_add_scaled(state[i].M, h * gauss_outer[i][j], moment[j]);
        }
    }
    for (int j = 0; j < GAUSS_STATIONS; j++) {
        *N = vec3_add_scaled(*N, h * gauss_weight[j], force[j]);
        *M = vec3_add_scaled(*M, h * gauss_weight[j], moment[j]);
    }
}

void balance_wrenches(equilibrium *e, const load_sum *line, const load_sum *node)
{
    vec3 N = {{0, 0, 0}}, M = {{0, 0, 0}};
    for (int k = 2 * e->plan->npair - 1; k >= 0; k--) {
        balance_add_load(&node[k + 1], &e->node_R[k + 1], &N, &M);
        e->node_N[k + 1] = N;
        e->node_M[k + 1] = M;
        panel_wrenches(e, k, line, &N, &M);
    }
}

// --- the balance at a station

// the blocks of a symmetric 6x6 that meet (v, w)
typedef struct blocks {
    mat3 vv, vw, ww;
} blocks;

static blocks split(const mat6 *K, double factor)
{
    blocks b;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            b.vv.a[i][j] = factor * K->a[i][j];
            b.vw.a[i][j] = factor * K->a[i][j + 3];
            b.ww.a[i][j] = factor * K->a[i + 3][j + 3];
        }
    }
    return b;
}

// += A^T P A with A = [I, -hat(r)], r = (x, y, 0), P symmetric
static void add_tendon_stiffness(const tendon_place *r, const mat3 *P, blocks *b)
{
    const double x = r->x, y = r->y;
    mat3 Q; // -P hat(r)
    for (int i = 0; i < 3; i++) {
        Q.a[i][0] = P->a[i][2] * y;
        Q.a[i][1] = -P->a[i][2] * x;
        Q.a[i][2] = P->a[i][1] * x - P->a[i][0] * y;
    }
    for (int j = 0; j < 3; j++) {
        for (int i = 0; i < 3; i++) {
            b->vv.a[i][j] += P->a[i][j];
            b->vw.a[i][j] += Q.a[i][j];
        }
        b->ww.a[0][j] += y * Q.a[2][j];
        b->ww.a[1][j] -= x * Q.a[2][j];
        b->ww.a[2][j] += x * Q.a[1][j] - y * Q.a[0][j];
    }
}

vec6 balance_tendon(const equilibrium *e, int tendon, int station)
{
    const tendon_place *r = &e->plan->tendon[tendon].place[station];
    const vec3 d = tendon_direction(r, &e->xi[station]);
    return tendon_wrench(r, vec3_scale(1 / vec3_norm(d), d));
}

// a tendon this short, or turned round against the rod, has eaten its own length
static const double eaten = 1e-7;

// tension times (t, r x t), and its derivative tension / |d| A^T (I - t t^T) A
static bool add_tendon(const tendon_place *r, double tension, const vec6 *xi, vec6 *force,
                       blocks *b)
{
    const vec3 d = tendon_direction(r, xi);
    const double length = vec3_norm(d);
    if (!(length > eaten && d.a[2] > 0)) {
        return false;
    }
    const vec3 t = vec3_scale(1 / length, d);
    *force = vec6_add(*force, tendon_wrench(r, vec3_scale(tension, t)));
    if (b) {
        const double q = tension / length;
        mat3 P;
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                P.a[i][j] = q * ((i == j) - t.a[i] * t.a[j]);
            }
        }
        add_tendon_stiffness(r, &P, b);
    }
    return true;
}

static double station_tension(const equilibrium *e, int tendon, int station)
{
    const double tau = e->tension[tendon];
    return e->friction ? tau * e->decay[(size_t)tendon * (size_t)e->room + (size_t)station] : tau;
}

// K (xi - xi*) + sum of the tendons' pulls, body frame
static bool station_force(const equilibrium *e, int i, vec6 *force, blocks *b)
{
    const plan *p = e->plan;
    vec6 strain = e->xi[i];
    for (int c = 0; c < 6; c++) {
        strain.a[c] -= p->rest[(size_t)c * (size_t)p->nstation + (size_t)i];
    }
    *force = mat6_mul_vec(p->K[i], strain);
    for (int j = 0; j < e->rod->ntendon; j++) {
        const plan_tendon *t = &p->tendon[j];
        if (e->tension[j] > 0 && i < t->nstation &&
            !add_tendon(&t->place[i], station_tension(e, j, i), &e->xi[i], force, b)) {
            return false;
        }
    }
    return true;
}

// inverse of a symmetric positive definite matrix by cofactors
static bool invert(const mat3 *a, mat3 *out)
{
    const double m0 = a->a[1][1] * a->a[2][2] - a->a[1][2] * a->a[1][2];
    const double m1 = a->a[1][2] * a->a[0][2] - a->a[0][1] * a->a[2][2];
    const double m2 = a->a[0][1] * a->a[1][2] - a->a[1][1] * a->a[0][2];
    const double det = a->a[0][0] * m0 + a->a[0][1] * m1 + a->a[0][2] * m2;
    if (!(det > 0) || !(m0 > 0) || !(a->a[2][2] > 0)) {
        return false;
    }
    const double q = 1 / det;
    const double b11 = a->a[0][0] * a->a[2][2] - a->a[0][2] * a->a[0][2];
    const double b12 = a->a[0][1] * a->a[0][2] - a->a[0][0] * a->a[1][2];
    const double b22 = a->a[0][0] * a->a[1][1] - a->a[0][1] * a->a[0][1];
    *out =
        (mat3){{{q * m0, q * m1, q * m2}, {q * m1, q * b11, q * b12}, {q * m2, q * b12, q * b22}}};
    return true;
}

static mat3 turned(const mat3 *R, const mat3 *a)
{
    return mat3_mul(mat3_mul(*R, *a), mat3_transpose(*R));
}

static mat3 subtract(mat3 a, double c, mat3 b)
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            a.a[i][j] -= c * b.a[i][j];
        }
    }
    return a;
}

// tr(X) I - X, the symmetric part of it where there is a potential
static mat3 turning_load(const mat3 *x, bool symmetric)
{
    const double trace = x->a[0][0] + x->a[1][1] + x->a[2][2];
    mat3 q;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            q.a[i][j] =
                (i == j ? trace : 0) - (symmetric ? (x->a[i][j] + x->a[j][i]) / 2 : x->a[i][j]);
        }
    }
    return q;
}

// (4.17): second derivatives by the station's turning rate omega and rotation phi
static void station_blocks(const equilibrium *e, int i, station_tangent *t)
{
    const station_state *s = &e->state[i];
    const bool potential = e->conservative;
    const mat3 N = mat3_hat(s->N), M = mat3_hat(s->M);
    t->wp = subtract(mat3_mul(mat3_transpose(t->B), N), potential ? 0.5 : 1, M);
    t->pw = potential ? mat3_transpose(t->wp) : subtract((mat3){0}, 1, mat3_mul(N, t->B));
    mat3 x = e->lines ? mat3_mul(s->R, e->line[i].dyad) : (mat3){0};
    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 3; c++) {
            x.a[r][c] += s->slope.a[r] * s->N.a[c];
        }
    }
    t->pp = turning_load(&x, potential);
    t->pp = subtract(t->pp, -1, mat3_mul(N, mat3_mul(t->E, N)));
    if (e->lines) {
        const vec3 m = mat3_mul_vec(s->R, e->line[i].follower_moment);
        t->pp = subtract(t->pp, -1, mat3_hat(m));
    }
}

bool balance_stations(equilibrium *e, bool tangents)
{
    for (int i = 0; i < e->plan->nstation; i++) {
        station_state *s = &e->state[i];
        blocks b;
        vec6 force;
        if (tangents) {
            b = split(&e->plan->K[i], 1 + e->shift);
        }
        // a section that is pressed through its neighbour is no rod any more
        if (!(e->xi[i].a[2] > 0)) {
            return false;
        }
        if (!station_force(e, i, &force, tangents ? &b : NULL)) {
            return false;
        }
        s->rv = vec3_sub(mat3_mul_vec(s->R, vec6_linear(force)), s->N);
        s->rw = vec3_sub(mat3_mul_vec(s->R, vec6_angular(force)), s->M);
        if (tangents) {
            station_tangent *t = &e->tangent[i];
            mat3 E;
            if (!invert(&b.vv, &E)) {
                return false;
            }
            const mat3 B = mat3_mul(E, b.vw);
            const mat3 D = subtract(b.ww, 1, mat3_mul(mat3_transpose(b.vw), B));
            t->E = turned(&s->R, &E);
            t->B = turned(&s->R, &B);
            t->D = turned(&s->R, &D);
            station_blocks(e, i, t);
        }
    }
    return true;
}
