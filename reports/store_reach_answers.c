// reports/store_reach_answers.c
// A scope's answers: numbers as columns over the targets, the bodies and the ways in one after the
// other.
#include "base/memory.h"
#include "reach/way.h"
#include "reports/store_reach.h"

#include <limits.h>
#include <string.h>

enum { MOST_BODY = 100000, MOST_LENGTHS = 1 << 28 };

static status pass_numbers(const passage *p, const char *group, int n, reach_answer *a)
{
#define OF(member) offsetof(reach_answer, member)
    static const column columns[] = {
        {"verdict", COLUMN_INT, VERDICTS, OF(verdict), 0, {0}, REACH_FAILED},
        {"joints", COLUMN_KNOWN, JOINT_UNITS, OF(q), 1, {SCOPE_JOINTS}, 0},
        {"miss_m", COLUMN_KNOWN, "m", OF(miss), 0, {0}, 0},
        {"clearance_m", COLUMN_KNOWN, "m", OF(clearance), 0, {0}, 0},
        {"least_clear_at_m", COLUMN_KNOWN, "m", OF(s), 0, {0}, 0},
        {"bound_m", COLUMN_ANY, "m", OF(bound), 0, {0}, 0},
        {"looks", COLUMN_INT, "-", OF(looks), 0, {0}, INT_MAX},
        {"starts", COLUMN_INT, "-", OF(starts), 0, {0}, INT_MAX},
        {"strain", COLUMN_KNOWN, "-", OF(strain), 0, {0}, 0},
        {"way_clearance_m", COLUMN_ANY, "m", OF(path_clearance), 0, {0}, 0},
    };
#undef OF
    return passage_columns(p, group, COUNT_OF(columns), columns, rows_of(a, n, sizeof *a));
}

// the limit's joint, counted from 1, so that 0 says none
static status pass_joints(const passage *p, const char *group, int n, int njoint, reach_answer *a)
{
    const column c = {"limit_joint", COLUMN_INT, "0 none, 1 insertion, 2 turn ...", 0, 0,
                      {0},           njoint};
    status st = OK;
    int *joint = NULL;
    TRY(TAKE(joint, (size_t)n));
    for (int i = 0; i < n && !p->reading; i++) {
        joint[i] = a[i].joint + 1;
    }
    TRY(passage_columns(p, group, 1, &c, rows_of(joint, n, sizeof *joint)));
    for (int i = 0; i < n && p->reading; i++) {
        a[i].joint = joint[i] - 1;
    }

done:
    free(joint);
    return st;
}

static status pass_reasons(const passage *p, const char *group, int n, reach_answer *a)
{
    status st = OK;
    char(*why)[REACH_TEXT] = NULL;
    TRY(TAKE(why, (size_t)n));
    for (int i = 0; i < n && !p->reading; i++) {
        memcpy(why[i], a[i].why, REACH_TEXT);
    }
    TRY(store_pass_lines(p, group, "why", n, why, sizeof *why));
    for (int i = 0; i < n && p->reading; i++) {
        memcpy(a[i].why, why[i], REACH_TEXT);
    }

done:
    free(why);
    return st;
}

// --- what is of another length for each target ---------------------------------------------------

// All bodies and ways of a scope, one after the other.
typedef struct lengths {
    int *body, *pose, *shown; // [ntarget]
    int nbody, npose, nshown; // together
    double *along, (*point)[3], *room, (*path)[SCOPE_JOINTS], (*way)[REACH_WAY_POINTS][3];
} lengths;

static void lengths_free(lengths *l)
{
    free(l->body);
    free(l->pose);
    free(l->shown);
    free(l->along);
    free(l->point);
    free(l->room);
    free(l->path);
    free(l->way);
}

// the sum of n counts; *sum < 0: beyond all reason
static int sum_of(int n, const int *count)
{
    long long sum = 0;
    for (int i = 0; i < n; i++) {
        sum += count[i];
    }
    return sum <= MOST_LENGTHS ? (int)sum : -1;
}

static status pass_one_length(const passage *p, const char *group, const char *name, int n,
                              int most, int *count, int *sum)
{
    const column c = {name, COLUMN_INT, "-", 0, 0, {0}, most};
    status st = OK;
    TRY(passage_columns(p, group, 1, &c, rows_of(count, n, sizeof *count)));
    *sum = sum_of(n, count);
    if (*sum < 0) {
        TRY(passage_damaged(p, passage_join(group, name).text, "adds up to too many"));
    }

done:
    return st;
}

