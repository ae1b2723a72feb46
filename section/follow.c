#include "section/follow.h"

#include "base/memory.h"
#include "meshes/morph.h"
#include "meshes/morph_curves.h"
#include "meshes/outline_move.h"
#include "section/reuse.h"

#include <math.h>
#include <string.h>

// two shapes turn together where their turns agree to this [rad]
static const double SAME_SPIN = 1e-9;
// a turn that differs by less from a constant rate's is one [rad]: rounding of the case's
// arithmetic
static const double SAME_TURN = 1e-9;
// a mesh is moved from where its triangles' areas were up to this apart, |ln|
static const double MOST_STRAIN = 0.3;
// places along the rod that are looked at
enum { SAMPLES = 129 };

// A place from which on the mesh is moved; the next one begins where that would strain it much.
typedef struct follow_station {
    double s;
    section_outline outline;
    mesh_morph *morph;
} follow_station;

enum { STEPS = 64 };

struct section_follow {
    const section_case *c;
    const mesh *plane;
    double turn, scale; // at the base
    bool turns_frames;
    int nstation; // 0: the section only turns and scales as a whole
    follow_station station[STEPS + 1];
};

void section_follow_free(section_follow *f)
{
    for (int i = 0; f && i < f->nstation; i++) {
        section_outline_free(&f->station[i].outline);
        mesh_morph_free(f->station[i].morph);
    }
    free(f);
}

// whether a shape has the material; of a drawing any may
static bool is_used(const section_case *c, int material)
{
    const shape_spec *shapes = c->shapes.items;
    for (int i = 0; i < c->shapes.count && !c->drawing; i++) {
        if (shapes[i].material_index == material) {
            return true;
        }
    }
    return c->drawing != NULL;
}

// What its materials allow beside their moduli along the rod, which do not move anything.
static material_traits traits_of_used(const section_case *c, const material *materials)
{
    material_traits t = {0};
    for (int i = 0; i < c->nmaterial; i++) {
        t.across = t.across || (is_used(c, i) && material_is_graded(&materials[i]));
        t.anisotropic = t.anisotropic || (is_used(c, i) && materials[i].kind != MATERIAL_ISOTROPIC);
    }
    return t;
}

static bool only_moves_as_a_whole(const section_case *c)
{
    return c->drawing || !shapes_vary((shape_list){c->shapes.count, c->shapes.items});
}

static status add_station(section_follow *f, double s, const mesh *m)
{
    status st = OK;
    bool drawn = false;
    follow_station *k = &f->station[f->nstation++];
    k->s = s;
    TRY(section_outline_at(f->c, s, &k->outline, &drawn));
    TRY(mesh_morph_make(&k->outline, s, m, &k->morph));

done:
    return st;
}

static status nodes_from(const section_follow *f, const follow_station *k, double s, double *xyz,
                         double *strain)
{
    status st = OK;
    section_outline o = {0};
    bool drawn = false;
    double turn = 0;
    TRY(section_outline_at(f->c, s, &o, &drawn));
    (void)section_outline_spin(&k->outline, &o, SAME_SPIN, &turn);
    TRY(mesh_morph_nodes(k->morph, &o, s, turn, xyz, strain));

done:
    section_outline_free(&o);
    return st;
}

// Steps along the rod, a station before each one that would strain the mesh too much. m: a copy of
// the plane mesh to work with; its nodes are those of the step before.
static status step_along(section_follow *f, double from, double to, mesh *m)
{
    status st = OK;
    double *next = NULL, before = from;
    TRY(TAKE(next, 3 * (size_t)m->nnode));
    TRY(add_station(f, from, m));
    for (int i = 1; i <= STEPS && !mesh_morph_is_mapped(f->station[0].morph); i++) {
        const double s = i == STEPS ? to : from + (to - from) * i / STEPS;
        const follow_station *k = &f->station[f->nstation - 1];
        double strain = 0;
        st = nodes_from(f, k, s, next, &strain);
        if (k->s < before && (st == ERR_INPUT || strain > MOST_STRAIN)) {
            status_clear(); // nearer by it may do
            TRY(add_station(f, before, m));
            st = nodes_from(f, k + 1, s, next, &strain);
        }
        TRY(st);
        memcpy(m->xyz, next, 3 * (size_t)m->nnode * sizeof *next);
        before = s;
    }

done:
    free(next);
    return st;
}

status section_follow_make(const section_case *c, const material *materials, double from, double to,
                           const mesh *plane, section_follow **out)
{
    status st = OK;
    section_follow *f = NULL;
    mesh moving = {0};
    if (section_own_length(c) > 0) {
        TRY(status_fail(ERR_INPUT, "section: the mesh of one slice of a stack is not another's"));
    }
    TRY(TAKE(f, 1));
    f->c = c;
    f->plane = plane;
    f->turn = field_at(&c->turn, from);
    f->scale = field_at(&c->scale, from);
    f->turns_frames =
        plane->nframe > 0 && section_varies(c) && traits_of_used(c, materials).anisotropic;
    if (!only_moves_as_a_whole(c)) {
        TRY(mesh_copy(plane, &moving));
        TRY(step_along(f, from, to, &moving));
    }
    *out = f;
    f = NULL;

done:
    mesh_free(&moving);
    section_follow_free(f);
    return st;
}

// turned and scaled about the origin since the base
static void move_as_a_whole(const section_follow *f, double s, double *xyz)
{
    const double angle = field_at(&f->c->turn, s) - f->turn;
    const double ratio = field_at(&f->c->scale, s) / f->scale;
    const double co = ratio * cos(angle), si = ratio * sin(angle);
    for (int i = 0; i < f->plane->nnode; i++) {
        const double *from = f->plane->xyz + 3 * (size_t)i;
        double *to = xyz + 3 * (size_t)i;
        to[0] = co * from[0] - si * from[1];
        to[1] = si * from[0] + co * from[1];
        to[2] = 0;
    }
}

