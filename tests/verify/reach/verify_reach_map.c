// tests/verify/reach/verify_reach_map.c
// The map of what is reached, against the inverse where nothing is in the way, against a search for
// every point in a surface, and against random poses.
#include "tests/surfaces.h"
#include "tests/unit/reach/scopes.h"

#include "base/memory.h"
#include "reach/reach_map.h"
#include "reach/scope_room.h"

#include <string.h>

enum { POINTS = 400 };

static const double near_enough = 2e-3;

typedef struct study {
    made_scope m;
    pose entry;
    scope_state *state;
    inverse *inverse;
    surface wall;
    distance_tree *tree;
    scope_room in;
    room_probe room;
    reach_map_options options;
    int npoint, count[3];
    double point[POINTS][3], q[POINTS][SCOPE_JOINTS];
    int found[POINTS];
    reach_map_answer answer;
} study;

// a free body everywhere
static double all_free(void *context, scope_state *state, const double *q, double *s)
{
    (void)context, (void)state, (void)q;
    *s = 0;
    return 1;
}

static vec3 ball_wall(vec3 u)
{
    return vec3_add(vec3_scale(22e-3, u), (vec3){{2e-3, 1e-3, 38e-3}});
}

static void start(study *s)
{
    made_surface made = {0};
    surface_report report;
    s->entry = pose_identity();
    made_ball(&made, 10, ball_wall);
    CHECK_OK(made_closed(&made, &s->wall, &report));
    made_free(&made);
    CHECK_OK(distance_tree_make(&s->wall, &s->tree));
    CHECK_OK(scope_state_make(&s->m.scope, &s->entry, &s->state));
    CHECK_OK(inverse_make(&s->m.scope, &s->inverse));
    s->in = (scope_room){.tree = s->tree, .tolerance = 5e-5, .free_entry = 19e-3};
    s->room = scope_room_probe(&s->in);
    s->options = reach_map_options_default();
    s->options.near = near_enough;
    s->npoint = POINTS;
    s->answer = (reach_map_answer){.state = s->found, .q = s->q};
}

static void stop(study *s)
{
    distance_tree_free(s->tree);
    surface_free(&s->wall);
    inverse_free(s->inverse);
    scope_state_free(s->state);
    free_scope(&s->m);
}

static vec3 point_at(const study *s, int k)
{
    return (vec3){{s->point[k][0], s->point[k][1], s->point[k][2]}};
}

static void map(const char *name, study *s, const room_probe *room)
{
    about("%s", name);
    memset(s->count, 0, sizeof s->count);
    CHECK_OK(reach_map(s->inverse, s->state, room, s->npoint, (const double(*)[3])s->point,
                       &s->options, &s->answer));
    for (int k = 0; k < s->npoint; k++) {
        s->count[s->found[k]]++;
        if (s->found[k] == 1) {
            double at;
            CHECK(scope_within(&s->m.scope, s->q[k]));
            CHECK_OK(scope_bend(s->state, s->q[k]));
            CHECK_AT_MOST(
                distance(scope_point(s->state, s->q[k], s->m.scope.length), point_at(s, k)),
                near_enough);
            CHECK_AT_LEAST(room->at(room->context, s->state, s->q[k], &at), 0);
        }
    }
    printf("%-28s %d reached, %d not, %d undecided, %d looks\n", name, s->count[1], s->count[0],
           s->count[2], s->answer.looks);
}

// nothing in the way: what the inverse says of every point, of which constant curvature's is a
// closed form
static void free_space_is_the_inverse(study *s)
{
    const room_probe free_room = {.at = all_free};
    const scope *sc = &s->m.scope;
    unsigned long long seed = 3;
    for (int k = 0; k < s->npoint; k++) {
        const double rho = random_between(&seed, 0, 1.2) * sc->length;
        const double angle = random_between(&seed, -PROTOTYPE_PI, PROTOTYPE_PI);
        s->point[k][0] = rho * cos(angle);
        s->point[k][1] = rho * sin(angle);
        s->point[k][2] = random_between(&seed, -sc->length, 0.1 + 2 * sc->length);
    }
    map("nothing in the way", s, &free_room);
    for (int k = 0; k < s->npoint; k++) {
        inverse_answer a;
        CHECK_OK(inverse_solve(s->inverse, s->state, point_at(s, k), &a));
        const double beyond = a.nearest.miss - near_enough;
        if (s->found[k] == 0) {
            CHECK_ABOVE(beyond, 0);
        }
        if (s->found[k] == 1) {
            CHECK_AT_MOST(beyond, 1e-9);
        }
        if (s->found[k] == 2) {
            CHECK_BELOW(fabs(beyond), s->options.resolution);
        }
    }
    CHECK_ABOVE(s->count[0], s->npoint / 10);
    CHECK_ABOVE(s->count[1], s->npoint / 10);
    CHECK_AT_MOST(s->count[2], POINTS / 20);
}

