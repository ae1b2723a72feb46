// reports/store_answers.c
// What is asked of sections beyond their laws, and the strains of rods, on their way to the store
// and back.
#include "reports/store_parts.h"

#include <stdio.h>

typedef struct rod_run rod_run;

#define AT(type, member) offsetof(type, member)

enum { MOST_CORNERS = 10000000 };

static status pass_kern(const passage *p, const char *group, section_answers *a)
{
    static const column corner = {"kern_m", COLUMN_REAL, "m", 0, 1, {2}, 0};
    status st = OK;
    int n = a->nkern;
    TRY(passage_count(p, passage_join(group, "kern_count").text, 0, MOST_CORNERS, &n));
    TRY(passage_room(p, (void **)&a->kern, (size_t)n, sizeof *a->kern));
    a->nkern = n;
    TRY(n > 0 ? passage_columns(p, group, 1, &corner, rows_of(a->kern, n, sizeof *a->kern)) : OK);

done:
    return st;
}

static status pass_extremes(const passage *p, const char *group, int nmaterial,
                            section_load_answer *load)
{
#define EXTREME(member) AT(section_extremes, member)
    static const column columns[] = {
        {"used", COLUMN_FLAG, "-", EXTREME(used), 0, {0}, 0},
        {"largest_strain", COLUMN_REAL, "-", EXTREME(strain.value), 0, {0}, 0},
        {"largest_strain_at_m", COLUMN_REAL, "m", EXTREME(strain.at), 1, {2}, 0},
        {"von_mises_Pa", COLUMN_REAL, "Pa", EXTREME(von_mises.value), 0, {0}, 0},
        {"von_mises_at_m", COLUMN_REAL, "m", EXTREME(von_mises.at), 1, {2}, 0},
        {"axial_highest_Pa", COLUMN_REAL, "Pa", EXTREME(axial_highest.value), 0, {0}, 0},
        {"axial_highest_at_m", COLUMN_REAL, "m", EXTREME(axial_highest.at), 1, {2}, 0},
        {"axial_lowest_Pa", COLUMN_REAL, "Pa", EXTREME(axial_lowest.value), 0, {0}, 0},
        {"axial_lowest_at_m", COLUMN_REAL, "m", EXTREME(axial_lowest.at), 1, {2}, 0},
    };
    status st = OK;
    TRY(passage_room(p, (void **)&load->extreme, (size_t)nmaterial, sizeof *load->extreme));
    TRY(passage_columns(p, group, COUNT_OF(columns), columns,
                        rows_of(load->extreme, nmaterial, sizeof *load->extreme)));

done:
    return st;
}

static status pass_fields(const passage *p, const char *group, int nnode, section_load_answer *load)
{
    static const column strain = {"strain", COLUMN_REAL, "-", 0, 1, {6}, 0};
    static const column stress = {"stress_Pa", COLUMN_REAL, "Pa", 0, 1, {6}, 0};
    status st = OK;
    if (nnode == 0) {
        return OK;
    }
    TRY(passage_room(p, (void **)&load->strain, (size_t)nnode, sizeof *load->strain));
    TRY(passage_room(p, (void **)&load->stress, (size_t)nnode, sizeof *load->stress));
    TRY(passage_columns(p, group, 1, &strain, rows_of(load->strain, nnode, sizeof *load->strain)));
    TRY(passage_columns(p, group, 1, &stress, rows_of(load->stress, nnode, sizeof *load->stress)));

done:
    return st;
}

static status pass_loads(const passage *p, const char *group, int nmaterial, section_answers *a)
{
    static const column columns[] = {
        {"name", COLUMN_TEXT, "-", AT(section_load_answer, name), 0, {sizeof a->load->name}, 0},
        {"at_m", COLUMN_REAL, "m", AT(section_load_answer, at), 1, {2}, 0},
        {"force_N", COLUMN_REAL, "N", AT(section_load_answer, force), 1, {3}, 0},
        {"moment_Nm", COLUMN_REAL, "N m", AT(section_load_answer, moment), 1, {3}, 0},
    };
    status st = OK;
    int n = a->nload;
    const passage_name inner = passage_join(group, "wrench");
    TRY(passage_count(p, passage_join(group, "wrench_count").text, 0, MOST_LOADS, &n));
    TRY(passage_room(p, (void **)&a->load, (size_t)n, sizeof *a->load));
    a->nload = n;
    TRY(passage_columns(p, inner.text, COUNT_OF(columns), columns,
                        rows_of(a->load, n, sizeof *a->load)));
    for (int i = 0; i < n; i++) {
        char tail[32];
        (void)snprintf(tail, sizeof tail, "%d", i);
        const passage_name one = passage_join(inner.text, tail);
        TRY(pass_extremes(p, one.text, nmaterial, &a->load[i]));
        TRY(pass_fields(p, one.text, a->nodes.nnode, &a->load[i]));
    }

done:
    return st;
}

