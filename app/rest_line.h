// app/rest_line.h
// The centreline of a rod at rest: the body frame along it. docs/theory.md (4.1), (5.16)
#pragma once

#include "rodsolver/rod.h"

typedef struct rest_line {
    rest_shape rest;
    double from, to; // arclengths [m]
    int npanel;
    double *s;   // [npanel + 1] where panels begin and end
    pose *begin; // [npanel] body frame there, the identity at `from`
} rest_line;

// breaks: [nbreak] arclengths where a curvature jumps; others are found. ERR_INPUT where the shape
// is not finite.
status rest_line_make(const rest_shape *rest, double from, double to, int nbreak,
                      const double *breaks, rest_line *out);
void rest_line_free(rest_line *line);

pose rest_line_at(const rest_line *line, double s);

// A straight rod without twist; one that only twists, at one rate (then its rate [rad/m]).
bool rest_line_is_straight(const rest_shape *rest);
bool rest_line_only_twists(const rest_shape *rest, double *rate);

// Angle by which the frame turns all in all along it [rad].
double rest_line_way(const rest_line *line);
