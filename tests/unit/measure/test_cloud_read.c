// Point clouds from files: every format gives the points that were written, whatever stands around
// them.
#include "measure/cloud_read.h"

#include "tests/clouds.h"
#include "tests/test.h"

#include <math.h>
#include <string.h>

enum { COUNT = 7 };

// exact as floats, and as decimals
static const double points[COUNT][3] = {{1, 2, 3},    {-4.5, 0.25, 100}, {0.125, -7, 8},
                                        {9, 10, -11}, {12.5, 13, 14},    {0, 0, 0},
                                        {-1000, 2, 3}};

static void check_points(const char *what, const char *path, double unit, double scale)
{
    point_cloud c = {0};
    cloud_report r;
    const cloud_read_options o = {.unit = unit};
    if (cloud_read(path, &o, &c, &r) != OK) {
        test_failures++;
        printf("%s: %s\n", what, status_message());
        status_clear();
        return;
    }
    CHECK(c.count == COUNT && r.read == COUNT && r.dropped == 0);
    for (size_t i = 0; i < c.count && i < COUNT; i++) {
        for (int d = 0; d < 3; d++) {
            const double wanted = points[i][d] * scale;
            if (!(fabs(c.p[i][d] - wanted) <= 1e-15 * fabs(wanted))) {
                test_failures++;
                printf("%s: point %zu is %g, wanted %g\n", what, i, c.p[i][d], wanted);
            }
        }
    }
    point_cloud_free(&c);
}

static void every_form_of_ply(void)
{
    static const char *const types[] = {"float", "double"};
    for (int form = 0; form < 3; form++) {
        for (int type = 0; type < 2; type++) {
            for (int around = 0; around < 3; around++) {
                cloud_file f = cloud_file_new(".ply");
                cloud_file_ply(&f, form, types[type], around, COUNT, points);
                check_points(types[type], cloud_file_close(&f), NAN, 1e-3);
                cloud_file_remove(&f);
            }
        }
    }
}

static void every_form_of_pcd(void)
{
    for (int form = 0; form < 3; form++) {
        for (int around = 0; around < 3; around++) {
            cloud_file f = cloud_file_new(".pcd");
            cloud_file_pcd(&f, form, around, COUNT, points);
            check_points("pcd", cloud_file_close(&f), 1.0, 1.0);
            cloud_file_remove(&f);
        }
    }
}

// rows of text as each of these programs writes them
static void text(const char *head, const char *format, double unit, double scale)
{
    cloud_file f = cloud_file_new(".dat"); // its name says nothing
    fputs(head, f.stream);
    for (int i = 0; i < COUNT; i++) {
        fprintf(f.stream, format, points[i][0], points[i][1], points[i][2]);
    }
    check_points(format, cloud_file_close(&f), unit, scale);
    cloud_file_remove(&f);
}

static void text_with_any_marks(void)
{
    text("", "%g %g %g\n", NAN, 1e-3);
    text("", "%g %g %g\r\n", 1.0, 1.0);
    text("", "  %.17e\t%.6f   %.3f  \n", NAN, 1e-3);
    text("\"x\",\"y\",\"z\"\n", "\"%g\",\"%g\",\"%g\"\n", NAN, 1e-3);
    text("", "\"%g\" \"%g\" \"%g\"\n", NAN, 1e-3);
    text("# x y z\n\n", "%g, %g, %g\n", NAN, 1e-3);
    text("", "%g,%g,%g,0,0,1,255,128,0\n", NAN, 1e-3);
    text("7\n", "%g %g %g -812 10 20 30\n", NAN, 1e-3);
    text("\xef\xbb\xbfx;y;z\n", "%g;%g;%g\n", NAN, 1e-3);
    text("//X Y Z R G B\n", "%g %g %g 1 2 3\n", NAN, 1e-3);
    text("made by a scanner\non a day\n", "%g\t%g\t%g\n", NAN, 1e-3);
}

