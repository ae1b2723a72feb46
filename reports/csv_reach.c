// reports/csv_reach.c
// reach.csv: a row per scope and target; reach_scopes.csv: the scopes beside each other;
// reach_body.csv: the bodies in their poses; reach_way.csv: the ways in; reach_map.csv:
// the samples of the wall; design.csv: what a search for a design found.
#include "reach/reach_case.h"
#include "reports/csv_kit.h"
#include "reports/reach_show.h"

#include <math.h>
#include <stdio.h>

static const char *const map_words[] = {"not reached", "reached", "not known"};

// tensions of the scope that has most
static int most_tendons(const reach_result *r)
{
    int most = 0;
    for (int i = 0; i < r->nscope; i++) {
        const reach_scope_result *s = &r->scope[i];
        const int n = s->arc ? 0 : s->njoint - SCOPE_BEND;
        most = n > most ? n : most;
    }
    return most;
}

// FRONT_insertion_m, FRONT_turn_rad, FRONT_bend_rad, FRONT_tension_1_N ...
static void add_joints(csv_header *h, int ntendon, const char *front)
{
    static const char *const names[] = {"insertion_m", "turn_rad", "bend_rad"};
    char name[CSV_MAX_NAME];
    for (int i = 0; i < 3 + ntendon; i++) {
        if (i < 3) {
            (void)snprintf(name, sizeof name, "%s%s", front, names[i]);
        } else {
            (void)snprintf(name, sizeof name, "%stension_%d_N", front, i - 2);
        }
        csv_add(h, name);
    }
}

// what the scope does not have stays empty; q NULL: all of it
static void write_joints(csv *c, const reach_scope_result *s, int ntendon, const double *q)
{
    csv_real(c, q ? q[SCOPE_INSERTION] : NAN);
    csv_real(c, q ? q[SCOPE_TURN] : NAN);
    csv_real(c, q && s->arc ? q[SCOPE_BEND] : NAN);
    for (int i = 0; i < ntendon; i++) {
        const bool there = q && !s->arc && SCOPE_BEND + i < s->njoint;
        csv_real(c, there ? q[SCOPE_BEND + i] : NAN);
    }
}

static void write_answer(csv *c, const reach_result *r, const reach_scope_result *s, int target)
{
    const reach_answer *a = &s->answer[target];
    const bool pose = a->verdict != REACH_FAILED;
    char words[REACH_WORDS];
    csv_text(c, s->name);
    csv_text(c, r->target_name[target]);
    csv_reals(c, 3, r->target[target]);
    csv_real(c, r->target_depth[target]);
    csv_text(c, reach_verdict_words(a->verdict));
    csv_text(c, a->why);
    csv_text(c, reach_search_words(r, s, a, words, sizeof words));
    csv_text(c, a->verdict == REACH_REACHED ? "" : reach_is_proved(r, s, a) ? "true" : "false");
    write_joints(c, s, most_tendons(r), pose ? a->q : NULL);
    csv_real(c, pose ? a->miss : NAN);
    csv_real(c, a->clearance);
    csv_real(c, a->s);
    csv_real(c, a->bound);
    csv_real(c, a->path_clearance);
    csv_real(c, a->strain);
    csv_real(c, a->looks);
    csv_real(c, a->starts);
}

static status write_answers(const reach_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h, "scope target target_x_m target_y_m target_z_m target_depth_m verdict why "
                    "thoroughness proved");
    add_joints(&h, most_tendons(r), "");
    csv_add_all(&h, "miss_m clearance_m least_clear_at_s_m clearance_bound_m way_clearance_m "
                    "strain_ratio looks_count starts_count");
    const status st = csv_table(dir, "reach.csv", &h, &c);
    for (int i = 0; st == OK && i < r->nscope; i++) {
        for (int k = 0; k < r->ntarget; k++) {
            write_answer(c, r, &r->scope[i], k);
        }
    }
    return st == OK ? csv_close(c) : st;
}

// --- scopes --------------------------------------------------------------------------------------

static void write_scope(csv *c, const reach_result *r, const reach_scope_result *s)
{
    const int ntendon = most_tendons(r);
    const bool map = s->state != NULL;
    csv_text(c, s->name);
    csv_text(c, s->kind);
    csv_text(c, r->synthetic ? "synthetic" : "as given");
    csv_real(c, s->nreached);
    csv_real(c, r->ntarget);
    csv_real(c, r->ntarget > 0 ? (double)s->nreached / r->ntarget : NAN);
    csv_real(c, map ? s->area_reached : NAN);
    csv_real(c, map ? s->area_undecided : NAN);
    csv_real(c, map ? s->area_error : NAN);
    csv_real(c, s->length);
    csv_real(c, s->radius);
    write_joints(c, s, ntendon, s->low);
    write_joints(c, s, ntendon, s->high);
    csv_text(c, s->limit_note);
    csv_real(c, s->spacing);
    csv_real(c, map ? s->map_spacing : NAN);
    csv_real(c, s->seconds);
}

