// reports/fig4_paper.c
#include "reports/fig4_paper.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// the paper's Fig. 4: its segment, its load and the section's own closed form
static const double paper_length = 20e-3, paper_force = 0.5;
static const double paper_EA = 29.213042, paper_r_nc = 2.1233e-3;
static const double paper_ratio = 7.11; // mm^2, EI / EA that its three figures need

// sides of the segment differ from the section by end effects and mesh, never by this much
static const double alike = 0.02;

static bool near(double value, double wanted)
{
    return fabs(value - wanted) <= alike * fabs(wanted);
}

fig4_load fig4_which(const run_result *r, int load)
{
    const segment_result *s = &r->segment;
    beam_centres centres;
    if (!r->has_segment || s->nload != 2 || !near(r->segment_length, paper_length) ||
        beam_law_centres(&s->middle, &centres) != OK) {
        status_clear();
        return FIG4_NONE;
    }
    const double *force = s->load[load].force;
    const double r_nc = hypot(centres.stiffness_centre[0], centres.stiffness_centre[1]);
    if (!near(centres.EA, paper_EA) || !near(r_nc, paper_r_nc) || !near(force[2], -paper_force) ||
        hypot(force[0], force[1]) > alike * paper_force) {
        return FIG4_NONE;
    }
    const double *at = s->load[load].point;
    const double off =
        hypot(at[0] - centres.stiffness_centre[0], at[1] - centres.stiffness_centre[1]);
    return hypot(at[0], at[1]) <= alike * r_nc ? FIG4_AT_GC
           : off <= alike * r_nc               ? FIG4_AT_NC
                                               : FIG4_NONE;
}

bool fig4_is(const run_result *r)
{
    // a case that says so: the same segment may be anybody's
    if (!r->has_segment || r->segment.nload != 2 || !strstr(r->title, "Fig. 4")) {
        return false;
    }
    const fig4_load a = fig4_which(r, 0), b = fig4_which(r, 1);
    return a != FIG4_NONE && b != FIG4_NONE && a != b;
}

fig4_reported fig4_paper(fig4_load which)
{
    switch (which) {
    case FIG4_AT_GC:
        return (fig4_reported){NULL, "10.7°", "9.39 1/m"};
    case FIG4_AT_NC:
        return (fig4_reported){"0.63 mm = 3.2 %", "under 0.1°", NULL};
    default:
        return (fig4_reported){NULL, NULL, NULL};
    }
}

void fig4_note(const run_result *r, char *text, unsigned long size)
{
    beam_centres c = {0};
    if (beam_law_centres(&r->segment.middle, &c) != OK || !(c.EA > 0)) {
        status_clear();
        text[0] = 0;
        return;
    }
    (void)snprintf(
        text, size,
        "The paper's magnitudes cannot all come from one linear run: whatever the load and the "
        "moduli, "
        "they need EI/EA = %.2f mm², and this section has %.2f mm². What can be verified are its "
        "two claims: a load at the geometric centre bends, a load at the stiffness centre "
        "compresses.",
        paper_ratio, c.EI[1] / c.EA * 1e6);
}
