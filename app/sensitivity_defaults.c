// app/sensitivity_defaults.c
// The parameters that papers and drawings leave open, for a case that names none.
#include "app/case_value.h"
#include "app/sensitivity.h"
#include "base/memory.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

// what printed soft robots leave open: +-0.1 mm in the channels' place, +-10 % in a modulus, nu of
// elastomers from foam to rubber, tendons in bare channels
static const double radius_off = 0.1, modulus_off = 0.1, nu_low = 0.3, nu_high = 0.49,
                    friction_high = 0.2;

static const char *say(default_list *d, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static const char *say(default_list *d, const char *format, ...)
{
    va_list arguments;
    char *text = d->text[d->ntext];
    va_start(arguments, format);
    (void)vsnprintf(text, sizeof d->text[0], format, arguments);
    va_end(arguments);
    return text;
}

// a key of the parameter at hand; false where there is no more room
static bool add_key(default_list *d, sensitivity_parameter *q, const char *text)
{
    if (d->ntext >= DEFAULT_TEXTS || q->p.keys.count >= PARAMETER_MOST_KEYS) {
        return false;
    }
    d->keys[d->ntext] = (key_text){.text = text};
    if (q->p.keys.count == 0) {
        q->p.keys.items = &d->keys[d->ntext];
    }
    d->ntext++;
    q->p.keys.count++;
    return true;
}

static sensitivity_parameter *begin(default_list *d, const char *name, double low, double high)
{
    sensitivity_parameter *q = &d->parameter[d->count];
    *q = (sensitivity_parameter){.p = {.name = name}, .low = low, .high = high, .sigma = NAN};
    return q;
}

static void end(default_list *d, const sensitivity_parameter *q)
{
    d->count += q->p.keys.count > 0;
}

// tendons at one radius that is the same all along, and not at the centre
static void add_radius(const case_data *c, default_list *d)
{
    const tendon_case *t = c->file.rod.tendons.items;
    double radius = 0;
    sensitivity_parameter *q = begin(d, "tendon radius", 0, 0);
    for (int i = 0; i < c->file.rod.tendons.count; i++) {
        const field *f = &t[i].spec.radius;
        const bool own = !field_varies(f) && f->value > 2e-3 * radius_off;
        if (own && (radius == 0 || radius == f->value)) {
            radius = f->value;
            if (!add_key(d, q, say(d, "rod.tendons.%d.radius_mm", i))) {
                break;
            }
        }
    }
    q->low = 1e3 * radius - radius_off;
    q->high = 1e3 * radius + radius_off;
    end(d, q);
}

static bool is_plain(const material *m)
{
    return m->kind == MATERIAL_ISOTROPIC;
}

static void add_nu(const case_data *c, default_list *d)
{
    sensitivity_parameter *q = begin(d, "Poisson's ratio", nu_low, nu_high);
    for (int i = 0; i < c->nmaterial; i++) {
        if (is_plain(&c->materials[i]) &&
            !add_key(d, q, say(d, "materials.%.60s.nu", c->materials[i].name))) {
            break;
        }
    }
    end(d, q);
}

// of the stiffest: the ratio of the moduli where there are two
static void add_modulus(const case_data *c, default_list *d)
{
    double most = 0;
    const char *path = NULL;
    for (int i = 0; i < c->nmaterial; i++) {
        case_value v;
        const char *key = say(d, "materials.%.60s.E_MPa", c->materials[i].name);
        const status found = case_value_find(c, key, (mark){1, 1}, &v);
        if (found != OK) {
            status_clear();
        } else if (is_plain(&c->materials[i]) && v.number > most) {
            most = v.number;
            path = c->materials[i].name;
        }
    }
    sensitivity_parameter *q = begin(d, c->nmaterial > 1 ? "E of the stiffest" : "E",
                                     (1 - modulus_off) * most, (1 + modulus_off) * most);
    if (path) {
        (void)add_key(d, q, say(d, "materials.%.60s.E_MPa", path));
    }
    end(d, q);
}

static void add_friction(const case_data *c, default_list *d)
{
    sensitivity_parameter *q = begin(d, "friction", 0, friction_high);
    for (int i = 0; i < c->file.rod.tendons.count; i++) {
        if (!add_key(d, q, say(d, "rod.tendons.%d.friction", i))) {
            break;
        }
    }
    end(d, q);
}

static void add_model(const case_data *c, default_list *d)
{
    sensitivity_parameter *q = begin(d, "section model", NAN, NAN);
    const bool classical = c->file.section.model == MODEL_CLASSICAL;
    q->alternative.text = classical ? "full" : "classical";
    (void)add_key(d, q, "section.model");
    end(d, q);
}

status sensitivity_defaults(const case_data *c, default_list *out)
{
    status st = OK;
    *out = (default_list){0};
    TRY(TAKE(out->text, (size_t)DEFAULT_TEXTS + 1));
    add_radius(c, out);
    add_nu(c, out);
    add_modulus(c, out);
    add_friction(c, out);
    add_model(c, out);

done:
    return st;
}

void sensitivity_defaults_free(default_list *d)
{
    free(d->text);
    *d = (default_list){0};
}
