// reports/sensitivity_result.h
// What moves the answer: every parameter's part in where the tip goes, and what follows from all of
// them at once.
#pragma once

#include "base/se3.h"
#include "base/status.h"
#include "measure/shares.h"

#include <stdbool.h>

enum { MOVER_NAME = 64, MOVER_KEYS = 256, MOVER_UNIT = 24, MOVER_TEXT = 96, MOVER_WHY = 160 };
enum { MOST_MOVERS = 40 }; // parameters of a result
enum { MOVER_LOW, MOVER_HIGH, MOVER_ENDS };

// One end of a parameter's range; of an alternative there is only the high one.
typedef struct mover_end {
    bool asked;
    double value;          // in the parameter's unit; NAN: a text
    char text[MOVER_TEXT]; // "3.5", "full", "pi/2 - (pi/4)*(s/L)"
    char why[MOVER_WHY];   // why there is no answer; "" where there is one
} mover_end;

typedef struct mover {
    char name[MOVER_NAME], keys[MOVER_KEYS];
    char unit[MOVER_UNIT]; // of its keys' spelling, "" where they have none
    bool discrete;         // an alternative instead of a range
    double value;          // as the case stands, in that unit; NAN: no number
    char text[MOVER_TEXT]; // the same in words, "0.3", "classical", "as in the case"
    mover_end end[MOVER_ENDS];
    char no_rate[MOVER_WHY]; // why there is no derivative; "" where there is one
    // of the Monte-Carlo runs
    bool drawn;
    double sigma; // of the normal distribution, in its unit; 0: uniform from low to high
} mover;

// What one parameter does to one solution; NAN where there is no answer. Places in the world.
typedef struct move {
    double rate[3];              // of the tip's place [m per unit]
    double bend_rate;            // of the total bend [rad per unit]
    double rate_error;           // of both, relative to the place's: an estimate
    double moved[MOVER_ENDS][3]; // of the tip, by a whole solve at that end [m]
    double bend[MOVER_ENDS];     // of the total bend [rad]
    double reached[MOVER_ENDS];  // fraction of the loads at that end: below 1 at a limit point
} move;

typedef enum spread_quantity {
    SPREAD_X,
    SPREAD_Y,
    SPREAD_Z,
    SPREAD_OFF, // how far the tip is from where it is as the case stands
    SPREAD_BEND,
    SPREAD_QUANTITIES,
} spread_quantity;

typedef struct monte_carlo {
    int nsample; // 0: none was asked for
    int seed;
    int degree;            // of the polynomials by which the variance is shared out
    int *used;             // [nsolution] samples that have an answer
    sample_spread *spread; // [nsolution][SPREAD_QUANTITIES] [m], of the bend [rad]
    double *share; // [nsolution][SPREAD_QUANTITIES][nmover] first-order shares of the variance
} monte_carlo;

typedef struct sensitivity_result {
    bool own_list; // the case names no parameters: the list that suits any case
    int nmover, nsolution;
    mover *mover;  // [nmover], as the case has them
    int *solution; // [nsolution] of the rod's
    move *move;    // [nmover][nsolution]
    monte_carlo monte_carlo;
} sensitivity_result;

status sensitivity_result_make(int nmover, int nsolution, sensitivity_result *out);
status monte_carlo_make(const sensitivity_result *r, monte_carlo *out); // room beside the samples
void sensitivity_result_free(sensitivity_result *r);

const move *sensitivity_move(const sensitivity_result *r, int mover, int solution);
const sample_spread *sensitivity_spread(const sensitivity_result *r, int solution, int quantity);
const double *sensitivity_share(const sensitivity_result *r, int solution, int quantity);

// How far the tip moves by that end; NAN where there is no answer.
double move_size(const move *m, int end);
// ... as the derivative alone has it, over [m].
double move_linear(const mover *p, const move *m, int end);
// How far the derivative's move lies from the whole solve's, over the latter; NAN: not known, or
// the tip of a rod of that length moves less than solves agree.
double move_nonlinearity(const mover *p, const move *m, int end, double length);
// The larger of both ends; 0 where none has an answer.
double move_largest(const move *m);

// Parameters by how far they move that solution's tip, the largest first; order [nmover].
void sensitivity_sort(const sensitivity_result *r, int solution, int *order);
