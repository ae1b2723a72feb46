// tests/unit/meshes/test_step.c
// tests/files/bar.step: a cylinder of radius 4 mm, 'jacket', around one of radius 2 mm, 'core',
// red, whose axis lies 0.5 mm beside it. Axes along the file's x, the jacket's through (.., 20, 30)
// from x = 5 to 15; the core lies towards y.
#include "base/door.h"
#include "tests/msh.h"
#include "tests/shapes.h"
#include "tests/test.h"

#include <sys/stat.h>

static const material both[2] = {{.name = "jacket", .E = 1e6, .nu = 0.3},
                                 {.name = "core", .E = 5e6, .nu = 0.4}};

static step_spec bar(void)
{
    return (step_spec){.at = {3, 3},
                       .file = {.text = "bar.step", .at = {3, 9}},
                       .origin = {10e-3, 20e-3, 30e-3},
                       .normal = {2, 0, 0},
                       .x_axis = {0, 1, 0}};
}

static status open_step(const char *directory, const step_spec *spec, const mesh_options *options,
                        mesh *out)
{
    drawing_files files = {.step = *spec};
    drawing *d = NULL;
    const drawing_request request = {.directory = directory, .nmaterial = 2, .materials = both};
    status_clear();
    status st = drawing_open(&files, &request, &d);
    if (st == OK) {
        st = drawing_mesh(d, 0, options, out);
    }
    drawing_free(d);
    return st;
}

static void a_bar_is_cut_in_its_own_axes(void)
{
    char folder[512];
    const step_spec spec = bar();
    // nodes are Gauss-Lobatto points of arcs of at most a = 0.06, 0.15, 0.25, 0.35: the area within
    // the polynomial through them is off by a^2 / 6, a^4 / 480, a^6 / 75700, a^8 / 2.04e7 of it
    const double tolerance[] = {0, 6.1e-4, 1.06e-6, 3.3e-9, 1.15e-11};
    for (int p = 1; p <= 4; p++) {
        mesh m = {0};
        const mesh_options options = {.order = p};
        CHECK_OK(open_step(files_folder(folder), &spec, &options, &m));
        CHECK(m.order == p && mesh_is_conforming(&m));
        // 16 mm^2 and 4 mm^2 may be off by their own parts
        CHECK_NEAR(mesh_moments(&m, 0).a[0], 12e-6 * PI, 4.0 / 3 * tolerance[p]);
        CHECK_NEAR(mesh_moments(&m, 1).a[0], 4e-6 * PI, tolerance[p]);
        CHECK_NEAR(mesh_moments(&m, 1).a[1], 4e-6 * PI * 0.5e-3, tolerance[p]); // x: the file's y
        CHECK_WITHIN(mesh_moments(&m, 1).a[2], 0, 1e-6 * 4e-9);
        mesh_free(&m);
    }
}

static void bodies_go_by_colour_and_by_none(void)
{
    char folder[512];
    mesh m = {0};
    const mesh_options options = {.order = 2};
    step_spec spec = bar();
    part_spec parts[2] = {
        {.at = {5, 7}, .colour = {"#FF0000", {5, 7}}, .material = {"jacket", {5, 9}}},
        {.at = {6, 7}, .name = {"jacket", {6, 7}}, .material = {"none", {6, 9}}}};
    spec.parts = (key_list){.at = {5, 5}, .count = 2, .items = parts};
    // its name is a material's too: the name comes first, and the colour is in vain
    CHECK(open_step(files_folder(folder), &spec, &options, &m) == ERR_INPUT);
    spec.parts.items = parts + 1;
    spec.parts.count = 1;
    CHECK_OK(open_step(folder, &spec, &options, &m));
    CHECK_NEAR(mesh_moments(&m, -1).a[0], 4e-6 * PI, 1e-4); // the core is left
    mesh_free(&m);
}

