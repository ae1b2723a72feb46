// app/parameter.c
#include "app/parameter.h"

#include "app/case.h"
#include "base/memory.h"

#include <stdio.h>
#include <string.h>

static const key_text *key_of(const parameter *p, int i)
{
    return (const key_text *)p->keys.items + i;
}

status parameter_check(const case_data *c, const parameter *p)
{
    double factor = 0;
    if (!p->name[0]) {
        return config_fail(c->config, p->at, "a parameter needs a name");
    }
    if (p->keys.count == 0) {
        return config_fail(c->config, p->keys.at, "parameter '%.60s' names no key", p->name);
    }
    const char *unit = parameter_unit(p, &factor);
    for (int i = 0; i < p->keys.count; i++) {
        const key_text *k = key_of(p, i);
        const char *other = key_written_unit(k->text, &factor);
        if (!k->text[0] || strchr(k->text, '=')) {
            return config_fail(c->config, k->at, "'%.60s' is no key: name one like rod.length_mm",
                               k->text);
        }
        if (strcmp(unit, other) != 0) {
            return config_fail(c->config, k->at,
                               "parameter '%.60s' has keys in '%s' and in '%s': one value goes to "
                               "all of them, so they take one unit",
                               p->name, unit[0] ? unit : "no unit", other[0] ? other : "no unit");
        }
        for (int j = 0; j < i; j++) {
            if (strcmp(k->text, key_of(p, j)->text) == 0) {
                return config_fail(c->config, k->at, "parameter '%.60s' names '%.60s' twice",
                                   p->name, k->text);
            }
        }
    }
    return OK;
}

status parameters_differ(const case_data *c, const parameter *p, const parameter *q)
{
    if (strcmp(p->name, q->name) == 0) {
        return config_fail(c->config, q->at, "two parameters are called '%.60s'", p->name);
    }
    for (int i = 0; i < p->keys.count; i++) {
        for (int j = 0; j < q->keys.count; j++) {
            if (strcmp(key_of(p, i)->text, key_of(q, j)->text) == 0) {
                return config_fail(c->config, key_of(q, j)->at,
                                   "'%.60s' belongs to parameter '%.60s' already",
                                   key_of(q, j)->text, p->name);
            }
        }
    }
    return OK;
}

const char *parameter_unit(const parameter *p, double *factor)
{
    *factor = 1;
    return p->keys.count > 0 ? key_written_unit(key_of(p, 0)->text, factor) : "";
}

static void add_about(settings *s, const parameter *p, const char *value)
{
    const size_t used = strlen(s->about);
    (void)snprintf(s->about + used, sizeof s->about - used, "%s%.60s = %.60s", used ? ", " : "",
                   p->name, value);
}

static status grow(settings *s, int more)
{
    status st = OK;
    char **larger = NULL;
    if (s->count + more <= s->capacity) {
        return OK;
    }
    const int capacity = 2 * s->capacity + more;
    TRY(TAKE(larger, (size_t)capacity));
    for (int i = 0; i < s->count; i++) {
        larger[i] = s->text[i];
    }
    free(s->text);
    s->text = larger;
    s->capacity = capacity;

done:
    return st;
}

// the value as it is written behind the equals sign, `words` as a person reads it
static status add(settings *s, const parameter *p, const char *value, const char *words)
{
    status st = OK;
    TRY(grow(s, p->keys.count));
    for (int i = 0; i < p->keys.count; i++) {
        const size_t room = strlen(key_of(p, i)->text) + strlen(value) + 2;
        char *text = NULL;
        TRY(TAKE(text, room));
        (void)snprintf(text, room, "%s=%s", key_of(p, i)->text, value);
        s->text[s->count++] = text;
    }
    add_about(s, p, words);

done:
    return st;
}

status settings_add(settings *s, const parameter *p, double value)
{
    char exact[40], words[40];
    (void)snprintf(exact, sizeof exact, "%.17g", value);
    (void)snprintf(words, sizeof words, "%.6g", value);
    return add(s, p, exact, words);
}

status settings_add_text(settings *s, const parameter *p, const char *value)
{
    return add(s, p, value, value);
}

void settings_free(settings *s)
{
    for (int i = 0; i < s->count; i++) {
        free(s->text[i]);
    }
    free(s->text);
    *s = (settings){0};
}
