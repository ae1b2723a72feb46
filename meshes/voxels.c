#include "meshes/voxels.h"

#include "base/memory.h"
#include "meshes/edges.h"
#include "meshes/pixel_image.h"
#include "meshes/pixel_nodes.h"
#include "meshes/sizing.h"

#include <math.h>
#include <string.h>

// how many squares the image's longer side has at most where no size is asked for: walls of a tenth
// still have four
enum { MOST_ACROSS = 48 };
// rounding of a case's numbers
static const double SAME_SIZE = 1e-9;

// --- squares of whole pixels, or of whole parts of one

// How many pixels make a square, or if negative, how many squares a pixel.
static int choose_factor(const pixel_image *p, double size)
{
    const double pitch = fmax(p->pitch[0], p->pitch[1]);
    const int across = p->n[0] > p->n[1] ? p->n[0] : p->n[1];
    if (!(size > 0)) {
        return (across + MOST_ACROSS - 1) / MOST_ACROSS;
    }
    const double ratio = size / pitch;
    return ratio >= 1 ? (int)fmin(across, floor(ratio * (1 + SAME_SIZE)))
                      : -(int)fmin(1e4, ceil((1 - SAME_SIZE) / ratio));
}

// what most pixels of a square have; of two that are level the later one in the list of materials.
// votes: by material + 1, all 0 before and after
static int majority(const pixel_image *p, int i0, int j0, int factor, int most, int *votes)
{
    int best = PIXEL_NONE;
    for (int k = 0; k < factor * factor; k++) {
        votes[pixel_at(p, i0 + k % factor, j0 + k / factor) + 1]++;
    }
    for (int material = PIXEL_NONE; material <= most; material++) {
        best = votes[material + 1] >= votes[best + 1] ? material : best;
    }
    memset(votes, 0, ((size_t)most + 2) * sizeof *votes);
    return best;
}

static status merge(const pixel_image *p, int factor, pixel_image *out)
{
    status st = OK;
    const double pitch[2] = {factor * p->pitch[0], factor * p->pitch[1]};
    int *votes = NULL, most = PIXEL_NONE;
    for (long i = 0; i < (long)p->n[0] * p->n[1]; i++) {
        most = p->at[i] > most ? p->at[i] : most;
    }
    TRY(TAKE(votes, (size_t)most + 2));
    TRY(pixel_image_make((p->n[0] + factor - 1) / factor, (p->n[1] + factor - 1) / factor, pitch,
                         out));
    memcpy(out->corner, p->corner, sizeof out->corner);
    for (int j = 0; j < out->n[1]; j++) {
        for (int i = 0; i < out->n[0]; i++) {
            out->at[(long)j * out->n[0] + i] =
                (short)majority(p, i * factor, j * factor, factor, most, votes);
        }
    }

done:
    free(votes);
    return st;
}

static status slice_image(const drawing *d, int slice, double size, pixel_image *out)
{
    status st = OK;
    pixel_image p = {0};
    bool found = false;
    TRY(drawing_pixels(d, slice, &p, &found));
    if (!found) {
        TRY(status_fail(ERR_INPUT, "section: only images have voxels"));
    }
    const int factor = choose_factor(&p, size);
    if (factor < -1 && (double)factor * factor * p.n[0] * p.n[1] > SECTION_MOST_ELEMENTS * 10.0) {
        TRY(status_fail(ERR_INPUT, "mesh: voxels of %g mm are too small for %d x %d pixels",
                        1e3 * size, p.n[0], p.n[1]));
    }
    if (factor == 1 || factor == -1) {
        *out = p;
        p = (pixel_image){0};
    } else {
        TRY(factor > 1 ? merge(&p, factor, out) : pixel_image_finer(&p, -factor, out));
    }

done:
    pixel_image_free(&p);
    return st;
}

// --- the plane mesh

// all places where any slice has matter; material 0, as a slice says what is there
static status unite(const drawing *d, const voxel_request *ask, pixel_image *all)
{
    status st = OK;
    pixel_image next = {0};
    for (int k = ask->first; k <= ask->last; k++) {
        TRY(slice_image(d, k, ask->size, &next));
        if (k == ask->first) {
            *all = next;
            next = (pixel_image){0};
            continue;
        }
        for (long i = 0; i < (long)all->n[0] * all->n[1]; i++) {
            all->at[i] = all->at[i] != PIXEL_NONE ? all->at[i] : next.at[i];
        }
        pixel_image_free(&next);
    }

done:
    pixel_image_free(&next);
    return st;
}

