// fem/face_load.c
// Loads and springs on faces.
#include "fem/face.h"

#include <string.h>

typedef struct load_adder {
    const body *body;
    const face_pressure *load;
    double *f;
} load_adder;

static status add_patch(void *self, const face_patch *p)
{
    const load_adder *a = (const load_adder *)self;
    const size_t nplane = (size_t)a->body->plane->nnode;
    for (int q = 0; q < p->npoint; q++) {
        for (int i = 0; i < p->nnode; i++) {
            const size_t level = (size_t)(p->level[i] - a->body->first);
            double *to = a->f + 3 * (level * nplane + (size_t)p->plane_node[i]);
            for (int d = 0; d < 3; d++) {
                to[d] += p->N[q][i] * p->dA[q] *
                         (a->load->traction[d] - a->load->pressure * p->normal[q][d]);
            }
        }
    }
    return OK;
}

status face_add_load(const body *b, const face_pressure *load, int first, int last, double *f)
{
    load_adder a = {b, load, f};
    return face_walk(b, &load->on, first, last, add_patch, &a);
}

static mat3 spring_at(const face_spring *s, const double normal[3])
{
    mat3 k = {0};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const double along = i == j ? s->stiffness[s->axes ? i : 1] : 0;
            const double more =
                s->axes ? 0 : (s->stiffness[0] - s->stiffness[1]) * normal[i] * normal[j];
            k.a[i][j] = along + more;
        }
    }
    return k;
}

void face_spring_matrix(const face_patch *p, const face_spring *spring, double *K)
{
    const size_t n3 = 3 * (size_t)p->nnode;
    memset(K, 0, n3 * n3 * sizeof *K);
    for (int q = 0; q < p->npoint; q++) {
        const mat3 k = spring_at(spring, p->normal[q]);
        for (size_t r = 0; r < n3; r++) {
            for (size_t s = 0; s < n3; s++) {
                K[r * n3 + s] += p->dA[q] * p->N[q][r / 3] * p->N[q][s / 3] * k.a[r % 3][s % 3];
            }
        }
    }
}
