// tests/unit/reach/test_surface_read.c
#include "reach/surface_read.h"

#include "tests/surface_files.h"
#include "tests/test.h"

#include <unistd.h>

static char path[64];

static status read_file(surface *s, surface_report *r)
{
    const surface_options options = {.path = path};
    return surface_read(&options, 1e-3, s, r);
}

static void write_bytes(const void *bytes, size_t n)
{
    FILE *f = fopen(path, "wb");
    CHECK(f && fwrite(bytes, 1, n, f) == n);
    if (f) {
        (void)fclose(f);
    }
}

static void refuse(const char *words)
{
    surface s = {0};
    surface_report r;
    CHECK(read_file(&s, &r) == ERR_FILE);
    const bool said =
        strstr(status_message(), words) && strncmp(status_message(), path, strlen(path)) == 0;
    if (!said) {
        printf("wanted '%s', said '%s'\n", words, status_message());
    }
    CHECK(said);
    CHECK(strchr(status_message(), '\n') == NULL);
    surface_free(&s);
    status_clear();
}

static void refuse_text(const char *text, const char *words)
{
    write_bytes(text, strlen(text));
    refuse(words);
}

static size_t form_bytes(surface_form form, char **bytes)
{
    made_surface m = {0};
    size_t n = 0;
    made_ball(&m, 3, made_bumpy);
    FILE *f = open_memstream(bytes, &n);
    put_surface(f, &m, form);
    (void)fclose(f);
    made_free(&m);
    return n;
}

static void every_form_gives_the_surface(void)
{
    made_surface m = {0};
    surface wanted = {0}, s = {0};
    surface_report r;
    made_ball(&m, 3, made_bumpy);
    CHECK_OK(made_closed(&m, &wanted, &r));
    for (int form = 0; form < FORMS; form++) {
        char *bytes = NULL;
        const size_t n = form_bytes(form, &bytes);
        write_bytes(bytes, n);
        CHECK_OK(read_file(&s, &r));
        CHECK(s.nvertex == wanted.nvertex && s.ntriangle == wanted.ntriangle && r.turned == 0);
        // single precision in the file
        CHECK_NEAR(s.volume, wanted.volume, 1e-6);
        CHECK_NEAR(s.area, wanted.area, 1e-6);
        for (int d = 0; d < 3; d++) {
            CHECK_WITHIN(s.low[d], wanted.low[d], 1e-8);
            CHECK_WITHIN(s.high[d], wanted.high[d], 1e-8);
        }
        surface_free(&s);
        free(bytes);
    }
    surface_free(&wanted);
    made_free(&m);
}

// wherever it is cut, it is refused in one line
static void cut_files_are_refused(void)
{
    for (int form = 0; form < FORMS; form++) {
        char *bytes = NULL;
        const size_t n = form_bytes(form, &bytes);
        for (size_t cut = 1; cut < n - 30; cut += 1 + n / 40) {
            write_bytes(bytes, cut);
            refuse(": ");
        }
        free(bytes);
    }
}

static void counts_that_lie_are_refused(void)
{
    char *bytes = NULL;
    size_t n = form_bytes(FORM_STL_BYTES, &bytes);
    memset(bytes + 80, 0xff, 4);
    write_bytes(bytes, n);
    refuse("a binary STL of 4294967295 triangles has 214748364834 bytes, but this file ");
    free(bytes);
    n = form_bytes(FORM_STL_BYTES, &bytes);
    bytes[80]--;
    write_bytes(bytes, n);
    refuse("a binary STL of 71 triangles has ");
    free(bytes);
    refuse_text("ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\n"
                "property float y\nproperty float z\nelement face 1\n"
                "property list uchar int vertex_index\nend_header\n1 2 3\n",
                "elements 'vertex' are more than the file holds");
    refuse_text("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                "property float z\nelement face 1\nproperty list uchar int vertex_index\n"
                "end_header\n1 2 3\n3 0 0 1\n",
                ":11: a face names a vertex that is not among the 1 in front of it");
    refuse_text("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                "property float z\nend_header\n1 2 3\n",
                "it has no faces");
}

static void bad_lines_are_named(void)
{
    refuse_text("solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 2 x\n",
                ":4: a vertex needs three numbers");
    refuse_text("solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 2 nan\nvertex 1 2 3\n"
                "vertex 1 2 4\nendloop\nendfacet\nendsolid\n",
                ":8: a corner of triangle 1 has no finite place within 10 km");
    refuse_text("solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 2 3\nendloop\nendfacet\n",
                ":6: a facet with 1 corners");
    refuse_text("solid a\nvertex 1 2 3\n", ":2: a vertex where none is due");
    refuse_text("solid a\nfacet normal 0 0 1\nfacet\n", ":3: a facet within another");
    refuse_text("solid a\nwarble\n", ":2: 'warble' is no word of an STL file");
    refuse_text("solid a\n", "the file ends before 'endsolid'");
    refuse_text("solid a\nendsolid a\n", "0 triangles: a closed surface has from 4");
    refuse_text("v 1 2\n", ":1: a vertex needs three numbers");
    refuse_text("v 1 2 3\nf 1 2 3\n", ":2: '2' is no vertex: 1 are in front of it");
    refuse_text("v 1 2 3\nf -2 1 1\n", ":2: '-2' is no vertex");
    refuse_text("v 1 2 3\nf 0 1 1\n", ":2: '0' is no vertex");
    refuse_text("v 1 2 3\nf 1 1\n", ":2: a face with 2 corners");
    refuse_text("v 1 2 3\nf 1x 1 1\n", ":2: '1x' is no vertex");
    refuse_text("v 1e300 2 3\nf 1 1 1\n", ":2: a corner of triangle 1 has no finite place");
    refuse_text("hello\n", ":1: 'hello' is no word of an OBJ file");
    refuse_text("call other.obj\n", ":1: 'call' is no word of an OBJ file");
    refuse_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "1 triangles: a closed surface has from 4");
    refuse_text("", "it is empty");
    refuse_text("\001\002\003", "it is no STL, OBJ or PLY");
}

static void polygons_are_fanned(void)
{
    surface s = {0};
    surface_report r;
    static const char cube[] =
        "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n"
        "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    write_bytes(cube, sizeof cube - 1);
    CHECK_OK(read_file(&s, &r));
    CHECK(s.ntriangle == 12 && s.nvertex == 8 && r.turned == 0);
    CHECK_NEAR(s.volume, 8e-9, 1e-12);
    surface_free(&s);
}

static void a_huge_file_of_nothing_is_refused_at_once(void)
{
    static const char *const heads[] = {"", "solid a\n", "ply\nformat ascii 1.0\n", "v 1 2 3\n"};
    for (int i = 0; i < 4; i++) {
        write_bytes(heads[i], strlen(heads[i]));
        CHECK(truncate(path, (off_t)5 << 30) == 0);
        refuse("it has 5368709120 bytes; at most 2147483648 are read");
        CHECK(truncate(path, (off_t)1 << 30) == 0);
        refuse(": ");
    }
}

int main(void)
{
    (void)snprintf(path, sizeof path, "/tmp/stiffaxis-surface-XXXXXX");
    const int fd = mkstemp(path);
    CHECK(fd >= 0);
    (void)close(fd);
    every_form_gives_the_surface();
    cut_files_are_refused();
    counts_that_lie_are_refused();
    bad_lines_are_named();
    polygons_are_fanned();
    a_huge_file_of_nothing_is_refused_at_once();
    (void)unlink(path);
    return test_failures != 0;
}
