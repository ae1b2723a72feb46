// reports/page_rest.c
// Comparisons, assumptions and where the numbers come from.
#include "reports/page_kit.h"
#include "reports/scripts.h"

#include <math.h>
#include <string.h>

int compare_out_of_tolerance(const run_result *r)
{
    int count = 0;
    for (int i = 0; i < r->ncompare; i++) {
        count += !r->compare[i].skipped && !r->compare[i].ok;
    }
    return count;
}

int compare_skipped(const run_result *r)
{
    int count = 0;
    for (int i = 0; i < r->ncompare; i++) {
        count += r->compare[i].skipped;
    }
    return count;
}

// how much of what it may differ by a row takes
static status band(bytes *page, const compare_row *row)
{
    status st = OK;
    const double share = row->tolerance > 0 ? row->difference / row->tolerance : NAN;
    if (isfinite(share)) {
        PAGE("<td><span class=\"band\"><i class=\"%s\" style=\"width:%.0f%%\"></i></span></td>",
             row->ok ? "" : "out", 100 * fmin(fmax(share, 0), 1));
    } else {
        PAGE("<td></td>");
    }

done:
    return st;
}

// N mm^2 as people write it
static status unit_of(bytes *page, const char *unit)
{
    status st = OK;
    const char *square = strstr(unit, "^2");
    TRY(markup_escape(page, unit, square ? (size_t)(square - unit) : strlen(unit)));
    if (square) {
        TRY(bytes_text(page, "²"));
        TRY(page_escaped(page, square + 2));
    }

done:
    return st;
}

// what its tolerance is made of, or why it is skipped, stands under a row's name: a column of such
// words would push the verdicts off the sheet
static status name_and_reason(bytes *page, const compare_row *row)
{
    status st = OK;
    PAGE("<tr><td class=\"text\">");
    TRY(page_escaped(page, row->what));
    if (row->reason[0]) {
        PAGE("<small>");
        TRY(page_escaped(page, row->reason));
        PAGE("</small>");
    }

done:
    return st;
}

// the size of a difference that should be none needs no more digits than that
enum { DIGITS_OF_VALUES = 8, DIGITS_OF_DIFFERENCES = 2 };

static status compare_line(bytes *page, const compare_row *row)
{
    status st = OK;
    const int digits = row->other == 0 ? DIGITS_OF_DIFFERENCES : DIGITS_OF_VALUES;

    TRY(name_and_reason(page, row));
    if (row->skipped) {
        PAGE("</td><td></td><td></td><td></td><td></td><td></td><td></td><td "
             "class=\"skip\">skipped</td>");
    } else {
        PAGE("</td><td>%s</td><td>%s</td><td class=\"unit\">",
             number_digits(row->ours, digits).text, number_digits(row->other, digits).text);
        TRY(unit_of(page, row->unit));
        PAGE("</td><td>%s</td><td>%s</td>", number_digits(row->difference, 2).text,
             number_digits(row->tolerance, 2).text);
        TRY(band(page, row));
        PAGE("<td class=\"%s\">%s</td>", row->ok ? "good" : "bad",
             row->ok ? "✓ agrees" : "✗ out of tolerance");
    }
    PAGE("</tr>\n");

done:
    return st;
}

// rows belong to the first group whose word they begin with; the last takes the rest
static const struct {
    const char *word, *title;
} groups[] = {
    {"section:", "The section: closed forms, GetDP, 3D FEM"},
    {"tip compliance", "The rod against 3D FEM: the tip's compliance"},
    {"load ", "What the loads do"},
    {"rod", "The rod in two frames, and against others"},
    {"", "Others"},
};

static size_t group_of(const compare_row *row)
{
    size_t i = 0;
    while (strncmp(row->what, groups[i].word, strlen(groups[i].word)) != 0) {
        i++;
    }
    return i;
}

static status group_table(bytes *page, const run_result *r, size_t group)
{
    status st = OK;
    int rows = 0;
    for (int i = 0; i < r->ncompare; i++) {
        if (group_of(&r->compare[i]) != group) {
            continue;
        }
        if (rows++ == 0) {
            PAGE("<div class=\"scroll\"><table>\n<caption>%s</caption>\n<thead>"
                 "<tr><th>what<small>and what the tolerance is made "
                 "of</small></th><th>ours</th><th>other</th><th class=\"text\">unit</th>",
                 groups[group].title);
            PAGE("<th>difference<small>relative</small></th><th>tolerance<small>relative"
                 "</small></th><th>of the band<small>difference over tolerance</small></th>"
                 "<th>verdict</th></tr></thead>\n<tbody>\n");
        }
        TRY(compare_line(page, &r->compare[i]));
    }
    if (rows > 0) {
        PAGE("</tbody></table></div>\n");
    }

done:
    return st;
}

