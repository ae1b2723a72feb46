// Meshes of images: conforming, exact in area, at every order and size; smoothed ones sound.
#include "base/memory.h"
#include "meshes/pixel_mesh.h"
#include "meshes/pixel_smooth.h"
#include "tests/test.h"

#include <stdint.h>
#include <string.h>

enum { MOST_MATERIALS = 3 };

static uint64_t draw(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state;
}

// blobs of several materials with holes
static pixel_image blobs(int nx, int ny, uint64_t seed)
{
    pixel_image p = {0};
    const double pitch[2] = {1e-3, 0.5e-3};
    CHECK_OK(pixel_image_make(nx, ny, pitch, &p));
    uint64_t state = seed * 2654435761u + 88172645463325252u;
    for (int k = 0; k < 12; k++) {
        const int x = (int)(draw(&state) % (uint64_t)nx), y = (int)(draw(&state) % (uint64_t)ny);
        const int r = 1 + (int)(draw(&state) % (uint64_t)(nx / 3));
        const int material = (int)(draw(&state) % 4) - 1;
        for (int j = 0; j < ny; j++) {
            for (int i = 0; i < nx; i++) {
                if ((i - x) * (i - x) + (j - y) * (j - y) < r * r) {
                    p.at[j * nx + i] = (short)material;
                }
            }
        }
    }
    p.at[0] = 0;
    return p;
}

static pixel_image noise(int n, uint64_t seed)
{
    pixel_image p = {0};
    CHECK_OK(pixel_image_make(n, n, (const double[2]){1, 1}, &p));
    uint64_t state = seed * 2654435761u + 88172645463325252u;
    for (int i = 0; i < n * n; i++) {
        p.at[i] = (short)((int)(draw(&state) >> 11) % 3 - 1);
    }
    p.at[0] = 0;
    return p;
}

// area of a material's elements, or of its pixels [m^2]
static double mesh_area(const mesh *m, int material)
{
    double sum = 0;
    for (int b = 0; b < m->nblock; b++) {
        const mesh_block *block = &m->block[b];
        element e = {0};
        basis_table t = {0};
        CHECK_OK(element_make(block->shape, m->order, &e));
        CHECK_OK(basis_table_make(&e, 2 * m->order, &t));
        for (int k = 0; k < block->nelem; k++) {
            for (int q = 0; q < t.npoint && block->material[k] == material; q++) {
                double J[2][2] = {{0}};
                for (int i = 0; i < t.nnode; i++) {
                    const double *x = m->xyz + 3 * block->conn[k * t.nnode + i];
                    for (int d = 0; d < 4; d++) {
                        J[d / 2][d % 2] += x[d / 2] * t.dN[2 * (q * t.nnode + i) + d % 2];
                    }
                }
                sum += t.weight[q] * (J[0][0] * J[1][1] - J[0][1] * J[1][0]);
            }
        }
        basis_table_free(&t);
    }
    return sum;
}

static double pixel_area(const pixel_image *p, int material)
{
    int count = 0;
    for (int i = 0; i < p->n[0] * p->n[1]; i++) {
        count += p->at[i] == material;
    }
    return count * p->pitch[0] * p->pitch[1];
}

// length of the sides between materials and nothing
static double pixel_boundary(const pixel_image *p)
{
    double sum = 0;
    for (int j = 0; j <= p->n[1]; j++) {
        for (int i = 0; i <= p->n[0]; i++) {
            const bool here = pixel_at(p, i, j) != PIXEL_NONE;
            sum += p->pitch[1] * (here != (pixel_at(p, i - 1, j) != PIXEL_NONE));
            sum += p->pitch[0] * (here != (pixel_at(p, i, j - 1) != PIXEL_NONE));
        }
    }
    return sum;
}

typedef struct side {
    int low, high;
} side;

static int side_order(const void *a, const void *b)
{
    const side *p = a, *q = b;
    return p->low != q->low ? (p->low > q->low) - (p->low < q->low)
                            : (p->high > q->high) - (p->high < q->high);
}

