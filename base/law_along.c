// base/law_along.c
#include "base/law_along.h"

#include "base/chebyshev.h"
#include "base/memory.h"

#include <math.h>

static const double half_pi = 1.57079632679489661923;

_Static_assert((int)LAW_ALONG_MAX_NODES <= (int)CHEBYSHEV_MAX_NODES, "nodes of a panel");

status law_along_make(double length, int npanel, int nnode, law_along *out)
{
    status st = OK;
    law_along a = {.length = length, .npanel = npanel, .nnode = nnode};
    if (!(length > 0) || npanel < 1 || nnode < 1 || nnode > LAW_ALONG_MAX_NODES) {
        TRY(status_fail(ERR_BUG, "law along the rod: %d panels of %d nodes over %g m", npanel,
                        nnode, length));
    }
    TRY(TAKE(a.edge, (size_t)npanel + 1));
    TRY(TAKE(a.law, (size_t)npanel * (size_t)nnode));
    TRY(TAKE(a.turn, (size_t)npanel * (size_t)nnode));
    for (int k = 0; k <= npanel; k++) {
        a.edge[k] = k == npanel ? length : length * k / npanel;
    }
    *out = a; // ownership passes only when all is well
    a = (law_along){0};

done:
    law_along_free(&a);
    return st;
}

void law_along_free(law_along *along)
{
    free(along->edge);
    free(along->law);
    free(along->turn);
    *along = (law_along){0};
}

double law_along_node(const law_along *along, int panel, int i)
{
    const double a = along->edge[panel], b = along->edge[panel + 1];
    if (i == 0 && along->nnode > 1) {
        return a;
    }
    if (i == along->nnode - 1 && along->nnode > 1) {
        return b;
    }
    return (a + b) / 2 + (b - a) / 2 * chebyshev_node(along->nnode, i);
}

// K and the turn of the pattern by the panel's interpolant, in the turned frame
typedef struct local_law {
    mat6 K, dK;
    double turn, dturn;
} local_law;

static int panel_of(const law_along *along, double s)
{
    int low = 0, high = along->npanel;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (s < along->edge[middle]) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return low;
}

// Of the panel at s, clipped to the rod, what each node counts: for the value and, where slope is
// not NULL, for the derivative along s. The panel's first node.
static int node_weights(const law_along *along, double s, double *value, double *slope)
{
    const double clipped = fmin(fmax(s, 0), along->length);
    const int panel = panel_of(along, clipped), n = along->nnode;
    const double a = along->edge[panel], b = along->edge[panel + 1];
    chebyshev_weights(n, (2 * clipped - a - b) / (b - a), value, slope);
    for (int i = 0; i < n && slope; i++) {
        slope[i] *= 2 / (b - a);
    }
    return panel * n;
}

static local_law interpolate(const law_along *along, double s, bool slopes)
{
    double value[LAW_ALONG_MAX_NODES], slope[LAW_ALONG_MAX_NODES] = {0};
    const int first = node_weights(along, s, value, slopes ? slope : NULL);

    local_law l = {0};
    for (int i = 0; i < along->nnode; i++) {
        const int node = first + i;
        const double rate = slope[i];
        l.turn += value[i] * along->turn[node];
        l.dturn += rate * along->turn[node];
        for (int j = 0; j < 36; j++) {
            const double k = along->law[node].K.a[j / 6][j % 6];
            l.K.a[j / 6][j % 6] += value[i] * k;
            l.dK.a[j / 6][j % 6] += rate * k;
        }
    }
    return l;
}

// R k R^T on each 3x3 block, R = R_z(angle)
static mat6 turned(mat6 k, double angle)
{
    return beam_law_move(k, 0, 0, -angle);
}

// Z k + (Z k)^T with Z = hat(e_z) on both blocks: the derivative of the turning
static mat6 turning(mat6 k)
{
    mat6 zk = {0};
    for (int j = 0; j < 6; j++) {
        zk.a[0][j] = -k.a[1][j];
        zk.a[1][j] = k.a[0][j];
        zk.a[3][j] = -k.a[4][j];
        zk.a[4][j] = k.a[3][j];
    }
    return mat6_add(zk, mat6_transpose(zk));
}

void law_along_at(const law_along *along, double s, mat6 *K, mat6 *dK)
{
    const local_law l = interpolate(along, s, dK != NULL);
    *K = turned(l.K, l.turn);
    if (dK) {
        // K_g = R K R^T, R' = turn' R Z, and Z^T = -Z: docs/theory.md (2.8)
        *dK = turned(mat6_add(l.dK, mat6_scale(l.dturn, turning(l.K))), l.turn);
    }
}

