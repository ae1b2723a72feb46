// reports/material_report.c
#include "reports/material_report.h"

#include "io/csv.h"
#include "io/disk.h"
#include "io/number.h"

#include <math.h>
#include <string.h>

enum { PATH_TEXT = 4096 };

static bool same_sizes(const material_specimen *a, const material_specimen *b)
{
    return a->length.value == b->length.value && a->area.value == b->area.value &&
           strcmp(a->length.from, b->length.from) == 0 && strcmp(a->area.from, b->area.from) == 0;
}

// once for neighbours that have the same
static void print_sizes(const material_result *r, int i, FILE *stream)
{
    const material_specimen *m = &r->specimen[i];
    const material_size *l = &m->length, *a = &m->area;
    if (!(l->value > 0 || a->value > 0) || (i > 0 && same_sizes(m, m - 1))) {
        return;
    }
    fputs("  with ", stream);
    if (l->value > 0) {
        fprintf(stream, "gauge length %.4g mm (%s)%s", 1e3 * l->value, l->from,
                a->value > 0 ? ", " : "");
    }
    if (a->value > 0) {
        fprintf(stream, "cross section %.4g mm^2 (%s)", 1e6 * a->value, a->from);
    }
    fputs(":\n", stream);
}

static void print_specimen(const material_specimen *m, const tensile_rule *rule, FILE *stream)
{
    const tensile_answer *a = &m->answer;
    fprintf(stream, "  %-24s E %8.4g MPa, %.4g to %.4g; straight from %.3g to %.3g %%", m->label,
            1e-6 * a->E, 1e-6 * a->interval[0], 1e-6 * a->interval[1], 100 * a->window[0],
            100 * a->window[1]);
    fprintf(stream, a->linear_to_end ? ", linear to its end" : ", linear up to %.3g %%",
            100 * a->linear_strain);
    fprintf(stream, "%s\n", m->outlier ? m->used ? "; stands out" : "; stands out, left out" : "");
    if (fabs(a->strain_offset) > 1e-9) {
        fprintf(stream, "  %-24s strain counts from %.3g %%", "", 100 * a->strain_offset);
        if (a->correlation > 1.5) {
            fprintf(stream, "; noise over %.0f points at a time", a->correlation);
        }
        fputc('\n', stream);
    }
    if (a->unloads || a->turned || isfinite(a->slip) || a->nspike > 0) {
        fprintf(stream, "  %-24s%s%s", "", a->unloads ? " first loading only;" : "",
                a->turned ? " compression, signs turned;" : "");
        if (isfinite(a->slip)) {
            fprintf(stream, " slips at %.3g %%, used up to there;", 100 * a->slip);
        }
        if (a->nspike > 0) {
            fprintf(stream, " %d spike%s left out;", a->nspike, plural(a->nspike));
        }
        fputc('\n', stream);
    }
    (void)rule;
}

// What would narrow the interval: readings where a curve's own error leads, samples anyway
static void print_remedy(const material_result *r, FILE *stream)
{
    const tensile_pool *p = &r->pool;
    fprintf(stream, "  narrower: ");
    if (p->n > 1) {
        fprintf(stream, "one more sample like these gives about +-%.2g %% for now +-%.2g %%",
                100 * p->next / p->E, 50 * (p->interval[1] - p->interval[0]) / p->E);
    }
    if (p->n == 1 || 2 * p->own > p->between) {
        fprintf(stream, "%smore readings or less noise where %s straight", p->n > 1 ? "; " : "",
                p->n > 1 ? "the curves are" : "the curve is");
    } else {
        fprintf(stream, "; more readings do little, the samples differ");
    }
    fputc('\n', stream);
}