// in a ball of tissue: each point searched for on its own
static void tissue_is_the_search(study *s)
{
    search_options options = search_options_default();
    int open = 0;
    options.tolerance = near_enough;
    options.most_looks = 3000;
    for (int k = 0; k < s->npoint; k++) {
        search_answer a;
        CHECK_OK(search_solve(s->inverse, s->state, point_at(s, k), &s->room, &options, &a));
        const bool refused = a.verdict == SEARCH_OUT_OF_REACH || a.verdict == SEARCH_JOINT_LIMIT ||
                             (a.verdict == SEARCH_COLLISION && a.bound < 0);
        CHECK(s->found[k] != 0 || a.verdict != SEARCH_REACHED);
        CHECK(s->found[k] != 1 || !refused);
        open += s->found[k] == 2;
        // what is not decided has little room, or little to spare of the way
        CHECK(s->found[k] != 2 || !(a.verdict == SEARCH_REACHED && a.room > 5e-4));
    }
    CHECK_ABOVE(s->count[0], s->npoint / 20);
    CHECK_ABOVE(s->count[1], s->npoint / 20);
    CHECK_AT_MOST(open, s->npoint / 10);
}

// no free pose comes near what is proved not to be reached
static void random_poses_agree(study *s, int n)
{
    unsigned long long seed = 8;
    int free_poses = 0, wrong = 0;
    for (int i = 0; i < n; i++) {
        double q[SCOPE_JOINTS], at;
        bool close = false;
        random_joints(&s->m.scope, &seed, q);
        CHECK_OK(scope_bend(s->state, q));
        const vec3 tip = scope_point(s->state, q, s->m.scope.length);
        for (int k = 0; k < s->npoint; k++) {
            close = close || (s->found[k] == 0 && distance(tip, point_at(s, k)) <= near_enough);
        }
        free_poses += i % 10 == 0 && s->room.at(s->room.context, s->state, q, &at) >= 0;
        wrong += close && s->room.at(s->room.context, s->state, q, &at) >= 0;
    }
    printf("%-28s %d random poses, a tenth of which %d free ones, none near what is not reached\n",
           "", n, free_poses);
    CHECK(wrong == 0);
    CHECK_ABOVE(free_poses, 0);
}

// equally many per area, and the same for the same seed
static void samples_are_spread(study *s)
{
    double again[POINTS][3];
    int octant[8] = {0};
    CHECK_OK(surface_samples(&s->wall, POINTS, 4, s->point));
    CHECK_OK(surface_samples(&s->wall, POINTS, 4, again));
    CHECK(memcmp(again, s->point, sizeof again) == 0);
    CHECK_OK(surface_samples(&s->wall, POINTS, 5, again));
    CHECK(memcmp(again, s->point, sizeof again) != 0);
    for (int k = 0; k < POINTS; k++) {
        const vec3 p = point_at(s, k);
        CHECK_BELOW(fabs(distance_to(s->tree, p).distance), 1e-15);
        octant[(p.a[0] > 2e-3) + 2 * (p.a[1] > 1e-3) + 4 * (p.a[2] > 38e-3)]++;
    }
    for (int i = 0; i < 8; i++) {
        CHECK_AT_MOST(abs(octant[i] - POINTS / 8), 2);
    }
    CHECK(surface_samples(&s->wall, -1, 4, again) == ERR_INPUT);
    status_clear();
}

static bool enough(void *context, double share)
{
    int *asked = context;
    ++*asked;
    return share >= 0;
}

static void stops_and_refuses(study *s)
{
    reach_map_options o = s->options;
    int asked = 0;
    o.stop = enough;
    o.context = &asked;
    CHECK(reach_map(s->inverse, s->state, &s->room, s->npoint, (const double(*)[3])s->point, &o,
                    &s->answer) == ERR_RESOURCE);
    status_clear();
    CHECK(asked == 1);
    o.near = 0;
    CHECK(reach_map(s->inverse, s->state, &s->room, s->npoint, (const double(*)[3])s->point, &o,
                    &s->answer) == ERR_INPUT);
    status_clear();
    // few looks: nothing is wrong, much is not known
    s->options.most_looks = 2000;
    map("few looks", s, &s->room);
    CHECK_ABOVE(s->count[2], POINTS / 20);
    random_poses_agree(s, 2000);
}

static void whole(const char *name, study *s)
{
    const bool one = s->m.scope.njoint == 3;
    start(s);
    s->npoint = test_is_long() || !s->m.scope.rod ? POINTS : 60;
    if (one) {
        free_space_is_the_inverse(s);
    }
    CHECK_OK(surface_samples(&s->wall, s->npoint, 1, s->point));
    s->options.most_looks = one || test_is_long() ? 1000000 : 20000;
    map(name, s, &s->room);
    if (one) {
        tissue_is_the_search(s);
    }
    random_poses_agree(s, test_is_long() ? 100000 : s->m.scope.rod ? 2000 : 20000);
}

int main(void)
{
    against(BY_SECOND_WAY, "the inverse, a search for each point, random poses");
    static study s;
    s.m = arc_scope();
    whole("constant curvature", &s);
    samples_are_spread(&s);
    stops_and_refuses(&s);
    stop(&s);
    for (int n = 1; n <= 2; n++) {
        s = (study){.npoint = 0};
        neuro_scope(n, usual_plan, &s.m);
        s.m.scope.radius = 1e-3;
        whole(n == 1 ? "neuro, 1 tendon" : "neuro, 2 tendons", &s);
        stop(&s);
    }
    return test_failures != 0;
}
