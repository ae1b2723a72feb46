// tests/unit/reports/test_answers.c
// A section's answers in the store, in JSON, in tables, on the page and in a picture.
#include "base/memory.h"
#include "reports/figures.h"
#include "reports/result.h"
#include "tests/test.h"
#include "tests/unit/reports/files.h"

static const material two[2] = {
    {.name = "soft", .E = 0.66e6, .nu = 0.3, .density = 1100, .linear_strain = 0.05},
    {.name = "<stiff>", .E = 15.93e6, .nu = 0.3, .density = 1200, .linear_strain = 0.05}};

static status copy_materials(run_result *r)
{
    status st = OK;
    TRY(TAKE(r->materials, 2));
    r->nmaterial = 2;
    for (int i = 0; i < 2; i++) {
        char *name = NULL;
        r->materials[i] = two[i];
        r->materials[i].name = NULL;
        TRY(TAKE(name, strlen(two[i].name) + 1));
        memcpy(name, two[i].name, strlen(two[i].name));
        r->materials[i].name = name;
    }

done:
    return st;
}

static status add_rod(run_result *r)
{
    status st = OK;
    const section_strain_place strain[2] = {{-0.12, 0.03, {4e-3, 1e-3}}, {0.02, 0, {-4e-3, 0}}};
    r->has_rod = true;
    r->rod_length = 0.12;
    TRY(rod_result_make(&(rod_result){.npoint = 2, .nsolution = 1}, &r->rod));
    struct rod_run *run = &r->rod.run[0];
    run->largest_strain = 0.12;
    TRY(rod_run_room(&r->rod, run));
    TRY(TAKE(run->strain, 2));
    memcpy(run->strain, strain, sizeof strain);

done:
    return st;
}

// the prototype's section under two wrenches, solved
static status make(run_result *r)
{
    status st = OK;
    const ring_spec ring = {.at = {1, 1},
                            .outer_radius = field_constant(4e-3),
                            .inner_radius = field_constant(3.2e-3),
                            .mid_angle = field_constant(3),
                            .width = field_constant(0.4)};
    shape_spec shapes[2] = {{.at = {1, 1}, .annulus = ring},
                            {.at = {2, 1}, .sector = ring, .material_index = 1}};
    section_wrench wrenches[2] = {
        {.name = "pull & \"more\"", .force = {0, 0, 1}, .at_kind = WRENCH_AT_STIFFNESS_CENTRE},
        {.name = "twist", .moment = {0, 0, 2e-3}, .at_kind = -1}};
    section_case c = section_case_default();
    c.shapes = (key_list){.count = 2, .items = shapes};
    c.wrenches = (key_list){.count = 2, .items = wrenches};
    c.mesh.order = 2;
    c.nmaterial = 2;
    const section_question question = {&c, two, true};
    TRY(section_along(&c, two, 0.1, &r->section));
    r->has_section = true;
    TRY(copy_materials(r));
    TRY(section_mesh_at(&c, 0, &r->section_mesh));
    TRY(TAKE(r->answer, 1));
    r->nanswer = 1;
    TRY(section_answer(&question, &r->section.station[0], 0, &r->answer[0]));
    TRY(TAKE(r->point, 1));
    r->npoint = 1;
    r->point[0][1] = 2e-3;
    TRY(TAKE(r->case_text, 1));
    TRY(add_rod(r));

done:
    return st;
}

static bool same(size_t n, const void *a, const void *b)
{
    return memcmp(a, b, n) == 0;
}

static void check_load(int nnode, const section_load_answer *a, const section_load_answer *b)
{
    CHECK(strcmp(a->name, b->name) == 0);
    CHECK(same(sizeof a->at, a->at, b->at) && same(sizeof a->force, a->force, b->force));
    CHECK(same(sizeof a->moment, a->moment, b->moment));
    for (int i = 0; i < 2; i++) {
        CHECK(b->extreme[i].used);
        CHECK(a->extreme[i].strain.value == b->extreme[i].strain.value);
        CHECK(a->extreme[i].von_mises.at[1] == b->extreme[i].von_mises.at[1]);
        CHECK(a->extreme[i].axial_lowest.value == b->extreme[i].axial_lowest.value);
    }
    CHECK(same((size_t)nnode * sizeof *a->strain, a->strain, b->strain));
    CHECK(same((size_t)nnode * sizeof *a->stress, a->stress, b->stress));
}

