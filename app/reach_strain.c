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

// --- the strains in a pose

struct reach_strain_probe {
    const reach_scope *scope;
    strains_along *known;
    rod_state *rod;
    double place[STRAIN_SAMPLES];
};

void reach_strain_probe_free(reach_strain_probe *p)
{
    if (p) {
        strains_along_free(p->known);
        rod_state_free(p->rod);
        free(p);
    }
}

status reach_strain_probe_make(reach_scope *s, reach_strain_probe **out)
{
    status st = OK;
    reach_strain_probe *p = NULL;
    const section_case solved = varied_section(s->v, &s->rod);
    TRY(TAKE(p, 1));
    p->scope = s;
    for (int i = 0; i < STRAIN_SAMPLES; i++) {
        p->place[i] = s->scope.length * i / (STRAIN_SAMPLES - 1);
    }
    TRY(rod_state_make(s->scope.rod, &p->rod));
    TRY(strains_along_make(&solved, s->rod.c.materials, s->rod.law, STRAIN_SAMPLES, p->place,
                           &p->known));
    *out = p;
    p = NULL;

done:
    reach_strain_probe_free(p);
    return st;
}

status reach_strain_at(const reach_strain_probe *p, const double *q, section_strain_place *out)
{
    status st = OK;
    vec6 wrench[STRAIN_SAMPLES];
    double tension[SCOPE_TENDONS];
    rod_solution found = {0};
    scope_tensions(&p->scope->scope, q, tension);
    TRY(rod_solve(p->rod, &(rod_request){.tension = tension, .cold = true}, &found));
    for (int i = 0; i < STRAIN_SAMPLES; i++) {
        TRY(rod_wrench_at(p->rod, p->place[i], &wrench[i], NULL));
    }
    TRY(strains_along_at(p->known, wrench, out));

done:
    return st;
}

bool reach_strain_is_searched(const reach_scope *s)
{
    return s->v && s->said->strain_limit && s->scope.njoint > SCOPE_BEND + 1;
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

status reach_strain_share(const reach_strain_probe *p, const double *q, double *share)
{
    status st = OK;
    section_strain_place *strain = NULL;
    TRY(TAKE(strain, (size_t)p->scope->rod.c.nmaterial));
    TRY(reach_strain_at(p, q, strain));
    (void)reach_worst_strain(p->scope, strain, share);

done:
    free(strain);
    return st;
}

// --- the tension at which a material passes its linear strain

// It lies between two tensions.
typedef struct strain_search {
    double low, high; // [N]; no material passes its limit up to low; at high this one does
    int material;     // -1: none does
} strain_search;

// The strains at these rising tensions, for as many of them as have a shape. Past what the rod can
// bear none has; `why` keeps the words of the first of them.
static status find_strains(const reach_strain_probe *p, int n, const double (*q)[SCOPE_JOINTS],
                           section_strain_place *strain, int *count, char *why, size_t room)
{
    status st = OK;
    for (*count = 0; *count < n; (*count)++) {
        st = reach_strain_at(p, q[*count], strain + *count * p->scope->rod.c.nmaterial);
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

static status one_round(const reach_strain_probe *p, strain_search *a)
{
    status st = OK;
    const reach_scope *s = p->scope;
    double list[ROUND_TENSIONS][SCOPE_JOINTS] = {{0}};
    const double(*q)[SCOPE_JOINTS] = (const double(*)[SCOPE_JOINTS])list;
    section_strain_place *strain = NULL;
    char why[400];
    int n = 0;
    lay_tensions(a, list);
    TRY(TAKE(strain, (size_t)ROUND_TENSIONS * (size_t)s->rod.c.nmaterial));
    TRY(find_strains(p, ROUND_TENSIONS, q, strain, &n, why, sizeof why));
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
    reach_strain_probe *p = NULL;
    if (!any_limit(&s->rod.c)) {
        return status_fail(ERR_INPUT, "strain_limit: no material has a linear_strain");
    }
    TRY(reach_strain_probe_make(s, &p));
    for (int round = 0; round < ROUNDS; round++) {
        TRY(one_round(p, &a));
        if (a.material < 0) {
            goto done; // nowhere in its range
        }
    }
    const material *m = &s->rod.c.materials[a.material];
    if (a.high <= *low) {
        TRY(status_fail(ERR_INPUT,
                        "strain_limit: at its least tension, %.4g N, '%s' is strained past its "
                        "%.4g %%",
                        *low, m->name, 100 * m->linear_strain));
    }
    (void)snprintf(s->limit_note, sizeof s->limit_note,
                   "tension at most %.4g N of %.4g N: there '%.40s' is strained by its %.4g %%",
                   a.low, *high, m->name, 100 * m->linear_strain);
    *high = a.low;

done:
    reach_strain_probe_free(p);
    return st;
}
