// app/print_fit.c
#include "app/print.h"

#include <math.h>
#include <stdio.h>

static void print_parameter(const fit_result *f, int i)
{
    const fit_parameter_told *p = &f->parameter[i];
    const fit_answer *a = &f->answer;
    const bool known = isfinite(a->error[i]);
    const int d = fit_decimals(known ? a->error[i] : (a->high[i] - a->low[i]) / 4);
    printf("%-24.40s %12.*f ", p->name, d, a->value[i]);
    if (known) {
        printf("%12.*f", d, a->error[i]);
    } else {
        printf("%12s", a->bound[i] < 0 ? "lower bound" : "upper bound");
    }
    printf(" %12.*f %12.*f  %-8s %s\n", d, a->low[i], d, a->high[i], p->unit, p->keys);
}

static void print_correlation(const fit_result *f)
{
    const int n = f->answer.nunknown;
    if (n < 2) {
        return;
    }
    printf("correlation (condition %.3g)\n", f->answer.condition);
    for (int i = 0; i < n; i++) {
        printf("%-24.40s", f->parameter[i].name);
        for (int j = 0; j <= i; j++) {
            const double x = f->answer.correlation[i * n + j];
            isfinite(x) ? printf(" %7.3f", x) : printf(" %7s", "-");
        }
        (void)putchar('\n');
    }
}

static void print_shapes(const fit_result *f)
{
    printf("%-32s %24s %24s\n", f->synthetic ? "synthetic shape" : "measured shape",
           "across, rms mm: before", "after");
    for (int k = 0; k < f->answer.nshape; k++) {
        const fit_match *m = &f->answer.match[k];
        printf("%-32.60s %24.4f %24.4f", print_plain(f->shape[k].name).text, 1e3 * m->rms[0],
               1e3 * m->rms[1]);
        if (isfinite(m->tip[0])) {
            printf("   tip %.4f to %.4f", 1e3 * m->tip[0], 1e3 * m->tip[1]);
        }
        (void)putchar('\n');
    }
    printf("before: at `start`, bases as registered; after: fitted, bases moved. Tip: in space, "
           "along the line too, where the fit does not look\n");
}

static void print_bases(const fit_result *f)
{
    const double degree = acos(-1.0) / 180;
    if (f->base == FIT_BASE_FIXED) {
        return;
    }
    printf("%-32s %26s %26s\n", "off the model's base", "shifted, x y z mm", "turned, x y z deg");
    for (int k = 0; k < f->answer.nshape; k++) {
        const double *b = f->answer.match[k].base.a;
        printf("%-32.60s %8.3f %8.3f %8.3f %8.3f %8.3f %8.3f%s\n",
               print_plain(f->shape[k].name).text, 1e3 * b[0], 1e3 * b[1], 1e3 * b[2],
               b[3] / degree, b[4] / degree, b[5] / degree, f->shape[k].turn_free ? " *" : "");
    }
    if (fit_turn_words(f)[0]) {
        printf("%s\n", fit_turn_words(f));
    }
}

static void print_grounds(const fit_result *f)
{
    static const char *const bases[] = {"fixed", "one small motion for all", "a small motion each"};
    const fit_answer *a = &f->answer;
    printf("chi^2 %.4g at %d degrees of freedom; ", a->chi2, a->freedom);
    if (a->sigma_known) {
        printf("standard errors by the lines' own uncertainty%s", a->scale > 1 ? "" : "\n");
        if (a->scale > 1) {
            printf(" times %.3g: the model misses them by more\n", a->scale);
        }
    } else {
        printf("uncertainty of a place by the residuals: %.3g mm\n", 1e3 * a->sigma * a->scale);
    }
    printf("errors go together over %.2g mm along a line, by %s; base: %s; Student's t %.3f\n",
           1e3 * a->correlation_length,
           a->correlation_from == FIT_BY_LINE ? "what the lines tell" : "the residuals",
           bases[f->base], a->quantile);
    if (a->nstart > 1) {
        printf("%d of %d starts ended here", a->nsame, a->nstart);
        if (a->nended < a->nstart) {
            printf(", %d found no end", a->nstart - a->nended);
        }
        isfinite(a->next_chi2) ? printf(", the next best at chi^2 %.4g\n", a->next_chi2)
                               : printf("\n");
    }
    if (a->step_error > 0.01) {
        printf("derivatives by differences are good to %.1g only: so are the standard errors\n",
               a->step_error);
    }
}

static void print_bounds(const fit_result *f)
{
    const fit_answer *a = &f->answer;
    for (int i = 0; i < a->nunknown; i++) {
        if (a->bound[i]) {
            printf("'%s' ends at its %s bound: the shapes alone would have it at %.4g %s\n",
                   f->parameter[i].name, a->bound[i] < 0 ? "lower" : "upper", a->beyond[i],
                   f->parameter[i].unit);
        }
    }
}

void print_fit(const run_result *r)
{
    const fit_result *f = &r->fit;
    if (!f->there) {
        return;
    }
    printf("fitted to %d %s shape%s%s%s\n", f->answer.nshape,
           f->synthetic ? "SYNTHETIC" : "measured", f->answer.nshape == 1 ? "" : "s",
           f->source[0] ? ": " : "", f->source);
    char interval[40];
    (void)snprintf(interval, sizeof interval, "%.4g %% interval", 100 * f->share);
    printf("%-24s %12s %12s %25s  %-8s %s\n", "parameter", "value", "std error", interval, "unit",
           "keys");
    for (int i = 0; i < f->answer.nunknown; i++) {
        print_parameter(f, i);
    }
    print_bounds(f);
    print_correlation(f);
    print_shapes(f);
    print_bases(f);
    print_grounds(f);
}
