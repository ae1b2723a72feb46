// tests/unit/meshes/test_geo.c
// Scripts of gmsh: only where they are allowed. tests/files/tongue.geo is what tongue_*.msh hold.
#include "tests/msh.h"
#include "tests/shapes.h"
#include "tests/test.h"

static status open_geo(const char *directory, const char *name, bool allow, int order, double size,
                       mesh *out)
{
    drawing_files files = {0};
    files.geo = (geo_spec){.at = {3, 3}, .file = {.text = name, .at = {3, 9}}, .unit = UNIT_MM};
    drawing *d = NULL;
    const drawing_request request = {.directory = directory,
                                     .nmaterial = MSH_MATERIALS,
                                     .materials = msh_materials,
                                     .allow_scripts = allow};
    const mesh_options options = {.order = order, .size = size};
    status_clear();
    status st = drawing_open(&files, &request, &d);
    if (st == OK) {
        st = drawing_mesh(d, 0, &options, out);
    }
    drawing_free(d);
    return st;
}

static double area(const mesh *m, int material)
{
    double sum = 0;
    for (int b = 0; b < m->nblock; b++) {
        mesh one = *m;
        one.nblock = 1;
        one.block[0] = m->block[b];
        sum += mesh_moments(&one, material).a[0];
    }
    return sum;
}

static void an_allowed_script_gives_its_mesh(void)
{
    char folder[512];
    for (int p = 1; p <= 4; p++) {
        mesh m = {0};
        CHECK_OK(open_geo(files_folder(folder), "tongue.geo", true, p, 0, &m));
        CHECK(m.order == p && m.nblock == 2);
        CHECK_NEAR(area(&m, 1), 1e-6, 1e-12);
        CHECK_NEAR(area(&m, 0), p == 1 ? 1e-6 * sin(PI / 4) / 2 : 1e-6 * PI / 8,
                   p == 1 ? 1e-12 : 2e-3);
        mesh_free(&m);
    }
}

static void put(const char *path, const char *text)
{
    FILE *f = fopen(path, "w");
    CHECK(f && fputs(text, f) >= 0);
    if (f) {
        (void)fclose(f);
    }
}

static void a_script_does_not_run_unasked(void)
{
    char folder[] = "/tmp/stiffaxis-geo-XXXXXX", script[128], witness[128], text[512];
    int line = 0, column = 0;
    mesh m = {0};
    CHECK(mkdtemp(folder) != NULL);
    (void)snprintf(script, sizeof script, "%s/a.geo", folder);
    (void)snprintf(witness, sizeof witness, "%s/witness", folder);
    (void)snprintf(text, sizeof text, "SystemCall \"touch %s\";\n", witness);
    put(script, text);
    CHECK(open_geo(folder, "a.geo", false, 1, 0, &m) == ERR_INPUT);
    CHECK(strstr(status_message(), "--allow-scripts") != NULL);
    CHECK(status_place(&line, &column) && line == 3);
    CHECK(access(witness, F_OK) != 0);
    // allowed, it does run, or the check above could not fail; it makes no section
    CHECK(open_geo(folder, "a.geo", true, 1, 0, &m) == ERR_FILE);
    for (int i = 0; i < 100 && access(witness, F_OK) != 0; i++) {
        (void)usleep(20000); // gmsh does not wait for what it starts
    }
    CHECK(access(witness, F_OK) == 0);
    (void)remove(witness);

    put(script, "Point(1) = {0, 0, 0};\nLine(1) = {1, 7};\n");
    CHECK(open_geo(folder, "a.geo", true, 1, 0, &m) == ERR_FILE);
    CHECK(strstr(status_message(), "a.geo: ") != NULL);
    (void)remove(script);
    CHECK(rmdir(folder) == 0);
}

int main(void)
{
    an_allowed_script_gives_its_mesh();
    a_script_does_not_run_unasked();
    return test_failures != 0;
}
