// app/chain_rod.c
// Shapes for every row of tensions.
#include "app/chain.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

// tangents for the total bend: 360 steps follow a rod that winds up many times
enum { BEND_SAMPLES = 361 };

// places along the rod where the materials' strains are looked at, ends included
enum { STRAIN_SAMPLES = 61 };

double chain_total_bend(int npose, const pose *shape)
{
    const vec3 base = {{shape[0].R.a[0][2], shape[0].R.a[1][2], shape[0].R.a[2][2]}};
    vec3 before = {{0, 0, 0}}; // direction in which the last tangent left the base's
    double total = 0, sign = 1;
    for (int i = 1; i < npose; i++) {
        const vec3 t = {{shape[i].R.a[0][2], shape[i].R.a[1][2], shape[i].R.a[2][2]}};
        const double along = vec3_dot(t, base);
        const vec3 aside = vec3_sub(t, vec3_scale(along, base));
        const double angle = atan2(vec3_norm(aside), along); // 0 to pi

        // passing the base's tangent or its opposite turns the direction around: unfold there
        sign = vec3_dot(aside, before) < 0 ? -sign : sign;
        const double turns = round((total - sign * angle) / (2 * M_PI));
        total = sign * angle + 2 * M_PI * turns;
        before = vec3_norm(aside) > 0 ? aside : before;
    }
    return fabs(total);
}

// strains, wrench and tensions at the points of the shape
static status follow_shape(const rod_state *r, const rod_result *rods, struct rod_run *run)
{
    status st = OK;
    for (int i = 0; i < rods->npoint; i++) {
        vec6 xi;
        double *tension = run->along + (size_t)i * (size_t)rods->ntendon;
        TRY(rod_strain_at(r, run->s[i], &xi));
        xi.a[2] -= 1;
        memcpy(run->stretch[i], &xi.a[0], sizeof run->stretch[i]);
        memcpy(run->curvature[i], &xi.a[3], sizeof run->curvature[i]);
        TRY(rod_wrench_at(r, run->s[i], &run->wrench[i], tension));
    }

done:
    return st;
}

// --- strains of the materials

typedef struct samples {
    double s[STRAIN_SAMPLES];
    vec6 *wrench; // [solution][STRAIN_SAMPLES] of the sections
} samples;

// K (xi - xi*) at the samples of the solution at hand, docs/theory.md (1.2)
static status sample_wrenches(const rod_state *r, int solution, samples *all)
{
    status st = OK;
    for (int i = 0; i < STRAIN_SAMPLES; i++) {
        vec6 *wrench = &all->wrench[(size_t)solution * STRAIN_SAMPLES + (size_t)i];
        TRY(rod_wrench_at(r, all->s[i], wrench, NULL));
    }

done:
    return st;
}

// the finest of what the laws along the rod were solved on
static section_case on_solved_mesh(const section_case *c, const section_result *r)
{
    section_case out = *c;
    for (int i = 0; i < r->nstation; i++) {
        const mesh_options *o = &r->station[i].mesh;
        out.mesh.order = i == 0 || o->order > out.mesh.order ? o->order : out.mesh.order;
        out.mesh.layers = i == 0 || o->layers > out.mesh.layers ? o->layers : out.mesh.layers;
        out.mesh.finer = i == 0 ? o->finer : fmax(out.mesh.finer, o->finer);
    }
    return out;
}

static status find_strains(const case_data *c, const samples *all, run_result *out)
{
    status st = OK;
    section_strain_place *places = NULL;
    const int n = out->rod.nsolution;
    const section_wrenches_along along = {STRAIN_SAMPLES, all->s, n, all->wrench};
    TRY(TAKE(places, (size_t)n * (size_t)c->nmaterial));
    const section_case solved = on_solved_mesh(&c->file.section, &out->section);
    TRY(section_strain_along(&solved, c->materials, &out->section.along, &along, places));
    for (int i = 0; i < n; i++) {
        struct rod_run *run = &out->rod.run[i];
        TRY(TAKE(run->strain, (size_t)c->nmaterial));
        for (int m = 0; m < c->nmaterial; m++) {
            run->strain[m] = places[(size_t)i * (size_t)c->nmaterial + (size_t)m];
            run->largest_strain = fmax(run->largest_strain, fabs(run->strain[m].value));
        }
    }

done:
    free(places);
    return st;
}

