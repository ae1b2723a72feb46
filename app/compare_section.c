// app/compare_section.c
// The section by us against closed forms, against GetDP and against the middle of the 3D segment.
#include "app/chain.h"
#include "app/compare_rows.h"

#include <math.h>

// Integrals over curved elements of order 3 and 4: their geometry's error, of order 2p, is below
// rounding's sum (docs/theory.md (6.3)). Coarser ones are held to their own error estimate.
static const tolerance closed_integrals = {1e-9, "rounding and the curved elements' geometry"};
static const tolerance closed_rounding = {1e-12, "rounding: two ways to write the same integrals"};
static const char coarse_integrals[] = "three times the section's own error estimate";
enum { ORDER_OF_CLOSED_INTEGRALS = 3 };

// What the end layers leave in the middle of the segment falls with the distance from the ends over
// the section's radius: in bending 0.007, 0.003, 0.001, 0.0004 of the law were measured 1.5, 2.5,
// 3.75 and 5 radii from the ends on the Fig. 4 section (nu 0.3 and 0.45).
static const double layers_at_end = 0.03, layer_radii = 1.5;
static const double middle_floor = 2e-3; // the default 3D mesh, where the layers have died out
static const char middle_reason[] = "end layers that reach the middle of the segment, and its mesh";
// The 3D column's own estimate counts up to this: 1e-3 to 3e-3 is what default meshes have
// (docs/theory.md, section 5).
static const double column_most = 5e-3;
// The column's plane mesh: edges over the radius.
static const double column_size = 0.5;
enum { COLUMN_ORDER = 3 };
static const char law_reason[] = "the estimates of both: section (three times) and 3D column";
static const char coarse_reason[] =
    "at most 5e-3 for a 3D mesh too coarse to tell, and the section";

static bool is_two_material_annulus(const section_outline *o, const material *materials,
                                    annulus_two_materials *out)
{
    if (o->count != 2 || o->items[0].kind != KIND_ANNULUS || o->items[1].kind != KIND_SECTOR ||
        o->items[0].material < 0 || o->items[1].material < 0) {
        return false;
    }
    const outline *ring = &o->items[0], *sector = &o->items[1];
    *out = (annulus_two_materials){
        .outer = ring->outer,
        .inner = ring->inner,
        .mid_angle = sector->mid_angle,
        .width = sector->width,
        .E_soft = materials[ring->material].E,
        .E_stiff = materials[sector->material].E,
    };
    return ring->outer == sector->outer && ring->inner == sector->inner && ring->centre[0] == 0 &&
           ring->centre[1] == 0 && sector->centre[0] == 0 && sector->centre[1] == 0;
}

// our exact integrals over rings and sectors against the paper's formulas as corrected,
// docs/theory.md (2.6)
static status compare_annulus(const annulus_two_materials *a, const beam_law *closed, run_result *r)
{
    status st = OK;
    beam_centres centres;
    TRY(beam_law_centres_near(closed, a->mid_angle, &centres));
    const annulus_closed_form form = annulus_closed(a);
    const double x = form.r_nc * cos(a->mid_angle), y = form.r_nc * sin(a->mid_angle);
    const double distance = hypot(centres.stiffness_centre[0] - x, centres.stiffness_centre[1] - y);

    compare_relative(compare_add(r, "N", "section: EA, integrals against Eq. 18-20"), centres.EA,
                     form.EA, closed_rounding);
    compare_judge(
        compare_add(r, "mm", "section: NC offset, integrals against Eq. 18-20 (of radius)"),
        1e3 * hypot(centres.stiffness_centre[0], centres.stiffness_centre[1]),
        1e3 * fabs(form.r_nc), distance / a->outer, closed_rounding);
    compare_relative(
        compare_add(r, "N mm^2", "section: EI about the symmetry axis, against Eq. 20"),
        1e6 * centres.EI[0], 1e6 * form.EI_centre[0], closed_rounding);
    compare_relative(
        compare_add(r, "N mm^2", "section: EI across the symmetry axis, against Eq. 20"),
        1e6 * centres.EI[1], 1e6 * form.EI_centre[1], closed_rounding);

done:
    return st;
}

// the paper's torsion and shear hold for no section or for axisymmetric ones only: told, not judged
static void compare_classical(const compare_section *section, run_result *r)
{
    beam_centres centres;
    if (r->section_model == MODEL_CLASSICAL &&
        beam_law_centres(&r->section.station[0].law, &centres) == OK) {
        compare_skip(compare_add(r, "N mm^2", "section: GJ, classical against full"),
                     "%.5g against %.5g N mm^2: the paper's Eq. 12 has no warping",
                     1e6 * centres.GJ, 1e6 * section->centres.GJ);
    }
    status_clear();
}

