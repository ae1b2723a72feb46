// reports/page_fit.c
// What was fitted to measured shapes, how surely, and what it rests on.
#include "reports/page_kit.h"

#include <math.h>

static status parameter_row(bytes *page, const fit_result *f, int i)
{
    status st = OK;
    const fit_parameter_told *p = &f->parameter[i];
    const fit_answer *a = &f->answer;
    const int digits =
        fit_decimals(isfinite(a->error[i]) ? a->error[i] : (a->high[i] - a->low[i]) / 4);
    PAGE("<tr><td class=\"text\">");
    TRY(page_escaped(page, p->name));
    PAGE("<small>");
    TRY(page_escaped(page, p->keys));
    PAGE("</small></td><td><b>%s</b></td>", number_fixed(a->value[i], digits).text);
    if (a->bound[i]) {
        PAGE("<td>at its %s bound</td>", a->bound[i] < 0 ? "lower" : "upper");
    } else {
        PAGE("<td>%s</td>", number_fixed(a->error[i], digits).text);
    }
    PAGE("<td>%s to %s</td><td class=\"text\">%s</td><td>%s</td></tr>\n",
         number_fixed(a->low[i], digits).text, number_fixed(a->high[i], digits).text, p->unit,
         number_short(p->start, 6).text);

done:
    return st;
}

static status parameter_table(bytes *page, const fit_result *f)
{
    status st = OK;
    PAGE("<div class=\"scroll\"><table>\n<thead><tr><th class=\"text\">fitted</th><th>value</th>"
         "<th>standard error</th><th>%s %% interval</th><th class=\"text\">unit</th><th>start</th>"
         "</tr></thead>\n<tbody>\n",
         number_short(100 * f->share, 4).text);
    for (int i = 0; i < f->answer.nunknown; i++) {
        TRY(parameter_row(page, f, i));
    }
    PAGE("</tbody></table></div>\n");

done:
    return st;
}

static status correlation_table(bytes *page, const fit_result *f)
{
    status st = OK;
    const int n = f->answer.nunknown;
    if (n < 2) {
        return OK;
    }
    PAGE("<h3>How they go together</h3>\n<div class=\"scroll\"><table>\n<thead><tr><th "
         "class=\"text\">correlation</th>");
    for (int i = 0; i < n; i++) {
        PAGE("<th>");
        TRY(page_escaped(page, f->parameter[i].name));
        PAGE("</th>");
    }
    PAGE("</tr></thead>\n<tbody>\n");
    for (int i = 0; i < n; i++) {
        PAGE("<tr><td class=\"text\">");
        TRY(page_escaped(page, f->parameter[i].name));
        PAGE("</td>");
        for (int j = 0; j < n; j++) {
            const double x = f->answer.correlation[i * n + j];
            PAGE("<td>%s</td>", isfinite(x) ? number_fixed(x, 3).text : "");
        }
        PAGE("</tr>\n");
    }
    PAGE("</tbody></table></div>\n<p>Condition number of this matrix: %s.</p>\n",
         number_digits(f->answer.condition, 3).text);

done:
    return st;
}

static status shape_table(bytes *page, const fit_result *f)
{
    status st = OK;
    PAGE("<h3>Before and after</h3>\n<div class=\"scroll\"><table>\n<thead><tr><th "
         "class=\"text\">measured shape</th><th>across the line, rms<small>before, "
         "mm</small></th><th>after<small>mm</small></th><th>tip<small>before, "
         "mm</small></th><th>after<small>mm</small></th></tr></thead>\n<tbody>\n");
    for (int k = 0; k < f->answer.nshape; k++) {
        const fit_match *m = &f->answer.match[k];
        PAGE("<tr><td class=\"text\">");
        TRY(page_escaped(page, f->shape[k].name));
        PAGE("</td><td>%s</td><td>%s</td>", number_digits(1e3 * m->rms[0], 3).text,
             number_digits(1e3 * m->rms[1], 3).text);
        for (int i = 0; i < 2; i++) {
            PAGE("<td>%s</td>", isfinite(m->tip[i]) ? number_digits(1e3 * m->tip[i], 3).text : "");
        }
        PAGE("</tr>\n");
    }
    PAGE("</tbody></table></div>\n<p>Before: at the parameters' start values, not the case's own "
         "where those differ, bases as registered. After: at the fitted values, bases moved. Tip: "
         "the distance in space, along the line too, where the fit does not look. The other "
         "parts of this page have the case's own values.</p>\n");

done:
    return st;
}

