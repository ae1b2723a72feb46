// tests/unit/reports/test_reach_result.c
// What is told of a reach study: through the store and back to the last bit, damaged stores are
// refused, JSON says the same numbers.
#include "base/memory.h"
#include "reports/reach_show.h"
#include "reports/result.h"
#include "tests/reach_results.h"
#include "tests/unit/io/scratch.h"

#include <string.h>

static run_result make(bool hostile)
{
    run_result r = {.title = "where scopes reach", .versions = "none"};
    CHECK_OK(memory_take((void **)&r.case_text, 1, 8));
    CHECK_OK(reach_results_make(hostile, true, true, &r.reach));
    return r;
}

// --- the store -----------------------------------------------------------------------------------

#define SAME(n, a, b) CHECK(memcmp((a), (b), (size_t)(n) * sizeof *(a)) == 0)
#define SAME_TEXT(a, b) CHECK(strcmp((a), (b)) == 0)

static void check_answer(const reach_answer *a, const reach_answer *b)
{
    CHECK(a->verdict == b->verdict && a->joint == b->joint);
    CHECK(a->looks == b->looks && a->starts == b->starts);
    SAME(SCOPE_JOINTS, a->q, b->q);
    SAME(1, &a->miss, &b->miss);
    SAME(1, &a->clearance, &b->clearance);
    SAME(1, &a->s, &b->s);
    SAME(1, &a->bound, &b->bound);
    SAME(1, &a->strain, &b->strain);
    SAME(1, &a->path_clearance, &b->path_clearance);
    SAME_TEXT(a->why, b->why);
    const bool alike = a->npoint == b->npoint && a->npath == b->npath && a->nway == b->nway;
    CHECK(alike);
    if (alike && a->npoint > 0) {
        SAME(a->npoint, a->along, b->along);
        SAME(a->npoint, a->point, b->point);
        SAME(a->npoint, a->room, b->room);
    }
    if (alike && a->npath > 0) {
        SAME(a->npath, a->path, b->path);
        SAME(a->nway, a->way, b->way);
    }
}

static void check_scope(const reach_result *r, const reach_scope_result *a,
                        const reach_scope_result *b)
{
    SAME_TEXT(a->name, b->name);
    SAME_TEXT(a->kind, b->kind);
    SAME_TEXT(a->limit_note, b->limit_note);
    CHECK(a->arc == b->arc && a->njoint == b->njoint && a->nreached == b->nreached);
    SAME(SCOPE_JOINTS, a->low, b->low);
    SAME(SCOPE_JOINTS, a->high, b->high);
    SAME(r->nmap, a->state, b->state);
    CHECK(a->length == b->length && a->radius == b->radius && a->spacing == b->spacing);
    CHECK(a->area_reached == b->area_reached && a->area_undecided == b->area_undecided);
    CHECK(a->area_error == b->area_error && a->map_spacing == b->map_spacing);
    CHECK(a->seconds == b->seconds);
    for (int i = 0; i < r->ntarget; i++) {
        check_answer(&a->answer[i], &b->answer[i]);
    }
}

static void check_design(const reach_design_result *a, const reach_design_result *b)
{
    const bool alike = a->nparameter == b->nparameter && a->nrow == b->nrow && b->there;
    CHECK(alike && a->best == b->best && a->goal == b->goal && a->seed == b->seed);
    CHECK(a->start_goal == b->start_goal && a->start_score == b->start_score);
    CHECK(a->evaluations == b->evaluations && a->failed == b->failed && a->islands == b->islands);
    SAME_TEXT(a->scope, b->scope);
    for (int i = 0; alike && i < a->nparameter; i++) {
        SAME_TEXT(a->name[i], b->name[i]);
        SAME_TEXT(a->unit[i], b->unit[i]);
        CHECK(a->lower[i] == b->lower[i] && a->upper[i] == b->upper[i]);
        CHECK(a->start[i] == b->start[i]);
    }
    for (int i = 0; alike && i < a->nrow; i++) {
        const reach_design_row *x = &a->row[i], *y = &b->row[i];
        CHECK(x->goal == y->goal && x->score == y->score);
        CHECK(x->island == y->island && x->evaluation == y->evaluation);
        SAME(a->nparameter, x->value, y->value);
    }
}

