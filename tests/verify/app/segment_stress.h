// tests/verify/app/segment_stress.h
// Segments at the ends of what can be asked: contrast, thin walls, Poisson's ratios, long elements,
// short and long bodies, by each way. In each the errors of the tip's compliance and of the
// middle's law stay within their estimates, or there is a refusal.
#pragma once

#include "app/segment_source.h"
#include "section/section.h"
#include "tests/test.h"

#include <stdarg.h>
#include <string.h>
#include <unistd.h>

enum { STRESS_TEXT = 1600 };

typedef struct stress_segment {
    const char *what;
    double value;
    double contrast, nu_soft, nu_stiff;
    double wall;         // over the outer radius of 4 mm
    double length;       // over the diameter
    const char *section; // shapes instead of the ring and its sector; NULL: those
    const char *ends;    // keys base and tip
    const char *mesh;    // keys of the mesh; NULL: the ladder
    const char *truth;   // tolerance of what it is held against; NULL: 3e-5
    bool exact;          // stretch and bending of the whole are the section's own times the length
    bool long_one;       // the ends do not reach the middle: its law is the section's
    bool one_way;        // by doubling alone: the other ways take ten times as long
} stress_segment;

typedef struct stress_count {
    int rows, outside, refused;
} stress_count;

typedef struct stress_answer {
    mat6 C, K;
    double C_error, K_error; // what is said of them
    int rungs;
    bool solved;
} stress_answer;

static const double STRESS_RADIUS = 4; // [mm]

static inline stress_segment stress_plain(const char *what, double value)
{
    return (stress_segment){.what = what,
                            .value = value,
                            .contrast = 24,
                            .nu_soft = 0.3,
                            .nu_stiff = 0.3,
                            .wall = 0.2,
                            .length = 2.5,
                            .ends = "base: clamped, tip: rigid"};
}

// --- a case and its solution

static inline void stress_text(const stress_segment *s, const char *method, const char *tolerance,
                               bool ladder, char text[STRESS_TEXT])
{
    const double inner = STRESS_RADIUS * (1 - s->wall);
    char shapes[STRESS_TEXT / 2];
    (void)snprintf(shapes, sizeof shapes,
                   "    - {annulus: {outer_radius_mm: %.17g, inner_radius_mm: %.17g}, material: "
                   "soft}\n    - {sector: {outer_radius_mm: %.17g, inner_radius_mm: %.17g, "
                   "mid_angle_rad: pi, width_rad: pi/8}, material: stiff}\n",
                   STRESS_RADIUS, inner, STRESS_RADIUS, inner);
    (void)snprintf(text, STRESS_TEXT,
                   "format: 1\nmaterials:\n  soft: {E_MPa: 1, nu: %.17g}\n"
                   "  stiff: {E_MPa: %.17g, nu: %.17g}\nsection:\n  model: full\n  shapes:\n%s"
                   "fem: {length_mm: %.17g, %s, method: %s, %s%s%s%s, loads: []}\n",
                   s->nu_soft, s->contrast, s->nu_stiff, s->section ? s->section : shapes,
                   2 * STRESS_RADIUS * s->length, s->ends, method, tolerance ? "tolerance: " : "",
                   tolerance ? tolerance : "", tolerance ? ", " : "",
                   s->mesh && !ladder ? s->mesh : "section_at_mm: 0");
}

static inline status stress_read(const char *text, case_data *c)
{
    char path[] = "/tmp/stiffaxis-test-XXXXXX";
    const int number = mkstemp(path);
    FILE *file = number < 0 ? NULL : fdopen(number, "w");
    CHECK(file != NULL && fputs(text, file) >= 0 && fclose(file) == 0);
    const status st = case_open(&(case_request){.path = path}, c);
    (void)unlink(path);
    return st;
}

static inline status stress_solve(const stress_segment *s, const char *method,
                                  const char *tolerance, bool ladder, stress_answer *out)
{
    status st = OK;
    char text[STRESS_TEXT];
    case_data c = {0};
    segment_source source = {0};
    segment_result r = {0};
    *out = (stress_answer){0};
    stress_text(s, method, tolerance, ladder, text);
    TRY(stress_read(text, &c));
    TRY(segment_source_make(&c, &source));
    TRY(segment_solve(&c.file.fem, &source, NULL, 0, &r));
    *out = (stress_answer){.C = r.tip_compliance,
                           .K = r.middle.K,
                           .C_error = r.relative_error,
                           .K_error = r.middle.relative_error,
                           .rungs = r.rungs,
                           .solved = true};

done:
    segment_result_free(&r);
    segment_source_free(&source);
    case_free(&c);
    return st;
}

