// reports/passage.c
#include "reports/passage.h"

#include "base/memory.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

passage_name passage_join(const char *group, const char *tail)
{
    passage_name n;
    (void)snprintf(n.text, sizeof n.text, "%s/%s", group, tail);
    return n;
}

status passage_damaged(const passage *p, const char *name, const char *words)
{
    return status_fail(ERR_FILE, "%s: damaged: '%s' %s", p->path, name, words);
}

status passage_room(const passage *p, void **array, size_t n, size_t size)
{
    return p->reading ? memory_take(array, n, size) : OK;
}

// --- arrays of structs ---------------------------------------------------------------------------

// the array's shape: [n] in front of the item's own
static int full_shape(const column *c, const column_rows *rows, size_t shape[4], size_t *width)
{
    int rank = 0;
    *width = 1;
    if (!rows->single) {
        shape[rank++] = rows->n;
    }
    for (int i = 0; i < c->rank; i++) {
        shape[rank++] = c->shape[i];
        *width *= c->shape[i];
    }
    return rank;
}

static char *member(const column *c, const column_rows *rows, size_t i)
{
    char *at = (char *)rows->base + i * rows->stride + c->offset;
    return rows->behind ? *(char **)(void *)at : at;
}

static bool shape_is(int rank, const size_t *shape, int found_rank, const size_t *found)
{
    return rank == found_rank &&
           (rank == 0 || memcmp(shape, found, (size_t)rank * sizeof *shape) == 0);
}

static status write_reals(const passage *p, const char *full, const column *c,
                          const column_rows *rows)
{
    status st = OK;
    double *data = NULL;
    size_t shape[4] = {0}, width = 0;
    const int rank = full_shape(c, rows, shape, &width);
    TRY(TAKE(data, rows->n * width));
    for (size_t i = 0; i < rows->n; i++) {
        memcpy(&data[i * width], member(c, rows, i), width * sizeof *data);
    }
    TRY(store_real(p->store, full, rank, shape, data, c->unit));

done:
    free(data);
    return st;
}

// What a number in this unit cannot be larger than, in any structure that a run of ours describes.
// Far beyond physics, and far from where a square or a product of a few leaves the doubles.
static double largest_in(const char *unit)
{
    static const struct {
        const char *unit;
        double largest;
    } limits[] = {{"m", 1e9}, {"1/m", 1e9}, {"m^2", 1e18}, {"rad", 1e9}, {"Pa", 1e20}};
    for (size_t i = 0; i < sizeof limits / sizeof *limits; i++) {
        if (strcmp(unit, limits[i].unit) == 0) {
            return limits[i].largest;
        }
    }
    return 1e60;
}

static status check_reals(const passage *p, const char *full, const column *c, const double *data,
                          size_t n)
{
    const double largest = largest_in(c->unit);
    for (size_t i = 0; c->kind != COLUMN_ANY && i < n; i++) {
        if (c->kind == COLUMN_KNOWN && isnan(data[i])) {
            continue;
        }
        if (!isfinite(data[i])) {
            return passage_damaged(p, full, "holds what is not a number");
        }
        if (fabs(data[i]) > largest) {
            return passage_damaged(p, full, "holds a number beyond all reason");
        }
        if (c->kind == COLUMN_POSITIVE && data[i] <= 0) {
            return passage_damaged(p, full, "is not positive");
        }
    }
    return OK;
}

static status read_reals(const passage *p, const char *full, const column *c,
                         const column_rows *rows)
{
    status st = OK;
    double *data = NULL;
    size_t shape[4] = {0}, found[4], width = 0;
    int found_rank = 0;
    const int rank = full_shape(c, rows, shape, &width);
    TRY(store_read_real(p->store, full, &found_rank, found, &data));
    if (!shape_is(rank, shape, found_rank, found)) {
        TRY(passage_damaged(p, full, "has another shape than the counts say"));
    }
    TRY(check_reals(p, full, c, data, rows->n * width));
    for (size_t i = 0; i < rows->n; i++) {
        memcpy(member(c, rows, i), &data[i * width], width * sizeof *data);
    }

done:
    free(data);
    return st;
}

