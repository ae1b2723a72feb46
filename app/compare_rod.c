// app/compare_rod.c
// The rod's linear limit against the 3D segment.
#include "app/beam_models.h"
#include "app/compare_rows.h"

#include <math.h>

// An end that holds the section's sideways contraction (a clamp, a rigid cap) takes away the axial
// and bending compliance of a part of a radius: at most 0.10 radii per end were measured (catheter;
// Fig. 4 at nu 0.3 and 0.45, contrast 1 to 15000, wall 1/5 to 1/50 of the radius); half as much
// again is allowed.
static const double held_end = 0.15;

// A clamped base and a rigid cap hold warping too: in sideways motion and twist 0.13 to 0.42 radii
// for both together (nu 0.3 and 0.45, 3 to 30 radii long, contrast up to 50).
static const double end_layers = 0.5;

// Shorter segments [radii] are all end.
static const double shortest = 4;

// What the 3D mesh may count at most in these rows. Uniform strain and bending between free ends
// are polynomials that cubic elements hold: only their geometry is left, 2e-6 on Fig. 4's default
// mesh.
static const double mesh_most = 5e-3, patch = 1e-4;
enum { PATCH_ORDER = 3 };

// The paper's Fig. 4 calls 0.1 deg no bending: 0.5 N on a segment of 20 mm, 4 mm outside, EI 170.34
// N mm^2 across its axis of symmetry. The same force at the rim would turn the tip by 13.45 deg;
// other loads and sizes are held to the same part of their own such angle.
static const double fig4_angle = 0.1 / 180 * M_PI;
static const double fig4_rim = 0.5 * 4e-3 * 20e-3 / 170.33784e-6;
static const char pure_reason[] = "0.1 deg on the paper's Fig. 4, scaled by load and size";

static bool warping_is_held(const case_data *c)
{
    return c->file.fem.base == BASE_CLAMPED && c->file.fem.tip == TIP_RIGID;
}

// Whether the fitted sideways motion and twist of the tip can be judged; else `why` says why not. A
// section without preferred axes keeps its mean motion free of warping.
static bool can_judge_sideways(const case_data *c, const compare_section *section, const char **why)
{
    if (section->contrast > COMPARE_MOST_CONTRAST) {
        *why = "no verdict: moduli this far apart have end layers many radii long";
        return false;
    }
    *why = "no verdict: the fitted motion of a free, warped end contains its warping";
    return warping_is_held(c) || section->centres.isotropic;
}

static double radii_long(const case_data *c, const compare_section *section)
{
    return c->file.fem.length / section->radius;
}

// of axial and bending compliances; ends that are free to contract leave these exact where the
// materials share one Poisson's ratio
static tolerance axial_tolerance(const case_data *c, const compare_section *section,
                                 const run_result *r)
{
    const int held = (c->file.fem.base == BASE_CLAMPED || !section->one_poisson) +
                     (c->file.fem.tip == TIP_RIGID || !section->one_poisson);
    const int order = c->file.fem.order;
    const bool cubic = order == 0 || order >= PATCH_ORDER;
    const double mesh = fmin(r->segment.relative_error + section->error, mesh_most);
    if (held == 0) {
        return (tolerance){cubic ? fmin(patch + section->error, mesh_most) : mesh,
                           "exact between free ends with one Poisson's ratio: the meshes' own"};
    }
    return (tolerance){held * held_end / radii_long(c, section) + mesh,
                       "ends that hold the section: 0.15 radii of length each, and the mesh"};
}

static tolerance sideways_tolerance(const case_data *c, const compare_section *section)
{
    return (tolerance){end_layers / radii_long(c, section),
                       "end layers: the compliance of half a radius of the length"};
}

// The straight rod of the segment's length, whose law knows all: NULL where there is none, which
// the table of models has told.
static const mat6 *rod_compliance(const run_result *r)
{
    const model_check *m = &r->models.model[BEAM_TURNING];
    return r->models.there && !m->why[0] ? &m->compliance : NULL;
}

// F with the axial and bending entries of `fem`
static mat6 axial_bending_only(const mat6 *F, const mat6 *fem)
{
    mat6 part = *F;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            if (i >= NZ && i <= MY && j >= NZ && j <= MY) {
                part.a[i][j] = fem->a[i][j];
            }
        }
    }
    return part;
}

static void compare_whole(const case_data *c, const compare_section *section, const mat6 *F,
                          run_result *r)
{
    const mat6 *fem = &r->segment.tip_compliance;
    const char *why = NULL;
    const mat6 part = axial_bending_only(fem, F);
    const double block = mat6_relative_error(part, *fem), apart = mat6_relative_error(*F, *fem);
    compare_judge(
        compare_add(r, "-", "tip compliance, axial and bending block, rod's limit against FEM"),
        block, 0, block, axial_tolerance(c, section, r));
    compare_row *row =
        compare_add(r, "-", "tip compliance, whole 6x6, rod's linear limit against FEM");
    if (can_judge_sideways(c, section, &why)) {
        compare_judge(row, apart, 0, apart, sideways_tolerance(c, section));
    } else {
        compare_skip(row, "%.2g apart; %s", apart, why);
    }
}

static bool too_short(const case_data *c, const compare_section *section, run_result *r)
{
    if (radii_long(c, section) >= shortest) {
        return false;
    }
    compare_skip(compare_add(r, "-", "segment: rod's linear limit against FEM"),
                 "no verdict: %.2g radii long, below %g a segment is all end layers",
                 radii_long(c, section), shortest);
    return true;
}

