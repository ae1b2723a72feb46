// section/along.c
#include "base/memory.h"
#include "section/along_error.h"
#include "section/reuse.h"
#include "section/section.h"
#include "section/stack.h"

#include <math.h>
#include <string.h>

// Nodes per panel and panels tried, in this order: nested nodes first, then halved panels.
typedef struct layout {
    int npanel, nnode;
} layout;
static const layout layouts[] = {
    {1, 5},  {1, 9},  {1, 17}, {1, 33}, {2, 9},  {2, 17}, {2, 33},  {4, 9},
    {4, 17}, {4, 33}, {8, 9},  {8, 17}, {8, 33}, {16, 9}, {16, 17}, {16, 33},
};
enum { NLAYOUT = sizeof layouts / sizeof *layouts, MOST_STATIONS = 1000 };

// Along the rod, where the case gives none: rods then are good to 1e-11 m.
static const double default_tolerance = 1e-10;

// The probe's place in a panel: irrational, far from any node of small layouts.
static const double probe_place = 0.38196601125010515;
// The probe may miss by this many times the tolerance: the coefficients tell the error's size, the
// probe that it is not another function that the nodes see.
static const double probe_slack = 10;

static status fill(section_store *store, law_along *along)
{
    status st = OK;
    bool all = true;
    for (int k = 0; k < along->npanel; k++) {
        for (int i = 0; i < along->nnode; i++) {
            const int node = k * along->nnode + i;
            solved_section one = {0};
            TRY(section_store_law(store, law_along_node(along, k, i), &one));
            along->law[node] = one.turned;
            along->turn[node] = one.place.turn;
            all = all && one.place.has_symmetry;
            section_place_free(&one.place);
        }
    }
    along->symmetric = all;

done:
    return st;
}

// the interpolant against a section solved between the nodes
static status probe(section_store *store, const law_along *along, int panel, double *miss)
{
    status st = OK;
    solved_section one = {0};
    const double a = along->edge[panel], b = along->edge[panel + 1];
    const double s = a + probe_place * (b - a);
    TRY(section_store_law(store, s, &one));
    *miss = along_miss(along, s, &one.turned, one.place.turn);

done:
    section_place_free(&one.place);
    return st;
}

// Sections on meshes differ by their own error from station to station: no interpolant can be asked
// to be closer. Turned copies of one section do not, and turns are known exactly.
static double reachable(const section_store *store, const law_along *along, double tolerance)
{
    for (int i = 0; store->count > 1 && i < along->npanel * along->nnode; i++) {
        tolerance = fmax(tolerance, along->law[i].relative_error);
    }
    return tolerance;
}

// the panel that is worst, by its error over what is allowed
typedef struct judgement {
    double ratio, error;
    int panel;
} judgement;

static void keep_worst(judgement *worst, double error, double allowed, int panel)
{
    if (!(error / allowed <= worst->ratio)) {
        *worst = (judgement){error / allowed, error, panel};
    }
}

// The nodes of a layout lie among those of the next one with the same panels: what the coarser
// interpolant misses at the new ones is known without another section. Where it misses no more than
// its coefficients promise, they are believed.
static bool confirmed(const law_along *coarse, const law_along *fine, double allowed)
{
    if (coarse->npanel != fine->npanel || fine->nnode != 2 * coarse->nnode - 1) {
        return false;
    }
    const double promised = fmax(coarse->relative_error, allowed);
    for (int k = 0; k < fine->npanel; k++) {
        for (int i = 1; i < fine->nnode; i += 2) {
            const int node = k * fine->nnode + i;
            const double s = law_along_node(fine, k, i);
            const double miss = along_miss(coarse, s, &fine->law[node], fine->turn[node]);
            if (!(miss <= probe_slack * promised)) {
                return false;
            }
        }
    }
    return true;
}

static status judge(section_store *store, const law_along *coarse, law_along *along,
                    double tolerance, judgement *worst)
{
    status st = OK;
    const double allowed = reachable(store, along, tolerance);
    *worst = (judgement){0};
    along->relative_error = 0;
    for (int k = 0; k < along->npanel; k++) {
        const double law = along_law_error(along, k), turn = along_turn_error(along, k);
        keep_worst(worst, law, allowed, k);
        keep_worst(worst, turn, tolerance, k);
        along->relative_error = fmax(along->relative_error, fmax(law, turn));
    }
    const bool believed = worst->ratio <= 1 && confirmed(coarse, along, allowed);
    for (int k = 0; k < along->npanel && worst->ratio <= 1 && !believed; k++) {
        double miss = 0;
        TRY(probe(store, along, k, &miss));
        keep_worst(worst, miss, probe_slack * allowed, k);
    }

done:
    return st;
}

static status one_station(section_store *store, double length, law_along *out)
{
    status st = OK;
    TRY(law_along_make(length, 1, 1, out));
    TRY(fill(store, out));

done:
    return st;
}

