// app/doctor_steps.c
#include "app/doctor.h"

#include "app/calculix_door.h"
#include "app/examples.h"
#include "app/getdp_door.h"
#include "app/outside.h"
#include "app/save.h"
#include "base/door.h"
#include "measure/gsl_door.h"
#include "reach/embree_door.h"
#include "reach/nlopt_door.h"

#include <math.h>
#include <string.h>

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
    char path[DOCTOR_PATH + 16];
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

static status try_rods(patient *p)
{
    return p->r.section.nstation > 0 ? chain_rods(p->cmd, &p->c, &p->r)
                                     : status_fail(ERR_RESOURCE, "needs the step before");
}

// neither may need it: the steps before this one opened no such library
static status try_without_mpi(patient *p)
{
    char version[64];
    (void)p;
    return library_version(LIBRARY_MPI, version, sizeof version)
               ? status_fail(ERR_BUG, "a section or a rod loaded MPI %s", version)
               : OK;
}

static status try_segment(patient *p)
{
    return p->c.config ? chain_segment(&p->c, false, &p->r)
                       : status_fail(ERR_RESOURCE, "needs the step before");
}

// the same segment once more, by sparse factors
static status try_petsc(patient *p)
{
    static const char *const direct[] = {"fem.method=direct", "fem.order=2", "fem.layers=2"};
    status st = OK;
    char path[DOCTOR_PATH + 16];
    case_data c = {0};
    run_result r = {0};
    (void)snprintf(path, sizeof path, "%s/case.yaml", p->directory);
    TRY(case_open(&(case_request){.path = path, .noverride = 3, .overrides = direct}, &c));
    TRY(chain_about(p->cmd, &c, &r));
    TRY(chain_segment(&c, false, &r));

done:
    run_result_free(&r);
    case_free(&c);
    return st;
}

static status try_store(patient *p)
{
    status st = OK;
    char path[DOCTOR_PATH + 16];
    run_result again = {0};
    (void)snprintf(path, sizeof path, "%s/result.hdf", p->directory);
    TRY(result_store_write(&p->r, path));
    TRY(result_store_read(path, &again));

done:
    run_result_free(&again);
    return st;
}

static status try_page(patient *p)
{
    char path[DOCTOR_PATH + 16];
    (void)snprintf(path, sizeof path, "%s/page", p->directory);
    return save_report(p->cmd, path, &p->r);
}

// Student's t for 10 degrees of freedom, from tables
static status try_gsl(patient *p)
{
    status st = OK;
    const gsl_random_door *door = NULL;
    (void)p;
    TRY(gsl_random_door_open(&door));
    if (fabs(door->student(0.95, 10) - 2.228139) > 1e-6) {
        st = status_fail(ERR_NUMERIC, "a wrong interval");
    }

done:
    return st;
}

static void unit_box(const void *context, int i, double low[3], double high[3])
{
    (void)context;
    for (int a = 0; a < 3; a++) {
        low[a] = i;
        high[a] = i + 1;
    }
}

static double count_visit(void *context, int i)
{
    int *seen = context;
    *seen += i == 1;
    return 0.1;
}

static status try_embree(patient *p)
{
    status st = OK;
    const embree_door *door = NULL;
    box_tree *tree = NULL;
    int seen = 0;
    (void)p;
    TRY(embree_door_open(&door));
    TRY(door->make(2, unit_box, NULL, &tree));
    door->near(tree, (const double[3]){1.5, 1.5, 1.5}, 0.1, count_visit, &seen);
    door->free(tree);
    if (seen != 1) {
        st = status_fail(ERR_NUMERIC, "a box that is near was not found");
    }

done:
    return st;
}

static status parabola(void *context, const double *x, double *score)
{
    double *best = context;
    *score = 1 - (x[0] - 0.25) * (x[0] - 0.25);
    *best = fmax(*best, *score);
    return OK;
}

static status try_nlopt(patient *p)
{
    static const double lower = 0, upper = 1, step = 0.3, resolution = 1e-6;
    status st = OK;
    const nlopt_door *door = NULL;
    double x = 0.9, best = 0;
    const nlopt_job job = {.way = NLOPT_WAY_LOCAL,
                           .n = 1,
                           .lower = &lower,
                           .upper = &upper,
                           .x = &x,
                           .step = &step,
                           .resolution = &resolution,
                           .evaluations = 100,
                           .seed = 1,
                           .score = parabola,
                           .context = &best};
    (void)p;
    TRY(nlopt_door_open(&door));
    TRY(door->maximise(&job));
    if (best < 1 - 1e-6) {
        st = status_fail(ERR_NUMERIC, "the best place was not found");
    }

done:
    return st;
}

static status try_getdp(patient *p)
{
    char version[64];
    const status st = getdp_version(version, sizeof version);
    (void)snprintf(p->told, sizeof p->told, "GetDP %s", version);
    return st;
}

static status try_calculix(patient *p)
{
    char path[DOCTOR_PATH], version[64];
    if (!calculix_find(path, sizeof path)) {
        return status_fail(ERR_RESOURCE, "ccx is not installed");
    }
    const status st = calculix_version(version, sizeof version);
    (void)snprintf(p->told, sizeof p->told, "CalculiX %s", version);
    return st;
}

static status try_mpirun(patient *p)
{
    static const outside_program mpirun = {.file = "mpirun", .name = "mpirun"};
    char path[DOCTOR_PATH];
    if (!outside_find(&mpirun, path, sizeof path)) {
        return status_fail(ERR_RESOURCE, "mpirun is not installed");
    }
    (void)snprintf(p->told, sizeof p->told, "%.79s", path);
    return OK;
}

const doctor_step doctor_steps[] = {
    {"case files",
     try_case,
     true,
     "libyaml-dev libmuparser-dev",
     2,
     {LIBRARY_YAML, LIBRARY_MUPARSER}},
    {"sections",
     try_section,
     true,
     "libsuitesparse-dev libopenblas0-serial",
     2,
     {LIBRARY_CHOLMOD, LIBRARY_BLAS}},
    {"rods", try_rods, true, NULL, 0, {0}},
    {"both without MPI", try_without_mpi, true, NULL, 0, {0}},
    {"free meshes, CAD files", try_free_mesh, true, "libgmsh-dev", 1, {LIBRARY_GMSH}},
    {"3D segment", try_segment, true, NULL, 0, {0}},
    {"3D by sparse factors",
     try_petsc,
     true,
     "petsc-dev",
     3,
     {LIBRARY_PETSC, LIBRARY_MUMPS, LIBRARY_MPI}},
    {"results", try_store, true, "libhdf5-openmpi-dev", 1, {LIBRARY_HDF5}},
    {"figures and the page",
     try_page,
     true,
     "libcairo2-dev libpng-dev",
     3,
     {LIBRARY_CAIRO, LIBRARY_PNG, LIBRARY_THREE}},
    {"fits, Monte Carlo", try_gsl, true, "libgsl-dev", 1, {LIBRARY_GSL}},
    {"reach: tissue surfaces", try_embree, true, "libembree-dev", 1, {LIBRARY_EMBREE}},
    {"design searches", try_nlopt, true, "libnlopt-dev", 1, {LIBRARY_NLOPT}},
    {"compare: torsion by GetDP", try_getdp, false, "getdp", 0, {0}},
    {"compare: 3D by CalculiX", try_calculix, false, "calculix-ccx", 0, {0}},
    {"several processes", try_mpirun, false, "openmpi-bin", 0, {0}},
    {0},
};
