// meshes/cad_sizes_door_module.c
// How finely faces of a STEP file's section are divided. Of the gmsh module.
#include <gmshc.h>
#include <math.h>

#include "meshes/gmsh_kit.h"

enum { PROBES = 33 };

// a curve's length, and the number of edges that its bends need
static status measure(int curve, double angle, double *length, double *bends)
{
    status st = OK;
    double *low = NULL, *high = NULL, *x = NULL, t[PROBES], most = 0;
    size_t nlow = 0, nhigh = 0, nx = 0;
    *length = *bends = 0;
    CAD_TRY(gmshModelGetParametrizationBounds(CURVE, curve, &low, &nlow, &high, &nhigh, &ierr));
    for (int i = 0; i < PROBES && nlow == 1 && nhigh == 1; i++) {
        t[i] = low[0] + (high[0] - low[0]) * i / (PROBES - 1);
    }
    CAD_TRY(gmshModelGetValue(CURVE, curve, t, PROBES, &x, &nx, &ierr));
    for (size_t i = 3; i + 3 <= nx; i += 3) {
        const double d[3] = {x[i] - x[i - 3], x[i + 1] - x[i - 2], x[i + 2] - x[i - 1]};
        const double step = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        *length += step;
        if (i + 6 <= nx) {
            const double e[3] = {x[i + 3] - x[i], x[i + 4] - x[i + 1], x[i + 5] - x[i + 2]};
            const double next = sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
            const double cosine = (d[0] * e[0] + d[1] * e[1] + d[2] * e[2]) / (step * next);
            const double turn = acos(fmin(1, fmax(-1, cosine)));
            most = turn / fmin(step, next) > most ? turn / fmin(step, next) : most;
        }
    }
    *bends = most * *length / angle;

done:
    gmshFree(low);
    gmshFree(high);
    gmshFree(x);
    return st;
}

static status divide_curves(const cad_request *r, double length)
{
    status st = OK;
    int *curves = NULL;
    size_t n = 0;
    double all = 0;
    CAD_TRY(gmshModelGetEntities(&curves, &n, CURVE, &ierr));
    for (size_t i = 0; i < n; i += 2) {
        double along = 0, bends = 0;
        TRY(measure(curves[i + 1], r->angle, &along, &bends));
        const double parts = fmax(1, ceil(fmax(along / length, bends) - 1e-6));
        all += parts;
        if (!(all <= r->most_elements)) {
            TRY(status_fail(ERR_INPUT, "mesh: its size asks for more than %d elements",
                            r->most_elements));
        }
        CAD_TRY(gmshModelMeshSetTransfiniteCurve(curves[i + 1], (int)parts + 1, "Progression", 1,
                                                 &ierr));
    }

done:
    gmshFree(curves);
    return st;
}

status cad_set_sizes(const cad_request *r, int nface, const int *face)
{
    status st = OK;
    double low[3], high[3], size = 0, area = 0, all = 0;
    CAD_TRY(gmshModelGetBoundingBox(-1, -1, &low[0], &low[1], &low[2], &high[0], &high[1], &high[2],
                                    &ierr));
    for (int i = 0; i < 3; i++) {
        size = hypot(size, (high[i] - low[i]) / 2);
    }
    const double length = r->length > 0 ? r->length : r->part * size;
    for (int k = 0; k < nface; k++) {
        CAD_TRY(gmshModelOccGetMass(FACE, face[k], &area, &ierr));
        all += area;
    }
    if (!(all < 0.4 * length * length * r->most_elements)) {
        TRY(status_fail(ERR_INPUT, "mesh: its size asks for more than %d elements",
                        r->most_elements));
    }
    CAD_TRY(gmshOptionSetNumber("Mesh.MeshSizeMax", length, &ierr));
    TRY(divide_curves(r, length));

done:
    return st;
}
