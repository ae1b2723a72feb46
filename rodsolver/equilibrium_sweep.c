// rodsolver/equilibrium_sweep.c
// The linearised two-point problem, from the tip to the base: what lies beyond a node answers a
// rotation phi of that node by the wrench dM = S phi + c (and dN = SN phi + cN where forces follow
// the body), so that each panel is a problem of its own in the turning rates omega of its three
// stations. docs/theory.md (4.17) to (4.19)
#include "rodsolver/collocation.h"
#include "rodsolver/equilibrium.h"
#include "rodsolver/panel_matrix.h"

#include <math.h>
#include <string.h>

enum { G = GAUSS_STATIONS, UNKNOWNS = PANEL_UNKNOWNS };

// m += c a
static void add_block(double m[UNKNOWNS][UNKNOWNS], int i, int l, double c, const mat3 *a)
{
    for (int r = 0; r < 3; r++) {
        for (int q = 0; q < 3; q++) {
            m[3 * i + r][3 * l + q] += c * a->a[r][q];
        }
    }
}

static void add_column(double m[UNKNOWNS][3], int i, double c, const mat3 *a)
{
    for (int r = 0; r < 3; r++) {
        for (int q = 0; q < 3; q++) {
            m[3 * i + r][q] += c * a->a[r][q];
        }
    }
}

static void add_matrix(mat3 *m, double c, const mat3 *a)
{
    for (int r = 0; r < 3; r++) {
        for (int q = 0; q < 3; q++) {
            m->a[r][q] += c * a->a[r][q];
        }
    }
}

// rows of omega_i: b_i h (D omega_i + wp phi_i) + sum_j h^2 b_j a_ji (pp phi_j + pw omega_j) - h
// b_i S phi_end, with phi_j = phi + h sum_l a_jl omega_l
static void assemble(double h, const station_tangent *t, const mat3 *S, bool symmetric,
                     double A[UNKNOWNS][UNKNOWNS], double rhs[UNKNOWNS][3])
{
    const double h2 = h * h, h3 = h2 * h;
    memset(A, 0, UNKNOWNS * sizeof *A);
    memset(rhs, 0, UNKNOWNS * sizeof *rhs);
    for (int i = 0; i < G; i++) {
        add_block(A, i, i, h * gauss_weight[i], &t[i].D);
        add_column(rhs, i, h * gauss_weight[i], &t[i].wp);
        add_column(rhs, i, -h * gauss_weight[i], S);
        for (int l = 0; l < (symmetric ? i + 1 : G); l++) {
            add_block(A, i, l, h2 * gauss_weight[i] * gauss_inner[i][l], &t[i].wp);
            add_block(A, i, l, h2 * gauss_weight[l] * gauss_inner[l][i], &t[l].pw);
            add_block(A, i, l, -h2 * gauss_weight[i] * gauss_weight[l], S);
            for (int j = 0; j < G; j++) {
                add_block(A, i, l, h3 * gauss_weight[j] * gauss_inner[j][i] * gauss_inner[j][l],
                          &t[j].pp);
            }
        }
        for (int l = 0; l < G; l++) {
            add_column(rhs, i, h2 * gauss_weight[l] * gauss_inner[l][i], &t[l].pp);
        }
    }
}

// --- forces that follow the body: dN_j = SN phi_end + cN - h sum_l outer_jl F_l x ... (4.20)

typedef struct follower_map {
    mat3 by_omega[G][G], by_phi[G]; // dN at stage j
    mat3 moment[G];                 // N E - hat(p'): what dN does to the rotation's row
} follower_map;

static mat3 force_turning(const equilibrium *e, int station)
{
    if (!e->lines) {
        return (mat3){0};
    }
    return mat3_hat(mat3_mul_vec(e->state[station].R, e->line[station].follower));
}

