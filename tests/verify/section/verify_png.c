// Sections drawn as images: exact where pixels draw them exactly, the same however the image lies,
// and for what pixels cannot draw, a ring with a stiff sector, how fast they come near, as they are
// and smoothed, and what the same image in wider pixels says of the error.
#include "tests/verify/section/png_sections.h"

static const double pi = 3.14159265358979323846;

static const material two[2] = {{.name = "soft", .E = 0.66, .nu = 0.3},
                                {.name = "stiff", .E = 15.93, .nu = 0.3}};

static beam_law law_of(const printed *p, int order, double size)
{
    beam_law law = {0};
    mesh m = {0};
    const mesh_options options = {.order = order, .size = size};
    CHECK_OK(drawing_mesh(p->drawing, 0, &options, &m));
    CHECK_OK(section_full_mesh(&m, two, &law, NULL));
    mesh_free(&m);
    return law;
}

// --- a rectangle of 4 x 1 mm

static int in_rectangle(double x, double y, const void *unused)
{
    (void)unused;
    return fabs(x) < 20 && fabs(y) < 5;
}

static void a_rectangle_of_pixels_is_that_rectangle(void)
{
    printed p;
    beam_centres c = {0};
    const double G = two[0].E / 2.6, GJ = 1.1232518332307129 * G; // Saint-Venant's series
    for (int smoothed = 0; smoothed < 2; smoothed++) {
        open_printed(50, 24, 0.1, smoothed, in_rectangle, NULL, 2, two, &p);
        const beam_law law = law_of(&p, 4, 0.05);
        CHECK_OK(beam_law_centres(&law, &c));
        printf("rectangle: GJ %.1e off its series\n", c.GJ / GJ - 1);
        CHECK_NEAR(law.area, 4, smoothed ? 1e-7 : 1e-12);
        CHECK_NEAR(c.EI_centre[0], two[0].E / 3, smoothed ? 1e-6 : 1e-11);
        CHECK_NEAR(c.EI_centre[1], two[0].E * 16 / 3, smoothed ? 1e-6 : 1e-11);
        // r^2 log r at the corners: h^4, 5e-10 at a twentieth of the height
        CHECK_NEAR(c.GJ, GJ, smoothed ? 1e-6 : 1e-9);
        drawing_free(p.drawing);
    }
}

// --- the image turned and mirrored

typedef struct placed {
    double c, s; // turned by
    bool mirrored;
} placed;

static int lopsided(double x, double y, const void *context)
{
    const placed *q = context;
    const double u = q->c * x + q->s * y, v = (q->c * y - q->s * x) * (q->mirrored ? -1 : 1);
    if (hypot(u + 2, v - 1) > 13.2 || hypot(u - 4, v + 3) < 4.1) {
        return 0;
    }
    return u + 0.4 * v > 3 ? 2 : 1;
}

// K of what is turned by a quarter n times, seen from axes that are turned with it
static mat6 law_turned(int n, bool mirrored, bool smoothed)
{
    printed p;
    const placed q = {
        .c = round(cos(n * pi / 2)), .s = round(sin(n * pi / 2)), .mirrored = mirrored};
    open_printed(40, 40, 0.1, smoothed, lopsided, &q, 2, two, &p);
    const beam_law law = law_of(&p, 2, 0);
    drawing_free(p.drawing);
    mat6 K = beam_law_move(law.K, 0, 0, n * pi / 2);
    // y -> -y: what has one y among its directions, or turns about x or z, changes sign
    const double sign[6] = {1, -1, 1, -1, 1, -1};
    for (int i = 0; i < 6 && mirrored; i++) {
        for (int j = 0; j < 6; j++) {
            K.a[i][j] *= sign[i] * sign[j];
        }
    }
    return K;
}

static void it_does_not_matter_how_the_image_lies(void)
{
    for (int smoothed = 0; smoothed < 2; smoothed++) {
        const mat6 first = law_turned(0, false, smoothed);
        for (int k = 1; k < 8; k++) {
            const mat6 K = law_turned(k % 4, k / 4, smoothed);
            // rounding of the solves, and of curves that are smoothed from another end
            CHECK_WITHIN(mat6_relative_error(K, first), 0, smoothed ? 1e-7 : 1e-9);
        }
    }
}

// --- a ring with a stiff sector, anywhere on the raster

typedef struct ring {
    double outer, inner, angle, centre[2]; // [pixels, rad]
} ring;

static int in_ring(double x, double y, const void *context)
{
    const ring *r = context;
    const double u = x - r->centre[0], v = y - r->centre[1], d = hypot(u, v);
    if (d > r->outer || d < r->inner) {
        return 0;
    }
    return fabs(remainder(atan2(v, u) - r->angle - pi, 2 * pi)) < pi / 16 ? 2 : 1;
}

// the constant-offset prototype (mm, N), sector at angle pi: closed forms, and GJ and shears from a
// mesh of order 4, 1e-7
static mat6 ring_stiffness(void)
{
    mat6 K = {{{2.138247702752}, {0, 2.867969908873}, {0, 0, 29.2130417672}}};
    K.a[3][3] = 81.2360411093;
    K.a[4][4] = 302.0390668764;
    K.a[5][5] = 65.8881998944;
    K.a[2][4] = K.a[4][2] = 62.0273603423;
    K.a[1][5] = K.a[5][1] = -1.5960168844;
    return K;
}