status section_follow_nodes(const section_follow *f, double s, double *xyz)
{
    status st = OK;
    section_outline o = {0};
    bool drawn = false;
    double strain = 0;
    int k = f->nstation - 1;
    while (k > 0 && f->station[k].s > s) {
        k--;
    }
    if (f->nstation > 0) {
        return nodes_from(f, &f->station[k], s, xyz, &strain);
    }
    TRY(section_outline_at(f->c, s, &o, &drawn)); // it checks turn and scale
    move_as_a_whole(f, s, xyz);

done:
    section_outline_free(&o);
    return st;
}

// --- directions of materials

bool section_follow_turns_frames(const section_follow *f)
{
    return f->turns_frames;
}

// as shape_frames_to_mesh numbers them
static status frame_of_shape(const section_outline *o, int index, material_frame *out)
{
    int n = 0;
    for (int k = 0; k < o->count; k++) {
        if (o->items[k].has_frame && o->items[k].material >= 0 && n++ == index) {
            *out = o->items[k].frame;
            return OK;
        }
    }
    return status_fail(ERR_BUG, "section: no direction %d of %d shapes", index, o->count);
}

status section_follow_frame(const section_follow *f, double s, int index, material_frame *out)
{
    status st = OK;
    section_outline o = {0};
    bool drawn = false;
    if (!f->c->drawing) {
        TRY(section_outline_at(f->c, s, &o, &drawn));
        TRY(frame_of_shape(&o, index, out));
        goto done;
    }
    *out = f->plane->frame[index];
    material_frame_move(out, field_at(&f->c->scale, s) / f->scale,
                        field_at(&f->c->turn, s) - f->turn);

done:
    section_outline_free(&o);
    return st;
}

// --- how it changes

// how far the curves move from one place to the next, over the size; places that have other curves
// tell nothing, they are refused where the mesh comes to them
static status outline_step(const section_outline *a, const section_outline *b, double *step)
{
    status st = OK;
    shape_curves from = {0}, to = {0};
    double turn = 0, most = 0;
    (void)section_outline_spin(a, b, SAME_SPIN, &turn);
    TRY(shape_curves_make(a, 0, &from));
    TRY(shape_curves_make(b, turn, &to));
    for (int c = 0; c < from.ncurve && from.ncurve == to.ncurve; c++) {
        const int n = from.curve[c].n;
        for (int i = 0; i < 2 * n && n == to.curve[c].n; i++) {
            double x[2], y[2];
            shape_curve_point(&from, c, i / 2.0, x);
            shape_curve_point(&to, c, i / 2.0, y);
            most = fmax(most, hypot(x[0] - y[0], x[1] - y[1]));
        }
    }
    *step = most / a->size;

done:
    shape_curves_free(&from);
    shape_curves_free(&to);
    return st;
}

// by the declared turns too: outlines show a turn up to whole ones only
static status place_step(const section_place *a, const section_place *b, double *step)
{
    status st = OK;
    const double turned = fabs(b->turn - a->turn);
    if (a->drawn) {
        TRY(outline_step(&a->outline, &b->outline, step));
        *step = fmax(*step, turned);
    } else {
        *step = turned + fabs(b->scale / a->scale - 1);
    }

done:
    return st;
}

// the samples' turns since the first; whether each section is the first one turned
static status sample(const section_case *c, const material *materials, double from, double to,
                     section_course *course, double turn[SAMPLES])
{
    status st = OK;
    section_store store = {0};
    section_place first = {0}, last = {0}, next = {0};
    TRY(section_store_make(c, materials, to, &store));
    TRY(section_place_at(c, from, to, &first));
    TRY(section_place_at(c, from, to, &last));
    store.traits = traits_of_used(c, materials);
    course->turns_only = true;
    course->one_grid = first.drawn;
    for (int i = 1; i < SAMPLES; i++) {
        section_likeness like = {0};
        double step = 0;
        bool alike = false;
        TRY(section_place_at(c, from + (to - from) * i / (SAMPLES - 1), to, &next));
        TRY(section_store_alike(&store, &first, &next, &like, &alike));
        course->turns_only = course->turns_only && alike && like.scale == 1 && !like.mirror;
        turn[i] = next.turn - first.turn;
        TRY(place_step(&last, &next, &step));
        course->way += step;
        if (course->one_grid) {
            TRY(outlines_share_grid(&last.outline, &next.outline, &course->one_grid));
        }
        section_place_free(&last);
        last = next;
        next = (section_place){0};
    }

done:
    section_store_free(&store);
    section_place_free(&first);
    section_place_free(&last);
    section_place_free(&next);
    return st;
}

status section_course_between(const section_case *c, const material *materials, double from,
                              double to, section_course *out)
{
    status st = OK;
    double turn[SAMPLES] = {0};
    section_course course = {.constant = !section_varies(c), .one_grid = true};
    if (!course.constant) {
        TRY(sample(c, materials, from, to, &course, turn));
        course.turn_rate = turn[SAMPLES - 1] / (to - from);
        for (int i = 0; i < SAMPLES; i++) {
            const double even = turn[SAMPLES - 1] * i / (SAMPLES - 1);
            course.turns_only = course.turns_only && fabs(turn[i] - even) <= SAME_TURN;
        }
        course.turn_rate = course.turns_only ? course.turn_rate : 0;
    }
    *out = course;

done:
    return st;
}
