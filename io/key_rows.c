// io/key_rows.c
// Values of a case that are lists of numbers, flat or in rows.
#include "io/key_value.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static status check_list(const value_key *v, const node *n)
{
    char wanted[48];
    (void)snprintf(wanted, sizeof wanted, "a list of %d numbers", v->k->count);
    if (n->kind != NODE_LIST) {
        return value_mismatch(v, n, wanted);
    }
    if (n->count != v->k->count) {
        return config_fail(v->cfg, n->at, "'%s': expected %s, found %d", shortened(v->written).a,
                           wanted, n->count);
    }
    return OK;
}

status value_vector(const value_key *v, const node *n, double *out)
{
    status st = check_list(v, n);
    int i = 0;
    for (const node *item = st == OK ? n->first : NULL; item && st == OK; item = item->next) {
        st = value_real(v, item, &out[i++]);
    }
    return st;
}

status value_fields(const value_key *v, const node *n, field *out)
{
    status st = check_list(v, n);
    int i = 0;
    for (const node *item = st == OK ? n->first : NULL; item && st == OK; item = item->next) {
        st = value_field(v, item, &out[i++]);
    }
    return st;
}

// YAML's own word for nothing
static bool is_open(const node *n)
{
    return n->kind == NODE_SCALAR && n->plain &&
           (strcmp(n->text, "~") == 0 || strcmp(n->text, "null") == 0);
}

static status value_entry(const value_key *v, const node *n, double *out)
{
    if (v->k->open && is_open(n)) {
        *out = NAN;
        return OK;
    }
    return value_real(v, n, out);
}

// every row is a list of ncol; looked at before memory is taken for nrow * ncol numbers
static status check_rows(const value_key *v, const node *row, int nrow, int ncol)
{
    for (int i = 0; i < nrow; i++, row = row->next) {
        if (row->kind != NODE_LIST) {
            return value_mismatch(v, row, "a row of numbers, [a, b, ...]");
        }
        if (row->count == 0) {
            return value_mismatch(v, row, "at least one number in a row");
        }
        if (row->count != ncol) {
            return config_fail(v->cfg, row->at, "'%s': expected rows of %d, found a row of %d",
                               shortened(v->written).a, ncol, row->count);
        }
    }
    return OK;
}

status value_rows(const value_key *v, const node *n, key_rows *out)
{
    if (n->kind != NODE_LIST) {
        return value_mismatch(v, n, "a list of rows of numbers");
    }
    if (n->count == 0) {
        return config_fail(v->cfg, n->at, "'%s': the list is empty", shortened(v->written).a);
    }
    const bool flat = n->first->kind == NODE_SCALAR;
    const node *row = flat ? n : n->first;
    const int ncol = v->k->count > 0 ? v->k->count : row->kind == NODE_LIST ? row->count : 1;
    const int nrow = flat ? 1 : n->count;
    status st = OK;
    // a flat list without a fixed length is a list of entries too (stations)
    TRY(value_count(v, n, flat && v->k->count == 0 ? n->count : nrow));
    TRY(check_rows(v, row, nrow, ncol));
    *out = (key_rows){.at = n->at, .nrow = nrow, .ncol = ncol};
    TRY(ARENA_TAKE(v->cfg->memory, out->a, (size_t)nrow * (size_t)ncol));
    double *a = out->a;
    for (int i = 0; i < nrow; i++, row = row->next) {
        for (const node *item = row->first; item; item = item->next) {
            TRY(value_entry(v, item, a++));
        }
    }

done:
    return st;
}
