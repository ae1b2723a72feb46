// tests/verify/app/verify_beam_models.c
// What assumptions about the section cost a rod: against an independent 3D code, and the ends told
// from the law by two lengths of our own 3D. docs/theory.md (5.19)
#include "app/beam_models.h"
#include "app/chain.h"

#include "tests/test.h"

#include <string.h>

// Compliances of the tip [mm, rad / N, N mm] by curved high-order hexahedra, base clamped, rigid
// cap: the upper triangles. Good to 9e-5, 2e-5, 2e-5.
static const double constant_20[21] = {
    23.917007683924982,      7.018702556762894e-11,   -2.4600769702955807,
    -4.1722996746122515e-12, 1.1624816688791673,      -1.6161848725536857e-12,
    38.80063306236766,       -6.623382180704366e-12,  -2.4331697033845594,
    2.8956250104005657e-12,  0.21378716272977993,     1.1999589518868163,
    3.4994737102740385e-13,  -0.24600769703143013,    1.9111736367720273e-13,
    0.24331697033857033,     -1.7509843097152815e-13, 1.591214952655256e-12,
    0.11624816688875944,     -6.773363284243685e-14,  0.29942150198682455};
static const double constant_120[21] = {
    3427.7302475676743,      2.6752539631920824e-05, -89.55099657218443,    -3.0438508031699285e-07,
    42.19901209221298,       -1.893823141603717e-08, 7111.10489199625,      -6.405481787045183e-07,
    -88.45778431340312,      3.008790610348002e-07,  1.0306138079853089,    7.26977194761135,
    7.324682115041779e-09,   -1.4925166146688007,    4.584058291291611e-10, 1.4742964249814021,
    -3.4383135341877657e-09, -2.696460586207379e-09, 0.7033168706155009,    -2.1594086018192766e-10,
    1.8379956642455995};
static const double helical_120[21] = {
    4524.370002339337,    -708.0399020012336,   40.11089147277404,   5.859751773948503,
    59.83647363340619,    2.347238777579812,    4817.17956630691,    60.685065665430045,
    -57.88395100263348,   -5.2922530336707805,  1.6546701579959064,  7.101668832756489,
    -0.9995435651613662,  0.030188406830251528, -0.1276170426942785, 1.006645297822918,
    -0.01684495098617085, -0.03718798090070899, 1.016768748722489,   -0.001991837743348555,
    1.7507230094507946};

typedef struct known_body {
    const char *what, *file;
    int noverride;
    const char *override[6];
    const double *upper;
    double published[BEAM_MODELS]; // misses of rods of these sections by the code's own authors
} known_body;

static const known_body known[] = {
    {"constant NC, 20 mm",
     "constant_nc",
     2,
     {"fem.length_mm=20", "fem.tolerance=1e-3"},
     constant_20,
     {0.3096730813745063, 0.04564152457094043, 0.04564152457094043}},
    {"constant NC, 120 mm",
     "constant_nc",
     2,
     {"fem.length_mm=120", "fem.tolerance=1e-3"},
     constant_120,
     {0.3252474088236081, 0.004438146312226713, 0.004438146312226713}},
    {"helical NC, 120 mm",
     "helical_segment",
     1,
     {"fem.method=direct"},
     helical_120,
     {0.3425043159505308, 0.036192597115379595, 0.006721798259945455}},
};

static void open_case(const char *file, int n, const char *const *overrides, case_data *c)
{
    char path[4096];
    const char *source = getenv("STIFFAXIS_SOURCE");
    (void)snprintf(path, sizeof path, "%s/cases/%s.yaml", source ? source : ".", file);
    if (case_open(&(case_request){.path = path, .noverride = n, .overrides = overrides}, c) != OK) {
        printf("%s\n", status_message());
        exit(1);
    }
}

static mat6 in_metres(const double *upper)
{
    mat6 C;
    for (int i = 0, k = 0; i < 6; i++) {
        for (int j = i; j < 6; j++, k++) {
            C.a[i][j] = C.a[j][i] = upper[k] * (i < 3 ? 1e-3 : 1) * (j < 3 ? 1 : 1e3);
        }
    }
    return C;
}

