// tests/fuzz/fuzz_surface.c
// fuzz_surface SECONDS [SEED]: mutated surfaces of every format. Always a closed surface whose
// distances are finite, or an error of one line.
#include "reach/distance.h"
#include "reach/surface_read.h"

#include "tests/fuzz/mutate.h"
#include "tests/surface_files.h"

static status check_surface(const surface *s)
{
    status st = OK;
    distance_tree *t = NULL;
    TRY(distance_tree_make(s, &t));
    if (!(s->volume > 0) || !isfinite(distance_to(t, (vec3){{0, 0, 0}}).distance)) {
        TRY(status_fail(ERR_BUG, "a surface without volume or distances"));
    }
    for (int i = 0; i < 3 * s->ntriangle; i++) {
        const int other = s->across[i / 3][i % 3];
        if (s->across[other / 3][other % 3] != i || s->triangle[i / 3][i % 3] >= s->nvertex) {
            TRY(status_fail(ERR_BUG, "edges that do not know one another"));
        }
    }

done:
    distance_tree_free(t);
    return st;
}

static status read_surface(const char *directory, const char *name, void *context)
{
    status st = OK;
    char path[512];
    surface s = {0};
    surface_report r;
    (void)context;
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    const surface_options options = {.path = path};
    TRY(surface_read(&options, 1e-3, &s, &r));
    TRY(check_surface(&s));

done:
    surface_free(&s);
    return st;
}

int main(int argc, char **argv)
{
    mutant_seed seeds[2 * FORMS];
    char *bytes[2 * FORMS];
    for (int i = 0; i < 2 * FORMS; i++) {
        made_surface m = {0};
        if (i < FORMS) {
            made_ball(&m, 1, made_round);
        } else {
            made_box(&m, (vec3){{0, 0, 0}}, (vec3){{1e-2, 1e-2, 1e-2}});
        }
        FILE *f = open_memstream(&bytes[i], &seeds[i].count);
        put_surface(f, &m, i % FORMS);
        (void)fclose(f);
        made_free(&m);
        seeds[i].bytes = (const unsigned char *)bytes[i];
    }
    const int bad = mutants_main(
        argc, argv,
        (mutant_plan){.nseed = 2 * FORMS, .seeds = seeds, .suffix = ".stl", .read = read_surface});
    for (int i = 0; i < 2 * FORMS; i++) {
        free(bytes[i]);
    }
    return bad;
}