static void check_anatomy(const reach_result *a, const reach_result *b)
{
    CHECK(a->nvertex == b->nvertex && a->ntriangle == b->ntriangle);
    SAME(a->nvertex, a->vertex, b->vertex);
    SAME(a->ntriangle, a->triangle, b->triangle);
    CHECK(a->ntarget == b->ntarget && a->nmap == b->nmap);
    SAME(a->ntarget, a->target_name, b->target_name);
    SAME(a->ntarget, a->target, b->target);
    SAME(a->ntarget, a->target_depth, b->target_depth);
    SAME(a->nmap, a->map_point, b->map_point);
    SAME(1, &a->entry, &b->entry);
}

static void the_store_gives_it_back(void)
{
    for (int hostile = 0; hostile < 2; hostile++) {
        run_result r = make(hostile), back = {0};
        const scratch dir = scratch_make();
        const scratch_path path = scratch_file(&dir, "result.hdf");
        CHECK_OK(result_store_write(&r, path.text));
        CHECK_OK(result_store_read(path.text, &back));
        const reach_result *a = &r.reach, *b = &back.reach;
        CHECK(b->there && b->synthetic && b->nscope == a->nscope);
        SAME_TEXT(a->source, b->source);
        SAME_TEXT(a->tissue, b->tissue);
        CHECK(a->area == b->area && a->volume == b->volume && a->entry_free == b->entry_free);
        CHECK(a->tolerance == b->tolerance && a->clearance == b->clearance);
        CHECK(a->resolution == b->resolution && a->map_seed == b->map_seed);
        CHECK(a->tip == b->tip && a->path == b->path && a->paper == b->paper);
        check_anatomy(a, b);
        for (int i = 0; i < a->nscope && i < b->nscope; i++) {
            check_scope(a, &a->scope[i], &b->scope[i]);
        }
        check_design(&a->design, &b->design);
        run_result_free(&back);
        run_result_free(&r);
        scratch_remove(&dir);
    }
}

// a study without a map or a design, and one without targets
static void parts_may_be_missing(void)
{
    for (int kind = 0; kind < 2; kind++) {
        run_result r = {.title = "parts"}, back = {0};
        const scratch dir = scratch_make();
        const scratch_path path = scratch_file(&dir, "result.hdf");
        CHECK_OK(memory_take((void **)&r.case_text, 1, 8));
        if (kind == 0) {
            CHECK_OK(reach_results_make(false, false, false, &r.reach));
        } else {
            CHECK_OK(reach_result_make(&(reach_result){.nscope = 1}, &r.reach));
            r.reach.scope[0].njoint = 3;
            r.reach.scope[0].length = 0.03;
        }
        CHECK_OK(result_store_write(&r, path.text));
        CHECK_OK(result_store_read(path.text, &back));
        CHECK(back.reach.there && !back.reach.design.there && back.reach.nmap == 0);
        CHECK(back.reach.nscope > 0 && back.reach.scope[0].state == NULL);
        CHECK(back.reach.ntarget == r.reach.ntarget);
        run_result_free(&back);
        run_result_free(&r);
        scratch_remove(&dir);
    }
}

// each writes what no run of ours does
static void damage(int kind, reach_result *r)
{
    reach_answer *a = &r->scope[1].answer[2];
    switch (kind) {
    case 0:
        a->verdict = 17;
        break;
    case 1:
        r->triangle[5][1] = r->nvertex;
        break;
    case 2:
        r->vertex[3][0] = NAN;
        break;
    case 3:
        a->joint = 6;
        break;
    case 4:
        r->scope[1].state[7] = 3;
        break;
    case 5:
        r->design.best = r->design.nrow;
        break;
    case 6:
        r->scope[0].njoint = SCOPE_JOINTS + 1;
        break;
    case 7:
        a->point[4][2] = INFINITY;
        break;
    case 8:
        r->scope[2].length = 0;
        break;
    case 9:
        r->design.goal = 2;
        break;
    case 10:
        r->path = 2;
        break;
    case 11:
        r->scope[0].nreached = r->ntarget + 1;
        break;
    case 12:
        a->looks = -1;
        break;
    case 13:
        r->entry.R.a[1][1] = NAN;
        break;
    default:
        r->design.row[1].value[0] = INFINITY;
        break;
    }
}

