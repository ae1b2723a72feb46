// reports/result.c
#include "reports/result.h"

#include <math.h>
#include <stdlib.h>

static void free_rods(rod_result *rod)
{
    for (int i = 0; rod->run && i < rod->nsolution; i++) {
        free(rod->run[i].s);
        free(rod->run[i].shape);
        free(rod->run[i].curvature);
        free(rod->run[i].strain);
    }
    free(rod->run);
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
    mesh_free(&r->segment_plane);
    mesh_free(&r->segment_mesh);
    segment_result_free(&r->segment);
    free(r->compare);
    *r = (run_result){0};
}

int result_beyond_linear(const run_result *r, const struct rod_run *run)
{
    int worst = -1;
    double most = 1;
    for (int i = 0; i < r->nmaterial; i++) {
        const double limit = r->materials[i].linear_strain;
        const double strain = run->strain ? fabs(run->strain[i].value) : run->largest_strain;
        if (limit > 0 && strain / limit > most) {
            most = strain / limit;
            worst = i;
        }
    }
    return worst;
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
