// meshes/free_child.c
#include "meshes/free_child.h"

#include "base/door.h"
#include "meshes/child.h"

#include <string.h>

// a section of a thousand fragments takes some seconds; what takes longer than this is lost
enum { TIME_LIMIT = 30 }; // [s]

typedef struct work {
    gmsh_door_mesh_function mesh;
    plane_request *request;
} work;

static status mesh_pieces(void *request, void *answer)
{
    const work *w = request;
    return w->mesh(w->request, answer);
}

static int list_parts(void *answer, child_part out[CHILD_MOST_PARTS])
{
    plane_pieces *p = answer;
    const child_part all[] = {
        {(void **)&p->xy, 2 * (int64_t)p->nnode, sizeof *p->xy},
        {(void **)&p->corner, 3 * (int64_t)p->ntriangle, sizeof *p->corner},
        {(void **)&p->face, p->ntriangle, sizeof *p->face},
        {(void **)&p->owner, p->nface, sizeof *p->owner},
        {(void **)&p->area, p->nface, sizeof *p->area},
        {(void **)&p->around, p->nface, sizeof *p->around},
        {(void **)&p->segment, 2 * (int64_t)p->nsegment, sizeof *p->segment},
        {(void **)&p->curve, p->nsegment, sizeof *p->curve},
        {(void **)&p->tag, p->ncurve, sizeof *p->tag},
        {(void **)&p->length, p->ncurve, sizeof *p->length},
        {(void **)&p->probe, 2 * CURVE_PROBES * (int64_t)p->ncurve, sizeof *p->probe},
    };
    memcpy(out, all, sizeof all);
    return (int)(sizeof all / sizeof *all);
}

static child_job job_of(work *w)
{
    return (child_job){.what = "the free mesher (gmsh)",
                       .seconds = TIME_LIMIT,
                       .when_killed = ERR_NUMERIC,
                       .request = w,
                       .work = mesh_pieces,
                       .answer_size = sizeof(plane_pieces),
                       .list = list_parts};
}

void plane_pieces_free(plane_pieces *p)
{
    const child_job job = job_of(NULL);
    child_answer_free(&job, p);
}

status free_child_run(plane_request *request, plane_pieces *out)
{
    status st = OK;
    door_function found = NULL;
    TRY(door_open("gmsh", "gmsh_door_mesh", &found));
    work w = {.mesh = (gmsh_door_mesh_function)found, .request = request};
    const child_job job = job_of(&w);
    st = child_run(&job, out);
    if (st != OK) {
        child_answer_free(&job, out);
    }

done:
    return st;
}
