// reach/embree_door_module.c
// Coordinates are moved and scaled so that the box around all items is within [-1, 1]: there single
// precision is at its best.
#include "reach/embree_door.h"

#include "base/memory.h"

#include <embree3/rtcore.h>

#include <float.h>
#include <math.h>

struct box_tree {
    RTCDevice device;
    RTCScene scene;
    double middle[3], half; // x -> (x - middle) / half
    item_box *box;          // while the tree is made
    const void *context;
};

// What rounding to single precision may cost a distance, of 1 + |p|: half a unit in the last place
// for each of p's three coordinates, and a few for the squares and roots. Embree needs about two
static const double ROUNDING = 8 * (double)FLT_EPSILON;

// the largest float <= x
static float float_below(double x)
{
    const float f = (float)x;
    return (double)f <= x ? f : nextafterf(f, -INFINITY);
}

static void scaled_bounds(const struct RTCBoundsFunctionArguments *args)
{
    const box_tree *t = args->geometryUserPtr;
    double low[3], high[3];
    t->box(t->context, (int)args->primID, low, high);
    for (int d = 0; d < 3; d++) {
        low[d] = (low[d] - t->middle[d]) / t->half;
        high[d] = (high[d] - t->middle[d]) / t->half;
    }
    *args->bounds_o = (struct RTCBounds){.lower_x = float_below(low[0]),
                                         .lower_y = float_below(low[1]),
                                         .lower_z = float_below(low[2]),
                                         .upper_x = -float_below(-high[0]),
                                         .upper_y = -float_below(-high[1]),
                                         .upper_z = -float_below(-high[2])};
}

static void find_scale(box_tree *t, int n)
{
    double lowest[3] = {INFINITY, INFINITY, INFINITY};
    double highest[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < n; i++) {
        double low[3], high[3];
        t->box(t->context, i, low, high);
        for (int d = 0; d < 3; d++) {
            lowest[d] = fmin(lowest[d], low[d]);
            highest[d] = fmax(highest[d], high[d]);
        }
    }
    t->half = 0;
    for (int d = 0; d < 3; d++) {
        t->middle[d] = 0.5 * (lowest[d] + highest[d]);
        t->half = fmax(t->half, 0.5 * (highest[d] - lowest[d]));
    }
    t->half = t->half > 0 ? t->half : 1;
}

static void tree_free(box_tree *t)
{
    if (t && t->scene) {
        rtcReleaseScene(t->scene);
    }
    if (t && t->device) {
        rtcReleaseDevice(t->device);
    }
    free(t);
}

static status device_fails(RTCDevice device)
{
    switch (rtcGetDeviceError(device)) {
    case RTC_ERROR_NONE:
        return OK;
    case RTC_ERROR_OUT_OF_MEMORY:
        return status_fail(ERR_RESOURCE, "Embree: out of memory for the tree of a surface");
    case RTC_ERROR_UNSUPPORTED_CPU:
        return status_fail(ERR_RESOURCE, "Embree: it does not run on this processor");
    default:
        return status_fail(ERR_BUG, "Embree refuses the tree of a surface");
    }
}

static status attach_items(box_tree *t, int n)
{
    RTCGeometry items = rtcNewGeometry(t->device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(items, (unsigned)n);
    rtcSetGeometryUserData(items, t);
    rtcSetGeometryBoundsFunction(items, scaled_bounds, NULL);
    rtcCommitGeometry(items);
    (void)rtcAttachGeometry(t->scene, items);
    rtcReleaseGeometry(items);
    return device_fails(t->device);
}

static status tree_make(int n, item_box *box, const void *context, box_tree **out)
{
    status st = OK;
    box_tree *t = NULL;
    TRY(TAKE(t, 1));
    t->box = box;
    t->context = context;
    find_scale(t, n);
    t->device = rtcNewDevice("threads=1,start_threads=0,set_affinity=0");
    TRY(device_fails(t->device));
    t->scene = rtcNewScene(t->device);
    rtcSetSceneFlags(t->scene, RTC_SCENE_FLAG_ROBUST);
    TRY(device_fails(t->device));
    TRY(attach_items(t, n));
    rtcCommitScene(t->scene);
    TRY(device_fails(t->device));
    *out = t;
    t = NULL;

done:
    tree_free(t);
    return st;
}

typedef struct search {
    item_visit *visit;
    void *context;
    double half, slack; // slack: of p, scaled
    bool ends;
} search;

// a radius in the tree's scale, made larger; from `slack` on it cannot be too small
static float scaled_radius(double radius, double half, double slack)
{
    const double r = radius / half;
    return isfinite(r) ? (float)(r + ROUNDING * r + slack) : INFINITY;
}

static bool look(struct RTCPointQueryFunctionArguments *args)
{
    search *s = args->userPtr;
    if (s->ends) {
        return false;
    }
    const double radius = s->visit(s->context, (int)args->primID);
    s->ends = radius < 0;
    const float scaled = s->ends ? 0 : scaled_radius(radius, s->half, s->slack);
    const bool smaller = scaled < args->query->radius;
    args->query->radius = smaller ? scaled : args->query->radius;
    return smaller;
}

static void tree_near(const box_tree *t, const double p[3], double radius, item_visit *visit,
                      void *context)
{
    double scaled[3], size = 1;
    for (int d = 0; d < 3; d++) {
        scaled[d] = (p[d] - t->middle[d]) / t->half;
        size += fabs(scaled[d]);
    }
    search s = {.visit = visit, .context = context, .half = t->half, .slack = ROUNDING * size};
    struct RTCPointQuery query = {.x = (float)scaled[0],
                                  .y = (float)scaled[1],
                                  .z = (float)scaled[2],
                                  .radius = scaled_radius(radius, t->half, s.slack)};
    struct RTCPointQueryContext where;
    rtcInitPointQueryContext(&where);
    (void)rtcPointQuery(t->scene, &query, &where, look, &s);
}

const embree_door *stiffaxis_embree_door(void);

const embree_door *stiffaxis_embree_door(void)
{
    static const embree_door door = {.make = tree_make, .near = tree_near, .free = tree_free};
    return &door;
}
