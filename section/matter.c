#include "section/matter.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// Rounding of a turned stiffness, relative to its largest entry: what couples less than this
// couples nothing, and leaving it out changes K by as little.
static const double rounding_of_coupling = 1e-14;

void matter_free(matter *m)
{
    free(m->law);
    for (int b = 0; b < MESH_MAX_BLOCKS; b++) {
        free(m->of[b]);
    }
    *m = (matter){0};
}

// Isotropic materials have no axes to be turned.
static int frame_of(const matter *m, const mesh_block *b, int index)
{
    const bool turns = m->materials[b->material[index]].kind != MATERIAL_ISOTROPIC;
    return turns && b->frame ? b->frame[index] : -1;
}

static mat6 stiffness_of(const matter *m, int index, int frame, double x, double y)
{
    const material_frame *f = frame < 0 ? NULL : &m->mesh->frame[frame];
    return mat6_symmetric(material_stiffness_in(&m->materials[index], f, x, y));
}

static status add_law(matter *m, int material, int frame, int next)
{
    status st = OK;
    if (m->nlaw == m->room) {
        matter_law *more = NULL;
        TRY(TAKE(more, 2 * (size_t)m->room + 8));
        if (m->nlaw) {
            memcpy(more, m->law, (size_t)m->nlaw * sizeof *more);
        }
        free(m->law);
        m->law = more;
        m->room = 2 * m->room + 8;
    }
    const material_frame *f = frame < 0 ? NULL : &m->mesh->frame[frame];
    const bool polar = f && f->polar;
    m->law[m->nlaw++] = (matter_law){
        .material = material,
        .frame = frame,
        .next = next,
        .graded = m->materials[material].modulus.at != NULL,
        .polar = polar,
        // a polar one beside its centre, where it has a direction
        .Q = stiffness_of(m, material, frame, polar ? f->centre[0] + 1 : 0,
                          polar ? f->centre[1] : 0),
    };

done:
    return st;
}

// Laws of one frame are chained, first[frame + 1] begins the chain: few materials share a frame.
static status find_laws(matter *m, int *first)
{
    status st = OK;
    for (int b = 0; b < m->mesh->nblock; b++) {
        const mesh_block *block = &m->mesh->block[b];
        TRY(TAKE(m->of[b], (size_t)block->nelem));
        for (int e = 0; e < block->nelem; e++) {
            const int frame = frame_of(m, block, e);
            int k = first[frame + 1];
            while (k >= 0 && m->law[k].material != block->material[e]) {
                k = m->law[k].next;
            }
            if (k < 0) {
                TRY(add_law(m, block->material[e], frame, first[frame + 1]));
                k = first[frame + 1] = m->nlaw - 1;
            }
            m->of[b][e] = k;
        }
    }

done:
    return st;
}

static bool couples(const mat6 *Q, double largest)
{
    static const int plane[4] = {XX, YY, ZZ, XY}, along[2] = {YZ, XZ};
    double most = 0;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 2; j++) {
            most = fmax(most, fabs(Q->a[plane[i]][along[j]]));
        }
    }
    return most > rounding_of_coupling * largest;
}

static void scale_laws(matter *m)
{
    for (int k = 0; k < m->nlaw; k++) {
        double largest = 0;
        for (int i = 0; i < 6; i++) {
            largest = fmax(largest, m->law[k].Q.a[i][i]);
        }
        m->modulus = fmax(m->modulus, largest);
        m->coupled = m->coupled || couples(&m->law[k].Q, largest);
    }
    for (int k = 0; k < m->nlaw; k++) {
        m->law[k].Q = mat6_scale(1 / m->modulus, m->law[k].Q);
    }
}

status matter_make(const mesh *m, const material *materials, matter *out)
{
    status st = OK;
    int *first = NULL;
    matter all = {.mesh = m, .materials = materials};
    TRY(TAKE(first, (size_t)m->nframe + 1));
    for (int f = 0; f <= m->nframe; f++) {
        first[f] = -1;
    }
    TRY(find_laws(&all, first));
    scale_laws(&all);
    *out = all;
    all = (matter){0};

done:
    free(first);
    matter_free(&all);
    return st;
}

static void place_of(const plane *p, const plane_element *e, int q, double *x, double *y)
{
    *x = p->centre[0] + p->length * e->x[q];
    *y = p->centre[1] + p->length * e->y[q];
}

static status grade(const material *m, const plane *p, const plane_element *e, double *weight)
{
    status st = OK;
    for (int q = 0; q < e->npoint; q++) {
        double x, y, c;
        place_of(p, e, q, &x, &y);
        TRY(material_check_grade(m, x, y, &c));
        weight[q] *= c;
    }

done:
    return st;
}

status matter_at(const matter *m, const plane *p, const plane_element *e, matter_element *out)
{
    out->law = &m->law[m->of[e->block][e->index]];
    memcpy(out->weight, e->dA, (size_t)e->npoint * sizeof *out->weight);
    return out->law->graded ? grade(&m->materials[out->law->material], p, e, out->weight) : OK;
}

const mat6 *matter_stiffness(const matter *m, const plane *p, const plane_element *e, int q,
                             matter_element *at)
{
    double x, y;
    if (!at->law->polar) {
        return &at->law->Q;
    }
    place_of(p, e, q, &x, &y);
    at->Q = mat6_scale(1 / m->modulus, stiffness_of(m, at->law->material, at->law->frame, x, y));
    return &at->Q;
}
