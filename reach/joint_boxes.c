// reach/joint_boxes.c
#include "reach/joint_boxes.h"

static const double pi = 3.14159265358979323846;

void box_push(box_heap *h, const joint_box *b)
{
    int i = h->n++;
    for (; i > 0 && h->box[(i - 1) / 2].bound < b->bound; i = (i - 1) / 2) {
        h->box[i] = h->box[(i - 1) / 2];
    }
    h->box[i] = *b;
}

joint_box box_pop(box_heap *h)
{
    const joint_box top = h->box[0], last = h->box[--h->n];
    int i = 0;
    for (int child = 1; child < h->n; child = 2 * i + 1) {
        child += child + 1 < h->n && h->box[child + 1].bound > h->box[child].bound;
        if (!(h->box[child].bound > last.bound)) {
            break;
        }
        h->box[i] = h->box[child];
        i = child;
    }
    h->box[i] = last;
    return top;
}

void box_motions(const bend_sweep *w, const joint_box *b, double part[BOX_JOINTS], double *tip)
{
    const double u = (b->low[SCOPE_BEND] + b->high[SCOPE_BEND]) / 2;
    const bend_node a = bend_sweep_at(w, b->low[SCOPE_BEND]), m = bend_sweep_at(w, u),
                    z = bend_sweep_at(w, b->high[SCOPE_BEND]);
    const double turn = (b->high[SCOPE_TURN] - b->low[SCOPE_TURN]) / 2;
    const double bent = fmax(m.moved - a.moved, z.moved - m.moved);
    const double tip_bent = fmax(m.tip_moved - a.tip_moved, z.tip_moved - m.tip_moved);
    part[SCOPE_INSERTION] = (b->high[SCOPE_INSERTION] - b->low[SCOPE_INSERTION]) / 2;
    part[SCOPE_TURN] = turn * (m.farthest + bent);
    part[SCOPE_BEND] = bent;
    *tip =
        hypot(part[SCOPE_INSERTION], turn * (hypot(m.tip.a[0], m.tip.a[1]) + tip_bent)) + tip_bent;
}

double box_motion(const double part[BOX_JOINTS])
{
    // along the line and about it are at right angles
    return hypot(part[SCOPE_INSERTION], part[SCOPE_TURN]) + part[SCOPE_BEND];
}

void box_halve(const bend_sweep *w, const joint_box *b, joint_box half[2])
{
    double part[BOX_JOINTS], tip;
    int widest = 0;
    box_motions(w, b, part, &tip);
    for (int j = 1; j < BOX_JOINTS; j++) {
        widest = part[j] > part[widest] ? j : widest;
    }
    half[0] = half[1] = *b;
    half[0].high[widest] = half[1].low[widest] = (b->low[widest] + b->high[widest]) / 2;
}

void box_one_turn(const scope *s, double limit[2])
{
    limit[0] = s->low[SCOPE_TURN];
    limit[1] = s->high[SCOPE_TURN];
    if (limit[1] - limit[0] > 2 * pi) {
        limit[0] = fmin(fmax(-pi, limit[0]), limit[1] - 2 * pi);
        limit[1] = limit[0] + 2 * pi;
    }
}
