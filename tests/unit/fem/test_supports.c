// tests/unit/fem/test_supports.c
#include "base/memory.h"
#include "fem/supports.h"
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

enum { LAYERS = 3, LEVELS = 7, MOST = 15 * LEVELS };

static void mark_couplings(const supports *s, const int *conn, int n, int layer,
                           char (*coupled)[MOST])
{
    int block[ELEMENT_MAX_NODES + 2], count = 0;
    for (int k = 0; k <= 2; k++) {
        for (int a = 0; a < n; a++) {
            block[count++] = supports_block(s, conn[a], 2 * layer + k);
        }
    }
    if (s->cap && layer == LAYERS - 1) {
        block[count++] = s->cap_block;
        block[count++] = s->cap_block + 1;
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
static void the_pattern_is_what_elements_couple(const column *c, const supports *s, int size)
{
    static char coupled[MOST][MOST];
    int own[MOST], beyond[MOST], rows = 0;
    memset(coupled, 0, sizeof coupled);
    for (int b = 0; b < 2; b++) {
        const mesh_block *k = &c->plane->block[b];
        for (int e = 0; e < k->nelem; e++) {
            for (int layer = 0; layer < LAYERS; layer++) {
                mark_couplings(s, k->conn + e * k->per_elem, k->per_elem, layer, coupled);
            }
        }
    }
    for (int rank = 0; rank < size; rank++) {
        const supports_share share = supports_share_of(s, rank, size);
        CHECK(share.first == rows);
        CHECK_OK(supports_pattern(s, c, share, own, beyond));
        for (int i = share.first; i < share.last; i++) {
            int inside = 0, outside = 0;
            for (int j = i; j < s->nblock; j++) {
                inside += j < share.last && coupled[i][j];
                outside += j >= share.last && coupled[i][j];
            }
            CHECK(own[i - share.first] == inside);
            CHECK(beyond[i - share.first] == outside);
        }
        rows = share.last;
    }
    CHECK(rows == s->nblock);
}

static void the_cap_moves_rigidly(const column *c, const supports *s)
{
    double x[3 * MOST] = {0}, u[3 * MOST];
    const double v[3] = {0.1, 0.2, 0.3}, w[3] = {0.4, 0.5, 0.6};
    for (int i = 0; i < 3; i++) {
        x[3 * s->cap_block + i] = v[i];
        x[3 * s->cap_block + 3 + i] = w[i] * s->radius;
    }
    supports_expand(s, c->plane, x, u);
    for (int i = 0; i < s->nplane; i++) {
        const double px = c->plane->xyz[3 * i], py = c->plane->xyz[3 * i + 1];
        const double *top = u + 3 * (s->nplane * (LEVELS - 1) + i);
        CHECK_WITHIN(top[0], v[0] - w[2] * py, 1e-15);
        CHECK_WITHIN(top[1], v[1] + w[2] * px, 1e-15);
        CHECK_WITHIN(top[2], v[2] + w[0] * py - w[1] * px, 1e-15);
        CHECK(u[3 * i] == 0 && u[3 * i + 1] == 0 && u[3 * i + 2] == 0); // the clamped base
    }
}

// u_z everywhere, and three in the plane: what rigid motion needs and no more
static void a_free_base_is_held_as_little_as_needed(const supports *s)
{
    int held[3] = {0};
    for (int i = 0; i < s->nplane; i++) {
        for (int d = 0; d < 3; d++) {
            held[d] += supports_is_held(s, i, 0, d);
            CHECK(!supports_is_held(s, i, 1, d));
        }
    }
    CHECK(held[2] == s->nplane);
    CHECK(held[0] == 1 && held[1] == 2); // the section is wider than high
}

int main(void)
{
    mesh plane = {0};
    column c = {0};
    double level[LEVELS];
    mixed_mesh(&plane);
    for (int k = 0; k < LEVELS; k++) {
        level[k] = 0.5 * k;
    }
    CHECK_OK(column_make(&plane, &one, 2, LEVELS, level, &c));
    for (int kind = 0; kind < 4; kind++) {
        supports s = {0};
        CHECK_OK(supports_make(&c, kind % 2, kind / 2, &s));
        for (int size = 1; size <= 9; size += 2) { // also more ranks than levels
            the_pattern_is_what_elements_couple(&c, &s, size);
        }
        if (kind == 3) {
            the_cap_moves_rigidly(&c, &s);
        }
        if (kind == 0) {
            a_free_base_is_held_as_little_as_needed(&s);
        }
        supports_free(&s);
    }
    column_free(&c);
    mesh_free(&plane);
    return test_failures != 0;
}
