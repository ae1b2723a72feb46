// app/chain_answers.c
// What is asked of the sections beyond their laws: of the stations that the case names, else of the
// first.
#include "app/chain.h"
#include "base/memory.h"

#include <string.h>

status chain_answers(const case_data *c, bool fields, run_result *out)
{
    status st = OK;
    const section_case *section = &c->file.section;
    const int n = section->stations.nrow > 0 ? out->section.nstation : 1;
    TRY(TAKE(out->answer, (size_t)n));
    for (int i = 0; i < n; i++) {
        const section_question question = {section, c->materials, fields && i == 0};
        st = section_answer(&question, &out->section.station[i], i, &out->answer[i]);
        TRY(case_place(c, st, section->at));
        out->nanswer = i + 1;
    }

done:
    return st;
}

status chain_points(const case_data *c, run_result *out)
{
    status st = OK;
    const key_rows *points = &c->file.section.points;
    TRY(TAKE(out->point, (size_t)points->nrow));
    out->npoint = points->nrow;
    for (int i = 0; i < points->nrow; i++) {
        memcpy(out->point[i], points->a + 2 * (size_t)i, sizeof out->point[i]);
    }

done:
    return st;
}
