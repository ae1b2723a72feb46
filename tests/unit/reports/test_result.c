// tests/unit/reports/test_result.c
#include "reports/result.h"

#include "base/memory.h"
#include "tests/unit/io/scratch.h"

#include <signal.h>
#include <stdint.h>
#include <string.h>
#include <sys/wait.h>

// --- a run that never was, every number another --------------------------------------------------

typedef struct counter {
    double x;
} counter;

static void fill(counter *c, size_t n, void *to)
{
    double *a = to;
    for (size_t i = 0; i < n; i++) {
        c->x += 0.37;
        a[i] = sin(c->x);
    }
}

// moduli, areas: what has to be above 0
static void fill_positive(counter *c, size_t n, double *to)
{
    fill(c, n, to);
    for (size_t i = 0; i < n; i++) {
        to[i] = 2 + to[i];
    }
}

static char *copy_text(const char *text)
{
    char *copy = NULL;
    CHECK_OK(memory_take((void **)&copy, strlen(text) + 1, 1));
    memcpy(copy, text, strlen(text));
    return copy;
}

// a strip of two quads, and the same two layers high
// two squares of two materials on three levels, their nodes apart where they meet
static void make_body(segment_body *b)
{
    static const int quads[2][4] = {{0, 1, 3, 4}, {1, 2, 4, 5}},
                     apart[2][4] = {{0, 1, 3, 4}, {6, 2, 7, 5}};
    CHECK_OK(mesh_make(1, 6, 1, (const shape[]){SHAPE_QUAD}, (const int[]){2}, &b->plane));
    CHECK_OK(mesh_make(1, 8, 1, (const shape[]){SHAPE_QUAD}, (const int[]){2}, &b->apart));
    b->order = 1;
    b->nlayer = 2;
    b->last = b->nlevel = 3;
    CHECK_OK(TAKE(b->level, 3));
    CHECK_OK(TAKE(b->node, 3 * 18));
    CHECK_OK(TAKE(b->matter, 4));
    for (int i = 0; i < 18; i++) {
        const double at[3] = {1e-3 * (i % 3), 1e-3 * (i / 3 % 2), 1e-3 * (i / 6)};
        memcpy(&b->node[3 * i], at, sizeof at);
        b->level[i / 6] = at[2];
        if (i < 6) {
            memcpy(&b->plane.xyz[3 * i], at, sizeof at);
            memcpy(&b->apart.xyz[3 * i], at, sizeof at);
        }
    }
    memcpy(&b->apart.xyz[18], &b->plane.xyz[3], sizeof(double[3]));
    memcpy(&b->apart.xyz[21], &b->plane.xyz[12], sizeof(double[3]));
    for (int e = 0; e < 2; e++) {
        memcpy(b->plane.block[0].conn + 4 * e, quads[e], sizeof quads[e]);
        memcpy(b->apart.block[0].conn + 4 * e, apart[e], sizeof apart[e]);
        b->plane.block[0].material[e] = b->apart.block[0].material[e] = e;
    }
    memcpy(b->matter, (const int[]){0, 1, -1, 1}, sizeof(int[4]));
}

static beam_law some_law(counter *c)
{
    beam_law law = {
        .area = 2e-5, .mass = 0.02, .mass_centre = {2e-4, -1e-4}, .relative_error = 1e-9};
    for (int i = 0; i < 6; i++) {
        c->x += 0.1;
        law.K.a[i][i] = 2 + sin(c->x);
    }
    return law;
}

static void make_section(counter *c, run_result *r)
{
    section_result *s = &r->section;
    r->has_section = true;
    r->section_model = MODEL_CLASSICAL;
    r->symmetry_turn = 0.3;
    s->nstation = 2;
    s->effort.meshed = true;
    s->effort.nsolved = 5;
    CHECK_OK(TAKE(s->station, 2));
    for (int i = 0; i < 2; i++) {
        s->station[i].s = 0.06 * i;
        s->station[i].law = some_law(c);
        fill_positive(c, 1, &s->station[i].centres.EA);
        fill(c, 2, s->station[i].centres.stiffness_centre);
        fill(c, 3, s->station[i].centres.EI_centre);
        fill_positive(c, 2, s->station[i].centres.EI);
        fill(c, 1, &s->station[i].centres.principal_angle);
        fill_positive(c, 1, &s->station[i].centres.GJ);
        fill(c, 2, s->station[i].centres.shear_centre);
    }
    s->station[1].centres.isotropic = true;
    CHECK_OK(law_along_make(0.12, 2, 3, &s->along));
    for (int i = 0; i < 6; i++) {
        s->along.law[i] = some_law(c);
    }
    fill(c, 6, s->along.turn);
    s->along.relative_error = 1e-7;
}

