// tests/unit/measure/test_table.c
#include "measure/table.h"
#include "tests/test.h"
#include "tests/unit/io/scratch.h"

#include <sys/resource.h>

static scratch dir;

static status read_bytes(const char *text, size_t size, const table_limits *limits, table *t)
{
    const scratch_path path = scratch_file(&dir, "t.csv");
    const key_text name = {.text = "t.csv"};
    write_whole(path.text, text, size);
    status_clear();
    return table_read(dir.path, &name, limits, t);
}

static status read_text(const char *text, table *t)
{
    return read_bytes(text, strlen(text), NULL, t);
}

// every way to write the rows (0, 0), (10 N, 0.5 mm), (20 N, 1 mm)
static void one_table_in_many_spellings(void)
{
    static const char *const all[] = {
        "force_N,extension_mm\n0,0\n10,0.5\n20,1\n",
        "Force [N];Extension [mm]\n0;0\n10;0,5\n20;1,0\n",
        "\xef\xbb\xbf\"Force (N)\",\"Extension (mm)\"\r\n\"0\",\"0\"\r\n\"10\",\"0.5\"\r\n\"20\","
        "\"1\"",
        "Force\tExtension\nN\tmm\n0\t0\n10\t0.5\n20\t1\n",
        "Force, Extension,\n(kN), (um),\n0, 0,\n0.01, 500,\n0.02, 1000,\n",
        "# force_N extension_m\n0 0\n10 5e-4\n20 1e-3\n",
        "Force [N] Extension [mm]\n 0   0\n 10  0.5 # a remark\n\n# another\n 20  1\n",
        "Test machine;17\nDate;1.4.2026\nWidth;Height\n4;2\n\nForce in N;Extension in "
        "cm\n0;0\n10;0,"
        "05\n20;0,1\n",
        "Force / N;Extension / \xc2\xb5m\r0;0\r10;500\r20;1000\r",
        "Force N,Time s,Extension mm\n0,0,0\n10,1,0.5\n20,2,1\n",
        "note,Force [N],Extension [mm]\n,0,0\n-,10,0.5\n3,20,1\n\x1a",
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        table t = {0};
        int force = -1, extension = -1;
        double *f = NULL, *e = NULL;
        CHECK_OK(read_text(all[i], &t));
        if (t.nrow != 3) {
            printf("table %zu has %d rows\n", i, t.nrow);
            test_failures++;
        } else {
            CHECK_OK(table_need(&t, "load|force", DIM_FORCE, &force));
            CHECK_OK(table_need(&t, "extension", DIM_LENGTH, &extension));
            CHECK_OK(table_take(&t, force, DIM_FORCE, &f));
            CHECK_OK(table_take(&t, extension, DIM_LENGTH, &e));
            CHECK(f[0] == 0 && f[1] == 10 && f[2] == 20);
            CHECK(e[0] == 0 && e[1] == 0.0005 && e[2] == 0.001);
        }
        free(f);
        free(e);
        table_free(&t);
    }
}

static void units_have_their_factors(void)
{
    static const struct {
        const char *header;
        dimension d;
        double factor;
    } all[] = {
        {"x [%]", DIM_NONE, 0.01},
        {"x_percent", DIM_NONE, 0.01},
        {"x (mm/mm)", DIM_NONE, 1},
        {"x [-]", DIM_NONE, 1},
        {"x", DIM_NONE, 1},
        {"x [N/mm^2]", DIM_STRESS, 1e6},
        {"x [N/mm\xc2\xb2]", DIM_STRESS, 1e6},
        {"x_N_per_mm2", DIM_STRESS, 1e6},
        {"x MPa", DIM_STRESS, 1e6},
        {"x_GPa", DIM_STRESS, 1e9},
        {"x (psi)", DIM_STRESS, 4.4482216152605 / (0.0254 * 0.0254)},
        {"x [kN]", DIM_FORCE, 1e3},
        {"x_mN", DIM_FORCE, 1e-3},
        {"x [in]", DIM_LENGTH, 0.0254},
        {"x [um]", DIM_LENGTH, 1e-6},
        {"x_mm2", DIM_AREA, 1e-6},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        char text[128];
        table t = {0};
        double factor = 0;
        (void)snprintf(text, sizeof text, "%s;y\n1;2\n", all[i].header);
        CHECK_OK(read_text(text, &t));
        CHECK_OK(table_column_si(&t, table_find(&t, "x"), all[i].d, &factor));
        CHECK_NEAR(factor, all[i].factor, 1e-12); // two ways to the same constant
        table_free(&t);
    }
}

