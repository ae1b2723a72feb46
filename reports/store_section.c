// reports/store_section.c
#include "reports/store_parts.h"

#include <limits.h>

static status pass_stations(const passage *p, run_result *r)
{
#define STATION(member) offsetof(section_station, member)
    static const column columns[] = {
        {"s_m", COLUMN_REAL, "m", STATION(s), 0, {0}, 0},
        {"turn_rate_rad_per_m", COLUMN_REAL, "rad/m", STATION(turn_rate), 0, {0}, 0},
        {"area_m2", COLUMN_POSITIVE, "m^2", STATION(law.area), 0, {0}, 0},
        {"mass_kg_per_m", COLUMN_REAL, "kg/m", STATION(law.mass), 0, {0}, 0},
        {"mass_centre_m", COLUMN_REAL, "m", STATION(law.mass_centre), 1, {2}, 0},
        {"K", COLUMN_REAL, STIFFNESS_UNIT, STATION(law.K), 2, {6, 6}, 0},
        {"relative_error", COLUMN_ANY, "-", STATION(law.relative_error), 0, {0}, 0},
        {"K_relative_error", COLUMN_ANY, "-", STATION(law.entry_error), 2, {6, 6}, 0},
        {"EA_N", COLUMN_POSITIVE, "N", STATION(centres.EA), 0, {0}, 0},
        {"stiffness_centre_m", COLUMN_REAL, "m", STATION(centres.stiffness_centre), 1, {2}, 0},
        {"EI_centre_Nm2", COLUMN_REAL, "N m^2", STATION(centres.EI_centre), 1, {3}, 0},
        {"EI_Nm2", COLUMN_POSITIVE, "N m^2", STATION(centres.EI), 1, {2}, 0},
        {"principal_angle_rad", COLUMN_REAL, "rad", STATION(centres.principal_angle), 0, {0}, 0},
        {"isotropic", COLUMN_FLAG, "-", STATION(centres.isotropic), 0, {0}, 0},
        {"GJ_Nm2", COLUMN_POSITIVE, "N m^2", STATION(centres.GJ), 0, {0}, 0},
        {"shear_centre_m", COLUMN_REAL, "m", STATION(centres.shear_centre), 1, {2}, 0},
    };
#undef STATION
    status st = OK;
    section_result *s = &r->section;
    int n = s->nstation;
    // figures and page look at the first one
    TRY(passage_count(p, "section/station_count", 1, MOST_STATIONS, &n));
    TRY(passage_room(p, (void **)&s->station, (size_t)n, sizeof *s->station));
    s->nstation = n;
    TRY(passage_columns(p, "section", COUNT_OF(columns), columns,
                        rows_of(s->station, n, sizeof *s->station)));

done:
    return st;
}

// what evaluates the law relies on panels that follow one another from 0 to the length, and on
// stiffnesses that are some
static status check_along(const passage *p, const law_along *a)
{
    for (int i = 0; i < a->npanel * a->nnode; i++) {
        if (beam_law_check(&a->law[i]) != OK) {
            status_clear();
            return passage_damaged(p, "section/along/K", "is no stiffness");
        }
    }
    bool ok = a->edge[0] == 0 && a->edge[a->npanel] == a->length;
    for (int k = 0; k < a->npanel; k++) {
        ok = ok && a->edge[k] < a->edge[k + 1];
    }
    return ok ? OK : passage_damaged(p, "section/along/edge_m", "does not ascend to the length");
}