static void names_tell_columns_and_units(void)
{
    text("x_m,y_m,z_m\n", "%g,%g,%g\n", NAN, 1);
    text("x_um,y_um,z_um\n", "%g,%g,%g\n", NAN, 1e-6);
    text("\"X [cm]\",\"Y [cm]\",\"Z [cm]\"\n", "%g,%g,%g\n", NAN, 1e-2);
    text("t (s),X (mm),note,Y (mm),Z (mm)\n", "0,%g,left,%g,%g\n", NAN, 1e-3);
    text("i x [m] y [m] z [m]\n", "5 %g %g %g\n", NAN, 1);
    text("a,b,c,d,e,f,g,h,i,x,y,z\n", "1,2,3,4,5,6,7,8,9,%g,%g,%g\n", 1e-2, 1e-2);
}

static void decimal_commas(void)
{
    cloud_file f = cloud_file_new(".csv");
    fputs("x_mm;y_mm;z_mm\n1;2,5;-3,25e1\n4,0;5;6\n", f.stream);
    point_cloud c = {0};
    cloud_report r;
    CHECK_OK(cloud_read(cloud_file_close(&f), &(cloud_read_options){.unit = NAN}, &c, &r));
    CHECK(c.count == 2 && r.unit_named);
    CHECK_NEAR(c.p[0][1], 2.5e-3, 1e-15);
    CHECK_NEAR(c.p[0][2], -32.5e-3, 1e-15);
    CHECK_NEAR(c.p[1][0], 4e-3, 1e-15);
    point_cloud_free(&c);
    cloud_file_remove(&f);
}

static void what_is_not_finite_is_dropped_and_counted(void)
{
    static const double some[4][3] = {{1, 2, 3}, {NAN, 2, 3}, {1, INFINITY, 3}, {4, 5, 6}};
    for (int kind = 0; kind < 7; kind++) {
        cloud_file f = cloud_file_new(".x");
        if (kind < 3) {
            cloud_file_ply(&f, kind, "float", 1, 4, some);
        } else if (kind < 6) {
            cloud_file_pcd(&f, kind - 3, 1, 4, some);
        } else {
            fputs("1 2 3\nNaN 2 3\n1 -inf 3\n4 5 6\n", f.stream);
        }
        point_cloud c = {0};
        cloud_report r;
        CHECK_OK(cloud_read(cloud_file_close(&f), &(cloud_read_options){.unit = 1}, &c, &r));
        CHECK(c.count == 2 && r.read == 4 && r.dropped == 2);
        CHECK_WITHIN(c.p[1][2], 6.0, 0);
        point_cloud_free(&c);
        cloud_file_remove(&f);
    }
}

// whole numbers of every size, either order
static void whole_numbers_in_ply(void)
{
    static const struct {
        const char *type;
        int size;
    } kinds[] = {{"char", 1}, {"uchar", 1}, {"int16", 2}, {"ushort", 2}, {"int", 4}, {"uint32", 4}};
    for (int k = 0; k < 6; k++) {
        for (int big = 0; big < 2; big++) {
            cloud_file f = cloud_file_new(".ply");
            fprintf(f.stream,
                    "ply\nformat binary_%s_endian 1.0\nelement vertex 1\nproperty %s x\n"
                    "property %s y\nproperty %s z\nend_header\n",
                    big ? "big" : "little", kinds[k].type, kinds[k].type, kinds[k].type);
            for (int d = 1; d <= 3; d++) {
                cloud_file_bits(&f, (uint64_t)(40 * d), kinds[k].size, big);
            }
            point_cloud c = {0};
            cloud_report r;
            CHECK_OK(cloud_read(cloud_file_close(&f), &(cloud_read_options){.unit = 1}, &c, &r));
            CHECK(c.count == 1);
            CHECK_WITHIN(c.count ? c.p[0][2] : NAN, 120.0, 0);
            point_cloud_free(&c);
            cloud_file_remove(&f);
        }
    }
}

