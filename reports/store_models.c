// reports/store_models.c
#include "reports/store_parts.h"

#include <math.h>

// entries that no end enters; the others are no numbers
static void blank_law(mat6 *F)
{
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            F->a[i][j] = i > 1 && j > 1 ? F->a[i][j] : NAN;
        }
    }
}

static status pass_checks(const passage *p, model_checks *m)
{
#define CHECK_OF(member) offsetof(model_check, member)
    static const column columns[] = {
        {"name", COLUMN_TEXT, "-", CHECK_OF(name), 0, {sizeof m->model->name}, 0},
        {"why_not", COLUMN_TEXT, "-", CHECK_OF(why), 0, {sizeof m->model->why}, 0},
        {"compliance", COLUMN_REAL, COMPLIANCE_UNIT, CHECK_OF(compliance), 2, {6, 6}, 0},
        {"error_relative", COLUMN_ANY, "-", CHECK_OF(error), 0, {0}, 0},
        {"row", COLUMN_INT, "-", CHECK_OF(row), 0, {0}, 5},
        {"column", COLUMN_INT, "-", CHECK_OF(column), 0, {0}, 5},
        {"law_error_relative", COLUMN_ANY, "-", CHECK_OF(law_error), 0, {0}, 0},
        {"law_row", COLUMN_INT, "-", CHECK_OF(law_row), 0, {0}, 5},
        {"law_column", COLUMN_INT, "-", CHECK_OF(law_column), 0, {0}, 5},
    };
#undef CHECK_OF
    return passage_columns(p, "compare/model", COUNT_OF(columns), columns,
                           rows_of(m->model, MODEL_CHECKS, sizeof *m->model));
}

status store_pass_models(const passage *p, run_result *r)
{
#define MODELS(member) offsetof(model_checks, member)
    static const column columns[] = {
        {"why_no_second_length",
         COLUMN_TEXT,
         "-",
         MODELS(why_no_second),
         0,
         {sizeof r->models.why_no_second},
         0},
        {"lengths_m", COLUMN_REAL, "m", MODELS(lengths), 1, {2}, 0},
        {"compliance_3d", COLUMN_REAL, COMPLIANCE_UNIT, MODELS(compliance), 2, {6, 6}, 0},
        {"law_3d", COLUMN_ANY, COMPLIANCE_UNIT, MODELS(law_difference), 2, {6, 6}, 0},
    };
#undef MODELS
    status st = OK;
    model_checks *m = &r->models;
    int there = m->there;
    TRY(passage_count(p, "compare/has_models", 0, 1, &there));
    m->there = there;
    if (there) {
        TRY(passage_columns(p, "compare/models", COUNT_OF(columns), columns, single(m)));
        TRY(pass_checks(p, m));
    }
    if (there && p->reading) {
        blank_law(&m->law_difference);
    }

done:
    return st;
}
