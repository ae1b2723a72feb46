// reports/page_rod_parts.c
// What acts on the rod, and what kind of equilibria its solutions are.
#include "reports/page_rod_parts.h"

#include "reports/rod_show.h"

#include <math.h>

enum { LOADS_LISTED = 20, CRITICAL_LISTED = 4, NAMED = 6 };

typedef struct rod_run rod_run;

static int least(int a, int b)
{
    return a < b ? a : b;
}

rod_rows rod_rows_choose(const rod_result *rod)
{
    rod_rows rows = {.ntendon = least(rod->ntendon, ROD_MOST_TENDONS)};
    rows.count = rod_spread(rod->nsolution, ROD_MOST_ROWS, rows.row);
    for (int i = 0; i < rod->nsolution; i++) {
        for (int k = 0; k < rod->nload; k++) {
            if (rod->run[i].load[k] != 1) {
                rows.nload = least(rod->nload, ROD_MOST_LOADS);
            }
        }
    }
    return rows;
}

// --- warnings

static bool stops(const rod_run *run)
{
    return run->fraction < 1;
}

static bool is_unstable(const rod_run *run)
{
    return run->stable == 0;
}

// the numbers of the first solutions that are so
static status numbers(bytes *page, const rod_result *rod, bool (*is)(const rod_run *))
{
    status st = OK;
    int named = 0;
    for (int i = 0; i < rod->nsolution; i++) {
        if (is(&rod->run[i]) && named < NAMED) {
            PAGE("%s%d", named > 0 ? ", " : "no. ", i + 1);
            named++;
        } else if (is(&rod->run[i])) {
            PAGE(", …");
            break;
        }
    }

done:
    return st;
}

static int count_of(const rod_result *rod, bool (*is)(const rod_run *))
{
    int count = 0;
    for (int i = 0; i < rod->nsolution; i++) {
        count += is(&rod->run[i]);
    }
    return count;
}

status page_rod_warnings(bytes *page, const run_result *r)
{
    static const struct {
        bool (*is)(const rod_run *);
        const char *words;
    } kinds[] = {
        {stops, "stop at a limit point, where the rod snaps: not all of their loads and tensions "
                "could be reached. What is shown is the shape there"},
        {is_unstable, "are unstable: balanced, but a real rod does not stay there"},
        {rod_error_is_large, "have an estimated error of the tip of more than 1 % of the length: "
                             "do not rely on them"},
    };
    status st = OK;
    const rod_result *rod = &r->rod;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        const int count = count_of(rod, kinds[i].is);
        if (count > 0) {
            PAGE("<p class=\"note warn\">⚠ %d of %d solutions %s (", count, rod->nsolution,
                 kinds[i].words);
            TRY(numbers(page, rod, kinds[i].is));
            PAGE(").</p>\n");
        }
    }

done:
    return st;
}

// --- loads

static status vector_cell(bytes *page, const vec3 *v, double unit)
{
    status st = OK;
    if (vec3_norm(*v) > 0) {
        PAGE("<td>%s, %s, %s</td>", number_short(v->a[0] * unit, 4).text,
             number_short(v->a[1] * unit, 4).text, number_short(v->a[2] * unit, 4).text);
    } else {
        PAGE("<td></td>");
    }

done:
    return st;
}

// a load that varies is told by both of its ends
static status load_row(bytes *page, const rod_result *rod, int load)
{
    static const char *const frames[] = {"fixed in space", "turning with the section"};
    status st = OK;
    const rod_load_sketch *l = &rod->load_sketch[load];
    const bool point = l->kind == LOAD_AT_POINT;
    PAGE("<tr><td class=\"text\">");
    TRY(page_escaped(page, rod->load_name[load]));
    if (l->kind == LOAD_GRAVITY) {
        PAGE("</td><td>everywhere</td><td>%s, %s, %s m/s²</td><td></td><td>fixed in space</td>"
             "</tr>\n",
             number_short(l->acceleration.a[0], 5).text, number_short(l->acceleration.a[1], 5).text,
             number_short(l->acceleration.a[2], 5).text);
        return OK;
    }
    for (int k = 0; k < (point ? 1 : 2); k++) {
        const int at = k * (LOAD_PLACES - 1);
        const double s = k ? l->to : l->from;
        PAGE("%s</td><td>%s</td>", k ? "<tr><td>" : "", number_short(s * 1e3, 5).text);
        TRY(vector_cell(page, &l->force[at], 1));
        TRY(vector_cell(page, &l->moment[at], point ? 1e3 : 1));
        PAGE("<td>%s%s</td></tr>\n", frames[l->frame == LOAD_BODY], point ? "" : ", per length");
    }

done:
    return st;
}

