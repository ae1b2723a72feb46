#include "app/segment_source.h"

#include "app/rest_line.h"
#include "base/memory.h"
#include "section/follow.h"

#include <math.h>
#include <string.h>

// Layers are no longer than what turns, bends or moves the section by this [rad, radii]: a layer of
// order 3 follows a helix over such an arc to 1e-5 of its radius.
static const double WAY_PER_LAYER = 3.14159265358979323846 / 8;
// what rounding may add to a way
static const double ROUNDING = 1e-9;
// more layers than this come from a mistake of unit
enum { MOST_SECTIONS_ALONG = 20000 };

typedef struct source_data {
    const case_data *c;
    double from, to;       // arclengths of base and tip [m]
    section_course course; // of the section
    rest_line line;        // the rod at rest; npanel 0: straight
    double twist;          // else of the rod at rest [rad/m]
} source_data;

// one body's; spec.shape.self
typedef struct body_course {
    const source_data *source;
    int nnode;
    section_follow *follow;
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
    st = section_mesh_with(section, d->from, &options, out);
    TRY(case_place(d->c, st, section->at));

done:
    return st;
}

// --- bodies

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
    TRY(case_place(d->c, section_follow_nodes(b->follow, d->from + s, xyz), d->c->file.section.at));
    for (int i = 0; i < b->nnode; i++) {
        double *x = xyz + 3 * (size_t)i;
        const vec3 there = vec3_add(mat3_mul_vec(g.R, (vec3){{x[0], x[1], x[2]}}), g.p);
        memcpy(x, there.a, sizeof there.a);
    }
    *axes = g.R;
    memcpy(origin, g.p.a, sizeof g.p.a);

done:
    return st;
}

static bool is_even_turn(const source_data *d)
{
    return (d->course.constant || d->course.turns_only) && d->line.npanel == 0;
}

static status source_course(void *self, const mesh *plane, body_spec *spec)
{
    status st = OK;
    const source_data *d = self;
    const case_data *c = d->c;
    body_course *b = NULL;
    if (is_even_turn(d)) {
        spec->turn_rate = d->course.turn_rate + d->twist;
        return OK;
    }
    TRY(TAKE(b, 1));
    *b = (body_course){.source = d, .nnode = plane->nnode};
    st = section_follow_make(&c->file.section, c->materials, d->from, plane, &b->follow);
    TRY(case_place(c, st, c->file.section.at));
    spec->shape = (body_shape){.self = b, .place = place};
    b = NULL;

done:
    free(b);
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

static status follow_course(source_data *d, segment_source *out)
{
    status st = OK;
    const section_case *section = &d->c->file.section;
    st = section_course_between(section, d->c->materials, d->from, d->to, &d->course);
    TRY(case_place(d->c, st, section->at));
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
    st = section_reach_at(&c->file.section, d->from, &source.radius);
    TRY(case_place(c, st, c->file.section.at));
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
        free(d);
    }
    *source = (segment_source){0};
}

status segment_source_keeps_prism(const case_data *c, bool *keeps)
{
    const bool along = c->file.fem.course == COURSE_ALONG;
    *keeps =
        !along && (section_varies(&c->file.section) || section_own_length(&c->file.section) > 0 ||
                   !rest_line_is_straight(&c->file.rod.rest));
    return OK;
}
