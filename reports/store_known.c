// reports/store_known.c
// The laws of solved sections by fingerprint, for the next run into the same result.
#include "base/memory.h"
#include "reports/store_parts.h"

#include <string.h>

enum { MOST_KNOWN = 100000, PARTS = 8, PART_BITS = 16, PART_MOST = 65535 };

// a fingerprint as small integers, which every store can hold
typedef struct known_row {
    int key[PARTS];
    beam_law law;
    int order, layers; // of its mesh
    double finer;
} known_row;

static void take_apart(hash key, int part[PARTS])
{
    for (int i = 0; i < PARTS; i++) {
        const uint64_t word = i < PARTS / 2 ? key.a : key.b;
        part[i] = (int)(word >> (PART_BITS * (i % (PARTS / 2))) & PART_MOST);
    }
}

static hash put_together(const int part[PARTS])
{
    hash key = {0};
    for (int i = 0; i < PARTS; i++) {
        uint64_t *word = i < PARTS / 2 ? &key.a : &key.b;
        *word |= (uint64_t)part[i] << (PART_BITS * (i % (PARTS / 2)));
    }
    return key;
}

static status pass_rows(const passage *p, int n, known_row *rows)
{
    static const column columns[] = {
        {"key", COLUMN_INT, "-", offsetof(known_row, key), 1, {PARTS}, PART_MOST},
        {"K", COLUMN_REAL, STIFFNESS_UNIT, offsetof(known_row, law.K), 2, {6, 6}, 0},
        {"area_m2", COLUMN_POSITIVE, "m^2", offsetof(known_row, law.area), 0, {0}, 0},
        {"mass_kg_per_m", COLUMN_REAL, "kg/m", offsetof(known_row, law.mass), 0, {0}, 0},
        {"mass_centre_m", COLUMN_REAL, "m", offsetof(known_row, law.mass_centre), 1, {2}, 0},
        {"relative_error", COLUMN_ANY, "-", offsetof(known_row, law.relative_error), 0, {0}, 0},
        {"mesh_order", COLUMN_INT, "-", offsetof(known_row, order), 0, {0}, ELEMENT_MAX_ORDER},
        {"mesh_layers", COLUMN_INT, "-", offsetof(known_row, layers), 0, {0}, SECTION_MOST_LAYERS},
        {"mesh_finer", COLUMN_REAL, "-", offsetof(known_row, finer), 0, {0}, 0},
        {"K_relative_error", COLUMN_ANY, "-", offsetof(known_row, law.entry_error), 2, {6, 6}, 0},
    };
    return n == 0 ? OK
                  : passage_columns(p, "section/known", COUNT_OF(columns), columns,
                                    rows_of(rows, n, sizeof *rows));
}

status store_write_known(store *s, const char *path, const section_known *known)
{
    status st = OK;
    known_row *rows = NULL;
    const passage p = {.store = s, .path = path};
    int n = known->count;
    TRY(TAKE(rows, (size_t)n));
    for (int i = 0; i < n; i++) {
        take_apart(known->key[i], rows[i].key);
        rows[i].law = known->law[i];
        rows[i].order = known->mesh[i].order;
        rows[i].layers = known->mesh[i].layers;
        rows[i].finer = known->mesh[i].finer;
    }
    TRY(passage_count(&p, "section/known/count", 0, MOST_KNOWN, &n));
    TRY(pass_rows(&p, n, rows));

done:
    free(rows);
    return st;
}

static status read_known(const passage *p, section_known *out)
{
    status st = OK;
    known_row *rows = NULL;
    int n = 0;
    TRY(passage_count(p, "section/known/count", 0, MOST_KNOWN, &n));
    TRY(TAKE(rows, (size_t)n));
    TRY(pass_rows(p, n, rows));
    for (int i = 0; i < n; i++) {
        const mesh_options o = {
            .order = rows[i].order, .layers = rows[i].layers, .finer = rows[i].finer};
        TRY(beam_law_check(&rows[i].law));
        if (o.order < 1 || !(o.finer >= 0 && o.finer <= SECTION_MOST_FINER)) {
            TRY(passage_damaged(p, "section/known", "a mesh that no section is solved on"));
        }
        TRY(section_known_add(out, put_together(rows[i].key), &rows[i].law, &o));
    }

done:
    free(rows);
    return st;
}

status result_known_read(const char *path, section_known *out)
{
    status st = OK;
    store *s = NULL;
    section_known known = {0};
    TRY(store_open(path, &s));
    const passage p = {.store = s, .reading = true, .path = path};
    if (store_has(s, "section/known/count")) {
        TRY(read_known(&p, &known));
    }
    *out = known;
    known = (section_known){0};

done:
    section_known_free(&known);
    store_close(s);
    return st;
}