static void map_followers(const equilibrium *e, int k, double h, const mat3 *SN, follower_map *out)
{
    mat3 F[G];
    for (int j = 0; j < G; j++) {
        F[j] = force_turning(e, G * k + j);
    }
    for (int j = 0; j < G; j++) {
        const station_state *s = &e->state[G * k + j];
        const mat3 slope = mat3_hat(s->slope);
        out->moment[j] = mat3_mul(mat3_hat(s->N), e->tangent[G * k + j].E);
        add_matrix(&out->moment[j], -1, &slope);
        out->by_phi[j] = *SN;
        for (int l = 0; l < G; l++) {
            add_matrix(&out->by_phi[j], -h * gauss_outer[j][l], &F[l]);
            out->by_omega[j][l] = (mat3){0};
            add_matrix(&out->by_omega[j][l], h * gauss_weight[l], SN);
            for (int q = 0; q < G; q++) {
                add_matrix(&out->by_omega[j][l], -h * h * gauss_outer[j][q] * gauss_inner[q][l],
                           &F[q]);
            }
        }
    }
}

static void assemble_followers(double h, const station_tangent *t, const follower_map *f,
                               double A[UNKNOWNS][UNKNOWNS], double rhs[UNKNOWNS][3])
{
    for (int i = 0; i < G; i++) {
        const mat3 Bt = mat3_transpose(t[i].B);
        const mat3 own = mat3_mul(Bt, f->by_phi[i]);
        add_column(rhs, i, h * gauss_weight[i], &own);
        for (int l = 0; l < G; l++) {
            const mat3 direct = mat3_mul(Bt, f->by_omega[i][l]);
            add_block(A, i, l, h * gauss_weight[i], &direct);
            const double c = h * h * gauss_weight[l] * gauss_inner[l][i];
            const mat3 turning = mat3_mul(f->moment[l], f->by_phi[l]);
            add_column(rhs, i, c, &turning);
            for (int q = 0; q < G; q++) {
                const mat3 more = mat3_mul(f->moment[l], f->by_omega[l][q]);
                add_block(A, i, q, c, &more);
            }
        }
    }
}

// --- from the tip to the base

void sweep_solve_panel(const equilibrium *e, int panel, double *b)
{
    const panel_factor *f = &e->panel[panel];
    const double(*A)[UNKNOWNS] = (const double(*)[UNKNOWNS])f->A;
    if (e->conservative) {
        panel_solve_symmetric(A, b);
    } else {
        panel_solve_general(A, f->exchange, b);
    }
}

static mat3 response_block(const panel_factor *f, int j)
{
    mat3 m;
    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 3; c++) {
            m.a[r][c] = f->response[3 * j + r][c];
        }
    }
    return m;
}

// what a load at a node adds to S and SN of all that lies beyond the panel before it
static void add_node(const equilibrium *e, int node, mat3 *S, mat3 *SN)
{
    const load_sum *l = &e->node[node];
    const mat3 *R = &e->node_R[node];
    const mat3 x = mat3_mul(*R, l->dyad);
    const double trace = x.a[0][0] + x.a[1][1] + x.a[2][2];
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const double other = e->conservative ? (x.a[i][j] + x.a[j][i]) / 2 : x.a[i][j];
            S->a[i][j] -= (i == j ? trace : 0) - other;
        }
    }
    const mat3 moment = mat3_hat(mat3_mul_vec(*R, l->follower_moment));
    const mat3 force = mat3_hat(mat3_mul_vec(*R, l->follower));
    add_matrix(S, -1, &moment);
    add_matrix(SN, -1, &force);
}

