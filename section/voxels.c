#include "section/voxels.h"

#include "base/memory.h"
#include "meshes/voxels.h"

#include <math.h>

// a body may be longer than its stack, and begin or end beside a slice's face, by this part of a
// slice: rounding of the case's numbers
static const double SAME_FACE = 1e-9;
// more layers than this come from a mistake of unit
static const double MOST_LAYERS = 1e6;

bool section_is_stack(const section_case *c)
{
    return section_own_length(c) > 0;
}

static status check(const section_case *c, double to)
{
    const double own = section_own_length(c);
    if (to > own * (1 + SAME_FACE)) {
        return status_fail(ERR_INPUT,
                           "section: the stack of %d slices is %.6g mm thick, %.6g mm are needed",
                           drawing_slice_count(c->drawing), 1e3 * own, 1e3 * to);
    }
    if (field_varies(&c->turn) || field_varies(&c->scale)) {
        return status_fail(ERR_INPUT, "section: turn and scale of a stack cannot vary along s");
    }
    return OK;
}

static double thickness(const section_case *c)
{
    return section_own_length(c) / drawing_slice_count(c->drawing);
}

// a slice's number, by a place on its lower face or in it
static int slice_from(const section_case *c, double s)
{
    return (int)floor(s / thickness(c) + SAME_FACE);
}

static int slice_to(const section_case *c, double s)
{
    const int k = (int)ceil(s / thickness(c) - SAME_FACE) - 1;
    const int last = drawing_slice_count(c->drawing) - 1;
    return k < last ? k : last;
}

status section_voxel_layers(const section_case *c, double from, double to, double longest,
                            int *nlayer, double **layer)
{
    status st = OK;
    double *s = NULL;
    const double thick = thickness(c);
    TRY(check(c, to));
    const int first = slice_from(c, from), last = slice_to(c, to);
    const double parts = fmax(1, ceil(thick / longest * (1 - SAME_FACE)));
    if (!(parts * (last - first + 1) <= MOST_LAYERS)) {
        TRY(status_fail(ERR_INPUT, "section: layers of %g mm are too many for the stack",
                        1e3 * longest));
    }
    TRY(TAKE(s, (size_t)parts * (size_t)(last - first + 1) + 1));
    *nlayer = 0;
    for (int k = first; k <= last; k++) {
        const double begin = fmax(k * thick, from), end = k == last ? to : (k + 1) * thick;
        for (int i = 0; i < (int)parts; i++) {
            s[(*nlayer)++] = begin + (end - begin) * i / parts - from;
        }
    }
    s[0] = 0;
    s[*nlayer] = to - from;
    *layer = s;
    s = NULL;

done:
    free(s);
    return st;
}

static void move(mesh *m, double turn, double scale)
{
    const double c = scale * cos(turn), s = scale * sin(turn);
    for (int i = 0; i < m->nnode; i++) {
        double *x = m->xyz + 3 * (size_t)i;
        const double a = x[0], b = x[1];
        x[0] = c * a - s * b;
        x[1] = s * a + c * b;
    }
}

status section_voxel_plane(const section_case *c, double from, double to,
                           const mesh_options *options, mesh *out)
{
    status st = OK;
    const double scale = field_at(&c->scale, from);
    const voxel_request ask = {.first = slice_from(c, from),
                               .last = slice_to(c, to),
                               .order = options->order,
                               .size = options->size / scale};
    TRY(check(c, to));
    TRY(voxel_plane(c->drawing, &ask, out));
    move(out, field_at(&c->turn, from), scale);

done:
    return st;
}

status section_voxel_matter(const section_case *c, double from, int nlayer, const double *layer,
                            const mesh *plane, int **matter)
{
    status st = OK;
    int *all = NULL, *slice = NULL;
    const double turn = field_at(&c->turn, from), scale = field_at(&c->scale, from);
    const size_t nelem = (size_t)mesh_element_count(plane);
    TRY(TAKE(all, (size_t)nlayer * nelem));
    TRY(TAKE(slice, (size_t)nlayer));
    for (int k = 0; k < nlayer; k++) {
        slice[k] = slice_from(c, from + (layer[k] + layer[k + 1]) / 2);
        if (k > 0 && slice[k] == slice[k - 1]) {
            for (size_t e = 0; e < nelem; e++) {
                all[(size_t)k * nelem + e] = all[(size_t)(k - 1) * nelem + e];
            }
            continue;
        }
        TRY(voxel_matter(c->drawing, slice[k], plane, turn, scale, all + (size_t)k * nelem));
    }
    TRY(voxel_check(plane, nlayer, all, slice));
    *matter = all;
    all = NULL;

done:
    free(all);
    free(slice);
    return st;
}
