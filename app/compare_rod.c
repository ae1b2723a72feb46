// app/compare_rod.c
// The rod in the NC frame against the GC frame, and its linear limit against the 3D segment.
#include "app/compare_rows.h"
#include "base/memory.h"

#include <math.h>

enum { FRAME_POINTS = 61, COMPLIANCE_POINTS = 4 };

// rounding of a shape made of a few hundred exponentials
static const double frame_rounding = 1e-12;

// A clamped base and a rigid cap hold the section's warping and sideways contraction: together they
// take away the compliance of at most half a radius of length (0.13 to 0.42 radii were measured, nu
// 0.3 and 0.45, 3 to 30 radii long).
static const double end_layers = 0.5;

// 0.1 deg on the paper's Fig. 4 segment, where the same force at the rim would turn the tip by 13.5
// deg
static const tolerance pure_compression = {
    0.0075, "0.1 deg on the paper's Fig. 4, scaled by load and size"};

static status frame_shape(const case_data *c, const run_result *r, int frame, const double *tension,
                          pose *shape)
{
    status st = OK;
    const rod_case *rc = &c->file.rod;
    const rod_options options = {.frame = frame, .tolerance = rc->tolerance};
    double s[FRAME_POINTS];
    rod *one = NULL;
    rod_solution solution = {0};
    TRY(rod_make(&r->section.along, rc->tendons.count, rc->tendons.items, &options, &one));
    TRY(rod_solve(one, tension, &solution));
    TRY(rod_shape(one, FRAME_POINTS, s, shape));

done:
    rod_free(one);
    return st;
}

// the largest distance between the two frames' shapes [m]
static status frames_apart(const case_data *c, const run_result *r, const double *tension,
                           double *apart)
{
    status st = OK;
    pose *gc = NULL, *nc = NULL;
    TRY(TAKE(gc, FRAME_POINTS));
    TRY(TAKE(nc, FRAME_POINTS));
    TRY(frame_shape(c, r, FRAME_GC, tension, gc));
    TRY(frame_shape(c, r, FRAME_NC, tension, nc));
    for (int i = 0; i < FRAME_POINTS; i++) {
        *apart = fmax(*apart, vec3_norm(vec3_sub(gc[i].p, nc[i].p)));
    }

done:
    free(gc);
    free(nc);
    return st;
}

status compare_frames(const case_data *c, run_result *r)
{
    status st = OK;
    const rod_case *rc = &c->file.rod;
    double largest = 0;
    compare_row *row =
        compare_add(r, "nm", "rod: largest distance, NC frame to GC frame (of length)");
    if (rc->tensions.nrow == 0) {
        compare_skip(row, "the case has no tensions");
        return OK;
    }
    for (int i = 0; i < rc->tensions.nrow; i++) {
        const double *tension = rc->tensions.a + (size_t)i * (size_t)rc->tensions.ncol;
        TRY(case_place(c, frames_apart(c, r, tension, &largest), rc->tensions.at));
    }
    compare_judge(row, 1e9 * largest, 0, largest / rc->length,
                  (tolerance){fmax(frame_rounding, 2 * rc->tolerance),
                              "each shape is within the rod's own tolerance"});

done:
    return st;
}

static tolerance end_tolerance(const compare_section *section, double length)
{
    return (tolerance){end_layers * section->radius / length,
                       "end layers: the compliance of half a radius of the length"};
}

// the straight prismatic rod of the segment's length and section
static status segment_compliance(const case_data *c, const compare_section *section, mat6 *out)
{
    status st = OK;
    law_along along = {0};
    TRY(law_along_make(c->file.fem.length, 1, 1, &along));
    along.law[0] = section->full;
    TRY(rod_linear_compliance(&along, c->file.fem.length, COMPLIANCE_POINTS, out));

done:
    law_along_free(&along);
    return st;
}

status compare_rod_segment(const case_data *c, const compare_section *section, run_result *r)
{
    static const struct {
        const char *name, *unit;
        double scale;
    } rows[6] = {
        {"sideways x", "mm/N", 1e3},
        {"sideways y", "mm/N", 1e3},
        {"axial", "mm/N", 1e3},
        {"bending x", "rad/(N mm)", 1e-3},
        {"bending y", "rad/(N mm)", 1e-3},
        {"twist", "rad/(N mm)", 1e-3},
    };
    status st = OK;
    mat6 F;
    const mat6 *fem = &r->segment.tip_compliance;
    const tolerance t = end_tolerance(section, c->file.fem.length);
    TRY(segment_compliance(c, section, &F));
    for (int i = 0; i < 6; i++) {
        compare_relative(compare_add(r, rows[i].unit,
                                     "tip compliance %s, rod's linear limit against FEM",
                                     rows[i].name),
                         rows[i].scale * F.a[i][i], rows[i].scale * fem->a[i][i], t);
    }
    const double apart = mat6_relative_error(F, *fem);
    compare_judge(compare_add(r, "-", "tip compliance, whole 6x6, rod's linear limit against FEM"),
                  apart, 0, apart, t);

done:
    return st;
}

// the load of a case as a wrench at the geometric centre
static vec6 load_wrench(const segment_load *load, const double *point)
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

// the angle that this load's largest effect could be: its force and moments at the section's rim
// [rad]
static double angle_scale(const case_data *c, const compare_section *section, vec6 w)
{
    const double moment =
        (fabs(w.a[2]) + hypot(w.a[0], w.a[1]) * c->file.fem.length / section->radius) *
            section->radius +
        hypot(w.a[3], w.a[4]);
    return moment * c->file.fem.length / section->centres.EI[0] +
           fabs(w.a[5]) * c->file.fem.length / section->centres.GJ;
}

status compare_loads(const case_data *c, const compare_section *section, run_result *r)
{
    static const double zero[3] = {0, 0, 0};
    status st = OK;
    mat6 F;
    const double degrees = 180 / M_PI;
    const segment_load *loads = c->file.fem.loads.items;
    const tolerance ends = end_tolerance(section, c->file.fem.length);
    TRY(segment_compliance(c, section, &F));
    for (int i = 0; i < r->segment.nload; i++) {
        const segment_load_result *load = &r->segment.load[i];
        const vec6 wrench = load_wrench(&loads[i], load->point);
        const vec6 beam = mat6_mul_vec(F, wrench);
        const double scale = angle_scale(c, section, wrench);
        if (loads[i].at_kind == 1 && scale > 0 &&
            vec3_norm((vec3){{wrench.a[0], wrench.a[1], 0}}) == 0) {
            compare_judge(compare_add(r, "deg", "load '%.32s': tip angle against 0 (of rim load)",
                                      load->name),
                          degrees * rotation_apart(load->tip_rotation, zero), 0,
                          rotation_apart(load->tip_rotation, zero) / scale, pure_compression);
        } else if (scale > 0) {
            compare_judge(compare_add(r, "deg",
                                      "load '%.32s': tip angle, beam against FEM (of rim load)",
                                      load->name),
                          degrees * rotation_apart(&beam.a[3], zero),
                          degrees * rotation_apart(load->tip_rotation, zero),
                          rotation_apart(&beam.a[3], load->tip_rotation) / scale, ends);
        }
    }

done:
    return st;
}
