// app/explain_rod.c
// What the program has understood of a case's rod and 3D segment.
#include "app/chain.h"
#include "app/explain.h"
#include "app/rest_line.h"
#include "app/segment_source.h"
#include "io/number.h"
#include "section/follow.h"

#include <math.h>
#include <string.h>

enum { PATH_SAMPLES = 17, MOST_TENDONS = 8 };

// a path that leaves its first place by less than this over the rod's length is straight
static const double STRAIGHT = 1e-9;

// --- tendons

static void describe_path(const tendon_spec *t, double end, word_list *words)
{
    double first[2], last[2], away = 0;
    chain_tendon_place(t, 0, first);
    for (int i = 0; i < PATH_SAMPLES; i++) {
        chain_tendon_place(t, end * i / (PATH_SAMPLES - 1), last);
        away = fmax(away, hypot(last[0] - first[0], last[1] - first[1]));
    }
    const double small = STRAIGHT * end; // no -0 mm
    for (int k = 0; k < 2; k++) {
        first[k] = fabs(first[k]) < small ? 0 : first[k];
        last[k] = fabs(last[k]) < small ? 0 : last[k];
    }
    if (away < small) {
        word_list_add(words, "along (%.4g, %.4g) mm", 1e3 * first[0], 1e3 * first[1]);
    } else {
        word_list_add(words, "from (%.4g, %.4g) to (%.4g, %.4g) mm", 1e3 * first[0], 1e3 * first[1],
                      1e3 * last[0], 1e3 * last[1]);
    }
}

static void explain_tendon(explanation *e, const rod_case *rc, int i)
{
    const tendon_spec *t = &rc->spec[i];
    char name[RESULT_NAME];
    word_list words = {0};
    chain_tendon_name(rc, i, name);
    describe_path(t, t->end > 0 ? t->end : rc->length, &words);
    if (t->end > 0) {
        word_list_add(&words, "anchored at s = %.6g mm", 1e3 * t->end);
    }
    if (t->friction > 0) {
        word_list_add(&words, "friction %.4g", t->friction);
    }
    if (t->EA > 0) {
        word_list_add(&words, "stretches with EA %.6g N", t->EA);
    }
    explain(e, "rod", "%s: %s", name, words.text);
}

// --- solutions

static void explain_solutions(explanation *e, const rod_case *rc)
{
    word_list words = {0};
    const int n = rod_case_solutions(rc);
    double most = 0;
    for (int i = 0; i < rc->tensions.nrow * rc->tensions.ncol; i++) {
        most = fmax(most, rc->tensions.a[i]); // NAN is passed over
    }
    if (rc->sweep.count > 0) {
        word_list_add(&words, "over %d range%s of sweep", rc->sweep.count, plural(rc->sweep.count));
    }
    if (rc->tensions.nrow > 0) {
        word_list_add(&words, "tensions up to %.6g N", most);
    }
    if (rc->pulls.nrow > 0) {
        word_list_add(&words, "pulled lengths given");
    }
    const int loads = rc->loads.count + rc->line_loads.count;
    if (loads > 0) {
        word_list_add(&words, "%d load%s", loads, plural(loads));
    }
    if (rod_case_has_gravity(rc)) {
        word_list_add(&words, "gravity");
    }
    if (n == 0) {
        explain(e, "rod", "nothing to solve for: no tensions, pulled lengths, loads or sweep");
        return;
    }
    explain(e, "rod", "%d solution%s%s%s; %s", n, plural(n), words.text[0] ? ": " : "", words.text,
            rc->start == START_REST ? "each reached from rest"
                                    : "each reached from the one before it");
}

void explain_rod(explanation *e, const case_data *c)
{
    const rod_case *rc = &c->file.rod;
    const bool moved = mark_given(rc->base.at);
    explain(e, "rod", "%.6g mm, %s at rest, its base %s", 1e3 * rc->length,
            rest_line_is_straight(&rc->rest) ? "straight" : "curved or twisted",
            moved ? "placed by `base`" : "at the origin, looking along z");
    for (int i = 0; i < rc->tendons.count && i < MOST_TENDONS; i++) {
        explain_tendon(e, rc, i);
    }
    if (rc->tendons.count > MOST_TENDONS) {
        explain(e, "rod", "and %d more tendons", rc->tendons.count - MOST_TENDONS);
    }
    explain_solutions(e, rc);
}

