// tests/unit/reports/synthetic.h
// A run_result made by hand: the constant-NC tube of the paper with the stiffness that its
// reference gives, a turning pattern along the rod, helices for shapes and beam theory for the
// segment. No room but base and reports is needed.
#pragma once

#include "base/memory.h"
#include "reports/result.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

enum { AROUND = 32, RADIAL = 2, ORDER = 3, LAYERS = 10, SHAPE_POINTS = 81 };

// a polar grid of quads; elements within width / 2 of mid are of material 1
static inline status ring_mesh(double inner, double outer, double mid, double width, mesh *out)
{
    status st = OK;
    mesh m = {0};
    double line[ORDER + 1];
    const int na = AROUND * ORDER, nr = RADIAL * ORDER + 1;
    gauss_lobatto_nodes(ORDER + 1, line);

    TRY(mesh_make(ORDER, na * nr, 1, &(shape){SHAPE_QUAD}, &(int){AROUND * RADIAL}, &m));
    m.dim = 2;
    for (int j = 0; j < nr; j++) {
        for (int i = 0; i < na; i++) {
            const double a = 2 * pi / AROUND * (i / ORDER + 0.5 * (1 + line[i % ORDER]));
            const double t = (j / ORDER + 0.5 * (1 + line[j % ORDER])) / RADIAL;
            const double r = inner + (outer - inner) * (j == nr - 1 ? 1 : t);
            m.xyz[3 * (i + na * j)] = r * cos(a);
            m.xyz[3 * (i + na * j) + 1] = r * sin(a);
        }
    }
    mesh_block *b = &m.block[0];
    for (int k = 0; k < b->nelem; k++) {
        const int ka = k % AROUND, kr = k / AROUND;
        // radius first and angle second, so that corners go counter-clockwise
        for (int v = 0; v <= ORDER; v++) {
            for (int u = 0; u <= ORDER; u++) {
                b->conn[k * b->per_elem + u + (ORDER + 1) * v] =
                    (ka * ORDER + v) % na + na * (kr * ORDER + u);
            }
        }
        const double off = remainder((ka + 0.5) * 2 * pi / AROUND - mid, 2 * pi);
        b->material[k] = fabs(off) < width / 2;
    }
    *out = m;
    m = (mesh){0};

done:
    mesh_free(&m);
    return st;
}

static inline status extruded(double length, segment_body *b)
{
    status st = OK;
    double line[ORDER + 1];
    gauss_lobatto_nodes(ORDER + 1, line);
    b->order = ORDER;
    b->nlayer = LAYERS;
    b->last = b->nlevel = LAYERS * ORDER + 1;
    TRY(TAKE(b->level, (size_t)b->nlevel));
    TRY(TAKE(b->node, 3 * (size_t)b->nlevel * (size_t)b->plane.nnode));
    for (int k = 0; k < b->nlevel; k++) {
        const double t = k == LAYERS * ORDER ? LAYERS : k / ORDER + 0.5 * (1 + line[k % ORDER]);
        b->level[k] = length * t / LAYERS;
        for (int i = 0; i < b->plane.nnode; i++) {
            double *x = b->node + 3 * (i + b->plane.nnode * k);
            x[0] = b->plane.xyz[3 * i];
            x[1] = b->plane.xyz[3 * i + 1];
            x[2] = b->level[k];
        }
    }

done:
    return st;
}

// the constant-NC section's K at the geometric centre, nu = 0.3, theta_m = pi
static inline beam_law tube_law(void)
{
    const double diagonal[6] = {2.13825,          2.86797,           29.213042,
                                81.236041 * 1e-6, 302.039067 * 1e-6, 65.88821 * 1e-6};
    beam_law law = {.area = pi * (16 - 10.24) * 1e-6, .relative_error = 3.2e-8};
    for (int i = 0; i < 6; i++) {
        law.K.a[i][i] = diagonal[i];
    }
    law.K.a[NZ][MY] = law.K.a[MY][NZ] = 62.027360e-3;
    law.K.a[NY][MZ] = law.K.a[MZ][NY] = -1.596017e-3;
    return law;
}

