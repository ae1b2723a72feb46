// app/compare.c
#include "app/compare.h"

#include "app/chain.h"
#include "app/compare_rows.h"
#include "app/segment_points.h"
#include "base/memory.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

static double modulus_contrast(const case_data *c, const mesh *m)
{
    double least = INFINITY, most = 0;
    for (int b = 0; b < m->nblock; b++) {
        for (int e = 0; e < m->block[b].nelem; e++) {
            const double E = c->materials[m->block[b].material[e]].E;
            least = fmin(least, E);
            most = fmax(most, E);
        }
    }
    return most / least;
}

static status prepare_section(const case_data *c, compare_section *out)
{
    status st = OK;
    out->s = case_has_segment(c) ? c->file.fem.section_at : 0;
    TRY(case_place(c, section_mesh_at(&c->file.section, out->s, &out->mesh), c->file.section.at));
    for (int i = 0; i < out->mesh.nnode; i++) {
        const double *x = out->mesh.xyz + 3 * (size_t)i;
        out->radius = fmax(out->radius, hypot(x[0], x[1]));
    }
    out->one_poisson = segment_has_one_poisson(c->materials, &out->mesh);
    out->isotropic = segment_is_isotropic(c->materials, &out->mesh);
    out->contrast = modulus_contrast(c, &out->mesh);
    // the full model, whatever the case's is, as the other ways have it: nothing turns
    section_case full = c->file.section;
    full.model = MODEL_FULL;
    TRY(case_place(c, section_solve(&full, c->materials, out->s, 0, &out->full), full.at));
    out->error = out->full.relative_error;
    TRY(beam_law_centres(&out->full, &out->centres));

done:
    return st;
}

status compare_all(const command *cmd, const case_data *c, run_result *r)
{
    status st = OK;
    compare_section section = {0};
    TRY(TAKE(r->compare, COMPARE_MAX_ROWS));
    r->has_compare = true;
    command_progress(cmd, "comparison: section");
    TRY(prepare_section(c, &section));
    TRY(compare_published(c, &section, r));
    TRY(compare_closed_forms(c, &section, r));
    command_progress(cmd, "comparison: GetDP");
    TRY(compare_getdp(c, &section, r));
    if (r->has_segment) {
        TRY(compare_section_segment(c, &section, r));
    }
    if (case_has_rod(c)) {
        command_progress(cmd, "comparison: rod in both frames");
        TRY(compare_frames(c, r));
    }
    compare_measured(r);
    if (r->has_segment) {
        command_progress(cmd, "comparison: models of the section");
        TRY(compare_models(c, &section, r));
        compare_rod_segment(c, &section, r);
        compare_loads(c, &section, r);
        command_progress(cmd, "comparison: CalculiX");
        TRY(compare_calculix(c, r));
    }

done:
    mesh_free(&section.mesh);
    return st;
}

status compare_verdict(const run_result *r)
{
    int out = 0, first = 0;
    for (int i = r->ncompare - 1; i >= 0; i--) {
        if (!r->compare[i].ok) {
            out++;
            first = i;
        }
    }
    if (out == 0) {
        return OK;
    }
    const compare_row *row = &r->compare[first];
    return status_fail(ERR_TOLERANCE,
                       "%d of %d comparisons out of tolerance, the first: %s: %.2e > %.2e", out,
                       r->ncompare, row->what, row->difference, row->tolerance);
}