// --- the segment

static void describe_loads(const segment_case *sc, word_list *words)
{
    const segment_load *loads = sc->loads.items;
    for (int i = 0; i < sc->loads.count; i++) {
        if (loads[i].name) {
            word_list_add(words, "'%.60s'", loads[i].name);
        } else {
            word_list_add(words, "load %d", i + 1);
        }
    }
}

// whether its plane meshes are made without a library: on grids that hold all along, of images
static bool is_quick(const case_data *c)
{
    const section_case *section = &c->file.section;
    const segment_case *sc = &c->file.fem;
    section_course course = {.one_grid = true};
    section_outline o = {0};
    bool found = false;
    const double from = sc->section_at, to = from + sc->length;
    if (mark_given(section->files.png.at)) {
        return true;
    }
    if (section_outline_at(section, from, &o, &found) != OK ||
        (sc->course == COURSE_ALONG &&
         section_course_between(section, c->materials, from, to, &course) != OK)) {
        status_clear(); // told where the segment is made
    }
    const bool quick =
        found && course.one_grid && section->mesh.kind != MESH_FREE && section_mesh_is_mapped(&o);
    section_outline_free(&o);
    return quick;
}

static void write_effort(explanation *e, const segment_forecast *f, bool tolerance)
{
    char size[40] = "";
    if (f->size > 0) {
        (void)snprintf(size, sizeof size, " of edges up to %.2g mm", 1e3 * f->size);
    }
    explain(e, "fem",
            "elements of order %d%s on %d nodes of the section, %d layers: %lld unknowns%s",
            f->order, size, f->plane_nodes, f->layers, f->dofs,
            tolerance ? " or what the tolerance takes" : "");
    explain(e, "fem",
            f->seconds < 10 ? "method %s: some %.1g s of one core and %.2g GB%s"
                            : "method %s: some %.0f s of one core and %.2g GB%s",
            f->way, f->seconds, 1e-9 * f->bytes, f->fits ? "" : ", more than this machine has");
    if (e->j) {
        json_object(e->j, NULL);
        json_text(e->j, "about", "fem forecast");
        json_integer(e->j, "order", f->order);
        json_integer(e->j, "layers", f->layers);
        json_integer(e->j, "plane_nodes", f->plane_nodes);
        json_integer(e->j, "dofs", f->dofs);
        json_text(e->j, "method", f->way);
        json_real(e->j, "seconds", f->seconds);
        json_real(e->j, "bytes", f->bytes);
        json_flag(e->j, "fits", f->fits);
        json_object_end(e->j);
    }
}

static status explain_effort(explanation *e, const case_data *c)
{
    status st = OK;
    segment_source source = {0};
    segment_forecast f = {0};
    const segment_case *sc = &c->file.fem;
    TRY(segment_source_make(c, &source));
    if (!is_quick(c)) {
        explain(e, "fem", "on a free mesh: its unknowns are known when it is made");
        goto done;
    }
    st = segment_forecast_make(sc, &source, &f);
    TRY(case_place(c, st, sc->at));
    write_effort(e, &f, sc->tolerance > 0);

done:
    segment_source_free(&source);
    return st;
}

status explain_segment(explanation *e, const case_data *c)
{
    static const char *const bases[] = {"clamped", "free to contract", "free"};
    static const char *const tips[] = {"rigid", "E-proportional", "uniform", "free"};
    status st = OK;
    word_list words = {0};
    const segment_case *sc = &c->file.fem;
    describe_loads(sc, &words);
    explain(e, "fem", "%.6g mm from s = %.6g mm on, base %s, tip %s", 1e3 * sc->length,
            1e3 * sc->section_at, bases[sc->base], tips[sc->tip]);
    explain(e, "fem", "%d load%s: %s", sc->loads.count, plural(sc->loads.count), words.text);
    TRY(explain_effort(e, c));

done:
    return st;
}
