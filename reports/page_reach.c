// reports/page_reach.c
// Where the scopes reach: on which anatomy, how many targets, which and why not, and how surely.
#include "reach/reach_case.h"
#include "reports/page_reach_parts.h"
#include "reports/reach_show.h"

#include <math.h>
#include <stdio.h>

enum { SHOWN_TARGETS = 100 };
static const double degrees = 180 / 3.14159265358979323846;

static status anatomy(bytes *page, const reach_result *r)
{
    status st = OK;
    PAGE("<p%s>", r->synthetic ? " class=\"note warn\"" : "");
    if (r->synthetic) {
        PAGE("<b>The anatomy is synthetic</b>, no patient's: what is reached in it says how the "
             "scopes compare there, and nothing of a patient. ");
    }
    PAGE("Tissue: ");
    TRY(page_escaped(page, r->tissue));
    PAGE(", %d triangles, %s mm², enclosing %s ml. ", r->ntriangle,
         number_digits(1e6 * r->area, 4).text, number_digits(1e6 * r->volume, 4).text);
    if (r->source[0]) {
        PAGE("Source: ");
        TRY(page_escaped(page, r->source));
    }
    PAGE("</p>\n");

done:
    return st;
}

static status question(bytes *page, const reach_result *r)
{
    status st = OK;
    const mat3 *R = &r->entry.R;
    PAGE("<p>A target counts as reached where the %s comes within %s mm of it with every joint in "
         "its limits and %s. Checked: %s.</p>\n",
         r->tip == REACH_TIP_SKIN ? "tip's skin" : "tip's centre",
         number_short(1e3 * r->tolerance, 4).text,
         r->clearance > 0 ? "the whole body as far from tissue as asked for"
                          : "no part of the body in tissue",
         reach_checked_words(r));
    PAGE("<p>The scopes enter at (%s, %s, %s) mm along (%s, %s, %s)",
         number_short(1e3 * r->entry.p.a[0], 5).text, number_short(1e3 * r->entry.p.a[1], 5).text,
         number_short(1e3 * r->entry.p.a[2], 5).text, number_fixed(R->a[0][2], 4).text,
         number_fixed(R->a[1][2], 4).text, number_fixed(R->a[2][2], 4).text);
    if (r->entry_free > 0) {
        PAGE("; the shaft is not looked at over the first %s mm of that line, the channel to the "
             "hollow",
             number_short(1e3 * r->entry_free, 4).text);
    }
    if (r->clearance > 0) {
        PAGE("; %s mm are left between body and tissue", number_short(1e3 * r->clearance, 4).text);
    }
    PAGE(".</p>\n");
    if (r->nmap > 0) {
        PAGE("<p>A place of the wall counts as reached where the tip's skin comes within %s mm of "
             "it, tolerance and clearance together, whatever of the tip is asked for at targets: "
             "%d places, equally many per area.</p>\n",
             number_short(1e3 * (r->tolerance + r->clearance), 4).text, r->nmap);
    }

done:
    return st;
}

// --- scopes beside each other --------------------------------------------------------------------

static status scope_row(bytes *page, const reach_result *r, const reach_scope_result *s, bool best)
{
    status st = OK;
    PAGE("<tr><td class=\"text\">");
    TRY(page_escaped(page, s->name));
    PAGE("<small>");
    TRY(page_escaped(page, s->kind));
    PAGE("</small></td>");
    if (r->ntarget > 0) {
        PAGE("<td%s>%d of %d</td><td>%d</td>", best ? " class=\"good\"" : "", s->nreached,
             r->ntarget, reach_open_count(r, s));
    } else {
        PAGE("<td></td><td></td>");
    }
    if (s->state) {
        PAGE("<td>%s ± %s</td><td>%s</td>", number_fixed(100 * s->area_reached, 1).text,
             number_fixed(100 * s->area_error, 1).text,
             number_fixed(100 * s->area_undecided, 1).text);
    } else {
        PAGE("<td></td><td></td>");
    }
    PAGE("<td>%s</td><td>%s</td><td>%s</td><td class=\"text\">%s</td></tr>\n",
         number_short(1e3 * s->length, 4).text, number_short(1e3 * s->radius, 4).text,
         number_digits(s->seconds, 2).text, r->synthetic ? "synthetic" : "as given");

done:
    return st;
}

