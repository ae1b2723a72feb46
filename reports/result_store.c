// reports/result_store.c
#include "base/memory.h"
#include "reports/store_parts.h"

#include <stdio.h>
#include <string.h>

// --- what was asked ------------------------------------------------------------------------------

static status pass_materials(const passage *p, run_result *r)
{
#define NUMBER(name, unit, member)                                                                 \
    {                                                                                              \
        name, COLUMN_REAL, unit, offsetof(material, member), 0, {0}, 0                             \
    }
    static const column columns[] = {
        {"E_Pa", COLUMN_POSITIVE, "Pa", offsetof(material, E), 0, {0}, 0},
        NUMBER("nu", "-", nu),
        NUMBER("linear_strain", "-", linear_strain),
        NUMBER("density_kg_per_m3", "kg/m^3", density),
        {"kind", COLUMN_INT, "-", offsetof(material, kind), 0, {0}, MATERIAL_ANISOTROPIC},
        {"graded_across", COLUMN_FLAG, "-", offsetof(material, modulus.across), 0, {0}, 0},
        {"graded_along", COLUMN_FLAG, "-", offsetof(material, modulus.along), 0, {0}, 0},
        NUMBER("E1_Pa", "Pa", E1),
        NUMBER("E2_Pa", "Pa", E2),
        NUMBER("E3_Pa", "Pa", E3),
        NUMBER("G12_Pa", "Pa", G12),
        NUMBER("G13_Pa", "Pa", G13),
        NUMBER("G23_Pa", "Pa", G23),
        NUMBER("nu12", "-", nu12),
        NUMBER("nu13", "-", nu13),
        NUMBER("nu23", "-", nu23),
        NUMBER("fibre_angle_rad", "rad", fibre_angle),
        NUMBER("plane_angle_rad", "rad", plane_angle),
        {"stiffness_in_frame",
         COLUMN_REAL,
         "Pa",
         offsetof(material, in_frame),
         2,
         {6, 6},
         0}, // order 11 22 33 23 13 12
    };
#undef NUMBER
    status st = OK;
    int n = r->nmaterial;
    TRY(passage_count(p, "material/count", 0, MOST_MATERIALS, &n));
    TRY(passage_room(p, (void **)&r->materials, (size_t)n, sizeof *r->materials));
    r->nmaterial = n;
    TRY(passage_columns(p, "material", COUNT_OF(columns), columns,
                        rows_of(r->materials, n, sizeof *r->materials)));
    for (int i = 0; i < n; i++) {
        char name[64], *text = (char *)r->materials[i].name;
        size_t length = text ? strlen(text) : 0;
        (void)snprintf(name, sizeof name, "material/%d/name", i);
        TRY(passage_text(p, name, &text, &length));
        r->materials[i].name = text;
    }

done:
    return st;
}

static status pass_case(const passage *p, run_result *r)
{
    static const column has[] = {
        {"section", COLUMN_FLAG, "-", offsetof(run_result, has_section), 0, {0}, 0},
        {"rod", COLUMN_FLAG, "-", offsetof(run_result, has_rod), 0, {0}, 0},
        {"fem", COLUMN_FLAG, "-", offsetof(run_result, has_segment), 0, {0}, 0},
        {"compare", COLUMN_FLAG, "-", offsetof(run_result, has_compare), 0, {0}, 0},
        {"measured", COLUMN_FLAG, "-", offsetof(run_result, has_measured), 0, {0}, 0},
    };
    status st = OK;
    TRY(passage_words(p, "case/title", r->title, sizeof r->title));
    TRY(passage_text(p, "case/text", &r->case_text, &r->case_length));
    TRY(passage_words(p, "case/versions", r->versions, sizeof r->versions));
    TRY(passage_columns(p, "has", COUNT_OF(has), has, single(r)));
    TRY(pass_materials(p, r));

done:
    return st;
}

// --- comparisons ---------------------------------------------------------------------------------

static status pass_compare(const passage *p, run_result *r)
{
#define ROW(member) offsetof(compare_row, member)
    static const column columns[] = {
        {"what", COLUMN_TEXT, "-", ROW(what), 0, {sizeof r->compare->what}, 0},
        {"unit", COLUMN_TEXT, "-", ROW(unit), 0, {sizeof r->compare->unit}, 0},
        {"ours", COLUMN_REAL, "see unit", ROW(ours), 0, {0}, 0},
        {"other", COLUMN_ANY, "see unit", ROW(other), 0, {0}, 0},
        {"difference_relative", COLUMN_ANY, "-", ROW(difference), 0, {0}, 0},
        {"tolerance_relative", COLUMN_ANY, "-", ROW(tolerance), 0, {0}, 0},
        {"reason", COLUMN_TEXT, "-", ROW(reason), 0, {sizeof r->compare->reason}, 0},
        {"skipped", COLUMN_FLAG, "-", ROW(skipped), 0, {0}, 0},
        {"ok", COLUMN_FLAG, "-", ROW(ok), 0, {0}, 0},
    };
#undef ROW
    status st = OK;
    int n = r->ncompare;
    TRY(passage_count(p, "compare/row_count", 0, MOST_ROWS, &n));
    TRY(passage_room(p, (void **)&r->compare, (size_t)n, sizeof *r->compare));
    r->ncompare = n;
    TRY(passage_columns(p, "compare", COUNT_OF(columns), columns,
                        rows_of(r->compare, n, sizeof *r->compare)));

done:
    return st;
}

// --- the whole -----------------------------------------------------------------------------------

static status pass_all(const passage *p, run_result *r)
{
    status st = OK;
    TRY(pass_case(p, r));
    TRY(r->has_section ? store_pass_section(p, r) : OK);
    TRY(r->has_rod ? store_pass_rod(p, r) : OK);
    TRY(r->has_measured ? store_pass_measured(p, r) : OK);
    TRY(r->has_segment ? store_pass_segment(p, r) : OK);
    TRY(r->has_compare ? pass_compare(p, r) : OK);
    TRY(r->has_compare ? store_pass_models(p, r) : OK);
    TRY(store_pass_sensitivity(p, r));
    TRY(store_pass_fit(p, r));
    TRY(store_pass_reach(p, r));

done:
    return st;
}

status result_store_write(const run_result *r, const char *path)
{
    status st = OK;
    store *s = NULL;
    run_result copy = *r; // one description serves both ways, so it takes what it could write to
    TRY(r->segment.body.shared ? store_create_shared(path, &s) : store_create(path, &s));
    if (!s) {
        return OK; // the first rank has nowhere to write, and says so
    }
    const passage p = {.store = s, .path = path};
    TRY(pass_all(&p, &copy));
    TRY(r->has_section ? store_write_known(s, path, &r->section.solved) : OK);
    TRY(store_write_grid(s, r));
    store *whole = s;
    s = NULL; // store_commit frees it
    TRY(store_commit(whole));

done:
    store_abandon(s);
    return st;
}

status result_store_read(const char *path, run_result *out)
{
    status st = OK;
    store *s = NULL;
    run_result r = {0};
    TRY(store_open(path, &s));
    const passage p = {.store = s, .reading = true, .path = path};
    TRY(pass_all(&p, &r));
    *out = r;
    r = (run_result){0};

done:
    run_result_free(&r);
    store_close(s);
    return st;
}
