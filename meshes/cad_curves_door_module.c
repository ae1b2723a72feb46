// meshes/cad_curves_door_module.c
// Our places of nodes on the curves of a file. gmsh spaces an edge's nodes equally, and a
// polynomial through them strays from an arc a by a^(p+1) or a^(p+2); through Gauss-Lobatto points
// of the curve itself by a^(2p). Of the gmsh module.
#include "base/element.h"
#include "base/memory.h"

#include <gmshc.h>
#include <math.h>

#include "meshes/gmsh_kit.h"

typedef struct on_curve {
    const cad_request *r;
    const int *index; // of nodes by gmsh's tags
    size_t nindex;
    int curve;
    double low, high; // of its parameter
    double *at;       // [nindex] parameter of nodes inside the curve, by gmsh's tags; NaN
    double *exact;    // [nnode][3]
} on_curve;

static double lagrange(int p, int k, double t)
{
    double N = 1;
    for (int i = 0; i <= p; i++) {
        N *= i == k ? 1 : (p * t - i) / (k - i);
    }
    return N;
}

// Parameters of an edge's nodes, in order. A corner of the curve has the bound that is nearer to
// its neighbour, since a closed curve's corner has both.
static bool edge_parameters(const on_curve *c, int p, const size_t *conn, double *u)
{
    for (int i = 0; i <= p; i++) {
        const size_t tag = i == 0 ? conn[0] : i == p ? conn[1] : conn[i + 1];
        if (tag >= c->nindex || c->index[tag] < 0) {
            return false;
        }
        u[i] = c->at[tag];
    }
    for (int end = 0; end <= p; end += p) {
        const double next = u[end == 0 ? 1 : p - 1];
        if (isnan(u[end])) {
            u[end] = fabs(next - c->low) < fabs(next - c->high) ? c->low : c->high;
        }
    }
    for (int i = 1; i <= p; i++) {
        if (!((u[i] - u[i - 1]) * (u[p] - u[0]) > 0)) {
            return false;
        }
    }
    return true;
}

static status place_edge(const on_curve *c, int p, const size_t *conn)
{
    status st = OK;
    double u[ELEMENT_MAX_ORDER + 1], t[ELEMENT_MAX_ORDER + 1], wanted[ELEMENT_MAX_ORDER + 1] = {0};
    double *x = NULL;
    size_t nx = 0;
    if (!edge_parameters(c, p, conn, u)) {
        return OK; // the polynomial stays
    }
    gauss_lobatto_nodes(p + 1, t);
    for (int i = 1; i < p; i++) {
        for (int k = 0; k <= p; k++) {
            wanted[i] += lagrange(p, k, (t[i] + 1) / 2) * u[k];
        }
    }
    CAD_TRY(gmshModelGetValue(CURVE, c->curve, wanted + 1, (size_t)p - 1, &x, &nx, &ierr));
    for (int i = 1; i < p && nx == 3 * ((size_t)p - 1); i++) {
        double *to = c->exact + 3 * (size_t)c->index[conn[i + 1]];
        cad_to_section(c->r, x + 3 * (i - 1), to);
    }

done:
    gmshFree(x);
    return st;
}

static status take_parameters(on_curve *c)
{
    status st = OK;
    size_t *tags = NULL, n = 0, nx = 0, nu = 0, nlow = 0, nhigh = 0;
    double *x = NULL, *u = NULL, *low = NULL, *high = NULL;
    CAD_TRY(gmshModelMeshGetNodes(&tags, &n, &x, &nx, &u, &nu, CURVE, c->curve, 0, 1, &ierr));
    CAD_TRY(gmshModelGetParametrizationBounds(CURVE, c->curve, &low, &nlow, &high, &nhigh, &ierr));
    c->low = nlow == 1 ? low[0] : NAN;
    c->high = nhigh == 1 ? high[0] : NAN;
    for (size_t i = 0; i < n && nu == n; i++) {
        if (tags[i] < c->nindex) {
            c->at[tags[i]] = u[i];
        }
    }

done:
    gmshFree(tags);
    gmshFree(x);
    gmshFree(u);
    gmshFree(low);
    gmshFree(high);
    return st;
}

static status place_curve(on_curve *c)
{
    status st = OK;
    const int p = c->r->order;
    int type = 0;
    size_t *tags = NULL, ntag = 0, *conn = NULL, nconn = 0;
    CAD_TRY(type = gmshModelMeshGetElementType("line", p, 0, &ierr));
    CAD_TRY(
        gmshModelMeshGetElementsByType(type, &tags, &ntag, &conn, &nconn, c->curve, 0, 1, &ierr));
    TRY(take_parameters(c));
    for (size_t i = 0; i < ntag && nconn == ntag * (size_t)(p + 1); i++) {
        TRY(place_edge(c, p, conn + i * (size_t)(p + 1)));
    }

done:
    gmshFree(tags);
    gmshFree(conn);
    return st;
}

status cad_place_on_curves(const cad_request *r, const int *index, size_t nindex, cad_pieces *out)
{
    status st = OK;
    on_curve c = {.r = r, .index = index, .nindex = nindex};
    int *curves = NULL;
    size_t n = 0;
    if (r->order <= 2) {
        return OK; // both kinds of nodes are the same
    }
    TRY(TAKE(c.at, nindex));
    TRY(TAKE(out->exact, 3 * (size_t)out->nnode));
    out->nexact = 3 * out->nnode;
    c.exact = out->exact;
    for (size_t i = 0; i < nindex; i++) {
        c.at[i] = NAN;
    }
    for (int i = 0; i < out->nexact; i++) {
        out->exact[i] = NAN;
    }
    CAD_TRY(gmshModelGetEntities(&curves, &n, CURVE, &ierr));
    for (size_t i = 0; i < n; i += 2) {
        c.curve = curves[i + 1];
        TRY(place_curve(&c));
    }

done:
    gmshFree(curves);
    free(c.at);
    return st;
}