// a file of these bytes is refused with these words
static void refused(const char *bytes, size_t count, const char *words)
{
    cloud_file f = cloud_file_new(".ply");
    (void)fwrite(bytes, 1, count, f.stream);
    point_cloud c = {0};
    cloud_report r;
    const status st = cloud_read(cloud_file_close(&f), &(cloud_read_options){.unit = NAN}, &c, &r);
    if (st != ERR_FILE || !strstr(status_message(), words) || !strstr(status_message(), f.path)) {
        test_failures++;
        printf("'%s': status %d, '%s', wanted '%s'\n", bytes, (int)st, status_message(), words);
    }
    CHECK(c.p == NULL);
    status_clear();
    cloud_file_remove(&f);
}

#define REFUSED(text, words) refused(text, sizeof(text) - 1, words)
#define PLY_HEAD "ply\nformat ascii 1.0\n"
#define XYZ_PLY "property float x\nproperty float y\nproperty float z\n"
#define PCD_HEAD "# .PCD v0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"

static void damaged_ply_is_refused(void)
{
    REFUSED(PLY_HEAD, "the header does not end");
    REFUSED("ply\nend_header\n", ":2: a header without a format");
    REFUSED("ply\nformat ebcdic 1.0\n", ":2: format 'ebcdic'");
    REFUSED(PLY_HEAD "element vertex 2\n" XYZ_PLY "end_header\n1 2 3\n", "after 1 of 2 points");
    REFUSED(PLY_HEAD "element vertex 1000000000000000000\n" XYZ_PLY "end_header\n1 2 3\n",
            "at most 20000000");
    REFUSED(PLY_HEAD "element vertex 1000\n" XYZ_PLY "end_header\n1 2 3\n", "but the file has");
    REFUSED(PLY_HEAD "element vertex 99999999999999999999999\n" XYZ_PLY "end_header\n",
            ":3: an element needs");
    REFUSED(PLY_HEAD "element vertex -1\n" XYZ_PLY "end_header\n", ":3: an element needs");
    REFUSED(PLY_HEAD "element vertex 0\n" XYZ_PLY "end_header\n", "it has no points");
    REFUSED(PLY_HEAD "element vertex 1\nproperty real x\n", ":4: this is no property");
    REFUSED(PLY_HEAD "element vertex 1\nproperty list float int x\n", ":4: this is no property");
    REFUSED(PLY_HEAD "property float x\n", ":3: a property before any element");
    REFUSED(PLY_HEAD "element vertex 1\nproperty float x\nend_header\n1\n", "x, y and z");
    REFUSED(PLY_HEAD "element vertex 1\n" XYZ_PLY "end_header\n1 2\n", ":8: 2 columns, too few");
    REFUSED(PLY_HEAD "element vertex 1\n" XYZ_PLY "end_header\n1 2 3x\n", ":8: '3x' is no number");
    REFUSED("ply\nformat binary_little_endian 1.0\nelement vertex 1\n" XYZ_PLY
            "end_header\n\1\2\3\4\5\6\7\10\1\2\3",
            "ends in the middle of its points");
    REFUSED("ply\nformat binary_little_endian 1.0\nelement face 1000000000000000000\n"
            "property list uchar int vertex_indices\nelement vertex 1\n" XYZ_PLY
            "end_header\n123456789012",
            "more than the file holds");
    REFUSED("ply\nformat binary_little_endian 1.0\nelement none 1000000000000000000\n"
            "element vertex 1\n" XYZ_PLY "end_header\n123456789012",
            "more than the file holds");
}