static void the_store_gives_it_all_back(const run_result *r, const char *dir)
{
    char path[128];
    run_result back = {0};
    (void)snprintf(path, sizeof path, "%s/result.hdf", dir);
    CHECK_OK(result_store_write(r, path));
    CHECK_OK(result_store_read(path, &back));
    CHECK(same(sizeof(mat6), &r->section.station[0].law.entry_error,
               &back.section.station[0].law.entry_error));
    CHECK(back.nanswer == 1 && back.npoint == 1 && back.point[0][1] == 2e-3);
    if (back.nanswer == 1) {
        const section_answers *a = &r->answer[0], *b = &back.answer[0];
        CHECK(same(sizeof a->mass.matrix, &a->mass.matrix, &b->mass.matrix) && b->mass.known);
        CHECK(a->EI_warping == b->EI_warping && a->nkern == b->nkern);
        CHECK(same((size_t)a->nkern * sizeof *a->kern, a->kern, b->kern));
        CHECK(b->nload == 2 && a->nodes.nnode == b->nodes.nnode);
        for (int i = 0; i < b->nload; i++) {
            check_load(a->nodes.nnode, &a->load[i], &b->load[i]);
        }
    }
    CHECK(back.rod.run[0].strain && back.rod.run[0].strain[0].at[0] == 4e-3);
    run_result_free(&back);
}

static char *document_of(const run_result *r)
{
    char *text = NULL;
    size_t size = 0;
    json *j = NULL;
    FILE *stream = open_memstream(&text, &size);
    CHECK_OK(json_open(stream, &j));
    CHECK_OK(result_json_run(j, r));
    CHECK_OK(json_close(j));
    (void)fclose(stream);
    return text;
}

static void documents_have_the_keys(run_result *r)
{
    static const char *const keys[] = {
        "geometric_centre_m", "mass_centre_m",       "mass_kg_per_m",  "mass_matrix",
        "shear_stiffness_N",  "shear_angle_rad",     "EI_warping_Nm4", "kern_m",
        "K_principal",        "turn_rate_rad_per_m", "points",         "wrenches",
        "K_relative_error",   "von_mises_Pa",        "largest_strain", "linear_strain"};
    char *text = document_of(r);
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        CHECK(strstr(text, keys[i]));
    }
    CHECK(!strstr(text, "\"mass_matrix\": null") && strstr(text, "\"pull & \\\"more\\\"\""));
    free(text);
    r->answer[0].mass.known = false; // as where one density is missing
    text = document_of(r);
    CHECK(strstr(text, "\"mass_matrix\": null") && strstr(text, "\"mass_kg_per_m\": null"));
    free(text);
    r->answer[0].mass.known = true;
}

static int lines_of(const char *dir, const char *name)
{
    size_t length = 0;
    int lines = 0;
    char *text = whole_file(dir, name, &length);
    for (size_t i = 0; text && i < length; i++) {
        lines += text[i] == '\n';
    }
    free(text);
    return lines;
}

static void tables_figure_and_page(const run_result *r, const char *dir)
{
    size_t length = 0;
    CHECK_OK(result_csv(r, dir));
    CHECK(lines_of(dir, "sections.csv") == 2);
    CHECK(lines_of(dir, "stresses.csv") == 1 + 2 * 2);
    CHECK(lines_of(dir, "kern.csv") == 1 + r->answer[0].nkern);
    CHECK_OK(figures_all(r, dir));
    CHECK_OK(report_page(r, dir));
    char *page = whole_file(dir, "report.html", &length);
    CHECK(page && strstr(page, "warping constant") && strstr(page, "pull &amp; "));
    CHECK(page && !strstr(page, "<stiff>"));
    CHECK(page && strstr(page, "Strain and stress under wrenches"));
    CHECK(lines_of(dir, "stresses.svg") > 1);
    free(page);
}

static void the_material_past_its_own_limit_is_named(run_result *r)
{
    struct rod_run *run = &r->rod.run[0];
    CHECK(result_beyond_linear(r, run) == 0);
    r->materials[0].linear_strain = 0.2;
    CHECK(result_beyond_linear(r, run) == -1);
    r->materials[1].linear_strain = 0.01;
    CHECK(result_beyond_linear(r, run) == 1);
    int whose = -1;
    CHECK_NEAR(result_strain_share(r, run, &whose), fabs(run->strain[1].value) / 0.01, 1e-12);
    CHECK(whose == 1);
    r->materials[0].linear_strain = r->materials[1].linear_strain = 0;
    CHECK(isnan(result_strain_share(r, run, &whose)) && whose == -1);
}

int main(void)
{
    char dir[64];
    run_result r = {0};
    scratch_make(dir);
    CHECK_OK(make(&r));
    if (test_failures == 0) {
        the_store_gives_it_all_back(&r, dir);
        documents_have_the_keys(&r);
        tables_figure_and_page(&r, dir);
        the_material_past_its_own_limit_is_named(&r);
    }
    run_result_free(&r);
    scratch_free(dir);
    return test_failures != 0;
}
