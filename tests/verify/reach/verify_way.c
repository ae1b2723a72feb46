// tests/verify/reach/verify_way.c
// Ways in: what is found is free between its poses too, by dense steps; what has to be found is;
// where the begin is in tissue there is none.
#include "tests/unit/reach/scopes.h"

#include "reach/way.h"

enum { POINTS = 40, STEPS = 30, LOOKS = 20000 };

static const double resolution = 5e-5;

// tissue above z = ceiling, and balls; of the whole body, or a ring about a place, of the tip alone
typedef struct toy {
    double ceiling;
    int nball;
    vec3 ball[4];
    double size;
    bool ring;
} toy;

static double free_at(const toy *t, vec3 p)
{
    double least = t->ceiling - p.a[2];
    for (int i = 0; i < t->nball; i++) {
        least = fmin(least, distance(p, t->ball[i]) - t->size);
    }
    return least;
}

// a ring in the plane of x and z about ball[0], which bars that plane
static double out_of_ring(const toy *t, vec3 p)
{
    const vec3 to = vec3_sub(p, t->ball[0]);
    return hypot(hypot(to.a[0], to.a[2]) - t->size, to.a[1]) - 1e-3;
}

static double toy_room(void *context, scope_state *state, const double *q, double *s)
{
    const toy *t = context;
    const scope *sc = scope_of(state);
    double least = INFINITY;
    *s = sc->length;
    if (t->ring) {
        return out_of_ring(t, scope_point(state, q, sc->length));
    }
    for (int i = 0; i <= POINTS; i++) {
        const double at = sc->length * i / POINTS;
        least = fmin(least, free_at(t, scope_point(state, q, at)) - sc->radius);
    }
    return least;
}

typedef struct study {
    made_scope m;
    scope_state *state;
    toy toy;
    room_probe room;
    way_answer answer;
} study;

static void start(study *s)
{
    const pose plain = pose_identity();
    CHECK_OK(scope_state_make(&s->m.scope, &plain, &s->state));
    s->room = (room_probe){.at = toy_room, .context = &s->toy};
}

static void stop(study *s)
{
    scope_state_free(s->state);
    free_scope(&s->m);
}

static double room_of(study *s, const double *q)
{
    double at;
    CHECK_OK(scope_bend(s->state, q));
    return toy_room(&s->toy, s->state, q, &at);
}

// the least room by small steps from pose to pose
static double dense_room(study *s)
{
    const way_answer *a = &s->answer;
    double least = room_of(s, a->q[0]);
    for (int k = 1; k < a->npose; k++) {
        for (int i = 1; i <= STEPS; i++) {
            double q[SCOPE_JOINTS];
            for (int j = 0; j < SCOPE_JOINTS; j++) {
                q[j] = a->q[k - 1][j] + (a->q[k][j] - a->q[k - 1][j]) * i / STEPS;
            }
            CHECK(scope_within(&s->m.scope, a->q[k]));
            least = fmin(least, room_of(s, q));
        }
    }
    return least;
}

static void find(study *s, const double *goal)
{
    way_answer *a = &s->answer;
    CHECK_OK(way_find(s->state, &s->room, goal, 0, resolution, LOOKS, a));
    CHECK_ABOVE(a->looks, 0);
    CHECK_AT_MOST(a->looks, LOOKS + 100);
    if (!a->found) {
        CHECK(a->npose == 0);
        return;
    }
    const int n = s->m.scope.njoint;
    const double dense = dense_room(s);
    CHECK_AT_LEAST(dense, a->room - 1e-9);
    CHECK_AT_LEAST(a->room, -resolution / 2);
    for (int j = 0; j < n; j++) {
        CHECK_WITHIN(a->q[a->npose - 1][j], goal[j], 0);
        CHECK(a->q[0][j] == s->m.scope.low[j] || j == SCOPE_TURN);
    }
}