static status pass_along(const passage *p, law_along *a)
{
    static const column head[] = {
        {"relative_error", COLUMN_ANY, "-", offsetof(law_along, relative_error), 0, {0}, 0},
        {"symmetric", COLUMN_FLAG, "-", offsetof(law_along, symmetric), 0, {0}, 0},
    };
    static const column laws[] = {
        {"K", COLUMN_REAL, STIFFNESS_UNIT, offsetof(beam_law, K), 2, {6, 6}, 0},
        {"area_m2", COLUMN_POSITIVE, "m^2", offsetof(beam_law, area), 0, {0}, 0},
        {"mass_kg_per_m", COLUMN_REAL, "kg/m", offsetof(beam_law, mass), 0, {0}, 0},
        {"mass_centre_m", COLUMN_REAL, "m", offsetof(beam_law, mass_centre), 1, {2}, 0},
        {"law_relative_error", COLUMN_ANY, "-", offsetof(beam_law, relative_error), 0, {0}, 0},
    };
    static const column length = {"length_m", COLUMN_POSITIVE, "m", 0, 0, {0}, 0};
    static const column edge = {"edge_m", COLUMN_REAL, "m", 0, 0, {0}, 0};
    static const column turn = {"turn_rad", COLUMN_REAL, "rad", 0, 0, {0}, 0};
    static const char group[] = "section/along";
    status st = OK;
    int npanel = a->npanel, nnode = a->nnode;
    double L = a->length;
    TRY(passage_count(p, "section/along/panel_count", 0, MOST_PANELS, &npanel));
    if (npanel == 0) {
        return OK;
    }
    TRY(passage_count(p, "section/along/node_count", 1, LAW_ALONG_MAX_NODES, &nnode));
    TRY(passage_columns(p, group, 1, &length, single(&L)));
    if (p->reading) {
        TRY(law_along_make(L, npanel, nnode, a));
    }
    const int n = npanel * nnode;
    TRY(passage_columns(p, group, COUNT_OF(head), head, single(a)));
    TRY(passage_columns(p, group, 1, &edge, rows_of(a->edge, npanel + 1, sizeof(double))));
    TRY(passage_columns(p, group, COUNT_OF(laws), laws, rows_of(a->law, n, sizeof *a->law)));
    TRY(passage_columns(p, group, 1, &turn, rows_of(a->turn, n, sizeof(double))));
    TRY(p->reading ? check_along(p, a) : OK);

done:
    return st;
}

status store_pass_section(const passage *p, run_result *r)
{
#define EFFORT(member) offsetof(run_result, section.effort.member)
    static const column columns[] = {
        {"model", COLUMN_INT, "-", offsetof(run_result, section_model), 0, {0}, MODEL_CLASSICAL},
        {"meshed", COLUMN_FLAG, "-", EFFORT(meshed), 0, {0}, 0},
        {"solved", COLUMN_INT, "-", EFFORT(nsolved), 0, {0}, INT_MAX},
        {"same", COLUMN_INT, "-", EFFORT(nsame), 0, {0}, INT_MAX},
        {"turned", COLUMN_INT, "-", EFFORT(nturned), 0, {0}, INT_MAX},
        {"scaled", COLUMN_INT, "-", EFFORT(nscaled), 0, {0}, INT_MAX},
        {"mirrored", COLUMN_INT, "-", EFFORT(nmirrored), 0, {0}, INT_MAX},
        {"recalled", COLUMN_INT, "-", EFFORT(nstored), 0, {0}, INT_MAX},
        {"uneven", COLUMN_FLAG, "-", EFFORT(uneven), 0, {0}, 0},
        {"pixel_relative_error",
         COLUMN_ANY,
         "-",
         offsetof(run_result, section.resolution),
         0,
         {0},
         0},
        {"symmetry_turn_rad", COLUMN_REAL, "rad", offsetof(run_result, symmetry_turn), 0, {0}, 0},
    };
#undef EFFORT
    status st = OK;
    TRY(passage_columns(p, "section", COUNT_OF(columns), columns, single(r)));
    TRY(pass_stations(p, r));
    TRY(pass_along(p, &r->section.along));
    TRY(passage_mesh(p, "section/mesh", 2, r->nmaterial, &r->section_mesh));
    TRY(store_pass_answers(p, r));

done:
    return st;
}
