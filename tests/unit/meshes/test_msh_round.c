// tests/unit/meshes/test_msh_round.c
// A mesh with directions of its materials, as a blade section has them, written as a MSH file in
// every form and read back identical. The writer here is its own: it knows nothing of the reader.
#include "tests/msh.h"
#include "tests/shapes.h"
#include "tests/test.h"

#include <stdint.h>
#include <time.h>

// bytes of a file as they are written
typedef struct page {
    char *bytes;
    size_t count, room;
    bool binary, swapped;
} page;

static void put(page *p, const void *bytes, size_t n)
{
    if (p->count + n > p->room) {
        p->room = 2 * (p->count + n);
        p->bytes = realloc(p->bytes, p->room);
    }
    memcpy(p->bytes + p->count, bytes, n);
    p->count += n;
}

static void put_text(page *p, const char *text)
{
    put(p, text, strlen(text));
}

static void put_bytes(page *p, const void *value, size_t n)
{
    char turned[8];
    for (size_t i = 0; i < n; i++) {
        turned[i] = ((const char *)value)[p->swapped ? n - 1 - i : i];
    }
    put(p, turned, n);
}

static void put_int(page *p, int value)
{
    char text[32];
    const int32_t v = value;
    (void)snprintf(text, sizeof text, "%d ", value);
    p->binary ? put_bytes(p, &v, sizeof v) : put_text(p, text);
}

static void put_size(page *p, int value)
{
    const int64_t v = value;
    p->binary ? put_bytes(p, &v, sizeof v) : put_int(p, value);
}

static void put_real(page *p, double value)
{
    char text[32];
    (void)snprintf(text, sizeof text, "%.17g ", value);
    p->binary ? put_bytes(p, &value, sizeof value) : put_text(p, text);
}

// a number on a line of text, in both forms
static void put_line(page *p, int value)
{
    char text[32];
    (void)snprintf(text, sizeof text, "%d\n", value);
    put_text(p, text);
}

static void put_end(page *p, const char *name)
{
    put_text(p, p->binary ? "" : "\n");
    put_text(p, name);
}

static void put_head(page *p, bool newer)
{
    char text[64];
    (void)snprintf(text, sizeof text, "$MeshFormat\n%s %d 8\n", newer ? "4.1" : "2.2", p->binary);
    put_text(p, text);
    if (p->binary) {
        put_int(p, 1);
    }
    put_text(p, "\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"soft\"\n2 2 \"stiff\"\n"
                "$EndPhysicalNames\n");
}

static void put_newer(page *p, const mesh *m)
{
    put_text(p, "$Entities\n");
    for (int i = 0; i < 4; i++) {
        put_size(p, i == 2 ? 2 : 0);
    }
    for (int k = 1; k <= 2; k++) {
        put_int(p, k);
        for (int i = 0; i < 6; i++) {
            put_real(p, 0);
        }
        put_size(p, 1);
        put_int(p, k);
        put_size(p, 0);
    }
    put_end(p, "$EndEntities\n$Nodes\n");
    const int head[] = {1, m->nnode, 1, m->nnode};
    for (int i = 0; i < 4; i++) {
        put_size(p, head[i]);
    }
    put_int(p, 2);
    put_int(p, 1);
    put_int(p, 0);
    put_size(p, m->nnode);
    for (int i = 0; i < m->nnode; i++) {
        put_size(p, i + 1);
    }
    for (int i = 0; i < 3 * m->nnode; i++) {
        put_real(p, m->xyz[i]);
    }
    const mesh_block *b = &m->block[0];
    put_end(p, "$EndNodes\n$Elements\n");
    const int counts[] = {b->nelem, b->nelem, 1, b->nelem}; // a block each keeps their order
    for (int i = 0; i < 4; i++) {
        put_size(p, counts[i]);
    }
    for (int e = 0; e < b->nelem; e++) {
        put_int(p, 2);
        put_int(p, b->material[e] + 1);
        put_int(p, 3);
        put_size(p, 1);
        put_size(p, e + 1);
        const int corner[] = {0, 1, 3, 2};
        for (int i = 0; i < 4; i++) {
            put_size(p, b->conn[4 * e + corner[i]] + 1);
        }
    }
    put_end(p, "$EndElements\n");
}