// bent by a right angle under a ceiling that lets a straight tip come so far only
static void bends_while_it_goes_in(study *s)
{
    const double length = s->m.scope.length, radius = s->m.scope.radius;
    const double goal[SCOPE_JOINTS] = {0.06, 0.4, PROTOTYPE_PI / 2};
    s->toy = (toy){.ceiling = 1};
    find(s, goal);
    CHECK(s->answer.found && s->answer.straight);
    // nothing is near: what is left of the room is exact but for the body's motion between poses
    CHECK_ABOVE(s->answer.room, 1 - 0.06 - length - radius - 0.02);
    s->toy.ceiling = 0.06 + 0.8 * length;
    find(s, goal);
    CHECK(s->answer.found && !s->answer.straight);
    // no way is wider than its end is
    CHECK_AT_MOST(s->answer.room,
                  s->toy.ceiling - radius - (0.06 + length / (PROTOTYPE_PI / 2)) + 1e-9);
    printf("under a ceiling: %d poses, %d looks, room %.2g mm\n", s->answer.npose, s->answer.looks,
           1e3 * s->answer.room);
    // the tip does not come to the begin
    s->toy.ceiling = 0.9 * length;
    find(s, goal);
    CHECK(!s->answer.found);
    CHECK_BELOW(s->answer.room, 0);
}

// a ring bars the plane in which the tip bends: it has to come in from the side
static void turns_where_it_must(study *s)
{
    const double goal[SCOPE_JOINTS] = {0.05, 0, 2};
    s->toy = (toy){.ring = true, .size = 5e-3};
    CHECK_OK(scope_bend(s->state, goal));
    s->toy.ball[0] = scope_point(s->state, goal, s->m.scope.length);
    find(s, goal);
    CHECK(s->answer.found && !s->answer.straight);
    bool turned = false;
    for (int k = 0; k < s->answer.npose; k++) {
        turned = turned || s->answer.q[k][SCOPE_TURN] != 0;
    }
    CHECK(turned);
    printf("round a ring: %d poses, %d looks\n", s->answer.npose, s->answer.looks);
    // without turning there is no way
    s->m.scope.low[SCOPE_TURN] = s->m.scope.high[SCOPE_TURN] = 0;
    find(s, goal);
    CHECK(!s->answer.found);
    s->m.scope.low[SCOPE_TURN] = -PROTOTYPE_PI;
    s->m.scope.high[SCOPE_TURN] = PROTOTYPE_PI;
}

static void among_balls(const char *name, study *s, int n)
{
    about("%s", name);
    unsigned long long seed = 17;
    int straight = 0, round = 0, none = 0;
    const double length = s->m.scope.length;
    for (int k = 0; k < n; k++) {
        double q[SCOPE_JOINTS] = {0};
        s->toy = (toy){.ceiling = 1, .nball = 4, .size = 0.25 * length};
        for (int i = 0; i < 4; i++) {
            const double r = random_between(&seed, 0.5, 0.9) * length;
            const double angle = random_between(&seed, -PROTOTYPE_PI, PROTOTYPE_PI);
            const double z = random_between(&seed, 1.2 * length, 3 * length);
            s->toy.ball[i] = (vec3){{r * cos(angle), r * sin(angle), z}};
        }
        do {
            random_joints(&s->m.scope, &seed, q);
        } while (room_of(s, q) < 0);
        find(s, q);
        straight += s->answer.straight;
        round += s->answer.found && !s->answer.straight;
        none += !s->answer.found;
    }
    printf("%-22s %d straight in, %d round, %d none\n", name, straight, round, none);
    CHECK_ABOVE(straight, 0);
    CHECK_ABOVE(round, 0);
}

int main(void)
{
    against(BY_SECOND_WAY, "dense steps between the poses");
    static study arc, rod, two;
    arc.m = arc_scope();
    start(&arc);
    bends_while_it_goes_in(&arc);
    turns_where_it_must(&arc);
    among_balls("constant curvature", &arc, test_is_long() ? 400 : 60);
    stop(&arc);
    neuro_scope(1, usual_plan, &rod.m);
    rod.m.scope.radius = 1e-3;
    start(&rod);
    among_balls("neuro, 1 tendon", &rod, test_is_long() ? 100 : 10);
    stop(&rod);
    neuro_scope(2, usual_plan, &two.m);
    two.m.scope.radius = 1e-3;
    start(&two);
    among_balls("neuro, 2 tendons", &two, test_is_long() ? 100 : 10);
    stop(&two);
    return test_failures != 0;
}
