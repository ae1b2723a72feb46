// section/fields.c
#include "section/fields.h"

#include "base/beam_law.h"
#include "base/memory.h"
#include "section/strains.h"

#include <math.h>
#include <string.h>

void section_fields_free(section_fields *f)
{
    mesh_free(&f->mesh);
    free(f->material);
    free(f->frame);
    free(f->strain);
    *f = (section_fields){0};
}

int section_frame_of(const mesh_block *b, int element)
{
    return b->frame ? b->frame[element] : -1;
}

mat6 section_stress_law(const mesh *m, const material *materials, int material, int frame, double x,
                        double y)
{
    const mat6 Q =
        material_stiffness_in(&materials[material], frame < 0 ? NULL : &m->frame[frame], x, y);
    return mat6_scale(material_grade(&materials[material], x, y), Q);
}

double section_axial_modulus(const mesh *m, const material *materials, int material, int frame,
                             double x, double y)
{
    mat6 compliance;
    if (materials[material].kind == MATERIAL_ISOTROPIC) {
        return materials[material].E * material_grade(&materials[material], x, y);
    }
    const mat6 Q = section_stress_law(m, materials, material, frame, x, y);
    return mat6_inverse_spd(Q, &compliance) ? 1 / compliance.a[ZZ][ZZ] : NAN;
}

// --- strains

// values of six nodal fields at a point, [3][6], and what the slopes want of them
typedef struct warping_at {
    double w[18], x[18], y[18], dw[18];
} warping_at;

static warping_at gather(const plane *p, const plane_element *e, int point,
                         const section_warping *warping)
{
    warping_at sum = {0};
    for (int i = 0; i < e->nnode; i++) {
        const int at = point * e->nnode + i;
        const double N = e->N[at], Nx = e->Nx[at] / p->length, Ny = e->Ny[at] / p->length;
        for (int j = 0; j < 6; j++) {
            const size_t from = 3 * ((size_t)j * (size_t)warping->nnode + (size_t)e->node[i]);
            for (int c = 0; c < 3; c++) {
                const double w = warping->w[from + (size_t)c];
                sum.w[6 * c + j] += N * w;
                sum.x[6 * c + j] += Nx * w;
                sum.y[6 * c + j] += Ny * w;
                sum.dw[6 * c + j] += N * warping->dw[from + (size_t)c];
            }
        }
    }
    return sum;
}

mat6 section_strains(const plane *p, const plane_element *e, int point,
                     const section_warping *warping, double turn_rate)
{
    const double x = p->centre[0] + p->length * e->x[point];
    const double y = p->centre[1] + p->length * e->y[point];
    const warping_at at = gather(p, e, point, warping);
    mat6 strain;
    set_rigid_strains(6, x, y, warping->psi.a[0], strain.a[0]);
    add_warping_strains(6, turn_rate, x, y, at.w, at.x, at.y, strain.a[0]);
    add_slope_strains(6, 1, at.dw, strain.a[0]);
    return strain;
}

// --- nodes apart

// copies of one node, a list through `next`
typedef struct apart {
    int *first; // [nnode of the mesh] index of its first copy, -1: none yet
    int *next;  // [copies]
    int *from;  // [copies] the mesh's node
    int *material, *frame;
    int count;
} apart;

static void apart_free(apart *a)
{
    free(a->first);
    free(a->next);
    free(a->from);
    free(a->material);
    free(a->frame);
}

static int copy_of(apart *a, int node, int material, int frame)
{
    int *at = &a->first[node];
    while (*at >= 0) {
        if (a->material[*at] == material && a->frame[*at] == frame) {
            return *at;
        }
        at = &a->next[*at];
    }
    const int new = a->count++;
    *at = new;
    a->next[new] = -1;
    a->from[new] = node;
    a->material[new] = material;
    a->frame[new] = frame;
    return new;
}

static size_t most_copies(const mesh *m)
{
    size_t count = 0;
    for (int b = 0; b < m->nblock; b++) {
        count += (size_t)m->block[b].nelem * (size_t)m->block[b].per_elem;
    }
    return count;
}

static status number_copies(mesh *m, apart *a)
{
    status st = OK;
    const size_t most = most_copies(m);
    TRY(TAKE(a->first, (size_t)m->nnode));
    TRY(TAKE(a->next, most));
    TRY(TAKE(a->from, most));
    TRY(TAKE(a->material, most));
    TRY(TAKE(a->frame, most));
    memset(a->first, -1, (size_t)m->nnode * sizeof *a->first);
    for (int b = 0; b < m->nblock; b++) {
        mesh_block *block = &m->block[b];
        for (int k = 0; k < block->nelem * block->per_elem; k++) {
            const int e = k / block->per_elem;
            block->conn[k] =
                copy_of(a, block->conn[k], block->material[e], section_frame_of(block, e));
        }
    }

done:
    return st;
}

