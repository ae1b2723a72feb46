// app/compare_calculix.c
// The 3D segment by us against CalculiX: the work of each load.
#include "app/calculix_door.h"
#include "app/compare_rows.h"
#include "app/segment_source.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

// CalculiX's two meshes: edges in the plane and end layers over the section's radius. Layers grow
// by two from the ends up to LAYER_MOST.
static const double coarse[2] = {0.4, 0.1}, fine[2] = {0.25, 0.05};
static const double LAYER_MOST = 1.5;
enum { MOST_LAYERS = 1000, MOST_LOADS_ASKED = 8 };

// its direct solver takes 10 s for this many nodes
static const double MOST_NODES = 30000;

// above this its fully integrated elements are too stiff
static const double REDUCED_ABOVE = 0.4;

static const double least = 1e-4; // what its printed digits and its hexahedra's missing nodes leave
static const double most = 2e-2;  // its own meshes are not forgiven to differ by more
static const char reason[] = "three times CalculiX's difference of two meshes, our estimate, 1e-4";

typedef struct witness {
    const case_data *c;
    segment_source source;
    int nload; // that are asked for
    int load[MOST_LOADS_ASKED];
    vec6 wrench[MOST_LOADS_ASKED]; // at the section's origin
    double work[2][MOST_LOADS_ASKED];
    double cpu; // [s]
} witness;

// layers that grow from `first` at both ends
static int make_layers(double length, double first, double highest, double *z)
{
    double height[MOST_LAYERS], total = 0, h = first;
    int half = 0;
    while (total < length / 2 && half < MOST_LAYERS / 2) {
        height[half++] = h;
        total += h;
        h = fmin(2 * h, highest);
    }
    z[0] = 0;
    for (int i = 0; i < 2 * half; i++) {
        z[i + 1] = z[i] + height[i < half ? i : 2 * half - 1 - i];
    }
    for (int i = 1; i <= 2 * half; i++) {
        z[i] *= length / (2 * total);
    }
    return 2 * half;
}

static status solve_body(witness *w, const body *b, double *work)
{
    status st = OK;
    vec6 motion[MOST_LOADS_ASKED];
    double cpu = 0;
    const calculix_ask ask = {
        .body = b,
        .cap = w->c->file.fem.tip == TIP_RIGID,
        .reduced = w->source.nu > REDUCED_ABOVE,
        .nload = w->nload,
        .wrench = w->wrench,
    };
    TRY(calculix_tip(&ask, motion, &cpu));
    w->cpu += cpu;
    for (int i = 0; i < w->nload; i++) {
        work[i] = 0;
        for (int k = 0; k < 6; k++) {
            work[i] += motion[i].a[k] * w->wrench[i].a[k] / 2;
        }
    }

done:
    return st;
}

static status solve_mesh(witness *w, const double parts[2], double *work)
{
    status st = OK;
    const segment_source *source = &w->source;
    const double length = w->c->file.fem.length;
    double *z = NULL, highest = LAYER_MOST * source->radius;
    mesh plane = {0};
    body b = {0};
    body_spec spec = {.materials = source->materials, .order = 2, .plane = &plane};
    const segment_mesh ask = {.order = 2, .size = parts[0] * source->radius};
    if (source->sections_along > 0) {
        highest = fmin(highest, length / source->sections_along);
    }
    TRY(TAKE(z, MOST_LAYERS + 1));
    spec.layer = z;
    spec.nlayer = make_layers(length, fmin(parts[1] * source->radius, highest), highest, z);
    TRY(source->plane(source->self, &ask, &plane));
    if ((double)plane.nnode * (2 * spec.nlayer + 1) > MOST_NODES) {
        TRY(status_fail(ERR_RESOURCE, "its mesh would have more than %g nodes", MOST_NODES));
    }
    TRY(source->course ? source->course(source->self, &plane, &spec) : OK);
    TRY(body_make(&spec, &b));
    TRY(solve_body(w, &b, work));

done:
    body_free(&b);
    if (source->release && spec.shape.self) {
        source->release(source->self, &spec);
    }
    mesh_free(&plane);
    free(z);
    return st;
}

static const char *why_not(const case_data *c)
{
    char path[4096];
    const segment_case *fem = &c->file.fem;
    if (!calculix_find(path, sizeof path)) {
        return "ccx is not installed";
    }
    if (segment_rank() > 0) {
        return "the first rank asks it";
    }
    if (fem->base != BASE_CLAMPED || fem->tip > TIP_E_PROPORTIONAL || fem->springs.count > 0 ||
        fem->holds.count > 0 || mark_given(fem->tip_spring.at)) {
        return "its deck has a clamped base, and a rigid or E_proportional tip";
    }
    return NULL;
}

// the loads that are wrenches on the tip
static void choose_loads(witness *w, const run_result *r)
{
    const segment_load *loads = w->c->file.fem.loads.items;
    for (int i = 0; i < r->segment.nload && w->nload < MOST_LOADS_ASKED; i++) {
        if (compare_acts_on_tip_only(&loads[i])) {
            w->load[w->nload] = i;
            w->wrench[w->nload++] = compare_load_wrench(&loads[i], r->segment.load[i].point);
        }
    }
}

static void judge(const witness *w, int i, run_result *r)
{
    const segment_load_result *load = &r->segment.load[w->load[i]];
    const double spread = fabs(w->work[0][i] / w->work[1][i] - 1);
    compare_relative(
        compare_add(r, "mJ", "load '%.32s': its work, ours against CalculiX", load->name),
        1e3 * load->strain_energy, 1e3 * w->work[1][i],
        (tolerance){least + COMPARE_MARGIN * fmin(spread, most) +
                        fmin(r->segment.relative_error, most),
                    reason});
}

status compare_calculix(const case_data *c, run_result *r)
{
    status st = OK;
    witness w = {.c = c};
    const char *why = why_not(c);
    choose_loads(&w, r);
    if (!why && w.nload > 0) {
        st = segment_source_make(c, &w.source);
        if (st == OK) {
            st = w.source.fixed_layers
                     ? status_fail(ERR_INPUT, "a stack's voxels are more than it is given")
                     : solve_mesh(&w, coarse, w.work[0]);
        }
        st = st == OK ? solve_mesh(&w, fine, w.work[1]) : st;
    }
    if (why || st != OK || w.nload == 0) {
        compare_skip(compare_add(r, "-", "segment: loads' work, ours against CalculiX"), "%s",
                     why        ? why
                     : st != OK ? status_message()
                                : "no load acts on the tip alone");
        if (st != ERR_INTERRUPTED) {
            status_clear();
            st = OK;
        }
        goto done;
    }
    for (int i = 0; i < w.nload; i++) {
        judge(&w, i, r);
    }

done:
    segment_source_free(&w.source);
    return st;
}
