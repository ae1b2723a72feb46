// fem/brick_point.c
// Forces of an element, and strain and stress at a point of it.
#include "fem/brick_parts.h"

#include <string.h>

// int N dV of node i
static double node_volume(const brick *w, int i)
{
    const basis_table *plane = &w->body->plane_table[w->block], *line = &w->body->line_table;
    double sum = 0;
    for (int q = 0; q < w->nq; q++) {
        sum += w->dV[q] * plane->N[q % w->np * w->n2 + i % w->n2] *
               line->N[q / w->np * line->nnode + i / w->n2];
    }
    return sum;
}

status brick_body_force(brick *w, int layer, const double force[3], double *f)
{
    status st = OK;
    if (body_material(w->body, w->block, w->e, layer) < 0) {
        return OK;
    }
    TRY(brick_geometry(w, layer));
    for (int i = 0; i < w->n; i++) {
        const double volume = node_volume(w, i);
        for (int d = 0; d < 3; d++) {
            f[3 * i + d] += volume * force[d];
        }
    }

done:
    return st;
}

status brick_mass(brick *w, int layer, double *mass)
{
    status st = OK;
    const int material = body_material(w->body, w->block, w->e, layer);
    memset(mass, 0, (size_t)w->n * sizeof *mass);
    if (material < 0) {
        return OK;
    }
    TRY(brick_geometry(w, layer));
    for (int i = 0; i < w->n; i++) {
        mass[i] = w->body->spec.materials[material].density * node_volume(w, i);
    }

done:
    return st;
}

// strain in the base's axes
static vec6 strain_of(const brick *w, const double *slope, const double *u)
{
    double H[3][3] = {{0}}; // du_i / dx_j
    for (int j = 0; j < 3; j++) {
        for (int a = 0; a < w->n; a++) {
            for (int i = 0; i < 3; i++) {
                H[i][j] += slope[j * w->n + a] * u[3 * a + i];
            }
        }
    }
    return (vec6){
        {H[0][0], H[1][1], H[2][2], H[1][2] + H[2][1], H[0][2] + H[2][0], H[0][1] + H[1][0]}};
}

// Q at a place along the section's axes
static status stiffness_at(const brick *w, int layer, double at, vec3 x, mat6 *Q)
{
    status st = OK;
    double grade;
    brick_law law;
    const double s = brick_arclength(w, layer, at);
    const int material = body_material(w->body, w->block, w->e, layer);
    TRY(brick_law_at(w->body, w->block, w->e, material, s, &law));
    TRY(brick_grade(&law, x.a[0], x.a[1], s, &grade));
    *Q = mat6_scale(grade, brick_section_stiffness(&law, x.a[0], x.a[1]));

done:
    return st;
}

status brick_stress_at(brick *w, int layer, const double at[3], const double *u, double *strain,
                       double *stress, double *place)
{
    status st = OK;
    double N[BRICK_MAX_NODES], slope[3 * BRICK_MAX_NODES], x[3] = {0};
    vec3 origin;
    mat3 axes;
    mat6 Q = {0};

    TRY(brick_geometry(w, layer));
    (void)brick_point(w, at, N, slope);
    for (int i = 0; i < 3 * w->n; i++) {
        x[i % 3] += N[i / 3] * w->xyz[i];
    }
    vec6 eps = strain_of(w, slope, u);
    if (w->body->spec.mixed) {
        TRY(brick_project(w));
        const double own = eps.a[0] + eps.a[1] + eps.a[2];
        const double more = (brick_projected(w, at, x, u) - own) / 3;
        for (int i = 0; i < 3; i++) {
            eps.a[i] += more;
        }
    }
    body_pose_at(w->body, layer, at[2], &axes, origin.a);
    eps = mat6_mul_vec(material_frame_strain_map(mat3_transpose(axes)), eps);
    if (body_material(w->body, w->block, w->e, layer) >= 0) {
        const vec3 r = vec3_sub((vec3){{x[0], x[1], x[2]}}, origin);
        TRY(stiffness_at(w, layer, at[2], mat3_tmul_vec(axes, r), &Q));
    }
    const vec6 sigma = mat6_mul_vec(Q, eps);
    memcpy(strain, eps.a, sizeof eps.a);
    memcpy(stress, sigma.a, sizeof sigma.a);
    if (place) {
        memcpy(place, x, sizeof x);
    }

done:
    return st;
}
