// section/reuse.c
#include "section/reuse.h"

#include "base/memory.h"
#include "meshes/outline_move.h"
#include "section/known.h"
#include "section/solve.h"

#include <math.h>
#include <string.h>

// outlines nearer than this part of their size are one: contrast times this stays below 1e-10 of K
static const double same_outline = 1e-12;
// The rates of two turning patterns may differ by this, in radians per section size: K follows a
// rate's change by about as much.
static const double same_rate = 1e-11;

static material_traits traits_of(int count, const material *materials)
{
    material_traits t = {0};
    for (int i = 0; i < count; i++) {
        t.along = t.along || (materials[i].modulus.at && materials[i].modulus.along);
        t.across = t.across || material_is_graded(&materials[i]);
        t.anisotropic = t.anisotropic || materials[i].kind != MATERIAL_ISOTROPIC;
    }
    return t;
}

status section_store_make(const section_case *c, const material *materials, double length,
                          section_store *out)
{
    status st = OK;
    *out = (section_store){.request = c, .materials = materials, .length = length};
    out->traits = traits_of(c->nmaterial, materials);
    if (out->traits.along) {
        TRY(TAKE(out->frozen, (size_t)c->nmaterial));
    }

done:
    return st;
}

void section_store_free(section_store *store)
{
    for (int i = 0; i < store->count; i++) {
        section_place_free(&store->solved[i].place);
    }
    free(store->solved);
    free(store->frozen);
    section_known_free(&store->laws);
    *store = (section_store){0};
}

static status make_room(section_store *store)
{
    status st = OK;
    solved_section *more = NULL;
    if (store->count < store->capacity) {
        return OK;
    }
    const int capacity = 2 * store->capacity + 16;
    TRY(TAKE(more, (size_t)capacity));
    for (int i = 0; i < store->count; i++) {
        more[i] = store->solved[i];
    }
    free(store->solved);
    store->solved = more;
    store->capacity = capacity;

done:
    return st;
}

// --- likeness

static bool rates_agree(const section_place *a, const section_place *b, const section_likeness *k,
                        double size)
{
    const double known = k->mirror ? -a->turn_rate : a->turn_rate;
    return fabs(b->turn_rate * k->scale - known) * size <= same_rate;
}

static status is_moved(const section_outline *a, const section_outline *b,
                       const section_likeness *k, bool *alike)
{
    status st = OK;
    section_outline moved = {0};
    double angle = 0;
    const outline_motion motion = {.mirror = k->mirror, .scale = k->scale};
    TRY(section_outline_copy(a, &moved));
    section_outline_move(&moved, &motion);
    *alike = section_outline_is_turned(&moved, b, same_outline, &angle);

done:
    section_outline_free(&moved);
    return st;
}

static bool is_anisotropic(const section_store *store, const outline *o)
{
    return o->material >= 0 && o->material < store->request->nmaterial &&
           store->materials[o->material].kind != MATERIAL_ISOTROPIC;
}

static material_frame frame_of(const outline *o)
{
    return o->has_frame ? o->frame : material_frame_make(0, 0);
}

// whether the directions of the materials turn with the outlines
static bool directions_agree(const section_store *store, const section_outline *a,
                             const section_outline *b, const section_likeness *k)
{
    for (int i = 0; i < a->count && store->traits.anisotropic; i++) {
        material_frame from = frame_of(&a->items[i]);
        const material_frame to = frame_of(&b->items[i]);
        material_frame_move(&from, k->scale, b->turn - a->turn);
        if (is_anisotropic(store, &a->items[i]) &&
            !material_frame_is(&from, &to, same_outline, b->size)) {
            return false;
        }
    }
    return true;
}

static status is_like_outline(const section_store *store, const section_outline *a,
                              const section_outline *b, section_likeness *k, bool *alike)
{
    status st = OK;
    double angle = 0;
    *k = (section_likeness){.scale = 1};
    *alike = section_outline_is_turned(a, b, same_outline, &angle) &&
             (!store->traits.across || angle == 0);
    if (*alike || store->traits.across || a->count != b->count) {
        return OK;
    }
    k->scale = b->size / a->size;
    TRY(is_moved(a, b, k, alike));
    if (!*alike && !store->traits.anisotropic) {
        k->mirror = true;
        TRY(is_moved(a, b, k, alike));
    }

done:
    return st;
}

status section_store_alike(const section_store *store, const section_place *a,
                           const section_place *b, section_likeness *k, bool *alike)
{
    status st = OK;
    *alike = false;
    if (a->drawn != b->drawn || (store->traits.along && a->s != b->s)) {
        return OK;
    }
    if (a->drawn) {
        TRY(is_like_outline(store, &a->outline, &b->outline, k, alike));
        *alike = *alike && rates_agree(a, b, k, a->outline.size) &&
                 directions_agree(store, &a->outline, &b->outline, k);
        return OK;
    }
    *k = (section_likeness){.scale = b->scale / a->scale};
    double reach = 0;
    TRY(drawing_reach(store->request->drawing, &reach));
    *alike = a->slice == b->slice && rates_agree(a, b, k, reach) &&
             (!store->traits.across || (a->turn == b->turn && k->scale == 1));

done:
    return st;
}

