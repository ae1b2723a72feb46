// meshes/msh_data.c
// Directions of materials: views of a MSH file with a value per element, and the frames they make.
#include "meshes/msh_reader.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

// The largest entry of axes axes^T - 1 that is a file's rounding, and the largest that is left as
// it is: what files of 12 digits have.
static const double NOT_ORTHONORMAL = 1e-4, ROUNDING = 1e-9;

static const struct {
    const char *name;
    int kind, width;
    double unit;
} views[] = {
    {"plane_angle_rad", VIEW_PLANE, 1, 1},
    {"plane_angle_deg", VIEW_PLANE, 1, PI / 180},
    {"fibre_angle_rad", VIEW_FIBRE, 1, 1},
    {"fibre_angle_deg", VIEW_FIBRE, 1, PI / 180},
    {"axes", VIEW_AXES, 9, 1},
};

static status find_view(const msh_reader *r, const char *name, int *view)
{
    *view = -1;
    if (strcmp(name, "plane_angle") == 0 || strcmp(name, "fibre_angle") == 0) {
        return msh_fail(&r->c, "the view '%s' does not say its unit: name it %s_deg or %s_rad",
                        name, name, name);
    }
    for (int i = 0; i < (int)(sizeof views / sizeof *views); i++) {
        if (strcmp(name, views[i].name) == 0) {
            *view = i;
        }
    }
    if (*view >= 0 && r->view[views[*view].kind]) {
        return msh_fail(&r->c, "the view '%s' comes twice", name);
    }
    return OK;
}

// names, reals and integers of a view; what matters of them
typedef struct view_head {
    char name[MSH_NAME];
    int64_t width;
    int count;
} view_head;

static status read_head(msh_reader *r, view_head *h)
{
    status st = OK;
    int nname = 0, nreal = 0, nint = 0;
    char name[MSH_NAME];
    double real;
    int64_t number;
    TRY(msh_count(&r->c, "the number of names", false, 2, 2, &nname));
    for (int i = 0; i < nname; i++) {
        TRY(msh_quoted(&r->c, i == 0 ? h->name : name));
    }
    TRY(msh_count(&r->c, "the number of reals", false, 2, 2, &nreal));
    for (int i = 0; i < nreal; i++) {
        TRY(msh_real(&r->c, "a real of a view", &real));
    }
    TRY(msh_count(&r->c, "the number of integers", false, 2, 2, &nint));
    for (int i = 0; i < nint && i != 2; i++) {
        TRY(msh_int(&r->c, "an integer of a view", i == 1 ? &h->width : &number));
    }
    if (nint < 3) {
        TRY(msh_fail(&r->c, "a view has three integers or more, not %d", nint));
    }
    TRY(msh_count(&r->c, "the number of values", false, 4, 12, &h->count));
    for (int i = 3; i < nint; i++) {
        TRY(msh_int(&r->c, "an integer of a view", &number));
    }

done:
    return st;
}

static status read_values(msh_reader *r, int view, int count)
{
    status st = OK;
    const int kind = views[view].kind, width = views[view].width;
    const size_t n = (size_t)r->raw.nelem;
    TRY(TAKE(r->view[kind], n * (size_t)width));
    TRY(TAKE(r->viewed[kind], n));
    for (int i = 0; i < count; i++) {
        int64_t id = 0;
        double value[9];
        TRY(msh_int(&r->c, "an element's number", &id));
        for (int k = 0; k < width; k++) {
            TRY(msh_real(&r->c, "an element's value", &value[k]));
            value[k] = value[k] * views[view].unit + 0.0; // no -0
        }
        const int e = id_map_find(&r->elements, id);
        if (e >= 0) {
            memcpy(r->view[kind] + (size_t)e * (size_t)width, value, (size_t)width * sizeof *value);
            r->viewed[kind][e] = true;
        }
    }

done:
    return st;
}

status msh_read_element_data(msh_reader *r)
{
    status st = OK;
    view_head h = {.width = 0};
    int view = -1;
    TRY(read_head(r, &h));
    TRY(find_view(r, h.name, &view));
    if (view < 0) {
        return msh_skip_section(r, "$ElementData");
    }
    if (!r->has_elements) {
        TRY(msh_fail(&r->c, "the view '%.60s' comes before $Elements", h.name));
    }
    if (h.width != views[view].width) {
        TRY(msh_fail(&r->c, "the view '%s' has %lld values per element, not %d", views[view].name,
                     (long long)h.width, views[view].width));
    }
    TRY(msh_begin_numbers(r));
    TRY(read_values(r, view, h.count));

done:
    return st;
}

