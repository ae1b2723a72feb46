// app/chain_segment.c
// The 3D segment: the section's outline at one place, meshed, extruded, solved.
#include "app/chain.h"
#include "base/memory.h"

#include <string.h>

status chain_plane_mesh(const case_data *c, double s, int order, double size, mesh *out)
{
    status st = OK;
    const section_case *section = &c->file.section;
    mesh_options options = section->mesh;
    options.order = order > 0 ? order : options.order;
    options.size = size > 0 ? size : options.size;
    TRY(case_place(c, section_mesh_with(section, s, &options, out), section->at));

done:
    return st;
}

// where each load acts: at the geometric centre, at a point of the case, or at the section's own
// stiffness centre
static status resolve_points(const case_data *c, const mesh *plane, double (*point)[2])
{
    status st = OK;
    const segment_load *loads = c->file.fem.loads.items;
    beam_law law = {0};
    beam_centres centres = {0};
    bool solved = false;
    for (int i = 0; i < c->file.fem.loads.count; i++) {
        if (loads[i].at_kind == 1 && !solved) {
            TRY(section_full_mesh(plane, c->materials, &law, NULL));
            TRY(beam_law_centres(&law, &centres));
            solved = true;
        }
        if (loads[i].at_kind == 1) {
            memcpy(point[i], centres.stiffness_centre, sizeof point[i]);
        } else if (loads[i].point.nrow > 0) {
            memcpy(point[i], loads[i].point.a, sizeof point[i]);
        }
    }

done:
    return st;
}

typedef struct source_data {
    const case_data *c;
} source_data;

static status source_plane(void *self, const segment_mesh *ask, mesh *out)
{
    const case_data *c = ((const source_data *)self)->c;
    return chain_plane_mesh(c, c->file.fem.section_at, ask->order, ask->size, out);
}

static status extrude(const segment_case *sc, const segment_result *r, run_result *out)
{
    status st = OK;
    const extrude_options options = {
        .length = sc->length, .layers = sc->layers, .grading = sc->grading};
    TRY(mesh_copy(&r->plane, &out->segment_plane));
    TRY(mesh_extrude(&out->segment_plane, &options, &out->segment_mesh, NULL));

done:
    return st;
}

// the load points need a plane mesh before the segment is solved
static status load_points(const case_data *c, const segment_case *sc, double (*point)[2])
{
    status st = OK;
    mesh plane = {0};
    TRY(chain_plane_mesh(c, sc->section_at, sc->order, sc->size, &plane));
    TRY(resolve_points(c, &plane, point));

done:
    mesh_free(&plane);
    return st;
}

status chain_segment(const case_data *c, bool displacements, run_result *out)
{
    status st = OK;
    const segment_case *sc = &c->file.fem;
    double(*point)[2] = NULL;
    source_data self = {c};
    segment_source source = {.self = &self, .plane = source_plane, .materials = c->materials};
    st = section_reach_at(&c->file.section, sc->section_at, &source.radius);
    TRY(case_place(c, st, c->file.section.at));
    TRY(TAKE(point, (size_t)sc->loads.count));
    const segment_case chosen = segment_choose(sc, source.radius);
    TRY(load_points(c, &chosen, point));
    st = segment_solve(sc, &source, (const double(*)[2])point, displacements, &out->segment);
    TRY(case_place(c, st, sc->at));
    TRY(extrude(&chosen, &out->segment, out));
    out->has_segment = true;
    out->segment_length = sc->length;
    out->segment_section_at = sc->section_at;
    out->segment_base = sc->base;
    out->segment_tip = sc->tip;

done:
    free(point);
    return st;
}
