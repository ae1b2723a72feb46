// meshes/cad.c
#include "meshes/cad.h"

#include "base/door.h"
#include "base/memory.h"
#include "meshes/child.h"
#include "meshes/raw_mesh.h"
#include "meshes/sizing.h"

#include <stdio.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

// A STEP file is read within some seconds, large ones in proportion; a script may take its time.
enum { STEP_SECONDS = 15, STEP_BYTES_PER_SECOND = 50000, SCRIPT_SECONDS = 300 };
static const size_t STEP_MEMORY = (size_t)3 << 30;

// An element's det J may fall to this part of its mean; below, shorter edges are tried.
static const double LEAST_JACOBIAN = 0.1;
enum { MOST_TRIES = 5 };

void cad_source_free(cad_source *s)
{
    input_file_free(&s->file);
    free(s->material);
    *s = (cad_source){0};
}

// --- one run of gmsh

typedef struct work {
    gmsh_door_cad_function read;
    cad_request request;
} work;

static status read_pieces(void *request, void *answer)
{
    const work *w = request;
    return w->read(&w->request, answer);
}

static int list_parts(void *answer, child_part out[CHILD_MOST_PARTS])
{
    cad_pieces *p = answer;
    const child_part all[] = {
        {(void **)&p->body, p->nbody, sizeof *p->body},
        {(void **)&p->xyz, 3 * (int64_t)p->nnode, sizeof *p->xyz},
        {(void **)&p->exact, p->nexact, sizeof *p->exact},
        {(void **)&p->sides, p->nelem, sizeof *p->sides},
        {(void **)&p->body_of, p->nelem, sizeof *p->body_of},
        {(void **)&p->conn, p->nconn, sizeof *p->conn},
    };
    memcpy(out, all, sizeof all);
    return (int)(sizeof all / sizeof *all);
}

static child_job job_of(const cad_source *s, work *w)
{
    const bool script = s->request.script;
    return (child_job){
        .what = "gmsh",
        .seconds =
            script ? SCRIPT_SECONDS : STEP_SECONDS + (int)(s->file.count / STEP_BYTES_PER_SECOND),
        .memory = script ? 0 : STEP_MEMORY,
        .sealed = !script,
        .when_killed = ERR_FILE,
        .request = w,
        .work = read_pieces,
        .answer_size = sizeof(cad_pieces),
        .list = list_parts,
    };
}

static void pieces_free(const cad_source *s, cad_pieces *p)
{
    const child_job job = job_of(s, NULL);
    child_answer_free(&job, p);
}

// The bytes that were looked at, under a name that says nothing; *fd to be closed.
static status put_in_memory(const input_file *f, char path[64], int *fd)
{
    *fd = (int)syscall(SYS_memfd_create, "section", 1u /* closed by a new program */);
    size_t done = 0;
    while (*fd >= 0 && done < f->count) {
        const ssize_t n = write(*fd, f->bytes + done, f->count - done);
        if (n <= 0) {
            break;
        }
        done += (size_t)n;
    }
    (void)snprintf(path, 64, "/proc/self/fd/%d", *fd);
    return done == f->count ? OK : status_fail(ERR_RESOURCE, "no memory for a copy of %s", f->path);
}

// what gmsh said, with the file in front
static status named(const cad_source *s, status st)
{
    char words[512];
    if (st != ERR_FILE && st != ERR_RESOURCE) {
        return st;
    }
    (void)snprintf(words, sizeof words, "%s", status_message());
    status_clear();
    (void)input_file_fail(&s->file, 0, "%s", words);
    return st;
}

static status run(const cad_source *s, const cad_request *request, cad_pieces *out)
{
    status st = OK;
    door_function found = NULL;
    char path[64];
    int fd = -1;
    *out = (cad_pieces){0};
    TRY(door_open("gmsh", "gmsh_door_cad", &found));
    work w = {.read = (gmsh_door_cad_function)found, .request = *request};
    w.request.path = s->file.path; // a script finds what it includes from its own place
    w.request.most_elements = SECTION_MOST_ELEMENTS;
    if (!request->script) {
        TRY(put_in_memory(&s->file, path, &fd));
        w.request.path = path;
    }
    const child_job job = job_of(s, &w);
    st = named(s, child_run(&job, out));
    if (st != OK) {
        pieces_free(s, out);
    }

done:
    if (fd >= 0) {
        (void)close(fd);
    }
    return st;
}

// --- materials

static const char *body_name(const cad_body *b, char text[CAD_NAME])
{
    (void)snprintf(text, CAD_NAME, "%d", b->number);
    return b->name[0] ? b->name : text;
}

// by its colour too, for who wants to name it so
static status body_unknown(const cad_source *s, const cad_body *b, const char *name,
                           const part_table *parts)
{
    char what[48];
    part_table t = *parts;
    (void)snprintf(what, sizeof what, "body of colour #%02x%02x%02x,", b->rgb[0], b->rgb[1],
                   b->rgb[2]);
    t.what = b->coloured ? what : parts->what;
    return part_unknown(&t, &s->file, 0, name);
}