static inline status make_section(run_result *r, bool turning)
{
    status st = OK;
    section_result *s = &r->section;
    r->has_section = true;
    s->effort.meshed = true;
    s->effort.nsolved = 1;
    s->nstation = turning ? 9 : 1;
    TRY(TAKE(s->station, (size_t)s->nstation));
    TRY(law_along_make(r->rod_length, 1, s->nstation, &s->along));
    for (int i = 0; i < s->nstation; i++) {
        section_station *at = &s->station[i];
        at->s = turning ? law_along_node(&s->along, 0, i) : 0;
        const double turn = turning ? pi * at->s / r->rod_length : 0;
        at->law = tube_law();
        s->along.law[i] = at->law;
        s->along.turn[i] = turn;
        at->law.K = beam_law_move(at->law.K, 0, 0, -turn);
        TRY(beam_law_centres(&at->law, &at->centres));
    }
    TRY(ring_mesh(3.2e-3, 4e-3, pi, pi / 8, &r->section_mesh));

done:
    return st;
}

enum { LOADS = 4 };

// a force at the tip fixed in space, a moment half way that turns with the rod, a force along the
// outer half, gravity
static inline void sketch_loads(rod_result *rod, double length)
{
    static const char *const names[LOADS] = {"tip <force>", "twist", "wind", "gravity"};
    rod_load_sketch *l = rod->load_sketch;
    l[0] = (rod_load_sketch){.from = length, .to = length};
    l[1] = (rod_load_sketch){.frame = LOAD_BODY, .from = 0.5 * length, .to = 0.5 * length};
    l[2] = (rod_load_sketch){.kind = LOAD_ALONG_LINE, .from = 0.5 * length, .to = length};
    l[3] = (rod_load_sketch){.kind = LOAD_GRAVITY, .acceleration = {{0, 0, -9.81}}};
    for (int k = 0; k < LOAD_PLACES; k++) {
        l[0].force[k] = (vec3){{0.02, 0, 0}};
        l[1].moment[k] = (vec3){{0, 0, 1e-3}};
        l[2].force[k] = (vec3){{0, 0.1 + 0.02 * k, 0}};
    }
    for (int i = 0; i < LOADS; i++) {
        (void)snprintf(rod->load_name[i], RESULT_NAME, "%s", names[i]);
    }
}

// the left tendon winds half around, the right one ends early
static inline void lay_tendons(rod_result *rod, double length)
{
    for (int k = 0; k < rod->npoint; k++) {
        const double angle = pi * k / (rod->npoint - 1);
        rod->tendon_path[k][0] = -3.6e-3 * cos(angle);
        rod->tendon_path[k][1] = -3.6e-3 * sin(angle);
        rod->tendon_path[rod->npoint + k][0] = 3.6e-3;
        rod->rest[k] = (pose){mat3_identity(), {{0, 0, length * k / (rod->npoint - 1)}}};
    }
    rod->tendon_end[0] = length;
    rod->tendon_end[1] = 0.75 * length;
}

// the tension falls by friction along the left tendon
static inline void carry(const rod_result *rod, struct rod_run *run, int point)
{
    const double part = (double)point / (rod->npoint - 1);
    run->along[2 * point] = run->tension[0] * exp(-0.3 * part);
    run->along[2 * point + 1] = part <= 0.75 ? run->tension[1] : 0;
    run->stretch[point][2] = -0.01 * (run->tension[0] + run->tension[1]);
    run->stretch[point][0] = 1e-3 * part;
    run->wrench[point] = (vec6){{0.02 * part, 0, -run->tension[0] - run->tension[1],
                                 1e-3 * (1 - part), 2e-3 * (1 - part), 1e-4}};
}

static inline status make_rod(run_result *r, int nsolution, double turns, int nload)
{
    status st = OK;
    rod_result *rod = &r->rod;
    r->has_rod = true;
    const rod_result sizes = {
        .ntendon = 2, .npoint = SHAPE_POINTS, .nsolution = nsolution, .nload = nload};
    TRY(rod_result_make(&sizes, rod));
    (void)snprintf(rod->tendon_name[0], sizeof rod->tendon_name[0], "left <b>&");
    (void)snprintf(rod->tendon_name[1], sizeof rod->tendon_name[1], "right");
    lay_tendons(rod, r->rod_length);
    if (nload == LOADS) {
        sketch_loads(rod, r->rod_length);
    }
    for (int i = 0; i < nsolution; i++) {
        struct rod_run *run = &rod->run[i];
        const int side = 2 * i >= nsolution;
        const double tension = 0.33 * (1 + (side ? i - nsolution / 2 : i));
        run->tension[side] = tension;
        run->tendon_length[0] = run->tendon_length[1] = r->rod_length * (1 - 0.01 * tension);
        run->largest_strain = 0.04 * tension;
        run->relative_error = 1e-10;
        run->pull[0] = run->pull[1] = NAN;
        run->fraction = 1;
        run->stable = 1;
        run->eigenvalue = 1 - 0.1 * i;
        run->energy = run->work = 1e-3 * tension * tension;
        for (int k = 0; k < nload; k++) {
            run->load[k] = 1;
        }
        TRY(rod_run_room(rod, run));
        run->shape[0] = pose_identity();
        const double ds = r->rod_length / (SHAPE_POINTS - 1);
        for (int k = 0; k < SHAPE_POINTS; k++) {
            const double angle = turns * pi * k / (SHAPE_POINTS - 1),
                         size = (side ? -9 : 33) * tension;
            run->s[k] = ds * k;
            run->curvature[k][0] = size * sin(angle);
            run->curvature[k][1] = size * cos(angle);
            carry(rod, run, k);
            if (k > 0) {
                const double *w = run->curvature[k];
                run->shape[k] = pose_mul(run->shape[k - 1],
                                         se3_exp((vec6){{0, 0, ds, w[0] * ds, w[1] * ds, 0}}));
            }
        }
        run->tip = run->shape[SHAPE_POINTS - 1];
        run->total_bend_rad = fabs(run->curvature[0][1]) * r->rod_length;
    }

done:
    return st;
}