// S and SN at the panel's left node
static void pass_panel(const equilibrium *e, int k, double h, const follower_map *f, mat3 *S,
                       mat3 *SN)
{
    const panel_factor *panel = &e->panel[k];
    const station_tangent *t = &e->tangent[G * k];
    const mat3 one = mat3_identity();
    mat3 omega[G], end = one, phi[G];
    for (int j = 0; j < G; j++) {
        omega[j] = response_block(panel, j);
        add_matrix(&end, h * gauss_weight[j], &omega[j]);
    }
    for (int j = 0; j < G; j++) {
        phi[j] = one;
        for (int l = 0; l < G; l++) {
            add_matrix(&phi[j], h * gauss_inner[j][l], &omega[l]);
        }
    }
    *S = mat3_mul(panel->S, end);
    *SN = mat3_mul(panel->SN, end);
    for (int j = 0; j < G; j++) {
        const mat3 a = mat3_mul(t[j].pp, phi[j]), b = mat3_mul(t[j].pw, omega[j]);
        add_matrix(S, -h * gauss_weight[j], &a);
        add_matrix(S, -h * gauss_weight[j], &b);
        if (f) {
            mat3 dN = f->by_phi[j];
            for (int l = 0; l < G; l++) {
                const mat3 more = mat3_mul(f->by_omega[j][l], omega[l]);
                add_matrix(&dN, 1, &more);
            }
            const mat3 m = mat3_mul(f->moment[j], dN), F = force_turning(e, G * k + j);
            const mat3 turning = mat3_mul(F, phi[j]);
            add_matrix(S, -h * gauss_weight[j], &m);
            add_matrix(SN, -h * gauss_weight[j], &turning);
        }
    }
}

// over the pivots of a rod without loads, so that no product of them overflows
static void keep_determinant(equilibrium *e, const station_tangent *t, double h, double product)
{
    double without = 1;
    for (int i = 0; i < UNKNOWNS; i++) {
        without *= h * gauss_weight[i / 3] * fabs(t[i / 3].D.a[i % 3][i % 3]);
    }
    int exponent;
    e->determinant_size = frexp(e->determinant_size * (product / without), &exponent);
    e->determinant_exponent += exponent;
}

static void solve_response(const equilibrium *e, panel_factor *panel)
{
    if (e->conservative) {
        panel_solve_columns((const double(*)[UNKNOWNS])panel->A, panel->response);
        return;
    }
    for (int c = 0; c < 3; c++) {
        double b[UNKNOWNS];
        for (int i = 0; i < UNKNOWNS; i++) {
            b[i] = panel->response[i][c];
        }
        panel_solve_general((const double(*)[UNKNOWNS])panel->A, panel->exchange, b);
        for (int i = 0; i < UNKNOWNS; i++) {
            panel->response[i][c] = b[i];
        }
    }
}

static bool factor_panel(equilibrium *e, int k, mat3 *S, mat3 *SN)
{
    panel_factor *panel = &e->panel[k];
    const double h = panel_length(e->plan, k);
    const station_tangent *t = &e->tangent[G * k];
    follower_map map;
    const follower_map *f = NULL;
    panel->S = *S;
    panel->SN = *SN;
    assemble(h, t, S, e->conservative, panel->A, panel->response);
    if (e->followers) {
        map_followers(e, k, h, SN, &map);
        assemble_followers(h, t, &map, panel->A, panel->response);
        f = &map;
    }
    double product = 1;
    if (e->conservative) {
        const int negative = panel_factor_symmetric(panel->A, &product);
        if (negative < 0) {
            return false;
        }
        e->negative += negative;
        e->determinant = negative % 2 ? -e->determinant : e->determinant;
    } else {
        const int sign = panel_factor_general(panel->A, panel->exchange, &product);
        if (sign == 0) {
            return false;
        }
        e->determinant *= sign;
    }
    keep_determinant(e, t, h, product);
    for (int i = 0; i < UNKNOWNS; i++) {
        for (int c = 0; c < 3; c++) {
            panel->response[i][c] = -panel->response[i][c];
        }
    }
    solve_response(e, panel);
    pass_panel(e, k, h, f, S, SN);
    return true;
}

double sweep_log_determinant(const equilibrium *e)
{
    return log(e->determinant_size) + e->determinant_exponent * 0.69314718055994530942;
}

bool sweep_factor(equilibrium *e)
{
    mat3 S = {0}, SN = {0};
    e->negative = 0;
    e->determinant = 1;
    e->determinant_size = 1;
    e->determinant_exponent = 0;
    for (int k = 2 * e->plan->npair - 1; k >= 0; k--) {
        add_node(e, k + 1, &S, &SN);
        if (!factor_panel(e, k, &S, &SN)) {
            return false;
        }
    }
    return true;
}