static status find_materials(cad_source *s, const cad_pieces *p, part_table *parts)
{
    status st = OK;
    const char **names = NULL;
    char(*numbers)[CAD_NAME] = NULL;
    TRY(TAKE(s->material, (size_t)p->nbody));
    TRY(TAKE(names, (size_t)p->nbody));
    TRY(TAKE(numbers, (size_t)p->nbody));
    s->nbody = p->nbody;
    for (int i = 0; i < p->nbody; i++) {
        const cad_body *b = &p->body[i];
        names[i] = body_name(b, numbers[i]);
        s->material[i] = part_by_name(parts, names[i]);
        if (s->material[i] == PART_UNKNOWN && b->coloured) {
            s->material[i] = part_by_colour(parts, b->rgb);
        }
        if (s->material[i] == PART_UNKNOWN) {
            TRY(body_unknown(s, b, names[i], parts));
        }
    }
    TRY(parts_all_used(parts, p->nbody, names));

done:
    free(names);
    free(numbers);
    return st;
}

status cad_look(cad_source *s, part_table *parts)
{
    status st = OK;
    cad_pieces p = {0};
    cad_request request = s->request;
    request.look = true;
    request.order = 1;
    TRY(run(s, &request, &p));
    TRY(find_materials(s, &p, parts));

done:
    pieces_free(s, &p);
    return st;
}

// --- meshes

static status check_pieces(const cad_source *s, const cad_pieces *p)
{
    bool good = p->nbody == s->nbody && p->order >= 1 && p->order <= ELEMENT_MAX_ORDER;
    int64_t nconn = 0;
    for (int k = 0; good && k < p->nelem; k++) {
        good = p->body_of[k] >= 0 && p->body_of[k] < p->nbody;
        nconn += element_node_count(p->sides[k] == 4 ? SHAPE_QUAD : SHAPE_TRIANGLE, p->order);
    }
    for (int i = 0; good && i < p->nconn; i++) {
        good = p->conn[i] >= 0 && p->conn[i] < p->nnode;
    }
    return good && nconn == p->nconn ? OK : input_file_fail(&s->file, 0, "gmsh gave no sound mesh");
}

// elements of bodies without material are left out
static status to_raw(const cad_source *s, const cad_pieces *p, raw_mesh *r)
{
    status st = OK;
    *r = (raw_mesh){.file = &s->file, .order = p->order, .unit = s->unit, .nnode = p->nnode};
    TRY(check_pieces(s, p));
    TRY(TAKE(r->xyz, 3 * (size_t)p->nnode));
    TRY(TAKE(r->node_id, (size_t)p->nnode));
    TRY(TAKE(r->elem, (size_t)p->nelem));
    TRY(TAKE(r->conn, (size_t)p->nconn));
    memcpy(r->xyz, p->xyz, 3 * (size_t)p->nnode * sizeof *r->xyz);
    if (p->nexact == 3 * p->nnode) {
        TRY(TAKE(r->exact, (size_t)p->nexact));
        memcpy(r->exact, p->exact, (size_t)p->nexact * sizeof *r->exact);
    }
    for (int i = 0; i < p->nnode; i++) {
        r->node_id[i] = i + 1;
    }
    for (int k = 0, at = 0; k < p->nelem; k++) {
        const shape shape = p->sides[k] == 4 ? SHAPE_QUAD : SHAPE_TRIANGLE;
        const int n = element_node_count(shape, p->order), material = s->material[p->body_of[k]];
        if (material != PART_NONE) {
            r->elem[r->nelem++] = (raw_element){
                .shape = shape, .first = r->nconn, .material = material, .frame = -1, .id = k + 1};
            memcpy(r->conn + r->nconn, p->conn + at, (size_t)n * sizeof *r->conn);
            r->nconn += n;
        }
        at += n;
    }

done:
    return st;
}

static status try_once(const cad_source *s, const cad_request *request, mesh *out, double *least)
{
    status st = OK;
    cad_pieces p = {0};
    raw_mesh r = {0};
    TRY(run(s, request, &p));
    TRY(to_raw(s, &p, &r));
    TRY(raw_mesh_make(&r, out));
    TRY(mesh_min_jacobian(out, least));

done:
    raw_mesh_free(&r);
    pieces_free(s, &p);
    return st;
}

status cad_mesh(const cad_source *s, const mesh_options *options, mesh *out)
{
    status st = OK;
    mesh m = {0};
    double least = -1;
    cad_request request = s->request;
    request.order = options->order;
    request.length = options->size / s->unit;
    request.part = sizing_length(&(mesh_options){.order = options->order}, 1);
    request.angle = sizing_angle(options);
    for (int k = 0; k < MOST_TRIES && !(least >= LEAST_JACOBIAN); k++) {
        mesh_free(&m);
        TRY(try_once(s, &request, &m, &least));
        request.length /= 2;
        request.part /= 2;
        request.angle /= 2;
    }
    if (!(least > 0)) {
        TRY(input_file_fail(&s->file, 0,
                            "gmsh makes inverted elements of it, however short their edges are"));
    }
    TRY(mesh_check(&m));
    *out = m;
    m = (mesh){0};

done:
    mesh_free(&m);
    return st;
}
