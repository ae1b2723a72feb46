// The rod as a person writes it: what arrives, and where mistakes are pointed out.
#include "app/case_rod.h"

#include "tests/test.h"

#include <string.h>
#include <unistd.h>

static const char start[] =
    "format: 1\n"
    "materials: {soft: {E_MPa: 1, nu: 0.3, density_kg_per_m3: 1100}}\n"
    "section: {shapes: [{annulus: {outer_radius_mm: 4, inner_radius_mm: 3}, material: soft}]}\n"
    "rod:\n"
    "  length_mm: 120\n";

static void write_file(const char *path, const char *text, size_t length)
{
    FILE *file = fopen(path, "wb");
    CHECK(file && fwrite(text, 1, length, file) == length);
    CHECK(file && fclose(file) == 0);
}

static status read_rod(const char *dir, const char *rod, case_data *c)
{
    char path[128], text[4096];
    (void)snprintf(path, sizeof path, "%s/case.yaml", dir);
    const int n = snprintf(text, sizeof text, "%s%s", start, rod);
    write_file(path, text, (size_t)n);
    status_clear();
    return case_open(&(case_request){.path = path}, c);
}

static void fails(const char *dir, status code, const char *rod, const char *words)
{
    case_data c = {0};
    const status st = read_rod(dir, rod, &c);
    if (st != code || !strstr(status_message(), words)) {
        test_failures++;
        printf("%s  gives %d, '%s', wanted '%s'\n", rod, (int)st, status_message(), words);
    }
    case_free(&c);
}

static void everything_arrives(const char *dir)
{
    case_data c = {0};
    CHECK_OK(read_rod(
        dir,
        "  base: {position_mm: [1, 2, 3], rotation_deg: [0, 90, 0], insertion_mm: 5, turn_rad: 1}\n"
        "  rest: {curvature_x_per_m: 2*s, twist_deg_per_m: 180}\n"
        "  breaks_mm: [40, 80]\n"
        "  tendons:\n"
        "    - {name: a, path_mm: [[0, 3, 0], [60, 3, 1], [L, 3, 0]], smooth_mm: 0.1,\n"
        "       friction: 0.2, EA_N: 50, outside_mm: 300}\n"
        "    - {name: b, x_mm: -3}\n"
        "  loads:\n"
        "    - {name: push, force_N: [0.02, 0, 0], moment_Nmm: [0, 1, 0], at_s_mm: 60,\n"
        "       frame: body, place_mm: [1, -1]}\n"
        "    - {force_mN: [1, 0, 0]}\n"
        "  line_loads: [{from_mm: 10, to_mm: L/2, force_N_per_m: [0, 0.1*s/L, 0]}]\n"
        "  gravity_m_per_s2: [0, 0, -9.81]\n"
        "  tensions_N: [[0.1, ~], [0.2, ~]]\n"
        "  pulls_mm: [[~, 2]]\n"
        "  load_factors: [[1, 1, 1, 0], [1, 1, 1, 1]]\n"
        "  sweep: [{load: push, from: 0, to: 1, steps: 4}]\n"
        "  start: last\n"
        "  past_limit_points: true\n"
        "  derivatives: true\n",
        &c));
    const rod_case *r = &c.file.rod;
    const law_along law = {.length = 0.12};
    const rod_spec spec = rod_case_spec(r, &law);
    CHECK(spec.ntendon == 2 && spec.npoint_load == 2 && spec.nline_load == 1 && spec.nbreak == 2);
    CHECK(spec.breaks && spec.breaks[1] == 0.08 && spec.gravity[2] == -9.81);
    CHECK_NEAR(field_at(&spec.rest.curvature_x, 0.06), 0.12, 1e-15);
    CHECK_NEAR(spec.rest.twist.value, acos(-1.0), 1e-15);
    if (r->spec) {
        const tendon_spec *t = r->spec;
        CHECK(t[0].table.count == 3 && t[0].table.point[6] == 0.12 && t[0].table.smooth == 1e-4);
        CHECK(t[0].friction == 0.2 && t[0].EA == 50 && t[0].outside == 0.3);
        CHECK(t[1].table.count == 0 && t[1].x.value == -3e-3);
        CHECK(spec.point_loads[0].s == 0.06 && spec.point_loads[0].frame == LOAD_BODY);
        CHECK(spec.point_loads[0].moment[1] == 1e-3 && spec.point_loads[0].place[1] == -1e-3);
        CHECK(spec.point_loads[1].s > 0.12 && spec.point_loads[1].frame == LOAD_SPACE);
        CHECK_NEAR(field_at(&spec.line_loads[0].force[1], 0.06), 0.05, 1e-15);
        CHECK(spec.line_loads[0].to == 0.06);
    }
    CHECK(rod_case_solutions(r) == 10 && r->start == START_LAST && r->past && r->derivatives);
    CHECK_NEAR(rod_case_base(r).p.a[0], 6e-3, 1e-14); // pushed along its own axis
    case_free(&c);
}

