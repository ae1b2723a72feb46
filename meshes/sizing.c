// meshes/sizing.c
#include "meshes/sizing.h"

#include <math.h>

// By order: edge length over the section's size, and the arc of an element. Chosen so that the
// geometry's error, which falls with angle^(2p), stays below that of the fields.
static const double length_part[ELEMENT_MAX_ORDER + 1] = {0, 0.04, 0.1, 0.18, 0.25};
static const double arc_angle[ELEMENT_MAX_ORDER + 1] = {0, 0.06, 0.15, 0.25, 0.35};

// an element edge turns by no more than this, whatever the size asked for
static const double LARGEST_ANGLE = 0.7854;

// Layers at corners without the caller's wish. The field at weak corners is smoother.
enum { STRONG_LAYERS = 3, WEAK_LAYERS = 1 };

// equal edges give counts that are whole numbers but for rounding
static const double ROUNDING = 1e-6;

double sizing_finer(const mesh_options *options)
{
    return options->finer > 0 ? options->finer : 1;
}

double sizing_growth(const mesh_options *options)
{
    return pow(SIZING_GROWTH, 1 / sizing_finer(options));
}

double sizing_length(const mesh_options *options, double section_size)
{
    const double chosen = length_part[options->order] * section_size;
    return options->size > 0 ? options->size : chosen / sizing_finer(options);
}

double sizing_angle(const mesh_options *options)
{
    return options->size > 0 ? LARGEST_ANGLE : arc_angle[options->order] / sizing_finer(options);
}

double sizing_shrink(const mesh_options *options, corner c)
{
    const int layers = (c == CORNER_WEAK ? WEAK_LAYERS : STRONG_LAYERS) + options->layers;
    return pow(SIZING_GROWTH, 1 - layers);
}

// With edge layers, by order. Areas are then off by 5e-8 at order 4 and 2e-7 at order 3 (8.2), and
// fields that go with the cosine of the angle by less; what is singular has its layers.
static const double edge_length_part[ELEMENT_MAX_ORDER + 1] = {0, 0.1, 0.25, 0.5, 1.0};
static const double edge_arc_angle[ELEMENT_MAX_ORDER + 1] = {0, 0.1, 0.25, 0.5, 1.0};

// the outermost edge layer over the thinnest part
static const double LAST_EDGE_LAYER = 0.1;

double sizing_edge_first(const mesh_options *options, double section_size, double thinnest)
{
    return options->edge_first > 0
               ? options->edge_first * section_size
               : LAST_EDGE_LAYER * thinnest * pow(SIZING_GROWTH, 1 - options->edge_layers);
}

double sizing_edge_length(const mesh_options *options, double section_size)
{
    return options->size > 0
               ? options->size
               : edge_length_part[options->order] * section_size / sizing_finer(options);
}

double sizing_edge_angle(const mesh_options *options)
{
    return edge_arc_angle[options->order] / sizing_finer(options);
}

// Triangles are halved at corners, and with thinner layers become as small as these are next to
// strong ones: torsion and shear are singular there all along the body. Over the first layer:
static const double AT_STRONG_CORNER = 10, AT_WEAK_CORNER = 100;

double sizing_edge_shrink(const mesh_options *options, corner c)
{
    const double first = sizing_edge_first(options, 1, 1);
    return c == CORNER_WEAK ? fmin(2, AT_WEAK_CORNER * first) : fmin(1, AT_STRONG_CORNER * first);
}

double sizing_parts(double length, double target)
{
    return fmax(1, ceil(length / target - ROUNDING));
}