// length of the sides that one element has alone: a node that hangs would add to it
static double mesh_boundary(const mesh *m)
{
    side *all = NULL;
    int n = 0;
    double sum = 0;
    CHECK_OK(TAKE(all, 4 * (size_t)mesh_element_count(m)));
    for (int b = 0; b < m->nblock; b++) {
        const mesh_block *block = &m->block[b];
        const int p = m->order, last = block->per_elem - 1;
        const int quad[4] = {0, p, last, last - p}, triangle[4] = {0, p, last, 0};
        const int nside = block->shape == SHAPE_QUAD ? 4 : 3;
        const int *local = nside == 4 ? quad : triangle;
        for (int k = 0; k < block->nelem * nside; k++) {
            const int *conn = block->conn + k / nside * block->per_elem;
            const int a = conn[local[k % nside]], c = conn[local[(k % nside + 1) % nside]];
            all[n++] = (side){a < c ? a : c, a < c ? c : a};
        }
    }
    qsort(all, (size_t)n, sizeof *all, side_order);
    for (int i = 0, k; i < n; i = k) {
        for (k = i + 1; k < n && side_order(&all[i], &all[k]) == 0; k++) {
        }
        CHECK(k - i <= 2);
        const double *x = m->xyz + 3 * all[i].low, *y = m->xyz + 3 * all[i].high;
        sum += k - i == 1 ? hypot(x[0] - y[0], x[1] - y[1]) : 0;
    }
    free(all);
    return sum;
}

static void meshes_fill_the_pixels_and_no_node_hangs(void)
{
    for (uint64_t seed = 1; seed <= 24; seed++) {
        pixel_image p = blobs(17 + (int)seed, 40, seed);
        const double sizes[] = {0, 0, 2.1e-3, 1e-3, 0.4e-3};
        const mesh_options options = {.order = 1 + (int)(seed % 4), .size = sizes[seed % 5]};
        mesh m = {0};
        CHECK_OK(pixel_mesh_make(&p, &options, false, &m));
        CHECK(m.order == options.order);
        CHECK_OK(mesh_check(&m));
        for (int k = 0; k < MOST_MATERIALS; k++) {
            CHECK_WITHIN(mesh_area(&m, k), pixel_area(&p, k), 1e-15);
        }
        CHECK_NEAR(mesh_boundary(&m), pixel_boundary(&p), 1e-12);
        mesh_free(&m);
        pixel_image_free(&p);
    }
}

static void elements_grow_away_from_boundaries(void)
{
    pixel_image p = {0};
    CHECK_OK(pixel_image_make(256, 256, (const double[2]){1, 1}, &p));
    memset(p.at, 0, (size_t)256 * 256 * sizeof *p.at);
    mesh m = {0};
    CHECK_OK(pixel_mesh_make(&p, &(mesh_options){.order = 1, .size = 1e9}, false, &m));
    CHECK(mesh_element_count(&m) == 4); // quarters about the centre
    mesh_free(&m);
    CHECK_OK(pixel_mesh_make(&p, &(mesh_options){.order = 1}, false, &m));
    CHECK(mesh_element_count(&m) == 256); // sixteen across
    mesh_free(&m);
    CHECK_OK(pixel_mesh_make(&p, &(mesh_options){.order = 1, .size = 8}, false, &m));
    CHECK(mesh_element_count(&m) == 1024);
    mesh_free(&m);
    p.at[100 * 256 + 77] = 1;
    CHECK_OK(pixel_mesh_make(&p, &(mesh_options){.order = 1}, false, &m));
    CHECK(mesh_element_count(&m) > 256 && mesh_element_count(&m) < 512);
    CHECK_NEAR(mesh_boundary(&m), 4 * 256, 1e-12);
    mesh_free(&m);
    pixel_image_free(&p);
}

