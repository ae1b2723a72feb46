#include "tests/dxf.h"
#include "tests/fuzz/mutate.h"
#include "tests/test.h"

static status outline_of(const dxf_paper *p, const key_list *parts, int unit, section_outline *o)
{
    drawing *d = NULL;
    bool found = false;
    status st = dxf_open_text(p->text, p->count, parts, unit, &d);
    if (st == OK) {
        st = drawing_outline(d, o, &found);
        CHECK(found);
    }
    drawing_free(d);
    return st;
}

static status mesh_of_paper(const dxf_paper *p, mesh *out)
{
    drawing *d = NULL;
    const mesh_options options = {.kind = MESH_AUTO, .order = 4};
    status st = dxf_open_text(p->text, p->count, NULL, 0, &d);
    st = st == OK ? drawing_mesh(d, 0, &options, out) : st;
    drawing_free(d);
    return st;
}

static void every_kind_of_curve_has_its_area(void)
{
    static dxf_paper p;
    mesh m = {0};
    dxf_all_kinds(&p);
    CHECK_OK(mesh_of_paper(&p, &m));
    CHECK(mesh_is_conforming(&m));
    const double mm2 = 1e-6;
    const double slot = 3 * 2 + PI, ellipse = PI * 1.5 * 1.5 * 0.4;
    // a quarter of a circle of radius 2 bulges out of the corner at (8, 2)
    const double rounded = 6 * 2 - 4 + PI;
    // the lens: under the parabola two thirds of its box, and the cubic's int y dx
    double lens = 2.0 / 3 * 4 * 1, t[8], w[8];
    gauss_legendre(8, t, w);
    for (int q = 0; q < 8; q++) {
        const double v = (1 + t[q]) / 2, u = 1 - v;
        const double depth = 6 * (u * u * v + u * v * v), dx = 3 * (u * u + 4 * u * v + v * v);
        lens += w[q] / 2 * depth * dx;
    }
    const moments stiff = mesh_moments(&m, 1);
    const double wanted = rounded + lens;
    CHECK_NEAR(stiff.a[0], wanted * mm2, 1e-9);
    CHECK_NEAR(mesh_moments(&m, 0).a[0], (240 - slot - ellipse - wanted) * mm2, 1e-9);
    mesh_free(&m);
}

// the same section drawn with shapes; also where the file has only six digits
static void the_drawn_tube_is_the_tube_of_shapes(void)
{
    const shape_spec s[] = {an_annulus(4e-3, 3.2e-3, 0), a_sector(4e-3, 3.2e-3, PI, PI / 8, 1)};
    static dxf_paper p;
    mesh m = {0}, wanted = {0};
    CHECK_OK(mesh_of(2, s, MESH_AUTO, 4, 0, &wanted));
    for (int digits = 15; digits >= 6; digits -= 9) {
        dxf_tube(&p, digits);
        CHECK_OK(mesh_of_paper(&p, &m));
        for (int k = 0; k < 2; k++) {
            const moments a = mesh_moments(&m, k), b = mesh_moments(&wanted, k);
            for (int i = 0; i < 5; i++) {
                const double unit = i == 0 ? b.a[0] : i < 3 ? b.a[0] * 4e-3 : b.a[0] * 16e-6;
                CHECK_WITHIN(a.a[i], b.a[i], (digits == 15 ? 1e-9 : 3e-7) * unit);
            }
        }
        mesh_free(&m);
    }
    mesh_free(&wanted);
}

static void layers_lie_on_one_another_by_size(void)
{
    static dxf_paper p;
    section_outline o = {0};
    dxf_begin(&p);
    dxf_put(&p, "0 CIRCLE 8 none 10 1 20 0 40 0.3 0 CIRCLE 8 stiff 10 1 20 0 40 0.5");
    dxf_put(&p, "0 CIRCLE 8 soft 10 0 20 0 40 4 0 CIRCLE 8 soft 10 0 20 0 40 3");
    dxf_put(&p, "0 CIRCLE 8 soft 10 0 20 0 40 2");
    dxf_end(&p);
    CHECK_OK(outline_of(&p, NULL, 0, &o));
    CHECK(o.count == 4);
    CHECK(section_top_shape(&o, 0, 3.5e-3) == 0 && o.items[0].material == 0);
    CHECK(section_top_shape(&o, 0, 2.5e-3) == -1); // a hole of the layer
    CHECK(section_top_shape(&o, 0, 1.5e-3) == 1 && o.items[1].material == 0);
    CHECK(section_top_shape(&o, 1.4e-3, 0) == 2 && o.items[2].material == 1);
    CHECK(section_top_shape(&o, 1e-3, 0) == 3 && o.items[3].material == -1);
    CHECK_NEAR(o.size, 4e-3, 1e-12);
    section_outline_free(&o);
}

