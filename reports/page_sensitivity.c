// reports/page_sensitivity.c
// What moves the answer: the tornado plot, a table of the solution it moves most, random samples.
#include "reports/page_kit.h"

#include <math.h>
#include <stdio.h>

enum { SHOWN_SOLUTIONS = 8 };
static const double degrees = 180 / 3.14159265358979323846;

static status number(bytes *page, double value, int decimals)
{
    status st = OK;
    PAGE("<td>%s</td>", isnan(value) ? "" : number_fixed(value, decimals).text);

done:
    return st;
}

static status mover_cells(bytes *page, const mover *p)
{
    status st = OK;
    PAGE("<tr><td class=\"text\">");
    TRY(page_escaped(page, p->name));
    PAGE(" <small>");
    TRY(page_escaped(page, p->unit));
    PAGE("</small></td><td>");
    TRY(page_escaped(page, p->text));
    PAGE("</td><td>");
    TRY(page_escaped(page, p->end[MOVER_LOW].text));
    PAGE("</td><td>");
    TRY(page_escaped(page, p->end[MOVER_HIGH].text));
    PAGE("</td>");

done:
    return st;
}

static status move_line(bytes *page, const run_result *r, const mover *p, const move *m)
{
    status st = OK;
    TRY(mover_cells(page, p));
    TRY(number(page, 1e3 * move_size(m, MOVER_LOW), 3));
    TRY(number(page, 1e3 * move_size(m, MOVER_HIGH), 3));
    TRY(number(page, 100 * move_largest(m) / r->rod_length, 2));
    TRY(number(page, degrees * m->bend[MOVER_LOW], 2));
    TRY(number(page, degrees * m->bend[MOVER_HIGH], 2));
    const double rate = 1e3 * hypot(hypot(m->rate[0], m->rate[1]), m->rate[2]);
    PAGE("<td>%s</td>", isnan(rate) ? "" : number_digits(rate, 5).text);
    const double off = fmax(move_nonlinearity(p, m, MOVER_LOW, r->rod_length),
                            move_nonlinearity(p, m, MOVER_HIGH, r->rod_length));
    TRY(number(page, 100 * off, 1));
    PAGE("</tr>\n");

done:
    return st;
}

static status moves_table(bytes *page, const run_result *r, int solution)
{
    status st = OK;
    const sensitivity_result *s = &r->sensitivity;
    const struct rod_run *run = &r->rod.run[s->solution[solution]];
    int order[MOST_MOVERS];
    PAGE("<h3>Solution %d: tip at (%s, %s, %s) mm, bend %s deg</h3>\n", s->solution[solution] + 1,
         number_fixed(1e3 * run->tip.p.a[0], 3).text, number_fixed(1e3 * run->tip.p.a[1], 3).text,
         number_fixed(1e3 * run->tip.p.a[2], 3).text,
         number_fixed(degrees * run->total_bend_rad, 2).text);
    PAGE("<div class=\"scroll\"><table>\n<thead><tr><th class=\"text\">parameter</th><th>as it "
         "is</th><th>low</th><th>high, or instead</th><th>tip moves<small>at low, "
         "mm</small></th><th>tip moves<small>at high, mm</small></th><th>at most<small>%% of "
         "L</small></th><th>bend<small>at low, deg</small></th><th>bend<small>at high, "
         "deg</small></th><th>derivative<small>mm per unit</small></th><th>it alone is "
         "off<small>%%</small></th></tr></thead>\n<tbody>\n");
    sensitivity_sort(s, solution, order);
    for (int i = 0; i < s->nmover; i++) {
        TRY(move_line(page, r, &s->mover[order[i]], sensitivity_move(s, order[i], solution)));
    }
    PAGE("</tbody></table></div>\n");

done:
    return st;
}

// --- random samples

static status spread_head(bytes *page, const sensitivity_result *s)
{
    status st = OK;
    PAGE("<div class=\"scroll\"><table>\n<thead><tr><th class=\"text\">solution</th><th "
         "class=\"text\"></th><th>mean</th><th>deviation</th><th>5 %%</th><th>50 %%</th><th>95 "
         "%%</th>");
    for (int k = 0; k < s->nmover; k++) {
        if (s->mover[k].drawn) {
            PAGE("<th>");
            TRY(page_escaped(page, s->mover[k].name));
            PAGE("<small>%% of variance</small></th>");
        }
    }
    PAGE("<th>together<small>%% of variance</small></th></tr></thead>\n<tbody>\n");

done:
    return st;
}