static void make_solution(counter *c, const rod_result *rod, int i)
{
    struct rod_run *run = &rod->run[i];
    fill(c, 2, run->tension);
    fill(c, 2, run->tendon_length);
    fill(c, 1, run->load);
    run->pull[0] = NAN; // its tension was given
    run->pull[1] = 0.002;
    run->tension[1] = i ? 0 : run->tension[1];
    fill(c, 9, run->tip.R.a);
    fill(c, 3, run->tip.p.a);
    fill(c, 1, &run->total_bend_rad);
    fill(c, 1, &run->largest_strain);
    run->iterations = 7 + i;
    run->relative_error = i ? NAN : 1e-12; // an estimate may be missing
    run->fraction = i ? 0.75 : 1;
    run->stable = i ? -1 : 1;
    run->eigenvalue = i ? NAN : 0.5;
    run->energy = i ? NAN : 2;
    run->work = i ? NAN : 1.5;
    run->residual = 1e-13;
    run->ncritical = 2 * i;
    run->critical[0] = (rod_critical){CRITICAL_BIFURCATION, 0.25, 1};
    run->critical[1] = (rod_critical){CRITICAL_LIMIT, 0.75, -1};
}

static void make_shape(counter *c, const rod_result *rod, struct rod_run *run)
{
    CHECK_OK(rod_run_room(rod, run));
    fill(c, 3, run->s);
    fill(c, 9, run->curvature);
    fill(c, 9, run->stretch);
    fill(c, 18, run->wrench);
    fill(c, 6, run->along);
    for (int k = 0; k < 3; k++) {
        fill(c, 9, run->shape[k].R.a);
        fill(c, 3, run->shape[k].p.a);
    }
}

static void make_rates(counter *c, rod_rates *rates)
{
    fill(c, 12, rates->tension);
    fill(c, 12, rates->pull);
    fill(c, 6, rates->load);
    fill(c, 36, rates->space.a);
    fill(c, 36, rates->body.a);
}

static void make_surroundings(counter *c, rod_result *rod)
{
    rod_load_sketch *load = rod->load_sketch;
    fill(c, 2, rod->tendon_end);
    fill(c, 12, rod->tendon_path[0]);
    load->kind = LOAD_ALONG_LINE;
    load->frame = LOAD_BODY;
    fill(c, 1, &load->from);
    fill(c, 1, &load->to);
    fill(c, 3 * LOAD_PLACES, load->force[0].a);
    fill(c, 3 * LOAD_PLACES, load->moment[0].a);
    fill(c, 2 * LOAD_PLACES, load->place[0]);
    fill(c, 3, load->acceleration.a);
    for (int k = 0; k < 3; k++) {
        fill(c, 9, rod->rest[k].R.a);
        fill(c, 3, rod->rest[k].p.a);
    }
}

static void make_rod(counter *c, run_result *r)
{
    rod_result *rod = &r->rod;
    const rod_result sizes = {
        .ntendon = 2, .npoint = 3, .nload = 1, .nsolution = 2, .has_rates = true};
    r->has_rod = true;
    r->rod_length = 0.12;
    CHECK_OK(rod_result_make(&sizes, rod));
    fill(c, 4, rod->tendon_base[0]);
    (void)snprintf(rod->tendon_name[0], sizeof rod->tendon_name[0], "t1");
    (void)snprintf(rod->tendon_name[1], sizeof rod->tendon_name[1], "\"=t2\"");
    (void)snprintf(rod->load_name[0], sizeof rod->load_name[0], "weight");
    make_surroundings(c, rod);
    for (int i = 0; i < 2; i++) {
        make_solution(c, rod, i);
        make_shape(c, rod, &rod->run[i]);
        make_rates(c, &rod->run[i].rates);
    }
}

