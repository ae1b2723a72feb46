// app/chain_segment.c
// The 3D segment: meshes of the section and the body on one, loads, solved.
#include "app/case_segment.h"
#include "app/chain.h"
#include "app/segment_points.h"
#include "app/segment_source.h"
#include "base/memory.h"

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

// of a drawing the materials are known with its mesh
static status check_drawing(const case_data *c)
{
    status st = OK;
    mesh m = {0};
    if (c->file.section.drawing && case_segment_accelerates(c)) {
        TRY(chain_plane_mesh(c, c->file.fem.section_at, 0, 0, &m));
        TRY(segment_check_densities(c, &m));
    }

done:
    mesh_free(&m);
    return st;
}

status chain_segment(const case_data *c, bool displacements, run_result *out)
{
    status st = OK;
    const segment_case *sc = &c->file.fem;
    double(*point)[2] = NULL;
    segment_source source = {0};
    TRY(check_drawing(c));
    TRY(segment_source_make(c, &source));
    TRY(TAKE(point, (size_t)sc->loads.count));
    TRY(segment_points(c, point));
    st = segment_solve(sc, &source, (const double(*)[2])point, displacements, &out->segment);
    TRY(case_place(c, st, sc->at));
    out->has_segment = true;
    out->segment_length = sc->length;
    out->segment_section_at = sc->section_at;
    out->segment_base = sc->base;
    out->segment_tip = sc->tip;

done:
    free(point);
    segment_source_free(&source);
    return st;
}
