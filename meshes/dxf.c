// meshes/dxf.c
#include "meshes/dxf.h"

#include "base/memory.h"
#include "meshes/dxf_entity.h"

#include <math.h>
#include <string.h>

// what gmsh and the checks follow within their time
enum { MOST_PIECES = 5000, MOST_LAYERS = 500 };

void dxf_plan_free(dxf_plan *p)
{
    free(p->layer);
    free(p->chain);
    free(p->piece);
    *p = (dxf_plan){0};
}

// room for one more item
static status grow(void **items, int count, int *room, size_t size)
{
    if (count < *room) {
        return OK;
    }
    const int wanted = 2 * *room + 16;
    void *more = realloc(*items, (size_t)wanted * size);
    if (!more) {
        return status_fail(ERR_RESOURCE, "out of memory");
    }
    *items = more;
    *room = wanted;
    return OK;
}

static status find_layer(const input_file *f, dxf_plan *p, const char *name, long line, int *layer)
{
    status st = OK;
    for (*layer = 0; *layer < p->nlayer; ++*layer) {
        if (strcmp(p->layer[*layer], name) == 0) {
            return OK;
        }
    }
    if (p->nlayer >= MOST_LAYERS) {
        TRY(input_file_fail(f, line, "there are more than %d layers", MOST_LAYERS));
    }
    TRY(grow((void **)&p->layer, p->nlayer, &p->layer_room, sizeof *p->layer));
    strncpy(p->layer[p->nlayer], name, sizeof *p->layer - 1);
    p->layer[p->nlayer][sizeof *p->layer - 1] = '\0';
    p->nlayer++;

done:
    return st;
}

status dxf_add_chain(const input_file *f, dxf_plan *p, const char *layer, long line)
{
    status st = OK;
    int of = 0;
    TRY(find_layer(f, p, layer, line, &of));
    TRY(grow((void **)&p->chain, p->nchain, &p->chain_room, sizeof *p->chain));
    p->chain[p->nchain++] = (dxf_chain){.layer = of, .line = line, .first = p->npiece};

done:
    return st;
}

status dxf_add_piece(const input_file *f, dxf_plan *p, carrier c)
{
    status st = OK;
    dxf_chain *chain = &p->chain[p->nchain - 1];
    if (p->npiece >= MOST_PIECES) {
        TRY(input_file_fail(f, chain->line, "the drawing has more than %d pieces of curves",
                            MOST_PIECES));
    }
    TRY(grow((void **)&p->piece, p->npiece, &p->piece_room, sizeof *p->piece));
    p->piece[p->npiece++] = c;
    chain->count++;

done:
    return st;
}

// --- the file

// skips to the end of a section
static status skip_section(dxf_text *t)
{
    status st = OK;
    while (!dxf_is(t, 0, "ENDSEC")) {
        TRY(dxf_next(t));
    }

done:
    return st;
}

// $INSUNITS of the header: the codes of the format
static double unit_of(int code)
{
    switch (code) {
    case 1:
        return 25.4e-3;
    case 2:
        return 0.3048;
    case 4:
        return 1e-3;
    case 5:
        return 1e-2;
    case 6:
        return 1;
    case 13:
        return 1e-6;
    case 14:
        return 0.1;
    default:
        return 0;
    }
}

static status read_header(dxf_text *t, dxf_plan *p)
{
    status st = OK;
    bool here = false;
    while (!dxf_is(t, 0, "ENDSEC")) {
        double value = 0;
        if (t->code == 9) {
            here = dxf_is(t, 9, "$INSUNITS");
        } else if (here && t->code == 70) {
            TRY(dxf_number(t, &value));
            p->unit = unit_of(value >= 0 && value < 100 ? (int)value : 0);
        }
        TRY(dxf_next(t));
    }

done:
    return st;
}

static status read_entities(dxf_text *t, dxf_plan *p)
{
    status st = OK;
    dxf_entity e = {0};
    while (t->code != 0) {
        TRY(dxf_next(t));
    }
    while (!dxf_is(t, 0, "ENDSEC")) {
        if (dxf_is(t, 0, "EOF") || dxf_is(t, 0, "SECTION")) {
            TRY(input_file_fail(t->file, t->line, "the section ENTITIES has no ENDSEC"));
        }
        TRY(dxf_entity_read(t, &e));
        TRY(dxf_entity_draw(t, &e, p));
    }

done:
    dxf_entity_free(&e);
    return st;
}

// one section, from its name to its ENDSEC
static status read_section(dxf_text *t, dxf_plan *p, bool *entities)
{
    status st = OK;
    TRY(dxf_next(t));
    const bool header = dxf_is(t, 2, "HEADER"), drawn = dxf_is(t, 2, "ENTITIES");
    *entities = *entities || drawn;
    TRY(dxf_next(t));
    TRY(header ? read_header(t, p) : drawn ? read_entities(t, p) : skip_section(t));

done:
    return st;
}

static void measure(dxf_plan *p)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < p->npiece; i++) {
        double h[CARRIER_HULL][2];
        const int n = carrier_hull(&p->piece[i], p->piece[i].from, p->piece[i].to, h);
        for (int k = 0; k < 2 * n; k++) {
            low[k % 2] = fmin(low[k % 2], h[k / 2][k % 2]);
            high[k % 2] = fmax(high[k % 2], h[k / 2][k % 2]);
        }
    }
    p->size = fmax(high[0] - low[0], high[1] - low[1]);
}

status dxf_read(const input_file *f, dxf_plan *out)
{
    status st = OK;
    dxf_plan p = {0};
    dxf_text t = {.file = f};
    bool entities = false;

    if (input_file_begins(f, "AutoCAD Binary DXF")) {
        TRY(input_file_fail(f, 0, "this is a binary DXF file; only ASCII DXF is read"));
    }
    if (memchr(f->bytes, 0, f->count)) {
        TRY(input_file_fail(f, 0, "there is a zero byte in it: this is no ASCII DXF file"));
    }
    TRY(dxf_next(&t));
    while (t.code == 999) {
        TRY(dxf_next(&t));
    }
    if (!dxf_is(&t, 0, "SECTION") && !dxf_is(&t, 0, "EOF")) {
        TRY(input_file_fail(f, t.line, "a DXF file begins with a SECTION"));
    }
    while (!dxf_is(&t, 0, "EOF")) {
        if (dxf_is(&t, 0, "SECTION")) {
            TRY(read_section(&t, &p, &entities));
        }
        TRY(dxf_next(&t));
    }
    if (!entities || p.npiece == 0) {
        TRY(input_file_fail(f, 0, "nothing is drawn: no curves in a section ENTITIES"));
    }
    measure(&p);
    *out = p;
    p = (dxf_plan){0};

done:
    dxf_plan_free(&p);
    return st;
}
