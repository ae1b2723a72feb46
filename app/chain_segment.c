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

// the plane mesh and its extrusion, with what the case leaves open chosen by the section's size
static status make_meshes(const case_data *c, run_result *out, int *nlevel, double **level)
{
    status st = OK;
    const section_case *section = &c->file.section;
    double reach = 0;
    TRY(case_place(c, section_reach_at(section, c->file.fem.section_at, &reach), section->at));
    const segment_case sc = segment_choose(&c->file.fem, reach);
    TRY(chain_plane_mesh(c, sc.section_at, sc.order, sc.size, &out->segment_plane));
    TRY(segment_check_size(&sc, out->segment_plane.nnode));
    const extrude_options options = {
        .length = sc.length,
        .layers = sc.layers,
        .grading = sc.grading,
    };
    TRY(mesh_extrude(&out->segment_plane, &options, &out->segment_mesh, level));
    *nlevel = sc.layers * sc.order + 1;

done:
    return st;
}

status chain_segment(const case_data *c, bool displacements, run_result *out)
{
    status st = OK;
    const segment_case *sc = &c->file.fem;
    double *level = NULL;
    double(*point)[2] = NULL;
    int nlevel = 0;
    TRY(make_meshes(c, out, &nlevel, &level));
    TRY(TAKE(point, (size_t)sc->loads.count));
    TRY(resolve_points(c, &out->segment_plane, point));
    const segment_model model = {
        .plane = &out->segment_plane,
        .solid = &out->segment_mesh,
        .nlevel = nlevel,
        .level = level,
        .materials = c->materials,
        .base = sc->base,
        .tip = sc->tip,
    };
    st = segment_solve(&model, sc->loads.count, sc->loads.items, (const double(*)[2])point,
                       displacements, &out->segment);
    TRY(case_place(c, st, sc->at));
    out->has_segment = true;
    out->segment_length = sc->length;
    out->segment_section_at = sc->section_at;
    out->segment_base = sc->base;
    out->segment_tip = sc->tip;

done:
    free(point);
    free(level);
    return st;
}