static void damaged_ones_are_refused(void)
{
    for (int kind = 0; kind < 15; kind++) {
        run_result r = make(false), back = {0};
        const scratch dir = scratch_make();
        const scratch_path path = scratch_file(&dir, "result.hdf");
        damage(kind, &r.reach);
        CHECK_OK(result_store_write(&r, path.text));
        const status st = result_store_read(path.text, &back);
        if (st != ERR_FILE || !strstr(status_message(), "damaged: 'reach/")) {
            printf("damage %d: %s\n", kind, status_message());
        }
        CHECK(st == ERR_FILE && strstr(status_message(), "damaged: 'reach/") != NULL);
        status_clear();
        run_result_free(&back);
        run_result_free(&r);
        scratch_remove(&dir);
    }
}

// --- JSON ----------------------------------------------------------------------------------------

static void write_document(const run_result *r, char **text)
{
    size_t size = 0;
    json *j = NULL;
    FILE *stream = open_memstream(text, &size);
    CHECK_OK(json_open(stream, &j));
    CHECK_OK(result_json_run(j, r));
    CHECK_OK(json_close(j)); // refuses an unbalanced document
    (void)fclose(stream);
}

// what stands behind the next such key; NULL: there is none
static const char *next_value(const char *text, const char *key)
{
    char quoted[64];
    (void)snprintf(quoted, sizeof quoted, "\"%s\":", key);
    const char *at = text ? strstr(text, quoted) : NULL;
    return at ? at + strlen(quoted) + strspn(at + strlen(quoted), " \n") : NULL;
}

static void check_number(const char *at, double wanted)
{
    const bool same =
        at && (isfinite(wanted) ? strtod(at, NULL) == wanted : strncmp(at, "null", 4) == 0);
    CHECK(same);
    if (!same) {
        printf("%.40s is not %.17g\n", at ? at : "nothing", wanted);
    }
}

static void check_pose(const char *at, const reach_scope_result *s, const reach_answer *a)
{
    check_number(next_value(at, "insertion_m"), a->q[0]);
    check_number(next_value(at, "turn_rad"), a->q[1]);
    const char *bend = next_value(at, s->arc ? "bend_rad" : "tensions_N");
    check_number(bend ? bend + strspn(bend, "[ ") : NULL, a->q[2]);
}

static void json_says_the_same(void)
{
    static const char *const verdicts[] = {"\"reached\"",   "\"out_of_reach\"", "\"joint_limit\"",
                                           "\"collision\"", "\"no_way_in\"",    "\"failed\""};
    run_result r = make(true);
    char *text = NULL;
    write_document(&r, &text);
    const char *at = strstr(text, "stiffaxis/reach/1");
    CHECK(at != NULL && strncmp(next_value(at, "synthetic"), "true", 4) == 0);
    at = next_value(at, "scopes");
    for (int i = 0; at && i < r.reach.nscope; i++) {
        const reach_scope_result *s = &r.reach.scope[i];
        check_number(next_value(at, "reached"), s->nreached);
        check_number(next_value(at, "area_reached_share"), s->area_reached);
        at = next_value(at, "answers");
        for (int k = 0; at && k < r.reach.ntarget; k++) {
            const reach_answer *a = &s->answer[k];
            at = next_value(at, "verdict");
            CHECK(at && strncmp(at, verdicts[a->verdict], strlen(verdicts[a->verdict])) == 0);
            if (a->verdict != REACH_FAILED) {
                check_pose(at, s, a);
            }
            check_number(next_value(at, "miss_m"), a->miss);
            check_number(next_value(at, "clearance_m"), a->clearance);
            check_number(next_value(at, "clearance_bound_m"), a->bound);
        }
    }
    CHECK(strstr(text, "as_printed_in_the_paper") != NULL);
    CHECK(strstr(text, "</script><script>alert(1)</script>") != NULL); // text it stays
    CHECK(strstr(text, "a \\\"b\\\" & c") != NULL);
    check_number(next_value(next_value(text, "design"), "best"),
                 r.reach.design.row[r.reach.design.best].value[0]);
    free(text);
    run_result_free(&r);
}

