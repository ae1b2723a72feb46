// reports/result.c
#include "reports/result.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

static void free_run(struct rod_run *run)
{
    free(run->tension);
    free(run->pull);
    free(run->tendon_length);
    free(run->load);
    free(run->rates.tension);
    free(run->rates.pull);
    free(run->rates.load);
    free(run->strain);
    free(run->s);
    free(run->shape);
    free(run->curvature);
    free(run->stretch);
    free(run->wrench);
    free(run->along);
}

static void free_rods(rod_result *rod)
{
    for (int i = 0; rod->run && i < rod->nsolution; i++) {
        free_run(&rod->run[i]);
    }
    free(rod->run);
    free(rod->tendon_name);
    free(rod->tendon_base);
    free(rod->tendon_end);
    free(rod->tendon_path);
    free(rod->load_name);
    free(rod->load_sketch);
    free(rod->rest);
}

static status take_run(const rod_result *rod, struct rod_run *run)
{
    status st = OK;
    const size_t nt = (size_t)rod->ntendon, nl = (size_t)rod->nload;
    TRY(TAKE(run->tension, nt));
    TRY(TAKE(run->pull, nt));
    TRY(TAKE(run->tendon_length, nt));
    TRY(TAKE(run->load, nl));
    TRY(TAKE(run->rates.tension, rod->has_rates ? nt : 0));
    TRY(TAKE(run->rates.pull, rod->has_rates ? nt : 0));
    TRY(TAKE(run->rates.load, rod->has_rates ? nl : 0));

done:
    return st;
}

status rod_result_make(const rod_result *sizes, rod_result *out)
{
    status st = OK;
    rod_result r = {.ntendon = sizes->ntendon,
                    .npoint = sizes->npoint,
                    .nload = sizes->nload,
                    .has_rates = sizes->has_rates};
    TRY(TAKE(r.tendon_name, (size_t)r.ntendon));
    TRY(TAKE(r.tendon_base, (size_t)r.ntendon));
    TRY(TAKE(r.tendon_end, (size_t)r.ntendon));
    TRY(TAKE(r.tendon_path, (size_t)r.ntendon * (size_t)r.npoint));
    TRY(TAKE(r.load_name, (size_t)r.nload));
    TRY(TAKE(r.load_sketch, (size_t)r.nload));
    TRY(TAKE(r.rest, (size_t)r.npoint));
    TRY(TAKE(r.run, (size_t)sizes->nsolution));
    r.nsolution = sizes->nsolution;
    for (int i = 0; i < r.nsolution; i++) {
        TRY(take_run(&r, &r.run[i]));
    }
    *out = r;
    r = (rod_result){0};

done:
    free_rods(&r);
    return st;
}

status rod_run_room(const rod_result *rod, struct rod_run *run)
{
    status st = OK;
    const size_t n = (size_t)rod->npoint;
    TRY(TAKE(run->s, n));
    TRY(TAKE(run->shape, n));
    TRY(TAKE(run->curvature, n));
    TRY(TAKE(run->stretch, n));
    TRY(TAKE(run->wrench, n));
    TRY(TAKE(run->along, n * (size_t)rod->ntendon));

done:
    return st;
}

double result_energy_misfit(const struct rod_run *run)
{
    const double most = fmax(fabs(run->energy), fabs(run->work));
    return most > 0 ? fabs(run->energy - run->work) / most : run->energy - run->work;
}

bool result_is_slack(const struct rod_run *run, int tendon)
{
    return !isnan(run->pull[tendon]) && run->tension[tendon] == 0;
}

void run_result_free(run_result *r)
{
    for (int i = 0; r->materials && i < r->nmaterial; i++) {
        free((void *)r->materials[i].name); // const for its readers, ours to free
    }
    for (int i = 0; r->load_name && i < r->segment.nload; i++) {
        free(r->load_name[i]);
    }
    free(r->load_name);
    free(r->materials);
    free(r->case_text);
    section_result_free(&r->section);
    for (int i = 0; i < r->nanswer; i++) {
        section_answers_free(&r->answer[i]);
    }
    free(r->answer);
    free(r->point);
    mesh_free(&r->section_mesh);
    free_rods(&r->rod);
    segment_result_free(&r->segment);
    measured_result_free(&r->measured);
    free(r->compare);
    sensitivity_result_free(&r->sensitivity);
    fit_result_free(&r->fit);
    reach_result_free(&r->reach);
    free(r->fitted_case);
    free(r->designed_case);
    *r = (run_result){0};
}

double result_strain_share(const run_result *r, const struct rod_run *run, int *whose)
{
    int worst = -1;
    double most = -1;
    for (int i = 0; i < r->nmaterial; i++) {
        const double limit = r->materials[i].linear_strain;
        const double strain = run->strain ? fabs(run->strain[i].value) : run->largest_strain;
        if (limit > 0 && strain / limit > most) {
            most = strain / limit;
            worst = i;
        }
    }
    *whose = worst;
    return worst < 0 ? NAN : most;
}

int result_beyond_linear(const run_result *r, const struct rod_run *run)
{
    int worst = -1;
    return result_strain_share(r, run, &worst) > 1 ? worst : -1;
}

const section_answers *result_answers(const run_result *r, int station)
{
    for (int i = 0; i < r->nanswer; i++) {
        if (r->answer[i].station == station) {
            return &r->answer[i];
        }
    }
    return NULL;
}
