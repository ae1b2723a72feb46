// app/reach_strain.c
#include "app/reach_scopes.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

// places along the rod where the materials' strains are looked at, ends included
enum { STRAIN_SAMPLES = 61 };

// Tensions of one round of the search for a limit; every round looks between two of the last, so
// that after ROUNDS the limit is known to 1 / 32^3 of the range.
enum { ROUND_TENSIONS = 33, ROUNDS = 3 };

static status sample_wrenches(const rod_state *r, double length, double *s, vec6 *wrench)
{
    status st = OK;
    for (int i = 0; i < STRAIN_SAMPLES; i++) {
        s[i] = length * i / (STRAIN_SAMPLES - 1);
        TRY(rod_wrench_at(r, s[i], &wrench[i], NULL));
    }

done:
    return st;
}

status reach_strains(reach_scope *s, int n, const double (*q)[SCOPE_JOINTS],
                     section_strain_place *out)
{
    status st = OK;
    vec6 *wrench = NULL;
    double place[STRAIN_SAMPLES];
    const case_data *c = &s->rod.c;
    TRY(TAKE(wrench, (size_t)n * STRAIN_SAMPLES));
    for (int i = 0; i < n; i++) {
        rod_solution found = {0};
        const rod_request request = {.tension = &q[i][SCOPE_BEND], .cold = true};
        TRY(rod_solve(s->rod.state, &request, &found));
        TRY(sample_wrenches(s->rod.state, s->scope.length, place, &wrench[i * STRAIN_SAMPLES]));
    }
    const section_case solved = varied_section(s->v, &s->rod);
    const section_wrenches_along along = {STRAIN_SAMPLES, place, n, wrench};
    TRY(section_strain_along(&solved, c->materials, s->rod.law, &along, out));

done:
    free(wrench);
    return st;
}

int reach_worst_strain(const reach_scope *s, const section_strain_place *strain, double *share)
{
    const case_data *c = &s->rod.c;
    int worst = -1;
    *share = 0;
    for (int m = 0; m < c->nmaterial; m++) {
        const double limit = c->materials[m].linear_strain;
        const double here = limit > 0 ? fabs(strain[m].value) / limit : 0;
        if (limit > 0 && (worst < 0 || here > *share)) {
            worst = m;
            *share = here;
        }
    }
    return worst;
}

// --- the tension at which a material passes its linear strain

// It lies between two tensions.
typedef struct strain_search {
    double low, high; // [N]; no material passes its limit up to low; at high this one does
    int material;     // -1: none does
} strain_search;

// How many of these rising tensions have a shape. Past what the rod can bear none has; `why` keeps
// the words of the first of them.
static status count_shapes(reach_scope *s, int n, const double (*q)[SCOPE_JOINTS], int *count,
                           char *why, size_t room)
{
    status st = OK;
    for (*count = 0; *count < n; (*count)++) {
        rod_solution found = {0};
        const rod_request request = {.tension = &q[*count][SCOPE_BEND], .cold = true};
        st = rod_solve(s->rod.state, &request, &found);
        if (st == ERR_NUMERIC) {
            (void)snprintf(why, room, "%s", status_message());
            status_clear();
            return OK;
        }
        TRY(st);
    }

done:
    return st;
}

static void lay_tensions(const strain_search *a, double (*q)[SCOPE_JOINTS])
{
    const double step = (a->high - a->low) / (ROUND_TENSIONS - 1);
    for (int i = 0; i < ROUND_TENSIONS; i++) {
        q[i][SCOPE_BEND] = i == ROUND_TENSIONS - 1 ? a->high : a->low + i * step;
    }
}

// the first of n poses in which a material passes its limit, n where none does
static int first_past(const reach_scope *s, int n, const section_strain_place *strain,
                      int *material)
{
    const int nmaterial = s->rod.c.nmaterial;
    double share;
    for (int i = 0; i < n; i++) {
        *material = reach_worst_strain(s, &strain[i * nmaterial], &share);
        if (share > 1) {
            return i;
        }
    }
    *material = -1;
    return n;
}

static status one_round(reach_scope *s, strain_search *a)
{
    status st = OK;
    double list[ROUND_TENSIONS][SCOPE_JOINTS] = {{0}};
    const double(*q)[SCOPE_JOINTS] = (const double(*)[SCOPE_JOINTS])list;
    section_strain_place *strain = NULL;
    char why[400];
    int n = 0;
    lay_tensions(a, list);
    TRY(TAKE(strain, (size_t)ROUND_TENSIONS * (size_t)s->rod.c.nmaterial));
    TRY(count_shapes(s, ROUND_TENSIONS, q, &n, why, sizeof why));
    TRY(n > 0 ? reach_strains(s, n, q, strain) : OK);
    const int past = first_past(s, n, strain, &a->material);
    if (past == n && n < ROUND_TENSIONS) {
        // no strain ends the range before the rod does
        TRY(status_fail(ERR_NUMERIC, "%s", why));
    }
    if (past < n) {
        a->low = q[past > 0 ? past - 1 : 0][SCOPE_BEND];
        a->high = q[past][SCOPE_BEND];
    }

done:
    free(strain);
    return st;
}

static bool any_limit(const case_data *c)
{
    bool any = false;
    for (int i = 0; i < c->nmaterial; i++) {
        any = any || c->materials[i].linear_strain > 0;
    }
    return any;
}

status reach_limit_tension(reach_scope *s)
{
    status st = OK;
    double *low = &s->scope.low[SCOPE_BEND], *high = &s->scope.high[SCOPE_BEND];
    strain_search a = {*low, *high, -1};
    if (!any_limit(&s->rod.c)) {
        return status_fail(ERR_INPUT, "strain_limit: no material has a linear_strain");
    }
    for (int round = 0; round < ROUNDS; round++) {
        TRY(one_round(s, &a));
        if (a.material < 0) {
            return OK; // nowhere in its range
        }
    }
    const material *m = &s->rod.c.materials[a.material];
    if (a.high <= *low) {
        return status_fail(ERR_INPUT,
                           "strain_limit: at its least tension, %.4g N, '%s' is strained past its "
                           "%.4g %%",
                           *low, m->name, 100 * m->linear_strain);
    }
    (void)snprintf(s->limit_note, sizeof s->limit_note,
                   "tension at most %.4g N of %.4g N: there '%.40s' is strained by its %.4g %%",
                   a.low, *high, m->name, 100 * m->linear_strain);
    *high = a.low;

done:
    return st;
}
