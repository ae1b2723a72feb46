// app/variation.c
#include "app/variation.h"

#include "app/rod_ask.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

// sections that are remembered; a fit tries some hundred
enum { MOST_KNOWN = 20000 };

// --- the base

// what met a tolerance is what is used, whatever the values; closed forms have no mesh
static void keep_finest(const section_result *r, mesh_options *mesh)
{
    bool first = true;
    for (int i = 0; i < r->nstation; i++) {
        const mesh_options *o = &r->station[i].mesh;
        if (o->order == 0) {
            continue;
        }
        mesh->order = first || o->order > mesh->order ? o->order : mesh->order;
        mesh->layers = first || o->layers > mesh->layers ? o->layers : mesh->layers;
        mesh->finer = first ? o->finer : fmax(mesh->finer, o->finer);
        mesh->order_chosen = false;
        first = false;
    }
}

static status copy_law(const law_along *from, law_along *to)
{
    status st = OK;
    const int n = from->npanel * from->nnode;
    TRY(law_along_make(from->length, from->npanel, from->nnode, to));
    memcpy(to->edge, from->edge, (size_t)(from->npanel + 1) * sizeof *to->edge);
    memcpy(to->law, from->law, (size_t)n * sizeof *to->law);
    memcpy(to->turn, from->turn, (size_t)n * sizeof *to->turn);
    to->symmetric = from->symmetric;
    to->relative_error = from->relative_error;

done:
    return st;
}

status variation_open(const case_data *base, const section_result *section, variation *out)
{
    status st = OK;
    const section_case *sc = &base->file.section;
    variation v = {.base = base, .mesh = sc->mesh};
    if (section) {
        TRY(copy_law(&section->along, &v.section.along));
    } else {
        TRY(case_place(base, section_along(sc, base->materials, base->length, &v.section), sc->at));
    }
    keep_finest(section ? section : &v.section, &v.mesh);
    *out = v;
    v = (variation){0};

done:
    variation_free(&v);
    return st;
}

void variation_free(variation *v)
{
    section_result_free(&v->section);
    section_known_free(&v->known);
    *v = (variation){0};
}

// --- the case with other values

// Whether a key belongs to what the section's laws do not know. Gravity needs the materials'
// densities too.
static bool only_the_rod(const char *setting)
{
    static const char rod[] = "rod.", length[] = "rod.length", gravity[] = "rod.gravity";
    return strncmp(setting, rod, strlen(rod)) == 0 &&
           strncmp(setting, length, strlen(length)) != 0 &&
           strncmp(setting, gravity, strlen(gravity)) != 0;
}

static bool keeps_section(const case_data *base, const settings *s)
{
    bool keeps = !rod_case_has_gravity(&base->file.rod);
    for (int i = 0; s && i < s->count; i++) {
        keeps = keeps && only_the_rod(s->text[i]);
    }
    return keeps;
}

static status reopen(const case_data *base, const settings *s, bool only_rod, case_data *out)
{
    return case_open(&(case_request){.noverride = s ? s->count : 0,
                                     .overrides = s ? (const char *const *)s->text : NULL,
                                     .allow_scripts = base->allow_scripts,
                                     .again = base->config,
                                     .only_rod = only_rod},
                     out);
}

static status remember(variation *v, const section_known *new)
{
    status st = OK;
    for (int i = 0; i < new->count && v->known.count < MOST_KNOWN; i++) {
        TRY(section_known_add(&v->known, new->key[i], &new->law[i], &new->mesh[i]));
    }

done:
    return st;
}

section_case varied_section(const variation *v, const varied *w)
{
    // where the rod alone was read again, its section is the base's
    section_case sc = w->law == &v->section.along ? v->base->file.section : w->c.file.section;
    sc.mesh.order = v->mesh.order;
    sc.mesh.order_chosen = v->mesh.order_chosen;
    sc.mesh.layers = v->mesh.layers;
    sc.mesh.finer = v->mesh.finer;
    return sc;
}

// on the base's mesh: how fine it is does not depend on the values
static status solve_section(variation *v, varied *w)
{
    status st = OK;
    w->law = &w->section.along;
    section_case sc = varied_section(v, w);
    sc.tolerance = 0;
    sc.stations = (key_rows){0};
    sc.known = &v->known;
    TRY(case_place(&w->c, section_along(&sc, w->c.materials, w->c.length, &w->section), sc.at));
    TRY(remember(v, &w->section.solved));
    v->nsection++;

done:
    return st;
}

static status make_rod(variation *v, varied *w)
{
    status st = OK;
    const rod_case *rc = &w->c.file.rod;
    const rod_options options = {.frame = rc->frame, .tolerance = rc->tolerance};
    const rod_spec spec = rod_case_spec(rc, w->law);
    TRY(case_place(&w->c, rod_make(&spec, &options, &w->rod), rc->at));
    TRY(rod_state_make(w->rod, &w->state));
    v->nrod++;

done:
    return st;
}

