// meshes/msh.c
#include "meshes/msh_reader.h"

#include "base/memory.h"
#include "meshes/sniff.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

status msh_reserve(void **items, int *room, int64_t need, size_t each)
{
    if (need <= *room) {
        return OK;
    }
    const int64_t wanted = need + need / 2 + 64;
    void *more = wanted < INT_MAX ? realloc(*items, (size_t)wanted * each) : NULL;
    if (!more) {
        return status_fail(ERR_RESOURCE, "not enough memory for the mesh");
    }
    *items = more;
    *room = (int)wanted;
    return OK;
}

status msh_begin_numbers(msh_reader *r)
{
    if (!r->bytes) {
        return OK;
    }
    const unsigned char *stop = memchr(r->c.at, '\n', (size_t)(r->c.end - r->c.at));
    if (!stop) {
        return msh_fail(&r->c, "the file ends here: it is not complete");
    }
    r->c.at = stop + 1;
    r->c.binary = true;
    r->c.swapped = r->swapped;
    return OK;
}

// --- $MeshFormat

static status read_byte_order(msh_reader *r)
{
    status st = OK;
    int64_t one = 0;
    r->bytes = true;
    TRY(msh_begin_numbers(r));
    TRY(msh_int(&r->c, "the number 1", &one));
    if (one != 1 && one != 1 << 24) {
        TRY(msh_fail(&r->c, "the number 1 that tells the order of bytes is %lld", (long long)one));
    }
    r->swapped = one != 1;

done:
    return st;
}

static status read_format(msh_reader *r)
{
    status st = OK;
    double version = 0;
    int64_t bytes = 0, width = 0;
    TRY(msh_real(&r->c, "the version", &version));
    TRY(msh_int(&r->c, "the file's type", &bytes));
    TRY(msh_int(&r->c, "the size of numbers", &width));
    r->newer = version == 4.1;
    if (!r->newer && version != 2.2) {
        TRY(msh_fail(&r->c,
                     "MSH version %g is not read; 2.2 and 4.1 are (gmsh -save -format msh41)",
                     version));
    }
    if ((bytes != 0 && bytes != 1) || width != 8) {
        TRY(msh_fail(&r->c, "a file of type %lld with numbers of %lld bytes is not read",
                     (long long)bytes, (long long)width));
    }
    if (bytes == 1) {
        TRY(read_byte_order(r));
    }

done:
    return st;
}

// --- $Nodes

status msh_add_node(msh_reader *r, const double *xyz, int *index)
{
    status st = OK;
    raw_mesh *m = &r->raw;
    int room = r->node_room;
    TRY(msh_reserve((void **)&m->node_id, &room, (int64_t)m->nnode + 1, sizeof *m->node_id));
    TRY(msh_reserve((void **)&m->xyz, &r->node_room, (int64_t)m->nnode + 1, 3 * sizeof *m->xyz));
    m->node_id[m->nnode] = 0;
    memcpy(m->xyz + 3 * (size_t)m->nnode, xyz, 3 * sizeof *xyz);
    *index = m->nnode++;

done:
    return st;
}

static status read_place(msh_reader *r, double *xyz)
{
    status st = OK;
    TRY(msh_real(&r->c, "x of a node", &xyz[0]));
    TRY(msh_real(&r->c, "y of a node", &xyz[1]));
    TRY(msh_real(&r->c, "z of a node", &xyz[2]));

done:
    return st;
}

static status read_older_nodes(msh_reader *r)
{
    status st = OK;
    raw_mesh *m = &r->raw;
    for (int i = 0; i < m->nnode; i++) {
        TRY(msh_int(&r->c, "a node's number", &m->node_id[i]));
        TRY(read_place(r, m->xyz + 3 * (size_t)i));
    }

done:
    return st;
}

static status read_node_block(msh_reader *r, int *first)
{
    status st = OK;
    raw_mesh *m = &r->raw;
    int64_t dim = 0, tag = 0, parametric = 0;
    int count = 0;
    double unused;
    TRY(msh_int(&r->c, "the dimension of a block of nodes", &dim));
    TRY(msh_int(&r->c, "the entity of a block of nodes", &tag));
    TRY(msh_int(&r->c, "whether nodes are parametric", &parametric));
    TRY(msh_count(&r->c, "the number of nodes of a block", true, 8, 32, &count));
    if (dim < 0 || dim > 3 || parametric < 0 || parametric > 1 || count > m->nnode - *first) {
        TRY(msh_fail(&r->c, "a block of %d nodes makes no sense here", count));
    }
    for (int i = *first; i < *first + count; i++) {
        TRY(msh_size(&r->c, "a node's number", &m->node_id[i]));
    }
    for (int i = *first; i < *first + count; i++) {
        TRY(read_place(r, m->xyz + 3 * (size_t)i));
        for (int k = 0; parametric && k < dim; k++) {
            TRY(msh_real(&r->c, "a node's parameter", &unused));
        }
    }
    *first += count;

done:
    return st;
}

static status read_newer_nodes(msh_reader *r, int nblock)
{
    status st = OK;
    int first = 0;
    for (int b = 0; b < nblock; b++) {
        TRY(read_node_block(r, &first));
    }
    if (first != r->raw.nnode) {
        TRY(msh_fail(&r->c, "%d nodes are announced, and %d come", r->raw.nnode, first));
    }

done:
    return st;
}

