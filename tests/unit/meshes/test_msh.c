// tests/unit/meshes/test_msh.c
#include "tests/msh.h"

#include "meshes/raw_mesh.h"
#include "tests/shapes.h"
#include "tests/test.h"

// --- files that gmsh wrote: a unit square of 2 x 2 quadrangles, half a disc of radius 1/2 beside
// it

static moments all_moments(const mesh *m, int material)
{
    moments sum = {0};
    for (int b = 0; b < m->nblock; b++) {
        mesh one = *m;
        one.nblock = 1;
        one.block[0] = m->block[b];
        const moments part = mesh_moments(&one, material);
        for (int i = 0; i < 6; i++) {
            sum.a[i] += part.a[i];
        }
    }
    return sum;
}

static void every_order_has_its_area(void)
{
    // four chords to begin with; then arcs of pi/4 that a polynomial of order p follows, off by
    // less than (pi/4 / 4)^(p + 2) of the radius
    const double exact[] = {0, sin(PI / 4) / 2, PI / 8, PI / 8, PI / 8};
    const double tolerance[] = {0, 1e-14, 2e-3, 3e-4, 1e-5};
    char folder[512], name[64];
    for (int p = 1; p <= 4; p++) {
        mesh m = {0};
        (void)snprintf(name, sizeof name, "tongue_41_text_%d.msh", p);
        CHECK_OK(msh_open_file(files_folder(folder), name, &m));
        CHECK(m.order == p && m.nblock == 2);
        CHECK_NEAR(all_moments(&m, 1).a[0], 1, 1e-14);
        CHECK_NEAR(all_moments(&m, 0).a[0], exact[p], tolerance[p]);
        CHECK_NEAR(all_moments(&m, 1).a[1], -0.5, 1e-14);
        CHECK_WITHIN(all_moments(&m, -1).a[2], 0, 1e-10); // as gmsh places nodes along curves
        mesh_free(&m);
    }
}

static bool same_mesh(const mesh *a, const mesh *b)
{
    bool same = a->nnode == b->nnode && a->nblock == b->nblock && a->order == b->order;
    for (int i = 0; same && i < 3 * a->nnode; i++) {
        same = fabs(a->xyz[i] - b->xyz[i]) <= 1e-15;
    }
    for (int k = 0; same && k < a->nblock; k++) {
        const mesh_block *p = &a->block[k], *q = &b->block[k];
        const size_t n = (size_t)p->nelem;
        same = p->shape == q->shape && p->nelem == q->nelem &&
               memcmp(p->conn, q->conn, n * (size_t)p->per_elem * sizeof(int)) == 0 &&
               memcmp(p->material, q->material, n * sizeof(int)) == 0;
    }
    return same;
}

static void both_versions_as_text_and_as_bytes_are_the_same_mesh(void)
{
    const char *forms[] = {"41_bytes", "22_text", "22_bytes"};
    char folder[512], name[64];
    for (int p = 1; p <= 4; p++) {
        mesh m = {0};
        (void)snprintf(name, sizeof name, "tongue_41_text_%d.msh", p);
        CHECK_OK(msh_open_file(files_folder(folder), name, &m));
        for (int k = 0; k < 3; k++) {
            mesh other = {0};
            (void)snprintf(name, sizeof name, "tongue_%s_%d.msh", forms[k], p);
            CHECK_OK(msh_open_file(folder, name, &other));
            CHECK(same_mesh(&m, &other));
            mesh_free(&other);
        }
        mesh_free(&m);
    }
}

static void lattice_holds_gmsh_nodes_in_our_order(void)
{
    int lattice[25];
    const int triangle3[10] = {0, 3, 9, 1, 2, 6, 8, 7, 4, 5};
    const int quad3[16] = {0, 3, 15, 12, 1, 2, 7, 11, 14, 13, 8, 4, 5, 6, 10, 9};
    raw_lattice(SHAPE_TRIANGLE, 3, lattice);
    CHECK(memcmp(lattice, triangle3, sizeof triangle3) == 0);
    raw_lattice(SHAPE_QUAD, 3, lattice);
    CHECK(memcmp(lattice, quad3, sizeof quad3) == 0);
}

