// fem/corner_strength.h
// How singular a clamped end is where it meets a free wall.
#pragma once

// Displacements near the edge where a clamped face meets a free one at a right angle go with
// r^lambda, 1/2 < lambda <= 1: Williams' exponent in plane strain, docs/theory.md (5.15). Poisson's
// ratio up to 1/2; 1 (not singular) for 0 and below.
double corner_strength(double nu);