// what the rods miss is what was found independently: the reference's digits and the laws' 1e-5
static void rods_miss_what_is_published(const known_body *k)
{
    case_data c = {0};
    beam_models m = {0};
    const mat6 wanted = in_metres(k->upper);
    open_case(k->file, k->noverride, k->override, &c);
    CHECK_OK(beam_models_make(&c, c.file.fem.length, &m));
    for (int i = 0; i < BEAM_MODELS; i++) {
        mat6 C;
        CHECK(!m.why[i][0]);
        CHECK_OK(beam_models_compliance(&m, i, c.file.fem.length, &C));
        const double miss = mat6_relative_error(C, wanted);
        printf("%-20s %-24s misses 3D by %.4f, published %.4f\n", k->what, beam_model_name(i), miss,
               k->published[i]);
        CHECK_WITHIN(miss, k->published[i], 1e-4);
    }
    beam_models_free(&m);
    case_free(&c);
}

// our own 3D, entry by entry
static void our_segment_is_the_reference(const known_body *k)
{
    case_data c = {0};
    run_result r = {0};
    open_case(k->file, k->noverride, k->override, &c);
    CHECK_OK(chain_segment(&c, false, &r));
    const double apart = mat6_relative_error(r.segment.tip_compliance, in_metres(k->upper));
    printf("%-20s our 3D (%s) and the reference: %.1e, said %.1e\n", k->what, r.segment.why, apart,
           r.segment.relative_error);
    CHECK_BELOW(apart, 2e-4);
    run_result_free(&r);
    case_free(&c);
}

static mat6 turning_compliance(const char *length, beam_models *models)
{
    char words[2][40];
    const char *const overrides[] = {words[0], words[1]};
    case_data c = {0};
    run_result r = {0};
    (void)snprintf(words[0], sizeof words[0], "rod.length_mm=%s", length);
    (void)snprintf(words[1], sizeof words[1], "fem.length_mm=%s", length);
    open_case("turning_30", 2, overrides, &c);
    CHECK_OK(chain_segment(&c, false, &r));
    if (models) {
        CHECK_OK(beam_models_make(&c, c.file.fem.length, models));
    }
    const mat6 C = r.segment.tip_compliance;
    run_result_free(&r);
    case_free(&c);
    return C;
}

// what a third turn adds in stretch, bending and twist
static mat6 third_turn(const mat6 *two, const mat6 *three)
{
    mat6 F = mat6_identity();
    for (int i = NZ; i < 6; i++) {
        for (int j = NZ; j < 6; j++) {
            F.a[i][j] = three->a[i][j] - two->a[i][j];
        }
    }
    return F;
}

// a helix of one turn in 30 mm: two and three turns differ by what the section's own law says, and
// sections taken as prisms are far off
static void turns_tell_the_law_from_its_ends(void)
{
    beam_models models = {0};
    const mat6 two = turning_compliance("60", NULL), three = turning_compliance("90", &models);
    const mat6 solid = third_turn(&two, &three);
    double miss[BEAM_MODELS];
    for (int i = 0; i < BEAM_MODELS; i++) {
        mat6 C[2];
        CHECK_OK(beam_models_compliance(&models, i, 60e-3, &C[0]));
        CHECK_OK(beam_models_compliance(&models, i, 90e-3, &C[1]));
        miss[i] = mat6_relative_error(third_turn(&C[0], &C[1]), solid);
        printf("a turn in 30 mm, %-24s: tip %.1e, law alone %.1e\n", beam_model_name(i),
               mat6_relative_error(C[0], two), miss[i]);
    }
    CHECK_BELOW(miss[BEAM_TURNING], 5e-4);
    CHECK_ABOVE(miss[BEAM_PRISMATIC], 0.15);
    beam_models_free(&models);
}

int main(void)
{
    against(BY_OTHER_CODE,
            "3D FEM of an independent code: curved high-order hexahedra, direct solver");
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        rods_miss_what_is_published(&known[i]);
    }
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        our_segment_is_the_reference(&known[i]);
    }
    against(BY_SECOND_WAY, "segments of two lengths");
    turns_tell_the_law_from_its_ends();
    return test_failures != 0;
}