static status base_table(bytes *page, const fit_result *f)
{
    status st = OK;
    if (f->base == FIT_BASE_FIXED) {
        return OK;
    }
    PAGE("<h3>How the shapes lie off the model's base</h3>\n<div class=\"scroll\"><table>\n<thead>"
         "<tr><th class=\"text\">measured shape</th>");
    for (int i = 0; i < 6; i++) {
        PAGE("<th>%s %c<small>%s</small></th>", i < 3 ? "shift" : "turn", "xyz"[i % 3],
             i < 3 ? "mm" : "deg");
    }
    PAGE("</tr></thead>\n<tbody>\n");
    for (int k = 0; k < f->answer.nshape; k++) {
        PAGE("<tr><td class=\"text\">");
        TRY(page_escaped(page, f->shape[k].name));
        PAGE("%s</td>", f->shape[k].turn_free ? " *" : "");
        for (int i = 0; i < 6; i++) {
            const double unit = i < 3 ? 1e3 : 180 / acos(-1.0);
            PAGE("<td>%s</td>", number_fixed(unit * f->answer.match[k].base.a[i], 3).text);
        }
        PAGE("</tr>\n");
    }
    PAGE("</tbody></table></div>\n");
    if (fit_turn_words(f)[0]) {
        PAGE("<p class=\"note warn\">%s.</p>\n", fit_turn_words(f));
    }

done:
    return st;
}

static status grounds(bytes *page, const fit_result *f)
{
    status st = OK;
    const fit_answer *a = &f->answer;
    static const char *const bases[] = {
        "The measured shapes are taken to stand exactly on the model's base.",
        "All measured shapes may lie off the model's base by one small motion, found too.",
        "Each measured shape may lie off the model's base by a small motion of its own, found "
        "too."};
    PAGE("<p>χ² = %s at %d degrees of freedom; ", number_digits(a->chi2, 4).text, a->freedom);
    if (a->sigma_known) {
        PAGE("standard errors are those of the lines' own uncertainty%s%s. ",
             a->scale > 1 ? " times " : "", a->scale > 1 ? number_digits(a->scale, 3).text : "");
    } else {
        PAGE("the lines do not all tell their uncertainty: where not, %s mm by their residuals. ",
             number_digits(1e3 * a->sigma * a->scale, 2).text);
    }
    PAGE("Intervals by Student's t (%s). Errors go together over %s mm along a line, by %s; %d "
         "places count. %s ",
         number_fixed(a->quantile, 3).text, number_digits(1e3 * a->correlation_length, 2).text,
         a->correlation_from == FIT_BY_LINE ? "what the lines tell" : "the residuals", a->nplace,
         bases[f->base]);
    if (f->base != FIT_BASE_FIXED) {
        PAGE("Known of it beforehand: %s mm, %s deg. ", number_digits(1e3 * f->base_shift, 2).text,
             number_digits(f->base_turn * 180 / acos(-1.0), 2).text);
    }
    if (a->nstart > 1) {
        PAGE("Of %d starts %d ended here", a->nstart, a->nsame);
        if (a->nended < a->nstart) {
            PAGE(", %d found no end", a->nstart - a->nended);
        }
        if (isfinite(a->next_chi2)) {
            PAGE(", the next best at χ² = %s", number_digits(a->next_chi2, 4).text);
        }
        PAGE(". ");
    }
    PAGE("Differences along the line are not looked at: nobody measures them. The intervals are "
         "those of the model being right.</p>\n");

done:
    return st;
}

status page_fit(bytes *page, const run_result *r, const char *dir)
{
    status st = OK;
    const fit_result *f = &r->fit;
    if (!f->there) {
        return OK;
    }
    PAGE("<h2 id=\"fit\">Fitted to %s shapes</h2>\n", f->synthetic ? "synthetic" : "measured");
    if (f->synthetic) {
        PAGE("<p><b>The shapes are synthetic, not from a bench.</b></p>\n");
    }
    if (f->source[0]) {
        PAGE("<p>Shapes: ");
        TRY(page_escaped(page, f->source));
        PAGE("</p>\n");
    }
    TRY(parameter_table(page, f));
    TRY(page_figure(page, dir, "fit",
                    "Distance across the measured line before and after the fit, and what pairs of "
                    "fitted numbers the shapes allow."));
    TRY(correlation_table(page, f));
    TRY(shape_table(page, f));
    TRY(base_table(page, f));
    TRY(grounds(page, f));

done:
    return st;
}
