// tests/unit/fem/test_unknowns.c
#include "base/memory.h"
#include "fem/unknowns.h"
#include "tests/test.h"

#include <string.h>

static const material one = {.E = 1, .nu = 0.3};

// a square of side 1 cut into two triangles, beside it a quad: both blocks, order 2
static void mixed_mesh(mesh *m)
{
    const shape shapes[2] = {SHAPE_QUAD, SHAPE_TRIANGLE};
    const int nelem[2] = {1, 2};
    // lattice of 5 x 3 nodes, spacing 1/2
    const int quad[9] = {2, 3, 4, 7, 8, 9, 12, 13, 14};
    const int triangle[12] = {0, 1, 2, 5, 6, 10, 12, 11, 10, 7, 6, 2};
    CHECK_OK(mesh_make(2, 15, 2, shapes, nelem, m));
    for (int i = 0; i < 15; i++) {
        m->xyz[3 * i] = 0.5 * (i % 5);
        m->xyz[3 * i + 1] = 0.5 * (i / 5);
    }
    memcpy(m->block[0].conn, quad, sizeof quad);
    memcpy(m->block[1].conn, triangle, sizeof triangle);
}

enum { LAYERS = 3, LEVELS = 7, NODES = 15, MOST = NODES * LEVELS };

static body_spec spec_of(const mesh *plane, const int *matter)
{
    static const double layer[LAYERS + 1] = {0, 1, 2, 3};
    return (body_spec){.plane = plane,
                       .materials = &one,
                       .order = 2,
                       .nlayer = LAYERS,
                       .layer = layer,
                       .matter = matter};
}

// --- shares

static void ranks_share_all_layers_in_order(const mesh *plane)
{
    const body_spec spec = spec_of(plane, NULL);
    for (int size = 1; size <= 9; size++) {
        int layer = 0, level = 0;
        for (int rank = 0; rank < size; rank++) {
            const level_share s = level_share_of(&spec, rank, size);
            CHECK(s.first_layer == layer && s.first == level);
            CHECK(s.last_layer > s.first_layer || rank >= LAYERS); // none idle before its turn
            CHECK(s.from >= 0 && s.from < s.to && s.to <= LEVELS);
            CHECK(s.first == s.last || (s.from <= s.first && s.to >= s.last));
            layer = s.last_layer;
            level = s.last;
        }
        CHECK(layer == LAYERS && level == LEVELS);
    }
}

static void layers_with_little_matter_count_little(const mesh *plane)
{
    // triangles alone in the first two layers, all in the last
    const int matter[3 * LAYERS] = {-1, 0, -1, -1, 0, -1, 0, 0, 0};
    const body_spec spec = spec_of(plane, matter);
    CHECK(level_share_of(&spec, 0, 2).last_layer == 2);
}

// --- pattern

static void mark_couplings(const unknowns *u, const int *conn, int n, int layer,
                           char (*coupled)[MOST])
{
    int block[ELEMENT_MAX_NODES + 2], count = 0;
    for (int k = 0; k <= 2; k++) {
        for (int a = 0; a < n; a++) {
            block[count++] = unknowns_block(u, conn[a], 2 * layer + k);
        }
    }
    if (u->cap && layer == LAYERS - 1) {
        block[count++] = u->cap_block;
        block[count++] = u->cap_block + 1;
    }
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < count; j++) {
            if (block[i] >= 0 && block[j] >= block[i]) {
                coupled[block[i]][block[j]] = 1;
            }
        }
    }
}

// the pattern against the couplings that the elements really make, for every rank of several
static void the_pattern_is_what_elements_couple(const segment_problem *p, int size)
{
    static char coupled[MOST][MOST];
    const body *b = p->body;
    int rows = 0;
    unknowns all = {0};
    CHECK_OK(unknowns_make(p, level_share_of(&b->spec, 0, 1), &all));
    memset(coupled, 0, sizeof coupled);
    for (int i = 0; i < 2; i++) {
        const mesh_block *k = &b->plane->block[i];
        for (int e = 0; e < k->nelem; e++) {
            for (int layer = 0; layer < LAYERS; layer++) {
                if (body_material(b, i, e, layer) >= 0) {
                    mark_couplings(&all, k->conn + e * k->per_elem, k->per_elem, layer, coupled);
                }
            }
        }
    }
    for (int rank = 0; rank < size; rank++) {
        int own[MOST], beyond[MOST];
        unknowns u = {0};
        CHECK_OK(unknowns_make(p, level_share_of(&b->spec, rank, size), &u));
        CHECK(u.first == rows && u.nblock == all.nblock);
        CHECK_OK(unknowns_pattern(&u, own, beyond));
        for (int i = u.first; i < u.last; i++) {
            int inside = 0, outside = 0;
            for (int j = i; j < u.nblock; j++) {
                inside += j < u.last && coupled[i][j];
                outside += j >= u.last && coupled[i][j];
            }
            // room enough; where all is matter, no more
            CHECK(own[i - u.first] >= inside && beyond[i - u.first] >= outside);
            CHECK(b->spec.matter || (own[i - u.first] == inside && beyond[i - u.first] == outside));
        }
        rows = u.last;
        unknowns_free(&u);
    }
    CHECK(rows == all.nblock);
    unknowns_free(&all);
}

// --- displacements and forces

