// app/warnings.c
#include "app/warnings.h"

#include "app/chain.h"
#include "app/segment_source.h"
#include "io/utf8.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

// places along a tendon that are looked at, ends included
enum { TENDON_SAMPLES = 17 };

// what the rounding of a radius may add to a tendon that runs in the section's very edge
static const double EDGE_ROUNDING = 1e-9;

// Length over the section's radius below which the ends' layers meet: what decays slowest in a full
// section falls by e within about half a radius, and by 50 over two from either end.
static const double SHORTEST_FREE_MIDDLE = 4;

// A modulus written over x or y that changes by less than this part over the section was most
// likely meant in another unit.
static const double HARDLY_GRADED = 1e-2;

void warn_at(const command *cmd, const case_data *c, mark at, const char *format, ...)
{
    char where[CONFIG_PLACE_TEXT], words[600];
    if (!cmd->first_rank) {
        return;
    }
    command_progress(cmd, NULL);
    config_place_text(c->config, at, where);
    va_list args;
    va_start(args, format);
    (void)vsnprintf(words, sizeof words, format, args);
    va_end(args);
    utf8_make_plain(words);
    fprintf(stderr, "%swarning: %s\n", where, words);
    if (cmd->warnings) {
        fprintf(cmd->warnings, "%swarning: %s\n", where, words);
    }
}

static status section_reach(const case_data *c, double s, double *reach)
{
    return case_place(c, section_reach_at(&c->file.section, s, reach), c->file.section.at);
}

// one line for the first place where the tendon lies outside
static status warn_tendon(const command *cmd, const case_data *c, const tendon_spec *t, int number)
{
    status st = OK;
    const section_case *section = &c->file.section;
    const double end = t->end > 0 ? t->end : c->file.rod.length;
    for (int i = 0; i < TENDON_SAMPLES; i++) {
        const double s = end * i / (TENDON_SAMPLES - 1);
        double place[2], reach = 0;
        chain_tendon_place(t, s, place);
        const double away = hypot(place[0], place[1]);
        TRY(case_place(c, section_reach_towards(section, s, place, &reach), section->at));
        if (away > reach * (1 + EDGE_ROUNDING)) {
            char name[64], where[40] = "";
            (void)snprintf(name, sizeof name, t->name ? "'%.60s'" : "%.0s%d",
                           t->name ? t->name : "", number);
            if (i > 0) {
                (void)snprintf(where, sizeof where, " at s = %.6g mm", 1e3 * s);
            }
            warn_at(cmd, c, t->at,
                    "tendon %s runs %.6g mm from the centre%s, outside the section, which reaches "
                    "%.6g mm there",
                    name, 1e3 * away, where, 1e3 * reach);
            break;
        }
    }

done:
    return st;
}

// E at the four ends of the section's axes and at its origin: its range over its mean
static double change_of(const material *m, double reach)
{
    static const double place[5][2] = {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < 5; i++) {
        const double E = place_field_at(&m->modulus, reach * place[i][0], reach * place[i][1]);
        low = fmin(low, E);
        high = fmax(high, E);
    }
    return (high - low) / fabs((high + low) / 2);
}

status warn_materials(const command *cmd, const case_data *c)
{
    status st = OK;
    double reach = 0;
    for (int i = 0; i < c->nmaterial; i++) {
        const material *m = &c->materials[i];
        if (!material_is_graded(m)) {
            continue;
        }
        TRY(section_reach(c, 0, &reach));
        if (change_of(m, reach) < HARDLY_GRADED) {
            warn_at(
                cmd, c, m->at,
                "E of '%s' is given over x or y, but changes by less than %g over the section: x "
                "and y are metres",
                m->name, HARDLY_GRADED);
        }
    }

done:
    return st;
}

status warn_tendons(const command *cmd, const case_data *c)
{
    status st = OK;
    const tendon_spec *tendons = c->file.rod.spec;
    for (int i = 0; i < c->file.rod.tendons.count; i++) {
        TRY(warn_tendon(cmd, c, &tendons[i], i + 1));
    }

done:
    return st;
}

status warn_segment(const command *cmd, const case_data *c)
{
    const segment_case *sc = &c->file.fem;
    double reach = 0;
    if (segment_source_keeps_prism(c)) {
        warn_at(cmd, c, sc->at,
                "`body: prism` keeps the section of s = %.6g mm, though section or rest shape "
                "change along the rod",
                1e3 * sc->section_at);
    }
    const status st = section_reach(c, sc->section_at, &reach);
    if (st == OK && sc->length < SHORTEST_FREE_MIDDLE * reach) {
        warn_at(cmd, c, sc->at,
                "the segment is %.3g radii long; its middle is not free of its ends below %g",
                sc->length / reach, SHORTEST_FREE_MIDDLE);
    }
    return st;
}