static status spread_line(bytes *page, const sensitivity_result *s, int solution, int quantity)
{
    static const char *const names[SPREAD_QUANTITIES] = {"tip x, mm", "tip y, mm", "tip z, mm",
                                                         "tip off its place, mm", "bend, deg"};
    status st = OK;
    const sample_spread *a = sensitivity_spread(s, solution, quantity);
    const double *share = sensitivity_share(s, solution, quantity);
    const double unit = quantity == SPREAD_BEND ? degrees : 1e3;
    PAGE("<tr><td class=\"text\">%d</td><td class=\"text\">%s</td>", s->solution[solution] + 1,
         names[quantity]);
    const double numbers[] = {a->mean, a->deviation, a->low, a->median, a->high};
    for (int i = 0; i < 5; i++) {
        TRY(number(page, unit * numbers[i], 3));
    }
    for (int k = 0; k < s->nmover; k++) {
        TRY(s->mover[k].drawn ? number(page, 100 * share[k], 1) : OK);
    }
    TRY(number(page, 100 * a->rest, 1));
    PAGE("</tr>\n");

done:
    return st;
}

static status monte_carlo_part(bytes *page, const sensitivity_result *s)
{
    status st = OK;
    const monte_carlo *m = &s->monte_carlo;
    int least = m->nsample;
    for (int i = 0; i < s->nsolution; i++) {
        least = m->used[i] < least ? m->used[i] : least;
    }
    PAGE("<h3 id=\"monte-carlo\">All of them at random</h3>\n<p>%d samples with seed %d, each "
         "solved "
         "anew. Shares of the variance are of first order: by a sum of one polynomial of degree %d "
         "per parameter. ",
         m->nsample, m->seed, m->degree);
    if (least < m->nsample) {
        PAGE("<span class=\"bad\">Up to %d samples have no answer</span> (a tendon that eats its "
             "length, a limit point) and are left out.",
             m->nsample - least);
    }
    PAGE("</p>\n");
    TRY(spread_head(page, s));
    for (int i = 0; i < s->nsolution && i < SHOWN_SOLUTIONS; i++) {
        for (int q = 0; q < SPREAD_QUANTITIES; q++) {
            TRY(spread_line(page, s, i, q));
        }
    }
    PAGE("</tbody></table></div>\n");

done:
    return st;
}

static status reasons(bytes *page, const sensitivity_result *s)
{
    status st = OK;
    for (int k = 0; k < s->nmover; k++) {
        const mover *p = &s->mover[k];
        const char *const words[] = {p->end[MOVER_LOW].why, p->end[MOVER_HIGH].why, p->no_rate};
        for (int i = 0; i < 3; i++) {
            if (words[i][0]) {
                PAGE("<p class=\"skip\">");
                TRY(page_escaped(page, p->name));
                PAGE("%s", i == 0   ? " at its low end: "
                           : i == 1 ? " at its high end: "
                                    : ", no derivative: ");
                TRY(page_escaped(page, words[i]));
                PAGE("</p>\n");
            }
        }
    }

done:
    return st;
}

status page_sensitivity(bytes *page, const run_result *r, const char *dir)
{
    status st = OK;
    const sensitivity_result *s = &r->sensitivity;
    if (!r->has_sensitivity) {
        return OK;
    }
    PAGE(
        "<h2 id=\"sensitivity\">What moves the answer</h2>\n<p>%d parameters, one at a time%s: the "
        "rod solved anew at both ends of each range, and its own derivative. The table's last "
        "column says how far the derivative alone is from the whole solve.</p>\n",
        s->nmover, s->own_list ? " (the case names none: the list for any case)" : "");
    TRY(page_figure(page, dir, "tornado", "How far each parameter moves the tip."));
    for (int i = 0; i < s->nsolution && i < SHOWN_SOLUTIONS; i++) {
        TRY(moves_table(page, r, i));
    }
    TRY(reasons(page, s));
    TRY(s->monte_carlo.nsample > 0 ? monte_carlo_part(page, s) : OK);

done:
    return st;
}
