// reports/store_pieces.c
// What ParaView sees: the section, the section under each of its wrenches, the deformed segments,
// the wall and the bodies of a reach study.
#include "base/memory.h"
#include "reports/store_parts.h"
#include "reports/store_reach_grid.h"
#include "section/extremes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { DISPLACEMENT, STRAIN, STRESS, MISES, NFIELD };

// of one piece, made here
typedef struct piece_fields {
    store_field field[NFIELD + REACH_FIELDS]; // a study's behind the others
    store_layers layers;
    double *own[NFIELD], *xyz;
} piece_fields;

typedef struct pieces {
    int n, nfield; // nfield 1: displacements only; a study's fields not counted
    reach_pieces reach;
    store_grid_piece *piece;
    piece_fields *fields;
    double *zero; // displacement of what does not move
} pieces;

static void pieces_free(pieces *p)
{
    for (int i = 0; i < p->n; i++) {
        for (int k = 0; k < NFIELD; k++) {
            free(p->fields[i].own[k]);
        }
        free(p->fields[i].xyz);
    }
    free(p->piece);
    free(p->fields);
    free(p->zero);
    reach_pieces_free(&p->reach);
}

static const section_answers *with_fields(const run_result *r)
{
    const section_answers *a = r->has_section && r->nanswer > 0 ? &r->answer[0] : NULL;
    return a && a->nodes.nnode > 0 ? a : NULL;
}

static bool has_stress(const run_result *r)
{
    const segment_body *b = &r->segment.body;
    return r->has_segment && r->segment.nload > 0 && b->apart.nnode > 0;
}

static status pieces_make(const run_result *r, pieces *out)
{
    status st = OK;
    const section_answers *a = with_fields(r);
    const int nwrench = a ? a->nload : 0, nsegment = r->has_segment ? r->segment.nload : 0;
    const int section = r->section_mesh.nnode, split = a ? a->nodes.nnode : 0;
    TRY(reach_pieces_make(&r->reach, &out->reach));
    int most = section > split ? section : split;
    for (int i = 0; i < out->reach.npiece; i++) {
        most = out->reach.mesh[i].nnode > most ? out->reach.mesh[i].nnode : most;
    }
    const size_t room = (size_t)(1 + nwrench + nsegment + out->reach.npiece);
    out->nfield = nwrench > 0 || has_stress(r) ? NFIELD : 1;
    TRY(TAKE(out->piece, room));
    TRY(TAKE(out->fields, room));
    TRY(TAKE(out->zero, 3 * (size_t)most));

done:
    return st;
}