static status paper_row(bytes *page, const char *name, int reached)
{
    return bytes_format(page,
                        "<tr class=\"skip\"><td class=\"text\">%s<small>as printed in the "
                        "paper</small></td><td>%d of "
                        "%d</td><td></td><td></td><td></td><td></td><td></td><td></td><td "
                        "class=\"text\">a patient's, not published</td></tr>\n",
                        name, reached, PAPER_REACH_TARGETS);
}

static status scope_table(bytes *page, const reach_result *r)
{
    status st = OK;
    const int best = reach_best_scope(r);
    PAGE("<div class=\"scroll\"><table>\n<caption>The scopes beside each other</caption>\n"
         "<thead><tr><th class=\"text\">scope</th><th>targets reached</th><th>collision<small>not "
         "proved</small></th><th>area "
         "reached<small>%% of the wall</small></th><th>not known<small>%%</small></th>"
         "<th>tip<small>length, mm</small></th><th>radius<small>mm</small></th><th>CPU "
         "time<small>s</small></th><th class=\"text\">anatomy</th></tr></thead>\n<tbody>\n");
    for (int i = 0; i < r->nscope; i++) {
        TRY(scope_row(page, r, &r->scope[i],
                      r->nscope > 1 && r->scope[i].nreached == r->scope[best].nreached));
    }
    if (r->paper == REACH_PAPER_TABLE_4) {
        TRY(paper_row(page, "constant curvature", PAPER_REACH_CONSTANT_CURVATURE));
        TRY(paper_row(page, "helical stiffness", PAPER_REACH_HELICAL));
    }
    PAGE("</tbody></table></div>\n");
    if (r->paper == REACH_PAPER_TABLE_4) {
        PAGE("<p class=\"note\">The paper's counts (Table IV) are as printed in the paper, on a "
             "patient's anatomy that is not published: they stand here to be read beside ours, "
             "not to be met.</p>\n");
    }

done:
    return st;
}

// --- joint limits --------------------------------------------------------------------------------

static status range(bytes *page, double low, double high, double unit)
{
    return bytes_format(page, "%s to %s", number_short(unit * low, 5).text,
                        number_short(unit * high, 5).text);
}

static status limits_row(bytes *page, const reach_scope_result *s)
{
    status st = OK;
    PAGE("<tr><td class=\"text\">");
    TRY(page_escaped(page, s->name));
    PAGE("</td><td>");
    TRY(range(page, s->low[SCOPE_INSERTION], s->high[SCOPE_INSERTION], 1e3));
    PAGE("</td><td>");
    TRY(range(page, s->low[SCOPE_TURN], s->high[SCOPE_TURN], degrees));
    PAGE("</td><td class=\"text\">");
    for (int i = SCOPE_BEND; i < s->njoint; i++) {
        char name[REACH_NAME];
        PAGE("%s%s ", i > SCOPE_BEND ? ", " : "", reach_joint_words(s, i, name, sizeof name));
        TRY(range(page, s->low[i], s->high[i], s->arc ? degrees : 1));
        PAGE(" %s", s->arc ? "deg" : "N");
    }
    PAGE("</td><td class=\"text\">");
    TRY(page_escaped(page, s->limit_note[0] ? s->limit_note : "as the case gives them"));
    PAGE("</td></tr>\n");

done:
    return st;
}

static status limits_table(bytes *page, const reach_result *r)
{
    status st = OK;
    PAGE("<h3>Joint limits as used</h3>\n<div class=\"scroll\"><table>\n<thead><tr><th "
         "class=\"text\">scope</th><th>insertion<small>mm</small></th><th>turn<small>deg"
         "</small></th><th class=\"text\">bending</th><th class=\"text\">from "
         "where</th></tr></thead>\n<tbody>\n");
    for (int i = 0; i < r->nscope; i++) {
        TRY(limits_row(page, &r->scope[i]));
    }
    PAGE("</tbody></table></div>\n");

done:
    return st;
}

// --- targets -------------------------------------------------------------------------------------

static status reached_words(bytes *page, const reach_scope_result *s, const reach_answer *a)
{
    status st = OK;
    if (isfinite(a->clearance)) {
        PAGE("<small>clearance %s mm", number_fixed(1e3 * a->clearance, 2).text);
        if (a->s < 0) {
            PAGE(" on the shaft</small>");
        } else {
            PAGE(" at s = %s mm</small>", number_fixed(1e3 * a->s, 1).text);
        }
    }
    PAGE("<small>");
    for (int i = SCOPE_BEND; i < s->njoint; i++) {
        char name[REACH_NAME];
        PAGE("%s%s %s %s", i > SCOPE_BEND ? ", " : "", reach_joint_words(s, i, name, sizeof name),
             s->arc ? number_fixed(degrees * a->q[i], 1).text : number_digits(a->q[i], 3).text,
             s->arc ? "deg" : "N");
    }
    PAGE("</small>");
    if (isfinite(a->strain)) {
        PAGE("<small>strain %s %%</small>", number_fixed(100 * a->strain, 2).text);
    }
    if (isfinite(a->path_clearance)) {
        PAGE("<small>on the way in %s mm</small>", number_fixed(1e3 * a->path_clearance, 2).text);
    }

done:
    return st;
}

