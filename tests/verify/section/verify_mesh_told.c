// With a tolerance, what is told of a section belongs to the mesh that met it, also where the law
// comes from an earlier run.
#include "section/answers.h"
#include "tests/sections.h"
#include "tests/test.h"

static const double rod = 0.1; // length [m]

// one station, all its nodes' stresses under a pull
typedef struct told {
    section_result r;
    section_answers a;
} told;

static void told_free(told *t)
{
    section_answers_free(&t->a);
    section_result_free(&t->r);
}

static void tell(const section_case *c, const material *materials, told *t)
{
    const section_question question = {c, materials, true};
    CHECK_OK(section_along(c, materials, rod, &t->r));
    CHECK(t->r.nstation == 1);
    CHECK_OK(section_answer(&question, &t->r.station[0], 0, &t->a));
}

static section_case case_of(const sample *s, key_list wrenches, double tolerance)
{
    section_case c = section_case_default();
    c.shapes = (key_list){.count = s->nshape, .items = (void *)(size_t)s->shape};
    c.wrenches = wrenches;
    c.nmaterial = 1;
    c.tolerance = tolerance;
    return c;
}

static bool same_mesh(const mesh_options *a, const mesh_options *b)
{
    return a->order == b->order && a->layers == b->layers && a->finer == b->finer;
}

static void belongs_to(const told *t, const section_case *c, const material *materials)
{
    section_case plain = *c;
    beam_law law = {0};
    mesh m = {0};
    plain.tolerance = 0;
    plain.mesh = t->r.station[0].mesh;
    CHECK_OK(section_solve(&plain, materials, 0, rod, &law));
    CHECK_WITHIN(mat6_relative_error(law.K, t->r.station[0].law.K), 0, 0);
    CHECK_OK(section_mesh_at(&plain, 0, &m));
    CHECK(t->a.nodes.order == m.order && t->a.nodes.nnode == m.nnode);
    mesh_free(&m);
}

int main(void)
{
    against(BY_SECOND_WAY, "the section solved on the mesh that is told");
    sample s;
    section_wrench pull = {.name = "pull", .force = {0, 0, 1}, .at_kind = -1};
    const key_list wrenches = {.count = 1, .items = &pull};
    const double tolerance[] = {1e-2, 1e-5, 1e-6};
    sample_make(14, &s); // an angle: the tolerances need different meshes
    for (int i = 0; i < 3; i++) {
        section_case c = case_of(&s, wrenches, tolerance[i]);
        const section_known nothing = {0};
        told first = {0}, again = {0};
        c.known = &nothing;
        tell(&c, s.material, &first);
        const mesh_options *used = &first.r.station[0].mesh;
        printf("tolerance %.0e: order %d, %d layers more, %.2f times finer, %d nodes\n",
               tolerance[i], used->order, used->layers, used->finer, first.a.nodes.nnode);
        CHECK(!same_mesh(used, &c.mesh));
        belongs_to(&first, &c, s.material);
        c.known = &first.r.solved;
        tell(&c, s.material, &again);
        CHECK(again.r.effort.nstored == 1 && same_mesh(&again.r.station[0].mesh, used));
        belongs_to(&again, &c, s.material);
        told_free(&again);
        told_free(&first);
    }
    return test_failures != 0;
}
