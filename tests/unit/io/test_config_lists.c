// Lists of expressions, rows with gaps, and the units of loads.
#include "io/json.h"
#include "tests/test.h"
#include "tests/unit/io/case_file.h"

#include <math.h>
#include <string.h>

typedef struct line {
    mark at;
    field force[3], place[2];
    double from[2];
    key_rows pulls;
    double gravity[3], twist;
} line;

static const key line_list[] = {
    {.name = "force",
     .kind = KEY_FIELDS,
     .dimension = DIM_FORCE_PER_LENGTH,
     .min = -100,
     .max = 100,
     .count = 3,
     .offset = offsetof(line, force),
     .about = "of a line"},
    {.name = "place",
     .kind = KEY_FIELDS,
     .dimension = DIM_LENGTH,
     .count = 2,
     .offset = offsetof(line, place),
     .about = "in the section"},
    {.name = "from", .kind = KEY_REAL, .dimension = DIM_FORCE, .offset = offsetof(line, from[0])},
    {.name = "from", .kind = KEY_REAL, .dimension = DIM_NONE, .offset = offsetof(line, from[1])},
    {.name = "pulls",
     .kind = KEY_ROWS,
     .dimension = DIM_LENGTH,
     .open = true,
     .offset = offsetof(line, pulls)},
    {.name = "gravity",
     .kind = KEY_VECTOR,
     .dimension = DIM_ACCELERATION,
     .count = 3,
     .offset = offsetof(line, gravity)},
    {.name = "twist",
     .kind = KEY_REAL,
     .dimension = DIM_CURVATURE,
     .offset = offsetof(line, twist)},
};
static const key_table line_keys = {
    "line", sizeof(line), (int)(sizeof line_list / sizeof *line_list), line_list, NULL, "a line"};

typedef struct reading {
    status st;
    line value;
    config *cfg;
} reading;

static reading read_line(const char *text)
{
    reading r = {0};
    case_file_write(text, strlen(text));
    status_clear();
    r.st = config_open(case_file_path, 0, NULL, &r.cfg);
    if (r.st == OK) {
        config_set_length(r.cfg, 0.12);
        r.st = config_read(r.cfg, &line_keys, &r.value);
    }
    (void)remove(case_file_path);
    return r;
}

static void each_entry_may_vary(void)
{
    reading r = read_line("force_N_per_mm: [1e-3, 2e-3*s/L, 0]\nplace_mm: [s/40, 3]\n");
    CHECK_OK(r.st);
    CHECK(!field_varies(&r.value.force[0]) && field_varies(&r.value.force[1]));
    CHECK_NEAR(field_at(&r.value.force[0], 0), 1, 1e-15);
    CHECK_NEAR(field_at(&r.value.force[1], 0.06), 1, 1e-15);
    CHECK_NEAR(field_at(&r.value.place[0], 0.04), 1e-3, 1e-18); // s in mm, as the key
    CHECK_NEAR(field_at(&r.value.place[1], 0.04), 3e-3, 1e-18);
    config_free(r.cfg);
}

static void rows_may_have_gaps(void)
{
    reading r = read_line("pulls_mm: [[1, ~], [null, -2]]\n");
    CHECK_OK(r.st);
    CHECK(r.value.pulls.nrow == 2 && r.value.pulls.ncol == 2);
    CHECK(r.value.pulls.a[0] == 1e-3 && isnan(r.value.pulls.a[1]));
    CHECK(isnan(r.value.pulls.a[2]) && r.value.pulls.a[3] == -2e-3);
    config_free(r.cfg);
}

// two of one name, in units of different kinds, are two keys
static void units_of_loads(void)
{
    reading r = read_line("from_mN: 3\nfrom: 0.5\ngravity_m_per_s2: [0, 0, -9.81]\n"
                          "twist_deg_per_m: 180\n");
    CHECK_OK(r.st);
    CHECK_NEAR(r.value.from[0], 3e-3, 1e-15);
    CHECK(r.value.from[1] == 0.5);
    CHECK(r.value.gravity[2] == -9.81);
    CHECK_NEAR(r.value.twist, acos(-1.0), 1e-14);
    config_free(r.cfg);
}

static void mistakes_have_their_place(void)
{
    static const struct {
        const char *text, *words;
    } all[] = {
        {"force_N_per_m: [1, 2]\n", ":1:16: error: 'force_N_per_m': expected a list of 3 numbers"},
        {"force_N_per_m: 1\n", ":1:16: error: 'force_N_per_m': expected a list of 3 numbers"},
        {"force_N_per_m: [1, ~, 2]\n", ":1:20: error: 'force_N_per_m'"},
        {"force_N_per_m: [1, 1/s, 2]\n", "not a finite number at s = 0 mm"},
        {"force_N_per_m: [1, 200*s/L, 2]\n", "is out of range, -100 N_per_m to 100 N_per_m"},
        {"force_N: [1, 2, 3]\n", ":1:1: error: "},
        {"pulls_mm: [[1, nan]]\n", ":1:16: error: 'pulls_mm': expected a number, found 'nan'"},
        {"pulls_mm: [[~, ]]\npulls_m: [[1]]\n", "are the same key"},
        {"gravity_m_per_s2: [0, ~, 0]\n", ":1:23: error: "},
        {"gravity: [0, 0, 0]\n", "key 'gravity' needs its unit: gravity_m_per_s2"},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        reading r = read_line(all[i].text);
        if (r.st != ERR_INPUT || !strstr(status_message(), all[i].words)) {
            test_failures++;
            printf("%s  gives %d, %s\n", all[i].text, (int)r.st, status_message());
        }
        status_clear();
        config_free(r.cfg);
    }
}

static void the_schema_allows_gaps(void)
{
    static char text[64 << 10];
    json *j = NULL;
    FILE *stream = fmemopen(text, sizeof text, "w");
    CHECK_OK(json_open(stream, &j));
    CHECK_OK(schema_write(&line_keys, j));
    CHECK_OK(json_close(j));
    (void)fclose(stream);
    CHECK(strstr(text, "\"null\"") && strstr(text, "\"force_N_per_mm\""));
    CHECK(strstr(text, "\"gravity_m_per_s2\"") && strstr(text, "may vary with the arclength s"));
}

int main(void)
{
    each_entry_may_vary();
    rows_may_have_gaps();
    units_of_loads();
    mistakes_have_their_place();
    the_schema_allows_gaps();
    return test_failures != 0;
}
