#include "meshes/pixel_mesh.h"

#include "base/memory.h"
#include "meshes/pixel_nodes.h"
#include "meshes/pixel_smooth.h"
#include "meshes/pixel_tree.h"
#include "meshes/sizing.h"

#include <math.h>

// How many squares the image's longer side has at least where the case gives no size: elements of
// order 2 on fewer are worse than most images.
enum { LEAST_ACROSS = 16 };

// the finest raster that a small mesh size may ask for
static const double most_fine_pixels = 1 << 24;

// --- a square as quadrangles and triangles

enum { CENTRE = 8, MOST_PIECES = 4 };

// Points of a square: corners 0..3 counter-clockwise from the lower left, 4..7 the middles of its
// sides from below, 8 its centre. By which sides are divided, up to turns.
typedef struct pattern {
    int sides; // bit k: side k is divided
    int nquad, ntriangle;
    int quad[MOST_PIECES][4], triangle[MOST_PIECES][3];
} pattern;

static const pattern patterns[] = {
    {.sides = 0, .nquad = 1, .quad = {{0, 1, 2, 3}}},
    {.sides = 1, .ntriangle = 3, .triangle = {{0, 4, 3}, {4, 1, 2}, {4, 2, 3}}},
    {.sides = 3, .ntriangle = 4, .triangle = {{0, 4, 3}, {4, 1, 5}, {4, 5, 3}, {5, 2, 3}}},
    {.sides = 5, .nquad = 2, .quad = {{0, 4, 6, 3}, {4, 1, 2, 6}}},
    {.sides = 7,
     .nquad = 1,
     .quad = {{0, 4, 6, 3}},
     .ntriangle = 3,
     .triangle = {{4, 1, 5}, {5, 2, 6}, {4, 5, 6}}},
    {.sides = 15, .nquad = 4, .quad = {{0, 4, 8, 7}, {4, 1, 5, 8}, {8, 5, 2, 6}, {7, 8, 6, 3}}},
};

// the pattern of these sides, and by how many quarter turns
static const pattern *find_pattern(int sides, int *turn)
{
    for (*turn = 0; *turn < 4; ++*turn) {
        const int turned = (sides >> *turn | sides << (4 - *turn)) & 15;
        for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++) {
            if (patterns[i].sides == turned) {
                return &patterns[i];
            }
        }
    }
    return &patterns[0]; // never: every set of sides is a turn of one above
}

static int turned_point(int point, int turn)
{
    return point == CENTRE ? CENTRE : point / 4 * 4 + (point + turn) % 4;
}

// --- points

typedef struct builder {
    const pixel_image *image; // fine
    const pixel_image *whole; // as it was given
    double *shift;            // of the corners of `whole`, in pixels; NULL: none
    int factor;               // fine pixels in a pixel
    const pixel_tree *tree;
    int *number; // [n[1] + 1][n[0] + 1] of a corner of pixels, + 1
    int *twin;   // the same for the pixels on its left where they are not joined to the right ones
    straight_cells cells;
} builder;

// Two pixels touch at this corner only: what lies to its left is not joined to the right.
static bool parts_meet(const pixel_image *p, int i, int j)
{
    const int ll = pixel_at(p, i - 1, j - 1), lr = pixel_at(p, i, j - 1);
    const int ul = pixel_at(p, i - 1, j), ur = pixel_at(p, i, j);
    const bool rising = ll != PIXEL_NONE && ur != PIXEL_NONE,
               none_rising = ll == ur && ll == PIXEL_NONE;
    const bool falling = ul != PIXEL_NONE && lr != PIXEL_NONE,
               none_falling = ul == lr && ul == PIXEL_NONE;
    return (rising && none_falling) || (falling && none_rising);
}