// tip compliance of a clamped beam: int A^T F A dz with A taking a tip wrench to the section at z,
// Simpson's rule being exact for the quadratic
static inline mat6 beam_tip_compliance(mat6 F, double length)
{
    mat6 sum = {0};
    const double weight[3] = {1.0 / 6, 4.0 / 6, 1.0 / 6};
    for (int i = 0; i < 3; i++) {
        const double arm = length * (1 - 0.5 * i);
        mat6 A = mat6_identity();
        A.a[3][1] = -arm;
        A.a[4][0] = arm;
        sum = mat6_add(sum, mat6_scale(weight[i] * length, mat6_congruence(A, F)));
    }
    return sum;
}

// u and the stress along z of a uniform strain
static inline status make_fields(const segment_body *b, vec6 e, segment_load_result *out)
{
    status st = OK;
    TRY(TAKE(out->displacement, 3 * (size_t)b->nlevel * (size_t)b->plane.nnode));
    TRY(TAKE(out->stress, 6 * (size_t)b->nlevel * (size_t)b->apart.nnode));
    for (int i = 0; i < b->nlevel * b->plane.nnode; i++) {
        const double *p = b->node + 3 * i, z = p[2];
        double *u = out->displacement + 3 * i;
        u[0] = 0.5 * e.a[4] * z * z;
        u[1] = -0.5 * e.a[3] * z * z;
        u[2] = z * (e.a[2] + e.a[3] * p[1] - e.a[4] * p[0]);
    }
    for (int i = 0; i < b->nlevel * b->apart.nnode; i++) {
        const double *p = b->apart.xyz + 3 * (i % b->apart.nnode);
        out->stress[6 * i + 2] = 1e6 * (e.a[2] + e.a[3] * p[1] - e.a[4] * p[0]);
    }

done:
    return st;
}

static inline status make_slices(const run_result *r, vec6 e, vec6 wrench, segment_load_result *out)
{
    status st = OK;
    const double L = r->segment_length;
    TRY(TAKE(out->slice, 21));
    out->nslice = 21;
    for (int i = 0; i < 21; i++) {
        const double s = L * i / 20, end = exp(-60 * s / L) + exp(-60 * (L - s) / L);
        out->slice[i] = (segment_slice){.s = s,
                                        .motion = vec6_scale(s, e),
                                        .resultant = wrench,
                                        .load = wrench,
                                        .strain = vec6_scale(1 - 0.3 * end, e)};
        out->slice[i].resultant.a[2] *= 1 + 1e-9 * i;
    }
    out->balance = 2e-8;

done:
    return st;
}

// an axial force makes the same strain everywhere: u follows in closed form
static inline status make_load(const run_result *r, mat6 F, const char *name, double x,
                               double force, segment_load_result *out)
{
    status st = OK;
    const double L = r->segment_length;
    const vec6 wrench = {{0, 0, force, 0, -x * force, 0}};
    const vec6 e = mat6_mul_vec(F, wrench);
    const vec6 tip = mat6_mul_vec(r->segment.tip_compliance, wrench);

    *out = (segment_load_result){.name = name, .point = {x, 0}, .force = {0, 0, force}};
    memcpy(out->tip_displacement, tip.a, sizeof out->tip_displacement);
    memcpy(out->tip_rotation, tip.a + 3, sizeof out->tip_rotation);
    out->mid_curvature[0] = e.a[3];
    out->mid_curvature[1] = e.a[4];
    out->shortening = -(tip.a[2] + 2.1233e-3 * tip.a[4]);
    out->strain_energy = 0.5 * L * vec6_dot(e, wrench);
    TRY(make_fields(&r->segment.body, e, out));
    TRY(make_slices(r, e, wrench, out));

done:
    return st;
}

