// app/design_run.c
// The design whose scope reaches most, then what it and the case's own scopes reach.
#include "app/chain.h"
#include "app/design_case.h"
#include "app/design_score.h"
#include "app/design_tell.h"
#include "base/memory.h"
#include "reach/reach_map.h"

#include <math.h>
#include <string.h>

// of misses and depths that count as short, in tolerances of the tip
static const double SHORT = 10;
// of the surface, at most: the share's standard error is then 2 %, and a look at a design is short
enum { MAP_POINTS = 500 };

typedef struct designing {
    const command *cmd;
    const case_data *c;
    reach_scene scene;
    variation base;
    design_scoring scoring;
    double lower[DESIGN_MOST], upper[DESIGN_MOST], start[DESIGN_MOST];
    char log[4096];
    hash problem;
} designing;

static status heard(void *context, const design_news *news)
{
    const designing *d = context;
    const bool area = d->c->file.reach.design.goal == DESIGN_AREA;
    char words[160];
    size_t n = (size_t)snprintf(words, sizeof words, "design: %d of %d", news->done, news->total);
    if (news->failed > 0) {
        n += (size_t)snprintf(words + n, sizeof words - n, ", %d without answer", news->failed);
    }
    if (!isnan(news->score)) {
        (void)snprintf(words + n, sizeof words - n,
                       area ? ", best %.4g %% of the area" : ", best %.0f targets (score %.4f)",
                       area ? 100 * news->goal : news->goal, news->score);
    }
    command_progress(d->cmd, words);
    return OK;
}

// --- the problem

// what the score depends on: the case but for how long is searched, tissue and targets
static hash fingerprint(const designing *d, const reach_scope *start)
{
    size_t length = 0;
    hash h = hash_begin();
    const surface *s = &d->scene.tissue;
    const char *text = config_text(d->c->config, &length);
    hash_text(&h, STIFFAXIS_VERSION);
    hash_bytes(&h, text, length);
    if (start->other.config) {
        text = config_text(start->other.config, &length);
        hash_bytes(&h, text, length);
    }
    for (int i = 0; i < d->cmd->noverride; i++) {
        const char *o = d->cmd->overrides[i];
        const bool search = strncmp(o, "reach.design.islands=", 21) == 0 ||
                            strncmp(o, "reach.design.evaluations=", 25) == 0 ||
                            strncmp(o, "reach.design.seed=", 18) == 0;
        if (!search) {
            hash_text(&h, o);
        }
    }
    hash_bytes(&h, s->vertex, (size_t)s->nvertex * sizeof *s->vertex);
    hash_bytes(&h, s->triangle, (size_t)s->ntriangle * sizeof *s->triangle);
    hash_bytes(&h, d->scene.target, (size_t)d->scene.ntarget * sizeof *d->scene.target);
    return h;
}

// beside the results, which are written at the end
static status name_log(designing *d)
{
    const char *out = d->cmd->out;
    size_t length = out ? strlen(out) : 0;
    while (length > 1 && out[length - 1] == '/') {
        length--;
    }
    const int n = snprintf(d->log, sizeof d->log, "%.*s.design-log", (int)length, out ? out : "");
    if (n >= (int)sizeof d->log) {
        return status_fail(ERR_INPUT, "--out: the name is too long");
    }
    return OK;
}

static status take_samples(designing *d)
{
    status st = OK;
    const reach_case *r = &d->c->file.reach;
    const int n = r->map.points < MAP_POINTS ? r->map.points : MAP_POINTS;
    if (r->design.goal != DESIGN_AREA) {
        return OK;
    }
    TRY(TAKE(d->scoring.map, (size_t)n));
    TRY(surface_samples(&d->scene.tissue, n, r->map.seed, d->scoring.map));
    d->scoring.nmap = n;

done:
    return st;
}

static status open_all(designing *d)
{
    status st = OK;
    const case_data *c = d->c;
    const design_case *dc = &c->file.reach.design;
    settings s = {0};
    reach_scope start = {0};
    command_progress(d->cmd, "tissue and targets");
    TRY(reach_scene_open(c, &d->scene));
    TRY(reach_base_open(c, NULL, &d->base));
    for (int i = 0; i < dc->parameters.count; i++) {
        const design_parameter_case *p = case_design_parameter(c, i);
        d->lower[i] = p->lower;
        d->upper[i] = p->upper;
        d->start[i] = p->start;
    }
    d->scoring = (design_scoring){.c = c,
                                  .scene = &d->scene,
                                  .base = &d->base,
                                  .scope = case_design_scope(c),
                                  .length = SHORT * c->file.reach.tolerance};
    // a mistake in what is set is told here; from there on a design may fail
    TRY(design_settings(c, d->start, &s));
    TRY(case_place(c, reach_scope_make(c, &d->base, d->scoring.scope, &s, &start), dc->at));
    d->problem = fingerprint(d, &start);
    TRY(name_log(d));
    TRY(take_samples(d));

done:
    reach_scope_free(&start);
    settings_free(&s);
    return st;
}

static status search(designing *d, design_answer *out)
{
    const design_case *dc = &d->c->file.reach.design;
    const design_problem p = {
        .nparameter = dc->parameters.count,
        .lower = d->lower,
        .upper = d->upper,
        .start = d->start,
        .score = design_score,
        .context = &d->scoring,
        .per_goal = d->scoring.nmap > 0 ? d->scoring.nmap : 1,
        .islands = dc->islands,
        .evaluations = dc->evaluations,
        .seed = dc->seed,
        .log = d->cmd->out ? d->log : NULL,
        .problem = d->problem,
        .heard = heard,
        .hearer = d,
    };
    return case_place(d->c, design_search(&p, out), dc->at);
}

// --- what it reaches

static status tell(designing *d, const design_answer *a, run_result *out)
{
    status st = OK;
    settings s = {0};
    reach_design_result rows = {0};
    const double *x = a->trial[a->best].x;
    reach_extra designed = {.scope = d->scoring.scope, .more = &s};
    (void)snprintf(designed.name, sizeof designed.name, "%.50s designed",
                   d->c->file.reach.design.scope.text);
    TRY(design_tell(d->c, a, &rows));
    TRY(design_case_text(d->c, &rows, x, &out->designed_case));
    TRY(design_settings(d->c, x, &s));
    TRY(chain_reach_with(d->cmd, d->c, &designed, out));
    out->reach.design = rows;
    rows = (reach_design_result){0};

done:
    reach_design_free(&rows);
    settings_free(&s);
    return st;
}

status chain_design(const command *cmd, const case_data *c, run_result *out)
{
    status st = OK;
    design_answer a = {0};
    designing d = {.cmd = cmd, .c = c};
    TRY(open_all(&d));
    TRY(search(&d, &a));
    if (cmd->first_rank) { // the others have done their part
        TRY(tell(&d, &a, out));
    }

done:
    design_answer_free(&a);
    free(d.scoring.map);
    variation_free(&d.base);
    reach_scene_free(&d.scene);
    return st;
}