// Weights of a pixel's corners at (u, v) in it: of the triangle, where it is cut in two, or else
// bilinear.
static void corner_weights(const double (*shift)[2], double u, double v, double weight[4])
{
    double xy[4][2];
    for (int k = 0; k < 4; k++) {
        xy[k][0] = (k == 1 || k == 2) + shift[k][0];
        xy[k][1] = (k >= 2) + shift[k][1];
    }
    const cell_cut cut = cell_cut_of((const double(*)[2])xy);
    const double both = cut == CUT_FIRST    ? fmin(u, v)
                        : cut == CUT_SECOND ? fmax(0, u + v - 1)
                                            : u * v;
    weight[0] = 1 - u - v + both;
    weight[1] = u - both;
    weight[2] = both;
    weight[3] = v - both;
}

// how far a corner of fine pixels is moved, in pixels: between the corners of its pixel
static void shift_at(const builder *w, int i, int j, double out[2])
{
    const pixel_image *p = w->whole;
    const int a = i / w->factor - (i == w->image->n[0]), b = j / w->factor - (j == w->image->n[1]);
    const double u = (double)i / w->factor - a, v = (double)j / w->factor - b;
    double corner[4][2], weight[4];
    out[0] = out[1] = 0;
    if (!w->shift) {
        return;
    }
    for (int k = 0; k < 4; k++) {
        const int x = a + (k == 1 || k == 2), y = b + (k >= 2);
        const double *s = w->shift + 2 * ((long)y * (p->n[0] + 1) + x);
        corner[k][0] = s[0];
        corner[k][1] = s[1];
    }
    corner_weights((const double(*)[2])corner, u, v, weight);
    for (int k = 0; k < 4; k++) {
        out[0] += weight[k] * corner[k][0];
        out[1] += weight[k] * corner[k][1];
    }
}

// the point at a corner of pixels for the square that begins at column `left`
static int point_at(builder *w, int i, int j, int left)
{
    const pixel_image *p = w->image;
    const long at = (long)j * (p->n[0] + 1) + i;
    int *number = left < i && parts_meet(p, i, j) ? &w->twin[at] : &w->number[at];
    if (*number == 0) {
        double shift[2], *xy = w->cells.xy + 2 * w->cells.npoint;
        shift_at(w, i, j, shift);
        xy[0] = p->corner[0] + p->pitch[0] * i + w->whole->pitch[0] * shift[0];
        xy[1] = p->corner[1] + p->pitch[1] * j + w->whole->pitch[1] * shift[1];
        *number = ++w->cells.npoint;
    }
    return *number - 1;
}

// --- cells

static void add_cell(builder *w, int kind, const int *local, const int *point, int turn,
                     int material)
{
    const int nside = 3 + kind, at = w->cells.ncell[kind]++;
    for (int k = 0; k < nside; k++) {
        w->cells.corner[kind][at * nside + k] = point[turned_point(local[k], turn)];
    }
    w->cells.material[kind][at] = material;
}

// a single pixel whose corners may have moved
static void add_pixel(builder *w, const int *point, int material)
{
    static const int quad[4] = {0, 1, 2, 3}, triangle[2][3] = {{0, 1, 2}, {0, 2, 3}};
    double xy[4][2];
    for (int k = 0; k < 4; k++) {
        for (int d = 0; d < 2; d++) {
            xy[k][d] = w->cells.xy[2 * point[k] + d] / w->image->pitch[d];
        }
    }
    const cell_cut cut = w->shift ? cell_cut_of((const double(*)[2])xy) : CUT_NOT;
    if (cut == CUT_NOT) {
        add_cell(w, 1, quad, point, 0, material);
        return;
    }
    for (int k = 0; k < 2; k++) {
        add_cell(w, 0, triangle[k], point, cut == CUT_FIRST ? 0 : 1, material);
    }
}