static void make_segment(counter *c, run_result *r)
{
    segment_result *s = &r->segment;
    r->has_segment = true;
    r->segment_length = 0.02;
    r->segment_section_at = 0.06;
    r->segment_base = BASE_FREE_TO_CONTRACT;
    r->segment_tip = TIP_E_PROPORTIONAL;
    make_body(&s->body);
    s->way = WAY_DIRECT;
    (void)snprintf(s->why, sizeof s->why, "asked for by the case");
    s->rungs = 3;
    s->met = true;
    s->order = s->mesh_used.order = 1;
    s->layers = 2;
    s->mesh_used.size = 1e-3;
    s->mesh_used.edge_layers = 4;
    s->mesh_used.edge_first = 0.01;
    s->iterations = 7;
    s->stiffness_centre_error = 1e-7;
    s->end_length[0] = NAN; // not known
    fill(c, 5, s->end_length + 1);
    fill(c, 3, &s->assemble_seconds);
    s->dofs = 5400000000;
    s->middle = some_law(c);
    fill(c, 2, s->stiffness_centre);
    fill(c, 2, s->tip_centre);
    fill(c, 36, s->tip_compliance.a);
    for (int i = 0; i < 3; i++) { // the last is the result's own
        s->step[i] = (segment_step){6e8 * (i + 1), 0.25 * (i + 1), s->tip_compliance};
        s->step[i].tip_compliance.a[2][2] *= 1 + 0.1 * (2 - i);
    }
    s->relative_error = 0.01;
    s->residual = 1e-13;
    s->nload = 2;
    CHECK_OK(TAKE(s->load, 2));
    for (int i = 0; i < 2; i++) {
        segment_load_result *load = &s->load[i];
        load->name = i ? "@stiffness centre" : "geometric centre"; // the case's own
        fill(c, 2, load->point);
        fill(c, 1, &load->shortening);
        fill(c, 3, load->tip_displacement);
        fill(c, 3, load->force);
        fill(c, 3, load->moment);
        fill(c, 3, load->tip_rotation);
        fill(c, 2, load->mid_curvature);
        fill(c, 1, &load->strain_energy);
        CHECK_OK(TAKE(load->displacement, 3 * 18));
        fill(c, 3 * 18, load->displacement);
        CHECK_OK(TAKE(load->stress, 6 * 24));
        fill(c, 6 * 24, load->stress);
        fill(c, 5, &load->shortening_error);
        load->balance = 1e-12;
        load->nslice = 4;
        CHECK_OK(TAKE(load->slice, 4));
        for (int k = 0; k < 4; k++) {
            fill(c, sizeof(segment_slice) / sizeof(double), &load->slice[k].s);
        }
    }
}

static void make_compare(run_result *r)
{
    r->has_compare = true;
    r->ncompare = 2;
    CHECK_OK(TAKE(r->compare, 2));
    r->compare[0] = (compare_row){.what = "section: GJ, ours against GetDP",
                                  .unit = "N m^2",
                                  .ours = 65e-6,
                                  .other = 65.1e-6,
                                  .difference = 1.5e-3,
                                  .tolerance = 1e-3,
                                  .reason = "mesh"};
    r->compare[1] = (compare_row){.what = "section: EA",
                                  .unit = "N",
                                  .ours = 29,
                                  .other = NAN,
                                  .difference = NAN,
                                  .reason = "GetDP is not here",
                                  .skipped = true};
}

static run_result make_run(void)
{
    counter c = {0};
    run_result r = {
        .title = "a run that never was", .versions = "hdf5 1.10.8\ngmsh 4.8.4", .nmaterial = 2};
    r.case_text = copy_text("format: 1\n");
    r.case_length = strlen(r.case_text);
    CHECK_OK(TAKE(r.materials, 2));
    r.materials[0] =
        (material){.name = copy_text("soft"), .E = 0.66e6, .nu = 0.3, .linear_strain = 0.05};
    r.materials[1] = (material){.name = copy_text("stiff"),
                                .E = 15.93e6,
                                .nu = 0.45,
                                .density = 1100,
                                .kind = MATERIAL_ORTHOTROPIC,
                                .G13 = 3e6,
                                .nu23 = -0.2,
                                .fibre_angle = 0.5,
                                .in_frame = {{{2e7, 3e6}, {3e6, 5e6}}},
                                .modulus = {.along = true}};
    make_section(&c, &r);
    CHECK_OK(
        mesh_make(1, 3, 1, (const shape[]){SHAPE_TRIANGLE}, (const int[]){1}, &r.section_mesh));
    memcpy(r.section_mesh.block[0].conn, (const int[]){0, 1, 2}, 3 * sizeof(int));
    memcpy(r.section_mesh.xyz, (const double[]){0, 0, 0, 1, 0, 0, 0, 1, 0}, 9 * sizeof(double));
    make_rod(&c, &r);
    make_segment(&c, &r);
    make_compare(&r);
    return r;
}