static void a_row_of_ones_is_no_row_of_units(void)
{
    table t = {0};
    CHECK_OK(read_text("x_mm,y_mm\n1,1\n2,2\n", &t));
    CHECK(t.nrow == 2);
    table_free(&t);
}

static void missing_cells_are_nan_and_words_are_counted(void)
{
    static const table_limits limits = {.word_columns = "specimen|sample"};
    static const char text[] = "Specimen,Force_N,x_mm\nA,1,\nB,,2\nA,3,n/a\n";
    table t = {0};
    CHECK_OK(read_bytes(text, strlen(text), &limits, &t));
    CHECK(t.nrow == 3 && t.nword == 2);
    if (t.nrow == 3 && t.nword == 2) {
        CHECK(strcmp(t.word[0], "A") == 0 && strcmp(t.word[1], "B") == 0);
        CHECK(t.a[0] == 0 && t.a[3] == 1 && t.a[6] == 0);
        CHECK(isnan(t.a[2]) && isnan(t.a[4]) && isnan(t.a[8]) && t.a[7] == 3);
        CHECK(t.line[2] == 4);
    }
    table_free(&t);
}

static void the_lines_above_are_read_too(void)
{
    table t = {0};
    double value = 0;
    long found = 0;
    CHECK_OK(read_text("# Synthetic data\nGauge length [mm];25,4\nWidth: 4 mm\n\"Area\",\"8\","
                       "\"mm^2\"\n# thickness_mm = 2\nrate;slow\nx;y\n1;2\n",
                       &t));
    CHECK_OK(table_note(&t, "gauge_length", DIM_LENGTH, &value, &found));
    CHECK(found && value == 0.0254);
    CHECK_OK(table_note(&t, "width", DIM_LENGTH, &value, &found));
    CHECK(found && value == 0.004);
    CHECK_OK(table_note(&t, "thickness", DIM_LENGTH, &value, &found));
    CHECK(found && value == 0.002);
    CHECK_OK(table_note(&t, "area|cross_section", DIM_AREA, &value, &found));
    CHECK(found);
    CHECK_NEAR(value, 8e-6, 1e-15);
    CHECK_OK(table_note(&t, "height", DIM_LENGTH, &value, &found));
    CHECK(!found);
    CHECK(table_note(&t, "rate", DIM_LENGTH, &value, &found) == ERR_FILE);
    CHECK(strstr(status_message(), "t.csv:6: 'rate' has no number"));
    CHECK(table_says(&t, "synthetic") && !table_says(&t, "measured"));
    table_free(&t);
    status_clear();
}

static void fails_with(const char *text, size_t size, const char *words)
{
    table t = {0};
    const status st = read_bytes(text, size, NULL, &t);
    if (st != ERR_FILE || !strstr(status_message(), words)) {
        printf("wanted '%s', said '%s' (%d)\n", words, status_message(), (int)st);
        test_failures++;
    }
    table_free(&t);
}

static void every_mistake_has_its_line(void)
{
    static const struct {
        const char *text, *words;
    } all[] = {
        {"", "t.csv: it is empty"},
        {"\n\n , ,\n", "t.csv: it is empty"},
        {"# only\n# remarks here\n", "t.csv: it is empty"},
        {"x_mm,y_mm\n", "no row of numbers under a line of names"},
        {"only words\nand more of them\n", "no row of numbers"},
        {"1,2\n3,4\n", "t.csv:1: numbers without a line of names"},
        {"x\n1\n2\n", "t.csv:2: no line of names"},
        {"x,y\n1,2\n3\n", "t.csv:3: 1 columns, but 2 names"},
        {"x,y\n1,2,3\n", "t.csv:2: 3 columns, but 2 names"},
        {"x,y\n1,2\n3,4,5\n", "t.csv:3: 3 columns, but 2 names"},
        {"x,y\n1,nan\n", "t.csv:2: 'nan' is not a number"},
        {"x,y\n1,2\n1,NaN\n", "t.csv:3: 'NaN' is not a number"},
        {"x,y\n1,2\n1,-inf\n", "t.csv:3: '-inf' is not a number"},
        {"x,y\n1,2\n1,1e999\n", "t.csv:3: '1e999' is not a number"},
        {"x,y\n1,oops\n2,3\n", "t.csv:2: 'oops' is not a number"},
        {"x,y\n1,2\n3,0x10\n", "t.csv:3: '0x10' is not a number"},
        {"x,y\n1,2\n=cmd(),3\n", "t.csv:3: '=cmd()' is not a number"},
        {"x,y\n1,2\nend of data\n", "t.csv:3: this is no row of numbers"},
        {"x;y\n1,5;2\n1.5;2\n", "t.csv:3: '1.5' has a decimal point, and line 2 has a comma"},
        {"x,y\n1,\"2\n", "no row of numbers"},
        {"x,y\n1,2\n3,\"4\n", "t.csv:3: a quote mark is not closed"},
        {"\xff\xfex\0,\0", "it is in UTF-16"},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        fails_with(all[i].text, strlen(all[i].text), all[i].words);
    }
    fails_with("x,y\n1,2\0\n", 9, "it is no text");
    fails_with("PK\x03\x04stuff", 9, "it is no text");
}

