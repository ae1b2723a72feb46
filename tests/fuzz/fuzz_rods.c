// fuzz_rods SECONDS [SEED]: mutated rods of case files, read and, where they are sound, solved. An
// answer is finite; what is none says why in one line.
#include "app/case.h"
#include "app/rod_ask.h"
#include "tests/fuzz/mutate.h"

#include <math.h>

static const char start[] =
    "format: 1\n"
    "materials: {soft: {E_MPa: 0.66, nu: 0.3, density_kg_per_m3: 1100}}\n"
    "section: {shapes: [{annulus: {outer_radius_mm: 4, inner_radius_mm: 3.2}, material: soft}]}\n";

static const char bent[] =
    "rod:\n"
    "  length_mm: 120\n"
    "  base: {position_mm: [1, 2, 3], rotation_deg: [0, 90, 0]}\n"
    "  rest: {curvature_y_per_m: 's < 0.04 ? 0 : 12', twist_rad_per_m: 4*s/L}\n"
    "  breaks_mm: [40]\n"
    "  tendons: [{name: a, radius_mm: 3.6, angle_rad: 2*pi*s/L}]\n"
    "  line_loads: [{from_mm: 40, force_mN_per_mm: [0, 0.02*s/L, 0]}]\n"
    "  gravity_m_per_s2: [0, 0, -9.81]\n"
    "  sweep: [{tension_of: a, from_N: 0, to_N: 0.4, steps: 3}]\n"
    "  start: last\n";

static const char pulled[] =
    "rod:\n"
    "  length_mm: 120\n"
    "  tendons:\n"
    "    - {name: a, x_mm: 3.6, friction: 0.2, EA_N: 600, outside_mm: 200}\n"
    "    - {name: b, x_mm: -3.6, end_mm: 90}\n"
    "    - {name: c, smooth_mm: 0.01, path_mm: [[0, 0, 3.6], [60, 3, 1.8], [120, 3.6, 0]]}\n"
    "  loads: [{name: d, force_N: [0.01, 0, 0], at_s_mm: 60, frame: body, place_mm: [1, 2]}]\n"
    "  pulls_mm:   [[4, ~, ~], [8, -8, ~]]\n"
    "  tensions_N: [[~, 0.1, 0], [~, ~, 0.1]]\n"
    "  load_factors: [[1], [0.5]]\n"
    "  past_limit_points: true\n";

enum { MOST_SOLVED = 4, MOST_TENDONS = 8, LEAST_TOLERANCE = 9 };

// the tube of the case, whatever became of its section: sections have fuzzers of their own
static status tube(double length, law_along *out)
{
    status st = OK;
    TRY(law_along_make(length, 1, 1, out));
    const double K[6] = {2.34, 2.34, 11.94, 78.35e-6, 78.35e-6, 60.27e-6};
    for (int i = 0; i < 6; i++) {
        out->law[0].K.a[i][i] = K[i];
    }
    out->law[0].mass = 0.02;

done:
    return st;
}

static status solve(const case_data *c)
{
    status st = OK;
    law_along law = {0};
    rod_ask ask = {0};
    rod *r = NULL;
    rod_state *state = NULL;
    const rod_case *rc = &c->file.rod;
    const rod_options options = {.frame = rc->frame,
                                 .tolerance = fmax(rc->tolerance, pow(10, -LEAST_TOLERANCE))};
    TRY(tube(rc->length, &law));
    const rod_spec spec = rod_case_spec(rc, &law);
    TRY(rod_ask_make(rc, &ask));
    TRY(rod_make(&spec, &options, &r));
    TRY(rod_state_make(r, &state));
    for (int i = 0; i < ask.count && i < MOST_SOLVED; i++) {
        rod_solution solution = {0};
        rod_ask_fill(&ask, i);
        TRY(rod_solve(state, &ask.request, &solution));
        for (int k = 0; k < 3; k++) {
            if (!isfinite(solution.tip.p.a[k])) {
                TRY(status_fail(ERR_BUG, "a tip that is no number, without an error"));
            }
        }
    }

done:
    rod_state_free(state);
    rod_free(r);
    rod_ask_free(&ask);
    law_along_free(&law);
    return st;
}

static status read_rod(const char *directory, const char *name, void *context)
{
    char path[512];
    case_data c = {0};
    (void)context;
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    status st = case_open(&(case_request){.path = path}, &c);
    if (st == OK && case_has_rod(&c) && c.file.rod.tendons.count <= MOST_TENDONS) {
        st = solve(&c);
    }
    case_free(&c);
    return st;
}

int main(int argc, char **argv)
{
    char text[2][2048];
    mutant_seed seeds[2];
    const char *const rods[2] = {bent, pulled};
    for (int i = 0; i < 2; i++) {
        const int n = snprintf(text[i], sizeof text[i], "%s%s", start, rods[i]);
        seeds[i] = (mutant_seed){(const unsigned char *)text[i], (size_t)n};
    }
    return mutants_main(
        argc, argv, (mutant_plan){.nseed = 2, .seeds = seeds, .suffix = ".yaml", .read = read_rod});
}
