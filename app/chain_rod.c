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

static status take_run(int npoint, struct rod_run *run)
{
    status st = OK;
    TRY(TAKE(run->s, (size_t)npoint));
    TRY(TAKE(run->shape, (size_t)npoint));
    TRY(TAKE(run->curvature, (size_t)npoint));

done:
    return st;
}

static status follow_curvature(const rod_state *r, int npoint, struct rod_run *run)
{
    status st = OK;
    for (int i = 0; i < npoint; i++) {
        vec6 xi;
        TRY(rod_strain_at(r, run->s[i], &xi));
        memcpy(run->curvature[i], &xi.a[3], sizeof run->curvature[i]);
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

static status solve_run(rod_state *r, const double *tension, rod_result *rods, struct rod_run *run)
{
    status st = OK;
    double s[BEND_SAMPLES];
    pose *samples = NULL;
    rod_solution solution = {.tendon_length = run->tendon_length};
    TRY(TAKE(samples, BEND_SAMPLES));
    TRY(take_run(rods->npoint, run));
    memcpy(run->tension, tension, (size_t)rods->ntendon * sizeof *tension);
    TRY(rod_solve(r, &(rod_request){.tension = tension, .cold = true}, &solution));
    TRY(rod_shape(r, rods->npoint, run->s, run->shape));
    TRY(rod_shape(r, BEND_SAMPLES, s, samples));
    TRY(follow_curvature(r, rods->npoint, run));
    run->tip = solution.tip;
    run->iterations = solution.iterations;
    run->relative_error = solution.relative_error;
    run->total_bend_rad = chain_total_bend(BEND_SAMPLES, samples);

done:
    free(samples);
    return st;
}

static void describe_tendons(const rod_case *rc, rod_result *rods)
{
    const tendon_spec *tendons = rc->tendons.items;
    rods->ntendon = rc->tendons.count;
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
    if (rc->tendons.count > RESULT_MAX_TENDONS) {
        return config_fail(c->config, rc->tendons.at, "%d tendons: at most %d", rc->tendons.count,
                           RESULT_MAX_TENDONS);
    }
    out->rod_length = rc->length;
    out->rod.npoint = rc->points;
    describe_tendons(rc, &out->rod);
    TRY(TAKE(out->rod.run, (size_t)rc->tensions.nrow));
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
        out->rod.nsolution = i + 1; // from here the result owns what solve_run takes
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