static void damaged_pcd_is_refused(void)
{
    REFUSED("# .PCD v0.7\nFIELDS x y z\n", "the header has no DATA");
    REFUSED("# .PCD v0.7\nFIELDS x y\nSIZE 4 4 4\n", ":3: more entries than fields");
    REFUSED("# .PCD v0.7\nFIELDS x y z\nSIZE 4 4 3\n", ":3: SIZE 3");
    REFUSED("# .PCD v0.7\nFIELDS x y z\nTYPE F F G\n", ":3: TYPE G");
    REFUSED("# .PCD v0.7\nFIELDS x y z\nSIZE 2 4 4\nPOINTS 1\nDATA ascii\n1 2 3\n", "2 bytes");
    REFUSED("# .PCD v0.7\nFIELDS x y\nPOINTS 1\nDATA ascii\n1 2\n", "no field 'z'");
    REFUSED(PCD_HEAD "POINTS 1000000000000000000\nDATA binary\n123456789012", "at most 20000000");
    REFUSED(PCD_HEAD "WIDTH 4294967296\nHEIGHT 4294967296\nDATA binary\n123456789012",
            "it has no points");
    REFUSED(PCD_HEAD "POINTS 2\nDATA binary\n123456789012", "ends in the middle");
    REFUSED(PCD_HEAD "POINTS 3\nDATA ascii\n1 2 3\n4 5 6\n", "after 2 of 3 points");
    REFUSED(PCD_HEAD "POINTS 1\nDATA zip\n", ":7: DATA zip");
    REFUSED(PCD_HEAD "POINTS 1\nDATA binary_compressed\n\4\0\0\0\14\0\0\0\5\5\5\5", "packed");
    REFUSED(PCD_HEAD "POINTS 1\nDATA binary_compressed\n\2\0\0\0\14\0\0\0\340\377", "packed");
    REFUSED(PCD_HEAD "POINTS 1\nDATA binary_compressed\n\4\0\0\0\15\0\0\0\5\5\5\5", "unpacks to");
}

static void damaged_text_is_refused(void)
{
    REFUSED("", "it is empty");
    REFUSED("\n\n", "it has no row of numbers");
    REFUSED("1 2 3\n4 5\n", ":2: 2 columns, but 3");
    REFUSED("1 2\n3 4\n", ":1: 2 columns: a point takes x, y and z");
    REFUSED("1 2 3 4 5 6 7 8 9 10\n", ":1: 10 columns without names");
    REFUSED("1 2 3\n4 5 x\n", ":2: 'x' is no number");
    REFUSED("1,2,3\n4,,6\n", ":2: a cell is empty");
    REFUSED("x_mm,y_mm,z_m\n1,2,3\n", "different units");
    REFUSED("nan nan nan\nnan nan nan\n", "none of its 2 points is a finite place");
    REFUSED("1 2 3\n4 \0005 6\n", "it is no point cloud");
    char late[700];
    memset(late, ' ', sizeof late);
    memcpy(late, "1 2 3\n4 5", 9);
    late[650] = 0;
    refused(late, sizeof late, ":2: there is a zero byte");
    REFUSED("\177ELF\1\1\1\0\0\0", "it is no point cloud");
    REFUSED("hello\nworld\n", "it has no row of numbers");
}

static void the_files_unit_and_the_users_must_agree(void)
{
    cloud_file f = cloud_file_new(".csv");
    fputs("x_m,y_m,z_m\n1,2,3\n", f.stream);
    point_cloud c = {0};
    cloud_report r;
    const char *path = cloud_file_close(&f);
    CHECK(cloud_read(path, &(cloud_read_options){.unit = 1e-3}, &c, &r) == ERR_INPUT);
    status_clear();
    CHECK_OK(cloud_read(path, &(cloud_read_options){.unit = 1}, &c, &r));
    point_cloud_free(&c);
    cloud_file_remove(&f);
}

int main(void)
{
    every_form_of_ply();
    every_form_of_pcd();
    text_with_any_marks();
    names_tell_columns_and_units();
    decimal_commas();
    what_is_not_finite_is_dropped_and_counted();
    whole_numbers_in_ply();
    damaged_ply_is_refused();
    damaged_pcd_is_refused();
    damaged_text_is_refused();
    the_files_unit_and_the_users_must_agree();
    return test_failures != 0;
}