// "tendon radius = 5: ..." at the parameter's place; what stood in front of the case's own words
// tells the same setting
static status explain(const case_data *base, status st, const settings *s, mark at)
{
    char words[1024], place[CONFIG_PLACE_TEXT];
    if (st == OK || !s || st == ERR_INTERRUPTED) {
        return st;
    }
    const char *message = status_message(), *own = strstr(message, ": error: ");
    (void)snprintf(words, sizeof words, "%s", own ? own + sizeof ": error: " - 1 : message);
    config_place_text(base->config, at, place);
    status_clear();
    return status_fail(st, "%serror: %s: %s", place, s->about, words);
}

status variation_read(const case_data *base, const settings *s, mark at, case_data *out)
{
    return explain(base, reopen(base, s, keeps_section(base, s), out), s, at);
}

status variation_check(const case_data *base, const settings *s, mark at)
{
    case_data c = {0};
    const status st = variation_read(base, s, at, &c);
    case_free(&c);
    return st;
}

status varied_make(variation *v, const settings *s, mark at, varied *out)
{
    status st = OK;
    *out = (varied){0};
    const bool keeps = keeps_section(v->base, s);
    TRY(reopen(v->base, s, keeps, &out->c));
    TRY(case_need_rod(&out->c));
    out->law = &v->section.along;
    if (!keeps && s && s->count > 0) {
        TRY(solve_section(v, out));
    }
    TRY(make_rod(v, out));
    return OK;

done:
    st = explain(v->base, st, s, at);
    varied_free(out);
    return st;
}

void varied_free(varied *w)
{
    rod_state_free(w->state);
    rod_free(w->rod);
    section_result_free(&w->section);
    case_free(&w->c);
    *w = (varied){0};
}

// --- shapes

static status make_answer(const variation_places *where, int nsolution, variation_answer *out)
{
    status st = OK;
    variation_answer a = {.nsolution = nsolution, .npoint = where->npoint};
    TRY(TAKE(a.tip, (size_t)nsolution));
    TRY(TAKE(a.fraction, (size_t)nsolution));
    TRY(TAKE(a.s, (size_t)where->npoint));
    TRY(TAKE(a.shape, (size_t)nsolution * (size_t)where->npoint));
    *out = a;
    a = (variation_answer){0};

done:
    variation_answer_free(&a);
    return st;
}

static void set_places(const variation_places *where, double length, double *s)
{
    for (int i = 0; i < where->npoint; i++) {
        const bool last = i == where->npoint - 1;
        const double even = last ? length : length * i / (where->npoint - 1);
        s[i] = where->s ? fmin(fmax(where->s[i], 0), length) : even;
    }
}

static status solve_one(varied *w, rod_ask *ask, int solution, int k, variation_answer *out)
{
    status st = OK;
    rod_solution found = {0};
    rod_ask_fill(ask, solution);
    ask->request.stability = false;
    st = rod_solve(w->state, &ask->request, &found);
    if (rod_ask_limited(st, &found)) {
        status_clear();
        st = OK;
    }
    TRY(case_place(&w->c, st, rod_case_rows(&w->c.file.rod)));
    out->tip[k] = found.tip;
    out->fraction[k] = found.fraction;
    for (int i = 0; i < out->npoint; i++) {
        TRY(rod_pose(w->state, out->s[i],
                     &out->shape[(size_t)k * (size_t)out->npoint + (size_t)i]));
    }

done:
    return st;
}

status varied_solve(varied *w, const variation_places *where, bool local, variation_answer *out)
{
    status st = OK;
    rod_ask ask = {0};
    *out = (variation_answer){0};
    TRY(rod_ask_make(&w->c.file.rod, &ask));
    const int n = where->nsolution > 0 ? where->nsolution : ask.count;
    TRY(make_answer(where, n, out));
    set_places(where, w->c.file.rod.length, out->s);
    for (int k = 0; k < n; k++) {
        const int solution = where->solution ? where->solution[k] : k;
        if (solution < 0 || solution >= ask.count) {
            TRY(status_fail(ERR_INPUT, "the rod has no solution %d with this value, but %d of them",
                            solution + 1, ask.count));
        }
        TRY(solve_one(w, &ask, solution, k, out));
    }
    // loads may keep their directions in the world: solved there, then seen from the clamp
    const pose back = ask.request.base ? pose_inverse(ask.base) : pose_identity();
    for (int i = 0; local && i < n * out->npoint; i++) {
        out->shape[i] = pose_mul(back, out->shape[i]);
    }
    for (int k = 0; local && k < n; k++) {
        out->tip[k] = pose_mul(back, out->tip[k]);
    }

done:
    rod_ask_free(&ask);
    if (st != OK) {
        variation_answer_free(out);
    }
    return st;
}

void variation_answer_free(variation_answer *a)
{
    free(a->tip);
    free(a->fraction);
    free(a->s);
    free(a->shape);
    *a = (variation_answer){0};
}

status variation_solve(variation *v, const settings *s, mark at, const variation_places *where,
                       bool local, variation_answer *out)
{
    status st = OK;
    varied w = {0};
    TRY(varied_make(v, s, at, &w));
    st = explain(v->base, varied_solve(&w, where, local, out), s, at);

done:
    varied_free(&w);
    return st;
}
