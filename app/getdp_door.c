// app/getdp_door.c
#include "app/getdp_door.h"

#include "app/getdp_files.h"
#include "app/outside.h"

#include <math.h>
#include <string.h>

static const outside_program getdp = {.file = "getdp", .name = "GetDP", .seconds = 120};

bool getdp_find(char *path, size_t size)
{
    return outside_find(&getdp, path, size);
}

typedef struct getdp_problem {
    const char *name; // of its resolution, and before .pro of its file
    int npost;
    const char *post[3]; // its post-processing steps
} getdp_problem;

static const getdp_problem torsion = {"Torsion", 1, {"Torsion"}};
static const getdp_problem plane_strain = {"Plane", 3, {"Plane0", "Plane1", "Plane2"}};

static status write_files(const char *directory, const getdp_problem *problem, const mesh *m,
                          int nmaterial, const material *materials)
{
    status st = OK;
    FILE *file = NULL;
    TRY(outside_open(&getdp, directory, "section.msh", "w", &file));
    getdp_write_mesh(m, file);
    TRY(outside_close_written(&getdp, file));
    TRY(outside_open(&getdp, directory, "problem.pro", "w", &file));
    if (problem == &torsion) {
        getdp_write_torsion(nmaterial, materials, file);
    } else {
        getdp_write_plane(m, nmaterial, materials, file);
    }
    TRY(outside_close_written(&getdp, file));

done:
    return st;
}

static status read_number(const char *directory, const char *name, double *value)
{
    status st = OK;
    FILE *file = NULL;
    double time = 0;
    if (outside_open(&getdp, directory, name, "r", &file) != OK) {
        status_clear();
        return status_fail(ERR_NUMERIC, "GetDP gave no result");
    }
    const int count = fscanf(file, "%lf %lf", &time, value);
    (void)fclose(file);
    if (count != 2 || !isfinite(*value)) {
        return status_fail(ERR_NUMERIC, "GetDP's result %s holds no number", name);
    }
    return st;
}

static status read_torsion(const char *directory, double *GJ)
{
    status st = OK;
    TRY(read_number(directory, "gj.txt", GJ));
    *GJ *= 1e-6; // from N mm^2
    if (!(*GJ > 0)) {
        st = status_fail(ERR_NUMERIC, "GetDP gave no torsional stiffness");
    }

done:
    return st;
}

static status read_plane(const char *directory, mat3 *out)
{
    static const double metres[3] = {1, 1e-3, 1e-3};
    status st = OK;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            char name[32];
            (void)snprintf(name, sizeof name, "k%d%d.txt", i, j);
            TRY(read_number(directory, name, &out->a[i][j]));
            out->a[i][j] *= metres[i] * metres[j];
        }
    }

done:
    return st;
}

// leaves the answers in the directory
static status solve_in(const char *directory, const getdp_problem *problem, const mesh *plane,
                       int nmaterial, const material *materials)
{
    status st = OK;
    const char *arguments[16] = {"getdp",       "problem.pro", "-msh", "section.msh", "-solve",
                                 problem->name, "-v",          "2",    "-pos"};
    mesh lower = {0};
    for (int i = 0, n = 9; i < problem->npost; i++) {
        arguments[n++] = problem->post[i];
    }
    if (plane->order > 2) {
        TRY(mesh_of_order(plane, 2, &lower));
    }
    TRY(write_files(directory, problem, lower.nnode ? &lower : plane, nmaterial, materials));
    TRY(outside_run(&getdp, directory, arguments, NULL));

done:
    mesh_free(&lower);
    return st;
}

status getdp_torsion(const mesh *plane, int nmaterial, const material *materials, double *GJ)
{
    status st = OK;
    char directory[OUTSIDE_PATH] = "";
    TRY(outside_enter(&getdp, directory));
    TRY(solve_in(directory, &torsion, plane, nmaterial, materials));
    TRY(read_torsion(directory, GJ));

done:
    return outside_leave(directory, st);
}

status getdp_axial_bending(const mesh *plane, int nmaterial, const material *materials, mat3 *out)
{
    status st = OK;
    char directory[OUTSIDE_PATH] = "";
    TRY(outside_enter(&getdp, directory));
    TRY(solve_in(directory, &plane_strain, plane, nmaterial, materials));
    TRY(read_plane(directory, out));

done:
    return outside_leave(directory, st);
}

status getdp_version(char *text, size_t size)
{
    static const char *const arguments[] = {"getdp", "-version", NULL};
    status st = OK;
    char directory[OUTSIDE_PATH] = "";
    FILE *file = NULL;
    text[0] = '\0';
    TRY(outside_enter(&getdp, directory));
    TRY(outside_run(&getdp, directory, arguments, NULL));
    TRY(outside_open(&getdp, directory, "log.txt", "r", &file));
    if (!fgets(text, (int)size, file)) {
        st = status_fail(ERR_NUMERIC, "GetDP does not tell its version");
    }
    text[strcspn(text, "\n")] = '\0';
    (void)fclose(file);

done:
    return outside_leave(directory, st);
}
