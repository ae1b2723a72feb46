// rodsolver/routing.c
#include "rodsolver/routing.h"

#include "base/chebyshev.h"

#include <math.h>

void routing_place(const tendon_spec *t, double s, double *x, double *y)
{
    const double radius = field_at(&t->radius, s), angle = field_at(&t->angle, s);
    *x = field_at(&t->x, s) + radius * cos(angle);
    *y = field_at(&t->y, s) + radius * sin(angle);
}

bool routing_varies(const tendon_spec *t)
{
    return field_varies(&t->radius) || field_varies(&t->angle) || field_varies(&t->x) ||
           field_varies(&t->y);
}

void routing_make(const tendon_spec *tendon, const spline *table, double a, double b, routing *out)
{
    out->a = a;
    out->b = b;
    out->varies = routing_varies(tendon);
    out->table = table && table->ncoef > 0 ? table : NULL;
    const int n = out->varies ? ROUTING_NODES : 1;
    for (int i = 0; i < n; i++) {
        const double s = (a + b) / 2 + (b - a) / 2 * chebyshev_node(n, i);
        routing_place(tendon, s, &out->x[i], &out->y[i]);
    }
}

tendon_place routing_at(const routing *r, double s)
{
    const int n = r->varies ? ROUTING_NODES : 1;
    double value[ROUTING_NODES], slope[ROUTING_NODES];
    chebyshev_weights(n, (2 * s - r->a - r->b) / (r->b - r->a), value, slope);
    tendon_place p = {0};
    for (int i = 0; i < n; i++) {
        const double rate = slope[i] * 2 / (r->b - r->a);
        p.x += value[i] * r->x[i];
        p.y += value[i] * r->y[i];
        p.dx += rate * r->x[i];
        p.dy += rate * r->y[i];
    }
    if (r->table) {
        double value[2], rate[2];
        spline_at(r->table, s, value, rate);
        p.x += value[0];
        p.y += value[1];
        p.dx += rate[0];
        p.dy += rate[1];
    }
    return p;
}