static void mistakes_have_their_place(const char *dir)
{
    static const struct {
        const char *rod, *words;
    } all[] = {
        {"  tendons: [{friction: -0.1}]\n", ":6:24: error: 'friction': -0.1 is out of range"},
        {"  tendons: [{path_mm: [[0, 1, 2]], path_csv: a.csv}]\n", "exclude each other"},
        {"  tendons: [{path_mm: [[0, 1, 2], [0, 1, 3]]}]\n  tensions_N: [[1]]\n",
         ":6:23: error: row 2 of the tendon's path does not lie beyond"},
        {"  tendons: [{path_mm: [[0, 1, 2], [nan, 1, 3]]}]\n", ":6:36: error: "},
        {"  tendons: [{end_mm: 121}]\n  tensions_N: [[1]]\n", ":6:13: error: the tendon ends"},
        {"  loads: [{at_s_mm: 130}]\n", ":6:11: error: the load lies at 130 mm"},
        {"  loads: [{at_s_mm: -1}]\n", ":6:21: error: 'at_s_mm': -1 mm is out of range"},
        {"  loads: [{frame: world}]\n", ":6:19: error: 'frame': expected one of space, body"},
        {"  loads: [{force: [1, 0, 0]}]\n", "key 'force' needs its unit: force_N"},
        {"  loads: [{force_N: [1, 0]}]\n", "expected a list of 3 numbers, found 2"},
        {"  line_loads: [{from_mm: 50, to_mm: 50}]\n", ":6:16: error: the load begins at 50 mm"},
        {"  line_loads: [{from_mm: 120}]\n", ":6:16: error: the load begins at 120 mm"},
        {"  line_loads: [{force_N_per_m: [1, 2, 1/0]}]\n", ":6:39: error: "},
        {"  breaks_mm: [40, 130]\n", ":6:14: error: a break at 130 mm"},
        {"  gravity: [0, 0, 1]\n", "needs its unit: gravity_m_per_s2"},
        {"  tendons: [{x_mm: 3}]\n", ":6:12: error: tendons without tensions"},
        {"  tendons: [{x_mm: 3}]\n  pulls_mm: [[~]]\n", ":7:13: error: row 1 gives neither"},
        {"  tendons: [{x_mm: 3}]\n  pulls_mm: [[1]]\n  tensions_N: [[1]]\n",
         ":7:13: error: row 1 gives tension and pulled length"},
        {"  tendons: [{x_mm: 3}]\n  tensions_N: [[-1]]\n", ":7:17: error: 'tensions_N': -1 N"},
        {"  load_factors: [[1]]\n", ":6:17: error: a row of load factors has 1 number for 0 loads"},
        {"  sweep: [{load: gravity, from: 0, to: 1, steps: 2}]\n",
         ":6:18: error: no load is called 'gravity'"},
        {"  tendons: [{name: a}]\n  sweep: [{tension_of: a, from_mm: 0, to_mm: 1, steps: 2}]\n",
         ":7:11: error: this sweep goes between `from_N`"},
        {"  tendons: [{name: a}]\n  sweep: [{tension_of: a, from_N: 0, to_N: 1, steps: 0}]\n",
         "'steps': 0 is out of range"},
        {"  start: middle\n", "'start': expected one of rest, last"},
        {"  rest: {curvature_x: 1}\n", "needs its unit: curvature_x_per_m"},
        {"  base: {rotation_deg: 90}\n", "expected a list of 3 numbers"},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        fails(dir, ERR_INPUT, all[i].rod, all[i].words);
    }
}

static void gravity_needs_densities(const char *dir)
{
    case_data c = {0};
    char path[128];
    static const char text[] =
        "format: 1\n"
        "materials:\n"
        "  soft: {E_MPa: 1, nu: 0.3}\n"
        "section: {shapes: [{annulus: {outer_radius_mm: 4, inner_radius_mm: 3}, material: soft}]}\n"
        "rod: {length_mm: 120, gravity_m_per_s2: [0, 0, -9.81]}\n";
    (void)snprintf(path, sizeof path, "%s/case.yaml", dir);
    write_file(path, text, strlen(text));
    status_clear();
    CHECK(case_open(&(case_request){.path = path}, &c) == ERR_INPUT);
    CHECK(strstr(status_message(), ":3:3: error: 'soft' needs its `density_kg_per_m3`") != NULL);
    status_clear();
    case_free(&c);
}

// --- tables in files

static const char with_csv[] = "  tendons: [{path_csv: path.csv}]\n  tensions_N: [[1]]\n";

static void file_is(const char *dir, const char *text, size_t length)
{
    char path[128];
    (void)snprintf(path, sizeof path, "%s/path.csv", dir);
    write_file(path, text, length);
}

