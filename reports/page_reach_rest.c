// reports/page_reach_rest.c
// How thorough "not reached" is, and what a search for a better design found.
#include "reach/reach_case.h"
#include "reports/page_reach_parts.h"
#include "reports/reach_show.h"

#include <math.h>

enum { SHOWN_ROWS = 60 };

// --- how thorough --------------------------------------------------------------------------------

typedef struct tally {
    int missed, proved, whole, searched, looks, starts;
    double bound; // largest that is known and not negative [m]; -1: none
} tally;

// whole: every bend was looked at; searched: from starts, or until the looks ran out
static tally tally_of(const reach_result *r, const reach_scope_result *s)
{
    tally t = {.bound = -1};
    for (int k = 0; k < r->ntarget; k++) {
        const reach_answer *a = &s->answer[k];
        const bool far = a->verdict == REACH_OUT_OF_REACH || a->verdict == REACH_JOINT_LIMIT;
        if (a->verdict == REACH_REACHED) {
            continue;
        }
        t.missed++;
        if (reach_is_proved(r, s, a)) {
            t.proved++;
        } else if (far && reach_one_bend(s)) {
            t.whole++;
        } else {
            t.searched++;
            t.bound = isfinite(a->bound) ? fmax(t.bound, a->bound) : t.bound;
        }
        t.looks = a->looks > t.looks ? a->looks : t.looks;
        t.starts = a->starts > t.starts ? a->starts : t.starts;
    }
    return t;
}

static status thorough_row(bytes *page, const reach_result *r, const reach_scope_result *s)
{
    status st = OK;
    const tally t = tally_of(r, s);
    PAGE("<tr><td class=\"text\">");
    TRY(page_escaped(page, s->name));
    PAGE("</td><td>%d</td><td>%d</td><td>%d</td><td>%d<small>%s%s</small></td><td>%d, %d</td>"
         "<td>%s",
         t.missed, t.proved, t.whole, t.searched, t.bound >= 0 ? "bound left, mm: " : "",
         t.bound >= 0 ? number_digits(1e3 * t.bound, 2).text : "", t.looks, t.starts,
         number_digits(1e3 * s->spacing, 2).text);
    if (s->state) {
        PAGE("<small>of the map: %s</small>", number_digits(1e3 * s->map_spacing, 2).text);
    }
    PAGE("</td></tr>\n");

done:
    return st;
}

status page_reach_thoroughness(bytes *page, const reach_result *r)
{
    status st = OK;
    if (r->nscope == 0) {
        return OK;
    }
    PAGE("<h3>How thorough “not reached” is</h3>\n<div class=\"scroll\"><table>\n<thead><tr><th "
         "class=\"text\">scope</th><th>not reached<small>targets</small></th><th>proved<small>by "
         "a bound or in closed form</small></th><th>tip not near<small>every bend looked "
         "at</small></th><th>searched "
         "only</th><th>looks, starts<small>at most, per target</small></th><th>tips "
         "apart<small>mm</small></th></tr></thead>\n<tbody>\n");
    for (int i = 0; i < r->nscope; i++) {
        TRY(thorough_row(page, r, &r->scope[i]));
    }
    PAGE("</tbody></table></div>\n<p class=\"note\">Proved: the joints are cut into boxes, and in "
         "none whose tips come near can the body have the clearance asked for; or the scope is an "
         "arc, whose tip is known in closed form at every bend. Every bend looked at: the tip's "
         "curve is followed by cubics through poses as far apart as told. Searched "
         "only: no pose was found from the starts told, or none has more clearance than the bound "
         "left, in steps down to %s mm; that is no proof.%s</p>\n",
         number_short(1e3 * r->resolution, 3).text,
         r->path == REACH_INSERTION ? " No way in: the pose is there, and ways to it were searched."
                                    : "");

done:
    return st;
}

// --- design --------------------------------------------------------------------------------------

static status value(bytes *page, double x)
{
    return bytes_format(page, "<td>%s</td>", isfinite(x) ? number_short(x, 6).text : "");
}

