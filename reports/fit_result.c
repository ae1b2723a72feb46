// reports/fit_result.c
#include "reports/fit_result.h"

#include "base/memory.h"

#include <math.h>
#include <stdio.h>

status fit_result_make(int nparameter, int nshape, fit_result *out)
{
    status st = OK;
    fit_result f = {0};
    TRY(fit_answer_make(nparameter, nshape, &f.answer));
    TRY(TAKE(f.parameter, (size_t)nparameter));
    TRY(TAKE(f.shape, (size_t)nshape));
    *out = f;
    f = (fit_result){0};

done:
    fit_result_free(&f);
    return st;
}

void fit_result_free(fit_result *f)
{
    free(f->parameter);
    free(f->shape);
    fit_answer_free(&f->answer);
    *f = (fit_result){0};
}

const char *fit_turn_words(const fit_result *f)
{
    bool any = false;
    for (int k = 0; k < f->answer.nshape; k++) {
        any = any || f->shape[k].turn_free;
    }
    return !any ? ""
           : f->base == FIT_BASE_EACH
               ? "* its scan is free in its turn about z: that turn is found with no idea of it "
                 "beforehand, so the shape tells how much the rod bends, not in which direction"
               : "* its scan is free in its turn about z, and the fit takes its direction for "
                 "known: a mark or fiducials in the scan, or `base: each`, mend that";
}

int fit_decimals(double error)
{
    const int decimals = error > 0 && isfinite(error) ? (int)ceil(1 - log10(error)) : 6;
    return decimals < 0 ? 0 : decimals > 12 ? 12 : decimals;
}

const char *fit_result_words(const fit_result *f, char *words, size_t room)
{
    const fit_answer *a = &f->answer;
    size_t used = 0;
    words[0] = '\0';
    for (int i = 0; i < a->nunknown && used < room; i++) {
        const fit_parameter_told *p = &f->parameter[i];
        const char *space = p->unit[0] ? " " : "";
        const char *comma = i ? ", " : "";
        int n = 0;
        if (a->bound[i]) {
            n = snprintf(words + used, room - used, "%s%s = %.6g%s%s (its bound)", comma, p->name,
                         a->value[i], space, p->unit);
        } else {
            const int d = fit_decimals(a->error[i]);
            n = snprintf(words + used, room - used, "%s%s = %.*f ± %.*f%s%s", comma, p->name, d,
                         a->value[i], d, a->error[i], space, p->unit);
        }
        used += n > 0 ? (size_t)n : 0;
    }
    return words;
}
