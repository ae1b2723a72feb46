// app/reach_case.c
#include "app/reach_case.h"

bool case_has_reach(const case_data *c)
{
    return mark_given(c->file.reach.at);
}

status case_need_reach(const case_data *c)
{
    return case_has_reach(c) ? OK : case_lacks(c, (mark){1, 1}, "reach", "endoscope");
}

const scope_case *case_scope(const case_data *c, int i)
{
    return (const scope_case *)c->file.reach.scopes.items + i;
}

bool case_scope_is_rod(const scope_case *s)
{
    return mark_given(s->rod.at);
}

bool case_scope_is_own(const scope_case *s)
{
    return case_scope_is_rod(s) && !s->rod.file.text;
}

// what `set` does to the case is looked at where the scope is made
static status check_own(const case_data *c, const scope_case *s)
{
    const int ntendon = c->file.rod.tendons.count, nrow = s->tensions.nrow;
    if (!case_has_rod(c)) {
        return config_fail(c->config, s->rod.at,
                           "scope '%s' is this case's own rod, but the case has no 'rod' (nor "
                           "does the scope name another case's by `file`)",
                           s->name);
    }
    if (s->rod.set.count == 0 && nrow != ntendon) {
        return config_fail(c->config, s->tensions.at,
                           "scope '%s': %d row%s of tensions, but its rod has %d tendon%s", s->name,
                           nrow, nrow == 1 ? "" : "s", ntendon, ntendon == 1 ? "" : "s");
    }
    return OK;
}

status case_reach_check(const case_data *c)
{
    status st = OK;
    const reach_case *r = &c->file.reach;
    mark where = r->at;
    st = reach_case_check(r, &where);
    TRY(case_place(c, st, where));
    for (int i = 0; i < r->scopes.count; i++) {
        const scope_case *s = case_scope(c, i);
        TRY(case_scope_is_own(s) ? check_own(c, s) : OK);
    }

done:
    return st;
}
