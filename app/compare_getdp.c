// app/compare_getdp.c
// The section by us against GetDP: torsion, and stretch and bending in generalized plane strain.
#include "app/chain.h"
#include "app/compare_rows.h"
#include "app/getdp_door.h"

#include <math.h>

// GetDP's two meshes: elements through the section's radius. Order-2 elements, and corners where
// materials meet.
static const double coarse = 1.0 / 20, fine = 1.0 / 40;
static const double least = 1e-7; // below this GetDP's rounding and linear solver count
static const double most = 1e-3;  // GetDP's own meshes are not forgiven to differ by more
static const char reason[] = "three times GetDP's difference of two meshes and our estimate";

// `spread`: relative difference of GetDP's two meshes
static tolerance tolerance_of(const compare_section *section, double spread)
{
    const double sum = COMPARE_MARGIN * (fmin(spread, most) + section->error);
    return (tolerance){fmax(least, sum), reason};
}

static status torsion_at(const case_data *c, const compare_section *section, double size,
                         double *GJ)
{
    status st = OK;
    mesh m = {0};
    TRY(chain_plane_mesh(c, section->s, 2, size * section->radius, &m));
    TRY(getdp_torsion(&m, c->nmaterial, c->materials, GJ));

done:
    mesh_free(&m);
    return st;
}

static status compare_torsion(const case_data *c, const compare_section *section, compare_row *row)
{
    status st = OK;
    double GJ[2] = {0};
    TRY(torsion_at(c, section, coarse, &GJ[0]));
    TRY(torsion_at(c, section, fine, &GJ[1]));
    compare_relative(row, 1e6 * section->centres.GJ, 1e6 * GJ[1],
                     tolerance_of(section, fabs(GJ[0] / GJ[1] - 1)));

done:
    return st;
}

// GetDP's stretch and bending as a law: what it leaves out is put in as no coupling and any size
static status plane_strain_at(const case_data *c, const compare_section *section, double size,
                              beam_centres *out)
{
    status st = OK;
    beam_law law = {.K = mat6_identity()};
    mesh m = {0};
    mat3 B;
    TRY(chain_plane_mesh(c, section->s, 2, size * section->radius, &m));
    TRY(getdp_axial_bending(&m, c->nmaterial, c->materials, &B));
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            law.K.a[NZ + i][NZ + j] = (B.a[i][j] + B.a[j][i]) / 2;
        }
    }
    TRY(beam_law_centres_near(&law, section->centres.principal_angle, out));

done:
    mesh_free(&m);
    return st;
}

typedef struct plane_rows {
    compare_row *EA, *centre, *EI[2];
} plane_rows;

static plane_rows add_plane_rows(run_result *r)
{
    return (plane_rows){
        compare_add(r, "N", "section: EA, ours (full) against GetDP in plane strain"),
        compare_add(r, "mm", "section: NC, ours (full) against GetDP in plane strain (of radius)"),
        {compare_add(r, "N mm^2", "section: EI about x', ours (full) against GetDP"),
         compare_add(r, "N mm^2", "section: EI about y', ours (full) against GetDP")},
    };
}

static void skip_plane_rows(const plane_rows *rows, const char *why)
{
    compare_skip(rows->EA, "%s", why);
    compare_skip(rows->centre, "%s", why);
    compare_skip(rows->EI[0], "%s", why);
    compare_skip(rows->EI[1], "%s", why);
}

static status compare_plane(const case_data *c, const compare_section *section,
                            const plane_rows *rows)
{
    status st = OK;
    const beam_centres *ours = &section->centres;
    const double *NC = ours->stiffness_centre;
    beam_centres b[2];
    TRY(plane_strain_at(c, section, coarse, &b[0]));
    TRY(plane_strain_at(c, section, fine, &b[1]));
    compare_relative(rows->EA, ours->EA, b[1].EA,
                     tolerance_of(section, fabs(b[0].EA / b[1].EA - 1)));
    for (int i = 0; i < 2; i++) {
        compare_relative(rows->EI[i], 1e6 * ours->EI[i], 1e6 * b[1].EI[i],
                         tolerance_of(section, fabs(b[0].EI[i] / b[1].EI[i] - 1)));
    }
    const double spread = compare_centre_distance(b[0].stiffness_centre, b[1].stiffness_centre);
    compare_judge(rows->centre, 1e3 * hypot(NC[0], NC[1]),
                  1e3 * hypot(b[1].stiffness_centre[0], b[1].stiffness_centre[1]),
                  compare_centre_distance(NC, b[1].stiffness_centre) / section->radius,
                  tolerance_of(section, spread / section->radius));

done:
    return st;
}

// NULL where GetDP can tell something about the section
static const char *why_not(const compare_section *section)
{
    char path[4096];
    if (!getdp_find(path, sizeof path)) {
        return "getdp is not installed";
    }
    if (!section->isotropic) {
        return "GetDP is given isotropic, uniform materials only";
    }
    return NULL;
}

status compare_getdp(const case_data *c, const compare_section *section, run_result *r)
{
    status st = OK;
    compare_row *torsion = compare_add(r, "N mm^2", "section: GJ, ours (full) against GetDP");
    const plane_rows plane = add_plane_rows(r);
    const char *why = why_not(section);
    if (why) {
        compare_skip(torsion, "%s", why);
        skip_plane_rows(&plane, why);
        return OK;
    }
    if (section->one_poisson) {
        TRY(compare_torsion(c, section, torsion));
    } else { // the scalar warping problem would not hold
        compare_skip(torsion,
                     "Poisson's ratios differ: GetDP's scalar torsion problem does not hold");
    }
    TRY(compare_plane(c, section, &plane));

done:
    return st;
}
