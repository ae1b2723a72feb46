// reports/scan_report.c
#include "reports/scan_report.h"

#include <math.h>
#include <string.h>

static const double DEGREE = 0.017453292519943295;

const char *scan_frame_words(const scan_result *r)
{
    static const char *const words[3][2] = {
        {"by fiducials", "by fiducials"},
        {"by the plate and the mark", "by the plate; free in its turn about z"},
        {"by the body's own base and the mark", "of the body's own base; free in its turn about z"},
    };
    return words[r->frame][r->turn_free];
}

const tube_gap *scan_worst_gap(const scan_result *r)
{
    const tube_gap *worst = NULL;
    for (int i = 0; i < r->tube.ngap; i++) {
        const tube_gap *g = &r->tube.gap[i];
        worst = !worst || g->to - g->from > worst->to - worst->from ? g : worst;
    }
    return worst;
}

double scan_worst_sigma(const scan_result *r, double *s)
{
    double worst = 0;
    *s = 0;
    for (int i = 0; i < r->line.count; i++) {
        if (r->line.sigma[i] > worst) {
            worst = r->line.sigma[i];
            *s = r->line.s[i];
        }
    }
    return worst;
}

static double middle_sigma(const scan_result *r)
{
    double sum = 0;
    for (int i = 0; i < r->line.count; i++) {
        sum += r->line.sigma[i] * r->line.sigma[i];
    }
    return sqrt(sum / r->line.count);
}

static void print_cloud(const scan_result *r, const char *name, FILE *f)
{
    fprintf(f, "cloud    %s: %s, %zu points in %s%s", name, r->cloud.kind, r->cloud.read,
            scan_unit_name(r->cloud.unit), r->cloud.unit_named ? " by its columns" : "");
    if (r->cloud.dropped > 0) {
        fprintf(f, ", %zu not finite", r->cloud.dropped);
    }
    if (r->boxed > 0) {
        fprintf(f, ", %zu outside the box", r->boxed);
    }
    fprintf(f, "\n");
    if (r->synthetic) {
        fprintf(f, "         synthetic: made, not measured\n");
    }
}

static void print_body(const scan_result *r, FILE *f)
{
    static const char *const tips[] = {"open", "flat", "round"};
    const tube_report *t = &r->tube;
    fprintf(f, "points   %zu looked at, %zu on the body, %zu strays\n", t->thinned, t->used,
            t->stray);
    if (r->radius_given) {
        fprintf(f, "body     radius %.4g mm as stated; the points say %.4f +- %.4f mm%s\n",
                1e3 * r->line.radius, 1e3 * t->radius_free, 1e3 * t->radius_free_sigma,
                t->radius_differs ? ": they differ" : "");
    } else {
        fprintf(f, "body     radius %.4f +- %.4f mm\n", 1e3 * r->line.radius,
                1e3 * r->line.radius_sigma);
    }
    fprintf(f, "         length %.3f +- %.3f mm, %s tip\n", 1e3 * t->length, 1e3 * t->length_sigma,
            tips[t->tip]);
    char remark[SCAN_REMARKS][SCAN_REMARK_ROOM];
    const int nremark = scan_remarks(r, remark);
    for (int i = 0; i < nremark; i++) {
        fprintf(f, "         %s\n", remark[i]);
    }
    fprintf(f, "fit      rms %.4f mm, noise of a point %.4f mm, %.0f %% of the surface seen\n",
            1e3 * t->rms, 1e3 * t->noise, 100 * t->coverage);
    const tube_gap *gap = scan_worst_gap(r);
    if (gap) {
        fprintf(f, "gaps     %d; worst s = %.1f to %.1f mm, %.0f deg seen there\n", t->ngap,
                1e3 * gap->from, 1e3 * gap->to, gap->angle / DEGREE);
    }
}

static const char *unit_doubt(const scan_result *r, char *words, size_t size)
{
    return scan_unit_doubt(r->line.radius, r->tube.length, r->cloud.unit, words, size);
}

static void print_frame(const scan_result *r, FILE *f)
{
    const mat6 *c = &r->place.covariance;
    fprintf(f, "frame    %s\n", scan_frame_words(r));
    for (int i = 0; i < r->nresidual; i++) {
        fprintf(f, "         fiducial %s: %.4f mm\n", r->residual[i].name,
                1e3 * r->residual[i].distance);
    }
    if (r->frame == SCAN_BY_PLATE) {
        fprintf(f, "         plate: %zu points, rms %.4f mm\n", r->plate.count,
                1e3 * r->plate.sigma);
    }
    fprintf(f, "         base known to %.4f, %.4f, %.4f mm, turned to %.3f, %.3f, %.3f deg%s\n",
            1e3 * sqrt(c->a[0][0]), 1e3 * sqrt(c->a[1][1]), 1e3 * sqrt(c->a[2][2]),
            sqrt(c->a[3][3]) / DEGREE, sqrt(c->a[4][4]) / DEGREE, sqrt(c->a[5][5]) / DEGREE,
            r->turn_free ? " (z: as chosen)" : "");
    if (r->frame != SCAN_BY_BODY) {
        fprintf(f, "         the body leaves it %.2f deg off z\n", r->lean / DEGREE);
    }
}