static void expect(const step_spec *spec, status wanted, const char *words)
{
    char folder[512];
    mesh m = {0};
    const mesh_options options = {.order = 2};
    const status st = open_step(files_folder(folder), spec, &options, &m);
    if (st != wanted || !strstr(status_message(), words)) {
        printf("%d '%s', wanted %d '%s'\n", (int)st, status_message(), (int)wanted, words);
        CHECK(false);
    }
}

static void planes_that_do_not_cut_are_told(void)
{
    step_spec s = bar();
    s.origin[0] = 16e-3;
    expect(&s, ERR_FILE, "meets no body");
    s.origin[0] = 15e-3;
    expect(&s, ERR_FILE, "runs along a face of the body 'jacket'");
    s = bar();
    s.x_axis[0] = 1;
    s.x_axis[1] = 0;
    expect(&s, ERR_INPUT, "along `normal`");
    s = bar();
    s.file.text = "tongue.geo";
    expect(&s, ERR_FILE, "no STEP file");
    s.file.text = "absent.step";
    expect(&s, ERR_FILE, "absent.step");
    s.file.text = "overlap.step"; // two cylinders, 'left' and 'right', along z
    s.origin[0] = s.origin[1] = s.origin[2] = s.normal[0] = 0;
    s.normal[2] = 1;
    expect(&s, ERR_FILE, "the bodies 'left' and 'right' overlap");
}

static char *file_text(const char *name)
{
    char folder[512], path[640], *text = calloc(1, 1 << 16);
    (void)snprintf(path, sizeof path, "%s/%s", files_folder(folder), name);
    FILE *f = fopen(path, "r");
    CHECK(f && text && fread(text, 1, (1 << 16) - 1, f) > 0);
    if (f) {
        (void)fclose(f);
    }
    return text;
}

// the same bar with some words replaced, everywhere
static status open_changed(const char *from, const char *to, step_spec spec, mesh *out)
{
    char folder[] = "/tmp/stiffaxis-step-XXXXXX", path[64], *text = file_text("bar.step");
    const mesh_options options = {.order = 4};
    CHECK(mkdtemp(folder) != NULL);
    (void)snprintf(path, sizeof path, "%s/bar.step", folder);
    FILE *f = fopen(path, "w");
    for (const char *at = text; f && text; at++) {
        const char *found = strstr(at, from);
        (void)fprintf(f, "%.*s", (int)(found ? found - at : (long)strlen(at)), at);
        if (!found) {
            break;
        }
        (void)fputs(to, f);
        at = found + strlen(from) - 1;
    }
    if (f) {
        (void)fclose(f);
    }
    free(text);
    const status st = open_step(folder, &spec, &options, out);
    (void)remove(path);
    CHECK(rmdir(folder) == 0); // and nothing else was there
    return st;
}

static void the_files_unit_counts(void)
{
    mesh m = {0};
    step_spec spec = bar();
    for (int i = 0; i < 3; i++) {
        spec.origin[i] *= 1e3;
    }
    CHECK_OK(open_changed("SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT($,.METRE.)", spec, &m));
    CHECK_NEAR(mesh_moments(&m, 1).a[0], 4 * PI, 1e-6);
    mesh_free(&m);
}

static void a_damaged_file_is_refused(void)
{
    mesh m = {0};
    CHECK(open_changed("END-ISO-10303-21;", "", bar(), &m) == ERR_FILE);
    CHECK(strstr(status_message(), "not complete") != NULL);
    CHECK(open_changed("MANIFOLD_SOLID_BREP", "NO_SUCH_THING", bar(), &m) == ERR_FILE);
    CHECK(strstr(status_message(), "bar.step: ") != NULL);
    CHECK(open_changed("'core'", "'kore'", bar(), &m) == ERR_FILE);
    CHECK(strstr(status_message(), "did you mean 'core'?") != NULL);
}

int main(void)
{
    a_bar_is_cut_in_its_own_axes();
    bodies_go_by_colour_and_by_none();
    planes_that_do_not_cut_are_told();
    the_files_unit_counts();
    a_damaged_file_is_refused();
    return test_failures != 0;
}
