// tests/verify/rodsolver/verify_rod_references.c
// Published-model references (classical section, nu = 0.45) that are good to 1e-11 m: the constant
// and the helical prototype and the homogeneous tube, in both frames.
#include "tests/unit/rodsolver/prototypes.h"

typedef struct reference {
    const char *name;
    prototype (*rod)(void);
    int ntendon;
    double angle[2], tension[2];
    double tip[3], rotation[9], length[2];
} reference;

static const reference references[] = {
    {"constant 0.49 N at 0",
     constant_nc,
     2,
     {0, PROTOTYPE_PI},
     {0.49, 0},
     {0.08028418628221297, 0, 0.05294104438628274},
     {-0.39388801360484094, 0, 0.9191584372339903, 0, 1, 0, -0.9191584372339903, 0,
      -0.39388801360484094},
     {0.10667998613176924, 0.12090469548105877}},
    {"constant 0.49 N at pi",
     constant_nc,
     2,
     {0, PROTOTYPE_PI},
     {0, 0.49},
     {-0.02969691042957603, 0, 0.11397934811276046},
     {0.8728618346068766, 0, -0.4879674350678721, 0, 1, 0, 0.4879674350678721, 0,
      0.8728618346068766},
     {0.12090469548105877, 0.11723442627800254}},
    {"constant 0.98 N at 0",
     constant_nc,
     2,
     {0, PROTOTYPE_PI},
     {0.98, 0},
     {0.04600661601636546, 0, -0.019715267641886875},
     {-0.6897044654768701, 0, -0.724090982060446, 0, 1, 0, 0.724090982060446, 0,
      -0.6897044654768701},
     {0.09335997226353845, 0.12180939096211772}},
    {"constant 0.98 N at pi",
     constant_nc,
     2,
     {0, PROTOTYPE_PI},
     {0, 0.98},
     {-0.055183595642014256, 0, 0.09871079721865669},
     {0.5237755646265664, 0, -0.8518563012035079, 0, 1, 0, 0.8518563012035079, 0,
      0.5237755646265664},
     {0.12180939096211774, 0.11446885255600503}},
    {"helical 0.98 N",
     helical_nc,
     1,
     {PROTOTYPE_PI / 2},
     {0.98},
     {-0.03127907696297282, 0.08485895950768964, 0.02897760051018824},
     {0.7061437832222057, 0.19878839654788028, 0.6795911497470459, -0.3269666825629065,
      -0.7597791893715279, 0.5619860958170881, 0.6280555277285975, -0.6190466515504701,
      -0.47151616864505935},
     {0.10750020676641828}},
    {"helical 1.96 N",
     helical_nc,
     1,
     {PROTOTYPE_PI / 2},
     {1.96},
     {-0.005438892654100678, 0.03703327984881886, -0.036215048325144994},
     {-0.654541577939713, -0.6732324134727578, 0.34399627933716026, 0.5254634475509536,
      -0.7322473425574335, -0.43324588238717515, 0.5435655324209459, -0.102819972608385,
      0.8330453560261465},
     {0.09500041353283664}},
    {"tube 0.5 N",
     homogeneous_tube,
     1,
     {0},
     {0.5},
     {0.08036061934312379, 0, 0.01564721861694736},
     {-0.9269438453622451, 0, 0.37520009001205157, 0, 1, 0, -0.37520009001205157, 0,
      -0.9269438453622451},
     {0.10505104162262004}},
    {"tube 1.0 N",
     homogeneous_tube,
     1,
     {0},
     {1.0},
     {0.005614314304212794, 0, -0.013870343394778906},
     {0.718449784909887, 0, -0.6955788284320691, 0, 1, 0, 0.6955788284320691, 0, 0.718449784909887},
     {0.09010208324524023}},
};

static void solve(const reference *ref, int frame, double tolerance, rod_solution *out)
{
    const prototype p = ref->rod();
    law_along law = {0};
    prototype_law(&p, &law);
    const tendon_spec tendon[2] = {straight_tendon("first", 3.6e-3, ref->angle[0]),
                                   straight_tendon("second", 3.6e-3, ref->angle[1])};
    const made_rod r =
        solved_rod(&law, ref->ntendon, tendon,
                   (rod_options){.frame = frame, .tolerance = tolerance}, ref->tension, out);
    free_rod(r);
    law_along_free(&law);
}

static void tips_agree_with_the_references(int frame)
{
    printf("%-24s %-5s %12s %12s %12s\n", "", "frame", "tip [m]", "rotation", "length [m]");
    for (size_t i = 0; i < sizeof references / sizeof *references; i++) {
        const reference *ref = &references[i];
        double length[2];
        rod_solution out = {.tendon_length = length};
        solve(ref, frame, 1e-9, &out);
        const vec3 wanted = {{ref->tip[0], ref->tip[1], ref->tip[2]}};
        mat3 R;
        for (int j = 0; j < 9; j++) {
            R.a[j / 3][j % 3] = ref->rotation[j];
        }
        double worst = 0;
        for (int j = 0; j < ref->ntendon; j++) {
            worst = fmax(worst, fabs(length[j] - ref->length[j]));
        }
        printf("%-24s %-5s %12.2e %12.2e %12.2e\n", ref->name, frame == FRAME_GC ? "GC" : "NC",
               distance(out.tip.p, wanted), rotation_difference(out.tip.R, R), worst);
        // tolerance 1e-9 of 0.12 m
        CHECK_WITHIN(distance(out.tip.p, wanted), 0, 1.2e-10);
        CHECK_WITHIN(rotation_difference(out.tip.R, R), 0, 1e-8);
        CHECK_WITHIN(worst, 0, 1e-10);
    }
}

// the same rod, integrated along another curve
static void frames_agree(void)
{
    for (size_t i = 0; i < sizeof references / sizeof *references; i++) {
        rod_solution gc = {0}, nc = {0};
        solve(&references[i], FRAME_GC, 1e-12, &gc);
        solve(&references[i], FRAME_NC, 1e-12, &nc);
        CHECK_WITHIN(distance(gc.tip.p, nc.tip.p), 0, 1e-12);
        CHECK_WITHIN(rotation_difference(gc.tip.R, nc.tip.R), 0, 1e-11);
        for (int c = 0; c < 6; c++) {
            // at different stations: the plans differ
            CHECK_WITHIN(nc.max_strain.a[c], gc.max_strain.a[c], c < 3 ? 1e-4 : 0.1);
        }
    }
}

int main(void)
{
    against(BY_OTHER_CODE, "rods of an independent code, good to 1e-11 m");
    tips_agree_with_the_references(FRAME_GC);
    tips_agree_with_the_references(FRAME_NC);
    frames_agree();
    return test_failures != 0;
}