static status pass_lengths(const passage *p, const char *group, int n, reach_answer *a, lengths *l)
{
    status st = OK;
    TRY(TAKE(l->body, (size_t)n));
    TRY(TAKE(l->pose, (size_t)n));
    TRY(TAKE(l->shown, (size_t)n));
    for (int i = 0; i < n && !p->reading; i++) {
        l->body[i] = a[i].npoint;
        l->pose[i] = a[i].npath;
        l->shown[i] = a[i].nway;
    }
    TRY(pass_one_length(p, group, "body_count", n, MOST_BODY, l->body, &l->nbody));
    TRY(pass_one_length(p, group, "way_count", n, WAY_POSES, l->pose, &l->npose));
    TRY(pass_one_length(p, group, "way_shown_count", n, REACH_WAY_STEPS, l->shown, &l->nshown));
    for (int i = 0; i < n && p->reading; i++) {
        TRY(reach_answer_room(&a[i], l->body[i], l->pose[i]));
        TRY(reach_answer_way(&a[i], l->shown[i]));
    }
    TRY(TAKE(l->along, (size_t)l->nbody));
    TRY(TAKE(l->point, (size_t)l->nbody));
    TRY(TAKE(l->room, (size_t)l->nbody));
    TRY(TAKE(l->path, (size_t)l->npose));
    TRY(TAKE(l->way, (size_t)l->nshown));

done:
    return st;
}

// between an answer and its place among all
static void carry(bool reading, void *one, void *all, size_t size)
{
    if (size > 0) {
        memcpy(reading ? one : all, reading ? all : one, size);
    }
}

static void move_all(bool reading, int n, reach_answer *a, lengths *l)
{
    size_t at = 0, pose = 0, shown = 0;
    for (int i = 0; i < n; i++) {
        const size_t nbody = (size_t)l->body[i], npose = (size_t)l->pose[i];
        const size_t nshown = (size_t)l->shown[i];
        carry(reading, a[i].along, l->along + at, nbody * sizeof *l->along);
        carry(reading, a[i].point, l->point + at, nbody * sizeof *l->point);
        carry(reading, a[i].room, l->room + at, nbody * sizeof *l->room);
        carry(reading, a[i].path, l->path + pose, npose * sizeof *l->path);
        carry(reading, a[i].way, l->way + shown, nshown * sizeof *l->way);
        at += nbody;
        pose += npose;
        shown += nshown;
    }
}

static status pass_bodies(const passage *p, const char *group, int n, reach_answer *a)
{
    static const column along = {"body_s_m", COLUMN_REAL, "m", 0, 0, {0}, 0};
    static const column point = {"body_m", COLUMN_REAL, "m", 0, 1, {3}, 0};
    static const column room = {"body_clearance_m", COLUMN_ANY, "m", 0, 0, {0}, 0};
    static const column path = {"way_joints", COLUMN_REAL, JOINT_UNITS, 0, 1, {SCOPE_JOINTS}, 0};
    static const column way = {"way_body_m", COLUMN_REAL, "m", 0, 2, {REACH_WAY_POINTS, 3}, 0};
    status st = OK;
    lengths l = {0};
    TRY(pass_lengths(p, group, n, a, &l));
    move_all(p->reading, p->reading ? 0 : n, a, &l);
    TRY(passage_columns(p, group, 1, &along, rows_of(l.along, l.nbody, sizeof *l.along)));
    TRY(passage_columns(p, group, 1, &point, rows_of(l.point, l.nbody, sizeof *l.point)));
    TRY(passage_columns(p, group, 1, &room, rows_of(l.room, l.nbody, sizeof *l.room)));
    TRY(passage_columns(p, group, 1, &path, rows_of(l.path, l.npose, sizeof *l.path)));
    TRY(passage_columns(p, group, 1, &way, rows_of(l.way, l.nshown, sizeof *l.way)));
    move_all(p->reading, p->reading ? n : 0, a, &l);

done:
    lengths_free(&l);
    return st;
}

status store_pass_reach_answers(const passage *p, const char *group, int ntarget,
                                reach_scope_result *s)
{
    status st = OK;
    const passage_name inner = passage_join(group, "target");
    TRY(pass_numbers(p, inner.text, ntarget, s->answer));
    TRY(pass_joints(p, inner.text, ntarget, s->njoint, s->answer));
    TRY(pass_reasons(p, inner.text, ntarget, s->answer));
    TRY(pass_bodies(p, inner.text, ntarget, s->answer));

done:
    return st;
}
