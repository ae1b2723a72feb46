// reports/json_reach.c
// The document of a reach study. The wall's triangles and the map's samples are not in it: they
// stand in result.hdf and reach_map.csv.
#include "reach/reach_case.h"
#include "reports/json_parts.h"
#include "reports/reach_show.h"

#include <math.h>

static const char *const verdict_names[] = {"reached",   "out_of_reach", "joint_limit",
                                            "collision", "no_way_in",    "failed"};

static void write_pose(json *j, const reach_scope_result *s, const reach_answer *a)
{
    const int n = s->njoint;
    json_real(j, "insertion_m", a->q[SCOPE_INSERTION]);
    json_real(j, "turn_rad", a->q[SCOPE_TURN]);
    if (s->arc) {
        json_real(j, "bend_rad", a->q[SCOPE_BEND]);
    } else {
        json_reals(j, "tensions_N", n - SCOPE_BEND, a->q + SCOPE_BEND);
    }
}

static void write_body(json *j, const reach_answer *a)
{
    json_object(j, "body");
    json_reals(j, "s_m", a->npoint, a->along);
    json_reals(j, "clearance_m", a->npoint, a->room);
    json_array(j, "p_m");
    for (int i = 0; i < a->npoint; i++) {
        json_reals(j, NULL, 3, a->point[i]);
    }
    json_array_end(j);
    json_object_end(j);
}

static void write_way(json *j, const reach_scope_result *s, const reach_answer *a)
{
    json_object(j, "way_in");
    json_real(j, "clearance_m", a->path_clearance);
    json_array(j, "joints");
    for (int i = 0; i < a->npath; i++) {
        json_reals(j, NULL, s->njoint, a->path[i]);
    }
    json_array_end(j);
    json_object_end(j);
}

static void write_answer(json *j, const reach_result *r, const reach_scope_result *s, int target)
{
    const reach_answer *a = &s->answer[target];
    const bool pose = a->verdict != REACH_FAILED;
    char words[REACH_WORDS];
    json_object(j, NULL);
    json_text(j, "target", r->target_name[target]);
    json_text(j, "verdict", verdict_names[a->verdict]);
    json_text(j, "why", a->why);
    json_text(j, "thoroughness", reach_search_words(r, s, a, words, sizeof words));
    json_flag(j, "proved", reach_is_proved(r, s, a));
    if (pose) {
        json_object(j, "pose");
        write_pose(j, s, a);
        json_object_end(j);
    } else {
        json_null(j, "pose");
    }
    json_real(j, "miss_m", pose ? a->miss : NAN);
    json_real(j, "clearance_m", a->clearance);
    json_real(j, "least_clear_at_s_m", a->s);
    json_real(j, "clearance_bound_m", a->bound);
    json_text(j, "limit_joint",
              a->joint >= 0 ? reach_joint_words(s, a->joint, words, sizeof words) : NULL);
    json_real(j, "strain", a->strain);
    json_integer(j, "looks", a->looks);
    json_integer(j, "starts", a->starts);
    write_way(j, s, a);
    write_body(j, a);
    json_object_end(j);
}

static void write_map(json *j, const reach_result *r, const reach_scope_result *s)
{
    if (!s->state) {
        json_null(j, "map");
        return;
    }
    json_object(j, "map");
    json_integer(j, "samples", r->nmap);
    json_real(j, "area_reached_share", s->area_reached);
    json_real(j, "area_undecided_share", s->area_undecided);
    json_real(j, "standard_error_share", s->area_error);
    json_real(j, "spacing_m", s->map_spacing);
    json_object_end(j);
}

static void write_scope(json *j, const reach_result *r, const reach_scope_result *s)
{
    json_object(j, NULL);
    json_text(j, "name", s->name);
    json_text(j, "kind", s->kind);
    json_real(j, "length_m", s->length);
    json_real(j, "radius_m", s->radius);
    json_array(j, "joints");
    for (int i = 0; i < s->njoint; i++) {
        char name[REACH_NAME];
        json_object(j, NULL);
        json_text(j, "name", reach_joint_words(s, i, name, sizeof name));
        json_text(j, "unit", reach_joint_unit(s, i));
        json_real(j, "low", s->low[i]);
        json_real(j, "high", s->high[i]);
        json_object_end(j);
    }
    json_array_end(j);
    json_text(j, "limit_note", s->limit_note);
    json_real(j, "pose_spacing_m", s->spacing);
    json_real(j, "cpu_s", s->seconds);
    json_integer(j, "reached", s->nreached);
    json_integer(j, "targets", r->ntarget);
    write_map(j, r, s);
    json_array(j, "answers");
    for (int i = 0; i < r->ntarget; i++) {
        write_answer(j, r, s, i);
    }
    json_array_end(j);
    json_object_end(j);
}