// --- JSON ----------------------------------------------------------------------------------------

static char *json_of(status (*write)(json *, const char *, const run_result *), const run_result *r)
{
    char *text = NULL;
    size_t size = 0;
    json *j = NULL;
    FILE *stream = open_memstream(&text, &size);
    CHECK_OK(json_open(stream, &j));
    CHECK_OK(write ? write(j, NULL, r) : result_json_run(j, r));
    CHECK_OK(json_close(j)); // refuses an unbalanced document
    (void)fclose(stream);
    return text;
}

static void check_keys(const char *text, const char *const *keys)
{
    for (; *keys; keys++) {
        char quoted[96];
        (void)snprintf(quoted, sizeof quoted, "\"%s\":", *keys);
        const bool found = strstr(text, quoted) != NULL;
        CHECK(found);
        if (!found) {
            printf("no key %s\n", *keys);
        }
    }
}

static void documents_have_the_keys_of_the_contract(void)
{
    static const char *const section[] = {"schema",
                                          "stations",
                                          "s_m",
                                          "area_m2",
                                          "EA_N",
                                          "stiffness_centre_m",
                                          "principal_angle_rad",
                                          "EI_Nm2",
                                          "EI_centre_Nm2",
                                          "GJ_Nm2",
                                          "shear_centre_m",
                                          "K",
                                          "relative_error",
                                          NULL};
    static const char *const rod[] = {"schema",
                                      "solutions",
                                      "tensions_N",
                                      "tip_position_m",
                                      "tip_rotation",
                                      "tendon_length_m",
                                      "iterations",
                                      "stable",
                                      "relative_error",
                                      "shape",
                                      "s_m",
                                      "p_m",
                                      "curvature_per_m",
                                      "largest_strain",
                                      "pulls_m",
                                      "slack",
                                      "load_factors",
                                      "fraction",
                                      "eigenvalue",
                                      "critical_points",
                                      "kind",
                                      "negative_directions",
                                      "energy_J",
                                      "work_J",
                                      "energy_misfit",
                                      "residual",
                                      "tip_derivatives",
                                      "by_tension_per_N",
                                      "by_pull_per_m",
                                      "by_load_factor",
                                      "compliance_space",
                                      "compliance_body",
                                      "strain",
                                      "force_N",
                                      "moment_Nm",
                                      "tension_N",
                                      "loads",
                                      NULL};
    static const char *const fem[] = {"schema",
                                      "dofs",
                                      "K",
                                      "stiffness_centre_m",
                                      "loads",
                                      "name",
                                      "shortening_m",
                                      "tip_rotation_rad",
                                      "mid_curvature_per_m",
                                      "strain_energy_J",
                                      "residual",
                                      "relative_error",
                                      "tip_compliance",
                                      "way",
                                      "why",
                                      "rungs",
                                      "ladder",
                                      "tolerance_met",
                                      "end_length_m",
                                      "slices",
                                      "motion",
                                      "resultant",
                                      "load",
                                      "strain",
                                      "balance",
                                      "shortening_error_m",
                                      "tip_rotation_error_rad",
                                      "strain_energy_error_J",
                                      NULL};
    static const char *const compare[] = {"schema",
                                          "rows",
                                          "what",
                                          "unit",
                                          "ours",
                                          "other",
                                          "difference_relative",
                                          "tolerance_relative",
                                          "reason",
                                          "skipped",
                                          "ok",
                                          NULL};
    static const char *const run[] = {"schema", "section", "rod", "fem", "compare", NULL};
    const struct {
        status (*write)(json *, const char *, const run_result *);
        const char *schema;
        const char *const *keys;
    } documents[] = {
        {result_json_section, "\"stiffaxis/section/1\"", section},
        {result_json_rod, "\"stiffaxis/rod/1\"", rod},
        {result_json_segment, "\"stiffaxis/fem/1\"", fem},
        {result_json_compare, "\"stiffaxis/compare/1\"", compare},
        {NULL, "\"stiffaxis/run/1\"", run},
    };
    run_result r = make_run();
    for (size_t i = 0; i < sizeof documents / sizeof *documents; i++) {
        char *text = json_of(documents[i].write, &r);
        const char *first = strstr(text, "\"schema\"");
        CHECK(first && strstr(first, documents[i].schema) &&
              strstr(first, documents[i].schema) < first + 16);
        check_keys(text, documents[i].keys);
        free(text);
    }
    run_result_free(&r);
}

