// meshes/drawing.h
// Sections that come from a file: images, meshes, CAD. Opened once, read whole, checked by content
// before any library sees them; then one mesh, or outlines, per slice.
#pragma once

#include "base/key.h"
#include "base/material.h"
#include "meshes/mesher.h"
#include "meshes/pixel_image.h"
#include "meshes/shape.h"

typedef enum drawing_unit { UNIT_MM, UNIT_M, UNIT_CM, UNIT_UM, UNIT_IN } drawing_unit;
double drawing_unit_size(int unit); // [m]

// Which part of the file is of which material: by its name (a physical group, a layer, a body) or
// its colour. A part whose name is a material's needs no entry.
typedef struct part_spec {
    mark at;
    key_text name;     // exactly one of name and colour
    key_text colour;   // "#rrggbb"
    key_text material; // a name, or "none"
} part_spec;

typedef struct png_spec {
    mark at;
    key_text file;   // one image, or a stack: a printf pattern with one %d, as in slice_%03d.png
    key_list parts;  // of part_spec, by colour; transparent is no material
    double pitch[2]; // of a pixel along x and y [m]
    double layer;    // thickness of a slice, for a stack [m]
    int first, last; // numbers of a stack's slices; 0: from 0 or 1 on, all there are
    int boundaries;  // 0 pixels, 1 smoothed
} png_spec;

typedef struct msh_spec {
    mark at;
    key_text file;
    key_list parts; // by physical name
    int unit;       // drawing_unit
} msh_spec;

typedef struct step_spec {
    mark at;
    key_text file;
    key_list parts;   // by the body's name or colour
    double origin[3]; // a point of the cutting plane, the section's origin [m]
    double normal[3]; // of the plane, the section's z
    double x_axis[3]; // the section's x, before it is made perpendicular to the normal
} step_spec;

typedef struct dxf_spec {
    mark at;
    key_text file;
    key_list parts; // by layer
    int unit;       // 0: the file's own; else one more than drawing_unit
} dxf_spec;

typedef struct geo_spec {
    mark at;
    key_text file;
    key_list parts; // by physical name
    int unit;
} geo_spec;

// At most one of them is given.
typedef struct drawing_files {
    png_spec png;
    msh_spec msh;
    step_spec step;
    dxf_spec dxf;
    geo_spec geo;
} drawing_files;

extern const key_table png_keys, msh_keys, step_keys, dxf_keys, geo_keys;

typedef struct drawing drawing;

typedef struct drawing_request {
    const char *directory; // that relative file names start from; NULL: the current one
    int nmaterial;         // materials by name
    const material *materials;
    bool allow_scripts; // `geo:` may run
} drawing_request;

// *out stays NULL where the case names no file. ERR_INPUT for the case's mistakes (with the place
// of the key), ERR_FILE for a damaged, unsupported or unreadable file (one line: name, line or
// offset, what is wrong).
status drawing_open(const drawing_files *files, const drawing_request *request, drawing **out);
void drawing_free(drawing *d); // NULL is fine

// A stack's length [m] and number of slices; 0 and 1 for one section.
double drawing_length(const drawing *d);
int drawing_slice_count(const drawing *d);
// The slice at s, named by the first one that is equal to it.
int drawing_slice_at(const drawing *d, double s);

// Outlines instead of a mesh: dxf. *found false for the others.
status drawing_outline(const drawing *d, section_outline *out, bool *found);

// How far its first slice reaches from the origin [m]; meshed once for it where need be.
status drawing_reach(drawing *d, double *reach);

// The order of elements that serves such a file best where the case says nothing; 0: as elsewhere.
int drawing_best_order(const drawing *d);

// A mesh of one slice. The options' order and size hold where the file is not itself a mesh.
status drawing_mesh(const drawing *d, int slice, const mesh_options *options, mesh *out);

// The slice as the next coarser resolution of the file would have it (pixels twice as wide): what
// the pixels are worth. *found false where the file has no resolution, or where such pixels would
// not hang together.
status drawing_mesh_coarser(const drawing *d, int slice, const mesh_options *options, mesh *out,
                            bool *found);

// The pixels of one slice, the caller's to free. *found false where the file is no image.
status drawing_pixels(const drawing *d, int slice, pixel_image *out, bool *found);

// --- what a kind of file provides

typedef struct drawing_kind {
    status (*open)(const drawing_files *files, const drawing_request *request, void **state);
    void (*close)(void *state);
    int (*slice_count)(const void *state);                      // NULL: 1
    int (*same_as)(const void *state, int slice);               // first equal slice; NULL: itself
    double (*layer)(const void *state);                         // [m]; NULL: no stack
    status (*outline)(const void *state, section_outline *out); // NULL: none
    status (*mesh)(const void *state, int slice, const mesh_options *options, mesh *out);
    status (*coarser)(const void *state, int slice, const mesh_options *options, mesh *out,
                      bool *found);                                   // NULL: none
    status (*pixels)(const void *state, int slice, pixel_image *out); // NULL: none
    int best_order; // of elements; 0: as elsewhere
} drawing_kind;