// f->mesh, material and frame; *from [nnode] tells the mesh's own node of each
static status take_apart(const mesh *m, section_fields *f)
{
    status st = OK;
    apart a = {0};
    double *xyz = NULL;
    TRY(mesh_copy(m, &f->mesh));
    TRY(number_copies(&f->mesh, &a));
    TRY(TAKE(xyz, 3 * (size_t)a.count));
    TRY(TAKE(f->strain, (size_t)a.count));
    for (int i = 0; i < a.count; i++) {
        memcpy(xyz + 3 * (size_t)i, m->xyz + 3 * (size_t)a.from[i], 3 * sizeof *xyz);
    }
    free(f->mesh.xyz);
    f->mesh.xyz = xyz; // ownership passes, as that of the two lists
    f->mesh.nnode = a.count;
    f->material = a.material;
    f->frame = a.frame;
    a.material = a.frame = NULL;

done:
    apart_free(&a);
    return st;
}

// --- fields at the nodes

// a plane whose points are the nodes of its elements
static status plane_at_nodes(const mesh *m, plane *out)
{
    status st = OK;
    plane p = {0};
    TRY(plane_make(m, 1, &p));
    free(p.room);
    p.room = NULL;
    size_t most = 0;
    for (int b = 0; b < m->nblock; b++) {
        element e = {0};
        basis_table *t = &p.table[b];
        TRY(element_make(m->block[b].shape, m->order, &e));
        const size_t n = (size_t)e.nnode;
        basis_table_free(t);
        *t = (basis_table){.dim = 2, .nnode = e.nnode, .npoint = e.nnode};
        TRY(TAKE(t->weight, n));
        TRY(TAKE(t->point, 2 * n));
        TRY(TAKE(t->N, n * n));
        TRY(TAKE(t->dN, 2 * n * n));
        for (size_t q = 0; q < n; q++) {
            memcpy(t->point + 2 * q, e.node[q], 2 * sizeof(double));
            element_basis(&e, e.node[q], t->N + q * n, t->dN + 2 * q * n);
        }
        most = n * (3 + 2 * n) > most ? n * (3 + 2 * n) : most;
    }
    TRY(TAKE(p.room, most));
    *out = p;
    p = (plane){0};

done:
    plane_free(&p);
    return st;
}

// sums over the elements of every node, and how many they were
static status add_elements(plane *p, const section_warping *warping, double turn_rate,
                           section_fields *f, int *count)
{
    status st = OK;
    const mesh *m = p->mesh;
    for (int b = 0; b < m->nblock; b++) {
        const mesh_block *to = &f->mesh.block[b];
        for (int k = 0; k < to->nelem; k++) {
            plane_element e;
            TRY(plane_element_at(p, b, k, &e));
            for (int q = 0; q < e.nnode; q++) {
                const int node = to->conn[k * to->per_elem + q];
                f->strain[node] =
                    mat6_add(f->strain[node], section_strains(p, &e, q, warping, turn_rate));
                count[node]++;
            }
        }
    }

done:
    return st;
}

status section_fields_make(const mesh *m, const section_warping *warping, double turn_rate,
                           section_fields *out)
{
    status st = OK;
    section_fields f = {0};
    plane p = {0};
    int *count = NULL;
    TRY(take_apart(m, &f));
    TRY(TAKE(count, (size_t)f.mesh.nnode));
    TRY(plane_at_nodes(m, &p));
    TRY(add_elements(&p, warping, turn_rate, &f, count));
    for (int i = 0; i < f.mesh.nnode; i++) {
        f.strain[i] = mat6_scale(1.0 / count[i], f.strain[i]);
    }
    *out = f;
    f = (section_fields){0};

done:
    free(count);
    plane_free(&p);
    section_fields_free(&f);
    return st;
}

status section_fields_classical(const mesh *m, const material *materials, const mat6 *K,
                                section_fields *out)
{
    status st = OK;
    section_fields f = {0};
    mat6 F;
    if (!mat6_inverse_spd(*K, &F)) {
        return status_fail(ERR_NUMERIC, "section: its stiffness is not positive definite");
    }
    TRY(take_apart(m, &f));
    for (int i = 0; i < f.mesh.nnode; i++) {
        const double nu = materials[f.material[i]].nu;
        mat6 *strain = &f.strain[i];
        *strain =
            mat6_mul(rigid_strains(f.mesh.xyz[3 * (size_t)i], f.mesh.xyz[3 * (size_t)i + 1]), F);
        for (int j = 0; j < 6; j++) {
            strain->a[XX][j] = strain->a[YY][j] = -nu * strain->a[ZZ][j];
        }
    }
    *out = f;
    f = (section_fields){0};

done:
    section_fields_free(&f);
    return st;
}

vec6 section_strain_at(const section_fields *f, int node, const vec6 *wrench)
{
    return mat6_mul_vec(f->strain[node], *wrench);
}

vec6 section_stress_at(const section_fields *f, const material *materials, int node,
                       const vec6 *strain)
{
    const double *at = f->mesh.xyz + 3 * (size_t)node;
    return mat6_mul_vec(
        section_stress_law(&f->mesh, materials, f->material[node], f->frame[node], at[0], at[1]),
        *strain);
}