static status answer_cell(bytes *page, const reach_result *r, const reach_scope_result *s,
                          const reach_answer *a)
{
    status st = OK;
    const bool reached = a->verdict == REACH_REACHED;
    PAGE("<td class=\"text\"><span class=\"%s\">%s %s</span>", reached ? "good" : "bad",
         reached ? "✓" : "✗", reach_told_words(r, s, a));
    if (reached) {
        TRY(reached_words(page, s, a));
    } else {
        PAGE("<small>");
        TRY(page_escaped(page, a->why));
        PAGE("</small>%s", reach_is_proved(r, s, a) ? "<small>proved</small>" : "");
    }
    PAGE("</td>");

done:
    return st;
}

static status target_row(bytes *page, const reach_result *r, int target)
{
    status st = OK;
    const double *p = r->target[target];
    PAGE("<tr><td class=\"text\">");
    TRY(page_escaped(page, r->target_name[target]));
    PAGE("<small>no. %d at (%s, %s, %s)</small></td><td>%s</td>", target + 1,
         number_fixed(1e3 * p[0], 1).text, number_fixed(1e3 * p[1], 1).text,
         number_fixed(1e3 * p[2], 1).text,
         isfinite(r->target_depth[target]) ? number_fixed(1e3 * r->target_depth[target], 2).text
                                           : "");
    for (int i = 0; i < r->nscope; i++) {
        TRY(answer_cell(page, r, &r->scope[i], &r->scope[i].answer[target]));
    }
    PAGE("</tr>\n");

done:
    return st;
}

static status target_table(bytes *page, const reach_result *r)
{
    status st = OK;
    const int shown = r->ntarget < SHOWN_TARGETS ? r->ntarget : SHOWN_TARGETS;
    PAGE("<h3>Target by target%s</h3>\n<div class=\"scroll\"><table>\n<thead><tr><th "
         "class=\"text\">target<small>mm</small></th><th>from the wall<small>mm</small></th>",
         r->synthetic ? ", in synthetic anatomy" : "");
    for (int i = 0; i < r->nscope; i++) {
        PAGE("<th class=\"text\">");
        TRY(page_escaped(page, r->scope[i].name));
        PAGE("</th>");
    }
    PAGE("</tr></thead>\n<tbody>\n");
    for (int k = 0; k < shown; k++) {
        TRY(target_row(page, r, k));
    }
    PAGE("</tbody></table></div>\n");
    if (shown < r->ntarget) {
        PAGE("<p>And %d more in reach.csv.</p>\n", r->ntarget - shown);
    }

done:
    return st;
}

// --- the whole -----------------------------------------------------------------------------------

static status pictures(bytes *page, const run_result *run, const char *dir)
{
    status st = OK;
    const reach_result *r = &run->reach;
    TRY(page_figure(page, dir, "reach",
                    r->synthetic ? "The scopes in their poses, in synthetic anatomy."
                                 : "The scopes in their poses."));
    TRY(page_reach_view(page, run));
    TRY(page_figure(page, dir, "reach_clearance", "The room along each body, target by target."));
    TRY(page_figure(page, dir, "reach_map",
                    r->synthetic ? "What of the wall the tips reach, in synthetic anatomy."
                                 : "What of the wall the tips reach."));

done:
    return st;
}

status page_reach(bytes *page, const run_result *run, const char *dir)
{
    status st = OK;
    const reach_result *r = &run->reach;
    if (!r->there) {
        return OK;
    }
    PAGE("<h2 id=\"reach\">Where the scopes reach</h2>\n");
    TRY(anatomy(page, r));
    TRY(question(page, r));
    TRY(r->nscope > 0 ? scope_table(page, r) : OK);
    TRY(pictures(page, run, dir));
    TRY(r->ntarget > 0 && r->nscope > 0 ? target_table(page, r) : OK);
    TRY(page_reach_thoroughness(page, r));
    TRY(limits_table(page, r));
    TRY(page_reach_design(page, r, dir));

done:
    return st;
}