static status write_integers(const passage *p, const char *full, const column *c,
                             const column_rows *rows)
{
    status st = OK;
    int *data = NULL;
    size_t shape[4] = {0}, width = 0;
    const int rank = full_shape(c, rows, shape, &width);
    TRY(TAKE(data, rows->n * width));
    for (size_t i = 0; i < rows->n * width; i++) {
        const char *from = member(c, rows, i / width);
        data[i] = c->kind == COLUMN_FLAG ? *(const bool *)(const void *)from
                                         : ((const int *)(const void *)from)[i % width];
    }
    TRY(store_integer(p->store, full, rank, shape, data));

done:
    free(data);
    return st;
}

static status read_integers(const passage *p, const char *full, const column *c,
                            const column_rows *rows)
{
    status st = OK;
    int *data = NULL;
    size_t shape[4] = {0}, found[4], width = 0;
    int found_rank = 0;
    const int rank = full_shape(c, rows, shape, &width);
    const int max = c->kind == COLUMN_FLAG ? 1 : c->max;
    TRY(store_read_integer(p->store, full, &found_rank, found, &data));
    if (!shape_is(rank, shape, found_rank, found)) {
        TRY(passage_damaged(p, full, "has another shape than the counts say"));
    }
    for (size_t i = 0; i < rows->n * width; i++) {
        char *to = member(c, rows, i / width);
        if (data[i] < 0 || data[i] > max) {
            TRY(passage_damaged(p, full, "is out of range"));
        }
        if (c->kind == COLUMN_FLAG) {
            *(bool *)(void *)to = data[i] != 0;
        } else {
            ((int *)(void *)to)[i % width] = data[i];
        }
    }

done:
    free(data);
    return st;
}

static status pass_texts(const passage *p, const char *group, const column *c,
                         const column_rows *rows)
{
    status st = OK;
    for (size_t i = 0; i < rows->n; i++) {
        passage_name full;
        (void)snprintf(full.text, sizeof full.text, "%s/%zu/%s", group, i, c->name);
        TRY(passage_words(p, full.text, member(c, rows, i), c->shape[0]));
    }

done:
    return st;
}

static status pass_column(const passage *p, const char *group, const column *c,
                          const column_rows *rows)
{
    const passage_name full = passage_join(group, c->name);
    switch (c->kind) {
    case COLUMN_REAL:
    case COLUMN_POSITIVE:
    case COLUMN_KNOWN:
    case COLUMN_ANY:
        return p->reading ? read_reals(p, full.text, c, rows) : write_reals(p, full.text, c, rows);
    case COLUMN_TEXT:
        return pass_texts(p, group, c, rows);
    default:
        return p->reading ? read_integers(p, full.text, c, rows)
                          : write_integers(p, full.text, c, rows);
    }
}

status passage_columns(const passage *p, const char *group, int ncolumn, const column *columns,
                       column_rows rows)
{
    status st = OK;
    for (int i = 0; i < ncolumn; i++) {
        TRY(pass_column(p, group, &columns[i], &rows));
    }

done:
    return st;
}

status passage_count(const passage *p, const char *name, int least, int most, int *n)
{
    status st = OK;
    int rank = 0, *data = NULL;
    size_t shape[4];
    if (!p->reading) {
        return store_integer(p->store, name, 0, NULL, n);
    }
    TRY(store_read_integer(p->store, name, &rank, shape, &data));
    if (rank != 0 || *data < least || *data > most) {
        TRY(passage_damaged(p, name, "is out of range"));
    }
    *n = *data;

done:
    free(data);
    return st;
}

// --- texts ---------------------------------------------------------------------------------------

status passage_text(const passage *p, const char *name, char **text, size_t *length)
{
    return p->reading ? store_read_text(p->store, name, text, length)
                      : store_text(p->store, name, *text, *length);
}

status passage_words(const passage *p, const char *name, char *text, size_t size)
{
    status st = OK;
    char *found = NULL;
    size_t length = 0;
    if (!p->reading) {
        return store_text(p->store, name, text, strnlen(text, size));
    }
    TRY(store_read_text(p->store, name, &found, &length));
    if (length >= size) {
        TRY(passage_damaged(p, name, "is too long"));
    }
    (void)snprintf(text, size, "%s", found);

done:
    free(found);
    return st;
}