typedef struct outcome {
    double area, EA, EI, GJ, K; // relative errors
    double wide;                // difference to the image in pixels twice as wide
} outcome;

static outcome print_ring(int size, bool smoothed, int trial)
{
    // irrational steps: every place on the raster is as likely
    const double pitch = 8.56 / size, turn = 2 * pi * fmod(0.6180339887 * (trial + 1), 1);
    const ring r = {.outer = 4 / pitch,
                    .inner = 3.2 / pitch,
                    .angle = turn,
                    .centre = {fmod(0.7548776662 * (trial + 1), 1) - 0.5,
                               fmod(0.5698402910 * (trial + 1), 1) - 0.5}};
    printed p;
    beam_centres c = {0};
    beam_law wide = {0};
    mesh m = {0};
    bool found = false;
    open_printed(size, size, pitch, smoothed, in_ring, &r, 2, two, &p);
    const beam_law law = law_of(&p, 2, 0);
    CHECK_OK(beam_law_centres(&law, &c));
    const mesh_options options = {.order = 2};
    CHECK_OK(drawing_mesh_coarser(p.drawing, 0, &options, &m, &found));
    CHECK(found);
    CHECK_OK(section_full_mesh(&m, two, &wide, NULL));
    mesh_free(&m);
    drawing_free(p.drawing);
    const mat6 own = beam_law_move(law.K, pitch * r.centre[0], pitch * r.centre[1], turn);
    return (outcome){.area = law.area / (pi * 5.76) - 1,
                     .EA = c.EA / 29.2130417672 - 1,
                     .EI = c.EI[0] / 81.2360411093 - 1,
                     .GJ = c.GJ / 65.0000212 - 1,
                     .K = mat6_relative_error(own, ring_stiffness()),
                     .wide = mat6_relative_error(wide.K, law.K)};
}

enum { TRIALS = 5, SIZES = 3 };

// root mean squares over the trials
typedef struct means {
    double h[SIZES], area[SIZES], EA[SIZES], EI[SIZES], GJ[SIZES], K[SIZES];
} means;

static means converge(bool smoothed, double least[2], int *loose)
{
    static const int sizes[SIZES] = {40, 80, 160};
    means a = {.h = {0}};
    for (int k = 0; k < SIZES; k++) {
        for (int t = 0; t < TRIALS; t++) {
            const outcome o = print_ring(sizes[k], smoothed, t);
            a.area[k] += o.area * o.area / TRIALS;
            a.EA[k] += o.EA * o.EA / TRIALS;
            a.EI[k] += o.EI * o.EI / TRIALS;
            a.GJ[k] += o.GJ * o.GJ / TRIALS;
            a.K[k] += o.K * o.K / TRIALS;
            least[smoothed] = fmin(least[smoothed], o.wide / o.K);
            *loose += o.wide > 30 * o.K;
        }
        double *const all[5] = {&a.area[k], &a.EA[k], &a.EI[k], &a.GJ[k], &a.K[k]};
        for (int i = 0; i < 5; i++) {
            *all[i] = sqrt(*all[i]);
        }
        a.h[k] = 1.0 / sizes[k];
        printf("%3d pixels, %s: area %.1e EA %.1e EI %.1e GJ %.1e K %.1e\n", sizes[k],
               smoothed ? "smoothed" : "pixels  ", a.area[k], a.EA[k], a.EI[k], a.GJ[k], a.K[k]);
    }
    return a;
}

static void smoothed_rings_come_nearer_than_pixels(void)
{
    double least[2] = {INFINITY, INFINITY};
    int loose = 0;
    const means pixels = converge(false, least, &loose), smooth = converge(true, least, &loose);
    // stairs weaken what they surround in proportion to their depth; what is left of them, and the
    // count of pixels, falls faster
    CHECK_WITHIN(observed_order(SIZES, pixels.h, pixels.GJ), 1, 0.3);
    CHECK_ABOVE(observed_order(SIZES, smooth.h, smooth.GJ), 1.2);
    for (int k = 0; k < SIZES; k++) {
        CHECK_BELOW(smooth.GJ[k], pixels.GJ[k] / 3);
        CHECK_BELOW(smooth.K[k], pixels.K[k]);
        // the area is that of the pixels, with what little the junctions change
        CHECK_BELOW(smooth.area[k], 1.3 * pixels.area[k]);
        CHECK_BELOW(smooth.EA[k], 1.3 * pixels.EA[k]);
    }
    printf("difference to pixels twice as wide over the error: at least %.2f, smoothed %.2f\n",
           least[0], least[1]);
    // the error lies below the difference; smoothed, where a count of few pixels decides, below
    // three times the difference
    CHECK_ABOVE(least[0], 1);
    CHECK_ABOVE(least[1], 1.0 / 3);
    CHECK_AT_MOST(loose, 2 * SIZES * TRIALS / 10);
}

int main(void)
{
    against(BY_CLOSED_FORM, "rectangles of pixels; a ring with a stiff sector, theory (2.6)");
    a_rectangle_of_pixels_is_that_rectangle();
    it_does_not_matter_how_the_image_lies();
    smoothed_rings_come_nearer_than_pixels();
    return test_failures != 0;
}