static void units_come_from_the_file_or_the_case(void)
{
    static dxf_paper p;
    const struct {
        const char *code;
        int unit;
        double size;
    } trials[] = {{"4", 0, 2e-3}, {"1", 0, 2 * 25.4e-3}, {"0", 0, 2e-3},
                  {"6", 1, 2e-3}, {"4", 2, 2},           {"13", 0, 2e-6}};
    for (size_t i = 0; i < sizeof trials / sizeof *trials; i++) {
        section_outline o = {0};
        p.count = 0;
        dxf_put(&p, "0 SECTION 2 HEADER 9 $INSUNITS 70 %s 0 ENDSEC 0 SECTION 2 ENTITIES",
                trials[i].code);
        dxf_put(&p, "0 CIRCLE 8 soft 10 0 20 0 40 2");
        dxf_end(&p);
        CHECK_OK(outline_of(&p, NULL, trials[i].unit, &o));
        CHECK_NEAR(o.size, trials[i].size, 1e-12);
        section_outline_free(&o);
    }
}

// what is seen from below, and arcs across 0 degrees
static void mirrored_entities_lie_where_they_are_seen(void)
{
    static dxf_paper p;
    section_outline o = {0};
    dxf_begin(&p);
    // a half disc about (-3, 1), drawn as one about (3, 1) seen from below; its flat side on the
    // left of it there
    dxf_put(&p, "0 ARC 8 soft 10 3 20 1 40 2 50 270 51 90 210 0 220 0 230 -1");
    dxf_put(&p, "0 LINE 8 soft 10 -3 20 -1 11 -3 21 3");
    dxf_end(&p);
    CHECK_OK(outline_of(&p, NULL, 0, &o));
    CHECK(section_top_shape(&o, -4e-3, 1e-3) == 0 && section_top_shape(&o, -2e-3, 1e-3) == -1);
    section_outline_free(&o);
}

static void parts_give_layers_their_materials(void)
{
    static dxf_paper p;
    section_outline o = {0};
    part_spec entry[] = {{.at = {7, 1}, .name = {"0", {7, 3}}, .material = {"stiff", {7, 9}}},
                         {.at = {8, 1}, .name = {"gone", {8, 3}}, .material = {"none", {8, 9}}}};
    key_list parts = {.count = 1, .items = entry};
    dxf_begin(&p);
    dxf_put(&p, "0 CIRCLE 8 0 10 0 20 0 40 2");
    dxf_end(&p);
    CHECK_OK(outline_of(&p, &parts, 0, &o));
    CHECK(o.items[0].material == 1);
    section_outline_free(&o);
    parts.count = 2;
    CHECK(outline_of(&p, &parts, 0, &o) == ERR_INPUT &&
          strstr(status_message(), "no layer 'gone'"));
    status_clear();
    CHECK(outline_of(&p, NULL, 0, &o) == ERR_FILE && strstr(status_message(), "layer '0'"));
    status_clear();
}

static void check_refused(const char *entities, const char *why)
{
    static dxf_paper p;
    section_outline o = {0};
    dxf_begin(&p);
    dxf_put(&p, "%s", entities);
    dxf_end(&p);
    CHECK(outline_of(&p, NULL, 0, &o) == ERR_FILE);
    if (!strstr(status_message(), why) || !strstr(status_message(), "drawing.dxf")) {
        printf("message: %s, wanted: %s\n", status_message(), why);
        CHECK(false);
    }
    status_clear();
}

#define SQUARE(l) "0 LWPOLYLINE 8 " l " 90 4 70 1 10 0 20 0 10 2 20 0 10 2 20 2 10 0 20 2"

