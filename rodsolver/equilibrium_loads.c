// rodsolver/equilibrium_loads.c
// All loads added up, in the base frame: linear in the factors, so that those on the way between
// two demands lie between their sums. docs/theory.md (4.12)
#include "rodsolver/equilibrium.h"

#include <string.h>

typedef struct one_load {
    int frame;
    double factor;
    vec3 force, moment;
    double x, y; // where the force acts, seen from the solve's frame
} one_load;

static void add_dead(const one_load *l, const mat3 *to_base, load_sum *sum)
{
    const vec3 f = mat3_mul_vec(*to_base, vec3_scale(l->factor, l->force));
    sum->dead = vec3_add(sum->dead, f);
    sum->dead_moment =
        vec3_add(sum->dead_moment, mat3_mul_vec(*to_base, vec3_scale(l->factor, l->moment)));
    for (int j = 0; j < 3; j++) {
        sum->dyad.a[0][j] += l->x * f.a[j];
        sum->dyad.a[1][j] += l->y * f.a[j];
    }
}

static void add_follower(const one_load *l, load_sum *sum)
{
    const vec3 f = vec3_scale(l->factor, l->force), place = {{l->x, l->y, 0}};
    const vec3 m = vec3_add(vec3_scale(l->factor, l->moment), vec3_cross(place, f));
    sum->follower = vec3_add(sum->follower, f);
    sum->follower_moment = vec3_add(sum->follower_moment, m);
}

static void add_load(const one_load *l, const mat3 *to_base, load_sum *sum)
{
    if (l->frame == LOAD_SPACE) {
        add_dead(l, to_base, sum);
    } else {
        add_follower(l, sum);
    }
}

static vec3 of_array(const double *a)
{
    return (vec3){{a[0], a[1], a[2]}};
}

// a wrench given about the geometric centre of a node, seen from the solve's frame there
static void add_at_node(const equilibrium *e, int node, int frame, double factor, vec3 force,
                        vec3 moment, const double place[2], const mat3 *to_base, load_sum *sum)
{
    one_load l = {frame, factor, force, moment, place[0], place[1]};
    if (e->plan->node_frame) {
        const pose T = centre_frame_pose(&e->plan->node_frame[node]);
        const vec3 q = mat3_tmul_vec(T.R, vec3_sub((vec3){{place[0], place[1], 0}}, T.p));
        l.x = q.a[0];
        l.y = q.a[1];
        if (frame == LOAD_BODY) {
            l.force = mat3_tmul_vec(T.R, force);
            l.moment = mat3_tmul_vec(T.R, moment);
        }
    }
    add_load(&l, to_base, &sum[node]);
}

static void add_points(const equilibrium *e, const demand *d, load_sum *node)
{
    static const double centre[2] = {0, 0};
    const rod *r = e->rod;
    const int tip = 2 * e->plan->npair;
    memset(node, 0, ((size_t)tip + 1) * sizeof *node);
    for (int i = 0; i < r->npoint_load; i++) {
        const point_load *l = &r->point_loads[i];
        add_at_node(e, e->plan->point_panel[i] + 1, l->frame, d->load[i], of_array(l->force),
                    of_array(l->moment), l->place, &d->to_base, node);
    }
    add_at_node(e, tip, LOAD_SPACE, 1, of_array(d->tip_space.a), of_array(d->tip_space.a + 3),
                centre, &d->to_base, node);
    add_at_node(e, tip, LOAD_BODY, 1, of_array(d->tip_body.a), of_array(d->tip_body.a + 3), centre,
                &d->to_base, node);
}

static void add_lines(const equilibrium *e, const demand *d, load_sum *line)
{
    const rod *r = e->rod;
    const int nline = r->nline_load + r->has_gravity;
    memset(line, 0, (size_t)e->plan->nstation * sizeof *line);
    for (int i = 0; i < nline; i++) {
        const double factor = d->load[r->npoint_load + i];
        const int frame = i < r->nline_load ? r->line_loads[i].frame : LOAD_SPACE;
        for (int k = 0; factor != 0 && k < e->plan->nstation; k++) {
            const line_station *s = &e->plan->line[i][k];
            const one_load l = {frame, factor, s->force, s->moment, s->x, s->y};
            add_load(&l, &d->to_base, &line[k]);
        }
    }
}

void demand_nothing(const rod *r, const demand *like, demand *d)
{
    for (int i = 0; i < r->ntendon; i++) {
        d->pull[i] = d->tension[i] = 0;
    }
    for (int i = 0; i < rod_load_count(r); i++) {
        d->load[i] = 0;
    }
    d->tip_space = d->tip_body = (vec6){{0}};
    d->to_base = like->to_base;
}

void demand_copy(const rod *r, const demand *from, demand *to)
{
    memcpy(to->tension, from->tension, (size_t)r->ntendon * sizeof *to->tension);
    memcpy(to->pull, from->pull, (size_t)r->ntendon * sizeof *to->pull);
    memcpy(to->load, from->load, (size_t)rod_load_count(r) * sizeof *to->load);
    to->tip_space = from->tip_space;
    to->tip_body = from->tip_body;
    to->to_base = from->to_base;
}

// a load_sum is nothing but numbers
enum { LOAD_NUMBERS = sizeof(load_sum) / sizeof(double) };

static void subtract(int n, const load_sum *to, const load_sum *from, load_sum *out)
{
    const double *a = (const double *)to, *b = (const double *)from;
    double *c = (double *)out;
    for (int i = 0; i < n * LOAD_NUMBERS; i++) {
        c[i] = a[i] - b[i];
    }
}

void loads_prepare(equilibrium *e)
{
    add_points(e, &e->from, e->node_from);
    add_points(e, &e->to, e->node_to);
    subtract(2 * e->plan->npair + 1, e->node_to, e->node_from, e->node_difference);
    if (e->lines) {
        add_lines(e, &e->from, e->line_from);
        add_lines(e, &e->to, e->line_to);
        subtract(e->plan->nstation, e->line_to, e->line_from, e->line_difference);
    }
}

static void blend(int n, double factor, const load_sum *from, const load_sum *to, load_sum *out)
{
    const double *a = (const double *)from, *b = (const double *)to;
    double *c = (double *)out;
    for (int i = 0; i < n * LOAD_NUMBERS; i++) {
        c[i] = (1 - factor) * a[i] + factor * b[i];
    }
}

void loads_of(equilibrium *e, const demand *d)
{
    add_points(e, d, e->node_difference);
    if (e->lines) {
        add_lines(e, d, e->line_difference);
    }
}

void loads_at_factor(equilibrium *e)
{
    blend(2 * e->plan->npair + 1, e->factor, e->node_from, e->node_to, e->node);
    if (e->lines) {
        blend(e->plan->nstation, e->factor, e->line_from, e->line_to, e->line);
    }
    for (int i = 0; i < e->rod->ntendon; i++) {
        if (!e->pulled[i]) {
            e->tension[i] = (1 - e->factor) * e->from.tension[i] + e->factor * e->to.tension[i];
        }
    }
}
