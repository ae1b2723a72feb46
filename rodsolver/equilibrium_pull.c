// rodsolver/equilibrium_pull.c
// Tendons whose pulled length is given: their tensions are unknowns, bordering the tangent.
// docs/theory.md (4.22)
#include "rodsolver/collocation.h"
#include "rodsolver/equilibrium.h"

#include <math.h>
#include <string.h>

static double pull_at(const equilibrium *e, int i)
{
    return (1 - e->factor) * e->from.pull[i] + e->factor * e->to.pull[i];
}

double pull_compliance(const equilibrium *e, int i)
{
    const tendon_spec *t = &e->rod->spec[i];
    return t->EA > 0 ? (friction_stretched_length(e, i) + t->outside) / t->EA : 0;
}

// what is too long inside the body: positive pulls
double pull_excess(const equilibrium *e, int i)
{
    return e->length[i] + pull_at(e, i) - e->rest_length[i] - pull_compliance(e, i) * e->tension[i];
}

static double decay_at(const equilibrium *e, int tendon, int station)
{
    return e->friction ? e->decay[(size_t)tendon * (size_t)e->room + (size_t)station] : 1;
}

// adds c times the misfit that a unit tension makes
void pull_misfit(equilibrium *e, int tendon, double c)
{
    for (int i = 0; i < e->plan->tendon[tendon].nstation; i++) {
        const vec6 f = vec6_scale(c * decay_at(e, tendon, i), balance_tendon(e, tendon, i));
        const mat3 *R = &e->state[i].R;
        e->rv[i] = vec3_add(e->rv[i], mat3_mul_vec(*R, vec6_linear(f)));
        e->rw[i] = vec3_add(e->rw[i], mat3_mul_vec(*R, vec6_angular(f)));
    }
}

static void clear_misfits(equilibrium *e)
{
    memset(e->rv, 0, (size_t)e->plan->nstation * sizeof *e->rv);
    memset(e->rw, 0, (size_t)e->plan->nstation * sizeof *e->rw);
}

double pull_length_change(const equilibrium *e, int tendon, const vec6 *strain)
{
    double sum = 0;
    for (int i = 0; i < e->plan->tendon[tendon].nstation; i++) {
        const vec6 f = balance_tendon(e, tendon, i);
        sum += gauss_weight[i % GAUSS_STATIONS] * panel_length(e->plan, i / GAUSS_STATIONS) *
               vec6_dot(f, strain[i]);
    }
    return sum;
}

static bool is_unknown(const equilibrium *e, int i)
{
    return e->pulled[i] && !e->slack[i];
}

void pull_answer(equilibrium *e, int tendon, vec6 *strain)
{
    clear_misfits(e);
    pull_misfit(e, tendon, 1);
    sweep_solve(e, e->rv, e->rw, strain);
}

// T[p][q] = d excess_p / d tension_q of the unknown tensions, rows and columns of the others unit
static void length_matrix(equilibrium *e)
{
    const int n = e->rod->ntendon;
    double *T = e->length_by_tension;
    for (int q = 0; q < n; q++) {
        if (is_unknown(e, q)) {
            pull_answer(e, q, e->scratch);
        }
        for (int p = 0; p < n; p++) {
            const bool both = is_unknown(e, p) && is_unknown(e, q);
            T[p * n + q] = both ? pull_length_change(e, p, e->scratch) : 0;
        }
        T[q * n + q] = is_unknown(e, q) ? T[q * n + q] - pull_compliance(e, q) : -1;
    }
}

// T = -L D L^T in place; T is negative definite where the rod is stable. The number of wrong signs
static int factor_lengths(int n, double *T)
{
    int wrong = 0;
    for (int j = 0; j < n; j++) {
        wrong += !(T[j * n + j] < 0);
        for (int i = j + 1; i < n; i++) {
            const double c = T[i * n + j] / T[j * n + j];
            for (int l = j + 1; l < n; l++) {
                T[i * n + l] -= c * T[j * n + l];
            }
            T[i * n + j] = c;
        }
    }
    return wrong;
}

static void solve_lengths(int n, const double *T, double *b)
{
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < i; j++) {
            b[i] -= T[i * n + j] * b[j];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++) {
            b[i] -= T[i * n + j] * b[j];
        }
        b[i] /= T[i * n + i];
    }
}

bool pull_unknown(const equilibrium *e)
{
    for (int i = 0; i < e->rod->ntendon; i++) {
        if (is_unknown(e, i)) {
            return true;
        }
    }
    return false;
}

// Turns the answer to the misfits kept in e->kept_v, e->kept_w into one that keeps lengths changing
// by `change` [ntendon], by tensions that change by the same array on return
static void hold_lengths(equilibrium *e, double *change, vec6 *strain)
{
    const int n = e->rod->ntendon;
    for (int i = 0; i < n; i++) {
        change[i] = is_unknown(e, i) ? change[i] - pull_length_change(e, i, strain) : 0;
    }
    solve_lengths(n, e->length_by_tension, change);
    memcpy(e->rv, e->kept_v, (size_t)e->plan->nstation * sizeof *e->rv);
    memcpy(e->rw, e->kept_w, (size_t)e->plan->nstation * sizeof *e->rw);
    for (int i = 0; i < n; i++) {
        if (is_unknown(e, i)) {
            pull_misfit(e, i, change[i]);
        }
    }
    sweep_solve(e, e->rv, e->rw, strain);
}

void pull_solve(equilibrium *e, double *change, vec6 *strain)
{
    if (pull_unknown(e)) {
        memcpy(e->kept_v, e->rv, (size_t)e->plan->nstation * sizeof *e->rv);
        memcpy(e->kept_w, e->rw, (size_t)e->plan->nstation * sizeof *e->rw);
        sweep_solve(e, e->rv, e->rw, strain);
        hold_lengths(e, change, strain);
    } else {
        sweep_solve(e, e->rv, e->rw, strain);
        memset(change, 0, (size_t)e->rod->ntendon * sizeof *change);
    }
}

// tendons that would push go slack, slack ones that are too long inside pull; whether any changed
bool pull_update_slack(equilibrium *e)
{
    bool changed = false;
    for (int i = 0; i < e->rod->ntendon; i++) {
        if (!e->pulled[i]) {
            continue;
        }
        const bool slack =
            e->slack[i] ? !(pull_excess(e, i) > 1e-12 * e->rest_length[i]) : e->tension[i] < 0;
        changed = changed || slack != e->slack[i];
        e->slack[i] = slack;
        e->tension[i] = slack ? 0 : e->tension[i];
    }
    return changed;
}

bool pull_any(const equilibrium *e)
{
    for (int i = 0; i < e->rod->ntendon; i++) {
        if (e->pulled[i]) {
            return true;
        }
    }
    return false;
}

void pull_factor(equilibrium *e)
{
    length_matrix(e);
    const int wrong = factor_lengths(e->rod->ntendon, e->length_by_tension);
    // inertia of the bordered matrix: each constraint takes one negative direction away
    e->negative -= wrong;
    e->determinant = wrong % 2 ? -e->determinant : e->determinant;
    for (int i = 0; i < e->rod->ntendon; i++) {
        int exponent;
        const double pivot = fabs(e->length_by_tension[i * e->rod->ntendon + i]);
        e->determinant_size = frexp(e->determinant_size * pivot, &exponent);
        e->determinant_exponent += exponent;
    }
}
