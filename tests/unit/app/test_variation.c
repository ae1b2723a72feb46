// A case solved again with other values: the same numbers as by --set, and nothing twice.
#include "app/variation.h"

#include "tests/test.h"

#include <string.h>
#include <time.h>
#include <unistd.h>

static const char text[] =
    "format: 1\n"
    "materials:\n"
    "  soft: {E_MPa: 0.66, nu: 0.3}\n"
    "  stiff: {E_MPa: 15.93, nu: 0.3}\n"
    "section:\n"
    "  model: full\n"
    "  shapes:\n"
    "    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3.2}, material: soft}\n"
    "    - {sector: {outer_radius_mm: 4, inner_radius_mm: 3.2, mid_angle_rad: pi, width_rad: "
    "pi/8}, "
    "material: stiff}\n"
    "rod:\n"
    "  length_mm: 120\n"
    "  base: {position_mm: [1, 2, 3], rotation_deg: [0, 90, 0]}\n"
    "  tendons:\n"
    "    - {name: t1, radius_mm: 3.6, angle_rad: 0, friction: 0.1}\n"
    "    - {name: t2, radius_mm: 3.6, angle_rad: pi}\n"
    "  tensions_N: [[0.49, 0], [0, 0.98]]\n";

static const char *const radii[] = {"rod.tendons.t1.radius_mm", "rod.tendons.t2.radius_mm"};
static const char *const modulus[] = {"materials.soft.E_MPa"};

typedef struct bench {
    char path[64];
    case_data c;
    variation v;
} bench;

static void set_up(bench *b)
{
    *b = (bench){.path = "/tmp/variation.XXXXXX"};
    const int file = mkstemp(b->path);
    CHECK(file >= 0 && write(file, text, sizeof text - 1) == (ssize_t)sizeof text - 1);
    (void)close(file);
    CHECK_OK(case_open(&(case_request){.path = b->path}, &b->c));
    CHECK_OK(variation_open(&b->c, NULL, &b->v));
}

static void tear_down(bench *b)
{
    variation_free(&b->v);
    case_free(&b->c);
    (void)unlink(b->path);
}

static parameter named(const char *name, int nkey, const char *const *keys, key_text *item)
{
    for (int i = 0; i < nkey; i++) {
        item[i] = (key_text){.text = keys[i]};
    }
    return (parameter){.at = {5, 3}, .name = name, .keys = {.count = nkey, .items = item}};
}

// the tip of the first solution by a fresh case under these settings
static pose tip_anew(const bench *b, const settings *s)
{
    case_data c = {0};
    variation v = {0};
    variation_answer a = {0};
    pose tip = {0};
    CHECK_OK(case_open(&(case_request){.path = b->path,
                                       .noverride = s->count,
                                       .overrides = (const char *const *)s->text},
                       &c));
    CHECK_OK(variation_open(&c, NULL, &v));
    CHECK_OK(variation_solve(&v, NULL, (mark){0}, &(variation_places){.nsolution = 1}, false, &a));
    tip = a.tip ? a.tip[0] : tip;
    variation_answer_free(&a);
    variation_free(&v);
    case_free(&c);
    return tip;
}

static void compare(bench *b, const parameter *p, double value, int sections)
{
    settings s = {0};
    variation_answer a = {0};
    const int before = b->v.nsection;
    CHECK_OK(settings_add(&s, p, value));
    CHECK_OK(variation_solve(&b->v, &s, p->at, &(variation_places){.nsolution = 1}, false, &a));
    const pose wanted = tip_anew(b, &s);
    for (int i = 0; i < 3 && a.tip; i++) {
        // the same arithmetic
        CHECK_WITHIN(a.tip[0].p.a[i], wanted.p.a[i], 1e-15);
    }
    CHECK(b->v.nsection == before + sections);
    variation_answer_free(&a);
    settings_free(&s);
}

static void gives_what_set_gives(bench *b)
{
    key_text item[2];
    const parameter radius = named("tendon radius", 2, radii, item);
    compare(b, &radius, 3.5, 0);
    key_text other[1];
    const parameter soft = named("soft modulus", 1, modulus, other);
    compare(b, &soft, 0.7, 1);
}

static void sees_from_the_clamp(bench *b)
{
    variation_answer world = {0}, local = {0};
    const double s[] = {0, 0.05, 0.12, 0.2};
    const variation_places where = {.nsolution = 2, .npoint = 4, .s = s};
    CHECK_OK(variation_solve(&b->v, NULL, (mark){0}, &where, false, &world));
    CHECK_OK(variation_solve(&b->v, NULL, (mark){0}, &where, true, &local));
    CHECK_WITHIN(vec3_norm(local.shape[0].p), 0, 1e-16);
    CHECK_WITHIN(world.shape[0].p.a[2], 3e-3, 1e-16);
    // the base's z lies along x
    CHECK_WITHIN(world.shape[1].p.a[0] - 1e-3, local.shape[1].p.a[2], 1e-15);
    // beyond the length is the tip
    CHECK_WITHIN(local.s[3], 0.12, 0);
    CHECK_WITHIN(vec3_norm(vec3_sub(local.shape[7].p, local.tip[1].p)), 0, 1e-16);
    variation_answer_free(&world);
    variation_answer_free(&local);
}

static void fails(bench *b, const char *key, const char *value, const char *words)
{
    key_text item[1];
    const parameter p = named("this one", 1, &key, item);
    settings s = {0};
    variation_answer a = {0};
    CHECK_OK(settings_add_text(&s, &p, value));
    const status st =
        variation_solve(&b->v, &s, p.at, &(variation_places){.nsolution = 1}, false, &a);
    if (st == OK || !strstr(status_message(), words) ||
        !strstr(status_message(), ":5:3: error: this one = ")) {
        test_failures++;
        printf("%s=%s gives %d '%s', wanted '%s'\n", key, value, (int)st, status_message(), words);
    }
    status_clear();
    settings_free(&s);
}

static void names_the_parameter(bench *b)
{
    fails(b, "rod.tendons.t1.radius_mmm", "3", "unknown unit 'mmm'");
    fails(b, "rod.tendons.t9.radius_mm", "3", "no entry is named 't9'");
    fails(b, "rod.tendons.t1.friction", "-1", "out of range");
    fails(b, "materials.soft.nu", "0.7", "breaks -1 < nu < 0.5");
    fails(b, "rod.tensions_N", "[[9, 0]]", "eaten");
}

static void a_rod_costs_milliseconds(bench *b)
{
    key_text item[2];
    const parameter radius = named("tendon radius", 2, radii, item);
    const clock_t start = clock();
    enum { N = 20 };
    for (int i = 0; i < N; i++) {
        settings s = {0};
        variation_answer a = {0};
        CHECK_OK(settings_add(&s, &radius, 3.5 + 0.01 * i));
        CHECK_OK(
            variation_solve(&b->v, &s, radius.at, &(variation_places){.npoint = 61}, true, &a));
        variation_answer_free(&a);
        settings_free(&s);
    }
    printf("another radius, 2 solutions at 61 places: %.2f ms\n",
           1e3 * (double)(clock() - start) / CLOCKS_PER_SEC / N);
}

int main(void)
{
    bench b;
    set_up(&b);
    gives_what_set_gives(&b);
    sees_from_the_clamp(&b);
    names_the_parameter(&b);
    a_rod_costs_milliseconds(&b);
    tear_down(&b);
    return test_failures != 0;
}
