// section/answers.c
#include "section/answers.h"

#include "base/memory.h"
#include "section/kern.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void section_answers_free(section_answers *a)
{
    for (int i = 0; i < a->nload; i++) {
        free(a->load[i].extreme);
        free(a->load[i].strain);
        free(a->load[i].stress);
    }
    free(a->load);
    free(a->kern);
    mesh_free(&a->nodes);
    *a = (section_answers){0};
}

vec6 section_wrench_at_origin(const double *at, const double *force, const double *moment)
{
    const double x = at[0], y = at[1], *n = force, *m = moment;
    return (vec6){{
        n[0],
        n[1],
        n[2],
        m[0] + y * n[2],
        m[1] - x * n[2],
        m[2] + x * n[1] - y * n[0],
    }};
}

// --- what one section is at its arclength

typedef struct cut {
    mesh mesh;
    material *materials; // as they are at s
    double turn_rate;
    section_warping warping; // nnode 0 in the classical model
} cut;

static void cut_free(cut *c)
{
    mesh_free(&c->mesh);
    free(c->materials);
    section_warping_free(&c->warping);
}

static status cut_make(const section_question *q, const section_station *station, cut *c)
{
    status st = OK;
    beam_law unused = {0};
    c->turn_rate = station->turn_rate;
    TRY(TAKE(c->materials, (size_t)q->request->nmaterial));
    for (int i = 0; i < q->request->nmaterial; i++) {
        c->materials[i] = material_at(&q->materials[i], station->s);
    }
    TRY(section_mesh_with(q->request, station->s, &station->mesh, &c->mesh));
    if (q->request->model == MODEL_FULL) {
        TRY(section_turning_mesh(&c->mesh, c->materials, c->turn_rate, &unused, &c->warping));
    }

done:
    return st;
}

static status cut_fields(const section_question *q, const cut *c, const beam_law *law,
                         section_fields *out)
{
    return q->request->model == MODEL_FULL
               ? section_fields_make(&c->mesh, &c->warping, c->turn_rate, out)
               : section_fields_classical(&c->mesh, c->materials, &law->K, out);
}

// --- wrenches

static status keep_fields(const section_fields *f, const material *materials, const vec6 *wrench,
                          section_load_answer *out)
{
    status st = OK;
    TRY(TAKE(out->strain, (size_t)f->mesh.nnode));
    TRY(TAKE(out->stress, (size_t)f->mesh.nnode));
    for (int i = 0; i < f->mesh.nnode; i++) {
        const vec6 strain = section_strain_at(f, i, wrench);
        const vec6 stress = section_stress_at(f, materials, i, &strain);
        memcpy(out->strain[i], strain.a, sizeof strain.a);
        memcpy(out->stress[i], stress.a, sizeof stress.a);
    }

done:
    return st;
}

static void describe(const section_wrench *w, const beam_centres *centres, section_load_answer *out)
{
    (void)snprintf(out->name, sizeof out->name, "%s", w->name);
    memcpy(out->force, w->force, sizeof out->force);
    memcpy(out->moment, w->moment, sizeof out->moment);
    if (w->at_kind == WRENCH_AT_STIFFNESS_CENTRE) {
        memcpy(out->at, centres->stiffness_centre, sizeof out->at);
    } else if (w->point.nrow > 0) {
        memcpy(out->at, w->point.a, sizeof out->at);
    }
}

static status answer_loads(const section_question *q, const cut *c, const section_station *station,
                           section_answers *out)
{
    status st = OK;
    section_fields f = {0};
    const section_wrench *wrenches = q->request->wrenches.items;
    const int n = q->request->wrenches.count;
    TRY(cut_fields(q, c, &station->law, &f));
    TRY(TAKE(out->load, (size_t)n));
    out->nload = n;
    for (int i = 0; i < n; i++) {
        section_load_answer *load = &out->load[i];
        describe(&wrenches[i], &station->centres, load);
        const vec6 wrench = section_wrench_at_origin(load->at, load->force, load->moment);
        TRY(TAKE(load->extreme, (size_t)q->request->nmaterial));
        section_extremes_find(&f, c->materials, q->request->nmaterial, &wrench, load->extreme);
        TRY(q->fields ? keep_fields(&f, c->materials, &wrench, load) : OK);
    }
    if (q->fields) {
        out->nodes = f.mesh; // ownership passes
        f.mesh = (mesh){0};
    }

done:
    section_fields_free(&f);
    return st;
}

status section_answer(const section_question *q, const section_station *station, int index,
                      section_answers *out)
{
    status st = OK;
    cut c = {0};
    section_answers a = {.station = index, .EI_warping = NAN};
    TRY(cut_make(q, station, &c));
    TRY(section_mass_of(&c.mesh, c.materials, &a.mass));
    TRY(section_kern(&c.mesh, &station->law, &a.nkern, &a.kern));
    if (c.warping.nnode > 0) {
        TRY(section_warping_constant(&c.mesh, c.materials, &c.warping, &a.EI_warping));
    }
    if (q->request->wrenches.count > 0) {
        TRY(answer_loads(q, &c, station, &a));
    }
    *out = a;
    a = (section_answers){0};

done:
    section_answers_free(&a);
    cut_free(&c);
    return st;
}