static int corner_number(const pixel_image *p, int *number, straight_cells *cells, int i, int j)
{
    int *n = &number[(long)j * (p->n[0] + 1) + i];
    if (*n == 0) {
        double *xy = cells->xy + 2 * (size_t)cells->npoint;
        xy[0] = p->corner[0] + p->pitch[0] * i;
        xy[1] = p->corner[1] + p->pitch[1] * j;
        *n = ++cells->npoint;
    }
    return *n - 1;
}

static status make_cells(const pixel_image *p, straight_cells *cells)
{
    status st = OK;
    int *number = NULL;
    const size_t ncorner = ((size_t)p->n[0] + 1) * ((size_t)p->n[1] + 1);
    const size_t npixel = (size_t)p->n[0] * (size_t)p->n[1];
    TRY(TAKE(number, ncorner));
    TRY(TAKE(cells->xy, 2 * ncorner));
    TRY(TAKE(cells->corner[1], 4 * npixel));
    TRY(TAKE(cells->material[1], npixel));
    for (int j = 0; j < p->n[1]; j++) {
        for (int i = 0; i < p->n[0]; i++) {
            if (pixel_at(p, i, j) == PIXEL_NONE) {
                continue;
            }
            const int at = cells->ncell[1]++;
            int *corner = cells->corner[1] + 4 * at;
            for (int k = 0; k < 4; k++) {
                corner[k] = corner_number(p, number, cells, i + (k == 1 || k == 2), j + (k >= 2));
            }
            cells->material[1][at] = pixel_at(p, i, j);
        }
    }

done:
    free(number);
    return st;
}

status voxel_plane(const drawing *d, const voxel_request *ask, mesh *out)
{
    status st = OK;
    pixel_image all = {0};
    straight_cells cells = {0};
    TRY(unite(d, ask, &all));
    TRY(make_cells(&all, &cells));
    if (cells.ncell[1] < 1) {
        TRY(status_fail(ERR_INPUT,
                        "mesh: voxels of %g mm leave nothing of the slices, they are to "
                        "be smaller",
                        1e3 * ask->size));
    }
    if (cells.ncell[1] > SECTION_MOST_ELEMENTS) {
        TRY(status_fail(ERR_INPUT, "mesh: the slices make %d squares, at most %d are possible",
                        cells.ncell[1], SECTION_MOST_ELEMENTS));
    }
    TRY(straight_cells_mesh(&cells, ask->order, out));

done:
    pixel_image_free(&all);
    straight_cells_free(&cells);
    return st;
}

// --- matter

// the middle of an element and the length of its first edge, in the image's own axes
static void find_square(const mesh *plane, int e, double turn, double scale, double *middle,
                        double *edge)
{
    const int p = plane->order;
    const int *conn = plane->block[0].conn + (size_t)e * (size_t)plane->block[0].per_elem;
    const double *a = plane->xyz + 3 * (size_t)conn[0], *b = plane->xyz + 3 * (size_t)conn[p];
    const double *c = plane->xyz + 3 * (size_t)conn[(p + 1) * (p + 1) - 1];
    const double x = (a[0] + c[0]) / 2, y = (a[1] + c[1]) / 2;
    middle[0] = (cos(turn) * x + sin(turn) * y) / scale;
    middle[1] = (cos(turn) * y - sin(turn) * x) / scale;
    *edge = hypot(b[0] - a[0], b[1] - a[1]) / scale;
}

status voxel_matter(const drawing *d, int slice, const mesh *plane, double turn, double scale,
                    int *matter)
{
    status st = OK;
    pixel_image p = {0};
    double middle[2], edge = 0;
    bool found = false;
    TRY(drawing_pixels(d, slice, &p, &found));
    find_square(plane, 0, turn, scale, middle, &edge);
    // the edge is along x; sizes go by the longer side of a pixel
    const double size = found ? edge * fmax(1, p.pitch[1] / p.pitch[0]) : edge;
    pixel_image_free(&p);
    TRY(slice_image(d, slice, size, &p));
    for (int e = 0; e < plane->block[0].nelem; e++) {
        find_square(plane, e, turn, scale, middle, &edge);
        matter[e] = pixel_at(&p, (int)floor((middle[0] - p.corner[0]) / p.pitch[0]),
                             (int)floor((middle[1] - p.corner[1]) / p.pitch[1]));
    }

done:
    pixel_image_free(&p);
    return st;
}

