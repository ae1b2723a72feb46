#include "app/rest_line.h"

#include "base/memory.h"
#include "rodsolver/kinks.h"
#include "rodsolver/lie_step.h"

#include <math.h>
#include <string.h>

// Panels beside the breaks: a step of order 6 over a 256th of the length leaves rounding for shapes
// that turn by less than a hundred radians.
enum { EVEN_PANELS = 256, FIELDS = 3 };

void rest_line_free(rest_line *line)
{
    free(line->s);
    free(line->begin);
    *line = (rest_line){0};
}

static vec6 strain_at(const rest_shape *r, double s)
{
    return (vec6){{0, 0, 1, field_at(&r->curvature_x, s), field_at(&r->curvature_y, s),
                   field_at(&r->twist, s)}};
}

// the motion from a to b, within one panel
static pose motion(const rest_shape *r, double a, double b)
{
    vec6 xi[GAUSS_STATIONS];
    for (int i = 0; i < GAUSS_STATIONS; i++) {
        xi[i] = strain_at(r, a + (b - a) * gauss_point[i]);
    }
    return se3_exp(lie_step_twist(b - a, xi));
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static status find_panels(rest_line *line, int nbreak, const double *breaks)
{
    status st = OK;
    const field *all[FIELDS] = {&line->rest.curvature_x, &line->rest.curvature_y,
                                &line->rest.twist};
    int n = 0, kept = 0;
    TRY(TAKE(line->s, (size_t)(EVEN_PANELS + 1 + FIELDS * MOST_KINKS + nbreak)));
    for (int i = 0; i <= EVEN_PANELS; i++) {
        line->s[n++] = line->from + (line->to - line->from) * i / EVEN_PANELS;
    }
    for (int f = 0; f < FIELDS; f++) {
        n += kinks_of_field(all[f], line->from, line->to, line->s + n);
    }
    for (int i = 0; i < nbreak; i++) {
        if (breaks[i] > line->from && breaks[i] < line->to) {
            line->s[n++] = breaks[i];
        }
    }
    qsort(line->s, (size_t)n, sizeof *line->s, ascending);
    for (int i = 0; i < n; i++) {
        if (kept == 0 || line->s[i] > line->s[kept - 1]) {
            line->s[kept++] = line->s[i];
        }
    }
    line->npanel = kept - 1;

done:
    return st;
}

static bool is_finite(pose g)
{
    double sum = 0;
    for (int i = 0; i < 9; i++) {
        sum += g.R.a[i / 3][i % 3] + g.p.a[i % 3];
    }
    return isfinite(sum);
}

status rest_line_make(const rest_shape *rest, double from, double to, int nbreak,
                      const double *breaks, rest_line *out)
{
    status st = OK;
    rest_line line = {.rest = *rest, .from = from, .to = to};
    pose g = pose_identity();
    TRY(find_panels(&line, nbreak, breaks));
    TRY(TAKE(line.begin, (size_t)line.npanel));
    for (int k = 0; k < line.npanel; k++) {
        line.begin[k] = g;
        g = pose_mul(g, motion(rest, line.s[k], line.s[k + 1]));
        if (!is_finite(g)) {
            TRY(status_fail_at(ERR_INPUT, rest->at.line, rest->at.column,
                               "rod: the shape at rest is not finite at s = %g mm",
                               1e3 * line.s[k + 1]));
        }
    }
    *out = line;
    line = (rest_line){0};

done:
    rest_line_free(&line);
    return st;
}

pose rest_line_at(const rest_line *line, double s)
{
    int low = 0, high = line->npanel - 1;
    while (low < high) {
        const int middle = (low + high + 1) / 2;
        if (line->s[middle] <= s) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    return pose_mul(line->begin[low], motion(&line->rest, line->s[low], s));
}

static bool is_zero(const field *f)
{
    return !field_varies(f) && f->value == 0;
}

bool rest_line_is_straight(const rest_shape *rest)
{
    double rate = 0;
    return rest_line_only_twists(rest, &rate) && rate == 0;
}

bool rest_line_only_twists(const rest_shape *rest, double *rate)
{
    *rate = rest->twist.value;
    return is_zero(&rest->curvature_x) && is_zero(&rest->curvature_y) &&
           !field_varies(&rest->twist);
}

double rest_line_way(const rest_line *line)
{
    double sum = 0;
    for (int k = 0; k < line->npanel; k++) {
        vec6 xi = strain_at(&line->rest, (line->s[k] + line->s[k + 1]) / 2);
        sum += vec3_norm(vec6_angular(xi)) * (line->s[k + 1] - line->s[k]);
    }
    return sum;
}