double law_along_mass(const law_along *along, double s, double centre[2])
{
    double value[LAW_ALONG_MAX_NODES], mass = 0, turn = 0, x = 0, y = 0;
    const int first = node_weights(along, s, value, NULL);
    for (int i = 0; i < along->nnode; i++) {
        const beam_law *law = &along->law[first + i];
        mass += value[i] * law->mass;
        x += value[i] * law->mass_centre[0];
        y += value[i] * law->mass_centre[1];
        turn += value[i] * along->turn[first + i];
    }
    centre[0] = cos(turn) * x - sin(turn) * y;
    centre[1] = sin(turn) * x + cos(turn) * y;
    return mass;
}

bool law_along_has_mass(const law_along *along)
{
    for (int i = 0; i < along->npanel * along->nnode; i++) {
        if (!(along->law[i].mass > 0)) {
            return false;
        }
    }
    return true;
}

// B of beam_law_axial_bending and its derivative
static void axial_bending(const local_law *l, mat3 *B, mat3 *dB)
{
    mat6 F = {0};
    // K was checked when the law was made
    (void)mat6_inverse_spd(l->K, &F);
    (void)beam_law_axial_bending(&F, B);
    // F' = -F K' F and B' = -B F' B
    const mat6 product = mat6_mul(F, mat6_mul(l->dK, F));
    mat3 block = {0};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            block.a[i][j] = product.a[NZ + i][NZ + j];
        }
    }
    *dB = mat3_mul(*B, mat3_mul(block, *B));
}

// angle of the principal axis in the turned frame and its derivative; false where there is no
// preferred axis
static bool local_axis(const mat3 *B, const mat3 *dB, const double p[2], const double dp[2],
                       double *angle, double *rate)
{
    const double EA = B->a[0][0], dEA = dB->a[0][0];
    const double Ixx = B->a[1][1] - EA * p[1] * p[1], Iyy = B->a[2][2] - EA * p[0] * p[0];
    const double difference = Iyy - Ixx, product = -B->a[1][2] - EA * p[0] * p[1];
    const double d_difference = dB->a[2][2] - dB->a[1][1] - dEA * (p[0] * p[0] - p[1] * p[1]) -
                                2 * EA * (p[0] * dp[0] - p[1] * dp[1]);
    const double d_product = -dB->a[1][2] - dEA * p[0] * p[1] - EA * (dp[0] * p[1] + p[0] * dp[1]);
    const double size = hypot(difference, 2 * product);
    if (size <= BEAM_LAW_ISOTROPIC * (Ixx + Iyy) / 2) {
        return false;
    }
    *angle = atan2(2 * product, difference) / 2;
    *rate = (difference * d_product - product * d_difference) / (size * size);
    return true;
}

void law_along_centre_frame(const law_along *along, double s, double phi_near, centre_frame *out)
{
    const local_law l = interpolate(along, s, true);
    mat3 B = {0}, dB = {0};
    axial_bending(&l, &B, &dB);
    const double EA = B.a[0][0], dEA = dB.a[0][0];
    const double p[2] = {-B.a[0][2] / EA, B.a[0][1] / EA};
    const double dp[2] = {(-dB.a[0][2] - p[0] * dEA) / EA, (dB.a[0][1] - p[1] * dEA) / EA};

    // The product of inertia of a symmetric section is noise of its mesh: where the two moments
    // cross it would turn the axes by pi/4 and back within a hair's breadth of s
    double axis = 0, rate = 0;
    if (along->symmetric || !local_axis(&B, &dB, p, dp, &axis, &rate)) {
        axis = 0;
        rate = 0;
    }
    const double c = cos(l.turn), z = sin(l.turn);
    const double phi = l.turn + axis;
    // axes differ by pi/2: the branch next to the station before
    const double branch = along->symmetric ? 0 : half_pi * round((phi_near - phi) / half_pi);
    *out = (centre_frame){
        .p = {c * p[0] - z * p[1], z * p[0] + c * p[1]},
        .dp = {c * (dp[0] - l.dturn * p[1]) - z * (dp[1] + l.dturn * p[0]),
               z * (dp[0] - l.dturn * p[1]) + c * (dp[1] + l.dturn * p[0])},
        .phi = phi + branch,
        .dphi = l.dturn + rate,
    };
}
