// meshes/msh_reader.h
// What the parts of the MSH reader share: one function per section of a file.
#pragma once

#include "meshes/id_map.h"
#include "meshes/msh.h"
#include "meshes/msh_cursor.h"

typedef struct msh_group {
    char name[MSH_NAME];
    bool asked; // `material` is known
    int material;
} msh_group; // a physical group of dimension 2 with a name

typedef struct msh_surface { // 4.1: an entity of dimension 2
    int first, count;        // its groups' numbers, into group_of
    bool asked;
    int material;
} msh_surface;

enum { VIEW_PLANE, VIEW_FIBRE, VIEW_AXES, VIEW_KINDS };

typedef struct msh_reader {
    msh_cursor c;
    bool newer;   // 4.1, not 2.2
    bool bytes;   // the file is binary
    bool swapped; // and its bytes have the other order
    part_table *parts;
    int ngroup;
    msh_group *group;
    id_map groups; // by their numbers
    bool has_entities;
    msh_surface *surface;
    id_map surfaces; // by their tags
    int ngroup_of, group_room;
    int64_t *group_of;
    bool has_nodes, has_elements;
    id_map nodes, elements;   // elements: those kept
    double *view[VIEW_KINDS]; // [nelem][1, 1 or 9]; NULL: not in the file
    bool *viewed[VIEW_KINDS]; // [nelem] which have a value
    int node_room, elem_room, conn_room;
    raw_mesh raw;
} msh_reader;

// Each reads what stands between $Name and $EndName.
status msh_read_names(msh_reader *r);
status msh_read_entities(msh_reader *r);
status msh_read_nodes(msh_reader *r);
status msh_read_elements(msh_reader *r);
status msh_read_element_data(msh_reader *r);

// To the line $End<name>.
status msh_skip_section(msh_reader *r, const char *name);

// Binary numbers begin after this line, where the file is binary.
status msh_begin_numbers(msh_reader *r);

// The material of elements in a physical group (2.2) or on a surface (4.1).
status msh_group_material(msh_reader *r, int64_t group, int *material);
status msh_surface_material(msh_reader *r, int64_t tag, int *material);

// A node that the file does not have.
status msh_add_node(msh_reader *r, const double *xyz, int *index);

// Frames of the mesh from the views.
status msh_make_frames(msh_reader *r);

// Room for `need` items where there was some for *room.
status msh_reserve(void **items, int *room, int64_t need, size_t each);