static void any_table_of_numbers_is_read(const char *dir)
{
    static const char *const all[] = {
        "s_mm,x_mm,y_mm\n0,3,0\n60,3,1.5\n120,3,0\n",
        "\xef\xbb\xbf# by hand\r\n x_mm ; s_m ; note ; y_um\r\n\r\n3;0;1;0 # base\r\n"
        "3;0.06;1;1500\r\n3;0.12;1;0",
        "s_cm\tx_mm y_mm\n0\t3 0\n6\t3 1.5\n12 3 0\n",
        "s_mm,x_mm,y_mm\r0,3,0\r60,3,1.5\r120,3,0\r",
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        case_data c = {0};
        file_is(dir, all[i], strlen(all[i]));
        CHECK_OK(read_rod(dir, with_csv, &c));
        const tendon_spec *t = c.file.rod.spec;
        CHECK(t && t->table.count == 3);
        if (t && t->table.count == 3) {
            CHECK(t->table.point[1] == 3e-3 && t->table.point[2] == 0);
            CHECK(t->table.point[3] == 0.06 && t->table.point[5] == 1.5e-3);
            CHECK(t->table.point[6] == 0.12);
        }
        case_free(&c);
    }
}

static void damaged_tables_name_their_line(const char *dir)
{
    static const struct {
        const char *text, *words;
    } all[] = {
        {"", "path.csv: it is empty"},
        {"s_mm,x_mm,y_mm\n0,0,0\n", "1 rows: a path takes two or more"},
        {"s_mm,x_mm\n0,0\n1,0\n", "path.csv:1: no column 'y_mm'"},
        {"s_mm,x_mm,y_mm,s_m\n0,1,2,0\n1,2,3,0\n", "path.csv:1: two columns 's'"},
        {"0,1,2\n1,2,3\n", "path.csv:1: numbers without a line of names"},
        {"s_mm,x_mm,y_mm\n", "path.csv: no row of numbers under a line of names"},
        {"s_mm,x_mm,y_mm\n0,0,0\n1,0\n", "path.csv:3: 2 columns, but 3 names"},
        {"s_mm,x_mm,y_mm\n0,0,0\n1,,0\n", "path.csv:3: a path has no gaps, and 'x' is missing"},
        {"s_mm,x_mm,y_mm\n0,0,0\n1,nan,0\n", "path.csv:3: 'nan' is not a number"},
        {"s_mm,x_mm,y_mm\n0,0,0\n1,1e999,0\n", "path.csv:3: '1e999' is not a number"},
        {"s_mm,x_mm,y_mm\n0,0,0\n1,0x10,0\n", "path.csv:3: '0x10' is not a number"},
        {"s_mm,x_mm,y_mm\n0,0,0\n1,=cmd(),0\n", "path.csv:3: '=cmd()' is not a number"},
        {"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\n",
         "path.csv: no row of numbers under a line of names"},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        file_is(dir, all[i].text, strlen(all[i].text));
        fails(dir, ERR_FILE, with_csv, all[i].words);
    }
    file_is(dir, "s_mm,x_mm,y_mm\n0,0\0,0\n", 22);
    fails(dir, ERR_FILE, with_csv, "it is no text");
    file_is(dir, "s_mm,x_mm,y_mm\n0,0,0\n0,1,0\n", 27);
    fails(dir, ERR_INPUT, with_csv, ":6:24: error: row 2 of the tendon's path");
    fails(dir, ERR_FILE, "  tendons: [{path_csv: none.csv}]\n", ":6:24: error: ");
    fails(dir, ERR_FILE, "  tendons: [{path_csv: ..}]\n", "it is a directory");
}

// whatever the bytes: an answer or a message
static void mutilated_tables_never_bring_us_down(const char *dir)
{
    static const char good[] = "s_mm,x_mm,y_mm\n0,3,0\n60,3,1.5\n120,3,0\n";
    unsigned seed = 7;
    for (int i = 0; i < 500; i++) {
        char text[sizeof good];
        memcpy(text, good, sizeof good);
        for (int k = 0; k < 3; k++) {
            seed = 1664525u * seed + 1013904223u;
            text[(seed >> 8) % (sizeof good - 1)] = (char)(seed >> 24);
        }
        file_is(dir, text, sizeof good - 1);
        int nrow = 0;
        double *rows = NULL;
        const key_text name = {"path.csv", {1, 1}};
        const status st = tendon_path_read(dir, &name, &nrow, &rows);
        CHECK(st == OK || (st == ERR_FILE && status_message()[0]));
        for (int k = 0; k < 3 * nrow; k++) {
            CHECK(isfinite(rows[k]));
        }
        status_clear();
        free(rows);
    }
}

int main(void)
{
    char dir[] = "/tmp/stiffaxis-test-XXXXXX", path[128];
    CHECK(mkdtemp(dir) != NULL);
    everything_arrives(dir);
    mistakes_have_their_place(dir);
    gravity_needs_densities(dir);
    any_table_of_numbers_is_read(dir);
    damaged_tables_name_their_line(dir);
    mutilated_tables_never_bring_us_down(dir);
    (void)snprintf(path, sizeof path, "%s/case.yaml", dir);
    (void)unlink(path);
    (void)snprintf(path, sizeof path, "%s/path.csv", dir);
    (void)unlink(path);
    CHECK(rmdir(dir) == 0);
    return test_failures != 0;
}
