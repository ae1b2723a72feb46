// app/chain_rod_names.c
// What tables and figures call tendons and loads, and where tendons run.
#include "app/chain.h"

#include <math.h>

// straight lines between the table's points
static void table_place(const tendon_table *table, double s, double place[2])
{
    const double *p = table->point;
    int i = 0;
    while (i < table->count - 2 && s > p[3 * (i + 1)]) {
        i++;
    }
    p += 3 * (size_t)i;
    const double t = fmin(fmax((s - p[0]) / (p[3] - p[0]), 0), 1);
    place[0] = p[1] + t * (p[4] - p[1]);
    place[1] = p[2] + t * (p[5] - p[2]);
}

void chain_tendon_place(const tendon_spec *t, double s, double place[2])
{
    const double radius = field_at(&t->radius, s), angle = field_at(&t->angle, s);
    place[0] = place[1] = 0;
    if (t->table.count > 0) {
        table_place(&t->table, s, place);
    }
    place[0] += radius * cos(angle) + field_at(&t->x, s);
    place[1] += radius * sin(angle) + field_at(&t->y, s);
}

static void keep_name(const char *name, const char *kind, int number, char out[RESULT_NAME])
{
    if (name) {
        (void)snprintf(out, RESULT_NAME, "%s", name);
    } else {
        (void)snprintf(out, RESULT_NAME, "%s %d", kind, number);
    }
}

static void name_tendons(const rod_case *rc, rod_result *rods)
{
    for (int i = 0; i < rods->ntendon; i++) {
        const tendon_spec *t = &rc->spec[i];
        chain_tendon_place(t, 0, rods->tendon_base[i]);
        chain_tendon_name(rc, i, rods->tendon_name[i]);
    }
}

void chain_tendon_name(const rod_case *rc, int i, char name[RESULT_NAME])
{
    keep_name(rc->spec[i].name, "tendon", i + 1, name);
}

void chain_load_name(const rod_case *rc, int i, char name[RESULT_NAME])
{
    const point_load *point = rc->loads.items;
    const line_load *line = rc->line_loads.items;
    const int line_number = i - rc->loads.count;
    if (line_number < 0) {
        keep_name(point[i].name, "load", i + 1, name);
    } else if (line_number < rc->line_loads.count) {
        keep_name(line[line_number].name, "line load", line_number + 1, name);
    } else {
        keep_name("gravity", "", 0, name);
    }
}

void chain_rod_names(const rod_case *rc, rod_result *rods)
{
    name_tendons(rc, rods);
    for (int i = 0; i < rods->nload; i++) {
        chain_load_name(rc, i, rods->load_name[i]);
    }
}