// --- what hangs together

typedef struct flood {
    int nelem, nlayer;
    const int *matter;
    int (*beside)[4]; // [nelem] elements across the sides, -1: none
    bool *reached;    // [nlayer][nelem]
    size_t *todo, count;
} flood;

static void reach(flood *f, int layer, int e)
{
    const size_t at = (size_t)layer * (size_t)f->nelem + (size_t)e;
    if (f->matter[at] >= 0 && !f->reached[at]) {
        f->reached[at] = true;
        f->todo[f->count++] = at;
    }
}

static status find_neighbours(const mesh *plane, flood *f)
{
    status st = OK;
    edge_list edges = {0};
    int nside = 0, *corner = NULL, *first = NULL;
    TRY(mesh_corners(plane, &nside, &corner));
    TRY(edge_list_make(f->nelem, nside, corner, &edges));
    TRY(TAKE(first, (size_t)edges.nedge)); // a side that an edge was met at, from 1
    TRY(TAKE(f->beside, (size_t)f->nelem));
    for (int k = 0; k < 4 * f->nelem; k++) {
        const int edge = edges.of[k], other = first[edge] - 1;
        f->beside[k / 4][k % 4] = -1;
        if (other >= 0) {
            f->beside[k / 4][k % 4] = other / 4;
            f->beside[other / 4][other % 4] = k / 4;
        }
        first[edge] = k + 1;
    }

done:
    free(corner);
    free(first);
    edge_list_free(&edges);
    return st;
}

static void flood_all(flood *f)
{
    for (int e = 0; e < f->nelem; e++) {
        reach(f, 0, e);
    }
    for (size_t done = 0; done < f->count; done++) {
        const int layer = (int)(f->todo[done] / (size_t)f->nelem);
        const int e = (int)(f->todo[done] % (size_t)f->nelem);
        for (int k = 0; k < 4; k++) {
            if (f->beside[e][k] >= 0) {
                reach(f, layer, f->beside[e][k]);
            }
        }
        for (int step = -1; step <= 1; step += 2) {
            if (layer + step >= 0 && layer + step < f->nlayer) {
                reach(f, layer + step, e);
            }
        }
    }
}

// nothing apart, and no layer empty
static status check_layer(const mesh *plane, const flood *f, int layer, int slice)
{
    int solid = 0;
    for (int e = 0; e < f->nelem; e++) {
        const size_t at = (size_t)layer * (size_t)f->nelem + (size_t)e;
        solid += f->matter[at] >= 0;
        if (f->matter[at] >= 0 && !f->reached[at]) {
            double middle[2], edge;
            find_square(plane, e, 0, 1, middle, &edge);
            return status_fail(
                ERR_INPUT,
                "section: in slice %d from the base, as voxels of %.4g mm, what is at x = %.4g "
                "mm, y = %.4g mm does not hang together with the base",
                slice + 1, 1e3 * edge, 1e3 * middle[0], 1e3 * middle[1]);
        }
    }
    return solid > 0 ? OK
                     : status_fail(ERR_INPUT,
                                   "section: slice %d from the base has no voxel "
                                   "left, they are too large for it",
                                   slice + 1);
}

status voxel_check(const mesh *plane, int nlayer, const int *matter, const int *slice_of)
{
    status st = OK;
    flood f = {.nelem = plane->block[0].nelem, .nlayer = nlayer, .matter = matter};
    const size_t n = (size_t)f.nelem * (size_t)nlayer;
    TRY(find_neighbours(plane, &f));
    TRY(TAKE(f.reached, n));
    TRY(TAKE(f.todo, n));
    flood_all(&f);
    for (int layer = 0; layer < nlayer; layer++) {
        TRY(check_layer(plane, &f, layer, slice_of[layer]));
    }

done:
    free(f.beside);
    free(f.reached);
    free(f.todo);
    return st;
}
