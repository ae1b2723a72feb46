// What eyes make of a colour: CIELAB at D65, the difference
// of two colours by CIEDE2000, and how eyes without one kind of cones see.
#pragma once

#include "reports/palette.h"

#include <math.h>

typedef enum vision { NORMAL, PROTANOPIA, DEUTANOPIA, TRITANOPIA, VISIONS } vision;

typedef struct lab {
    double L, a, b;
} lab;

static inline double linear_part(double x) // sRGB, IEC 61966-2-1
{
    return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}

// Machado, Oliveira and Fernandes, "A physiologically-based model for simulation of color vision
// deficiency", IEEE TVCG 15 (2009), table 1 at severity 1; on linear RGB
static inline void seen_by(vision v, const double rgb[3], double seen[3])
{
    static const double kept[VISIONS][3][3] = {
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        {{0.152286, 1.052583, -0.204868},
         {0.114503, 0.786281, 0.099216},
         {-0.003882, -0.048116, 1.051998}},
        {{0.367322, 0.860646, -0.227968},
         {0.280085, 0.672501, 0.047413},
         {-0.011820, 0.042940, 0.968881}},
        {{1.255528, -0.076749, -0.178779},
         {-0.078411, 0.930809, 0.147602},
         {0.004733, 0.691367, 0.303900}},
    };
    for (int i = 0; i < 3; i++) {
        const double sum = kept[v][i][0] * rgb[0] + kept[v][i][1] * rgb[1] + kept[v][i][2] * rgb[2];
        seen[i] = fmin(fmax(sum, 0), 1);
    }
}

static inline double lab_root(double x)
{
    return x > 216.0 / 24389 ? cbrt(x) : (24389.0 / 27 * x + 16) / 116;
}

static inline lab lab_of(colour c, vision v)
{
    static const double xyz[3][3] = {{0.4124564, 0.3575761, 0.1804375},
                                     {0.2126729, 0.7151522, 0.0721750},
                                     {0.0193339, 0.1191920, 0.9503041}},
                        white[3] = {0.95047, 1, 1.08883};
    const double rgb[3] = {linear_part(c.r), linear_part(c.g), linear_part(c.b)};
    double seen[3], f[3];
    seen_by(v, rgb, seen);
    for (int i = 0; i < 3; i++) {
        f[i] =
            lab_root((xyz[i][0] * seen[0] + xyz[i][1] * seen[1] + xyz[i][2] * seen[2]) / white[i]);
    }
    return (lab){116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

static inline double degrees_of(double b, double a)
{
    const double h = atan2(b, a) * 180 / acos(-1.0);
    return h < 0 ? h + 360 : h;
}

static inline double cos_degrees(double x)
{
    return cos(x * acos(-1.0) / 180);
}

// Sharma, Wu and Dalal, "The CIEDE2000 color-difference formula", Color Research and Application 30
// (2005); letters as there
static inline double colour_difference(lab p, lab q)
{
    const double mean = (hypot(p.a, p.b) + hypot(q.a, q.b)) / 2, m7 = pow(mean, 7);
    const double G = 0.5 * (1 - sqrt(m7 / (m7 + pow(25, 7))));
    const double a1 = (1 + G) * p.a, a2 = (1 + G) * q.a;
    const double C1 = hypot(a1, p.b), C2 = hypot(a2, q.b), C = (C1 + C2) / 2, C7 = pow(C, 7);
    const double h1 = degrees_of(p.b, a1), h2 = degrees_of(q.b, a2);
    const double turn = C1 * C2 > 0 ? remainder(h2 - h1, 360) : 0;
    const double L = (p.L + q.L) / 2, h = C1 * C2 > 0 ? h1 + turn / 2 : h1 + h2;
    const double T = 1 - 0.17 * cos_degrees(h - 30) + 0.24 * cos_degrees(2 * h) +
                     0.32 * cos_degrees(3 * h + 6) - 0.20 * cos_degrees(4 * h - 63);
    const double far = (fmod(h + 360, 360) - 275) / 25;
    const double RT = -2 * sqrt(C7 / (C7 + pow(25, 7))) * cos_degrees(90 - 60 * exp(-far * far));
    const double l = (q.L - p.L) / (1 + 0.015 * (L - 50) * (L - 50) / hypot(sqrt(20), L - 50));
    const double c = (C2 - C1) / (1 + 0.045 * C);
    const double k = 2 * sqrt(C1 * C2) * cos_degrees(90 - turn / 2) / (1 + 0.015 * C * T);
    return sqrt(l * l + c * c + k * k + RT * c * k);
}
