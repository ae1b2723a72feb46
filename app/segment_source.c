#include "app/segment_source.h"

#include "app/rest_line.h"
#include "base/memory.h"
#include "section/follow.h"
#include "section/voxels.h"

#include <math.h>
#include <string.h>

// Layers are no longer than what turns, bends or moves the section by this [rad, radii]: a layer of
// order 3 follows a helix over such an arc to 1e-5 of its radius.
static const double WAY_PER_LAYER = 3.14159265358979323846 / 8;
// layers of a slice are no longer than this over the section's radius, where the case does not say
static const double LONGEST_VOXEL = 0.5;
// what rounding may add to a way
static const double ROUNDING = 1e-9;
// more layers than this come from a mistake of unit
enum { MOST_SECTIONS_ALONG = 20000 };

// a modulus along the rod as the segment asks for it
typedef struct shifted_field {
    place_field field;
    double by; // [m]
} shifted_field;

typedef struct source_data {
    const case_data *c;
    double from, to;       // arclengths of base and tip [m]
    section_course course; // of the section
    rest_line line;        // the rod at rest; npanel 0: straight
    double twist;          // else of the rod at rest [rad/m]
    material *shifted;     // [nmaterial] materials that count s from the segment's base
    shifted_field *shift;  // [nmaterial] their moduli; NULL where none varies along the rod
    bool stack;
    int nlayer;
    double *layer; // [nlayer + 1] of a stack [m]
} source_data;

// one body's; spec.shape.self
typedef struct body_course {
    const source_data *source;
    const mesh *plane;
    section_follow *follow; // NULL: of a stack
} body_course;

static status source_plane(void *self, const segment_mesh *ask, mesh *out)
{
    status st = OK;
    const source_data *d = self;
    const section_case *section = &d->c->file.section;
    mesh_options options = section->mesh;
    options.order = ask->order > 0 ? ask->order : options.order;
    options.size = ask->size > 0 ? ask->size : options.size;
    options.edge_layers = ask->edge_layers;
    options.edge_first = ask->edge_first;
    if (options.kind == MESH_AUTO && !d->course.one_grid) {
        options.kind = MESH_FREE; // no grid of the base's cells holds the section farther on
    }
    st = d->stack ? section_voxel_plane(section, d->from, d->to, &options, out)
                  : section_mesh_with(section, d->from, &options, out);
    TRY(case_place(d->c, st, section->at));

done:
    return st;
}

// --- bodies

// nodes in the body frame at s
static status place_in_section(const body_course *b, double s, double *xyz)
{
    status st = OK;
    const case_data *c = b->source->c;
    if (b->follow) {
        st = section_follow_nodes(b->follow, b->source->from + s, xyz);
        return case_place(c, st, c->file.section.at);
    }
    memcpy(xyz, b->plane->xyz, 3 * (size_t)b->plane->nnode * sizeof *xyz);
    return st;
}

// nodes of the body frame, and the frame, into the base's axes
static status place(const void *self, double s, double *xyz, mat3 *axes, double origin[3])
{
    status st = OK;
    const body_course *b = self;
    const source_data *d = b->source;
    pose g = {.R = mat3_rot_z(d->twist * s), .p = {{0, 0, s}}};
    if (d->line.npanel > 0) {
        g = rest_line_at(&d->line, d->from + s);
    }
    TRY(place_in_section(b, s, xyz));
    for (int i = 0; i < b->plane->nnode; i++) {
        double *x = xyz + 3 * (size_t)i;
        const vec3 there = vec3_add(mat3_mul_vec(g.R, (vec3){{x[0], x[1], x[2]}}), g.p);
        memcpy(x, there.a, sizeof there.a);
    }
    *axes = g.R;
    memcpy(origin, g.p.a, sizeof g.p.a);

done:
    return st;
}

static status frame(const void *self, double s, int index, material_frame *out)
{
    const body_course *b = self;
    const case_data *c = b->source->c;
    return case_place(c, section_follow_frame(b->follow, b->source->from + s, index, out),
                      c->file.section.at);
}

static bool is_even_turn(const source_data *d)
{
    return (d->course.constant || d->course.turns_only) && d->line.npanel == 0;
}

static status follow(const source_data *d, const mesh *plane, body_spec *spec)
{
    status st = OK;
    const section_case *section = &d->c->file.section;
    body_course *b = NULL;
    TRY(TAKE(b, 1));
    *b = (body_course){.source = d, .plane = plane};
    spec->shape = (body_shape){.self = b, .place = place};
    if (!d->stack) {
        st = section_follow_make(section, d->c->materials, d->from, d->to, plane, &b->follow);
        TRY(case_place(d->c, st, section->at));
        spec->shape.frame = section_follow_turns_frames(b->follow) ? frame : NULL;
    }

done:
    return st;
}

static status source_course(void *self, const mesh *plane, body_spec *spec)
{
    status st = OK;
    const source_data *d = self;
    const section_case *section = &d->c->file.section;
    int *matter = NULL;
    if (d->stack) {
        st = section_voxel_matter(section, d->from, d->nlayer, d->layer, plane, &matter);
        TRY(case_place(d->c, st, section->at));
        spec->matter = matter;
    }
    if (is_even_turn(d)) {
        spec->turn_rate = d->course.turn_rate + d->twist;
    } else {
        TRY(follow(d, plane, spec));
    }

done:
    return st;
}

static void source_release(void *self, body_spec *spec)
{
    (void)self;
    body_course *b = (body_course *)(size_t)spec->shape.self;
    if (b) {
        section_follow_free(b->follow);
        free(b);
    }
    free((int *)(size_t)spec->matter);
    spec->matter = NULL;
    spec->shape = (body_shape){0};
}