static status write_scopes(const reach_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h, "scope kind anatomy reached_count targets_count reached_ratio "
                    "area_reached_ratio area_undecided_ratio area_error_ratio length_m radius_m");
    add_joints(&h, most_tendons(r), "least_");
    add_joints(&h, most_tendons(r), "most_");
    csv_add_all(&h, "limit_note pose_spacing_m map_spacing_m cpu_s");
    const status st = csv_table(dir, "reach_scopes.csv", &h, &c);
    for (int i = 0; st == OK && i < r->nscope; i++) {
        write_scope(c, r, &r->scope[i]);
    }
    return st == OK ? csv_close(c) : st;
}

// --- bodies and ways in --------------------------------------------------------------------------

static status write_bodies(const reach_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h, "scope target verdict s_m x_m y_m z_m state clearance_m");
    const status st = csv_table(dir, "reach_body.csv", &h, &c);
    for (int i = 0; st == OK && i < r->nscope; i++) {
        for (int k = 0; k < r->ntarget; k++) {
            const reach_answer *a = &r->scope[i].answer[k];
            for (int j = 0; j < a->npoint; j++) {
                csv_text(c, r->scope[i].name);
                csv_text(c, r->target_name[k]);
                csv_text(c, reach_verdict_words(a->verdict));
                csv_real(c, a->along[j]);
                csv_reals(c, 3, a->point[j]);
                csv_text(c, reach_part_words(reach_part_of(r, a, j)));
                csv_real(c, a->room[j]);
            }
        }
    }
    return st == OK ? csv_close(c) : st;
}

static status write_ways(const reach_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h, "scope target pose_count");
    add_joints(&h, most_tendons(r), "");
    const status st = csv_table(dir, "reach_way.csv", &h, &c);
    for (int i = 0; st == OK && i < r->nscope; i++) {
        const reach_scope_result *s = &r->scope[i];
        for (int k = 0; k < r->ntarget; k++) {
            for (int j = 0; j < s->answer[k].npath; j++) {
                csv_text(c, s->name);
                csv_text(c, r->target_name[k]);
                csv_real(c, j + 1);
                write_joints(c, s, most_tendons(r), s->answer[k].path[j]);
            }
        }
    }
    return st == OK ? csv_close(c) : st;
}

// --- map and design ------------------------------------------------------------------------------

// scopes are numbered, since two may be called the same
static status write_map(const reach_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h, "x_m y_m z_m");
    for (int i = 0; i < r->nscope; i++) {
        char name[CSV_MAX_NAME];
        (void)snprintf(name, sizeof name, "scope_%d_%s", i + 1, r->scope[i].name);
        csv_add(&h, name);
    }
    const status st = csv_table(dir, "reach_map.csv", &h, &c);
    for (int k = 0; st == OK && k < r->nmap; k++) {
        csv_reals(c, 3, r->map_point[k]);
        for (int i = 0; i < r->nscope; i++) {
            csv_text(c, map_words[r->scope[i].state[k]]);
        }
    }
    return st == OK ? csv_close(c) : st;
}

static status write_design(const reach_design_result *d, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h, "island_count evaluation_count best");
    csv_add(&h, d->goal == DESIGN_TARGETS ? "targets_reached_count" : "area_reached_ratio");
    csv_add(&h, "score_ratio");
    for (int i = 0; i < d->nparameter; i++) {
        char name[CSV_MAX_NAME];
        (void)snprintf(name, sizeof name, "parameter_%d_%.40s_%.24s", i + 1, d->name[i],
                       d->unit[i][0] ? d->unit[i] : "ratio");
        csv_add(&h, name);
    }
    const status st = csv_table(dir, "design.csv", &h, &c);
    for (int i = 0; st == OK && i < d->nrow; i++) {
        const reach_design_row *row = &d->row[i];
        csv_real(c, row->island + 1);
        csv_real(c, row->evaluation);
        csv_text(c, i == d->best ? "best" : "");
        csv_real(c, row->goal);
        csv_real(c, row->score);
        csv_reals(c, d->nparameter, row->value);
    }
    return st == OK ? csv_close(c) : st;
}

status csv_reach(const reach_result *r, const char *dir)
{
    status st = OK;
    TRY(write_scopes(r, dir));
    TRY(r->ntarget > 0 ? write_answers(r, dir) : OK);
    TRY(r->ntarget > 0 ? write_bodies(r, dir) : OK);
    TRY(r->path == REACH_INSERTION && r->ntarget > 0 ? write_ways(r, dir) : OK);
    TRY(r->nmap > 0 ? write_map(r, dir) : OK);
    TRY(r->design.there ? write_design(&r->design, dir) : OK);

done:
    return st;
}