// --- words ---------------------------------------------------------------------------------------

static void not_reached_says_how_thorough(void)
{
    reach_result r = {.resolution = 5e-5};
    const reach_scope_result one = {.njoint = 3, .spacing = 2e-4}, two = {.njoint = 4};
    reach_answer a = {.verdict = REACH_COLLISION, .bound = -3e-4, .looks = 9};
    char words[REACH_WORDS];
    CHECK(reach_is_proved(&r, &one, &a));
    r.clearance = -4e-4; // so much in the wall is asked for
    CHECK(!reach_is_proved(&r, &one, &a));
    r.clearance = 0;
    CHECK(strstr(reach_search_words(&r, &one, &a, words, sizeof words), "proved: ") == words);
    CHECK(strstr(words, "-0.3 mm") != NULL);
    a.bound = 1e-4;
    CHECK(!reach_is_proved(&r, &one, &a));
    CHECK(strstr(reach_search_words(&r, &one, &a, words, sizeof words), "9 looks") != NULL);
    a.bound = INFINITY;
    CHECK(strstr(reach_search_words(&r, &two, &a, words, sizeof words), "not proved") != NULL);
    a.verdict = REACH_OUT_OF_REACH;
    CHECK(strstr(reach_search_words(&r, &one, &a, words, sizeof words), "0.2 mm apart") != NULL);
    CHECK(strstr(words, "by cubics") != NULL && !reach_is_proved(&r, &one, &a));
    a.verdict = REACH_NO_WAY;
    CHECK(strstr(reach_search_words(&r, &one, &a, words, sizeof words), "not proved") != NULL);
    a.verdict = REACH_REACHED;
    CHECK(reach_search_words(&r, &one, &a, words, sizeof words)[0] == '\0');
    // an arc's tip is known: proved where no bend between those looked at can be near
    const reach_scope_result arc = {.njoint = 3, .spacing = 2e-4, .arc = true};
    a.verdict = REACH_OUT_OF_REACH;
    r.tolerance = 1e-3;
    a.miss = 1.4e-3;
    CHECK(reach_is_proved(&r, &arc, &a));
    CHECK(strstr(reach_search_words(&r, &arc, &a, words, sizeof words), "proved: ") == words);
    CHECK(strstr(words, "cubics") == NULL && strstr(words, "closed form") != NULL);
    a.miss = 1.2e-3;
    CHECK(!reach_is_proved(&r, &arc, &a));
    CHECK(strstr(reach_search_words(&r, &arc, &a, words, sizeof words), "proved") == NULL);
    a.verdict = REACH_JOINT_LIMIT;
    a.miss = 2e-3;
    a.joint = -1; // a strain
    CHECK(!reach_is_proved(&r, &arc, &a));
    // tendons whose tension is one are no joints
    const reach_scope_result held = {.njoint = 4, .low = {0, 0, 0, 1}, .high = {1, 1, 1, 1}};
    const reach_scope_result moved = {.njoint = 4, .low = {0, 0, 0, 1}, .high = {1, 1, 1, 2}};
    CHECK(reach_one_bend(&held) && !reach_one_bend(&moved));
}

static void a_collision_that_is_open_is_told_so(void)
{
    const reach_scope_result s = {.njoint = 3};
    reach_result r = {.clearance = 1e-3};
    reach_answer a = {.verdict = REACH_COLLISION, .bound = 1.2e-3};
    CHECK(reach_is_open(&r, &s, &a));
    CHECK(strcmp(reach_told_words(&r, &s, &a), "collision, not proved") == 0);
    a.bound = 0.9e-3;
    CHECK(strcmp(reach_told_words(&r, &s, &a), "collision") == 0);
    a.verdict = REACH_REACHED;
    CHECK(strcmp(reach_told_words(&r, &s, &a), "reached") == 0);
}

int main(void)
{
    the_store_gives_it_back();
    parts_may_be_missing();
    damaged_ones_are_refused();
    json_says_the_same();
    not_reached_says_how_thorough();
    a_collision_that_is_open_is_told_so();
    return test_failures != 0;
}
