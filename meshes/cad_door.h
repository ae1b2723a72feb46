// meshes/cad_door.h
// What the gmsh module takes and gives for files that gmsh itself reads: bodies of a STEP file cut
// at a plane, or what a gmsh script draws; plane elements out, as gmsh has them. Plain types only.
#pragma once

#include "base/status.h"

enum { CAD_NAME = 128 };

typedef struct cad_request {
    const char *path;
    bool script;        // a gmsh script runs; else a STEP file
    bool look;          // bodies only, no elements
    double place[3];    // STEP: of the plane's origin [mm]
    double turn[3][3];  // rows are the section's x, y and z in the file
    int order;          // of the elements
    double length;      // of edges, in the file's unit (mm); 0: `part` of the section's size, or
                        // what a script says
    double part, angle; // largest angle of an arc that an edge follows [rad]
    int most_elements;  // more are refused
} cad_request;

// A body that the plane cuts, or a physical group.
typedef struct cad_body {
    char name[CAD_NAME]; // "" where it has none
    int number;          // from 1, in the file's order; of a group its own
    bool coloured;
    unsigned char rgb[3];
} cad_body;

typedef struct cad_pieces {
    int nbody;
    cad_body *body;
    int order;
    int nnode;
    double *xyz;   // [nnode][3] in the section's axes, the file's unit
    int nexact;    // 3 nnode, or 0
    double *exact; // [nnode][3] where nodes of edges on curves are, were they Gauss-Lobatto points;
                   // NaN for others
    int nelem, nconn;
    int *sides;   // [nelem] 3 or 4
    int *body_of; // [nelem]
    int *conn;    // [nconn] nodes, gmsh's order
} cad_pieces;

// Symbol "gmsh_door_cad" of the module; to be called once in a process. ERR_FILE with gmsh's words
// where it gave up, or where the plane meets no body, runs along a face, or bodies overlap. The
// caller frees what is in *out, also after a failure.
typedef status (*gmsh_door_cad_function)(const cad_request *request, cad_pieces *out);
status gmsh_door_cad(const cad_request *request, cad_pieces *out);
