// What of a scan's line is to be doubted, a sentence each: in the summary, the JSON and the table.
#include "reports/scan_report.h"

#include <math.h>
#include <stdio.h>

int scan_remarks(const scan_result *r, char text[SCAN_REMARKS][SCAN_REMARK_ROOM])
{
    const tube_report *t = &r->tube;
    int n = 0;
    if (t->taper != 0) {
        (void)snprintf(text[n++], SCAN_REMARK_ROOM,
                       "the radius is not one number: %.4f mm at the base, %.4f mm at the tip",
                       1e3 * (t->radius_free - t->taper / 2),
                       1e3 * (t->radius_free + t->taper / 2));
    }
    if (t->beyond > 0) {
        (void)snprintf(text[n++], SCAN_REMARK_ROOM,
                       "points go on for %.3g mm beyond the tip, as a tube of %.3g mm radius",
                       1e3 * t->beyond, 1e3 * t->beyond_radius);
    }
    if (t->length_differs) {
        (void)snprintf(text[n++], SCAN_REMARK_ROOM, "the length is %.3f mm %s than stated: %s",
                       1e3 * fabs(t->missing), t->missing > 0 ? "less" : "more",
                       t->missing > 0 ? "the tip is not seen, or the body is shorter"
                                      : "the body is longer, or something else goes on at its end");
    }
    if (t->unseen_base > r->line.radius / 2) {
        (void)snprintf(text[n++], SCAN_REMARK_ROOM,
                       "no points on the first %.3g mm: bridged, +- %.3g mm at the base",
                       1e3 * t->unseen_base, 1e3 * r->fit_sigma[0]);
    }
    return n;
}