static void a_unit_and_parts_are_the_cases(void)
{
    char folder[512];
    mesh m = {0};
    const material one = {.name = "rubber", .E = 1, .nu = 0.3};
    part_spec parts[] = {{.at = {5, 7}, .name = {"soft", {5, 7}}, .material = {"rubber", {5, 9}}},
                         {.at = {6, 7}, .name = {"stiff", {6, 7}}, .material = {"none", {6, 9}}}};
    const key_list list = {.at = {5, 5}, .count = 2, .items = parts};
    const char *file = "tongue_41_text_1.msh";
    CHECK_OK(msh_open_with(files_folder(folder), file, 1, &one, list, UNIT_MM, &m));
    CHECK(m.nblock == 1 && m.block[0].shape == SHAPE_TRIANGLE); // the square is left out
    CHECK_NEAR(all_moments(&m, 0).a[0], 1e-6 * sin(PI / 4) / 2, 1e-14);
    mesh_free(&m);

    int line = 0, column = 0;
    parts[0].name.text = "sotf";
    CHECK(msh_open_with(folder, file, 1, &one, list, UNIT_MM, &m) == ERR_FILE);
    parts[0].name.text = "soft";
    parts[1].material.text = "ruber";
    CHECK(msh_open_with(folder, file, 1, &one, list, UNIT_MM, &m) == ERR_INPUT);
    CHECK(status_place(&line, &column) && line == 6 && column == 9);
    CHECK(strstr(status_message(), "did you mean 'rubber'?") != NULL);
    parts[1].material.text = "none";
    part_spec three[3] = {parts[0], parts[1], parts[0]};
    three[2].name.text = "air";
    const key_list longer = {.at = {5, 5}, .count = 3, .items = three};
    CHECK(msh_open_with(folder, file, 1, &one, longer, UNIT_MM, &m) == ERR_INPUT);
    CHECK(strstr(status_message(), "'air'") != NULL);
}

// --- small files by hand; two triangles, a unit square

#define HEAD                                                                                       \
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"soft\"\n2 2 \"stiff\"\n"       \
    "$EndPhysicalNames\n"
#define NODES "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
#define ELEMENTS "$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 2 1 1 3 4\n$EndElements\n"

static status open_text(const char *text, mesh *out)
{
    return msh_open_text(text, strlen(text), out);
}

static void a_small_file_is_read(void)
{
    mesh m = {0};
    CHECK_OK(open_text(HEAD NODES ELEMENTS, &m));
    CHECK(m.nnode == 4 && m.nblock == 1 && m.block[0].nelem == 2 && !m.frame);
    CHECK(m.block[0].material[0] == 0 && m.block[0].material[1] == 1);
    mesh_free(&m);
    // turned over, another plane, an unused node, large numbers, windows line ends, a section that
    // means nothing to us
    CHECK_OK(open_text(HEAD "$Nodes\n5\n10000000 0 0 7\n2 1 0 7\n3 1 1 7\n4 0 1 7\n9 5 5 5\n"
                            "$EndNodes\r\n$Periodic\n0\n$EndPeriodic\n"
                            "$Elements\r\n3\n8 1 2 9 1 2 3\n1 2 2 1 1 10000000 3 2\n"
                            "2 2 2 2 1 10000000 3 4\n$EndElements\n",
                       &m));
    CHECK(m.nnode == 4);
    CHECK_NEAR(all_moments(&m, -1).a[0], 1, 1e-15);
    CHECK(m.xyz[2] == 0);
    mesh_free(&m);
}

static void an_8_node_quadrangle_gets_its_middle(void)
{
    mesh m = {0};
    CHECK_OK(open_text(HEAD "$Nodes\n8\n1 0 0 0\n2 2 0 0\n3 2 2 0\n4 0 2 0\n5 1 -0.2 0\n6 2 1 0\n"
                            "7 1 2 0\n8 0 1 0\n$EndNodes\n$Elements\n1\n"
                            "1 16 2 1 1 1 2 3 4 5 6 7 8\n$EndElements\n",
                       &m));
    CHECK(m.order == 2 && m.nnode == 9);
    // the lower side bulges by a parabola: 2/3 of its height times its length
    CHECK_NEAR(all_moments(&m, 0).a[0], 4 + 2.0 / 3 * 0.2 * 2, 1e-14);
    mesh_free(&m);
}