static void put_older(page *p, const mesh *m)
{
    const mesh_block *b = &m->block[0];
    put_text(p, "$Nodes\n");
    put_line(p, m->nnode);
    for (int i = 0; i < m->nnode; i++) {
        put_int(p, i + 1);
        for (int d = 0; d < 3; d++) {
            put_real(p, m->xyz[3 * i + d]);
        }
    }
    put_end(p, "$EndNodes\n$Elements\n");
    put_line(p, b->nelem);
    for (int e = 0; e < b->nelem; e++) {
        const int text[] = {e + 1, 3, 2, b->material[e] + 1, 7};
        const int bytes[] = {3, 1, 2, e + 1, b->material[e] + 1, 7};
        for (int i = 0; i < (p->binary ? 6 : 5); i++) {
            put_int(p, p->binary ? bytes[i] : text[i]);
        }
        const int corner[] = {0, 1, 3, 2};
        for (int i = 0; i < 4; i++) {
            put_int(p, b->conn[4 * e + corner[i]] + 1);
        }
    }
    put_end(p, "$EndElements\n");
}

static void put_axes(page *p, const mesh *m)
{
    const mesh_block *b = &m->block[0];
    put_text(p, "$ElementData\n1\n\"axes\"\n1\n0.0\n3\n0\n9\n");
    put_line(p, b->nelem);
    for (int e = 0; e < b->nelem; e++) {
        put_int(p, e + 1);
        for (int i = 0; i < 9; i++) {
            put_real(p, m->frame[b->frame[e]].axes.a[i / 3][i % 3]);
        }
    }
    put_end(p, "$EndElementData\n");
}

// a ring whose fibres are wound around it by an angle that changes from element to element
static status make_ring(int order, double size, mesh *out)
{
    status st = OK;
    const shape_spec s[] = {an_annulus(4, 3.2, 0), a_sector(4, 3.2, PI, PI / 8, 1)};
    TRY(mesh_of(2, s, MESH_MAPPED, order, size, out));
    TRY(mesh_take_frames(out, 7));
    for (int i = 0; i < 7; i++) {
        out->frame[i] = material_frame_make(0.3 + i, 0.1 * i);
    }
    for (int e = 0; e < out->block[0].nelem; e++) {
        out->block[0].frame[e] = e % 7;
    }

done:
    return st;
}

static bool same_axes(const mesh *a, const mesh *b, int elem)
{
    const int f = a->block[0].frame[elem], g = b->block[0].frame[elem];
    for (int i = 0; i < 9; i++) {
        if (a->frame[f].axes.a[i / 3][i % 3] != b->frame[g].axes.a[i / 3][i % 3]) {
            return false;
        }
    }
    return true;
}

static void every_form_reads_back_identical(void)
{
    mesh m = {0};
    CHECK_OK(make_ring(1, 0.4, &m));
    for (int form = 0; form < 6; form++) {
        page p = {.binary = form >= 2, .swapped = form >= 4};
        mesh back = {0};
        put_head(&p, form % 2);
        form % 2 ? put_newer(&p, &m) : put_older(&p, &m);
        put_axes(&p, &m);
        CHECK_OK(msh_open_text(p.bytes, p.count, &back));
        const mesh_block *a = &m.block[0], *b = &back.block[0];
        CHECK(back.nnode == m.nnode && back.nblock == 1 && b->nelem == a->nelem);
        CHECK(back.nframe == 7);
        if (back.nnode == m.nnode && b->nelem == a->nelem && back.nframe == 7) {
            const size_t n = (size_t)a->nelem;
            CHECK(memcmp(back.xyz, m.xyz, 3 * (size_t)m.nnode * sizeof(double)) == 0);
            CHECK(memcmp(b->conn, a->conn, 4 * n * sizeof(int)) == 0);
            CHECK(memcmp(b->material, a->material, n * sizeof(int)) == 0);
            for (int e = 0; e < a->nelem; e++) {
                CHECK(same_axes(&m, &back, e));
            }
        }
        mesh_free(&back);
        free(p.bytes);
    }
    mesh_free(&m);
}

// twenty thousand elements and their directions; prints what it takes
static void a_large_file_is_read_at_once(void)
{
    mesh m = {0};
    double best = INFINITY;
    page p = {0};
    CHECK_OK(make_ring(1, 0.03, &m));
    put_head(&p, true);
    put_newer(&p, &m);
    put_axes(&p, &m);
    for (int i = 0; i < 3; i++) {
        mesh back = {0};
        const clock_t begin = clock();
        CHECK_OK(msh_open_text(p.bytes, p.count, &back));
        best = fmin(best, (double)(clock() - begin) / CLOCKS_PER_SEC);
        mesh_free(&back);
    }
    printf("%d elements, %.1f MB: %.3f s CPU\n", m.block[0].nelem, (double)p.count * 1e-6, best);
    CHECK(best < 2); // far above what it takes, also under sanitizers
    free(p.bytes);
    mesh_free(&m);
}

int main(void)
{
    every_form_reads_back_identical();
    a_large_file_is_read_at_once();
    return test_failures != 0;
}
