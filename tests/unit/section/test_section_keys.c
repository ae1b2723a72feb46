// tests/unit/section/test_section_keys.c
#include "section/section.h"
#include "tests/test.h"

#include <string.h>

static material known[2] = {{.name = "soft", .E = 1, .nu = 0.3},
                            {.name = "stiff", .E = 2, .nu = 0.3}};
static const key_list materials = {.count = 2, .items = known};

static status bind(const char *first, const char *second, shape_spec shapes[2], mark *where)
{
    section_case c = section_case_default();
    shapes[0] = (shape_spec){.material = {first, {3, 7}}};
    shapes[1] = (shape_spec){.material = {second, {4, 9}}};
    c.shapes = (key_list){.at = {2, 5}, .count = 2, .items = shapes};
    return section_case_bind(&c, &materials, &(section_surroundings){0}, where);
}

static void names_become_indices(void)
{
    shape_spec shapes[2];
    mark where = {0};
    CHECK_OK(bind("stiff", "none", shapes, &where));
    CHECK(shapes[0].material_index == 1);
    CHECK(shapes[1].material_index == -1);
}

static void unknown_names_are_placed(void)
{
    shape_spec shapes[2];
    mark where = {0};
    CHECK(bind("soft", "stif", shapes, &where) == ERR_INPUT);
    CHECK(where.line == 4 && where.column == 9);
    CHECK(strcmp(status_message(), "material 'stif' is not defined (did you mean 'stiff'?)") == 0);
    status_clear();
}

static void holes_alone_are_no_section(void)
{
    shape_spec shapes[2];
    mark where = {0};
    CHECK(bind("none", "none", shapes, &where) == ERR_INPUT);
    CHECK(where.line == 2 && where.column == 5);
    status_clear();
}

// the struct that the table starts from is the default that the program uses
static void table_and_default_agree(void)
{
    const section_case a = section_case_default();
    const section_case *b = section_keys.initial;
    CHECK(section_keys.size == sizeof(section_case));
    CHECK(a.model == b->model && a.tolerance == b->tolerance && a.tolerance == 0);
    mesh_options resolved = b->mesh;
    mesh_options_resolve(&resolved);
    CHECK(a.mesh.kind == resolved.kind && a.mesh.order == resolved.order && a.mesh.order_chosen &&
          resolved.order_chosen && a.mesh.size == resolved.size);
}

int main(void)
{
    names_become_indices();
    unknown_names_are_placed();
    holes_alone_are_no_section();
    table_and_default_agree();
    return test_failures != 0;
}