static status goal_value(bytes *page, const reach_design_result *d, double goal)
{
    if (!isfinite(goal)) {
        return bytes_text(page, "<td>no answer</td>");
    }
    return d->goal == DESIGN_AREA
               ? bytes_format(page, "<td>%s %%</td>", number_fixed(100 * goal, 2).text)
               : bytes_format(page, "<td>%s</td>", number_short(goal, 6).text);
}

static status parameter_rows(bytes *page, const reach_design_result *d,
                             const reach_design_row *best)
{
    status st = OK;
    for (int i = 0; i < d->nparameter; i++) {
        PAGE("<tr><td class=\"text\">");
        TRY(page_escaped(page, d->name[i]));
        PAGE("</td><td class=\"text\">");
        TRY(page_escaped(page, d->unit[i]));
        PAGE("</td>");
        TRY(value(page, d->lower[i]));
        TRY(value(page, d->upper[i]));
        TRY(value(page, d->start[i]));
        TRY(value(page, best ? best->value[i] : NAN));
        PAGE("</tr>\n");
    }
    PAGE("<tr><td class=\"text\"><b>%s</b></td><td></td><td></td><td></td>",
         d->goal == DESIGN_AREA ? "area reached" : "targets reached");
    TRY(goal_value(page, d, d->start_goal));
    TRY(goal_value(page, d, best ? best->goal : NAN));
    PAGE("</tr>\n<tr><td class=\"text\">score, what was maximised</td><td></td><td></td><td></td>");
    TRY(value(page, d->start_score));
    TRY(value(page, best ? best->score : NAN));
    PAGE("</tr>\n");

done:
    return st;
}

static status improvements(bytes *page, const reach_design_result *d)
{
    status st = OK;
    const int shown = d->nrow < SHOWN_ROWS ? d->nrow : SHOWN_ROWS;
    PAGE("<div class=\"scroll\"><table>\n<caption>Improvements on the way</caption>\n<thead><tr>"
         "<th>island</th><th>evaluation</th><th>goal</th><th>score</th>");
    for (int i = 0; i < d->nparameter; i++) {
        PAGE("<th>");
        TRY(page_escaped(page, d->name[i]));
        PAGE("</th>");
    }
    PAGE("</tr></thead>\n<tbody>\n");
    for (int k = 0; k < shown; k++) {
        const reach_design_row *row = &d->row[k];
        PAGE("<tr><td>%d</td><td>%d</td>", row->island + 1, row->evaluation);
        TRY(goal_value(page, d, row->goal));
        TRY(value(page, row->score));
        for (int i = 0; i < d->nparameter; i++) {
            TRY(value(page, row->value[i]));
        }
        PAGE("</tr>\n");
    }
    PAGE("</tbody></table></div>\n");
    if (shown < d->nrow) {
        PAGE("<p>And %d more in design.csv.</p>\n", d->nrow - shown);
    }

done:
    return st;
}

status page_reach_design(bytes *page, const reach_result *r, const char *dir)
{
    status st = OK;
    const reach_design_result *d = &r->design;
    const reach_design_row *best = d->nrow > 0 ? &d->row[d->best] : NULL;
    if (!d->there) {
        return OK;
    }
    PAGE("<h3 id=\"design\">Search for a better design%s</h3>\n<p>The scope ",
         r->synthetic ? ", in synthetic anatomy" : "");
    TRY(page_escaped(page, d->scope));
    PAGE(" was varied to make the %s largest: %d evaluations by %d search%s side by side from "
         "seed %d, %d of them without an answer. The best that was found is no proof of the best "
         "that there is.</p>\n",
         d->goal == DESIGN_AREA ? "area that it reaches" : "number of targets that it reaches",
         d->evaluations, d->islands, d->islands == 1 ? "" : "es", d->seed, d->failed);
    PAGE("<div class=\"scroll\"><table>\n<thead><tr><th class=\"text\">parameter</th><th "
         "class=\"text\">unit</th><th>least</th><th>most</th><th>start</th><th>best found</th>"
         "</tr></thead>\n<tbody>\n");
    TRY(parameter_rows(page, d, best));
    PAGE("</tbody></table></div>\n");
    TRY(page_figure(page, dir, "design", "How the search went."));
    TRY(d->nrow > 0 ? improvements(page, d) : OK);

done:
    return st;
}