static void write_targets(json *j, const reach_result *r)
{
    json_array(j, "targets");
    for (int i = 0; i < r->ntarget; i++) {
        json_object(j, NULL);
        json_text(j, "name", r->target_name[i]);
        json_reals(j, "p_m", 3, r->target[i]);
        json_real(j, "depth_m", r->target_depth[i]);
        json_object_end(j);
    }
    json_array_end(j);
}

static void write_paper(json *j, const reach_result *r)
{
    if (r->paper == REACH_PAPER_NONE) {
        json_null(j, "as_printed_in_the_paper");
        return;
    }
    json_object(j, "as_printed_in_the_paper");
    json_text(j, "anatomy", "a patient's, not published");
    json_integer(j, "targets", PAPER_REACH_TARGETS);
    json_integer(j, "constant_curvature_reached", PAPER_REACH_CONSTANT_CURVATURE);
    json_integer(j, "helical_reached", PAPER_REACH_HELICAL);
    json_object_end(j);
}

static void write_design_row(json *j, const reach_design_result *d, int i)
{
    const reach_design_row *row = &d->row[i];
    json_object(j, NULL);
    json_flag(j, "best", i == d->best);
    json_integer(j, "island", row->island + 1);
    json_integer(j, "evaluation", row->evaluation);
    json_real(j, "goal", row->goal);
    json_real(j, "score", row->score);
    json_reals(j, "values", d->nparameter, row->value);
    json_object_end(j);
}

static void write_design(json *j, const reach_design_result *d)
{
    json_object(j, "design");
    json_text(j, "scope", d->scope);
    json_text(j, "maximise", d->goal == DESIGN_AREA ? "area" : "targets");
    json_array(j, "parameters");
    for (int i = 0; i < d->nparameter; i++) {
        json_object(j, NULL);
        json_text(j, "name", d->name[i]);
        json_text(j, "unit", d->unit[i][0] ? d->unit[i] : "1");
        json_real(j, "lower", d->lower[i]);
        json_real(j, "upper", d->upper[i]);
        json_real(j, "start", d->start[i]);
        json_real(j, "best", d->nrow > 0 ? d->row[d->best].value[i] : NAN);
        json_object_end(j);
    }
    json_array_end(j);
    json_real(j, "start_goal", d->start_goal);
    json_real(j, "start_score", d->start_score);
    json_integer(j, "evaluations", d->evaluations);
    json_integer(j, "failed", d->failed);
    json_integer(j, "islands", d->islands);
    json_integer(j, "seed", d->seed);
    json_array(j, "improvements");
    for (int i = 0; i < d->nrow; i++) {
        write_design_row(j, d, i);
    }
    json_array_end(j);
    json_object_end(j);
}

static void write_tissue(json *j, const reach_result *r)
{
    json_object(j, "tissue");
    json_text(j, "file", r->tissue);
    json_integer(j, "triangles", r->ntriangle);
    json_real(j, "area_m2", r->area);
    json_real(j, "volume_m3", r->volume);
    json_object_end(j);
    json_object(j, "entry");
    json_reals(j, "p_m", 3, r->entry.p.a);
    json_reals(j, "direction", 3,
               (const double[]){r->entry.R.a[0][2], r->entry.R.a[1][2], r->entry.R.a[2][2]});
    json_real(j, "free_m", r->entry_free);
    json_object_end(j);
}

status result_json_reach(json *j, const char *key, const run_result *run)
{
    const reach_result *r = &run->reach;
    json_begin(j, key, "stiffaxis/reach/1", run);
    json_flag(j, "synthetic", r->synthetic);
    json_text(j, "source", r->source);
    write_tissue(j, r);
    json_real(j, "tolerance_m", r->tolerance);
    json_real(j, "clearance_m", r->clearance);
    json_real(j, "resolution_m", r->resolution);
    json_text(j, "tip", r->tip == REACH_TIP_SKIN ? "skin" : "centre");
    json_text(j, "checked", r->path == REACH_INSERTION ? "insertion" : "final_pose");
    write_paper(j, r);
    write_targets(j, r);
    json_array(j, "scopes");
    for (int i = 0; i < r->nscope; i++) {
        write_scope(j, r, &r->scope[i]);
    }
    json_array_end(j);
    if (r->design.there) {
        write_design(j, &r->design);
    }
    json_object_end(j);
    return OK;
}