// a verdict is bad when a row that was not skipped is
static void the_verdict_is_that_of_the_rows(void)
{
    run_result r = make_run();
    char *text = json_of(result_json_compare, &r);
    CHECK(strstr(text, "\"ok\": true") == NULL);
    free(text);
    r.compare[0].ok = true;
    text = json_of(result_json_compare, &r);
    const char *last = strrchr(text, ':');
    CHECK(last && strncmp(last, ": true", 6) == 0); // that of the whole comes last
    free(text);
    run_result_free(&r);
}

// --- the store -----------------------------------------------------------------------------------

static bool same_mesh(const mesh *a, const mesh *b)
{
    bool same =
        a->dim == b->dim && a->order == b->order && a->nnode == b->nnode &&
        a->nblock == b->nblock &&
        (a->nnode == 0 || memcmp(a->xyz, b->xyz, 3 * (size_t)a->nnode * sizeof *a->xyz) == 0);
    for (int k = 0; same && k < a->nblock; k++) {
        const mesh_block *p = &a->block[k], *q = &b->block[k];
        const size_t n = (size_t)p->nelem;
        same = p->shape == q->shape && p->nelem == q->nelem && p->per_elem == q->per_elem &&
               memcmp(p->conn, q->conn, n * (size_t)p->per_elem * sizeof *p->conn) == 0 &&
               memcmp(p->material, q->material, n * sizeof *p->material) == 0;
    }
    return same;
}

// what was given, what was found, and what nobody can know
static void a_rod_tells_slack_stability_and_balance(void)
{
    run_result r = make_run();
    CHECK(!result_is_slack(&r.rod.run[0], 0) && !result_is_slack(&r.rod.run[0], 1));
    CHECK(!result_is_slack(&r.rod.run[1], 0) && result_is_slack(&r.rod.run[1], 1));
    CHECK_NEAR(result_energy_misfit(&r.rod.run[0]), 0.25, 1e-15);
    CHECK(isnan(result_energy_misfit(&r.rod.run[1])));
    CHECK(result_energy_misfit(&(struct rod_run){0}) == 0);

    char *text = json_of(result_json_rod, &r);
    CHECK(strstr(text, "\"stable\": true") && strstr(text, "\"stable\": null"));
    CHECK(strstr(text, "\"kind\": \"limit_point\"") && strstr(text, "\"kind\": \"bifurcation\""));
    CHECK(strstr(text, "\"negative_directions\": null") && strstr(text, "\"energy_J\": null"));
    CHECK(strstr(text, "\"pulls_m\": [null, 0.002]"));
    free(text);
    run_result_free(&r);
}