// --- frames

// rows 1, 2, 3; made orthonormal from 1 and 2 where they are rounded
static status make_axes(const msh_reader *r, int elem, const double *v, mat3 *out)
{
    mat3 a;
    double off = 0;
    memcpy(a.a, v, sizeof a.a);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const double dot =
                a.a[i][0] * a.a[j][0] + a.a[i][1] * a.a[j][1] + a.a[i][2] * a.a[j][2];
            off = fmax(off, fabs(dot - (i == j)));
        }
    }
    const vec3 one = {{v[0], v[1], v[2]}}, two = {{v[3], v[4], v[5]}};
    const vec3 three = vec3_cross(one, two);
    const double right = three.a[0] * v[6] + three.a[1] * v[7] + three.a[2] * v[8];
    if (!(off <= NOT_ORTHONORMAL) || !(right > 0)) {
        return input_file_fail(r->c.file, 0,
                               "the axes of element %lld are not orthonormal and "
                               "right-handed",
                               (long long)r->raw.elem[elem].id);
    }
    if (off > ROUNDING) {
        const vec3 e1 = vec3_scale(1 / vec3_norm(one), one);
        const vec3 e3 = vec3_scale(1 / vec3_norm(three), three), e2 = vec3_cross(e3, e1);
        for (int d = 0; d < 3; d++) {
            a.a[0][d] = e1.a[d];
            a.a[1][d] = e2.a[d];
            a.a[2][d] = e3.a[d];
        }
    }
    *out = a;
    return OK;
}

static status frame_of(const msh_reader *r, int elem, material_frame *out)
{
    if (r->viewed[VIEW_AXES] && r->viewed[VIEW_AXES][elem]) {
        *out = (material_frame){.polar = false};
        return make_axes(r, elem, r->view[VIEW_AXES] + 9 * (size_t)elem, &out->axes);
    }
    *out = material_frame_make(r->view[VIEW_PLANE] ? r->view[VIEW_PLANE][elem] : 0,
                               r->view[VIEW_FIBRE] ? r->view[VIEW_FIBRE][elem] : 0);
    return OK;
}

static bool has_value(const msh_reader *r, int elem)
{
    for (int k = 0; k < VIEW_KINDS; k++) {
        if (r->viewed[k] && r->viewed[k][elem]) {
            return true;
        }
    }
    return false;
}

typedef struct turned {
    mat3 axes;
    int elem;
} turned;

static int axes_order(const mat3 *p, const mat3 *q)
{
    const double *x = &p->a[0][0], *y = &q->a[0][0];
    for (int i = 0; i < 9; i++) {
        if (x[i] != y[i]) {
            return x[i] < y[i] ? -1 : 1;
        }
    }
    return 0;
}

static int turned_order(const void *a, const void *b)
{
    const turned *p = a, *q = b;
    const int order = axes_order(&p->axes, &q->axes);
    return order ? order : (p->elem > q->elem) - (p->elem < q->elem);
}

// equal frames are kept once
static status keep_frames(raw_mesh *m, int n, const turned *t)
{
    status st = OK;
    TRY(TAKE(m->frame, (size_t)n));
    for (int i = 0; i < n; i++) {
        if (i == 0 || axes_order(&t[i].axes, &t[i - 1].axes) != 0) {
            m->frame[m->nframe++].axes = t[i].axes;
        }
        m->elem[t[i].elem].frame = m->nframe - 1;
    }

done:
    return st;
}

status msh_make_frames(msh_reader *r)
{
    status st = OK;
    turned *t = NULL;
    int n = 0;
    if (r->view[VIEW_AXES] && (r->view[VIEW_PLANE] || r->view[VIEW_FIBRE])) {
        TRY(input_file_fail(r->c.file, 0, "it gives directions by 'axes' and by angles: which?"));
    }
    TRY(TAKE(t, (size_t)r->raw.nelem));
    for (int e = 0; e < r->raw.nelem; e++) {
        if (has_value(r, e)) {
            material_frame f;
            TRY(frame_of(r, e, &f));
            t[n++] = (turned){.axes = f.axes, .elem = e};
        }
    }
    qsort(t, (size_t)n, sizeof *t, turned_order);
    TRY(n > 0 ? keep_frames(&r->raw, n, t) : OK);

done:
    free(t);
    return st;
}