status compare_closed_forms(const case_data *c, const compare_section *section, run_result *r)
{
    status st = OK;
    section_outline outline = {0};
    beam_law closed, meshed;
    beam_centres a, b;
    annulus_two_materials annulus;
    bool done = false, found = false;
    compare_classical(section, r);
    const section_case *of = &c->file.section;
    TRY(case_place(c, section_outline_at(of, section->s, &outline, &found), of->at));
    TRY(found ? section_classical_closed(&outline, c->materials, &closed, &done) : OK);
    if (!done) {
        compare_skip(compare_add(r, "-", "section: mesh against closed forms"),
                     "no closed form covers these shapes");
        goto done;
    }
    if (is_two_material_annulus(&outline, c->materials, &annulus)) {
        TRY(compare_annulus(&annulus, &closed, r));
    }
    TRY(section_classical_mesh(&section->mesh, c->materials, &meshed));
    TRY(beam_law_centres(&closed, &b));
    TRY(beam_law_centres_near(&meshed, b.principal_angle, &a));
    const bool fine = section->mesh.order >= ORDER_OF_CLOSED_INTEGRALS;
    const tolerance t =
        fine ? closed_integrals : (tolerance){compare_section_share(section), coarse_integrals};
    compare_relative(compare_add(r, "N", "section: EA, mesh against closed form"), a.EA, b.EA, t);
    compare_judge(compare_add(r, "mm", "section: NC offset, mesh against closed form (of radius)"),
                  1e3 * hypot(a.stiffness_centre[0], a.stiffness_centre[1]),
                  1e3 * hypot(b.stiffness_centre[0], b.stiffness_centre[1]),
                  compare_centre_distance(a.stiffness_centre, b.stiffness_centre) / section->radius,
                  t);
    for (int i = 0; i < 2; i++) {
        compare_relative(compare_add(r, "N mm^2", "section: EI about %s', mesh against closed form",
                                     i ? "y" : "x"),
                         1e6 * a.EI[i], 1e6 * b.EI[i], t);
    }

done:
    section_outline_free(&outline);
    return st;
}

// what may be left of the end layers in the middle, in bending
static tolerance middle_tolerance(const case_data *c, const compare_section *section)
{
    const double radii = 0.5 * c->file.fem.length / section->radius;
    return (tolerance){middle_floor + layers_at_end * exp(-radii / layer_radii), middle_reason};
}

static tolerance law_tolerance(const compare_section *section, const beam_law *column)
{
    const bool coarse = column->relative_error > column_most;
    return (tolerance){fmin(column->relative_error, column_most) + compare_section_share(section),
                       coarse ? coarse_reason : law_reason};
}

// the moduli differ so much that the column's ends reach its middle: told, not judged
static bool has_no_verdict(const compare_section *section, const beam_law *column)
{
    return section->contrast > COMPARE_MOST_CONTRAST && column->relative_error > column_most;
}

// one number of both laws
static void compare_with_column(const compare_section *section, const beam_law *column,
                                compare_row *row, const double value[2])
{
    if (has_no_verdict(section, column)) {
        compare_skip(row,
                     "%.5g against %.5g %s: no verdict, at a contrast of %.3g the 3D column's "
                     "end layers reach its middle",
                     value[0], value[1], row->unit, section->contrast);
    } else {
        compare_relative(row, value[0], value[1], law_tolerance(section, column));
    }
}

// the matrices as wholes, by the same rule
static void compare_matrices(const compare_section *section, const beam_law *column,
                             compare_row *row)
{
    const double apart = mat6_relative_error(section->full.K, column->K);
    if (has_no_verdict(section, column)) {
        compare_skip(row, "%.2g apart: no verdict, by the same layers", apart);
    } else {
        compare_judge(row, apart, 0, apart, law_tolerance(section, column));
    }
}

// the case's order and size of the 3D segment where it gives them
static status column_plane(const case_data *c, const compare_section *section, mesh *out)
{
    const segment_case *fem = &c->file.fem;
    return chain_plane_mesh(c, section->s, fem->order > 0 ? fem->order : COLUMN_ORDER,
                            fem->size > 0 ? fem->size : column_size * section->radius, out);
}

// The centre that 3D finds is that of the middle's mean curvature: of a body whose section changes
// there it is no section's.
static void compare_centre(const case_data *c, const compare_section *section, run_result *r)
{
    const double *ours = section->centres.stiffness_centre, *found = r->segment.stiffness_centre;
    compare_row *row =
        compare_add(r, "mm", "section: NC, ours against bending-free load (of radius)");
    if (isnan(found[0])) {
        compare_skip(row, "springs or holds on the walls: the middle has no centre of its own");
        return;
    }
    if (c->file.fem.course == COURSE_ALONG && section_varies(&c->file.section)) {
        compare_skip(row, "the section changes along the segment, and so does its centre");
        return;
    }
    compare_judge(row, 1e3 * hypot(ours[0], ours[1]), 1e3 * hypot(found[0], found[1]),
                  compare_centre_distance(ours, found) / section->radius,
                  middle_tolerance(c, section));
}

status compare_section_segment(const case_data *c, const compare_section *section, run_result *r)
{
    status st = OK;
    mesh plane = {0};
    beam_centres fem;
    beam_law law = {0};
    const beam_centres *ours = &section->centres;
    const mat6 *K = &section->full.K, *K_fem = &law.K;
    TRY(column_plane(c, section, &plane));
    TRY(segment_section_law(&plane, c->materials, &law));
    TRY(beam_law_centres_near(&law, ours->principal_angle, &fem));
    const struct {
        const char *name, *unit;
        double value[2]; // ours, FEM
    } rows[] = {
        {"EA", "N", {ours->EA, fem.EA}},
        {"EI about x'", "N mm^2", {1e6 * ours->EI[0], 1e6 * fem.EI[0]}},
        {"EI about y'", "N mm^2", {1e6 * ours->EI[1], 1e6 * fem.EI[1]}},
        {"GJ", "N mm^2", {1e6 * ours->GJ, 1e6 * fem.GJ}},
        {"shear stiffness x", "N", {K->a[NX][NX], K_fem->a[NX][NX]}},
        {"shear stiffness y", "N", {K->a[NY][NY], K_fem->a[NY][NY]}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        compare_with_column(
            section, &law,
            compare_add(r, rows[i].unit, "section: %s, ours (full) against 3D FEM", rows[i].name),
            rows[i].value);
    }
    compare_matrices(section, &law,
                     compare_add(r, "-", "section: whole 6x6, ours (full) against 3D FEM"));
    compare_centre(c, section, r);

done:
    mesh_free(&plane);
    return st;
}