// documents and tables hold nearly everything: the rest is looked at one by one
static void the_store_gives_back_all_of_a_run(const scratch *dir)
{
    const scratch_path path = scratch_file(dir, "result.hdf");
    run_result r = make_run(), back = {0};
    CHECK_OK(result_store_write(&r, path.text));
    CHECK_OK(result_store_read(path.text, &back));
    char *before = json_of(NULL, &r), *after = json_of(NULL, &back);
    CHECK(strcmp(before, after) == 0);
    free(before);
    free(after);

    CHECK(back.case_length == r.case_length && strcmp(back.case_text, r.case_text) == 0);
    CHECK(strcmp(back.versions, r.versions) == 0);
    CHECK(back.nmaterial == 2 && strcmp(back.materials[1].name, "stiff") == 0);
    CHECK(back.materials[0].E == 0.66e6 && back.materials[1].nu == 0.45);
    CHECK(back.materials[0].linear_strain == 0.05 && back.materials[0].kind == MATERIAL_ISOTROPIC);
    const material *kept = &back.materials[1];
    CHECK(kept->kind == MATERIAL_ORTHOTROPIC && kept->density == 1100 && kept->G13 == 3e6);
    CHECK(kept->nu23 == -0.2 && kept->fibre_angle == 0.5 && kept->in_frame.a[1][0] == 3e6);
    CHECK(kept->modulus.along && !kept->modulus.across);
    CHECK(back.symmetry_turn == 0.3 && back.section.effort.meshed);
    CHECK(same_mesh(&back.section_mesh, &r.section_mesh));
    const segment_body *kept_body = &back.segment.body, *body = &r.segment.body;
    CHECK(same_mesh(&kept_body->plane, &body->plane) && same_mesh(&kept_body->apart, &body->apart));
    CHECK(kept_body->order == 1 && kept_body->nlayer == 2 && kept_body->nlevel == 3);
    CHECK(kept_body->first == 0 && kept_body->last == 3);
    CHECK(memcmp(kept_body->level, body->level, sizeof(double[3])) == 0);
    CHECK(memcmp(kept_body->node, body->node, sizeof(double[3 * 18])) == 0);
    CHECK(memcmp(kept_body->matter, body->matter, sizeof(int[4])) == 0);
    for (int i = 0; i < 2; i++) {
        CHECK(memcmp(back.segment.load[i].displacement, r.segment.load[i].displacement,
                     sizeof(double[3 * 18])) == 0);
        CHECK(memcmp(back.segment.load[i].stress, r.segment.load[i].stress,
                     sizeof(double[6 * 24])) == 0);
        CHECK(memcmp(back.segment.load[i].slice, r.segment.load[i].slice,
                     sizeof(segment_slice[4])) == 0);
        CHECK(memcmp(back.rod.run[i].shape, r.rod.run[i].shape, 3 * sizeof(pose)) == 0);
    }
    CHECK(memcmp(back.segment.step, r.segment.step, 3 * sizeof(segment_step)) == 0);
    CHECK(memcmp(back.rod.load_sketch, r.rod.load_sketch, sizeof *r.rod.load_sketch) == 0);
    CHECK(memcmp(back.rod.tendon_end, r.rod.tendon_end, sizeof(double[2])) == 0);
    CHECK(memcmp(back.rod.tendon_path, r.rod.tendon_path, sizeof(double[12])) == 0);
    CHECK(memcmp(back.rod.rest, r.rod.rest, 3 * sizeof(pose)) == 0);
    const law_along *a = &back.section.along, *b = &r.section.along;
    CHECK(a->length == b->length && a->npanel == b->npanel && a->nnode == b->nnode);
    CHECK(memcmp(a->edge, b->edge, 3 * sizeof *a->edge) == 0);
    CHECK(memcmp(a->law, b->law, 6 * sizeof *a->law) == 0);
    CHECK(memcmp(a->turn, b->turn, 6 * sizeof *a->turn) == 0);
    run_result_free(&back);
    run_result_free(&r);
}

static void parts_that_are_not_there_stay_away(const scratch *dir)
{
    const scratch_path path = scratch_file(dir, "part.hdf");
    run_result r = {.title = "nothing"}, back = {0};
    store *s = NULL;
    r.case_text = copy_text("");
    CHECK_OK(result_store_write(&r, path.text));
    CHECK_OK(result_store_read(path.text, &back));
    CHECK(!back.has_section && !back.has_rod && !back.has_segment && !back.has_compare);
    CHECK(strcmp(back.title, "nothing") == 0 && back.case_length == 0);
    CHECK_OK(store_open(path.text, &s));
    CHECK(!store_has(s, "VTKHDF") && !store_has(s, "rod"));
    store_close(s);
    run_result_free(&back);
    run_result_free(&r);
}

// --- files of others -----------------------------------------------------------------------------

static status write_broken(run_result *r, const char *path)
{
    run_result back = {0};
    CHECK_OK(result_store_write(r, path));
    const status st = result_store_read(path, &back);
    CHECK(back.materials == NULL);
    CHECK(strstr(status_message(), path) && strstr(status_message(), "damaged"));
    status_clear();
    return st;
}

