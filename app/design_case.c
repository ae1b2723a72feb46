// app/design_case.c
#include "app/design_case.h"

#include "app/reach_case.h"
#include "base/memory.h"
#include "base/nearest.h"
#include "io/expression.h"
#include "reach/design.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { NAME_MOST = 32 };

bool case_has_design(const case_data *c)
{
    return case_has_reach(c) && mark_given(c->file.reach.design.at);
}

const design_parameter_case *case_design_parameter(const case_data *c, int i)
{
    return (const design_parameter_case *)c->file.reach.design.parameters.items + i;
}

static const key_text *set_of(const case_data *c, int i)
{
    return (const key_text *)c->file.reach.design.set.items + i;
}

int case_design_scope(const case_data *c)
{
    const reach_case *r = &c->file.reach;
    for (int i = 0; i < r->scopes.count; i++) {
        if (strcmp(case_scope(c, i)->name, r->design.scope.text) == 0) {
            return i;
        }
    }
    return -1;
}

// --- what does not go together

static bool is_word(const char *name)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
    static const char all[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
    return name[0] && strspn(name, letters) > 0 && strspn(name, all) == strlen(name) &&
           strlen(name) < NAME_MOST;
}

// whether the expressions use it at all
static status is_used(const case_data *c, const char *name, bool *used)
{
    status st = OK;
    const double two[2] = {1, 2};
    char *one = NULL, *other = NULL;
    *used = false;
    for (int i = 0; i < c->file.reach.design.set.count && !*used; i++) {
        const char *equals = strchr(set_of(c, i)->text, '=');
        TRY(design_words(equals, 1, &name, &two[0], &one));
        TRY(design_words(equals, 1, &name, &two[1], &other));
        *used = strcmp(one, other) != 0;
        free(one);
        free(other);
        one = other = NULL;
    }

done:
    free(one);
    free(other);
    return st;
}

static bool is_of_yaml(const char *name)
{
    return strcmp(name, "true") == 0 || strcmp(name, "false") == 0 || strcmp(name, "null") == 0;
}

static status check_parameter(const case_data *c, int i)
{
    status st = OK;
    bool used = false;
    const design_parameter_case *p = case_design_parameter(c, i);
    if (!is_word(p->name)) {
        return config_fail(c->config, p->at,
                           "'%.60s' is no name for a parameter: letters, digits and _, a letter "
                           "first, at most %d",
                           p->name, NAME_MOST - 1);
    }
    if (expression_knows(p->name) || is_of_yaml(p->name)) {
        return config_fail(c->config, p->at,
                           "a parameter cannot be called '%s': expressions know that name already",
                           p->name);
    }
    for (int k = 0; k < i; k++) {
        if (strcmp(p->name, case_design_parameter(c, k)->name) == 0) {
            return config_fail(c->config, p->at, "two parameters are called '%s'", p->name);
        }
    }
    if (!(p->lower < p->upper)) {
        return config_fail(c->config, p->at,
                           "parameter '%s': lower = %g does not lie below upper = %g", p->name,
                           p->lower, p->upper);
    }
    if (!(p->lower <= p->start && p->start <= p->upper)) {
        return config_fail(c->config, p->at,
                           "parameter '%s': start = %g lies outside its bounds, %g to %g", p->name,
                           p->start, p->lower, p->upper);
    }
    TRY(is_used(c, p->name, &used));
    if (!used) {
        return config_fail(c->config, p->at, "parameter '%s' stands in no expression of `set`",
                           p->name);
    }

done:
    return st;
}

static status check_scope(const case_data *c)
{
    const design_case *d = &c->file.reach.design;
    const int i = case_design_scope(c);
    if (i < 0) {
        char words[NEAREST_WORDS];
        nearest near = nearest_to(d->scope.text);
        for (int k = 0; k < c->file.reach.scopes.count; k++) {
            nearest_offer(&near, case_scope(c, k)->name, case_scope(c, k)->name);
        }
        return config_fail(c->config, d->scope.at, "no scope is called '%.60s'%s", d->scope.text,
                           nearest_words(&near, words));
    }
    if (!case_scope_is_rod(case_scope(c, i))) {
        return config_fail(c->config, d->scope.at,
                           "scope '%.60s' is an arc: it has no rod whose design could be varied",
                           d->scope.text);
    }
    return OK;
}

// a key that two lines set, or one that the scope sets too: one of them would be lost
static status check_set(const case_data *c, int i)
{
    const key_text *line = set_of(c, i);
    const key_list *own = &case_scope(c, case_design_scope(c))->rod.set;
    const size_t key = strcspn(line->text, "=");
    if (line->text[key] == '\0') {
        return config_fail(c->config, line->at, "'%.60s' sets nothing: write KEY=EXPRESSION",
                           line->text);
    }
    if (strncmp(line->text, "reach", 5) == 0) {
        return config_fail(c->config, line->at, "'%.60s' is of the search, not of the design",
                           line->text);
    }
    for (int k = 0; k < i + own->count; k++) {
        const key_text *other = k < i ? set_of(c, k) : (const key_text *)own->items + (k - i);
        if (strncmp(other->text, line->text, key + 1) == 0) {
            return config_fail(c->config, line->at, "'%.*s' is set twice%s",
                               (int)(key < 60 ? key : 60), line->text,
                               k < i ? "" : ", by the scope's rod.set too");
        }
    }
    return OK;
}