static void pixels_that_touch_at_a_corner_are_not_joined(void)
{
    pixel_image p = {0};
    CHECK_OK(pixel_image_make(2, 2, (const double[2]){1, 1}, &p));
    mesh m = {0};
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 4; i++) {
            p.at[i] = i % 3 == 0 ? (k ? 0 : PIXEL_NONE) : (k ? PIXEL_NONE : 0);
        }
        CHECK_OK(pixel_mesh_make(&p, &(mesh_options){.order = 1}, false, &m));
        CHECK(m.nnode == 8);
        mesh_free(&m);
    }
    pixel_image_free(&p);
}

static void smoothed_meshes_are_sound_whatever_the_image(void)
{
    double worst = 1;
    for (uint64_t seed = 1; seed <= 40; seed++) {
        pixel_image p = seed % 2 ? noise(24, seed) : blobs(40, 40, seed);
        const double size = seed % 5 == 0 ? p.pitch[0] / 3 : 0;
        const mesh_options options = {.order = 1 + (int)(seed % 3), .size = size};
        mesh m = {0};
        double least = 0;
        CHECK_OK(pixel_mesh_make(&p, &options, true, &m));
        CHECK_OK(mesh_check(&m));
        CHECK_OK(mesh_min_jacobian(&m, &least));
        worst = fmin(worst, least);
        mesh_free(&m);
        pixel_image_free(&p);
    }
    printf("smoothed: least det J %.3g of its mean\n", worst);
    CHECK(worst > 0.1);
}

static void corners_move_by_less_than_a_pixel_and_straight_sides_stay(void)
{
    pixel_image p = noise(30, 7);
    double *shift = NULL, most = 0;
    CHECK_OK(pixel_smooth(&p, &shift));
    for (int i = 0; i < 2 * 31 * 31; i++) {
        most = fmax(most, fabs(shift[i]));
    }
    CHECK(most > 0 && most <= 0.5);
    free(shift);
    pixel_image_free(&p);

    CHECK_OK(pixel_image_make(30, 20, (const double[2]){1, 1}, &p));
    for (int j = 3; j < 17; j++) {
        for (int i = 6; i < 26; i++) {
            p.at[j * 30 + i] = i < 15 ? 0 : 1;
        }
    }
    CHECK_OK(pixel_smooth(&p, &shift));
    for (int i = 0; i < 2 * 31 * 21; i++) {
        CHECK_WITHIN(shift[i], 0, 1e-6);
    }
    free(shift);
    pixel_image_free(&p);
}

// a slanted straight edge is straight again, but for its ends
static void stairs_become_a_straight_line(void)
{
    pixel_image p = {0};
    double *shift = NULL, most = 0;
    CHECK_OK(pixel_image_make(90, 40, (const double[2]){1, 1}, &p));
    const double slope = 0.23, rise = 8.3;
    for (int i = 0; i < 90 * 40; i++) {
        p.at[i] = i / 90 + 0.5 < rise + slope * (i % 90 + 0.5) ? 0 : 1;
    }
    CHECK_OK(pixel_smooth(&p, &shift));
    for (int j = 1; j < 40; j++) { // not along the image's own sides
        for (int i = 25; i < 65; i++) {
            const double *s = shift + 2 * (j * 91 + i);
            if (s[0] != 0 || s[1] != 0) {
                const double off = (j + s[1] - rise - slope * (i + s[0])) / hypot(1, slope);
                most = fmax(most, fabs(off));
            }
        }
    }
    printf("a slanted edge: %.3f pixels off the straight line\n", most);
    CHECK(most > 0 && most < 0.1); // stairs: 0.5
    free(shift);
    pixel_image_free(&p);
}

int main(void)
{
    meshes_fill_the_pixels_and_no_node_hangs();
    elements_grow_away_from_boundaries();
    pixels_that_touch_at_a_corner_are_not_joined();
    smoothed_meshes_are_sound_whatever_the_image();
    corners_move_by_less_than_a_pixel_and_straight_sides_stay();
    stairs_become_a_straight_line();
    return test_failures != 0;
}