static void the_cap_moves_rigidly(const unknowns *u)
{
    double cap[6], moved[3 * NODES];
    const double v[3] = {0.1, 0.2, 0.3}, w[3] = {0.4, 0.5, 0.6};
    for (int i = 0; i < 3; i++) {
        cap[i] = v[i];
        cap[3 + i] = w[i] * u->radius;
    }
    unknowns_expand(u, LEVELS - 1, NULL, cap, false, moved);
    for (int i = 0; i < NODES; i++) {
        const double *x = u->body->plane->xyz + 3 * i, *top = moved + 3 * i;
        CHECK_WITHIN(top[0], v[0] - w[2] * x[1], 1e-15);
        CHECK_WITHIN(top[1], v[1] + w[2] * x[0], 1e-15);
        CHECK_WITHIN(top[2], v[2] + w[0] * x[1] - w[1] * x[0], 1e-15);
    }
}

// forces on rows do the work that they do on the nodes: u(x) . f = x . b(f)
static void gathering_is_the_transpose_of_expanding(const segment_problem *p)
{
    static double x[3 * MOST], f[3 * MOST], b[3 * MOST], moved[3 * MOST];
    unknowns u = {0};
    double of_nodes = 0, of_rows = 0;
    CHECK_OK(unknowns_make(p, level_share_of(&p->body->spec, 0, 1), &u));
    for (int i = 0; i < 3 * MOST; i++) {
        x[i] = sin(1 + i);
        f[i] = cos(2 * i);
    }
    for (int level = 0; level < LEVELS; level++) {
        unknowns_expand(&u, level, x + 3 * u.start[level], x + 3 * u.cap_block, false,
                        moved + 3 * NODES * level);
    }
    unknowns_gather(&u, f, b);
    for (int i = 0; i < 3 * MOST; i++) {
        of_nodes += moved[i] * f[i];
        of_rows += i < 3 * u.nblock ? x[i] * b[i] : 0;
    }
    CHECK_NEAR(of_rows, of_nodes, 1e-13);
    unknowns_free(&u);
}

// u_z everywhere, and three in the plane: what rigid motion needs and no more
static void a_base_free_to_contract_is_held_as_little_as_needed(const unknowns *u)
{
    int held[3] = {0};
    for (int i = 0; i < NODES; i++) {
        for (int d = 0; d < 3; d++) {
            held[d] += unknowns_is_held(u, i, 0, d);
            CHECK(!unknowns_is_held(u, i, 1, d));
        }
    }
    CHECK(held[2] == NODES);
    CHECK(held[0] == 1 && held[1] == 2); // the section is wider than high
}

static void one_kind(const mesh *plane, const int *matter, int base, int tip)
{
    body b = {0};
    unknowns u = {0};
    const body_spec spec = spec_of(plane, matter);
    CHECK_OK(body_make(&spec, &b));
    const segment_problem p = {.body = &b, .base = base, .tip = tip};
    for (int size = 1; size <= 5; size++) { // also more ranks than layers
        the_pattern_is_what_elements_couple(&p, size);
    }
    gathering_is_the_transpose_of_expanding(&p);
    CHECK_OK(unknowns_make(&p, level_share_of(&spec, 0, 1), &u));
    CHECK(matter || u.nblock == NODES * (LEVELS - (base == BASE_CLAMPED) - (tip == TIP_RIGID)) +
                                    (tip == TIP_RIGID ? 2 : 0));
    if (tip == TIP_RIGID) {
        the_cap_moves_rigidly(&u);
    }
    if (base == BASE_FREE_TO_CONTRACT && !matter) {
        a_base_free_to_contract_is_held_as_little_as_needed(&u);
    }
    unknowns_free(&u);
    body_free(&b);
}

static void contradictions_are_refused(const mesh *plane)
{
    body b = {0};
    unknowns u = {0};
    const body_spec spec = spec_of(plane, NULL);
    const face_hold tip = {.on = {.face = FACE_TIP, .to = INFINITY}, .mask = 7};
    CHECK_OK(body_make(&spec, &b));
    segment_problem p = {
        .body = &b, .base = BASE_CLAMPED, .tip = TIP_RIGID, .nhold = 1, .hold = &tip};
    CHECK(unknowns_make(&p, level_share_of(&spec, 0, 1), &u) == ERR_INPUT);
    status_clear();
    p.tip = TIP_FREE;
    p.base = BASE_FREE_TO_CONTRACT;
    CHECK(unknowns_make(&p, level_share_of(&spec, 0, 1), &u) == ERR_INPUT);
    status_clear();
    p.base = BASE_CLAMPED;
    CHECK_OK(unknowns_make(&p, level_share_of(&spec, 0, 1), &u));
    for (int i = 0; i < NODES; i++) {
        CHECK(unknowns_is_held(&u, i, LEVELS - 1, 2) && !unknowns_is_held(&u, i, LEVELS - 2, 2));
    }
    unknowns_free(&u);
    body_free(&b);
}

int main(void)
{
    mesh plane = {0};
    const int matter[3 * LAYERS] = {0, 0, -1, -1, 0, 0, 0, 0, 0};
    mixed_mesh(&plane);
    ranks_share_all_layers_in_order(&plane);
    layers_with_little_matter_count_little(&plane);
    for (int kind = 0; kind < 4; kind++) {
        one_kind(&plane, NULL, kind % 2, kind / 2);
        one_kind(&plane, matter, kind % 2, kind / 2);
    }
    contradictions_are_refused(&plane);
    mesh_free(&plane);
    return test_failures != 0;
}
