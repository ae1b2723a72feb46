// reports/result_json.c
// The documents of the program's contract. Keys carry their unit; matrices are arrays of rows in
// the order nx ny nz mx my mz at the geometric centre. What is not a number is null.
#include "reports/json_parts.h"

#include <math.h>

static const char *const model_names[] = {"full", "classical"};

void json_begin(json *j, const char *key, const char *schema, const run_result *r)
{
    json_object(j, key);
    json_text(j, "schema", schema);
    if (!key) {
        json_text(j, "title", r->title);
    }
}

static status write_station(json *j, const run_result *r, int station)
{
    const section_station *s = &r->section.station[station];
    const beam_centres *c = &s->centres;
    json_object(j, NULL);
    json_real(j, "s_m", s->s);
    json_real(j, "area_m2", s->law.area);
    json_real(j, "EA_N", c->EA);
    json_reals(j, "stiffness_centre_m", 2, c->stiffness_centre);
    json_real(j, "principal_angle_rad", c->principal_angle);
    json_flag(j, "isotropic", c->isotropic);
    json_reals(j, "EI_Nm2", 2, c->EI);
    json_reals(j, "EI_centre_Nm2", 3, c->EI_centre);
    json_real(j, "GJ_Nm2", c->GJ);
    json_reals(j, "shear_centre_m", 2, c->shear_centre);
    json_mat6(j, "K", s->law.K);
    json_real(j, "relative_error", s->law.relative_error);
    json_mat6(j, "K_relative_error", s->law.entry_error);
    const status st = json_station_answers(j, r, station);
    json_object_end(j);
    return st;
}

status result_json_section(json *j, const char *key, const run_result *r)
{
    status st = OK;
    json_begin(j, key, "stiffaxis/section/1", r);
    json_text(j, "model", model_names[r->section_model]);
    json_integer(j, "sections_solved", r->section.effort.nsolved);
    json_real(j, "interpolation_relative_error", r->section.along.relative_error);
    if (r->section.resolution > 0) {
        json_real(j, "pixel_relative_error", r->section.resolution);
    }
    json_array(j, "stations");
    for (int i = 0; i < r->section.nstation; i++) {
        TRY(write_station(j, r, i));
    }
    json_array_end(j);
    json_object_end(j);

done:
    return st;
}

static void write_row(json *j, const compare_row *row)
{
    json_object(j, NULL);
    json_text(j, "what", row->what);
    json_text(j, "unit", row->unit);
    json_real(j, "ours", row->skipped ? NAN : row->ours); // nothing was compared: null
    json_real(j, "other", row->skipped ? NAN : row->other);
    json_real(j, "difference_relative", row->skipped ? NAN : row->difference);
    json_real(j, "tolerance_relative", row->tolerance);
    json_text(j, "reason", row->reason);
    json_flag(j, "skipped", row->skipped);
    json_flag(j, "ok", row->ok);
    json_object_end(j);
}

status result_json_compare(json *j, const char *key, const run_result *r)
{
    bool ok = true;
    json_begin(j, key, "stiffaxis/compare/1", r);
    json_array(j, "rows");
    for (int i = 0; i < r->ncompare; i++) {
        write_row(j, &r->compare[i]);
        ok = ok && (r->compare[i].ok || r->compare[i].skipped);
    }
    json_array_end(j);
    if (r->models.there) {
        result_json_models(j, "models", &r->models);
    }
    if (r->has_measured) {
        result_json_measured(j, "measured", r);
    }
    json_flag(j, "ok", ok);
    json_object_end(j);
    return OK;
}

status result_json_run(json *j, const run_result *r)
{
    status st = OK;
    json_begin(j, NULL, "stiffaxis/run/1", r);
    TRY(r->has_section ? result_json_section(j, "section", r) : OK);
    TRY(r->has_rod ? result_json_rod(j, "rod", r) : OK);
    TRY(r->has_segment ? result_json_segment(j, "fem", r) : OK);
    TRY(r->has_compare ? result_json_compare(j, "compare", r) : OK);
    TRY(r->has_sensitivity ? result_json_sensitivity(j, "sensitivity", r) : OK);
    TRY(r->fit.there ? result_json_fit(j, "fit", r) : OK);
    TRY(r->reach.there ? result_json_reach(j, "reach", r) : OK);
    json_object_end(j);

done:
    return st;
}