status page_rod_loads(bytes *page, const run_result *r)
{
    status st = OK;
    const rod_result *rod = &r->rod;
    if (rod->nload == 0) {
        return OK;
    }
    PAGE("<div class=\"scroll\"><table>\n<caption>Loads at factor 1; one that acts along the rod "
         "by its values at both ends, per length</caption>\n<thead><tr><th>load</th><th>s<small>mm"
         "</small></th><th>force<small>x, y, z in N or N/m</small></th><th>moment<small>x, y, z in "
         "N mm or N</small></th><th>directions</th></tr></thead>\n<tbody>\n");
    for (int i = 0; i < rod->nload && i < LOADS_LISTED; i++) {
        TRY(load_row(page, rod, i));
    }
    PAGE("</tbody></table></div>\n");
    if (rod->nload > LOADS_LISTED) {
        PAGE("<p class=\"note\">%d more loads: in result.hdf.</p>\n", rod->nload - LOADS_LISTED);
    }

done:
    return st;
}

// --- equilibria

static status critical_cell(bytes *page, const rod_run *run)
{
    status st = OK;
    PAGE("<td>%s", run->ncritical == 0 ? "nothing" : "");
    for (int i = 0; i < run->ncritical && i < CRITICAL_LISTED; i++) {
        PAGE("<small>%s at %s</small>",
             run->critical[i].kind == CRITICAL_LIMIT ? "limit point" : "bifurcation",
             number_digits(run->critical[i].fraction, 5).text);
    }
    if (run->ncritical > CRITICAL_LISTED) {
        PAGE("<small>and %d more</small>", run->ncritical - CRITICAL_LISTED);
    }
    PAGE("</td>");

done:
    return st;
}

static status equilibrium_row(bytes *page, const rod_run *run, int number)
{
    static const char *const words[] = {"not known", "<span class=\"bad\">no ⚠</span>", "yes"};
    status st = OK;
    const double misfit = result_energy_misfit(run);
    PAGE("<tr><td>%d</td>", number);
    if (run->fraction < 1) {
        PAGE("<td class=\"bad\">%s ⚠</td>", number_digits(run->fraction, 5).text);
    } else {
        PAGE("<td>all</td>");
    }
    PAGE("<td>%s</td><td>%s</td>", words[run->stable < 0 ? 0 : 1 + (run->stable == 1)],
         isnan(run->eigenvalue) ? "–" : number_digits(run->eigenvalue, 4).text);
    TRY(critical_cell(page, run));
    if (isnan(run->energy) || isnan(run->work)) {
        PAGE("<td>–</td><td>–</td><td>–</td>");
    } else {
        PAGE("<td>%s</td><td>%s</td><td>%s</td>", number_digits(run->energy * 1e6, 5).text,
             number_digits(run->work * 1e6, 5).text, number_digits(misfit, 2).text);
    }
    PAGE("<td>%s</td><td>%d</td></tr>\n", number_digits(run->residual, 2).text, run->iterations);

done:
    return st;
}

status page_rod_equilibria(bytes *page, const run_result *r, const rod_rows *rows)
{
    status st = OK;
    PAGE("<div class=\"scroll\"><table>\n<caption>Each solution as an equilibrium. Reached: the "
         "part of the way from the start to all loads and tensions. The eigenvalue is the smallest "
         "of the second variation over the elastic energy's: 1 at rest, 0 where it is critical; "
         "follower loads and friction leave it unknown. Energy and work must agree: a check of the "
         "solve.</caption>\n");
    PAGE("<thead><tr><th>no.</th><th>reached</th><th>stable</th><th>eigenvalue</th><th>met on the "
         "way<small>at this part of it</small></th><th>energy<small>µJ</small></th><th>work"
         "<small>µJ</small></th><th>apart<small>relative</small></th><th>residual<small>of the "
         "balance</small></th><th>steps</th></tr></thead>\n<tbody>\n");
    for (int i = 0; i < rows->count; i++) {
        TRY(equilibrium_row(page, &r->rod.run[rows->row[i]], rows->row[i] + 1));
    }
    PAGE("</tbody></table></div>\n");

done:
    return st;
}
