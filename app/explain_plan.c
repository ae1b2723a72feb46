// app/explain_plan.c
// What would be computed from a case, what it reads, what it left open.
#include "app/chain.h"
#include "app/design_case.h"
#include "app/explain.h"
#include "app/measured_case.h"
#include "app/reach_case.h"
#include "app/sensitivity.h"
#include "io/config_defaults.h"
#include "io/number.h"

#include <string.h>

// --- what is computed

static void list_done(const case_data *c, word_list *words)
{
    const case_file *f = &c->file;
    const chain_parts parts = chain_all_parts(c);
    if (parts.section) {
        word_list_add(words, "section");
    }
    if (parts.rod) {
        word_list_add(words, "rod");
    }
    if (parts.measured) {
        const int n = f->measured.shapes.count;
        if (n > 0) {
            word_list_add(words, "errors against %d measured shape%s", n, plural(n));
        } else {
            word_list_add(words, "errors as the paper prints them");
        }
    }
    if (parts.fit) {
        word_list_add(words, "fit of %d number%s", f->fit.parameters.count,
                      plural(f->fit.parameters.count));
    }
    if (parts.segment) {
        word_list_add(words, "fem");
    }
    if (parts.compare) {
        word_list_add(words, "compare");
    }
    if (parts.sensitivity) {
        word_list_add(words, "sensitivity to %d parameter%s", f->sensitivity.parameters.count,
                      plural(f->sensitivity.parameters.count));
    }
    if (parts.reach) {
        word_list_add(words, "reach of %d scope%s", f->reach.scopes.count,
                      plural(f->reach.scopes.count));
    }
}

static void explain_parameters(explanation *e, const case_data *c)
{
    word_list moved = {0}, fitted = {0}, scopes = {0}, design = {0};
    const sensitivity_parameter *s = c->file.sensitivity.parameters.items;
    const fit_parameter *f = c->file.fit.parameters.items;
    for (int i = 0; i < c->file.sensitivity.parameters.count; i++) {
        word_list_add(&moved, "'%.60s'", s[i].p.name);
    }
    for (int i = 0; i < c->file.fit.parameters.count; i++) {
        word_list_add(&fitted, "'%.60s'", f[i].what.name);
    }
    for (int i = 0; i < c->file.reach.scopes.count; i++) {
        const scope_case *scope = case_scope(c, i);
        word_list_add(&scopes, "'%.60s' (%s)", scope->name ? scope->name : "",
                      case_scope_is_rod(scope) ? "rod" : "arc");
    }
    const design_parameter_case *d = c->file.reach.design.parameters.items;
    for (int i = 0; i < c->file.reach.design.parameters.count; i++) {
        word_list_add(&design, "'%.60s' from %.6g to %.6g%s%s", d[i].name, d[i].lower, d[i].upper,
                      d[i].unit && d[i].unit[0] ? " " : "", d[i].unit ? d[i].unit : "");
    }
    const struct {
        const char *about, *words;
    } lists[] = {{"sensitivity", moved.text},
                 {"fit", fitted.text},
                 {"scopes", scopes.text},
                 {"design", design.text}};
    for (int i = 0; i < 4; i++) {
        if (lists[i].words[0]) {
            explain(e, lists[i].about, "%s", lists[i].words);
        }
    }
}

static void list_lacking(const case_data *c, word_list *words)
{
    const struct {
        bool there;
        const char *name;
    } parts[] = {{case_has_section(c), "section"},
                 {case_has_rod(c), "rod"},
                 {case_has_segment(c), "fem"},
                 {case_has_measured(c), "measured"},
                 {case_has_sensitivity(c), "sensitivity"},
                 {case_has_fit(c), "fit"},
                 {case_has_reach(c), "reach"}};
    for (int i = 0; i < (int)(sizeof parts / sizeof *parts); i++) {
        if (!parts[i].there) {
            word_list_add(words, "%s", parts[i].name);
        }
    }
}

// --- files

static void tell_file(const key_text *name, void (*tell)(void *self, const char *name), void *self)
{
    if (name->text && name->text[0]) {
        tell(self, name->text);
    }
}

void case_files(const case_data *c, void (*tell)(void *self, const char *name), void *self)
{
    const case_file *f = &c->file;
    const drawing_files *d = &f->section.files;
    const tendon_case *tendons = f->rod.tendons.items;
    const measured_shape *shapes = f->measured.shapes.items;
    const key_text *drawn[] = {&d->png.file, &d->msh.file, &d->step.file, &d->dxf.file,
                               &d->geo.file};
    for (int i = 0; i < (int)(sizeof drawn / sizeof *drawn); i++) {
        tell_file(drawn[i], tell, self);
    }
    for (int i = 0; i < f->rod.tendons.count; i++) {
        tell_file(&tendons[i].path_csv, tell, self);
    }
    for (int i = 0; i < f->measured.shapes.count; i++) {
        tell_file(&shapes[i].csv, tell, self);
    }
    tell_file(&f->reach.tissue, tell, self);
    tell_file(&f->reach.targets, tell, self);
    for (int i = 0; i < f->reach.scopes.count; i++) {
        tell_file(&case_scope(c, i)->rod.file, tell, self);
    }
}

static void add_file(void *self, const char *name)
{
    word_list_add(self, "%.200s", name);
}

// --- defaults

typedef struct defaults {
    explanation *e;
    const char *map;
    word_list words;
} defaults;

static void end_part(defaults *d)
{
    if (d->map) {
        explain(d->e, "defaults", "%s: %s", d->map, d->words.text);
    }
    d->words = (word_list){0};
    d->map = NULL;
}

// what is 0, 1 or nothing unless it is given needs no words
static bool is_nothing(const char *words)
{
    return strcmp(words, "0") == 0 || strcmp(words, "1") == 0 || strncmp(words, "[0", 2) == 0 ||
           strcmp(words, "false") == 0;
}

static void add_default(void *self, const char *map, const char *key, const char *words)
{
    defaults *d = self;
    if (is_nothing(words)) {
        return;
    }
    if (!d->map || strcmp(d->map, map) != 0) {
        end_part(d);
        d->map = map;
    }
    word_list_add(&d->words, "%s %s", key, words);
}

void explain_plan(explanation *e, const case_data *c)
{
    word_list done = {0}, lacking = {0}, files = {0};
    defaults d = {.e = e};
    key_table root;
    case_file initial;
    explain_parameters(e, c);
    list_done(c, &done);
    list_lacking(c, &lacking);
    explain(e, "run", "computes %s%s", done.text,
            case_has_design(c) ? "; `design` searches for a better one" : "");
    if (lacking.text[0]) {
        explain(e, "absent", "%s", lacking.text);
    }
    case_files(c, add_file, &files);
    explain(e, "files", "%s", files.text[0] ? files.text : "none but the case");
    case_keys(&root, &initial);
    config_defaults(c->config, &root, add_default, &d);
    end_part(&d);
}
