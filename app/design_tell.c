// app/design_tell.c
#include "app/design_tell.h"

#include "app/design_case.h"
#include "app/fit_files.h"
#include "base/memory.h"
#include "reports/markup.h"

#include <math.h>
#include <string.h>

// --- rows

// whether the trial is the best of its island up to there
static bool improves(const design_answer *a, int i)
{
    const design_trial *t = &a->trial[i];
    if (t->evaluation == 0 || isnan(t->score)) {
        return false;
    }
    for (int k = i - t->evaluation + 1; k < i; k++) {
        if (a->trial[k].score >= t->score) {
            return false;
        }
    }
    return true;
}

static void tell_parameters(const case_data *c, reach_design_result *out)
{
    for (int i = 0; i < out->nparameter; i++) {
        const design_parameter_case *p = case_design_parameter(c, i);
        (void)snprintf(out->name[i], sizeof out->name[i], "%s", p->name);
        (void)snprintf(out->unit[i], sizeof out->unit[i], "%s", p->unit ? p->unit : "");
        out->lower[i] = p->lower;
        out->upper[i] = p->upper;
        out->start[i] = p->start;
    }
}

status design_tell(const case_data *c, const design_answer *a, reach_design_result *out)
{
    status st = OK;
    const design_case *d = &c->file.reach.design;
    int n = 0;
    for (int i = 0; i < a->islands * a->evaluations; i++) {
        n += improves(a, i);
    }
    TRY(reach_design_make(d->parameters.count, n, out));
    tell_parameters(c, out);
    (void)snprintf(out->scope, sizeof out->scope, "%s", d->scope.text);
    out->goal = d->goal;
    out->islands = a->islands;
    out->seed = d->seed;
    out->evaluations = a->done;
    out->failed = a->failed;
    out->start_goal = a->trial[0].goal; // the first island begins with it
    out->start_score = a->trial[0].score;
    n = 0;
    for (int i = 0; i < a->islands * a->evaluations; i++) {
        if (!improves(a, i)) {
            continue;
        }
        const design_trial *t = &a->trial[i];
        reach_design_row *row = &out->row[n];
        memcpy(row->value, t->x, (size_t)out->nparameter * sizeof *row->value);
        row->goal = t->goal;
        row->score = t->score;
        row->island = t->island;
        row->evaluation = t->evaluation;
        out->best = i == a->best ? n : out->best;
        n++;
    }

done:
    return st;
}

// --- the case file

static const char headline[] = "# designed: ";

// "17", or "4.31 % of the area"
static void goal_words(const reach_design_result *d, double goal, char *words, size_t room)
{
    (void)snprintf(words, room, d->goal == DESIGN_TARGETS ? "%.0f targets" : "%.4g %% of the area",
                   d->goal == DESIGN_TARGETS ? goal : 100 * goal);
}

static void write_headline(const case_data *c, const reach_design_result *d, const double *x,
                           bool whole, char *line, size_t room)
{
    char from[40], to[40];
    const reach_design_row *best = &d->row[d->best];
    goal_words(d, d->start_goal, from, sizeof from);
    goal_words(d, best->goal, to, sizeof to);
    size_t n = (size_t)snprintf(line, room, "%sscope %.60s reaches %s%s, at first %s;", headline,
                                d->scope, to, c->file.reach.synthetic ? " (synthetic)" : "",
                                isnan(d->start_goal) ? "nothing" : from);
    for (int i = 0; i < d->nparameter && n < room; i++) {
        n += (size_t)snprintf(line + n, room - n, "%s %.40s = %.6g%s%.20s", i ? "," : "",
                              d->name[i], x[i], d->unit[i][0] ? " " : "", d->unit[i]);
    }
    if (n < room) {
        n += (size_t)snprintf(line + n, room - n, "; %d designs, seed %d%s", d->evaluations,
                              d->seed, whole ? "" : "; NOT ALL IN FORCE: see the end of the case");
    }
    (void)utf8_clean(line, line, room); // a name may hold what would end the comment
}

status design_case_text(const case_data *c, const reach_design_result *d, const double *x,
                        char **out)
{
    status st = OK;
    settings s = {0};
    char *text = NULL, *moved = NULL, line[2048];
    size_t length = 0, moved_length = 0;
    int nleft = 0, moved_left = 0;
    TRY(design_case_settings(c, x, &s));
    TRY(config_rewrite(c->config, s.count, (const char *const *)s.text, &text, &length, &nleft));
    // whole paths where all of them have a place
    TRY(fit_files(c, &s));
    TRY(config_rewrite(c->config, s.count, (const char *const *)s.text, &moved, &moved_length,
                       &moved_left));
    const bool move = moved_left == nleft;
    const char *from = move ? moved : text;
    length = move ? moved_length : length;
    const char *first = memchr(from, '\n', length);
    if (length >= sizeof headline && first && strncmp(from, headline, sizeof headline - 1) == 0) {
        length -= (size_t)(first + 1 - from); // of the search before this one
        from = first + 1;
    }
    write_headline(c, d, x, nleft == 0, line, sizeof line);
    const size_t before = strlen(line);
    TRY(TAKE(*out, before + length + 2));
    memcpy(*out, line, before);
    (*out)[before] = '\n';
    memcpy(*out + before + 1, from, length);

done:
    free(moved);
    free(text);
    settings_free(&s);
    return st;
}
