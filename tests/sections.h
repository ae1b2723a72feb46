// Sections of all kinds, as the error estimate must serve them: smooth and with corners, thin and
// thick, of one material and of many, near the origin and not, directed, and turning along the rod.
#pragma once

#include "tests/sections_directed.h"

enum { SAMPLES = 50 };

static inline void sample_make(int k, sample *s)
{
    static const double tee[2][4] = {{10e-3, 2e-3, 0, 0}, {2e-3, 8e-3, 0, -5e-3}};
    static const double you[3][4] = {
        {10e-3, 1e-3, 0, 0}, {1e-3, 8e-3, -4.5e-3, 4e-3}, {1e-3, 8e-3, 4.5e-3, 4e-3}};
    static const double eye[3][4] = {
        {8e-3, 1e-3, 0, 5e-3}, {8e-3, 1e-3, 0, -5e-3}, {0.6e-3, 10e-3, 0, 0}};
    static const double channel[3][4] = {
        {1e-3, 12e-3, 0, 0}, {6e-3, 1e-3, 2.5e-3, 5.5e-3}, {6e-3, 1e-3, 2.5e-3, -5.5e-3}};
    *s = (sample){0};
#define KIND(number, words, quick, call)                                                           \
    case number:                                                                                   \
        s->name = words;                                                                           \
        s->in_short = quick;                                                                       \
        call;                                                                                      \
        break
    switch (k) {
        KIND(0, "annulus 1/5", true, sample_ring(s, 4e-3, 3.2e-3));
        KIND(1, "annulus 1/50", false, sample_ring(s, 4e-3, 3.92e-3));
        KIND(2, "annulus thick", false, sample_ring(s, 4e-3, 0.4e-3));
        KIND(3, "sector pi/8, 24", true, sample_sector(s, PI / 8, 24.136, 0.3));
        KIND(4, "sector pi/8, 24, unequal nu", false, sample_sector(s, PI / 8, 24.136, 0.45));
        KIND(5, "sector pi/2, 24", false, sample_sector(s, PI / 2, 24.136, 0.3));
        KIND(6, "sector 3 pi/2, 24", false, sample_sector(s, 3 * PI / 2, 24.136, 0.3));
        KIND(7, "sector pi/8, 1e4", false, sample_sector(s, PI / 8, 1e4, 0.3));
        KIND(8, "sector pi/8, 1.5", false, sample_sector(s, PI / 8, 1.5, 0.3));
        KIND(9, "rectangle 4 x 1", true, sample_box(s, 4e-3, 1e-3, 0, 0.3));
        KIND(10, "rectangle 40 x 1", false, sample_box(s, 40e-3, 1e-3, 0, 0.3));
        KIND(11, "square, nu 0", false, sample_box(s, 4e-3, 4e-3, 0, 0));
        KIND(12, "square, nu 0.49", false, sample_box(s, 4e-3, 4e-3, 0, 0.49));
        KIND(13, "rectangle turned", false, sample_box(s, 4e-3, 1e-3, 0.6, 0.3));
        KIND(14, "L", true, sample_angle(s));
        KIND(15, "T", false, sample_walls(s, 2, tee));
        KIND(16, "U", false, sample_walls(s, 3, you));
        KIND(17, "I", false, sample_walls(s, 3, eye));
        KIND(18, "channel", false, sample_walls(s, 3, channel));
        KIND(19, "polygon with holes", true, sample_quadrilateral_with_holes(s));
        KIND(20, "hexagon", false, sample_hexagon(s));
        KIND(21, "disc with off-centre hole", true, sample_discs(s, 2e-3, -1, 1));
        KIND(22, "disc with off-centre core, 10", false, sample_discs(s, 2e-3, 1, 10));
        KIND(23, "disc with soft core, 1e-3", false, sample_discs(s, -1e-3, 1, 1e-3));
        KIND(24, "disc", false, sample_discs(s, 0, 0, 1));
        KIND(25, "annulus of two, nu 0 and 0.49", true, sample_core_and_shell(s, 0.49, 0));
        KIND(26, "annulus of two, nu 0.3", false, sample_core_and_shell(s, 0.3, 0.3));
        KIND(27, "square with stiff half", true, sample_square_with_stiff_half(s));
        KIND(28, "catheter", false, sample_catheter(s));
        KIND(29, "rectangle moved and turned", false, sample_moved(s, 0.1));
        KIND(30, "ring of three materials", false, sample_three_materials(s));
        KIND(31, "rectangle of two, nu 0 and 0.45", false, sample_split_rectangle(s));
        KIND(32, "sector pi/8, 24, nu 0", false, sample_sector(s, PI / 8, 24.136, 0));
        KIND(33, "disc with a far hole", false, sample_discs(s, 2.8e-3, -1, 1));
        KIND(34, "ellipse", false, sample_ellipse(s));
        KIND(35, "ellipse with core and hole", false, sample_ellipse_with_core(s));
        KIND(36, "rounded rectangle", true, sample_rounded(s));
        KIND(37, "rounded square with lumens", false, sample_rounded_with_lumens(s));
        KIND(38, "spline with a hole", false, sample_spline(s));
        KIND(39, "square, fibre at 22.5 deg", true, sample_square_of_plies(s));
        KIND(40, "wound ring", false, sample_wound_ring(s));
        KIND(41, "wound wall of two plies", false, sample_wound_wall(s));
        KIND(42, "laminate of two plies", false, sample_laminate(s));
        KIND(43, "anisotropic half, soft half", false, sample_anisotropic_half(s));
        KIND(44, "ring with a wound sector", false, sample_wound_ring_with_sector(s));
        KIND(45, "sector pi/8, turning 0.05/mm", true, sample_turning_sector(s, 0.3, 50));
        KIND(46, "sector pi/8, turning 0.1/mm", false, sample_turning_sector(s, 0.3, 100));
        KIND(47, "unequal nu, turning 0.1/mm", false, sample_turning_sector(s, 0.45, 100));
        KIND(48, "square bar, turning 0.1/mm", false, sample_turning_box(s, 4e-3, 4e-3, 100));
        KIND(49, "catheter, turning 0.1/mm", false, sample_turning_catheter(s, 100));
    default:
        break;
    }
#undef KIND
}