static void keep_solution(const rod_solution *solution, struct rod_run *run)
{
    run->tip = solution->tip;
    run->iterations = solution->iterations;
    run->relative_error = solution->relative_error;
    run->fraction = solution->fraction;
    run->stable = solution->stable;
    run->eigenvalue = solution->eigenvalue;
    run->ncritical = solution->ncritical;
    memcpy(run->critical, solution->critical, sizeof run->critical);
    run->energy = solution->energy;
    run->work = solution->work;
    run->residual = solution->residual;
}

static status solve_run(rod_state *r, const double *tension, rod_result *rods, struct rod_run *run)
{
    status st = OK;
    double s[BEND_SAMPLES];
    pose *samples = NULL;
    rod_solution solution = {.tendon_length = run->tendon_length, .tension = run->tension};
    const rod_request request = {.tension = tension, .cold = true, .stability = true};
    for (int i = 0; i < rods->ntendon; i++) {
        run->pull[i] = NAN;
    }
    TRY(TAKE(samples, BEND_SAMPLES));
    TRY(rod_run_room(rods, run));
    TRY(rod_solve(r, &request, &solution));
    keep_solution(&solution, run);
    TRY(rod_shape(r, rods->npoint, run->s, run->shape));
    TRY(rod_shape(r, BEND_SAMPLES, s, samples));
    TRY(follow_shape(r, rods, run));
    run->total_bend_rad = chain_total_bend(BEND_SAMPLES, samples);

done:
    free(samples);
    return st;
}

static void describe_tendons(const rod_case *rc, rod_result *rods)
{
    const tendon_spec *tendons = rc->tendons.items;
    for (int i = 0; i < rods->ntendon; i++) {
        const tendon_spec *t = &tendons[i];
        const double radius = field_at(&t->radius, 0), angle = field_at(&t->angle, 0);
        char *name = rods->tendon_name[i];
        rods->tendon_base[i][0] = radius * cos(angle) + field_at(&t->x, 0);
        rods->tendon_base[i][1] = radius * sin(angle) + field_at(&t->y, 0);
        if (tendons[i].name) {
            (void)snprintf(name, sizeof rods->tendon_name[i], "%s", tendons[i].name);
        } else {
            (void)snprintf(name, sizeof rods->tendon_name[i], "tendon %d", i + 1);
        }
    }
}

status chain_rods(const command *cmd, const case_data *c, run_result *out)
{
    status st = OK;
    const rod_case *rc = &c->file.rod;
    const rod_options options = {.frame = rc->frame, .tolerance = rc->tolerance};
    const rod_spec spec = {
        .law = &out->section.along, .ntendon = rc->tendons.count, .tendons = rc->tendons.items};
    rod *r = NULL;
    rod_state *state = NULL;
    samples all = {0};
    out->rod_length = rc->length;
    const rod_result sizes = {
        .ntendon = rc->tendons.count, .npoint = rc->points, .nsolution = rc->tensions.nrow};
    TRY(rod_result_make(&sizes, &out->rod));
    describe_tendons(rc, &out->rod);
    TRY(TAKE(all.wrench, (size_t)rc->tensions.nrow * STRAIN_SAMPLES));
    for (int i = 0; i < STRAIN_SAMPLES; i++) {
        all.s[i] = rc->length * i / (STRAIN_SAMPLES - 1);
    }
    TRY(case_place(c, rod_make(&spec, &options, &r), rc->at));
    TRY(rod_state_make(r, &state));
    for (int i = 0; i < rc->tensions.nrow; i++) {
        char words[48];
        (void)snprintf(words, sizeof words, "rod %d of %d", i + 1, rc->tensions.nrow);
        command_progress(cmd, words);
        const double *tension = rc->tensions.a + (size_t)i * (size_t)rc->tensions.ncol;
        st = solve_run(state, tension, &out->rod, &out->rod.run[i]);
        TRY(case_place(c, st, rc->tensions.at));
        TRY(sample_wrenches(state, i, &all));
    }
    TRY(find_strains(c, &all, out));
    out->has_rod = true;

done:
    free(all.wrench);
    rod_state_free(state);
    rod_free(r);
    return st;
}
