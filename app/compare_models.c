// app/compare_models.c
// What each assumption about the section costs a rod, against the 3D segment: docs/theory.md (5.19)
#include "app/beam_models.h"
#include "app/compare_rows.h"
#include "app/segment_source.h"
#include "section/follow.h"

#include <math.h>
#include <string.h>

// The two lengths differ by so many radii or more, or the ends of a short segment meet.
static const double SHORTEST_STEP = 4;
// A second segment longer than this, over the first, costs more than it tells.
static const double LONGEST_SECOND = 4;

// What the law by two lengths misses because the ends of the first one meet: 5e-3 in torsion at 5
// radii between free ends, 3e-4 between held ones, 7e-5 at 10 radii. Shorter ones are all ends.
static const double ENDS_MEET = 0.05, ENDS_DIE = 2.5, SHORTEST_RADII = 4;
static const double SHARE_MOST = 5e-3; // of a mesh too coarse to tell

static const double PI = 3.14159265358979323846;

// Entries that no end enters: what the ends take of stretch, bending and twist does not depend on
// the length. A force along x or y bends the base more, the longer the segment.
static bool is_free_of_ends(int i)
{
    return i >= NZ;
}

// the largest of |A - B|_ij / sqrt(B_ii B_jj) over all entries or those free of the ends, and where
static double largest_miss(const mat6 *A, const mat6 *B, bool law, int *row, int *column)
{
    double most = -1;
    for (int i = law ? NZ : NX; i < 6; i++) {
        for (int j = i; j < 6; j++) {
            const double miss = fabs(A->a[i][j] - B->a[i][j]) / sqrt(B->a[i][i] * B->a[j][j]);
            if (!(miss <= most)) {
                most = miss;
                *row = i;
                *column = j;
            }
        }
    }
    return most;
}

static mat6 per_length(mat6 longer, mat6 shorter, double step)
{
    mat6 F = mat6_scale(1 / step, mat6_add(longer, mat6_scale(-1, shorter)));
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            F.a[i][j] = is_free_of_ends(i) && is_free_of_ends(j) ? F.a[i][j] : NAN;
        }
    }
    return F;
}

// --- the second length: twice the first where nothing changes, whole turns more where the section
// only turns, so that the tip's end is the same

static double second_length(const case_data *c, const compare_section *section, model_checks *out)
{
    const segment_case *fem = &c->file.fem;
    section_course course = {.constant = true};
    if (fem->course == COURSE_ALONG) {
        const status st = section_course_between(&c->file.section, c->materials, fem->section_at,
                                                 fem->section_at + fem->length, &course);
        if (st != OK) {
            status_clear();
            course = (section_course){0};
        }
    }
    const double least = SHORTEST_STEP * section->radius;
    if (course.constant) {
        return fem->length + fmax(fem->length, least);
    }
    if (!course.turns_only) {
        (void)snprintf(out->why_no_second, sizeof out->why_no_second,
                       "the section changes along the segment, so that its tip's end does with "
                       "the length");
        return 0;
    }
    const double turn = 2 * PI / fabs(course.turn_rate);
    const double second = fem->length + turn * ceil(least / turn);
    if (second > LONGEST_SECOND * fem->length) {
        (void)snprintf(out->why_no_second, sizeof out->why_no_second,
                       "a whole turn more is %.3g mm", 1e3 * (second - fem->length));
        return 0;
    }
    return second;
}

// the tip compliance of the same segment, that much longer
static status second_compliance(const case_data *c, double length, mat6 *out)
{
    status st = OK;
    static const double centre[1][2] = {{0, 0}};
    segment_load unit = {.name = "unit", .force = {0, 0, 1}, .at_kind = -1};
    case_data other = *c;
    segment_source source = {0};
    segment_result r = {0};
    segment_case *fem = &other.file.fem;
    fem->length = length;
    fem->layers = 0; // as many as that length takes
    fem->stress = false;
    fem->loads = (key_list){.count = 1, .items = &unit};
    if (fem->tip != TIP_RIGID) {
        fem->tip = TIP_E_PROPORTIONAL; // whose compliance it is with the others too
    }
    TRY(segment_source_make(&other, &source));
    TRY(segment_solve(fem, &source, centre, 0, &r));
    *out = r.tip_compliance;

done:
    segment_result_free(&r);
    segment_source_free(&source);
    return st;
}

