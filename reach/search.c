// reach/search.c
#include "reach/search_inside.h"

search_options search_options_default(void)
{
    return (search_options){
        .tolerance = 1e-3,  // the paper's
        .resolution = 5e-5, // well under what a printed scope's radius is good for
        .most_looks = 30000,
    };
}

double room_roughly(const room_probe *room, scope_state *state, const double *q,
                    const clearance_wish *wish, double *s)
{
    return room->roughly ? room->roughly(room->context, state, q, wish, s)
                         : room->at(room->context, state, q, s);
}

status search_look(search *s, const inverse_pose *pose, clearance_wish *wish, double *room)
{
    status st = OK;
    const bool near = pose->miss <= s->options->tolerance;
    clearance_wish w = *wish;
    w.below = near ? fmin(w.below, s->out->room) : w.below;
    TRY(scope_bend(s->state, pose->q));
    *room = room_roughly(s->room, s->state, pose->q, &w, &wish->first);
    s->out->looks++;
    if (near && *room > s->out->room) {
        double at = NAN;
        *room = s->room->at(s->room->context, s->state, pose->q, &at);
        if (*room > s->out->room) {
            s->out->pose = *pose;
            s->out->room = *room;
            s->out->s = at;
        }
    }

done:
    return st;
}

// the tip does not come near, or nothing that was looked at had any room to speak of
static void too_far(const inverse_answer *poses, search_answer *out)
{
    out->pose = poses->nearest;
    out->room = out->s = NAN;
    out->joint = poses->limit >= 0 ? poses->limit : -1;
    out->verdict = out->joint >= 0 ? SEARCH_JOINT_LIMIT : SEARCH_OUT_OF_REACH;
}

status search_solve(const inverse *inv, scope_state *state, vec3 target, const room_probe *room,
                    const search_options *options, search_answer *out)
{
    status st = OK;
    inverse_answer poses;
    search s = {inv, state, target, room, options, out};
    *out = (search_answer){.room = -INFINITY, .s = NAN, .bound = INFINITY, .joint = -1};
    if (!(options->tolerance > 0) || !(options->resolution > 0) || options->most_looks < 1) {
        return status_fail(ERR_INPUT, "reach: a tolerance of %g m and a resolution of %g m",
                           options->tolerance, options->resolution);
    }
    TRY(inverse_solve(inv, state, target, &poses));
    out->starts = poses.starts;
    if (poses.npose == 0 && poses.nearest.miss > options->tolerance) {
        too_far(&poses, out);
        return OK;
    }
    if (poses.npose == 0) {
        poses.pose[poses.npose++] = poses.nearest;
    }
    for (int i = 0; i < poses.npose; i++) {
        double here;
        clearance_wish any = {.below = -INFINITY, .tolerance = options->resolution};
        TRY(search_look(&s, &poses.pose[i], &any, &here));
    }
    TRY(inv->scope->njoint == SCOPE_BEND + 1 ? search_boxes(&s) : search_starts(&s));
    out->verdict = out->room >= 0 ? SEARCH_REACHED : SEARCH_COLLISION;

done:
    return st;
}