// what is well-formed but wrong would send the pictures out of bounds
static void a_file_that_lies_is_refused(const scratch *dir)
{
    const scratch_path path = scratch_file(dir, "lies.hdf");
    run_result r = make_run();
    int *conn = r.segment.body.plane.block[0].conn, *apart = r.segment.body.apart.block[0].conn;
    const int nload = r.segment.nload;
    r.segment.nload = 0; // the writer puts their fields on such nodes
    conn[3] = 6;
    CHECK(write_broken(&r, path.text) == ERR_FILE);
    conn[3] = -1;
    CHECK(write_broken(&r, path.text) == ERR_FILE);
    conn[3] = 4;
    r.segment.nload = nload;
    apart[4] = 0; // a copy of two nodes
    CHECK(write_broken(&r, path.text) == ERR_FILE);
    apart[4] = 6;
    r.segment.body.level[1] = 3e-3; // levels go up
    CHECK(write_broken(&r, path.text) == ERR_FILE);
    r.segment.body.level[1] = 1e-3;
    r.segment.body.matter[2] = 2;
    CHECK(write_broken(&r, path.text) == ERR_FILE);
    r.segment.body.matter[2] = -1;
    r.section_mesh.block[0].material[0] = 2;
    CHECK(write_broken(&r, path.text) == ERR_FILE);
    r.section_mesh.block[0].material[0] = 0;
    r.segment_tip = 4;
    CHECK(write_broken(&r, path.text) == ERR_FILE);
    r.segment_tip = TIP_RIGID;
    r.section_model = -1;
    CHECK(write_broken(&r, path.text) == ERR_FILE);
    r.section_model = MODEL_FULL;
    r.section.along.edge[1] = 0.2; // beyond the length
    CHECK(write_broken(&r, path.text) == ERR_FILE);
    r.section.along.edge[1] = 0.06;
    r.section.along.law[2].K.a[3][3] = -1;
    CHECK(write_broken(&r, path.text) == ERR_FILE);
    r.section.along.law[2].K.a[3][3] = 1;
    r.rod.run[1].s[2] = INFINITY;
    CHECK(write_broken(&r, path.text) == ERR_FILE);
    r.rod.run[1].s[2] = 0.12;

    run_result back = {0};
    CHECK_OK(result_store_write(&r, path.text)); // all is well again
    CHECK_OK(result_store_read(path.text, &back));
    run_result_free(&back);
    run_result_free(&r);
}

// with one number wrong the file is refused by that number's name; else the pictures run away
static void numbers_beyond_reason_are_refused(const scratch *dir)
{
    const scratch_path path = scratch_file(dir, "numbers.hdf");
    run_result r = make_run();
    const struct {
        double *number, value;
        const char *name;
    } wrong[] = {
        {&r.segment.load[0].displacement[5], 1e160, "fem/load/0/displacement_m"},
        {&r.segment.load[1].displacement[0], -2e9, "fem/load/1/displacement_m"},
        {&r.segment.load[0].point[1], 1e308, "fem/load/point_m"},
        {&r.segment.stiffness_centre[0], 1e308, "fem/stiffness_centre_m"},
        {&r.segment.body.node[4], 1e308, "fem/node_m"},
        {&r.segment.body.plane.xyz[3], -1e308, "fem/plane/node_m"},
        {&r.segment.load[0].stress[7], 1e160, "fem/load/0/stress_Pa"},
        {&r.segment.load[1].slice[2].strain.a[4], 1e308, "fem/load/1/slice/strain"},
        {&r.segment_length, 1e308, "fem/length_m"},
        {&r.segment_length, 0, "fem/length_m"},
        {&r.section_mesh.xyz[3], 1e308, "section/mesh/node_m"},
        {&r.section_mesh.xyz[3], 0, "section/mesh/node_m"}, // all on one line
        {&r.section.station[0].centres.stiffness_centre[0], 1e308, "section/stiffness_centre_m"},
        {&r.section.station[1].centres.EA, 0, "section/EA_N"},
        {&r.section.station[1].centres.EA, 1e308, "section/EA_N"},
        {&r.section.station[0].law.K.a[2][2], 1e308, "section/K"},
        {&r.rod.run[0].shape[1].p.a[2], 1e308, "rod/shape/0/p_m"},
        {&r.rod.run[1].curvature[1][0], -1e308, "rod/shape/1/curvature_per_m"},
        {&r.rod.run[0].wrench[2].a[5], 1e308, "rod/shape/0/wrench"},
        {&r.rod.run[1].tension[1], 1e308, "rod/tension_N"},
        {&r.rod.run[1].rates.pull[1].a[5], 1e308, "rod/tip_by_pull"},
        {&r.rod_length, 1e308, "rod/length_m"},
        {&r.rod_length, 0, "rod/length_m"},
        {&r.rod_length, -0.1, "rod/length_m"},
        {&r.materials[1].E, 0, "material/E_Pa"},
        {&r.materials[0].E, 1e308, "material/E_Pa"},
        {&r.compare[0].ours, NAN, "compare/ours"},
        {&r.compare[1].ours, INFINITY, "compare/ours"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        run_result back = {0};
        char quoted[64];
        const double kept = *wrong[i].number;
        *wrong[i].number = wrong[i].value;
        CHECK_OK(result_store_write(&r, path.text));
        *wrong[i].number = kept;
        (void)snprintf(quoted, sizeof quoted, "damaged: '%s'", wrong[i].name);
        const bool refused = result_store_read(path.text, &back) == ERR_FILE &&
                             strstr(status_message(), quoted) != NULL;
        CHECK(refused);
        if (!refused) {
            printf("%s = %g: %s\n", wrong[i].name, wrong[i].value, status_message());
        }
        status_clear();
        run_result_free(&back);
    }
    run_result_free(&r);
}

static void damaged_files_never_bring_us_down(const scratch *dir)
{
    enum { TRIALS = 60 };
    const scratch_path good = scratch_file(dir, "good.hdf"), bad = scratch_file(dir, "bad.hdf");
    run_result r = make_run();
    uint64_t state = 1;
    size_t size = 0;
    int refused = 0;
    CHECK_OK(result_store_write(&r, good.text));
    char *bytes = read_whole(good.text, &size);
    for (int i = 0; bytes && i < TRIALS; i++) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        const size_t at = (size_t)(state >> 33) % size;
        const char kept = bytes[at];
        run_result back = {0};
        bytes[at] = (char)(bytes[at] ^ (1 << (i % 8)));
        write_whole(bad.text, bytes, i % 4 ? size : at);
        bytes[at] = kept;
        const status st = result_store_read(bad.text, &back);
        CHECK(st == OK || (st == ERR_FILE && status_message()[0]));
        refused += st == ERR_FILE;
        status_clear();
        run_result_free(&back);
    }
    CHECK(refused >= TRIALS / 4); // those that were cut off
    free(bytes);
    run_result_free(&r);
}

