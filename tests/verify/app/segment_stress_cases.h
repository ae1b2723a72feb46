// tests/verify/app/segment_stress_cases.h
// What is asked of the segments of docs/segment_stability.md.
#pragma once

#include "tests/verify/app/segment_stress.h"

typedef struct stress_table {
    stress_count count;
    const char *only; // lines whose words contain it; NULL: all
    bool brief;       // every line costs a second at most
} stress_table;

static inline void table_add(stress_table *t, const stress_segment *s, bool in_brief)
{
    if ((!t->brief || in_brief) && (!t->only || strstr(s->what, t->only))) {
        stress_rows(s, &t->count);
    }
}

static const char STRESS_FREE[] = "base: free_to_contract, tip: E_proportional";

static inline void stress_contrasts(stress_table *t)
{
    static const double contrast[] = {1, 1e2, 1e4, 1e6, 1e8};
    for (int k = 0; k < 5; k++) {
        stress_segment s = stress_plain("stiff sector, contrast", contrast[k]);
        s.contrast = contrast[k];
        s.truth = contrast[k] < 1e4 ? NULL : "2e-4";
        table_add(t, &s, false);
    }
    for (int k = 1; k < 5; k++) {
        stress_segment s = stress_plain("soft sector, contrast", contrast[k]);
        s.contrast = 1 / contrast[k];
        s.truth = contrast[k] < 1e4 ? NULL : "2e-4";
        table_add(t, &s, false);
    }
    for (int k = 1; k < 5; k++) {
        stress_segment s = stress_plain("stiff sector, ends free, contrast", contrast[k]);
        s.contrast = contrast[k];
        s.truth = contrast[k] < 1e4 ? NULL : "2e-4";
        s.ends = STRESS_FREE;
        s.exact = true;
        table_add(t, &s, k == 4);
    }
    for (int k = 1; k < 5; k++) {
        stress_segment s = stress_plain("stiff core, contrast", contrast[k]);
        s.contrast = contrast[k];
        s.truth = contrast[k] < 1e4 ? NULL : "2e-4";
        s.section = "    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 1}, material: soft}\n"
                    "    - {annulus: {outer_radius_mm: 2, inner_radius_mm: 1}, material: stiff}\n";
        table_add(t, &s, false);
    }
}

static inline void stress_walls(stress_table *t)
{
    static const double wall[] = {5, 20, 50, 100, 200};
    for (int k = 0; k < 5; k++) {
        stress_segment s = stress_plain("radius / wall", wall[k]);
        s.wall = 1 / wall[k];
        table_add(t, &s, false);
    }
    for (int k = 0; k < 5; k++) {
        stress_segment s = stress_plain("ends free, radius / wall", wall[k]);
        s.wall = 1 / wall[k];
        s.ends = STRESS_FREE;
        s.exact = true;
        s.one_way = t->brief && !test_is_long();
        table_add(t, &s, k == 2);
    }
}

static inline void stress_poissons(stress_table *t)
{
    static const double nu[] = {0, 0.3, 0.45, 0.49, 0.499, 0.4999};
    for (int k = 0; k < 6; k++) {
        stress_segment s = stress_plain("nu", nu[k]);
        s.nu_soft = s.nu_stiff = nu[k];
        table_add(t, &s, false);
    }
    for (int k = 0; k < 6; k++) {
        stress_segment s = stress_plain("ends free, nu", nu[k]);
        s.nu_soft = s.nu_stiff = nu[k];
        s.ends = STRESS_FREE;
        s.exact = true;
        table_add(t, &s, k == 2);
    }
    for (int k = 0; k < 6; k++) {
        stress_segment s = stress_plain("nu 0.3 in the sector, else", nu[k]);
        s.nu_soft = nu[k];
        table_add(t, &s, false);
    }
}

typedef struct stress_mesh {
    const char *what, *mesh;
    double aspect, length;
} stress_mesh;

static inline void stress_elements(stress_table *t)
{
    static const stress_mesh mesh[] = {
        {"longest layer / shortest", "layers: 20, grading: 1, order: 3, size_mm: 1", 1, 2.5},
        {"longest layer / shortest", "layers: 20, grading: 1000, order: 3, size_mm: 1", 1e3, 2.5},
        {"layer / element, order 3", "layers: 2, grading: 1, order: 3, size_mm: 1", 10, 2.5},
        {"layer / element, order 3", "layers: 2, grading: 1, order: 3, size_mm: 0.2", 1e3, 50},
        {"layer / element, order 2", "layers: 2, grading: 1, order: 2, size_mm: 0.2", 1e3, 50},
        {"layer / element, order 4", "layers: 2, grading: 1, order: 4, size_mm: 0.4", 500, 50},
        {"element / shortest layer", "layers: 30, grading: 1e4, order: 3, size_mm: 2", 1e3, 2.5},
    };
    for (int k = 0; k < 7; k++) {
        stress_segment s = stress_plain(mesh[k].what, mesh[k].aspect);
        s.mesh = mesh[k].mesh;
        s.length = mesh[k].length;
        table_add(t, &s, false);
    }
}

static inline void stress_lengths(stress_table *t)
{
    static const double length[] = {0.1, 0.3, 1, 5, 15, 50};
    for (int k = 0; k < 6; k++) {
        stress_segment s = stress_plain("length / diameter", length[k]);
        s.length = length[k];
        s.long_one = length[k] >= 15;
        table_add(t, &s, false);
    }
}

static inline stress_count stress_all(bool brief, const char *only)
{
    stress_table t = {.brief = brief, .only = only};
    printf("| segment | value | way | tolerance | compliance: true error | estimate | law of the "
           "middle: true error | estimate | |\n"
           "|---|---|---|---|---|---|---|---|---|\n");
    stress_contrasts(&t);
    stress_walls(&t);
    stress_poissons(&t);
    stress_elements(&t);
    stress_lengths(&t);
    return t.count;
}