static void print_pool(const material_result *r, FILE *stream)
{
    const tensile_pool *p = &r->pool;
    fprintf(stream, "%s: E = %.4g MPa, %.0f %% interval %.4g to %.4g MPa, of %d curve%s\n", r->name,
            1e-6 * p->E, 100 * r->rule.share, 1e-6 * p->interval[0], 1e-6 * p->interval[1], p->n,
            plural(p->n));
    if (p->n > 1) {
        fprintf(
            stream,
            "  from sample to sample: standard deviation %.3g MPa (%.2g %%), besides the %.2g %% "
            "of a curve by itself\n",
            1e-6 * p->between, 100 * p->between / p->E, 100 * p->own / p->E);
    } else {
        fprintf(stream, "  one curve: what differs from sample to sample is not in the interval\n");
    }
    print_remedy(r, stream);
    fprintf(stream, "  linear_strain: %.3g (the stress leaves the line of E by %.3g %% there)\n",
            p->linear_strain, 100 * r->rule.departure);
    if (r->noutlier > 0) {
        const bool kept = r->other.n < p->n;
        fprintf(stream, "  %d curve%s out, %s; %s E = %.4g MPa, %.4g to %.4g\n", r->noutlier,
                r->noutlier == 1 ? " stands" : "s stand", kept ? "kept" : "left out",
                kept ? "without" : "with", 1e-6 * r->other.E, 1e-6 * r->other.interval[0],
                1e-6 * r->other.interval[1]);
    }
}

void material_print(const material_result *r, FILE *stream)
{
    if (r->synthetic) {
        fprintf(stream, "SYNTHETIC data: its file says so; no measurement\n");
    }
    print_pool(r, stream);
    for (int i = 0; i < r->n; i++) {
        print_sizes(r, i, stream);
        print_specimen(&r->specimen[i], &r->rule, stream);
    }
}

static void json_size(json *j, const char *name, const char *from, const material_size *s)
{
    json_real(j, name, s->value > 0 ? s->value : NAN);
    json_text(j, from, s->value > 0 ? s->from : "not used");
}

static void json_specimen(json *j, const material_specimen *m)
{
    const tensile_answer *a = &m->answer;
    json_object(j, NULL);
    json_text(j, "name", m->label);
    json_size(j, "gauge_length_m", "gauge_length_from", &m->length);
    json_size(j, "area_m2", "area_from", &m->area);
    json_real(j, "E_Pa", a->E);
    json_reals(j, "interval_Pa", 2, a->interval);
    json_real(j, "standard_error_Pa", a->standard_error);
    json_real(j, "degrees_of_freedom", a->freedom);
    json_real(j, "linear_strain", a->linear_strain);
    json_flag(j, "linear_to_end", a->linear_to_end);
    json_real(j, "strain_offset", a->strain_offset);
    json_reals(j, "window_strain", 2, a->window);
    json_integer(j, "window_points", a->nwindow);
    json_integer(j, "loading_points", a->nloading);
    json_real(j, "noise_Pa", a->noise);
    json_real(j, "correlated_points", a->correlation);
    json_integer(j, "duplicates", a->nduplicate);
    json_integer(j, "spikes", a->nspike);
    json_flag(j, "unloads", a->unloads);
    json_flag(j, "compression", a->turned);
    json_real(j, "slip_strain", a->slip);
    json_flag(j, "outlier", m->outlier);
    json_flag(j, "used", m->used);
    json_object_end(j);
}

static void json_pool(json *j, const tensile_pool *p)
{
    json_real(j, "E_Pa", p->E);
    json_reals(j, "interval_Pa", 2, p->interval);
    json_real(j, "standard_error_Pa", p->standard_error);
    json_real(j, "degrees_of_freedom", p->freedom);
    json_real(j, "between_samples_Pa", p->between);
    json_real(j, "linear_strain", p->linear_strain);
    json_real(j, "curve_standard_error_Pa", p->own);
    json_real(j, "half_interval_with_one_more_Pa", p->next);
    json_integer(j, "curves", p->n);
}

status material_json(json *j, const material_result *r)
{
    json_object(j, NULL);
    json_text(j, "schema", "stiffaxis/material/1");
    json_text(j, "name", r->name);
    json_flag(j, "synthetic", r->synthetic);
    json_text(j, "source", r->source);
    json_real(j, "share", r->rule.share);
    json_real(j, "departure", r->rule.departure);
    json_pool(j, &r->pool);
    json_array(j, "outliers");
    for (int i = 0; i < r->n; i++) {
        if (r->specimen[i].outlier) {
            json_text(j, NULL, r->specimen[i].label);
        }
    }
    json_array_end(j);
    json_flag(j, "outliers_used", r->other.n < r->pool.n);
    json_object(j, r->other.n < r->pool.n ? "without_outliers" : "with_all");
    json_pool(j, &r->other);
    json_object_end(j);
    json_array(j, "warnings");
    for (int i = 0; i < r->nwarning; i++) {
        json_text(j, NULL, r->warning[i]);
    }
    json_array_end(j);
    json_array(j, "specimens");
    for (int i = 0; i < r->n; i++) {
        json_specimen(j, &r->specimen[i]);
    }
    json_array_end(j);
    json_object_end(j);
    return OK;
}

