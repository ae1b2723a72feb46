// app/cmd_doctor.c
// stiffaxis doctor: uses every library once on a small problem and tells its version, or why it
// does not work.
#include "app/calculix_door.h"
#include "app/case.h"
#include "app/chain.h"
#include "app/document.h"
#include "app/examples.h"
#include "app/getdp_door.h"
#include "app/interrupt.h"
#include "app/versions.h"
#include "io/disk.h"
#include "io/json.h"
#include "reports/figures.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MAX_PATH = 4096, MAX_LIBRARIES = 3 };

// What the steps share: a private directory, a small case and what came out of it so far.
typedef struct patient {
    const command *cmd;
    char directory[MAX_PATH];
    char outside[80]; // the program that the last step ran
    case_data c;
    run_result r;
} patient;

typedef struct step {
    const char *what;
    status (*try_it)(patient *p);
    bool needed;
    int nlibrary;
    int library[MAX_LIBRARIES];
} step;

static status write_case(const patient *p, char *path, size_t size)
{
    (void)snprintf(path, size, "%s/case.yaml", p->directory);
    const example *e = examples;
    while (e->name && strcmp(e->name, "homogeneous_tube") != 0) {
        e++;
    }
    FILE *file = e->name ? fopen(path, "wx") : NULL;
    const bool written = file && fwrite(e->text, 1, e->length, file) == e->length;
    const bool closed = file && fclose(file) == 0;
    return written && closed ? OK : status_fail(ERR_RESOURCE, "%s: cannot write it", path);
}

static status try_case(patient *p)
{
    status st = OK;
    char path[MAX_PATH + 16];
    TRY(write_case(p, path, sizeof path));
    TRY(case_open(&(case_request){.path = path}, &p->c));
    TRY(chain_about(p->cmd, &p->c, &p->r));

done:
    return st;
}

static status try_section(patient *p)
{
    return p->c.config ? chain_section(&p->c, true, &p->r)
                       : status_fail(ERR_RESOURCE, "needs the step before");
}

static status try_free_mesh(patient *p)
{
    status st = OK;
    mesh m = {0};
    const mesh_options options = {.kind = MESH_FREE, .order = 2};
    TRY(section_mesh_with(&p->c.file.section, 0, &options, &m));

done:
    mesh_free(&m);
    return st;
}

static status try_segment(patient *p)
{
    return p->c.config ? chain_segment(&p->c, false, &p->r)
                       : status_fail(ERR_RESOURCE, "needs the step before");
}

static status try_store(patient *p)
{
    status st = OK;
    char path[MAX_PATH + 16];
    run_result again = {0};
    (void)snprintf(path, sizeof path, "%s/result.hdf", p->directory);
    TRY(result_store_write(&p->r, path));
    TRY(result_store_read(path, &again));

done:
    run_result_free(&again);
    return st;
}

static status try_figures(patient *p)
{
    return figure_section(&p->r, p->directory);
}

static status try_getdp(patient *p)
{
    char version[64];
    const status st = getdp_version(version, sizeof version);
    (void)snprintf(p->outside, sizeof p->outside, "GetDP %s", version);
    return st;
}

static status try_calculix(patient *p)
{
    char version[64];
    const status st = calculix_version(version, sizeof version);
    (void)snprintf(p->outside, sizeof p->outside, "CalculiX %s", version);
    return st;
}

static const step steps[] = {
    {"case files", try_case, true, 2, {LIBRARY_YAML, LIBRARY_MUPARSER}},
    {"sections", try_section, true, 2, {LIBRARY_CHOLMOD, LIBRARY_BLAS}},
    {"free meshes", try_free_mesh, true, 1, {LIBRARY_GMSH}},
    {"3D segment", try_segment, true, 2, {LIBRARY_PETSC, LIBRARY_MUMPS}},
    {"results", try_store, true, 1, {LIBRARY_HDF5}},
    {"figures", try_figures, true, 1, {LIBRARY_CAIRO}},
    {"torsion by GetDP, for compare", try_getdp, false, 0, {0}},
    {"3D by CalculiX, for compare", try_calculix, false, 0, {0}},
};

