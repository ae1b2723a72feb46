// reports/store_pieces.c
// What ParaView sees: the section, the section under each of its wrenches, the deformed segments.
#include "base/memory.h"
#include "reports/store_parts.h"
#include "section/extremes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { DISPLACEMENT, STRAIN, STRESS, MISES, NFIELD };

typedef struct piece_fields {
    store_field field[NFIELD];
    double *own[NFIELD]; // made here; NULL: somebody else's
} piece_fields;

typedef struct pieces {
    int n, nfield; // nfield 1: no wrench is asked for, displacements only
    store_grid_piece *piece;
    piece_fields *fields;
    double *zero, *nothing; // for the fields that a piece has not
} pieces;

static void pieces_free(pieces *p)
{
    for (int i = 0; i < p->n; i++) {
        for (int k = 0; k < NFIELD; k++) {
            free(p->fields[i].own[k]);
        }
    }
    free(p->piece);
    free(p->fields);
    free(p->zero);
    free(p->nothing);
}

static const section_answers *with_fields(const run_result *r)
{
    const section_answers *a = r->has_section && r->nanswer > 0 ? &r->answer[0] : NULL;
    return a && a->nodes.nnode > 0 ? a : NULL;
}

static status pieces_make(const run_result *r, pieces *out)
{
    status st = OK;
    const section_answers *a = with_fields(r);
    const int nwrench = a ? a->nload : 0, nsegment = r->has_segment ? r->segment.nload : 0;
    const int section = r->section_mesh.nnode, split = a ? a->nodes.nnode : 0;
    int most = section > split ? section : split;
    most = most > r->segment_mesh.nnode ? most : r->segment_mesh.nnode;
    out->nfield = nwrench > 0 ? NFIELD : 1;
    const size_t size = out->nfield > 1 ? 6 * (size_t)most : 0;
    TRY(TAKE(out->piece, (size_t)(1 + nwrench + nsegment)));
    TRY(TAKE(out->fields, (size_t)(1 + nwrench + nsegment)));
    TRY(TAKE(out->zero, 3 * (size_t)most));
    TRY(TAKE(out->nothing, size));
    for (size_t i = 0; i < size; i++) {
        out->nothing[i] = NAN;
    }

done:
    return st;
}

// one more piece, with no fields of its own yet, and the name of its part
static status add_piece(store *s, pieces *p, const mesh *m, const char *name)
{
    char part[64];
    piece_fields *f = &p->fields[p->n];
    f->field[DISPLACEMENT] = (store_field){"displacement_m", 3, p->zero};
    f->field[STRAIN] = (store_field){"strain", 6, p->nothing};
    f->field[STRESS] = (store_field){"stress_Pa", 6, p->nothing};
    f->field[MISES] = (store_field){"von_mises_Pa", 1, p->nothing};
    p->piece[p->n] = (store_grid_piece){.mesh = m, .nfield = p->nfield, .field = f->field};
    (void)snprintf(part, sizeof part, "part/%d", p->n);
    p->n++;
    return store_text(s, part, name, strlen(name));
}

// xx yy zz yz xz xy -> xx yy zz xy yz xz
static void in_vtk_order(int n, const double (*from)[6], double *to)
{
    static const int order[6] = {0, 1, 2, 5, 3, 4};
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < 6; k++) {
            to[6 * (size_t)i + (size_t)k] = from[i][order[k]];
        }
    }
}

static status add_wrench(store *s, pieces *p, const mesh *m, const section_load_answer *load)
{
    status st = OK;
    const size_t n = (size_t)m->nnode;
    char name[96];
    (void)snprintf(name, sizeof name, "section, %s", load->name);
    TRY(add_piece(s, p, m, name));
    piece_fields *f = &p->fields[p->n - 1];
    TRY(TAKE(f->own[STRAIN], 6 * n));
    TRY(TAKE(f->own[STRESS], 6 * n));
    TRY(TAKE(f->own[MISES], n));
    in_vtk_order(m->nnode, (const double(*)[6])load->strain, f->own[STRAIN]);
    in_vtk_order(m->nnode, (const double(*)[6])load->stress, f->own[STRESS]);
    for (size_t i = 0; i < n; i++) {
        vec6 stress;
        memcpy(stress.a, load->stress[i], sizeof stress.a);
        f->own[MISES][i] = von_mises(&stress);
    }
    for (int k = STRAIN; k < NFIELD; k++) {
        f->field[k].data = f->own[k];
    }

done:
    return st;
}

static status add_all(store *s, const run_result *r, pieces *p)
{
    status st = OK;
    const section_answers *a = with_fields(r);
    if (r->has_section && r->section_mesh.nnode > 0) {
        TRY(add_piece(s, p, &r->section_mesh, "section"));
    }
    for (int i = 0; r->has_segment && i < r->segment.nload; i++) {
        const segment_load_result *load = &r->segment.load[i];
        if (load->displacement) {
            TRY(add_piece(s, p, &r->segment_mesh, load->name ? load->name : ""));
            p->fields[p->n - 1].field[DISPLACEMENT].data = load->displacement;
            p->piece[p->n - 1].displacement = load->displacement;
        }
    }
    for (int i = 0; a && i < a->nload; i++) {
        TRY(add_wrench(s, p, &a->nodes, &a->load[i]));
    }

done:
    return st;
}

status store_write_grid(store *s, const run_result *r)
{
    status st = OK;
    pieces p = {0};
    TRY(pieces_make(r, &p));
    TRY(add_all(s, r, &p));
    TRY(p.n > 0 ? store_grid(s, p.n, p.piece) : OK);

done:
    pieces_free(&p);
    return st;
}