static status write_json(const material_result *r, const char *path)
{
    status st = OK;
    json *j = NULL;
    FILE *file = fopen(path, "w");
    if (!file) {
        return disk_fail(path, "write");
    }
    TRY(json_open(file, &j));
    TRY(material_json(j, r));

done:
    if (j) {
        const status closed = json_close(j);
        st = st == OK ? closed : st;
    }
    return fclose(file) != 0 && st == OK ? disk_fail(path, "write") : st;
}

static status write_yaml(const material_result *r, const char *path)
{
    const tensile_pool *p = &r->pool;
    FILE *file = fopen(path, "w");
    if (!file) {
        return disk_fail(path, "write");
    }
    if (r->synthetic) {
        fprintf(file, "# SYNTHETIC data: no measurement\n");
    }
    fprintf(file, "# a case has one `materials:`, with the block of each material below it\n");
    fprintf(file, "materials:\n  %s:\n", r->name);
    fprintf(file, "    E_MPa: %-10.4g # %.4g to %.4g with %.0f %%, of %d curve%s\n", 1e-6 * p->E,
            1e-6 * p->interval[0], 1e-6 * p->interval[1], 100 * r->rule.share, p->n, plural(p->n));
    if (isfinite(r->nu)) {
        fprintf(file, "    nu: %-13.4g # as given: tension does not tell it\n", r->nu);
    } else {
        fprintf(file,
                "    # nu is needed and tension does not tell it: write `nu: 0.48` here, or run\n"
                "    # `stiffaxis material` with --set nu=0.48; elastomers: 0.45 to 0.499, below "
                "0.5\n");
    }
    fprintf(file, "    linear_strain: %.3g\n", p->linear_strain);
    const bool written = !ferror(file);
    return fclose(file) == 0 && written ? OK : disk_fail(path, "write");
}

static void csv_size(csv *c, double unit, const material_size *s)
{
    csv_real(c, s->value > 0 ? s->value / unit : NAN);
    csv_text(c, s->value > 0 ? s->from : "not used");
}

static status write_csv(const material_result *r, const char *path)
{
    static const char *const names[] = {"name",
                                        "E_MPa",
                                        "low_MPa",
                                        "high_MPa",
                                        "standard_error_MPa",
                                        "linear_strain",
                                        "strain_offset",
                                        "window_from",
                                        "window_to",
                                        "noise_MPa",
                                        "correlated_points",
                                        "outlier",
                                        "used",
                                        "gauge_length_mm",
                                        "gauge_length_from",
                                        "area_mm2",
                                        "area_from"};
    enum { COLUMNS = sizeof names / sizeof *names };
    status st = OK;
    csv *c = NULL;
    TRY(csv_open(path, COLUMNS, names, &c));
    for (int i = 0; i < r->n; i++) {
        const tensile_answer *a = &r->specimen[i].answer;
        const double row[] = {1e-6 * a->E,
                              1e-6 * a->interval[0],
                              1e-6 * a->interval[1],
                              1e-6 * a->standard_error,
                              a->linear_strain,
                              a->strain_offset,
                              a->window[0],
                              a->window[1],
                              1e-6 * a->noise,
                              a->correlation,
                              r->specimen[i].outlier,
                              r->specimen[i].used};
        csv_text(c, r->specimen[i].label);
        for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
            csv_real(c, row[k]);
        }
        csv_size(c, 1e-3, &r->specimen[i].length);
        csv_size(c, 1e-6, &r->specimen[i].area);
    }
    st = csv_close(c);

done:
    return st;
}

status material_files(const char *directory, const void *result)
{
    status st = OK;
    const material_result *r = result;
    char path[PATH_TEXT];
    TRY(disk_join(path, sizeof path, "%s/material.yaml", directory));
    TRY(write_yaml(r, path));
    TRY(disk_join(path, sizeof path, "%s/material.csv", directory));
    TRY(write_csv(r, path));
    TRY(disk_join(path, sizeof path, "%s/material.json", directory));
    TRY(write_json(r, path));
    TRY(figure_material(r, directory));

done:
    return st;
}
