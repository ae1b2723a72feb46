// reports/page_measured.c
// The model against measured shapes, in the layout of the paper's Tables II and III.
#include "reports/measured_show.h"
#include "reports/page_kit.h"

// Without shapes of the case's own there is nothing to hold the model against: the paper's errors
// alone.
static bool has_lines(const run_result *r)
{
    return r->measured.nline > 0;
}

static status head(bytes *page, bool lines, bool paper)
{
    status st = OK;
    PAGE("<thead><tr><th class=\"text\">shape</th><th class=\"text\">tendon</th>"
         "<th>tension<small>N</small></th>");
    if (lines) {
        PAGE("<th>tip error<small>mm (%% of L)</small></th>"
             "<th>shape error<small>%%</small></th><th>rms distance<small>mm</small></th>"
             "<th>largest<small>mm at s in mm</small></th><th>tangents at the "
             "tip<small>deg apart</small></th>");
    }
    if (paper) {
        PAGE("<th>the paper's tip error<small>mm (%% of L)</small></th>"
             "<th>the paper's shape error<small>%%</small></th>");
    }
    PAGE("</tr></thead>\n<tbody>\n");

done:
    return st;
}

static status row(bytes *page, const run_result *r, const measured_row *one, bool paper)
{
    status st = OK;
    const measured_cells c = measured_cells_of(r, one, " ± ");
    PAGE("<tr><td class=\"text\">");
    TRY(page_escaped(page, c.name));
    PAGE("%s</td><td class=\"text\">", one->line && r->measured.synthetic ? " (synthetic)" : "");
    TRY(page_escaped(page, c.tendon));
    PAGE("</td><td>%s</td>", c.tension);
    if (has_lines(r)) {
        PAGE("<td>%s</td><td>%s</td><td>%s</td><td>%s</td><td>%s</td>", c.tip, c.shape, c.rms,
             c.largest, c.angle);
    }
    if (paper) {
        PAGE("<td>%s</td><td>%s</td>", c.paper_tip, c.paper_shape);
    }
    PAGE("</tr>\n");

done:
    return st;
}

static status doubts(bytes *page, const run_result *r)
{
    status st = OK;
    char words[MEASURED_NOTES];
    for (int i = 0; i < r->measured.nline; i++) {
        measured_line_notes(r, &r->measured.line[i], words, sizeof words);
        if (words[0]) {
            PAGE("<p class=\"note warn\">");
            TRY(page_escaped(page, r->measured.line[i].name));
            PAGE(": ");
            TRY(page_escaped(page, words));
            PAGE(".</p>\n");
        }
    }

done:
    return st;
}

static status table(bytes *page, const run_result *r)
{
    status st = OK;
    measured_row rows[MEASURED_ROWS];
    const int n = measured_rows(r, rows);
    const bool paper = measured_has_paper(r);
    PAGE("<div class=\"scroll\"><table>\n<caption>%s against %s</caption>\n",
         has_lines(r) ? "The model" : "The paper's model", measured_word(r));
    TRY(head(page, has_lines(r), paper));
    for (int i = 0; i < n; i++) {
        TRY(row(page, r, &rows[i], paper));
    }
    PAGE("</tbody></table></div>\n");
    TRY(doubts(page, r));
    if (paper) {
        PAGE("<p class=\"note\">%s.</p>\n", measured_paper_words(r));
    }

done:
    return st;
}

static status definitions(bytes *page, const run_result *r)
{
    status st = OK;
    PAGE(
        "<p class=\"note\">Tip error: |p(L) − p<sub>measured</sub>(L)|. Shape error: the mean over "
        "the measured arclength of |p(s) − p<sub>measured</sub>(s)| / s.");
    if (!has_lines(r)) {
        PAGE("</p>\n");
        return OK;
    }
    PAGE(" Uncertainties are standard "
         "ones, of the measurement alone. The arclength is the unloaded rod's%s.</p>\n",
         r->measured.arclength == ARCLENGTH_REST
             ? ", as the data has it"
             : ": a measured one is taken back to it by the model's stretch, tip to tip where the "
               "tip was measured");

done:
    return st;
}

status page_measured(bytes *page, const run_result *r, const char *dir)
{
    status st = OK;
    char words[MEASURED_SOURCE + 80];
    if (!r->has_measured) {
        return OK;
    }
    measured_data_words(r, words, sizeof words);
    PAGE("<h2 id=\"measured\">Against %s</h2>\n<p%s>", measured_word(r),
         r->measured.synthetic ? " class=\"note warn\"" : "");
    TRY(page_escaped(page, words));
    PAGE(".</p>\n");
    TRY(table(page, r));
    TRY(definitions(page, r));
    TRY(page_figure(page, dir, "measured",
                    r->measured.synthetic
                        ? "The model (lines) and synthetic shapes (dots), from three sides."
                        : "The model (lines) and measured shapes (dots), from three sides."));
    TRY(page_figure(page, dir, "measured_along",
                    r->measured.synthetic
                        ? "Curvature of the model and of the synthetic shapes along the rod."
                        : "Curvature of the model and of the measured shapes along the rod."));

done:
    return st;
}
