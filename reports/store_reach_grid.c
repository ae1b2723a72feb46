// reports/store_reach_grid.c
#include "reports/store_reach_grid.h"

#include "base/memory.h"
#include "reports/near_points.h"

#include <stdio.h>
#include <string.h>

enum { WALL, CLEARANCE = 0, TARGET, STATE };

void reach_pieces_free(reach_pieces *p)
{
    for (int i = 0; i < REACH_PIECES; i++) {
        mesh_free(&p->mesh[i]);
        for (int k = 0; k < REACH_FIELDS; k++) {
            free(p->data[i][k]);
        }
    }
    *p = (reach_pieces){0};
}

static status add_wall(const reach_result *r, reach_pieces *p)
{
    status st = OK;
    near_points near = {0};
    mesh *m = &p->mesh[WALL];
    TRY(mesh_make(1, r->nvertex, 1, (const shape[]){SHAPE_TRIANGLE}, &r->ntriangle, m));
    memcpy(m->xyz, r->vertex, (size_t)r->nvertex * sizeof *r->vertex);
    memcpy(m->block[0].conn, r->triangle, (size_t)r->ntriangle * sizeof *r->triangle);
    TRY(near_points_make(r->nmap, (const double(*)[3])r->map_point, &near));
    for (int i = 0; r->nmap > 0 && i < r->nscope; i++) {
        TRY(TAKE(p->data[WALL][STATE + i], (size_t)r->nvertex));
    }
    for (int k = 0; r->nmap > 0 && k < r->nvertex; k++) {
        const double *at = r->vertex[k];
        const int sample = near_points_find(&near, (vec3){{at[0], at[1], at[2]}});
        for (int i = 0; sample >= 0 && i < r->nscope; i++) {
            p->data[WALL][STATE + i][k] = r->scope[i].state[sample];
        }
    }

done:
    near_points_free(&near);
    return st;
}

// all bodies of a scope as lines from point to point
static status add_bodies(const reach_result *r, const reach_scope_result *s, int piece,
                         reach_pieces *p)
{
    status st = OK;
    int npoint = 0, nline = 0;
    for (int k = 0; k < r->ntarget; k++) {
        npoint += s->answer[k].npoint;
        nline += s->answer[k].npoint > 1 ? s->answer[k].npoint - 1 : 0;
    }
    mesh *m = &p->mesh[piece];
    TRY(mesh_make(1, npoint, 1, (const shape[]){SHAPE_LINE}, &nline, m));
    TRY(TAKE(p->data[piece][CLEARANCE], (size_t)npoint));
    TRY(TAKE(p->data[piece][TARGET], (size_t)npoint));
    int at = 0, *line = m->block[0].conn;
    for (int k = 0; k < r->ntarget; k++) {
        const reach_answer *a = &s->answer[k];
        for (int i = 0; i < a->npoint; i++, at++) {
            memcpy(m->xyz + 3 * (size_t)at, a->point[i], sizeof a->point[i]);
            p->data[piece][CLEARANCE][at] = a->room[i];
            p->data[piece][TARGET][at] = k + 1;
            if (i > 0) {
                *line++ = at - 1;
                *line++ = at;
            }
        }
    }

done:
    return st;
}

static bool has_bodies(const reach_result *r, const reach_scope_result *s)
{
    for (int k = 0; k < r->ntarget; k++) {
        if (s->answer[k].npoint > 1) {
            return true;
        }
    }
    return false;
}

static void name_fields(const reach_result *r, reach_pieces *p)
{
    (void)snprintf(p->field[CLEARANCE], sizeof p->field[0], "clearance_m");
    (void)snprintf(p->field[TARGET], sizeof p->field[0], "target_count");
    p->nfield = STATE;
    for (int i = 0; r->nmap > 0 && i < r->nscope; i++) {
        (void)snprintf(p->field[p->nfield++], sizeof p->field[0], "scope_%d_state", i + 1);
    }
}

status reach_pieces_make(const reach_result *r, reach_pieces *out)
{
    status st = OK;
    reach_pieces p = {0};
    if (!r->there || r->nvertex == 0) {
        return OK;
    }
    name_fields(r, &p);
    (void)snprintf(p.name[p.npiece], sizeof p.name[0], "%stissue",
                   r->synthetic ? "synthetic " : "");
    TRY(add_wall(r, &p));
    p.npiece++;
    for (int i = 0; i < r->nscope; i++) {
        if (has_bodies(r, &r->scope[i])) {
            (void)snprintf(p.name[p.npiece], sizeof p.name[0], "scope %s", r->scope[i].name);
            TRY(add_bodies(r, &r->scope[i], p.npiece, &p));
            p.npiece++;
        }
    }
    *out = p;
    p = (reach_pieces){0};

done:
    reach_pieces_free(&p);
    return st;
}
