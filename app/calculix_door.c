// app/calculix_door.c
#include "app/calculix_door.h"

#include "app/calculix_files.h"
#include "app/outside.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

// its direct solver takes 6 s for 60 thousand unknowns
static const outside_program ccx = {.file = "ccx", .name = "CalculiX", .seconds = 120};

bool calculix_find(char *path, size_t size)
{
    return outside_find(&ccx, path, size);
}

status calculix_version(char *text, size_t size)
{
    static const char *const arguments[] = {"ccx", "-v", NULL};
    status st = OK;
    char directory[OUTSIDE_PATH] = "", line[128];
    FILE *file = NULL;
    text[0] = '\0';
    TRY(outside_enter(&ccx, directory));
    // it ends with an exit code of its own after telling its version
    (void)outside_run(&ccx, directory, arguments, NULL);
    status_clear();
    TRY(outside_open(&ccx, directory, "log.txt", "r", &file));
    while (!text[0] && fgets(line, sizeof line, file)) {
        const char *word = strstr(line, "Version ");
        if (word) {
            word += strlen("Version ");
            (void)snprintf(text, size, "%.*s", (int)strcspn(word, "\n"), word);
        }
    }
    (void)fclose(file);
    if (!text[0]) {
        st = status_fail(ERR_RESOURCE, "CalculiX does not tell its version");
    }

done:
    return outside_leave(directory, st);
}

static status check_ask(const calculix_ask *ask)
{
    const body *b = ask->body;
    if (b->order != 2 || b->plane->order != 2) {
        return status_fail(ERR_INPUT, "CalculiX has no elements of order %d", b->order);
    }
    for (int k = 0; k < b->plane->nblock; k++) {
        for (int e = 0; e < b->plane->block[k].nelem; e++) {
            for (int layer = 0; layer < b->nlayer; layer++) {
                const int at = body_material(b, k, e, layer);
                const material *m = at < 0 ? NULL : &b->spec.materials[at];
                if (m && (m->kind != MATERIAL_ISOTROPIC || m->modulus.at)) {
                    return status_fail(ERR_INPUT, "'%s' is not isotropic and uniform", m->name);
                }
            }
        }
    }
    return OK;
}

// the deck, the run, and the displacements of the tip
static status solve_in(const char *directory, const calculix_problem *p, double *u, double *cpu)
{
    static const char *const arguments[] = {"ccx", "-i", "segment", NULL};
    status st = OK;
    FILE *file = NULL;
    TRY(outside_open(&ccx, directory, "segment.inp", "w", &file));
    st = calculix_write(p, file);
    const status closed = outside_close_written(&ccx, file);
    TRY(st);
    TRY(closed);
    TRY(outside_run(&ccx, directory, arguments, cpu));
    TRY(outside_open(&ccx, directory, "segment.dat", "r", &file));
    st = calculix_read(p, file, u);
    (void)fclose(file);

done:
    return st;
}

status calculix_tip(const calculix_ask *ask, vec6 *motion, double *cpu_seconds)
{
    status st = OK;
    char directory[OUTSIDE_PATH] = "";
    const body *b = ask->body;
    const size_t n = 3 * (size_t)b->plane->nnode;
    level_fit fit = {0};
    double *u = NULL;
    TRY(outside_enter(&ccx, directory));
    TRY(check_ask(ask));
    TRY(level_fit_make(b, b->nlevel - 1, LEVEL_BY_E, &fit));
    TRY(TAKE(u, n * (size_t)ask->nload));
    const calculix_problem p = {
        .body = b,
        .cap = ask->cap,
        .fit = &fit,
        .reduced = ask->reduced,
        .nload = ask->nload,
        .wrench = ask->wrench,
    };
    TRY(solve_in(directory, &p, u, cpu_seconds));
    for (int i = 0; i < ask->nload; i++) {
        motion[i] = level_fit_motion(&fit, u + (size_t)i * n);
    }

done:
    free(u);
    level_fit_free(&fit);
    return outside_leave(directory, st);
}