status page_compare(bytes *page, const run_result *r)
{
    status st = OK;
    const int bad = compare_out_of_tolerance(r), skipped = compare_skipped(r);
    if (!r->has_compare || r->ncompare == 0) {
        return OK;
    }

    PAGE("<h2 id=\"compare\">Two ways to the same number</h2>\n<p>%d comparisons: "
         "<span class=\"good\">%d agree</span>, <span class=\"%s\">%d out of tolerance</span>",
         r->ncompare, r->ncompare - bad - skipped, bad ? "bad" : "skip", bad);
    if (skipped > 0) {
        PAGE(", <span class=\"skip\">%d skipped</span>", skipped);
    }
    PAGE(".</p>\n");
    for (size_t i = 0; i < sizeof groups / sizeof *groups; i++) {
        TRY(group_table(page, r, i));
    }

done:
    return st;
}

static bool pattern_turns(const law_along *along)
{
    for (int i = 1; along->turn && i < along->npanel * along->nnode; i++) {
        if (along->turn[i] != along->turn[0]) {
            return true;
        }
    }
    return false;
}

static status tendon_assumptions(bytes *page, const rod_result *rod)
{
    enum { MOST_NAMED = 8 };
    status st = OK;
    PAGE("<li>Tendons lie without play along the routing that the case gives; their friction, "
         "where it gives one, is that of being pulled. At the base:");
    for (int i = 0; i < rod->ntendon && i < MOST_NAMED; i++) {
        const double *at = rod->tendon_base[i];
        PAGE("%s ", i ? "," : "");
        TRY(page_escaped(page, rod->tendon_name[i]));
        PAGE(" at radius %s mm", number_digits(1e3 * hypot(at[0], at[1]), 4).text);
    }
    PAGE("%s. Where a channel's radius was not measured it is an assumption, and a tenth of a "
         "millimetre moves a soft rod's tip by millimetres.</li>\n",
         rod->ntendon > MOST_NAMED ? ", …" : "");

done:
    return st;
}

static status rod_assumptions(bytes *page, const rod_result *rod)
{
    status st = OK;
    TRY(rod->ntendon > 0 ? tendon_assumptions(page, rod) : OK);
    if (rod->nload == 0) {
        PAGE("<li>No gravity and no other load on the rod.</li>\n");
    } else {
        PAGE("<li>Loads act slowly: the answer is the equilibrium reached by growing loads and "
             "tensions together from rest, or from the solution before.</li>\n");
    }
    PAGE("<li>The rod touches nothing but its base, not even itself.</li>\n");

done:
    return st;
}

status page_assumptions(bytes *page, const run_result *r)
{
    status st = OK;

    PAGE("<h2 id=\"assumptions\">Assumptions</h2>\n<ul>\n<li>Materials are linear%s and "
         "perfectly bonded where they meet.</li>\n",
         materials_are_plain(r) ? ", isotropic" : "");
    if (r->has_rod) {
        TRY(rod_assumptions(page, &r->rod));
    }
    if (r->has_section && r->section_model == MODEL_CLASSICAL) {
        PAGE("<li>The classical model takes torsion and shear without warping: right for "
             "axisymmetric sections "
             "only.</li>\n");
    }
    if (r->has_section && r->section_model == MODEL_FULL && pattern_turns(&r->section.along)) {
        PAGE("<li>The pattern turns along the rod, and each station is taken as if it were "
             "prismatic: couplings of stretch and twist that a turning pattern has are not in "
             "K.</li>\n");
    }
    if (r->reach.there) {
        PAGE("<li>Tissue is rigid and is not touched; a scope's shaft stays straight on its line, "
             "and its tip bends under its tendons alone, without gravity, friction of the joints "
             "or fluid.</li>\n");
    }
    if (r->has_segment) {
        PAGE("<li>The 3D segment is linear: displacements are taken as small.</li>\n");
    }
    PAGE("</ul>\n");
    if (r->nmaterial > 0) {
        TRY(page_materials(page, r));
    }

done:
    return st;
}

status page_origin(bytes *page, const run_result *r)
{
    status st = OK;

    const script *cite = &script_citation;
    PAGE("<h2 id=\"origin\">Where this comes from</h2>\n<h3 id=\"cite\">How to cite</h3>\n<p>The "
         "software, in the form that GitHub and reference managers read (CITATION.cff):</p>\n"
         "<pre>");
    TRY(markup_escape(page, cite->text, (size_t)(cite->end - cite->text)));
    PAGE("</pre>\n");
    if (r->versions[0]) {
        PAGE("<h3>Versions</h3>\n<pre>");
        TRY(page_escaped(page, r->versions));
        PAGE("</pre>\n");
    }
    if (r->case_text && r->case_length > 0) {
        PAGE("<h3>The case, as read</h3>\n<pre>");
        TRY(markup_escape(page, r->case_text, r->case_length));
        PAGE("</pre>\n");
    }

done:
    return st;
}