static void a_killed_run_leaves_no_file(const scratch *dir)
{
    const scratch_path path = scratch_file(dir, "killed.hdf");
    const pid_t child = fork();
    if (child == 0) {
        store *s = NULL;
        const double x = 1;
        (void)store_create(path.text, &s);
        (void)store_real(s, "section/s_m", 0, NULL, &x, "m");
        (void)raise(SIGKILL);
    }
    int how = 0;
    CHECK(waitpid(child, &how, 0) == child && WIFSIGNALED(how));
    CHECK(!exists(path.text));
}

// --- tables --------------------------------------------------------------------------------------

static void check_table(const scratch *dir, const char *name, int nline, const char *start)
{
    size_t size = 0;
    int n = 0;
    char *text = read_whole(scratch_file(dir, name).text, &size);
    CHECK(text && strncmp(text, start, strlen(start)) == 0);
    for (const char *p = text; p && (p = strstr(p, "\r\n")) != NULL; p += 2) {
        n++;
    }
    CHECK(n == nline);
    free(text);
}

static void tables_have_a_line_per_thing(const scratch *dir)
{
    run_result r = make_run();
    CHECK_OK(result_csv(&r, dir->path));
    check_table(dir, "sections.csv", 3, "s_m,area_m2,EA_N,stiffness_centre_x_m,");
    check_table(dir, "rods.csv", 3,
                "solution_count,tension_1_t1_N,\"tension_2_\"\"=t2\"\"_N\",tip_x_m,");
    check_table(dir, "shapes.csv", 7, "solution_count,s_m,x_m,y_m,z_m,curvature_x_per_m,");
    check_table(dir, "segment.csv", 3, "load,point_x_m,point_y_m,force_x_N,");
    check_table(dir, "segment_slices.csv", 9, "load_count,load,s_m,displacement_x_m,");
    check_table(dir, "compare.csv", 3, "what,unit,ours_in_unit,other_in_unit,difference_ratio,");

    size_t size = 0;
    char *text = read_whole(scratch_file(dir, "segment.csv").text, &size);
    CHECK(text && strstr(text, "\r\n'@stiffness centre,")); // no formula
    free(text);
    run_result_free(&r);
}

int main(void)
{
    const scratch dir = scratch_make();
    documents_have_the_keys_of_the_contract();
    the_verdict_is_that_of_the_rows();
    a_rod_tells_slack_stability_and_balance();
    the_store_gives_back_all_of_a_run(&dir);
    parts_that_are_not_there_stay_away(&dir);
    a_file_that_lies_is_refused(&dir);
    numbers_beyond_reason_are_refused(&dir);
    damaged_files_never_bring_us_down(&dir);
    a_killed_run_leaves_no_file(&dir);
    tables_have_a_line_per_thing(&dir);
    scratch_remove(&dir);
    return test_failures != 0;
}