status msh_read_nodes(msh_reader *r)
{
    status st = OK;
    raw_mesh *m = &r->raw;
    int nblock = 0, twice = -1;
    int64_t unused;
    if (r->has_nodes) {
        TRY(msh_fail(&r->c, "$Nodes comes twice"));
    }
    r->has_nodes = true;
    if (r->newer) {
        TRY(msh_begin_numbers(r));
        TRY(msh_count(&r->c, "the number of blocks of nodes", true, 8, 20, &nblock));
    }
    TRY(msh_count(&r->c, "the number of nodes", r->newer, 8, r->newer ? 32 : 28, &m->nnode));
    TRY(TAKE(m->node_id, (size_t)m->nnode + 1));
    TRY(TAKE(m->xyz, 3 * ((size_t)m->nnode + 1)));
    r->node_room = m->nnode + 1;
    if (r->newer) {
        TRY(msh_size(&r->c, "the least number of a node", &unused));
        TRY(msh_size(&r->c, "the largest number of a node", &unused));
        TRY(read_newer_nodes(r, nblock));
    } else {
        TRY(msh_begin_numbers(r));
        TRY(read_older_nodes(r));
    }
    TRY(id_map_make(m->nnode, m->node_id, &r->nodes, &twice));
    if (twice >= 0) {
        TRY(msh_fail(&r->c, "two nodes have the number %lld", (long long)m->node_id[twice]));
    }

done:
    return st;
}

// --- sections

static const struct {
    const char *name;
    status (*read)(msh_reader *r);
} sections[] = {
    {"$PhysicalNames", msh_read_names},
    {"$Entities", msh_read_entities},
    {"$Nodes", msh_read_nodes},
    {"$Elements", msh_read_elements},
    {"$ElementData", msh_read_element_data},
};

status msh_skip_section(msh_reader *r, const char *name)
{
    char end[MSH_NAME + 8];
    const size_t n = (size_t)snprintf(end, sizeof end, "$End%s", name + 1);
    do {
        msh_skip_line(&r->c);
        if ((size_t)(r->c.end - r->c.at) < n) {
            return msh_fail(&r->c, "%s has no %s: the file is not complete", name, end);
        }
    } while (memcmp(r->c.at, end, n) != 0);
    return OK;
}

static status read_section(msh_reader *r, const char *name)
{
    if (strcmp(name, "$PartitionedEntities") == 0) {
        return msh_fail(&r->c, "a mesh in partitions is not read");
    }
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++) {
        if (strcmp(name, sections[i].name) == 0) {
            return sections[i].read(r);
        }
    }
    return msh_skip_section(r, name);
}

static status read_sections(msh_reader *r)
{
    status st = OK;
    char name[MSH_NAME], end[MSH_NAME];
    for (bool first = true; first || !msh_at_end(&r->c); first = false) {
        TRY(msh_word(&r->c, name));
        if (name[0] != '$' || strncmp(name, "$End", 4) == 0) {
            TRY(msh_fail(&r->c, "a section's name is wanted here, $Nodes for one, not '%.40s'",
                         name));
        }
        TRY(first ? read_format(r) : read_section(r, name));
        r->c.binary = false;
        TRY(msh_word(&r->c, end));
        if (strncmp(end, "$End", 4) != 0 || strcmp(end + 4, name + 1) != 0) {
            TRY(msh_fail(&r->c, "$End%.60s is wanted here, not '%.40s'", name + 1, end));
        }
    }

done:
    return st;
}

static status check_parts(const msh_reader *r)
{
    status st = OK;
    const char **names = NULL;
    TRY(TAKE(names, (size_t)r->ngroup));
    for (int i = 0; i < r->ngroup; i++) {
        names[i] = r->group[i].name;
    }
    TRY(parts_all_used(r->parts, r->ngroup, names));

done:
    free(names);
    return st;
}

static void reader_free(msh_reader *r)
{
    free(r->group);
    free(r->surface);
    free(r->group_of);
    id_map_free(&r->groups);
    id_map_free(&r->surfaces);
    id_map_free(&r->nodes);
    id_map_free(&r->elements);
    for (int k = 0; k < VIEW_KINDS; k++) {
        free(r->view[k]);
        free(r->viewed[k]);
    }
    raw_mesh_free(&r->raw);
}

status msh_read(const input_file *file, part_table *parts, double unit, raw_mesh *out)
{
    status st = OK;
    char words[SNIFF_WORDS];
    msh_reader r = {.c = msh_cursor_at_start(file), .parts = parts};
    r.raw.file = file;
    r.raw.unit = unit;

    if (!input_file_begins(file, "$MeshFormat")) {
        TRY(input_file_fail(file, 0, "it is no MSH file, which begins with $MeshFormat: it is %s",
                            sniff_words(file, words)));
    }
    TRY(read_sections(&r));
    if (!r.has_elements) {
        TRY(msh_fail(&r.c, "the file ends without %s", r.has_nodes ? "$Elements" : "$Nodes"));
    }
    TRY(check_parts(&r));
    TRY(msh_make_frames(&r));
    *out = r.raw;
    r.raw = (raw_mesh){0};

done:
    reader_free(&r);
    return st;
}