// The law of b from that of a, both in frames that are turned with their patterns: lengths scale,
// and in a mirror y -> -y the strains gamma_y, kappa_x and tau change their signs.
static beam_law carried(beam_law law, const section_likeness *k)
{
    const double sign = k->mirror ? -1 : 1, a = k->scale;
    const double factor[6] = {a, sign * a, a, sign * a * a, a * a, sign * a * a};
    for (int i = 0; i < 36; i++) {
        law.K.a[i / 6][i % 6] *= factor[i / 6] * factor[i % 6];
    }
    law.area *= a * a;
    law.mass *= a * a;
    law.mass_centre[0] *= a;
    law.mass_centre[1] *= sign * a;
    return law;
}

static void count_reuse(section_effort *effort, const section_place *a, const section_place *b,
                        const section_likeness *k)
{
    if (k->mirror) {
        effort->nmirrored++;
    } else if (k->scale != 1) {
        effort->nscaled++;
    } else if (a->turn != b->turn) {
        effort->nturned++;
    } else if (a->s != b->s) { // else it is asked for again

        effort->nsame++;
    }
}

static status find(section_store *store, solved_section *out, bool *found)
{
    status st = OK;
    *found = false;
    for (int i = 0; i < store->count && !*found; i++) {
        const solved_section *known = &store->solved[i];
        section_likeness k = {0};
        TRY(section_store_alike(store, &known->place, &out->place, &k, found));
        if (*found) {
            out->turned = carried(known->turned, &k);
            out->mesh = known->mesh;
            // the very same section: a turn to the pattern and back would widen its bounds
            const bool same = k.scale == 1 && !k.mirror && out->place.turn == known->place.turn;
            out->body = same ? known->body : beam_law_turn(out->turned, -out->place.turn);
            count_reuse(&store->effort, &known->place, &out->place, &k);
        }
    }

done:
    return st;
}

// --- new ones

const material *section_store_materials(section_store *store, double s)
{
    for (int i = 0; store->frozen && i < store->request->nmaterial; i++) {
        store->frozen[i] = material_at(&store->materials[i], s);
    }
    return store->frozen ? store->frozen : store->materials;
}

// what an earlier run chose, of a mesh that the case describes as it did then
static mesh_options as_then(const section_case *c, const mesh_options *then)
{
    mesh_options o = c->mesh;
    o.order = then->order;
    o.layers = then->layers;
    o.finer = then->finer;
    return o;
}

// the law in the body frame, from an earlier run or solved
static status solve_or_recall(section_store *store, const section_place *p, beam_law *law,
                              mesh_options *mesh)
{
    status st = OK;
    hash key = {0};
    bool comparable = false;
    section_used used = {0};
    const section_case *c = store->request;
    if (c->known) { // else nobody recalls or keeps anything
        TRY(section_fingerprint(c, store->materials, p, &key, &comparable));
    }
    const int found = comparable ? section_known_find(c->known, key) : -1;
    if (found >= 0) {
        *law = c->known->law[found];
        used = (section_used){true, as_then(c, &c->known->mesh[found])};
        store->effort.nstored++;
    } else {
        TRY(section_solve_place(c, section_store_materials(store, p->s), p, law, &used));
        store->effort.nsolved++;
    }
    *mesh = used.mesh;
    if (store->count == 0) {
        TRY(section_resolution(c, section_store_materials(store, p->s), p, law,
                               &store->resolution));
    }
    store->effort.meshed = store->effort.meshed || used.meshed;
    if (comparable) {
        TRY(section_known_add(&store->laws, key, law, mesh));
    }

done:
    return st;
}

static status solve_new(section_store *store, solved_section *out)
{
    status st = OK;
    TRY(make_room(store));
    TRY(solve_or_recall(store, &out->place, &out->turned, &out->mesh));
    out->body = out->turned;
    out->turned = beam_law_turn(out->body, out->place.turn);

    solved_section *new = &store->solved[store->count];
    *new = *out;
    TRY(section_outline_copy(&out->place.outline, &new->place.outline));
    store->count++;

done:
    return st;
}

// What is graded over x and y, and materials with the section's own axes, stand still while the
// outlines turn: no pattern that turns as a whole.
static bool stands_still(const section_store *store, const section_place *p)
{
    bool still = store->traits.across;
    for (int i = 0; i < p->outline.count && store->traits.anisotropic; i++) {
        const outline *o = &p->outline.items[i];
        still = still || (is_anisotropic(store, o) && !o->has_frame);
    }
    return still;
}

status section_store_place(const section_store *store, double s, section_place *out)
{
    section_place p = {0};
    const status st = section_place_at(store->request, s, store->length, &p);
    if (store->request->model == MODEL_CLASSICAL) {
        p.turn_rate = 0;
        p.uneven = false;
    } else if (p.turn_rate != 0 && stands_still(store, &p)) {
        p.turn_rate = 0;
        p.uneven = true;
    }
    *out = p;
    return st;
}

status section_store_law(section_store *store, double s, solved_section *out)
{
    status st = OK;
    solved_section one = {0};
    bool found = false;
    TRY(section_store_place(store, s, &one.place));
    store->effort.uneven = store->effort.uneven || one.place.uneven;
    TRY(find(store, &one, &found));
    if (!found) {
        TRY(solve_new(store, &one));
    }
    *out = one;
    one = (solved_section){0};

done:
    section_place_free(&one.place);
    return st;
}