static inline status make_segment(run_result *r, double force)
{
    status st = OK;
    segment_result *s = &r->segment;
    mat6 F = {0};
    r->has_segment = true;
    r->segment_length = 20e-3;
    s->middle = tube_law();
    s->dofs = 52000;
    s->stiffness_centre[0] = -2.1163e-3;
    s->relative_error = 4e-4;
    s->residual = 2e-12;
    s->way = WAY_DOUBLING;
    (void)snprintf(s->why, sizeof s->why, "doubling 0.1 s, direct 2 s, iterative 9 s");
    s->rungs = 2;
    s->order = s->mesh_used.order = ORDER;
    s->layers = LAYERS;
    for (int i = 0; i < 6; i++) {
        s->end_length[i] = 1e-4 * (i + 1);
    }
    TRY(ring_mesh(3.2e-3, 4e-3, pi, pi / 8, &s->body.plane));
    TRY(mesh_copy(&s->body.plane, &s->body.apart)); // nodes need not be apart
    TRY(extruded(r->segment_length, &s->body));
    (void)mat6_inverse_spd(s->middle.K, &F);
    s->tip_compliance = beam_tip_compliance(F, r->segment_length);
    for (int i = 0; i < 2; i++) {
        s->step[i] = (segment_step){i ? 52000 : 17000, i ? 0.31 : 0.12, s->tip_compliance};
        s->step[i].tip_compliance.a[0][0] *= i ? 1 : 0.999;
    }
    TRY(TAKE(s->load, 2));
    s->nload = 2;
    TRY(make_load(r, F, "geometric centre", 0, force, &s->load[0]));
    TRY(make_load(r, F, "stiffness centre", -2.1233e-3, force, &s->load[1]));

done:
    return st;
}

static inline status make_compare(run_result *r)
{
    status st = OK;
    static const compare_row rows[3] = {
        {"section: GJ, ours against GetDP", "N mm^2", 65.0000, 65.000001, 1.5e-8, 1e-6,
         "mesh of both", false, true},
        {"rod: tip, linear limit against 3D <FEM>", "mm", 1.234, 1.3, 0.05, 0.01, "end effects",
         false, false},
        {"section: K, ours against CalculiX", "N", 0, 0, 0, 0, "not on this machine", true, false},
    };
    r->has_compare = true;
    r->ncompare = 3;
    TRY(TAKE(r->compare, 3));
    memcpy(r->compare, rows, sizeof rows);

done:
    return st;
}

static const char synthetic_case[] =
    "title: <script>alert('x')</script>\nmaterials: {a: {E_MPa: 1}} # & \"more\"\n";

// turns: of the curvature's direction along the rod, in pi; force: of both segment loads along z
// [N]; nload: 0 or LOADS
static inline status synthetic_loaded_make(int nsolution, double turns, double force, int nload,
                                           run_result *out)
{
    status st = OK;
    run_result *r = out;
    *r = (run_result){.rod_length = 120e-3, .nmaterial = 2};
    (void)snprintf(r->title, sizeof r->title,
                   "<script>alert(1)</script> tube & \"tendons\", Fig. 4");
    (void)snprintf(r->versions, sizeof r->versions, "stiffaxis 0\ncairo 1");
    r->case_length = sizeof synthetic_case - 1;
    TRY(TAKE(r->case_text, sizeof synthetic_case));
    memcpy(r->case_text, synthetic_case, sizeof synthetic_case);
    TRY(TAKE(r->materials, 2));
    r->materials[0] = (material){.name = "soft", .E = 0.66e6, .nu = 0.3, .linear_strain = 0.05};
    r->materials[1] =
        (material){.name = "stiff <i>", .E = 15.93e6, .nu = 0.3, .linear_strain = 0.06};
    TRY(make_section(r, turns != 0));
    TRY(make_rod(r, nsolution, turns, nload));
    TRY(make_segment(r, force));
    TRY(make_compare(r));

done:
    return st;
}

static inline status synthetic_make(int nsolution, double turns, double force, run_result *out)
{
    return synthetic_loaded_make(nsolution, turns, force, 0, out);
}

static inline void synthetic_free(run_result *r)
{
    for (int i = 0; i < r->nmaterial; i++) {
        r->materials[i].name = NULL; // not the result's own here
    }
    run_result_free(r);
}
