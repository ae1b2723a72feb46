// fem/after_ends.c
// What the layers at the ends do: the tip's own centre, and the lengths that they take.
#include "fem/after_parts.h"

#include "base/element.h"
#include "base/memory.h"

#include <math.h>

// the point at which an axial force leaves the tip unturned: C's own equation (5.4)
status after_tip_centre(const after *a, double centre[2])
{
    const mat6 C = a->compliance;
    const double det = C.a[MX][MX] * C.a[MY][MY] - C.a[MX][MY] * C.a[MY][MX];
    if (!(det > 0)) {
        return status_fail(ERR_NUMERIC, "segment: end moments do not turn the tip");
    }
    centre[0] = (C.a[MY][NZ] * C.a[MX][MX] - C.a[MX][NZ] * C.a[MY][MX]) / det;
    centre[1] = (C.a[MY][NZ] * C.a[MX][MY] - C.a[MX][NZ] * C.a[MY][MY]) / det;
    return OK;
}

// --- (5.17)

// heights at which a section is held against the middle's, and how near its nodes must lie over the
// radius to be the same
enum { LOOKS = 8 };
static const double SAME = 1e-9;

static bool materials_vary(const after *a)
{
    const mesh *plane = a->problem->body->plane;
    bool vary = a->problem->body->spec.matter != NULL;
    for (int b = 0; b < plane->nblock; b++) {
        for (int e = 0; e < plane->block[b].nelem; e++) {
            const int k = plane->block[b].material[e];
            vary = vary || material_varies(&a->problem->body->spec.materials[k]);
        }
    }
    return vary;
}

// the section's nodes in its own axes
static status own_places(const body *b, double s, double *own)
{
    status st = OK;
    section_pose pose;
    TRY(b->spec.shape.place(b->spec.shape.self, s, own, &pose.axes, pose.origin.a));
    for (int i = 0; i < b->plane->nnode; i++, own += 3) {
        const vec3 r = vec3_sub((vec3){{own[0], own[1], own[2]}}, pose.origin);
        const vec3 at = mat3_tmul_vec(pose.axes, r);
        own[0] = at.a[0];
        own[1] = at.a[1];
        own[2] = at.a[2];
    }

done:
    return st;
}

// whether all sections are the middle's, but for where they are
static status is_uniform(const after *a, bool *out)
{
    status st = OK;
    const body *b = a->problem->body;
    const size_t all = 3 * (size_t)b->plane->nnode;
    double *middle = NULL, *here = NULL;
    *out = !materials_vary(a);
    if (*out && b->spec.shape.place) {
        TRY(TAKE(middle, all));
        TRY(TAKE(here, all));
        TRY(own_places(b, a->middle, middle));
        for (int k = 0; *out && k <= LOOKS; k++) {
            TRY(own_places(b, a->run->z[0] + a->length * k / LOOKS, here));
            for (size_t i = 0; *out && i < all; i++) {
                *out = fabs(here[i] - middle[i]) <= SAME * a->radius;
            }
        }
    }

done:
    free(middle);
    free(here);
    return st;
}

// What the segment would be without ends, for wrenches at its middle: whole = int T^T F T, and the
// mean law in the base's axes.
static status beam_without_ends(const after *a, const section_pose *middle, mat6 *whole, mat6 *mean)
{
    enum { PANELS = 64, RULE = 4 };
    status st = OK;
    double x[RULE], w[RULE];
    const double h = a->length / PANELS;
    gauss_legendre(RULE, x, w);
    for (int i = 0; i < PANELS * RULE; i++) {
        section_pose here;
        const double s = a->run->z[0] + h * (i / RULE + (1 + x[i % RULE]) / 2);
        TRY(after_pose_at(a->problem->body, s, &here));
        const mat6 T = after_transport(middle, &here, 1);
        here.origin = middle->origin;
        const mat6 R = after_transport(middle, &here, 1);
        *whole = mat6_add(*whole, mat6_scale(w[i % RULE] * h / 2, mat6_congruence(T, a->F)));
        *mean = mat6_add(*mean, mat6_scale(w[i % RULE] / 2 / PANELS, mat6_congruence(R, a->F)));
    }

done:
    return st;
}

status after_end_length(const after *a, double length[6])
{
    status st = OK;
    const double L = a->length;
    section_pose middle;
    mat6 whole = {0}, mean = {0};
    bool uniform = false;
    for (int i = 0; i < 6; i++) {
        length[i] = NAN;
    }
    TRY(is_uniform(a, &uniform));
    // what holds the base is no layer at an end
    if (!uniform || a->problem->nspring > 0 || a->problem->nhold > 0) {
        return OK;
    }
    TRY(after_pose_at(a->problem->body, a->run->z[0] + L / 2, &middle));
    middle.axes = mat3_identity();
    TRY(beam_without_ends(a, &middle, &whole, &mean));
    const mat6 T = after_transport(
        &middle,
        &(section_pose){.axes = mat3_identity(), .origin = a->pose[a->run->nlevel - 1].origin}, 1);
    const mat6 C = mat6_congruence(T, a->compliance);
    for (int i = 5; i >= 0; i--) {
        double missing = whole.a[i][i] - C.a[i][i];
        if (i < NZ) { // what the ends take of the bending by a transverse force is theirs
            const int bend = i == NX ? MY : MX;
            missing -= mean.a[bend][bend] * (pow(L, 3) - pow(L - length[bend], 3)) / 12;
        }
        length[i] = missing / mean.a[i][i];
    }

done:
    return st;
}
