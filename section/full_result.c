#include "base/beam_law.h"
#include "base/memory.h"
#include "section/full.h"

#include <math.h>

// What rounding may put the compliance off by, relative as in (6.1), judged by how far the stresses
// miss the unit wrenches. The equations make the two equal, so what remains is the rounding of the
// matrix and its solves: 1e-13 in sound sections, and more as moduli or lengths grow apart. It goes
// into the law's error; beyond this rounding has taken over.
static const double rounding_limit = 1e-2;

// The stresses make the wrenches I + D instead of I. Rounding of a stiff direction's stresses is
// rounding of a soft one's strains, and the other way round: D counts by the larger ratio of the
// two compliances. Strips 1e3 to 3e3 times as long as thick have a third of it as their error.
static double compliance_error(mat6 F, mat6 resultant)
{
    double most = 0;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            const double ratio = sqrt(F.a[i][i] / F.a[j][j]);
            const double part = fabs(resultant.a[i][j] - (i == j)) * fmax(ratio, 1 / ratio);
            most = part <= most ? most : part; // a NaN must not look small
        }
    }
    return most;
}

// (3.5) and (3.6), and back to SI at the section's origin
status full_law(warping_problem *p, const full_solution *s, beam_law *out)
{
    status st = OK;
    mat6 F, K, resultant;
    TRY(warping_energy(p, s->w, &s->psi, &F, &resultant));
    const double miss = compliance_error(F, resultant);
    if (!(miss <= rounding_limit)) {
        TRY(status_fail(ERR_NUMERIC,
                        "section: rounding puts its compliance off by %.1e: a wall is too thin for "
                        "the section's size, the materials are too far apart in stiffness, or "
                        "parts hang together by a point",
                        miss));
    }
    if (!mat6_inverse_spd(F, &K)) {
        TRY(status_fail(ERR_NUMERIC, "section: the compliance is not positive definite"));
    }
    const double a = p->plane.length, unit = p->matter.modulus * a * a;
    for (int i = 0; i < 36; i++) {
        K.a[i / 6][i % 6] *= unit * (i / 6 < 3 ? 1 : a) * (i % 6 < 3 ? 1 : a);
    }
    *out = (beam_law){
        .K = beam_law_move(K, -p->plane.centre[0], -p->plane.centre[1], 0),
        .area = p->area * a * a,
        .relative_error = miss,
    };
    const mass_sum mass = {
        .unknown = p->mass.unknown,
        .one = a * a * p->mass.one,
        .x = a * a * a * p->mass.x,
        .y = a * a * a * p->mass.y,
    };
    mass_into_law(&mass, p->plane.centre, out);

done:
    return st;
}

void section_warping_free(section_warping *w)
{
    free(w->w);
    free(w->dw);
    *w = (section_warping){0};
}

// Unit wrenches at the section's origin, seen scaled at the centre: theta_c = P theta_o, column by
// column, and psi_o = P^T psi_c since both do the same work.
static mat6 wrench_at_centre(const plane *p, double modulus)
{
    const double a = p->length, x = p->centre[0], y = p->centre[1];
    const double force = 1 / (modulus * a * a), moment = force / a;
    mat6 P = {0};
    for (int i = 0; i < 6; i++) {
        P.a[i][i] = i < 3 ? force : moment;
    }
    // m_c = m_o - c x n
    P.a[MX][NZ] = -y * moment;
    P.a[MY][NZ] = x * moment;
    P.a[MZ][NX] = y * moment;
    P.a[MZ][NY] = -x * moment;
    return P;
}

// generalized strains of the scaled section at its centre -> SI at the origin, for the columns
// already combined by P
static mat6 strains_at_origin(const plane *p, mat6 psi)
{
    const double a = p->length, x = p->centre[0], y = p->centre[1];
    for (int k = 0; k < 6; k++) {
        double column[6];
        for (int i = 0; i < 6; i++) {
            column[i] = psi.a[i][k] / (i < 3 ? 1 : a);
        }
        psi.a[NX][k] = column[NX] + y * column[MZ];
        psi.a[NY][k] = column[NY] - x * column[MZ];
        psi.a[NZ][k] = column[NZ] - y * column[MX] + x * column[MY];
        psi.a[MX][k] = column[MX];
        psi.a[MY][k] = column[MY];
        psi.a[MZ][k] = column[MZ];
    }
    return psi;
}

status full_warping_in_si(const warping_problem *p, const full_solution *s, section_warping *out)
{
    status st = OK;
    const int nnode = s->nnode;
    const mat6 P = wrench_at_centre(&p->plane, p->matter.modulus);
    const mat6 TP = mat6_mul(warping_transport(p->rate), P);
    section_warping g = {.nnode = nnode};
    TRY(TAKE(g.w, 18 * (size_t)nnode));
    TRY(TAKE(g.dw, 18 * (size_t)nnode));
    for (int u = 0; u < 3 * nnode; u++) {
        for (int j = 0; j < 6; j++) {
            double w = 0, dw = 0;
            for (int i = 0; i < 6; i++) {
                w += s->w[6 * u + i] * P.a[i][j];
                dw += s->w[6 * u + i] * TP.a[i][j];
            }
            g.w[(size_t)j * 3 * (size_t)nnode + (size_t)u] = w * p->plane.length;
            g.dw[(size_t)j * 3 * (size_t)nnode + (size_t)u] = dw;
        }
    }
    g.psi = strains_at_origin(&p->plane, mat6_mul(s->psi, P));
    // per scaled length: one more division for the slopes
    g.dpsi = mat6_scale(1 / p->plane.length, strains_at_origin(&p->plane, mat6_mul(s->psi, TP)));
    *out = g;
    g = (section_warping){0};

done:
    section_warping_free(&g);
    return st;
}
