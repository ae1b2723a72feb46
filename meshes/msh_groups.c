// meshes/msh_groups.c
// Physical groups and surfaces of a MSH file, and their materials.
#include "meshes/msh_reader.h"

#include "base/memory.h"

#include <stdio.h>
#include <string.h>

status msh_read_names(msh_reader *r)
{
    status st = OK;
    int count = 0, twice = -1;
    int64_t *numbers = NULL, dim = 0, number = 0;
    char name[MSH_NAME];
    if (r->group) {
        TRY(msh_fail(&r->c, "$PhysicalNames comes twice"));
    }
    TRY(msh_count(&r->c, "the number of names", false, 6, 6, &count));
    TRY(TAKE(r->group, (size_t)count));
    TRY(TAKE(numbers, (size_t)count));
    for (int i = 0; i < count; i++) {
        TRY(msh_int(&r->c, "a name's dimension", &dim));
        TRY(msh_int(&r->c, "a name's number", &number));
        TRY(msh_quoted(&r->c, name));
        if (dim == 2) {
            memcpy(r->group[r->ngroup].name, name, sizeof name);
            numbers[r->ngroup++] = number;
        }
    }
    TRY(id_map_make(r->ngroup, numbers, &r->groups, &twice));
    if (twice >= 0) {
        TRY(msh_fail(&r->c, "two physical groups have the number %lld", (long long)numbers[twice]));
    }

done:
    free(numbers);
    return st;
}

// --- 4.1: which groups a surface is in

static status add_group_of(msh_reader *r, int64_t number)
{
    status st = OK;
    TRY(msh_reserve((void **)&r->group_of, &r->group_room, (int64_t)r->ngroup_of + 1,
                    sizeof *r->group_of));
    r->group_of[r->ngroup_of++] = number < 0 ? -number : number; // negative: turned over

done:
    return st;
}

// tag, box, groups, boundaries; a point has a place and no boundaries
static status read_entity(msh_reader *r, int dim, int64_t *tag)
{
    status st = OK;
    double unused;
    int count = 0;
    int64_t number = 0;
    TRY(msh_int(&r->c, "an entity's tag", tag));
    for (int i = 0; i < (dim == 0 ? 3 : 6); i++) {
        TRY(msh_real(&r->c, "a bound of an entity", &unused));
    }
    for (int list = 0; list < (dim == 0 ? 1 : 2); list++) {
        TRY(msh_count(&r->c, list ? "a number of boundaries" : "a number of physical groups", true,
                      2, 4, &count));
        for (int i = 0; i < count; i++) {
            TRY(msh_int(&r->c, "a tag", &number));
            if (dim == 2 && list == 0) {
                TRY(add_group_of(r, number));
            }
        }
    }

done:
    return st;
}

status msh_read_entities(msh_reader *r)
{
    status st = OK;
    int count[4] = {0}, twice = -1;
    int64_t *tags = NULL, tag = 0;
    const char *what[] = {"the number of points", "the number of curves", "the number of surfaces",
                          "the number of volumes"};
    if (r->has_entities || !r->newer) {
        TRY(msh_fail(&r->c, r->newer ? "$Entities comes twice" : "MSH 2.2 has no $Entities"));
    }
    r->has_entities = true;
    TRY(msh_begin_numbers(r));
    for (int dim = 0; dim < 4; dim++) {
        TRY(msh_count(&r->c, what[dim], true, 10, 36, &count[dim]));
    }
    TRY(TAKE(r->surface, (size_t)count[2]));
    TRY(TAKE(tags, (size_t)count[2]));
    for (int dim = 0; dim < 4; dim++) {
        for (int i = 0; i < count[dim]; i++) {
            const int first = r->ngroup_of;
            TRY(read_entity(r, dim, &tag));
            if (dim == 2) {
                r->surface[i].first = first;
                r->surface[i].count = r->ngroup_of - first;
                tags[i] = tag;
            }
        }
    }
    TRY(id_map_make(count[2], tags, &r->surfaces, &twice));
    if (twice >= 0) {
        TRY(msh_fail(&r->c, "two surfaces have the number %lld", (long long)tags[twice]));
    }

done:
    free(tags);
    return st;
}

// --- materials

// a group without a name goes by its number
static const char *group_name(const msh_reader *r, int64_t number, char text[MSH_NAME])
{
    const int i = id_map_find(&r->groups, number);
    (void)snprintf(text, MSH_NAME, "%lld", (long long)number);
    return i >= 0 ? r->group[i].name : text;
}

static int material_of(msh_reader *r, int64_t number)
{
    char text[MSH_NAME];
    const int i = id_map_find(&r->groups, number);
    if (i < 0) {
        return part_by_name(r->parts, group_name(r, number, text));
    }
    msh_group *g = &r->group[i];
    if (!g->asked) {
        g->asked = true;
        g->material = part_by_name(r->parts, g->name);
    }
    return g->material;
}

status msh_group_material(msh_reader *r, int64_t group, int *material)
{
    char text[MSH_NAME];
    if (group <= 0) {
        return msh_fail(&r->c, "an element belongs to no physical group: which material is it of?");
    }
    *material = material_of(r, group);
    return *material != PART_UNKNOWN
               ? OK
               : part_unknown(r->parts, r->c.file, r->c.binary ? 0 : r->c.line,
                              group_name(r, group, text));
}

// A surface may be in several groups; those that name materials must agree.
static status ask_surface(msh_reader *r, int64_t tag, msh_surface *s)
{
    status st = OK;
    char a[MSH_NAME], b[MSH_NAME];
    int named = -1;
    if (s->count == 0) {
        TRY(msh_fail(&r->c, "surface %lld belongs to no physical group: which material is it of?",
                     (long long)tag));
    }
    s->material = PART_UNKNOWN;
    for (int i = s->first; i < s->first + s->count; i++) {
        const int material = material_of(r, r->group_of[i]);
        if (material == PART_UNKNOWN) {
            continue;
        }
        if (named >= 0 && material != s->material) {
            TRY(msh_fail(&r->c,
                         "surface %lld is in the groups '%.60s' and '%.60s', which are of "
                         "different materials",
                         (long long)tag, group_name(r, r->group_of[named], a),
                         group_name(r, r->group_of[i], b)));
        }
        named = i;
        s->material = material;
    }
    if (named < 0) {
        TRY(msh_group_material(r, r->group_of[s->first], &s->material));
    }
    s->asked = true;

done:
    return st;
}

status msh_surface_material(msh_reader *r, int64_t tag, int *material)
{
    status st = OK;
    const int i = id_map_find(&r->surfaces, tag);
    if (i < 0) {
        TRY(msh_fail(&r->c,
                     r->has_entities ? "there is no surface %lld in $Entities"
                                     : "elements of surface %lld come before $Entities",
                     (long long)tag));
    }
    msh_surface *s = &r->surface[i];
    if (!s->asked) {
        TRY(ask_surface(r, tag, s));
    }
    *material = s->material;

done:
    return st;
}
