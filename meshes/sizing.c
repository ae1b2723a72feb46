// meshes/sizing.c
#include "meshes/sizing.h"

#include <math.h>

// By order: edge length over the section's size, and the arc of an element. Chosen so that the
// geometry's error, which falls with angle^(2p), stays below that of the fields.
static const double length_part[ELEMENT_MAX_ORDER + 1] = {0, 0.04, 0.1, 0.18, 0.25};
static const double arc_angle[ELEMENT_MAX_ORDER + 1] = {0, 0.06, 0.15, 0.25, 0.35};

// an element edge turns by no more than this, whatever the size asked for
static const double LARGEST_ANGLE = 0.7854;

// The field at a weak corner is smoother: a layer there does what three do at a strong one.
enum { DEFAULT_LAYERS = 3, LAYERS_PER_WEAK = 3 };

// equal edges give counts that are whole numbers but for rounding
static const double ROUNDING = 1e-6;

double sizing_finer(const mesh_options *options)
{
    return options->finer > 0 ? options->finer : 1;
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
    const int strong = options->layers > 0 ? options->layers : DEFAULT_LAYERS;
    const int weak = 1 + (strong - DEFAULT_LAYERS) / LAYERS_PER_WEAK;
    return pow(SIZING_GROWTH, 1 - (c == CORNER_WEAK ? weak : strong));
}

double sizing_parts(double length, double target)
{
    return fmax(1, ceil(length / target - ROUNDING));
}