void compare_rod_segment(const case_data *c, const compare_section *section, run_result *r)
{
    static const struct {
        const char *name, *unit;
        double scale;
        bool sideways;
    } rows[6] = {
        {"sideways x", "mm/N", 1e3, true},
        {"sideways y", "mm/N", 1e3, true},
        {"axial", "mm/N", 1e3, false},
        {"bending x", "rad/(N mm)", 1e-3, false},
        {"bending y", "rad/(N mm)", 1e-3, false},
        {"twist", "rad/(N mm)", 1e-3, true},
    };
    const char *why = NULL;
    const mat6 *fem = &r->segment.tip_compliance, *F = rod_compliance(r);
    const bool judge = can_judge_sideways(c, section, &why);
    if (!F || too_short(c, section, r)) {
        return;
    }
    for (int i = 0; i < 6; i++) {
        const double ours = rows[i].scale * F->a[i][i], other = rows[i].scale * fem->a[i][i];
        compare_row *row = compare_add(
            r, rows[i].unit, "tip compliance %s, rod's linear limit against FEM", rows[i].name);
        if (rows[i].sideways && !judge) {
            compare_skip(row, "%.4g against %.4g; %s", ours, other, why);
        } else {
            compare_relative(row, ours, other,
                             rows[i].sideways ? sideways_tolerance(c, section)
                                              : axial_tolerance(c, section, r));
        }
    }
    compare_whole(c, section, F, r);
}

// the load of a case as a wrench at the geometric centre
vec6 compare_load_wrench(const segment_load *load, const double *point)
{
    const double *f = load->force, *m = load->moment;
    return (vec6){{f[0], f[1], f[2], m[0] + point[1] * f[2], m[1] - point[0] * f[2],
                   m[2] + point[0] * f[1] - point[1] * f[0]}};
}

static double rotation_apart(const double *a, const double *b)
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

// The angle that this load's force would give at the section's rim, with its moments [rad]. The
// larger of the two bending stiffnesses: the smaller angle, the tighter limit.
static double rim_angle(const case_data *c, const compare_section *section,
                        const segment_load *load, vec6 w)
{
    const double length = c->file.fem.length;
    const double moment = fabs(w.a[NZ]) * section->radius + hypot(w.a[NX], w.a[NY]) * length +
                          hypot(load->moment[0], load->moment[1]);
    return moment * length / fmax(section->centres.EI[0], section->centres.EI[1]) +
           fabs(w.a[MZ]) * length / section->centres.GJ;
}

bool compare_acts_on_tip_only(const segment_load *load)
{
    static const double none[3] = {0, 0, 0};
    return load->pressures.count == 0 && rotation_apart(load->body_force, none) == 0 &&
           rotation_apart(load->acceleration, none) == 0 && !mark_given(load->tip_motion.at) &&
           !load->holds_move;
}

static bool is_pure_compression(const segment_load *load)
{
    const double *f = load->force, *m = load->moment;
    return load->at_kind == 1 && f[0] == 0 && f[1] == 0 && m[0] == 0 && m[1] == 0 && m[2] == 0;
}

// the beam's angle against the segment's: what the ends may take of it, and what counts as no angle
static void compare_angle(const case_data *c, const compare_section *section, const double *beam,
                          const double *fem, double rim, bool sideways, run_result *r,
                          compare_row *row)
{
    static const double zero[3] = {0, 0, 0};
    const double degrees = 180 / M_PI, angle = rotation_apart(beam, zero);
    const char *why = NULL;
    if (sideways && !can_judge_sideways(c, section, &why)) {
        compare_skip(row, "%.4g against %.4g deg; %s", degrees * angle,
                     degrees * rotation_apart(fem, zero), why);
        return;
    }
    const tolerance ends =
        sideways ? sideways_tolerance(c, section) : axial_tolerance(c, section, r);
    compare_judge(row, degrees * angle, degrees * rotation_apart(fem, zero),
                  rotation_apart(beam, fem) / rim,
                  (tolerance){ends.value * angle / rim + fig4_angle / fig4_rim,
                              "the ends' part of the beam's angle, and Fig. 4's 0.1 deg scaled"});
}

void compare_loads(const case_data *c, const compare_section *section, run_result *r)
{
    static const double zero[3] = {0, 0, 0};
    const mat6 *F = rod_compliance(r);
    const segment_load *loads = c->file.fem.loads.items;
    if (!F || radii_long(c, section) < shortest) {
        return;
    }
    for (int i = 0; i < r->segment.nload; i++) {
        const segment_load_result *load = &r->segment.load[i];
        const vec6 w = compare_load_wrench(&loads[i], load->point);
        const vec6 beam = mat6_mul_vec(*F, w);
        const double rim = rim_angle(c, section, &loads[i], w);
        const double turned = rotation_apart(load->tip_rotation, zero);
        if (!(rim > 0) || !compare_acts_on_tip_only(&loads[i])) {
            continue;
        }
        if (is_pure_compression(&loads[i])) {
            compare_judge(compare_add(r, "deg", "load '%.32s': tip angle against 0 (of rim load)",
                                      load->name),
                          180 / M_PI * turned, 0, turned / rim,
                          (tolerance){fig4_angle / fig4_rim, pure_reason});
        } else {
            const bool sideways = w.a[NX] != 0 || w.a[NY] != 0 || w.a[MZ] != 0;
            compare_angle(c, section, &beam.a[3], load->tip_rotation, rim, sideways, r,
                          compare_add(r, "deg",
                                      "load '%.32s': tip angle, beam against FEM (of rim load)",
                                      load->name));
        }
    }
}
