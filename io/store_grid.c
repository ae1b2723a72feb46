// io/store_grid.c
#include "io/store_grid_parts.h"

#include "base/memory.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

status grid_write_rows(const grid *g, const char *name, size_t first, size_t n, int kind,
                       size_t width, const void *data)
{
    const hdf5_array rows = {kind, width > 1 ? 2 : 1, {n, width}};
    char full[128];
    (void)snprintf(full, sizeof full, "VTKHDF/%s", name);
    return g->door->rows(g->file, full, first, &rows, data);
}

status grid_make_room(const grid *g, const char *name, size_t n, int kind, size_t width,
                      const char *unit)
{
    const hdf5_array whole = {kind, width > 1 ? 2 : 1, {n, width}};
    char full[128];
    (void)snprintf(full, sizeof full, "VTKHDF/%s", name);
    return g->door->make(g->file, full, &whole, unit);
}

// --- points

// points here of a piece, and the first of them among all
static size_t points_here(const grid *g, int i, size_t *first)
{
    const share s = share_of(&g->piece[i], g->first_rank);
    const size_t n = (size_t)g->piece[i].mesh->nnode;
    *first = g->from[i].point + (size_t)s.level * n;
    return (size_t)(s.last_level - s.level) * n;
}

static status write_points(const grid *g)
{
    status st = OK;
    double *xyz = NULL;
    TRY(grid_make_room(g, "Points", g->from[g->npiece].point, HDF5_REAL, 3, "m"));
    for (int i = 0; i < g->npiece; i++) {
        const store_grid_piece *p = &g->piece[i];
        const double *from = p->layers ? p->layers->xyz : p->mesh->xyz;
        size_t first = 0;
        const size_t n = points_here(g, i, &first);
        free(xyz);
        TRY(TAKE(xyz, 3 * n));
        for (size_t k = 0; k < 3 * n; k++) {
            xyz[k] = from[k] + (p->displacement ? p->displacement[k] : 0);
        }
        TRY(grid_write_rows(g, "Points", first, n, HDF5_REAL, 3, xyz));
    }

done:
    free(xyz);
    return st;
}

// a field's unit stands behind the last _ of its name
static const char *unit_of(const char *name)
{
    const char *last = strrchr(name, '_');
    return last && last[1] ? last + 1 : "-";
}

static status check_field(const grid *g, int k)
{
    const store_field *first = &g->piece[0].field[k];
    const int nc = first->ncomponent;
    for (int i = 0; i < g->npiece; i++) {
        const store_field *f = k < g->piece[i].nfield ? &g->piece[i].field[k] : NULL;
        if (!f || strcmp(f->name, first->name) != 0 || f->ncomponent != nc ||
            (nc != 1 && nc != 3 && nc != 6)) {
            return status_fail(ERR_BUG, "the grid's pieces differ in field %d", k);
        }
    }
    return OK;
}

static status write_field(const grid *g, int k)
{
    status st = OK;
    char name[96];
    double *nothing = NULL;
    const store_field *field = &g->piece[0].field[k];
    const size_t width = (size_t)field->ncomponent;
    TRY(check_field(g, k));
    (void)snprintf(name, sizeof name, "PointData/%s", field->name);
    TRY(grid_make_room(g, name, g->from[g->npiece].point, HDF5_REAL, width, unit_of(field->name)));
    for (int i = 0; i < g->npiece; i++) {
        const double *data = g->piece[i].field[k].data;
        size_t first = 0;
        const size_t n = points_here(g, i, &first);
        if (!data) {
            free(nothing);
            TRY(TAKE(nothing, width * n));
            for (size_t j = 0; j < width * n; j++) {
                nothing[j] = NAN;
            }
        }
        TRY(grid_write_rows(g, name, first, n, HDF5_REAL, width, data ? data : nothing));
    }

done:
    free(nothing);
    return st;
}

status store_grid_write(const hdf5_door *door, hdf5_file *file, bool first_rank, int npiece,
                        const store_grid_piece *pieces)
{
    static const char type[] = "UnstructuredGrid";
    static const int64_t version[2] = {1, 0};
    const hdf5_array pair = {HDF5_LONG, 1, {2}}, word = hdf5_text_of(sizeof type - 1);
    status st = OK;
    grid g = {
        .door = door, .file = file, .first_rank = first_rank, .npiece = npiece, .piece = pieces};
    if (npiece < 1) {
        return status_fail(ERR_BUG, "a grid needs a piece");
    }
    TRY(grid_count(&g));
    TRY(door->put(file, "VTKHDF", "Version", &pair, version));
    TRY(door->put(file, "VTKHDF", "Type", &word, type));
    TRY(grid_write_topology(&g));
    TRY(write_points(&g));
    for (int k = 0; k < pieces[0].nfield; k++) {
        TRY(write_field(&g, k));
    }

done:
    free(g.count);
    free(g.from);
    return st;
}
