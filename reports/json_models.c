// reports/json_models.c
// What assumptions about the section cost, as part of a comparison's document.
#include "reports/json_parts.h"

static const char *const axis[6] = {"nx", "ny", "nz", "mx", "my", "mz"};

// a miss and the entry that has it
static void write_miss(json *j, const char *key, const char *where, double miss, int row,
                       int column)
{
    json_real(j, key, miss);
    json_array(j, where);
    json_text(j, NULL, axis[row]);
    json_text(j, NULL, axis[column]);
    json_array_end(j);
}

static void write_check(json *j, const model_check *m)
{
    json_object(j, NULL);
    json_text(j, "name", m->name);
    if (m->why[0]) {
        json_text(j, "why_not", m->why);
    } else {
        json_mat6(j, "compliance", m->compliance);
        write_miss(j, "error", "entry", m->error, m->row, m->column);
        write_miss(j, "law_error", "law_entry", m->law_error, m->law_row, m->law_column);
    }
    json_object_end(j);
}

void result_json_models(json *j, const char *key, const model_checks *m)
{
    const bool second = m->lengths[1] > 0;
    json_object(j, key);
    json_reals(j, "lengths_m", second ? 2 : 1, m->lengths);
    if (!second) {
        json_text(j, "why_no_second_length", m->why_no_second);
    }
    json_mat6(j, "compliance_3d", m->compliance);
    if (second) {
        json_mat6(j, "law_3d", m->law_difference);
    }
    json_array(j, "assumptions");
    for (int i = 0; i < MODEL_CHECKS; i++) {
        write_check(j, &m->model[i]);
    }
    json_array_end(j);
    json_object_end(j);
}