// one more piece, with no fields of its own yet, and the name of its part
static status add_piece(store *s, pieces *p, const mesh *m, const char *name)
{
    char part[64];
    piece_fields *f = &p->fields[p->n];
    f->field[DISPLACEMENT] = (store_field){"displacement_m", 3, p->zero};
    f->field[STRAIN] = (store_field){"strain", 6, NULL};
    f->field[STRESS] = (store_field){"stress_Pa", 6, NULL};
    f->field[MISES] = (store_field){"von_mises_Pa", 1, NULL};
    for (int k = 0; k < p->reach.nfield; k++) {
        f->field[p->nfield + k] = (store_field){p->reach.field[k], 1, NULL};
    }
    p->piece[p->n] =
        (store_grid_piece){.mesh = m, .nfield = p->nfield + p->reach.nfield, .field = f->field};
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

// --- segments

// rows of plane nodes on the levels here -> rows of the nodes apart
static status spread(const segment_body *b, const int *copy_of, int width, const double *from,
                     double **to)
{
    status st = OK;
    const size_t levels = (size_t)(b->last - b->first), w = (size_t)width;
    const size_t nplane = (size_t)b->plane.nnode, napart = (size_t)b->apart.nnode;
    TRY(TAKE(*to, levels * napart * w));
    for (size_t level = 0; level < levels; level++) {
        for (size_t i = 0; i < napart; i++) {
            memcpy(*to + (level * napart + i) * w, from + (level * nplane + (size_t)copy_of[i]) * w,
                   w * sizeof **to);
        }
    }

done:
    return st;
}

// nodes of the plane mesh that the nodes apart are copies of
static status find_copies(const segment_body *b, int **out)
{
    status st = OK;
    TRY(TAKE(*out, (size_t)b->apart.nnode));
    for (int k = 0; k < b->apart.nblock; k++) {
        const mesh_block *a = &b->apart.block[k], *o = &b->plane.block[k];
        for (int i = 0; i < a->nelem * a->per_elem; i++) {
            (*out)[a->conn[i]] = o->conn[i];
        }
    }

done:
    return st;
}

static status take_stress(const segment_body *b, const double *stress, piece_fields *f)
{
    status st = OK;
    const int n = (b->last - b->first) * b->apart.nnode;
    TRY(TAKE(f->own[STRESS], 6 * (size_t)n));
    TRY(TAKE(f->own[MISES], (size_t)n));
    in_vtk_order(n, (const double(*)[6])(const void *)stress, f->own[STRESS]);
    for (int i = 0; i < n; i++) {
        vec6 s;
        memcpy(s.a, stress + 6 * (size_t)i, sizeof s.a);
        f->own[MISES][i] = von_mises(&s);
    }
    f->field[STRESS].data = f->own[STRESS];
    f->field[MISES].data = f->own[MISES];

done:
    return st;
}

static status add_segment(store *s, pieces *p, const segment_body *b,
                          const segment_load_result *load)
{
    status st = OK;
    int *copy_of = NULL;
    const bool apart = load->stress != NULL;
    TRY(add_piece(s, p, apart ? &b->apart : &b->plane, load->name ? load->name : ""));
    piece_fields *f = &p->fields[p->n - 1];
    f->layers = (store_layers){.order = b->order,
                               .nlayer = b->nlayer,
                               .matter = b->matter,
                               .first = b->first,
                               .last = b->last,
                               .xyz = b->node};
    f->field[DISPLACEMENT].data = load->displacement;
    if (apart) {
        TRY(find_copies(b, &copy_of));
        TRY(spread(b, copy_of, 3, load->displacement, &f->own[DISPLACEMENT]));
        TRY(spread(b, copy_of, 3, b->node, &f->xyz));
        TRY(take_stress(b, load->stress, f));
        f->field[DISPLACEMENT].data = f->own[DISPLACEMENT];
        f->layers.xyz = f->xyz;
    }
    p->piece[p->n - 1].layers = &f->layers;
    p->piece[p->n - 1].displacement = f->field[DISPLACEMENT].data;

done:
    free(copy_of);
    return st;
}

// --- a reach study

static status add_reach(store *s, pieces *p)
{
    status st = OK;
    for (int i = 0; i < p->reach.npiece; i++) {
        TRY(add_piece(s, p, &p->reach.mesh[i], p->reach.name[i]));
        for (int k = 0; k < p->reach.nfield; k++) {
            p->fields[p->n - 1].field[p->nfield + k].data = p->reach.data[i][k];
        }
    }

done:
    return st;
}

static status add_all(store *s, const run_result *r, pieces *p)
{
    status st = OK;
    const section_answers *a = with_fields(r);
    const segment_body *b = &r->segment.body;
    if (r->has_section && r->section_mesh.nnode > 0) {
        TRY(add_piece(s, p, &r->section_mesh, "section"));
    }
    for (int i = 0; r->has_segment && store_segment_is_whole(b) && i < r->segment.nload; i++) {
        if (r->segment.load[i].displacement) {
            TRY(add_segment(s, p, b, &r->segment.load[i]));
        }
    }
    for (int i = 0; a && i < a->nload; i++) {
        TRY(add_wrench(s, p, &a->nodes, &a->load[i]));
    }
    TRY(add_reach(s, p));

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