static status pass_answer(const passage *p, int index, int nmaterial, section_answers *a)
{
    char group[64];
    status st = OK;
    (void)snprintf(group, sizeof group, "section/answers/%d", index);
    TRY(pass_kern(p, group, a));
    TRY(passage_mesh(p, passage_join(group, "mesh").text, 2, nmaterial, &a->nodes));
    TRY(pass_loads(p, group, nmaterial, a));

done:
    return st;
}

status store_pass_answers(const passage *p, run_result *r)
{
#define ANSWER(member) AT(section_answers, member)
    const column columns[] = {
        {"station", COLUMN_INT, "-", ANSWER(station), 0, {0}, r->section.nstation - 1},
        {"geometric_centre_m", COLUMN_REAL, "m", ANSWER(mass.centre), 1, {2}, 0},
        {"mass_known", COLUMN_FLAG, "-", ANSWER(mass.known), 0, {0}, 0},
        {"mass_kg_per_m", COLUMN_REAL, "kg/m", ANSWER(mass.mass), 0, {0}, 0},
        {"mass_centre_m", COLUMN_REAL, "m", ANSWER(mass.mass_centre), 1, {2}, 0},
        {"mass_matrix", COLUMN_REAL, "kg/m, kg, kg m", ANSWER(mass.matrix), 2, {6, 6}, 0},
        {"EI_warping_Nm4", COLUMN_ANY, "N m^4", ANSWER(EI_warping), 0, {0}, 0},
    };
    static const column place = {"point_m", COLUMN_REAL, "m", 0, 1, {2}, 0};
    status st = OK;
    int n = r->nanswer, npoint = r->npoint;
    TRY(passage_count(p, "section/point_count", 0, MOST_POINTS, &npoint));
    TRY(passage_room(p, (void **)&r->point, (size_t)npoint, sizeof *r->point));
    r->npoint = npoint;
    TRY(passage_columns(p, "section", 1, &place, rows_of(r->point, npoint, sizeof *r->point)));
    TRY(passage_count(p, "section/answer_count", 0, r->section.nstation, &n));
    TRY(passage_room(p, (void **)&r->answer, (size_t)n, sizeof *r->answer));
    r->nanswer = n;
    TRY(passage_columns(p, "section/answers", COUNT_OF(columns), columns,
                        rows_of(r->answer, n, sizeof *r->answer)));
    for (int i = 0; i < n; i++) {
        TRY(pass_answer(p, i, r->nmaterial, &r->answer[i]));
    }

done:
    return st;
}

status store_pass_strains(const passage *p, run_result *r)
{
#define PLACE(member) AT(section_strain_place, member)
    static const column columns[] = {
        {"strain", COLUMN_REAL, "-", PLACE(value), 0, {0}, 0},
        {"s_m", COLUMN_REAL, "m", PLACE(s), 0, {0}, 0},
        {"at_m", COLUMN_REAL, "m", PLACE(at), 1, {2}, 0},
    };
    status st = OK;
    int known = r->rod.nsolution > 0 && r->rod.run[0].strain;
    TRY(passage_count(p, "rod/strains_known", 0, 1, &known));
    for (int i = 0; known && i < r->rod.nsolution; i++) {
        rod_run *run = &r->rod.run[i];
        char group[64];
        (void)snprintf(group, sizeof group, "rod/material_strain/%d", i);
        TRY(passage_room(p, (void **)&run->strain, (size_t)r->nmaterial, sizeof *run->strain));
        TRY(passage_columns(p, group, COUNT_OF(columns), columns,
                            rows_of(run->strain, r->nmaterial, sizeof *run->strain)));
    }

done:
    return st;
}
