// tests/unit/app/test_segment_stack.c
// Bodies of stacks of images: voxels, what they are made of, what hangs together.
#include "tests/unit/app/made_body.h"
#include "tests/unit/app/stack_files.h"

static const slice_kind whole[SLICES] = {WHOLE, WHOLE, CUT, WHOLE};

static void every_pixel_is_there(void)
{
    const stack s = write_stack(whole);
    const double sizes[] = {0.5e-3, 1e-3, 0.25e-3, 0};
    const double voxel = 0.25e-6 * 2e-3; // [m^3]
    for (int k = 0; k < 4; k++) {
        made m;
        const segment_mesh ask = {.order = k % 2 + 1, .size = sizes[k]};
        CHECK_OK(make(s.text, "fem: {length_mm: 8, loads: []}\n", ask, 1, &m));
        CHECK(m.source.fixed_layers && m.body.nlayer % SLICES == 0 &&
              m.body.nlayer == m.source.nlayer);
        const body_volume v = body_volumes(&m.body);
        // as pixels: 4 stiff per slice; all of slice 2 beyond column 2 is cut, so 2 of its 4 too.
        // squares of 2 x 2 pixels: the odd slices' columns become 1 and 2, level votes
        if (k != 1) {
            CHECK_NEAR(v.of[1], (3 * 4 + 2) * voxel, 1e-12);
            CHECK_NEAR(v.of[0] + v.of[1], (3 * 144 + 36) * voxel, 1e-12);
        }
        CHECK_NEAR(v.smallest, 1, 1e-9);
        unmake(&m);
    }
    remove_stack(&s);
}

// from the middle of the second slice into the third, turned: volumes as before
static void a_part_of_a_stack_is_one(void)
{
    const stack s = write_stack(whole);
    char text[700];
    made m;
    const segment_mesh ask = {.order = 1, .size = 0.5e-3};
    (void)snprintf(text, sizeof text, "%s  turn_rad: 0.7\n  scale: 2\n", s.text);
    CHECK_OK(make(text,
                  "rod: {length_mm: 8, rest: {twist_rad_per_m: 30}}\n"
                  "fem: {length_mm: 2, section_at_mm: 3, loads: []}\n",
                  ask, 1, &m));
    CHECK_NEAR(m.spec.turn_rate, 30, 1e-12);
    const body_volume v = body_volumes(&m.body);
    CHECK_NEAR(v.of[0] + v.of[1], 4 * 0.25e-6 * (144 + 36) * 1e-3, 2e-4); // twisted order 1
    CHECK_NEAR(v.of[1] / (v.of[0] + v.of[1]), 6.0 / 180, 2e-4);
    unmake(&m);
    CHECK(make(text, "rod: {length_mm: 8}\nfem: {length_mm: 6, section_at_mm: 3, loads: []}\n", ask,
               1, &m) == ERR_INPUT);
    unmake(&m);
    remove_stack(&s);
}

static void floating_parts_are_refused(void)
{
    const slice_kind apart[SLICES] = {WHOLE, CUT, FAR, WHOLE};
    const stack s = write_stack(apart);
    made m;
    const segment_mesh ask = {.order = 1, .size = 0.5e-3};
    CHECK(make(s.text, "fem: {length_mm: 8, loads: []}\n", ask, 1, &m) == ERR_INPUT);
    CHECK(strstr(status_message(), "in slice 3 from the base") != NULL);
    CHECK(strstr(status_message(), "does not hang together") != NULL);
    unmake(&m);
    // as a prism it is what its first slice shows
    CHECK_OK(make(s.text, "fem: {length_mm: 8, body: prism, loads: []}\n", ask, 2, &m));
    CHECK(m.body.prism && !m.source.fixed_layers);
    unmake(&m);
    remove_stack(&s);
}

int main(void)
{
    every_pixel_is_there();
    a_part_of_a_stack_is_one();
    floating_parts_are_refused();
    return test_failures != 0;
}
