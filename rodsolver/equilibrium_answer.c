// rodsolver/equilibrium_answer.c
// One right-hand side of the factored tangent: from the tip to the base, and back. docs/theory.md
// (4.18), (4.19)
#include "rodsolver/collocation.h"
#include "rodsolver/equilibrium.h"

enum { G = GAUSS_STATIONS, UNKNOWNS = PANEL_UNKNOWNS };

static vec3 minus_product(vec3 a, const mat3 *m, vec3 b)
{
    return vec3_sub(a, mat3_mul_vec(*m, b));
}

static vec3 follower_force(const equilibrium *e, int station, vec3 phi)
{
    if (!e->lines) {
        return (vec3){{0, 0, 0}};
    }
    return vec3_cross(mat3_mul_vec(e->state[station].R, e->line[station].follower), phi);
}

// what follows from the turning rates of a panel's stages
typedef struct panel_motion {
    vec3 end, phi[G], dN[G];
} panel_motion;

// rotations by omega from `phi` on, and the forces beyond that they turn
static panel_motion move_panel(const equilibrium *e, int k, double h, vec3 phi, const vec3 *omega,
                               vec3 cN)
{
    panel_motion m = {.end = phi};
    for (int j = 0; j < G; j++) {
        m.end = vec3_add_scaled(m.end, h * gauss_weight[j], omega[j]);
        m.phi[j] = phi;
        for (int l = 0; l < G; l++) {
            m.phi[j] = vec3_add_scaled(m.phi[j], h * gauss_inner[j][l], omega[l]);
        }
    }
    if (e->followers) {
        const vec3 beyond = vec3_add(mat3_mul_vec(e->panel[k].SN, m.end), cN);
        for (int j = 0; j < G; j++) {
            m.dN[j] = beyond;
            for (int l = 0; l < G; l++) {
                const vec3 F = follower_force(e, G * k + l, m.phi[l]);
                m.dN[j] = vec3_add_scaled(m.dN[j], -h * gauss_outer[j][l], F);
            }
        }
    }
    return m;
}

// the rotation's row at a stage: pp phi + pw omega + (N E - p') dN - N x E rv
static vec3 turning_row(const equilibrium *e, int station, vec3 phi, vec3 omega, vec3 dN, vec3 rv)
{
    const station_tangent *t = &e->tangent[station];
    const station_state *s = &e->state[station];
    vec3 row = vec3_add(mat3_mul_vec(t->pp, phi), mat3_mul_vec(t->pw, omega));
    const vec3 stretch = mat3_mul_vec(t->E, vec3_sub(dN, rv));
    row = vec3_add(row, vec3_cross(s->N, stretch));
    return e->followers ? vec3_sub(row, vec3_cross(s->slope, dN)) : row;
}

static void to_panel(const vec3 *v, double *b)
{
    for (int i = 0; i < UNKNOWNS; i++) {
        b[i] = v[i / 3].a[i % 3];
    }
}

// turning rates of a panel whose left node does not turn, kept in e->omega; c and cN move on to the
// left node
static void back_panel(equilibrium *e, int k, const vec3 *rv, const vec3 *rw, vec3 *c, vec3 *cN)
{
    static const vec3 zero[G] = {0};
    const double h = panel_length(e->plan, k);
    const panel_motion still = move_panel(e, k, h, zero[0], zero, *cN);
    vec3 row[G], rhs[G];
    for (int j = 0; j < G; j++) {
        row[j] = turning_row(e, G * k + j, zero[0], zero[0], still.dN[j], rv[j]);
    }
    for (int i = 0; i < G; i++) {
        const station_tangent *t = &e->tangent[G * k + i];
        const vec3 force = mat3_tmul_vec(t->B, vec3_sub(still.dN[i], rv[i]));
        rhs[i] = vec3_scale(-h * gauss_weight[i], vec3_sub(vec3_add(rw[i], force), *c));
        for (int j = 0; j < G; j++) {
            rhs[i] = vec3_add_scaled(rhs[i], -h * h * gauss_weight[j] * gauss_inner[j][i], row[j]);
        }
    }
    double b[UNKNOWNS];
    to_panel(rhs, b);
    sweep_solve_panel(e, k, b);
    vec3 *omega = &e->omega[G * k];
    for (int i = 0; i < UNKNOWNS; i++) {
        omega[i / 3].a[i % 3] = b[i];
    }
    const panel_motion moved = move_panel(e, k, h, zero[0], omega, *cN);
    *c = vec3_add(*c, mat3_mul_vec(e->panel[k].S, moved.end));
    for (int j = 0; j < G; j++) {
        const vec3 r = turning_row(e, G * k + j, moved.phi[j], omega[j], moved.dN[j], rv[j]);
        *c = vec3_add_scaled(*c, -h * gauss_weight[j], r);
    }
    if (e->followers) {
        *cN = vec3_add(*cN, mat3_mul_vec(e->panel[k].SN, moved.end));
        for (int j = 0; j < G; j++) {
            *cN = vec3_add_scaled(*cN, -h * gauss_weight[j],
                                  follower_force(e, G * k + j, moved.phi[j]));
        }
    }
}

// adds the answer to the left node's rotation, and finds the strains
static void forward_panel(equilibrium *e, int k, const vec3 *rv, vec3 cN, vec6 *strain)
{
    const double h = panel_length(e->plan, k);
    const vec3 phi = e->phi[k];
    vec3 *omega = &e->omega[G * k];
    for (int i = 0; i < UNKNOWNS; i++) {
        const double *x = e->panel[k].response[i];
        omega[i / 3].a[i % 3] += x[0] * phi.a[0] + x[1] * phi.a[1] + x[2] * phi.a[2];
    }
    const panel_motion m = move_panel(e, k, h, phi, omega, cN);
    e->phi[k + 1] = m.end;
    for (int j = 0; j < G; j++) {
        const int i = G * k + j;
        const station_state *s = &e->state[i];
        const station_tangent *t = &e->tangent[i];
        vec3 n = vec3_cross(s->N, m.phi[j]);
        n = e->followers ? vec3_add(n, m.dN[j]) : n;
        e->nu[i] = minus_product(mat3_mul_vec(t->E, vec3_sub(n, rv[j])), &t->B, omega[j]);
        const vec3 v = mat3_tmul_vec(s->R, e->nu[i]), w = mat3_tmul_vec(s->R, omega[j]);
        strain[i] = (vec6){{v.a[0], v.a[1], v.a[2], w.a[0], w.a[1], w.a[2]}};
    }
}

void sweep_solve(equilibrium *e, const vec3 *rv, const vec3 *rw, vec6 *strain)
{
    const int npanel = 2 * e->plan->npair;
    vec3 c = {{0, 0, 0}}, cN = {{0, 0, 0}};
    for (int k = npanel - 1; k >= 0; k--) {
        e->beyond[k] = cN;
        back_panel(e, k, rv + G * k, rw + G * k, &c, &cN);
    }
    e->phi[0] = (vec3){{0, 0, 0}};
    for (int k = 0; k < npanel; k++) {
        forward_panel(e, k, rv + G * k, e->beyond[k], strain);
    }
}
