// tests/verify/app/verify_section_fem.c
// All 21 entries of K: the section room's against the middle of a column of 3D elements, which
// know nothing of warping. docs/theory.md (5.5)
#include "fem/segment.h"
#include "section/section.h"

#include "tests/sections.h"
#include "tests/test.h"

typedef struct judged {
    int sample;  // of tests/sections.h
    double size; // of an edge over the section's
    int order;
} judged;

// sector of two materials, unequal Poisson's ratios, a bar that fibres couple, an anisotropic half,
// a disc with a hole off its middle
static const judged sections[] = {
    {3, 0.4, 3}, {4, 0.4, 3}, {39, 0.4, 3}, {43, 0.5, 3}, {21, 0.5, 3}};

// the largest over all entries, of what each is worth beside the others
static void every_entry_agrees(const judged *j)
{
    sample s;
    section_case c = section_case_default();
    mesh m = {0};
    beam_law ours = {0}, solid = {0};
    double reach = 0;
    sample_make(j->sample, &s);
    c.shapes = (key_list){.count = s.nshape, .items = s.shape};
    c.nmaterial = SAMPLE_MATERIALS;
    for (int i = 0; i < SAMPLE_MATERIALS && s.material[i].name; i++) {
        CHECK_OK(material_bind(&s.material[i]));
    }
    CHECK_OK(section_reach_at(&c, 0, &reach));
    mesh_options options = c.mesh;
    options.order = j->order;
    options.size = j->size * reach;
    CHECK_OK(section_mesh_with(&c, 0, &options, &m));
    CHECK_OK(section_full_mesh(&m, s.material, &ours, NULL));
    CHECK_OK(segment_section_law(&m, s.material, &solid));
    const double apart = mat6_relative_error(solid.K, ours.K);
    printf("%-32s %5d nodes: %.1e apart, 3D says %.1e\n", s.name, m.nnode, apart,
           solid.relative_error);
    CHECK_BELOW(apart, 1e-3);
    mesh_free(&m);
}

int main(void)
{
    against(BY_SECOND_WAY, "the middle of a column of 3D elements, theory (5.5)");
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++) {
        every_entry_agrees(&sections[i]);
    }
    return test_failures != 0;
}