static void views_become_frames(void)
{
    mesh m = {0};
    CHECK_OK(open_text(HEAD NODES ELEMENTS
                       "$ElementData\n1\n\"plane_angle_deg\"\n1\n0.0\n3\n0\n1\n1\n1 90\n"
                       "$EndElementData\n"
                       "$ElementData\n1\n\"von Mises\"\n1\n0.0\n3\n0\n1\n1\n1 -\n$EndElementData\n"
                       "$ElementData\n1\n\"fibre_angle_rad\"\n1\n0.0\n3\n0\n1\n1\n1 0.25\n"
                       "$EndElementData\n",
                       &m));
    CHECK(m.nframe == 1 && m.block[0].frame[0] == 0 && m.block[0].frame[1] == -1);
    const material_frame wanted = material_frame_make(PI / 2, 0.25);
    for (int i = 0; m.nframe == 1 && i < 9; i++) {
        CHECK_WITHIN(m.frame[0].axes.a[i / 3][i % 3], wanted.axes.a[i / 3][i % 3], 1e-15);
    }
    mesh_free(&m);
    CHECK_OK(open_text(HEAD NODES ELEMENTS "$ElementData\n1\n\"axes\"\n1\n0.0\n3\n0\n9\n2\n"
                                           "1 0 0 1 0 1 0 -1 0 0\n2 0 0 1 0 1 0 -1 0 0\n"
                                           "$EndElementData\n",
                       &m));
    CHECK(m.nframe == 1 && m.block[0].frame[1] == 0 && m.frame[0].axes.a[2][0] == -1);
    mesh_free(&m);
}