// the section's own law: of all that is far from ends
static inline status stress_section(const stress_segment *s, beam_law *law)
{
    status st = OK;
    char text[STRESS_TEXT];
    case_data c = {0};
    stress_text(s, "auto", NULL, true, text);
    TRY(stress_read(text, &c));
    TRY(section_solve(&c.file.section, c.materials, 0, 0, law));

done:
    case_free(&c);
    return st;
}

// --- truth

// two finer rungs that agree; the climb begins higher than those that are judged
static inline bool stress_truth(const stress_segment *s, stress_answer *out)
{
    const bool solved =
        stress_solve(s, "doubling", s->truth ? s->truth : "3e-5", true, out) == OK ||
        stress_solve(s, "direct", "3e-4", true, out) == OK;
    status_clear();
    return solved;
}

// largest difference of entries, relative to the truth's diagonal; of stretch and bending alone
// where only they are known
static inline double stress_apart(mat6 a, mat6 truth, bool axial_only)
{
    double most = 0;
    for (int i = axial_only ? NZ : NX; i <= (axial_only ? MY : MZ); i++) {
        for (int j = axial_only ? NZ : NX; j <= (axial_only ? MY : MZ); j++) {
            const double e = fabs(a.a[i][j] - truth.a[i][j]) / sqrt(truth.a[i][i] * truth.a[j][j]);
            most = e <= most ? most : e; // a NaN stays
        }
    }
    return most;
}

typedef struct stress_known {
    stress_answer fine;
    bool has_fine, has_law;
    beam_law law;
} stress_known;

// the errors less what the truth says of its own
static inline void stress_errors(const stress_segment *s, const stress_known *t,
                                 const stress_answer *a, double *C_error, double *K_error)
{
    *C_error = *K_error = NAN;
    if (t->has_fine) {
        *C_error = fmax(0, stress_apart(a->C, t->fine.C, false) - t->fine.C_error);
        *K_error = fmax(0, stress_apart(a->K, t->fine.K, false) - t->fine.K_error);
    }
    if (t->has_law && s->exact) {
        mat6 F;
        const double length = 2e-3 * STRESS_RADIUS * s->length;
        CHECK(mat6_inverse_spd(t->law.K, &F));
        const double own = stress_apart(a->C, mat6_scale(length, F), true) - t->law.relative_error;
        *C_error = fmax(0, own);
        *K_error = fmax(0, stress_apart(a->K, t->law.K, true) - t->law.relative_error);
    }
    if (t->has_law && s->long_one) {
        const double own = stress_apart(a->K, t->law.K, false) - t->law.relative_error;
        *K_error = isnan(*K_error) ? own : fmax(*K_error, own);
    }
}

// --- the table

static inline void stress_row(const stress_segment *s, const stress_known *t, const char *way,
                              const char *tolerance, stress_count *count)
{
    stress_answer a;
    double C_error, K_error;
    count->rows++;
    printf("| %s | %g | %s | %s |", s->what, s->value, way, tolerance ? tolerance : "");
    if (stress_solve(s, way, tolerance, false, &a) != OK) {
        const char *words = strstr(status_message(), "error: ");
        count->refused++;
        printf(" | | | | refused: %s |\n", words ? words + 7 : status_message());
        status_clear();
        return;
    }
    stress_errors(s, t, &a, &C_error, &K_error);
    const bool within = C_error <= a.C_error && K_error <= a.K_error;
    count->outside += !within;
    printf(" %.1e | %.1e | %.1e | %.1e | %s |\n", C_error, a.C_error, K_error, a.K_error,
           within ? "" : "OUTSIDE");
    (void)fflush(stdout);
}

static inline void stress_rows(const stress_segment *s, stress_count *count)
{
    stress_known t = {0};
    t.has_fine = !s->exact && stress_truth(s, &t.fine);
    if (s->exact || s->long_one) {
        t.has_law = stress_section(s, &t.law) == OK;
        status_clear();
    }
    stress_row(s, &t, "doubling", NULL, count);
    if (s->one_way) {
        return;
    }
    stress_row(s, &t, "direct", NULL, count);
    // the mixed form takes hundreds of iterations: minutes
    if (fmax(s->nu_soft, s->nu_stiff) <= 0.45) {
        stress_row(s, &t, "iterative", NULL, count);
    }
    if (!s->mesh && !s->exact) {
        stress_row(s, &t, "doubling", "5e-4", count);
    }
}