static void what_cannot_be_is_refused_with_its_line(void)
{
    check_refused("0 LINE 8 soft 10 0 20 0 11 1 21 0 0 LINE 8 soft 10 1 20 0 11 1 21 1",
                  "drawing.dxf:39: in layer 'soft' the outline is open at (0, 0)");
    check_refused(SQUARE("soft") " " SQUARE("soft"), "drawn again in layer 'soft'");
    check_refused(SQUARE("soft") " 0 CIRCLE 8 soft 10 2 20 1 40 0.5", "crosses or touches the one");
    check_refused("0 LWPOLYLINE 8 soft 90 4 70 1 10 0 20 0 10 2 20 2 10 2 20 0 10 0 20 2",
                  "crosses or all but touches itself near");
    check_refused(SQUARE("soft") " 0 LINE 8 soft 10 2 20 2 11 3 21 3", "open at (2, 2)");
    check_refused(SQUARE("soft") " 0 INSERT 8 soft 2 block 10 0 20 0", "explode");
    check_refused("0 3DSOLID 8 soft", "3DSOLID cannot be read");
    check_refused("0 TEXT 8 soft 10 0 20 0 1 hello", "nothing is drawn");
    check_refused("0 CIRCLE 8 soft 10 0 20 0 40 -1", "CIRCLE has a radius of -1");
    check_refused("0 CIRCLE 8 soft 10 0 20 0", "CIRCLE without group code 40");
    check_refused("0 CIRCLE 8 soft 10 zero 20 0 40 1", "the value of group code 10 is no number");
    check_refused("0 CIRCLE 8 soft 10 nan 20 0 40 1", "the value of group code 10 is no number");
    check_refused("0 CIRCLE 8 soft 10 0 20 0 40 1 210 1 220 0 230 0", "along the xy plane");
    check_refused(
        "0 SPLINE 8 soft 70 4 71 2 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 0.7 41 1 10 0 20 "
        "0 10 1 20 1 10 2 20 0",
        "SPLINE with unequal weights");
    check_refused("0 SPLINE 8 soft 71 5", "SPLINE of degree 5");
    check_refused("0 SPLINE 8 soft 71 3 11 0 21 0 11 1 21 1", "fit points alone");
    check_refused("0 POLYLINE 8 soft 70 1 0 LINE 8 soft", "has no SEQEND");
    check_refused("0 POLYLINE 8 soft 70 64 0 SEQEND", "a mesh of faces");
    check_refused("0 LINE 8 soft 10 0 20 0", "LINE without group code 11");
}

static status open_text(const char *text)
{
    drawing *d = NULL;
    const status st = dxf_open_text(text, strlen(text), NULL, 0, &d);
    drawing_free(d);
    return st;
}

static void other_files_are_refused(void)
{
    const struct {
        const char *text, *why;
    } trials[] = {
        {"", "the file ends before its EOF"},
        {"#!/bin/sh\nrm -r x\n", "no ASCII DXF file"},
        {"SystemCall(\"touch x\");\n", "no ASCII DXF file"},
        {"AutoCAD Binary DXF\r\n", "binary DXF"},
        {"0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\nsoft\n10\n0\n", "the file ends before its EOF"},
        {"5\nSECTION\n", "begins with a SECTION"},
    };
    for (size_t i = 0; i < sizeof trials / sizeof *trials; i++) {
        CHECK(open_text(trials[i].text) == ERR_FILE);
        if (!strstr(status_message(), trials[i].why)) {
            printf("message: %s, wanted %s\n", status_message(), trials[i].why);
            CHECK(false);
        }
        status_clear();
    }
}

static status read_drawing(const char *directory, const char *name, void *context)
{
    drawing *d = NULL;
    (void)context;
    const status st = dxf_open_file(directory, name, NULL, 0, &d);
    drawing_free(d);
    return st;
}

static void three_hundred_mutants_are_answered(void)
{
    static dxf_paper papers[2];
    dxf_tube(&papers[0], 9);
    dxf_all_kinds(&papers[1]);
    mutant_seed seeds[2];
    for (int i = 0; i < 2; i++) {
        seeds[i] = (mutant_seed){(const unsigned char *)papers[i].text, papers[i].count};
    }
    mutant_plan plan = {
        .nseed = 2, .seeds = seeds, .suffix = ".dxf", .read = read_drawing, .state = 20};
    CHECK(mutants_run(&plan, 300, 0) == 0);
    status_clear();
}

int main(void)
{
    every_kind_of_curve_has_its_area();
    the_drawn_tube_is_the_tube_of_shapes();
    layers_lie_on_one_another_by_size();
    units_come_from_the_file_or_the_case();
    mirrored_entities_lie_where_they_are_seen();
    parts_give_layers_their_materials();
    what_cannot_be_is_refused_with_its_line();
    other_files_are_refused();
    three_hundred_mutants_are_answered();
    return test_failures != 0;
}
