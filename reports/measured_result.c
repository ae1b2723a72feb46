// reports/measured_result.c
#include "reports/measured_result.h"

#include "base/memory.h"

status measured_line_room(measured_line *line, int npoint)
{
    status st = OK;
    const size_t n = (size_t)npoint;
    TRY(TAKE(line->s, n));
    TRY(TAKE(line->sigma, n));
    TRY(TAKE(line->p, n));
    TRY(TAKE(line->model, n));
    TRY(TAKE(line->bend, n));
    TRY(TAKE(line->bend_sigma, n));
    line->npoint = npoint;

done:
    return st;
}

void measured_result_free(measured_result *m)
{
    for (int i = 0; m->line && i < m->nline; i++) {
        measured_line *line = &m->line[i];
        free(line->s);
        free(line->sigma);
        free(line->p);
        free(line->model);
        free(line->bend);
        free(line->bend_sigma);
    }
    free(m->line);
    *m = (measured_result){0};
}