static void units_are_asked_for(void)
{
    static const struct {
        const char *text, *words;
    } all[] = {
        {"x,y\n1,2\n", "t.csv:1: column 'x' has no unit: write 'x [mm]'"},
        {"x [N],y\n1,2\n", "t.csv:1: column 'x' cannot be in 'N': it takes mm"},
        {"x [furlong],y\n1,2\n", "t.csv:1: unknown unit 'furlong' of column 'x'"},
        {"z,y\n1,2\n", "t.csv:1: no column 'x_mm' in the line of names"},
        {"x_mm,X_m\n1,2\n", "t.csv:1: two columns 'x'"},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        table t = {0};
        int column = -1;
        CHECK_OK(read_text(all[i].text, &t));
        CHECK(table_need(&t, "x", DIM_LENGTH, &column) == ERR_FILE);
        if (!strstr(status_message(), all[i].words)) {
            printf("wanted '%s', said '%s'\n", all[i].words, status_message());
            test_failures++;
        }
        table_free(&t);
    }
    status_clear();
}

static double seconds(void)
{
    struct rusage u;
    (void)getrusage(RUSAGE_SELF, &u);
    return (double)u.ru_utime.tv_sec + 1e-6 * (double)u.ru_utime.tv_usec;
}

static void large_files_are_refused_at_once(void)
{
    const scratch_path path = scratch_file(&dir, "t.csv");
    const key_text name = {.text = "t.csv"};
    table t = {0};
    enum { WIDE = 1000000 };
    char *wide = malloc(2 * WIDE + 8);
    CHECK(wide != NULL);
    for (int i = 0; wide && i < WIDE; i++) {
        wide[2 * i] = '1';
        wide[2 * i + 1] = i + 1 < WIDE ? ',' : '\n';
    }
    fails_with(wide, 2 * WIDE, "t.csv:1: more than 64 columns");
    // many lines none of which is a name, each with a comment: must not be looked at twice each
    for (int i = 0; wide && i < WIDE; i++) {
        wide[2 * i] = '#';
        wide[2 * i + 1] = '\n';
    }
    const double before = seconds();
    fails_with(wide, 2 * WIDE, "it is empty");
    CHECK(seconds() - before < 10); // linear: a fraction of a second, some under a sanitizer
    free(wide);

    status_clear();
    CHECK(truncate(path.text, (off_t)5 << 30) == 0);
    CHECK(table_read(dir.path, &name, NULL, &t) == ERR_FILE);
    CHECK(strstr(status_message(), "5368709120 bytes; at most"));

    static const char three[] = "x,y\n1,2\n3,4\n5,6\n";
    static const table_limits two = {.rows = 2};
    CHECK(read_bytes(three, strlen(three), &two, &t) == ERR_FILE);
    CHECK(strstr(status_message(), "t.csv:4: more than 2 rows"));
    status_clear();
}

int main(void)
{
    dir = scratch_make();
    one_table_in_many_spellings();
    units_have_their_factors();
    a_row_of_ones_is_no_row_of_units();
    missing_cells_are_nan_and_words_are_counted();
    the_lines_above_are_read_too();
    every_mistake_has_its_line();
    units_are_asked_for();
    large_files_are_refused_at_once();
    scratch_remove(&dir);
    return test_failures != 0;
}