// --- what does not apply

static const char *why_not(const case_data *c)
{
    const segment_case *fem = &c->file.fem;
    const bool rests = fem->course == COURSE_ALONG && mark_given(c->file.rod.rest.at);
    if (fem->base == BASE_FREE || fem->springs.count > 0 || fem->holds.count > 0 ||
        mark_given(fem->tip_spring.at)) {
        return "more than its base holds the segment";
    }
    if (section_own_length(&c->file.section) > 0 && fem->course == COURSE_ALONG) {
        return "a stack's segment is made of its voxels, the sections' models are not";
    }
    return rests ? "the rod is not straight at rest" : NULL;
}

// --- rows

// the law that knows everything against two lengths of 3D: nothing but meshes is left
static void judge_law(const compare_section *section, const model_checks *checks, run_result *r)
{
    const model_check *m = &checks->model[BEAM_TURNING];
    compare_row *row = compare_add(
        r, "-", "section: stretch, bending, twist of the law, ours (full) against two 3D lengths");
    const double radii = checks->lengths[0] / section->radius;
    if (checks->why_no_second[0]) {
        compare_skip(row, "%s", checks->why_no_second);
        return;
    }
    if (section->contrast > COMPARE_MOST_CONTRAST || radii < SHORTEST_RADII) {
        compare_skip(row, "%.2g apart; no verdict: the ends reach each other", m->law_error);
        return;
    }
    // errors of both lengths stand in their difference
    const double share = (checks->lengths[1] + checks->lengths[0]) /
                         (checks->lengths[1] - checks->lengths[0]) * r->segment.relative_error;
    compare_judge(row, m->law_error, 0, m->law_error,
                  (tolerance){ENDS_MEET * exp(-radii / ENDS_DIE) + fmin(share, SHARE_MOST) +
                                  compare_section_share(section),
                              "where ends meet; estimates of 3D (both lengths) and section"});
}

static void check_model(const beam_models *models, int i, const model_checks *checks,
                        model_check *out)
{
    mat6 longer;
    (void)snprintf(out->name, sizeof out->name, "%s", beam_model_name(i));
    (void)snprintf(out->why, sizeof out->why, "%s", models->why[i]);
    out->law_error = NAN;
    if (out->why[0]) {
        return;
    }
    if (beam_models_compliance(models, i, checks->lengths[0], &out->compliance) != OK) {
        (void)snprintf(out->why, sizeof out->why, "%.150s", status_message());
        status_clear();
        return;
    }
    out->error =
        largest_miss(&out->compliance, &checks->compliance, false, &out->row, &out->column);
    if (checks->lengths[1] > 0 &&
        beam_models_compliance(models, i, checks->lengths[1], &longer) == OK) {
        const mat6 F = per_length(longer, out->compliance, checks->lengths[1] - checks->lengths[0]);
        out->law_error =
            largest_miss(&F, &checks->law_difference, true, &out->law_row, &out->law_column);
    }
    status_clear();
}

status compare_models(const case_data *c, const compare_section *section, run_result *r)
{
    status st = OK;
    beam_models models = {0};
    mat6 longer;
    model_checks *checks = &r->models;
    const char *why = why_not(c);
    if (why) {
        compare_skip(compare_add(r, "-", "tip compliance by the models of the section"), "%s", why);
        return OK;
    }
    checks->lengths[0] = c->file.fem.length;
    checks->compliance = r->segment.tip_compliance;
    checks->lengths[1] = second_length(c, section, checks);
    TRY(beam_models_make(c, fmax(checks->lengths[0], checks->lengths[1]), &models));
    if (checks->lengths[1] > 0) {
        TRY(second_compliance(c, checks->lengths[1], &longer));
        checks->law_difference =
            per_length(longer, r->segment.tip_compliance, checks->lengths[1] - checks->lengths[0]);
    }
    for (int i = 0; i < BEAM_MODELS; i++) {
        check_model(&models, i, checks, &checks->model[i]);
    }
    judge_law(section, checks, r);
    checks->there = true;

done:
    beam_models_free(&models);
    return st;
}
