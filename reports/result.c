// reports/result.c
#include "reports/result.h"

#include <stdlib.h>

static void free_rods(rod_result *rod)
{
    for (int i = 0; rod->run && i < rod->nsolution; i++) {
        free(rod->run[i].s);
        free(rod->run[i].shape);
        free(rod->run[i].curvature);
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
    mesh_free(&r->section_mesh);
    free_rods(&r->rod);
    mesh_free(&r->segment_plane);
    mesh_free(&r->segment_mesh);
    segment_result_free(&r->segment);
    free(r->compare);
    *r = (run_result){0};
}
