// app/compare_measured.c
// Verdicts on measured shapes, where the case gives a tolerance: a model's error is none by itself.
#include "app/compare_rows.h"

#include <math.h>
#include <stdio.h>

static const measured_line *worst_of(const measured_result *m, bool tip)
{
    const measured_line *worst = NULL;
    for (int i = 0; i < m->nline; i++) {
        const measured_line *line = &m->line[i];
        const double value = tip ? line->error.tip : line->error.shape;
        if (!isnan(value) && (!worst || value > (tip ? worst->error.tip : worst->error.shape))) {
            worst = line;
        }
    }
    return worst;
}

void compare_measured(run_result *r)
{
    const measured_result *m = &r->measured;
    const measured_line *tip = worst_of(m, true), *shape = worst_of(m, false);
    const tolerance t = {m->tolerance, m->synthetic ? "as the case states; the shapes are synthetic"
                                                    : "as the case states"};
    if (!(m->tolerance > 0)) {
        return;
    }
    if (tip) {
        compare_judge(compare_add(r, "mm", "%s: tip error over L, largest (%.40s)",
                                  m->synthetic ? "synthetic" : "measured", tip->name),
                      1e3 * tip->error.tip, 0, tip->error.tip / r->rod_length, t);
    }
    if (shape) {
        compare_judge(compare_add(r, "%", "%s: shape error, largest (%.40s)",
                                  m->synthetic ? "synthetic" : "measured", shape->name),
                      100 * shape->error.shape, 0, shape->error.shape, t);
    }
}