// --- the whole

// of a file's materials it is not known which ones it uses
static double largest_nu(const case_data *c)
{
    double nu = 0;
    const shape_spec *shapes = c->file.section.shapes.items;
    for (int i = 0; i < c->nmaterial; i++) {
        bool used = c->file.section.drawing != NULL;
        for (int k = 0; k < c->file.section.shapes.count && !used; k++) {
            used = shapes[k].material_index == i;
        }
        nu = used ? fmax(nu, c->materials[i].nu) : nu;
    }
    return nu;
}

static status follow_rest(source_data *d)
{
    status st = OK;
    const rod_case *rod = &d->c->file.rod;
    if (!rest_line_only_twists(&rod->rest, &d->twist)) {
        d->twist = 0;
        st = rest_line_make(&rod->rest, d->from, d->to, rod->breaks.nrow * rod->breaks.ncol,
                            rod->breaks.a, &d->line);
        TRY(case_place(d->c, st, rod->rest.at));
    }

done:
    return st;
}

// how far the section moves along the segment [rad, radii]
static double whole_way(const source_data *d)
{
    const double bend = d->line.npanel > 0 ? rest_line_way(&d->line) : 0;
    return d->course.way + bend + fabs(d->twist) * (d->to - d->from);
}

static status follow_slices(source_data *d, double radius, segment_source *out)
{
    status st = OK;
    const section_case *section = &d->c->file.section;
    const int asked = d->c->file.fem.layers;
    const double longest = asked > 0 ? (d->to - d->from) / asked : LONGEST_VOXEL * radius;
    st = section_voxel_layers(section, d->from, d->to, longest, &d->nlayer, &d->layer);
    TRY(case_place(d->c, st, section->at));
    out->fixed_layers = true;
    out->nlayer = d->nlayer;
    out->layer = d->layer;

done:
    return st;
}

static status follow_section(source_data *d, segment_source *out)
{
    const section_case *section = &d->c->file.section;
    d->stack = section_is_stack(section);
    if (d->stack) {
        return follow_slices(d, out->radius, out);
    }
    const status st = section_course_between(section, d->c->materials, d->from, d->to, &d->course);
    return case_place(d->c, st, section->at);
}

static status follow_course(source_data *d, segment_source *out)
{
    status st = OK;
    const section_case *section = &d->c->file.section;
    TRY(follow_section(d, out));
    TRY(follow_rest(d));
    const double layers = ceil(whole_way(d) / WAY_PER_LAYER * (1 - ROUNDING));
    if (!(layers <= MOST_SECTIONS_ALONG)) {
        TRY(case_place(d->c,
                       status_fail(ERR_INPUT,
                                   "segment: the section turns and moves %g times its radius "
                                   "along it: a mistake of unit?",
                                   whole_way(d)),
                       section->at));
    }
    out->sections_along = (int)layers;
    out->course = source_course;
    out->release = source_release;

done:
    return st;
}

static double shifted_at(const void *self, double x, double y, double s)
{
    const shifted_field *f = self;
    return f->field.at(f->field.expression, x, y, s + f->by);
}

// The segment counts s from its base; a prism is all of what is there
static status shift_materials(source_data *d, segment_source *out)
{
    status st = OK;
    const case_data *c = d->c;
    bool any = false;
    for (int i = 0; i < c->nmaterial; i++) {
        any = any || material_varies(&c->materials[i]);
    }
    const bool prism = c->file.fem.course == COURSE_PRISM;
    if (!any || (d->from == 0 && !prism)) {
        return OK;
    }
    TRY(TAKE(d->shifted, (size_t)c->nmaterial));
    TRY(TAKE(d->shift, (size_t)c->nmaterial));
    for (int i = 0; i < c->nmaterial; i++) {
        d->shifted[i] = c->materials[i];
        d->shift[i] = (shifted_field){c->materials[i].modulus, d->from};
        if (prism) {
            d->shifted[i] = material_at(&c->materials[i], d->from);
        } else if (material_varies(&c->materials[i])) {
            d->shifted[i].modulus.at = shifted_at;
            d->shifted[i].modulus.expression = &d->shift[i];
        }
    }
    out->materials = d->shifted;

done:
    return st;
}

status segment_source_make(const case_data *c, segment_source *out)
{
    status st = OK;
    source_data *d = NULL;
    const segment_case *sc = &c->file.fem;
    segment_source source = {.plane = source_plane,
                             .materials = c->materials,
                             .nmaterial = c->nmaterial,
                             .nu = largest_nu(c)};
    TRY(TAKE(d, 1));
    source.self = d;
    *d = (source_data){.c = c, .from = sc->section_at, .to = sc->section_at + sc->length};
    d->course = (section_course){.constant = true, .one_grid = true};
    st = section_reach_at(&c->file.section, d->from, &source.radius);
    TRY(case_place(c, st, c->file.section.at));
    TRY(shift_materials(d, &source));
    if (sc->course == COURSE_ALONG) {
        TRY(follow_course(d, &source));
    }
    *out = source;
    source = (segment_source){0};

done:
    segment_source_free(&source);
    return st;
}

void segment_source_free(segment_source *source)
{
    source_data *d = source->self;
    if (d) {
        rest_line_free(&d->line);
        free(d->shifted);
        free(d->shift);
        free(d->layer);
        free(d);
    }
    *source = (segment_source){0};
}

bool segment_source_keeps_prism(const case_data *c)
{
    const section_case *section = &c->file.section;
    return c->file.fem.course == COURSE_PRISM &&
           (section_varies(section) || section_is_stack(section) ||
            !rest_line_is_straight(&c->file.rod.rest));
}