static void add_square(builder *w, int i, int j, int size)
{
    const int half = size / 2;
    const int place[9][2] = {{0, 0},       {size, 0},    {size, size}, {0, size},   {half, 0},
                             {size, half}, {half, size}, {0, half},    {half, half}};
    int point[9] = {0}, sides = 0, turn = 0;
    for (int k = 0; k < 4; k++) {
        sides |= pixel_tree_split(w->tree, i, j, size, k) << k;
    }
    for (int k = 0; k < 9; k++) {
        if (k < 4 || (k < CENTRE && sides >> (k - 4) & 1) || (k == CENTRE && sides == 15)) {
            point[k] = point_at(w, i + place[k][0], j + place[k][1], i);
        }
    }
    const int material = pixel_at(w->image, i, j);
    if (size == 1) {
        add_pixel(w, point, material);
        return;
    }
    const pattern *how = find_pattern(sides, &turn);
    for (int k = 0; k < how->nquad; k++) {
        add_cell(w, 1, how->quad[k], point, turn, material);
    }
    for (int k = 0; k < how->ntriangle; k++) {
        add_cell(w, 0, how->triangle[k], point, turn, material);
    }
}

static status build_cells(builder *w)
{
    status st = OK;
    const size_t most = (size_t)w->tree->nleaf;
    const int *n = w->image->n;
    int size = 0;

    TRY(TAKE(w->number, ((size_t)n[0] + 1) * ((size_t)n[1] + 1)));
    TRY(TAKE(w->twin, ((size_t)n[0] + 1) * ((size_t)n[1] + 1)));
    TRY(TAKE(w->cells.xy, 2 * 9 * most));
    for (int kind = 0; kind < 2; kind++) {
        TRY(TAKE(w->cells.corner[kind], MOST_PIECES * most * (size_t)(3 + kind)));
        TRY(TAKE(w->cells.material[kind], MOST_PIECES * most));
    }
    for (int j = 0; j < n[1]; j++) {
        for (int i = 0; i < n[0]; i++) {
            if (pixel_tree_leaf(w->tree, i, j, &size)) {
                add_square(w, i, j, size);
            }
        }
    }

done:
    return st;
}

// --- sizes

// how many fine pixels to a pixel, and how large squares may become
static status choose_sizes(const pixel_image *p, const mesh_options *options, int *factor, int *top)
{
    const double pitch = fmax(p->pitch[0], p->pitch[1]);
    *factor = 1;
    *top = 0;
    if (!(options->size > 0)) {
        while (2 << *top <= (p->n[0] > p->n[1] ? p->n[0] : p->n[1]) / LEAST_ACROSS) {
            ++*top;
        }
        return OK;
    }
    const double parts = ceil(pitch / options->size * (1 - 1e-9));
    if (parts * parts * p->n[0] * p->n[1] > most_fine_pixels) {
        return status_fail_at(ERR_INPUT, options->at.line, options->at.column,
                              "mesh: a size of %g m is too small for %d x %d pixels of %g m",
                              options->size, p->n[0], p->n[1], pitch);
    }
    *factor = (int)parts;
    *top = (int)fmin(30, floor(log2(options->size * (1 + 1e-9) * parts / pitch)));
    return OK;
}

status pixel_mesh_make(const pixel_image *p, const mesh_options *options, bool smoothed, mesh *out)
{
    status st = OK;
    pixel_image fine = {0};
    pixel_tree tree = {0};
    pixel_tree_rule rule = {0};
    builder w = {.whole = p, .image = p, .tree = &tree};

    TRY(choose_sizes(p, options, &w.factor, &rule.top));
    if (w.factor > 1) {
        TRY(pixel_image_finer(p, w.factor, &fine));
        w.image = &fine;
    }
    rule.rim = smoothed ? w.factor : 0;
    TRY(pixel_tree_make(w.image, &rule, &tree));
    if (tree.nleaf > SECTION_MOST_ELEMENTS) {
        TRY(status_fail_at(ERR_INPUT, options->at.line, options->at.column,
                           "the image makes %d elements, at most %d are possible: use larger "
                           "pixels or a larger mesh size",
                           tree.nleaf, SECTION_MOST_ELEMENTS));
    }
    if (smoothed) {
        TRY(pixel_smooth(p, &w.shift));
    }
    TRY(build_cells(&w));
    TRY(straight_cells_mesh(&w.cells, options->order, out));

done:
    free(w.number);
    free(w.twin);
    free(w.shift);
    straight_cells_free(&w.cells);
    pixel_tree_free(&tree);
    pixel_image_free(&fine);
    return st;
}
