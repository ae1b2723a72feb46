// app/chain_rod.c
// Every solution that the case asks of its rod.
#include "app/chain.h"
#include "app/rod_ask.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

// tangents for the total bend: 360 steps follow a rod that winds up many times
enum { BEND_SAMPLES = 361 };

// places along the rod where the materials' strains are looked at, ends included
enum { STRAIN_SAMPLES = 61 };

// solutions between two lines of progress
enum { PROGRESS_STRIDE = 16 };

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

static void unknown(int n, double *a)
{
    for (int i = 0; i < n; i++) {
        a[i] = NAN;
    }
}

// The tip's derivatives; NAN at a limit point, where they are infinite.
static status find_rates(rod_state *r, double length, const rod_result *rods, struct rod_run *run)
{
    rod_rates *rates = &run->rates;
    const rod_derivatives wanted = {.tension = rates->tension,
                                    .pull = rates->pull,
                                    .load = rates->load,
                                    .tip_space = &rates->space,
                                    .tip_body = &rates->body};
    if (!rods->has_rates) {
        return OK;
    }
    if (run->fraction == 1) {
        return rod_derive(r, length, &wanted);
    }
    unknown(6 * rods->ntendon, rates->tension->a);
    unknown(6 * rods->ntendon, rates->pull->a);
    unknown(6 * rods->nload, rates->load->a);
    unknown(36, &rates->space.a[0][0]);
    unknown(36, &rates->body.a[0][0]);
    return OK;
}

// What the state holds about the solution at hand.
static status keep_answer(rod_state *r, double length, const rod_result *rods, struct rod_run *run)
{
    status st = OK;
    double s[BEND_SAMPLES];
    pose *samples = NULL;
    TRY(TAKE(samples, BEND_SAMPLES));
    TRY(rod_run_room(rods, run));
    TRY(rod_shape(r, rods->npoint, run->s, run->shape));
    TRY(rod_shape(r, BEND_SAMPLES, s, samples));
    TRY(follow_shape(r, rods, run));
    TRY(find_rates(r, length, rods, run));
    run->total_bend_rad = chain_total_bend(BEND_SAMPLES, samples);

done:
    free(samples);
    return st;
}

// A solve that ends at a limit point has an answer, which tells so: run->fraction < 1.
static status solve_run(rod_state *r, const rod_ask *ask, const rod_result *rods,
                        struct rod_run *run)
{
    status st = OK;
    rod_solution solution = {.tendon_length = run->tendon_length, .tension = run->tension};
    memcpy(run->pull, ask->pull, (size_t)rods->ntendon * sizeof *run->pull);
    memcpy(run->load, ask->load, (size_t)rods->nload * sizeof *run->load);
    st = rod_solve(r, &ask->request, &solution);
    if (rod_ask_limited(st, &solution)) {
        status_clear();
        st = OK;
    }
    TRY(st);
    keep_solution(&solution, run);
    if (solution.fraction < 1) {
        run->relative_error = NAN; // no estimate where the tangent is singular
    }
    if (!ask->request.cold) {
        run->work = NAN; // it is that of the way from rest, and this one was another
    }
    TRY(keep_answer(r, ask->rod->length, rods, run));

done:
    return st;
}

// --- all of them

static status solve_all(const command *cmd, const case_data *c, rod_state *state, rod_ask *ask,
                        samples *all, rod_result *rods)
{
    status st = OK;
    for (int i = 0; i < ask->count; i++) {
        char words[48];
        (void)snprintf(words, sizeof words, "rod %d of %d", i + 1, ask->count);
        if (i % PROGRESS_STRIDE == 0) {
            command_progress(cmd, words);
        }
        rod_ask_fill(ask, i);
        // what stopped at a limit point is no place to go on from
        ask->request.cold =
            ask->rod->start == START_REST || i == 0 || rods->run[i - 1].fraction < 1;
        st = solve_run(state, ask, rods, &rods->run[i]);
        TRY(case_place(c, st, rod_case_rows(ask->rod)));
        TRY(sample_wrenches(state, i, all));
    }

done:
    return st;
}

static status make_result(const rod_case *rc, int nsolution, run_result *out)
{
    status st = OK;
    const rod_result sizes = {.ntendon = rc->tendons.count,
                              .npoint = rc->points,
                              .nload = rod_case_loads(rc),
                              .nsolution = nsolution,
                              .has_rates = rc->derivatives};
    out->rod_length = rc->length;
    TRY(rod_result_make(&sizes, &out->rod));
    chain_rod_names(rc, &out->rod);

done:
    return st;
}

status chain_rods(const command *cmd, const case_data *c, run_result *out)
{
    status st = OK;
    const rod_case *rc = &c->file.rod;
    const rod_options options = {.frame = rc->frame, .tolerance = rc->tolerance};
    const rod_spec spec = rod_case_spec(rc, &out->section.along);
    rod *r = NULL;
    rod_state *state = NULL;
    rod_ask ask = {0};
    samples all = {0};
    TRY(rod_ask_make(rc, &ask));
    TRY(make_result(rc, ask.count, out));
    TRY(TAKE(all.wrench, (size_t)ask.count * STRAIN_SAMPLES));
    for (int i = 0; i < STRAIN_SAMPLES; i++) {
        all.s[i] = rc->length * i / (STRAIN_SAMPLES - 1);
    }
    TRY(case_place(c, rod_make(&spec, &options, &r), rc->at));
    TRY(rod_state_make(r, &state));
    TRY(chain_rod_sketch(rc, state, &out->rod));
    TRY(solve_all(cmd, c, state, &ask, &all, &out->rod));
    TRY(find_strains(c, &all, out));
    out->has_rod = true;

done:
    free(all.wrench);
    rod_ask_free(&ask);
    rod_state_free(state);
    rod_free(r);
    return st;
}

status chain_rod_verdict(const case_data *c, const run_result *r)
{
    char where[CONFIG_PLACE_TEXT];
    int limited = 0, first = 0;
    for (int i = r->rod.nsolution - 1; r->has_rod && i >= 0; i--) {
        if (r->rod.run[i].fraction < 1) {
            limited++;
            first = i;
        }
    }
    if (limited == 0) {
        return OK;
    }
    config_place_text(c->config, rod_case_rows(&c->file.rod), where);
    return status_fail(ERR_NUMERIC,
                       "%serror: %d of %d solutions end%s at a limit point, where the rod snaps: "
                       "solution %d at %.6g of its way; `past_limit_points: true` follows the "
                       "equilibria on",
                       where, limited, r->rod.nsolution, limited == 1 ? "s" : "", first + 1,
                       r->rod.run[first].fraction);
}