// each with what the message must hold
static void what_makes_no_section_is_refused_in_one_line(void)
{
    static const char *const cases[][2] = {
        {"", "empty"},
        {"SystemCall \"touch /tmp/x\";\n", "text that begins with 'SystemCall"},
        {"#!/bin/sh\nid\n", "a script"},
        {"\x7f"
         "ELF",
         "a program"},
        {"$MeshFormat\n4 0 8\n$EndMeshFormat\n", ":2: MSH version 4 is not read"},
        {"$MeshFormat\n2.2 0 4\n$EndMeshFormat\n", ":2: a file of type 0"},
        {"$MeshFormat\n2.2 0 8\n", ":3: the file ends here"},
        {HEAD "SystemCall \"touch /tmp/x\";\n", ":9: a section's name is wanted here"},
        {HEAD NODES, "the file ends without $Elements"},
        {HEAD ELEMENTS NODES, "before $Nodes"},
        {HEAD NODES NODES ELEMENTS, "$Nodes comes twice"},
        {HEAD "$Nodes\n4000000000\n1 0 0 0\n", ":10: the number of nodes 4000000000 is not"},
        {HEAD "$Nodes\n-1\n", "-1 is not possible"},
        {HEAD "$Nodes\n2\n1 0 0 0\n1 1 0 0\n$EndNodes\n" ELEMENTS, "two nodes have the number 1"},
        {HEAD "$Nodes\n1\n1 0 nan 0\n$EndNodes\n", ":11: y of a node is no number: 'nan'"},
        {HEAD "$Nodes\n1\n1 0 1e999 0\n$EndNodes\n", ":11: y of a node is too large"},
        {HEAD "$Nodes\n1\n1 0 0x10 0\n$EndNodes\n", "is no number: '0x10'"},
        {HEAD NODES "$Elements\n1\n1 2 2 1 1 1 2 5\n$EndElements\n", ":18: there is no node 5"},
        {HEAD NODES "$Elements\n1\n1 2 2 0 1 1 2 3\n$EndElements\n", "no physical group"},
        {HEAD NODES "$Elements\n1\n1 2 2 3 1 1 2 3\n$EndElements\n",
         "the physical group '3' has no material"},
        {HEAD NODES "$Elements\n1\n1 4 2 1 1 1 2 3 4\n$EndElements\n", "solid"},
        {HEAD NODES "$Elements\n1\n1 99 2 1 1 1 2 3 4\n$EndElements\n", "type 99"},
        {HEAD NODES "$Elements\n1\n1 39 2 1 1 1 2 3 4\n$EndElements\n", "SecondOrderIncomplete"},
        {HEAD NODES "$Elements\n2\n1 2 2 1 1 1 2 3\n1 2 2 1 1 1 3 4\n$EndElements\n",
         "two elements have the number 1"},
        {HEAD NODES "$Elements\n1\n1 1 2 1 1 1 2\n$EndElements\n", "no element"},
        {HEAD NODES "$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 1 2 4\n$EndElements\n", "folded"},
        {HEAD NODES "$Elements\n1\n1 3 2 1 1 1 2 4 3\n$EndElements\n", "no area"},
        {HEAD NODES "$Elements\n1\n1 2 2 1 1 1 2 2\n$EndElements\n", "no area"},
        {HEAD "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0.1\n$EndNodes\n"
              "$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n",
         "a plane z = constant"},
        {HEAD "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 0 0\n5 1 1 0\n6 0 1 0\n$EndNodes\n"
              "$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 4 5 6\n$EndElements\n",
         "same place"},
        // a square and, on half of its right side each, two more triangles
        {HEAD "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 1 .5 0\n6 2 .5 0\n$EndNodes\n"
              "$Elements\n3\n1 3 2 1 1 1 2 3 4\n2 2 2 1 1 2 6 5\n3 2 2 1 1 5 6 3\n"
              "$EndElements\n",
         "node hangs on"},
        {HEAD "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 5 0 0\n5 6 1 0\n6 5 1 0\n$EndNodes\n"
              "$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 4 5 6\n$EndElements\n",
         "one piece"},
        {HEAD NODES ELEMENTS "$ElementData\n1\n\"plane_angle\"\n0\n3\n0\n1\n0\n",
         "plane_angle_deg or"},
        {HEAD NODES ELEMENTS "$ElementData\n1\n\"axes\"\n0\n3\n0\n9\n1\n1 1 0 0 0 1 0 0 0 -1\n"
                             "$EndElementData\n",
         "orthonormal"},
        {HEAD NODES ELEMENTS "$Comments\nno end", "$EndComments"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        mesh m = {0};
        const status st = open_text(cases[i][0], &m);
        const char *said = status_message();
        if (st != ERR_FILE || !strstr(said, cases[i][1]) || strchr(said, '\n')) {
            printf("case %zu: %d '%s', wanted '%s'\n", i, (int)st, said, cases[i][1]);
            CHECK(false);
        }
        CHECK(!m.xyz);
    }
}

static void nodes_between_corners_must_agree(void)
{
    mesh m = {0};
    // two quadratic triangles that share corners 1 and 3, but not the node between
    CHECK(open_text(HEAD "$Nodes\n10\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 .5 0 0\n6 1 .5 0\n"
                         "7 .5 .5 0\n8 .5 1 0\n9 0 .5 0\n10 .5 .55 0\n$EndNodes\n$Elements\n2\n"
                         "1 9 2 1 1 1 2 3 5 6 7\n2 9 2 1 1 1 3 4 10 8 9\n$EndElements\n",
                    &m) == ERR_FILE);
    CHECK(strstr(status_message(), "not the nodes between") != NULL);
    // a node of an edge that is a corner elsewhere
    CHECK(open_text(HEAD "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 1 1 0\n5 .5 0 0\n6 1 .5 0\n7 .5 .5 0\n"
                         "$EndNodes\n$Elements\n2\n1 9 2 1 1 1 2 3 5 6 7\n2 9 2 1 1 1 5 3 2 6 7\n"
                         "$EndElements\n",
                    &m) == ERR_FILE);
}

int main(void)
{
    every_order_has_its_area();
    both_versions_as_text_and_as_bytes_are_the_same_mesh();
    lattice_holds_gmsh_nodes_in_our_order();
    a_unit_and_parts_are_the_cases();
    a_small_file_is_read();
    an_8_node_quadrangle_gets_its_middle();
    views_become_frames();
    what_makes_no_section_is_refused_in_one_line();
    nodes_between_corners_must_agree();
    return test_failures != 0;
}