status case_design_check(const case_data *c)
{
    status st = OK;
    const reach_case *r = &c->file.reach;
    const design_case *d = &r->design;
    TRY(check_scope(c));
    if (d->parameters.count == 0 || d->set.count == 0) {
        return config_fail(c->config, d->at, "a design needs parameters, and keys that they `set`");
    }
    for (int i = 0; i < d->set.count; i++) {
        TRY(check_set(c, i));
    }
    for (int i = 0; i < d->parameters.count; i++) {
        TRY(check_parameter(c, i));
    }
    if (d->evaluations > DESIGN_MOST_EVALUATIONS) {
        return config_fail(c->config, d->at, "evaluations = %d are more than %d", d->evaluations,
                           DESIGN_MOST_EVALUATIONS);
    }
    if (d->goal == DESIGN_TARGETS && !r->targets.text) {
        return config_fail(c->config, d->at,
                           "the case has no `targets` to maximise: give them, or maximise: area");
    }
    if (d->goal == DESIGN_AREA && !mark_given(r->map.at)) {
        return config_fail(c->config, d->at,
                           "an area is that of the reach map: give map: {points: 10000}");
    }

done:
    return st;
}

status case_need_design(const case_data *c)
{
    const mark at = c->file.reach.at;
    return case_has_design(c)
               ? case_design_check(c)
               : case_lacks(c, mark_given(at) ? at : (mark){1, 1}, "reach.design", "design");
}

// --- a design as settings

// "width = 1.5, turns = -1", for messages
static void tell_about(const case_data *c, const double *x, settings *s)
{
    size_t used = 0;
    s->about[0] = '\0';
    for (int i = 0; i < c->file.reach.design.parameters.count && used < sizeof s->about; i++) {
        used += (size_t)snprintf(s->about + used, sizeof s->about - used, "%s%s = %.6g",
                                 i ? ", " : "", case_design_parameter(c, i)->name, x[i]);
    }
}

// the part before the equals sign of `text` to `value`
static status add_key(settings *s, const char *text, const char *value)
{
    status st = OK;
    char *key = NULL;
    const size_t length = strcspn(text, "=");
    TRY(TAKE(key, length + 1));
    memcpy(key, text, length);
    key_text name = {.text = key};
    const parameter p = {.name = "", .keys = {.count = 1, .items = &name}};
    TRY(settings_add_text(s, &p, value));

done:
    free(key);
    return st;
}

status design_settings(const case_data *c, const double *x, settings *out)
{
    status st = OK;
    const design_case *d = &c->file.reach.design;
    const char *name[DESIGN_PARAMETERS];
    char *value = NULL;
    for (int i = 0; i < d->parameters.count; i++) {
        name[i] = case_design_parameter(c, i)->name;
    }
    for (int i = 0; i < d->set.count; i++) {
        const char *text = set_of(c, i)->text;
        TRY(design_words(strchr(text, '=') + 1, d->parameters.count, name, x, &value));
        TRY(add_key(out, text, value));
        free(value);
        value = NULL;
    }
    tell_about(c, x, out);

done:
    free(value);
    return st;
}

// "[a, 'b']": what the scope sets already, then the design
static status set_list(const scope_case *scope, const settings *design, char **out)
{
    status st = OK;
    char *list = NULL;
    size_t room = 3, used = 1;
    for (int i = 0; i < scope->rod.set.count + design->count; i++) {
        const int k = i - scope->rod.set.count;
        room += 8 + 2 * strlen(k < 0 ? ((const key_text *)scope->rod.set.items)[i].text
                                     : design->text[k]);
    }
    TRY(TAKE(list, room));
    list[0] = '[';
    for (int i = 0; i < scope->rod.set.count + design->count; i++) {
        const int k = i - scope->rod.set.count;
        const char *from =
            k < 0 ? ((const key_text *)scope->rod.set.items)[i].text : design->text[k];
        used += (size_t)snprintf(list + used, room - used, "%s'", i ? ", " : "");
        for (; *from; from++) {
            list[used++] = *from;
            if (*from == '\'') {
                list[used++] = *from;
            }
        }
        list[used++] = '\'';
    }
    (void)snprintf(list + used, room - used, "]");
    *out = list;

done:
    return st;
}

status design_case_settings(const case_data *c, const double *x, settings *out)
{
    status st = OK;
    settings design = {0};
    char *list = NULL, key[80], value[40];
    const int scope = case_design_scope(c);
    TRY(design_settings(c, x, &design));
    if (case_scope_is_own(case_scope(c, scope))) {
        for (int i = 0; i < design.count; i++) {
            TRY(add_key(out, design.text[i], strchr(design.text[i], '=') + 1));
        }
    } else {
        (void)snprintf(key, sizeof key, "reach.scopes.%d.rod.set", scope);
        TRY(set_list(case_scope(c, scope), &design, &list));
        TRY(add_key(out, key, list));
    }
    for (int i = 0; i < c->file.reach.design.parameters.count; i++) {
        (void)snprintf(key, sizeof key, "reach.design.parameters.%d.start", i);
        (void)snprintf(value, sizeof value, "%.17g", x[i]);
        TRY(add_key(out, key, value));
    }
    tell_about(c, x, out);

done:
    free(list);
    settings_free(&design);
    return st;
}