static status interpolate(section_store *store, double length, double tolerance, law_along *out)
{
    status st = OK;
    law_along along = {0}, coarse = {0};
    judgement j = {0};
    for (int k = 0; k < NLAYOUT; k++) {
        law_along_free(&coarse);
        coarse = along;
        along = (law_along){0};
        TRY(law_along_make(length, layouts[k].npanel, layouts[k].nnode, &along));
        TRY(fill(store, &along));
        TRY(judge(store, &coarse, &along, tolerance, &j));
        if (j.ratio <= 1) {
            *out = along;
            along = (law_along){0};
            goto done;
        }
    }
    TRY(status_fail(
        ERR_NUMERIC,
        "section: its stiffness along the rod is not resolved to %.1e by %d panels of %d "
        "stations (still %.1e off between s = %.4g mm and %.4g mm): is there a jump?",
        tolerance, along.npanel, along.nnode, j.error, 1e3 * along.edge[j.panel],
        1e3 * along.edge[j.panel + 1]));

done:
    law_along_free(&along);
    law_along_free(&coarse);
    return st;
}

// --- stations

// Principal axes: the declared axis of symmetry, else the axis of the largest int E x'^2 first and
// from there on the one that goes on with the pattern's turn.
typedef struct axis_memory {
    bool begun;
    double angle, turn; // of the last station
} axis_memory;

static status add_station(section_store *store, double s, axis_memory *axis, section_result *r)
{
    status st = OK;
    section_station *new = &r->station[r->nstation];
    solved_section one = {0};
    const section_place *p = &one.place;
    new->s = s;
    TRY(section_store_law(store, s, &one));
    new->turn_rate = p->turn_rate;
    new->law = one.body;
    new->mesh = one.mesh;
    if (p->has_symmetry) {
        TRY(beam_law_centres_near(&new->law, p->turn, &new->centres));
    } else if (axis->begun) {
        const double near = axis->angle + p->turn - axis->turn;
        TRY(beam_law_centres_near(&new->law, near, &new->centres));
    } else {
        TRY(beam_law_centres(&new->law, &new->centres));
    }
    *axis = (axis_memory){true, new->centres.principal_angle, p->turn};
    r->nstation++;

done:
    section_place_free(&one.place);
    return st;
}

static status asked_stations(section_store *store, const key_rows *rows, double length,
                             section_result *r)
{
    status st = OK;
    axis_memory axis = {0};
    const int count = rows->nrow * rows->ncol;
    if (count > MOST_STATIONS) {
        TRY(status_fail(ERR_INPUT, "section: %d stations are more than %d", count, MOST_STATIONS));
    }
    TRY(TAKE(r->station, (size_t)count));
    for (int i = 0; i < count; i++) {
        const double s = rows->a[i];
        if (!(s >= 0 && s <= length * (1 + 1e-12))) {
            TRY(status_fail_at(ERR_INPUT, rows->at.line, rows->at.column,
                               "section: the station at s = %g mm lies outside the rod, 0 to %g mm",
                               1e3 * s, 1e3 * length));
        }
        TRY(add_station(store, s, &axis, r));
    }

done:
    return st;
}

static status own_stations(section_store *store, section_result *r)
{
    status st = OK;
    axis_memory axis = {0};
    const law_along *along = &r->along;
    if (along->npanel * along->nnode == 1) {
        TRY(TAKE(r->station, 1));
        TRY(add_station(store, 0, &axis, r));
        store->effort.nsame = 0; // the same one, asked for at its beginning
        goto done;
    }
    TRY(TAKE(r->station, (size_t)along->npanel * (size_t)along->nnode));
    for (int k = 0; k < along->npanel; k++) {
        // panels share their ends
        for (int i = k > 0 && along->nnode > 1; i < along->nnode; i++) {
            TRY(add_station(store, law_along_node(along, k, i), &axis, r));
        }
    }

done:
    return st;
}

status section_along(const section_case *c, const material *materials, double length,
                     section_result *out)
{
    status st = OK;
    section_result r = {0};
    section_store store = {0};
    TRY(section_store_make(c, materials, length, &store));
    if (section_own_length(c) > 0) {
        TRY(stack_laws(&store, length, &r.along));
    } else {
        TRY(section_varies(c) || store.traits.along
                ? interpolate(&store, length, c->tolerance > 0 ? c->tolerance : default_tolerance,
                              &r.along)
                : one_station(&store, length, &r.along));
    }
    TRY(c->stations.nrow > 0 ? asked_stations(&store, &c->stations, length, &r)
                             : own_stations(&store, &r));
    r.effort = store.effort;
    r.resolution = store.resolution;
    r.solved = store.laws;
    store.laws = (section_known){0};
    *out = r;
    r = (section_result){0};

done:
    section_store_free(&store);
    section_result_free(&r);
    return st;
}

void section_result_free(section_result *r)
{
    free(r->station);
    law_along_free(&r->along);
    section_known_free(&r->solved);
    *r = (section_result){0};
}