// "CHOLMOD 3.0.14, OpenBLAS 0.3.21"
static void name_libraries(const patient *p, const step *one, char *text, size_t size)
{
    size_t used = 0;
    text[0] = '\0';
    for (int i = 0; i < one->nlibrary && used < size; i++) {
        char version[64] = "of unknown version";
        (void)library_version(one->library[i], version, sizeof version);
        used += (size_t)snprintf(text + used, size - used, "%s%s %s", i ? ", " : "",
                                 library_name(one->library[i]), version);
    }
    if (one->nlibrary == 0) {
        (void)snprintf(text, size, "%s", p->outside);
    }
}

static void write_step(json *j, FILE *stream, const step *one, const char *versions,
                       const char *why)
{
    if (!j) {
        fprintf(stream, "%-30s %-8s %s%s%s\n", one->what,
                why[0] == '\0' ? "works"
                : one->needed  ? "FAILS"
                               : "missing",
                versions, why[0] ? ": " : "", why);
        return;
    }
    json_object(j, NULL);
    json_text(j, "what", one->what);
    json_text(j, "versions", versions);
    json_flag(j, "works", why[0] == '\0');
    json_flag(j, "needed", one->needed);
    json_text(j, "message", why);
    json_object_end(j);
}

// tries every step; *failed counts the needed ones that do not work
static void try_steps(patient *p, json *j, FILE *stream, int *failed)
{
    for (size_t i = 0; i < sizeof steps / sizeof *steps && !interrupt_pending(); i++) {
        char versions[256], why[1024] = "";
        command_progress(p->cmd, steps[i].what);
        if (steps[i].try_it(p) != OK) {
            (void)snprintf(why, sizeof why, "%s", status_message());
            status_clear();
            *failed += steps[i].needed;
        }
        name_libraries(p, &steps[i], versions, sizeof versions);
        write_step(j, stream, &steps[i], versions, why);
    }
}

static status write_doctor(patient *p, FILE *stream, int *failed)
{
    status st = OK;
    json *j = NULL;
    if (p->cmd->json) {
        TRY(json_open(stream, &j));
        json_object(j, NULL);
        json_text(j, "schema", "stiffaxis/doctor/1");
        json_text(j, "version", STIFFAXIS_VERSION);
        json_array(j, "parts");
    } else {
        fprintf(stream, "stiffaxis " STIFFAXIS_VERSION "\n");
    }
    try_steps(p, j, stream, failed);
    if (j) {
        json_array_end(j);
        json_flag(j, "good", *failed == 0);
        json_object_end(j);
        st = json_close(j);
    }

done:
    return st;
}

static status make_directory(patient *p)
{
    const char *place = getenv("TMPDIR");
    (void)snprintf(p->directory, sizeof p->directory, "%.3000s/stiffaxis-doctor-XXXXXX",
                   place && place[0] == '/' ? place : "/tmp");
    if (!mkdtemp(p->directory)) {
        p->directory[0] = '\0';
        return status_fail(ERR_RESOURCE, "cannot make a temporary directory in %s",
                           place ? place : "/tmp");
    }
    return OK;
}

status cmd_doctor(command *cmd)
{
    status st = OK;
    document d = {0};
    patient *p = calloc(1, sizeof *p);
    int failed = 0;
    if (!p) {
        return status_fail(ERR_RESOURCE, "out of memory");
    }
    p->cmd = cmd;
    interrupt_hold(); // so that the directory does not stay behind
    TRY(make_directory(p));
    TRY(document_begin(&d));
    TRY(write_doctor(p, d.stream, &failed));
    TRY(document_end(&d, cmd, cmd->json ? "doctor.json" : "doctor.txt"));
    if (failed) {
        st = status_fail(ERR_RESOURCE, "%d of the parts that are needed do not work", failed);
    }

done:
    if (p->directory[0]) {
        (void)disk_remove_tree(p->directory);
    }
    document_free(&d);
    run_result_free(&p->r);
    case_free(&p->c);
    free(p);
    const status interrupted = interrupt_release();
    return interrupted != OK ? interrupted : st;
}
