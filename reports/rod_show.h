// reports/rod_show.h
// How the solutions of a rod are shown, the same in every picture: which belong together in a line
// of a sweep, which shapes are drawn, and one colour each.
#pragma once

#include "reports/figure_kit.h"
#include "reports/result.h"

// What a case gives to a solution.
typedef enum rod_given { GIVEN_TENSION, GIVEN_PULL, GIVEN_LOAD, GIVEN_KINDS } rod_given;
typedef struct rod_quantity {
    int kind, index; // rod_given; of the tendon or load
} rod_quantity;

// [N], [mm], [-]; 0 where the other of tension and pulled length was given
double rod_quantity_value(const struct rod_run *run, rod_quantity q);
const char *rod_quantity_unit(rod_quantity q); // "N", "mm", ""
// "tension of t1", "t2 drawn", "factor of tip force"
void rod_quantity_name(const rod_result *rod, rod_quantity q, char *text, size_t size);

// Consecutive solutions in which the same quantities change.
typedef struct rod_line {
    int first, count;
    rod_quantity lead; // of those that change, the one that pictures draw along
} rod_line;

typedef struct rod_show {
    const rod_result *rod;
    bool sweep; // the lines tell something: the longest is long and goes to and fro but a few times
    int nline;
    rod_line *line;
    bool factors_vary; // from solution to solution: labels tell them
    int nshown;
    int *shown; // of the shapes that are drawn, ascending
    int ndetail;
    int detail[6]; // of those that are drawn with loads and tendons, ascending
    colour *ink;   // [nsolution]
} rod_show;

status rod_show_make(const rod_result *rod, rod_show *out);
void rod_show_free(rod_show *s);

// "all solutions"; where those are too many to be drawn "24 of 81 solutions, spread over the sweep"
void rod_show_words(const rod_show *s, char *words, size_t size);

// The line to which a solution belongs.
int rod_show_line_of(const rod_show *s, int solution);

// At most `most` of 0 .. n - 1 at equal steps, the first and the last among them; their count.
int rod_spread(int n, int most, int *out);

// The point to draw after point k: some hundred make a smooth curve. npoint after the last.
int rod_next_point(const rod_result *rod, int k);
