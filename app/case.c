// app/case.c
#include "app/case.h"

#include "app/case_rod.h"
#include "app/case_segment.h"
#include "app/measured_case.h"
#include "app/reach_case.h"
#include "app/sensitivity.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

static const key root_keys[] = {
    {.name = "format",
     .kind = KEY_INTEGER,
     .min = 1,
     .max = 1,
     .required = true,
     .offset = offsetof(case_file, format),
     .about = "version of the case format; this program reads 1"},
    {.name = "title",
     .kind = KEY_TEXT,
     .offset = offsetof(case_file, title),
     .about = "one line for the report"},
    {.name = "fitted",
     .kind = KEY_TEXT,
     .offset = offsetof(case_file, fitted),
     .about = "which of the case's numbers were fitted to measured shapes: said with the title, "
              "wherever that stands; `fit` writes it into fitted.yaml"},
    {.name = "materials",
     .kind = KEY_NAMED,
     .max_count = 64,
     .offset = offsetof(case_file, materials),
     .table = &material_keys,
     .about = "the materials by name; needed where there is a section"},
    {.name = "section",
     .kind = KEY_TABLE,
     .offset = offsetof(case_file, section),
     .table = &section_keys,
     .about = "the cross section, which may vary along the rod; needed by all but `reach`"},
    {.name = "rod",
     .kind = KEY_TABLE,
     .offset = offsetof(case_file, rod),
     .table = &rod_keys,
     .about = "the rod and its tendons"},
    {.name = "fem",
     .kind = KEY_TABLE,
     .offset = offsetof(case_file, fem),
     .table = &segment_keys,
     .about = "a segment of the rod in 3D"},
    {.name = "measured",
     .kind = KEY_TABLE,
     .offset = offsetof(case_file, measured),
     .table = &measured_keys,
     .about = "shapes of the rod that were measured"},
    {.name = "sensitivity",
     .kind = KEY_TABLE,
     .offset = offsetof(case_file, sensitivity),
     .table = &sensitivity_keys,
     .about = "what moves the rod's answer"},
    {.name = "fit",
     .kind = KEY_TABLE,
     .offset = offsetof(case_file, fit),
     .table = &fit_keys,
     .about = "what is left open, fitted to the measured shapes"},
    {.name = "reach",
     .kind = KEY_TABLE,
     .offset = offsetof(case_file, reach),
     .table = &reach_keys,
     .about = "which targets in a body scopes reach"},
};

void case_keys(key_table *root, case_file *initial)
{
    *initial = (case_file){
        // not section_case_default(): what the case leaves open stays open until it was read
        .section = *(const section_case *)section_keys.initial,
        .rod = rod_case_default(),
        .fem = segment_case_default(),
        .sensitivity = {.monte_carlo = {.seed = 1}},
        .fit = fit_case_default(),
        .reach = reach_case_default(),
    };
    *root = (key_table){
        .name = "case",
        .size = sizeof(case_file),
        .nkey = (int)(sizeof root_keys / sizeof *root_keys),
        .keys = root_keys,
        .initial = initial,
        .about = "a stiffaxis case",
    };
}

// the length comes first: expressions may use it as L
static status peek_length(case_data *c, const key_table *table, const char *path)
{
    status st = OK;
    bool found = false;
    for (int i = 0; i < table->nkey && c->length <= 0; i++) {
        if (strcmp(table->keys[i].name, "length") == 0) {
            double length = 0;
            TRY(config_peek_real(c->config, path, &table->keys[i], &length, &found));
            c->length = found ? length : 0;
        }
    }

done:
    return st;
}

status case_place(const case_data *c, status st, mark at)
{
    char words[1024];
    const bool placed = status_place(&at.line, &at.column);
    if (st == OK || (st != ERR_INPUT && !placed) || strstr(status_message(), ": error: ")) {
        return st;
    }
    (void)snprintf(words, sizeof words, "%s", status_message());
    status_clear();
    (void)config_fail(c->config, at, "%s", words);
    return st;
}

static double last_station(const key_rows *stations)
{
    double last = 0;
    for (int i = 0; i < stations->nrow * stations->ncol; i++) {
        last = stations->a[i] > last ? stations->a[i] : last;
    }
    return last;
}

void case_folder(const case_data *c, char *folder, size_t room)
{
    const char *path = config_path(c->config), *slash = strrchr(path, '/');
    const size_t length = slash ? (size_t)(slash - path) + 1 : 0;
    (void)snprintf(folder, room, "%.*s", (int)(length < room ? length : 0), path);
}

static bool varies(const case_data *c)
{
    bool any = section_varies(&c->file.section);
    for (int i = 0; i < c->nmaterial; i++) {
        any = any || material_varies(&c->materials[i]);
    }
    return any;
}

static status check_section(case_data *c)
{
    const key_rows *stations = &c->file.section.stations;
    mark where = c->file.section.at;
    char folder[PATH_MAX];
    case_folder(c, folder, sizeof folder);
    const section_surroundings around = {
        .directory = folder[0] ? folder : NULL,
        .allow_scripts = c->allow_scripts,
    };
    status st = case_place(
        c, section_case_bind(&c->file.section, &c->file.materials, &around, &where), where);
    if (st == OK) {
        st = case_place(c, section_wrenches_check(&c->file.section, &where), where);
    }
    if (st != OK) {
        return st;
    }
    const double last = last_station(stations);
    if (c->length <= 0 && section_own_length(&c->file.section) > 0) {
        c->length = section_own_length(&c->file.section);
    }
    if (c->length <= 0) {
        if (varies(c) && last <= 0) {
            return config_fail(c->config, c->file.section.at,
                               "the section varies along s, but nothing says how far: give "
                               "rod.length, fem.length or section.stations");
        }
        c->length = last > 0 ? last : 1; // a section alone has no length, and nothing varies
    }
    for (int i = 0; i < stations->nrow * stations->ncol; i++) {
        if (stations->a[i] < 0 || stations->a[i] > c->length) {
            return config_fail(c->config, stations->at, "station %g mm lies outside 0 to %g mm",
                               1e3 * stations->a[i], 1e3 * c->length);
        }
    }
    return OK;
}

