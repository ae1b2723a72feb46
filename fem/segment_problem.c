// fem/segment_problem.c
#include "fem/segment_problem.h"

#include "base/memory.h"

#include <string.h>

void problem_parts_free(problem_parts *p)
{
    free(p->spring);
    free(p->hold);
    free(p->pressure);
    free(p->extra);
    free(p->column);
    *p = (problem_parts){0};
}

static bool is_zero(const double *v)
{
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

static bool load_has_more(const segment_load *load)
{
    return load->pressures.count > 0 || !is_zero(load->body_force) ||
           !is_zero(load->acceleration) || load->holds_move;
}

static status take_supports(const segment_case *c, problem_parts *p)
{
    status st = OK;
    const segment_spring *spring = c->springs.items;
    const segment_hold *hold = c->holds.items;
    TRY(TAKE(p->spring, (size_t)c->springs.count));
    TRY(TAKE(p->hold, (size_t)c->holds.count));
    for (int i = 0; i < c->springs.count; i++) {
        p->spring[i] = segment_face_spring(&spring[i]);
    }
    for (int i = 0; i < c->holds.count; i++) {
        p->hold[i] = segment_face_hold(&hold[i]);
    }
    p->problem.nspring = c->springs.count;
    p->problem.nhold = c->holds.count;
    p->problem.spring = p->spring;
    p->problem.hold = p->hold;

done:
    return st;
}

static int count_pressures(const segment_case *c)
{
    const segment_load *loads = c->loads.items;
    int count = 0;
    for (int i = 0; i < c->loads.count; i++) {
        count += loads[i].pressures.count;
    }
    return count;
}

static void fill_column(const segment_load *load, face_pressure *to, load_column *column)
{
    const segment_pressure *from = load->pressures.items;
    *column = (load_column){
        .npressure = load->pressures.count, .pressure = to, .holds_move = load->holds_move};
    memcpy(column->body_force, load->body_force, sizeof column->body_force);
    memcpy(column->acceleration, load->acceleration, sizeof column->acceleration);
    for (int k = 0; k < load->pressures.count; k++) {
        to[k] = segment_face_pressure(&from[k]);
    }
}

static void fill_uniform(problem_parts *p)
{
    p->uniform = 6;
    for (int i = 0; i < 3; i++) {
        p->extra[i].uniform_tip = true;
        p->extra[i].tip_force[i] = 1;
    }
    p->problem.nextra = 3;
}

static status take_columns(const segment_case *c, problem_parts *p)
{
    status st = OK;
    const segment_load *loads = c->loads.items;
    int used = 0;
    TRY(TAKE(p->pressure, (size_t)count_pressures(c)));
    TRY(TAKE(p->extra, (size_t)c->loads.count + 3));
    TRY(TAKE(p->column, (size_t)c->loads.count));
    p->uniform = -1;
    if (c->tip == TIP_UNIFORM) {
        fill_uniform(p);
    }
    for (int i = 0; i < c->loads.count; i++) {
        p->column[i] = -1;
        if (load_has_more(&loads[i])) {
            p->column[i] = 6 + p->problem.nextra;
            fill_column(&loads[i], p->pressure + used, &p->extra[p->problem.nextra++]);
            used += loads[i].pressures.count;
        }
    }
    p->problem.extra = p->extra;

done:
    return st;
}

status problem_parts_make(const segment_case *c, problem_parts *out)
{
    status st = OK;
    problem_parts p = {.problem = {.base = c->base, .tip = c->tip}};
    TRY(take_supports(c, &p));
    TRY(take_columns(c, &p));
    *out = p;
    p = (problem_parts){0};

done:
    problem_parts_free(&p);
    return st;
}