void scan_print(const scan_result *r, const char *name, FILE *f)
{
    const centreline *c = &r->line;
    const vec3 tip = c->p[c->count - 1];
    double at = 0;
    const double worst = scan_worst_sigma(r, &at);
    print_cloud(r, name, f);
    print_body(r, f);
    char words[200];
    if (unit_doubt(r, words, sizeof words)[0]) {
        fprintf(f, "DOUBT    %s\n", words);
    }
    print_frame(r, f);
    fprintf(f, "line     %d points, sigma %.4f mm (rms), at most %.4f mm at s = %.1f mm\n",
            c->count, 1e3 * middle_sigma(r), 1e3 * worst, 1e3 * at);
    fprintf(f, "tip      %.3f  %.3f  %.3f mm\n", 1e3 * tip.a[0], 1e3 * tip.a[1], 1e3 * tip.a[2]);
}

// --- JSON

static void json_body(json *j, const scan_result *r)
{
    static const char *const tips[] = {"open", "flat", "round"};
    const tube_report *t = &r->tube;
    json_object(j, "body");
    json_flag(j, "radius_given", r->radius_given);
    json_real(j, "radius_m", r->line.radius);
    json_real(j, "radius_sigma_m", r->line.radius_sigma);
    json_real(j, "radius_of_points_m", t->radius_free);
    json_real(j, "radius_of_points_sigma_m", t->radius_free_sigma);
    json_flag(j, "radius_differs", t->radius_differs);
    char words[200];
    json_text(j, "unit_doubt", unit_doubt(r, words, sizeof words));
    json_real(j, "length_m", t->length);
    json_real(j, "length_sigma_m", t->length_sigma);
    json_text(j, "tip", tips[t->tip]);
    json_real(j, "missing_of_stated_length_m", t->missing);
    json_flag(j, "length_differs", t->length_differs);
    json_real(j, "taper_m", t->taper);
    json_real(j, "taper_sigma_m", t->taper_sigma);
    json_real(j, "beyond_tip_m", t->beyond);
    json_real(j, "beyond_tip_radius_m", t->beyond_radius);
    char remark[SCAN_REMARKS][SCAN_REMARK_ROOM];
    const int nremark = scan_remarks(r, remark);
    json_array(j, "remarks");
    for (int i = 0; i < nremark; i++) {
        json_text(j, NULL, remark[i]);
    }
    json_array_end(j);
    json_object_end(j);
    json_object(j, "fit");
    json_integer(j, "points_thinned", (long)t->thinned);
    json_integer(j, "points_used", (long)t->used);
    json_integer(j, "points_stray", (long)t->stray);
    json_real(j, "rms_m", t->rms);
    json_real(j, "noise_m", t->noise);
    json_real(j, "coverage", t->coverage);
    json_real(j, "smoothing_m", t->smoothing);
    json_real(j, "correlation_length_m", r->line.correlation_length);
    json_array(j, "gaps");
    for (int i = 0; i < t->ngap; i++) {
        json_object(j, NULL);
        json_real(j, "from_m", t->gap[i].from);
        json_real(j, "to_m", t->gap[i].to);
        json_real(j, "seen_rad", t->gap[i].angle);
        json_object_end(j);
    }
    json_array_end(j);
    json_object_end(j);
}

static void json_frame(json *j, const scan_result *r)
{
    static const char *const ways[] = {"fiducials", "plate", "body"};
    json_object(j, "registration");
    json_text(j, "by", ways[r->frame]);
    json_flag(j, "turn_free", r->turn_free);
    json_array(j, "rotation");
    for (int i = 0; i < 3; i++) {
        json_reals(j, NULL, 3, r->place.place.R.a[i]);
    }
    json_array_end(j);
    json_reals(j, "translation_m", 3, r->place.place.p.a);
    json_mat6(j, "covariance", r->place.covariance);
    json_real(j, "lean_rad", r->lean);
    if (r->frame == SCAN_BY_FIDUCIALS) {
        json_array(j, "fiducials");
        for (int i = 0; i < r->nresidual; i++) {
            json_object(j, NULL);
            json_text(j, "name", r->residual[i].name);
            json_real(j, "residual_m", r->residual[i].distance);
            json_object_end(j);
        }
        json_array_end(j);
        json_real(j, "fiducial_sigma_m", r->fiducials.sigma);
        json_real(j, "chi2", r->fiducials.chi2);
        json_integer(j, "freedom", r->fiducials.freedom);
    } else if (r->frame == SCAN_BY_PLATE) {
        json_integer(j, "plate_points", (long)r->plate.count);
        json_real(j, "plate_rms_m", r->plate.sigma);
    }
    json_object_end(j);
}

status scan_json(json *j, const scan_result *r, const char *name)
{
    json_object(j, NULL);
    json_text(j, "schema", "stiffaxis/scan/1");
    json_flag(j, "synthetic", r->synthetic);
    json_object(j, "cloud");
    json_text(j, "file", name);
    json_text(j, "format", r->cloud.kind);
    json_real(j, "unit_m", r->cloud.unit);
    json_integer(j, "points_read", (long)r->cloud.read);
    json_integer(j, "points_not_finite", (long)r->cloud.dropped);
    json_integer(j, "points_outside_box", (long)r->boxed);
    json_object_end(j);
    json_body(j, r);
    json_frame(j, r);
    json_array(j, "centreline");
    for (int i = 0; i < r->line.count; i++) {
        json_object(j, NULL);
        json_real(j, "s_m", r->line.s[i]);
        json_reals(j, "p_m", 3, r->line.p[i].a);
        json_real(j, "sigma_m", r->line.sigma[i]);
        json_real(j, "fit_sigma_m", r->fit_sigma[i]);
        json_object_end(j);
    }
    json_array_end(j);
    json_object_end(j);
    return OK;
}