static status bind_materials(case_data *c)
{
    status st = OK;
    material *m = c->file.materials.items;
    for (int i = 0; i < c->file.materials.count; i++) {
        TRY(case_place(c, material_bind(&m[i]), m[i].at));
    }

done:
    return st;
}

// measured shapes belong to the case as it stands, not to what is made of it
static status check_measured(case_data *c, bool again)
{
    char folder[PATH_MAX];
    case_folder(c, folder, sizeof folder);
    return case_has_measured(c) && !again ? case_measured_bind(c, folder[0] ? folder : NULL) : OK;
}

// a case that only asks where arcs reach has no section; all else is about one
static status check_present(const case_data *c)
{
    const case_file *f = &c->file;
    const struct {
        mark at;
        const char *what;
    } about[] = {{f->rod.at, "rod"},
                 {f->fem.at, "fem"},
                 {f->measured.at, "measured"},
                 {f->sensitivity.at, "sensitivity"},
                 {f->fit.at, "fit"}};
    if (case_has_section(c)) {
        return mark_given(f->materials.at)
                   ? OK
                   : config_fail(c->config, f->at, "key 'materials' is missing in the case");
    }
    for (int i = 0; case_has_reach(c) && i < (int)(sizeof about / sizeof *about); i++) {
        if (mark_given(about[i].at)) {
            return config_fail(c->config, about[i].at,
                               "key 'section' is missing in the case: its '%s' needs one",
                               about[i].what);
        }
    }
    return case_has_reach(c) ? OK
                             : config_fail(c->config, f->at, "key '%s' is missing in the case",
                                           mark_given(f->materials.at) ? "section" : "materials");
}

static status check_parts(case_data *c, bool only_rod)
{
    status st = OK;
    char folder[PATH_MAX];
    TRY(check_present(c));
    TRY(bind_materials(c));
    TRY(only_rod || !case_has_section(c) ? OK : check_section(c));
    if (case_has_rod(c)) {
        case_folder(c, folder, sizeof folder);
        TRY(case_rod_bind(c, folder[0] ? folder : NULL));
    }
    if (case_has_segment(c) && !only_rod) {
        TRY(case_segment_check(c));
    }

done:
    return st;
}

static status open_config(const case_request *r, config **out)
{
    return r->again  ? config_open_again(r->again, r->noverride, r->overrides, out)
           : r->text ? config_open_text(r->path, r->text, r->noverride, r->overrides, out)
                     : config_open(r->path, r->noverride, r->overrides, out);
}

status case_open(const case_request *request, case_data *out)
{
    status st = OK;
    case_data c = {.allow_scripts = request->allow_scripts};
    key_table root;
    case_file initial;

    TRY(open_config(request, &c.config));
    TRY(peek_length(&c, &rod_keys, "rod.length"));
    TRY(peek_length(&c, &segment_keys, "fem.length"));
    if (c.length > 0) {
        config_set_length(c.config, c.length);
    }
    case_keys(&root, &initial);
    TRY(config_read(c.config, &root, &c.file));
    c.nmaterial = c.file.materials.count;
    c.materials = c.file.materials.items;
    TRY(check_parts(&c, request->only_rod));
    TRY(check_measured(&c, request->again != NULL));
    TRY(case_has_sensitivity(&c) && !request->again ? sensitivity_check(&c) : OK);
    TRY(case_has_fit(&c) && !request->again ? case_fit_check(&c) : OK);
    TRY(case_has_reach(&c) && !request->again ? case_reach_check(&c) : OK);
    *out = c;
    c = (case_data){0};

done:
    case_free(&c);
    return st;
}

status command_case(const command *cmd, case_data *out)
{
    return case_open(&(case_request){.path = cmd->argument,
                                     .noverride = cmd->noverride,
                                     .overrides = cmd->overrides,
                                     .allow_scripts = cmd->allow_scripts},
                     out);
}

void case_free(case_data *c)
{
    section_case_release(&c->file.section);
    rod_case_release(&c->file.rod);
    measured_case_release(&c->file.measured);
    config_free(c->config);
    *c = (case_data){0};
}

bool case_has_section(const case_data *c)
{
    return mark_given(c->file.section.at);
}

bool case_has_rod(const case_data *c)
{
    return mark_given(c->file.rod.at);
}

bool case_has_segment(const case_data *c)
{
    return mark_given(c->file.fem.at);
}

bool case_has_sensitivity(const case_data *c)
{
    return mark_given(c->file.sensitivity.at);
}

status case_lacks(const case_data *c, mark at, const char *part, const char *example)
{
    return config_fail(c->config, at, "the case has no '%s'; `stiffaxis example %s` has one", part,
                       example);
}

status case_need_section(const case_data *c)
{
    return case_has_section(c) ? OK : case_lacks(c, (mark){1, 1}, "section", "fig4");
}

status case_need_rod(const case_data *c)
{
    return case_has_rod(c) ? OK : case_lacks(c, (mark){1, 1}, "rod", "constant_nc");
}

status case_need_segment(const case_data *c)
{
    return case_has_segment(c) ? OK : case_lacks(c, (mark){1, 1}, "fem", "fig4");
}
