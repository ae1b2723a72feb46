// reports/reach_result.c
#include "reports/reach_result.h"

#include "base/memory.h"

const char *reach_verdict_words(int verdict)
{
    static const char *const words[] = {"reached",   "out of reach", "joint limit",
                                        "collision", "no way in",    "failed"};
    return verdict >= 0 && verdict <= REACH_FAILED ? words[verdict] : "not known";
}

status reach_answer_room(reach_answer *a, int npoint, int npath)
{
    status st = OK;
    TRY(TAKE(a->path, (size_t)npath));
    a->npath = npath;
    TRY(TAKE(a->along, (size_t)npoint));
    TRY(TAKE(a->point, (size_t)npoint));
    TRY(TAKE(a->room, (size_t)npoint));
    a->npoint = npoint;

done:
    return st;
}

status reach_answer_way(reach_answer *a, int nway)
{
    status st = OK;
    TRY(TAKE(a->way, (size_t)nway));
    a->nway = nway;

done:
    return st;
}

static void free_answer(reach_answer *a)
{
    free(a->path);
    free(a->way);
    free(a->along);
    free(a->point);
    free(a->room);
}

static void free_scopes(reach_result *r)
{
    for (int i = 0; r->scope && i < r->nscope; i++) {
        reach_scope_result *s = &r->scope[i];
        for (int k = 0; s->answer && k < r->ntarget; k++) {
            free_answer(&s->answer[k]);
        }
        free(s->answer);
        free(s->state);
    }
    free(r->scope);
}

void reach_design_free(reach_design_result *d)
{
    for (int i = 0; d->row && i < d->nrow; i++) {
        free(d->row[i].value);
    }
    free(d->row);
    free(d->name);
    free(d->unit);
    free(d->lower);
    free(d->upper);
    free(d->start);
    *d = (reach_design_result){0};
}

void reach_result_free(reach_result *r)
{
    free(r->vertex);
    free(r->triangle);
    free(r->target_name);
    free(r->target);
    free(r->target_depth);
    free(r->map_point);
    free_scopes(r);
    reach_design_free(&r->design);
    *r = (reach_result){0};
}

static status take_scopes(const reach_result *sizes, reach_result *r)
{
    status st = OK;
    TRY(TAKE(r->scope, (size_t)sizes->nscope));
    r->nscope = sizes->nscope;
    for (int i = 0; i < r->nscope; i++) {
        TRY(TAKE(r->scope[i].answer, (size_t)r->ntarget));
        TRY(r->nmap > 0 ? TAKE(r->scope[i].state, (size_t)r->nmap) : OK);
    }

done:
    return st;
}

status reach_design_make(int nparameter, int nrow, reach_design_result *out)
{
    status st = OK;
    reach_design_result d = {.there = true, .nparameter = nparameter};
    const size_t n = (size_t)nparameter;
    TRY(TAKE(d.name, n));
    TRY(TAKE(d.unit, n));
    TRY(TAKE(d.lower, n));
    TRY(TAKE(d.upper, n));
    TRY(TAKE(d.start, n));
    TRY(TAKE(d.row, (size_t)nrow));
    d.nrow = nrow;
    for (int i = 0; i < nrow; i++) {
        TRY(TAKE(d.row[i].value, n));
    }
    *out = d;
    d = (reach_design_result){0};

done:
    reach_design_free(&d);
    return st;
}

status reach_result_make(const reach_result *sizes, reach_result *out)
{
    status st = OK;
    reach_result r = {.there = true,
                      .nvertex = sizes->nvertex,
                      .ntriangle = sizes->ntriangle,
                      .ntarget = sizes->ntarget,
                      .nmap = sizes->nmap,
                      .entry = pose_identity()};
    TRY(TAKE(r.vertex, (size_t)r.nvertex));
    TRY(TAKE(r.triangle, (size_t)r.ntriangle));
    TRY(TAKE(r.target_name, (size_t)r.ntarget));
    TRY(TAKE(r.target, (size_t)r.ntarget));
    TRY(TAKE(r.target_depth, (size_t)r.ntarget));
    TRY(TAKE(r.map_point, (size_t)r.nmap));
    TRY(take_scopes(sizes, &r));
    if (sizes->design.there) {
        TRY(reach_design_make(sizes->design.nparameter, sizes->design.nrow, &r.design));
    }
    *out = r;
    r = (reach_result){0};

done:
    reach_result_free(&r);
    return st;
}
