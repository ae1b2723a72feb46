// section/along_error.c
#include "section/along_error.h"

#include "base/chebyshev.h"

#include <math.h>
#include <stddef.h>

// the two last Chebyshev coefficients, which bound what the next ones add where they decay
static double tail(int n, const double *value)
{
    double coefficient[LAW_ALONG_MAX_NODES];
    chebyshev_coefficients(n, value, coefficient);
    return fmax(fabs(coefficient[n - 1]), fabs(coefficient[n - 2]));
}

// K relative as in (6.1), by the panel's smallest diagonal
static double stiffness_error(const law_along *along, int panel)
{
    const int n = along->nnode;
    const beam_law *law = along->law + (size_t)panel * (size_t)n;
    double value[LAW_ALONG_MAX_NODES], size[6], most = 0;
    for (int i = 0; i < 6; i++) {
        size[i] = INFINITY;
        for (int k = 0; k < n; k++) {
            size[i] = fmin(size[i], law[k].K.a[i][i]);
        }
    }
    for (int i = 0; i < 6; i++) {
        for (int j = i; j < 6; j++) {
            for (int k = 0; k < n; k++) {
                value[k] = law[k].K.a[i][j];
            }
            most = fmax(most, tail(n, value) / sqrt(size[i] * size[j]));
        }
    }
    return most;
}

// the mass over the panel's smallest, and its centre over the section's smallest size
static double mass_error(const law_along *along, int panel)
{
    const int n = along->nnode;
    const beam_law *law = along->law + (size_t)panel * (size_t)n;
    double mass[LAW_ALONG_MAX_NODES], centre[2][LAW_ALONG_MAX_NODES];
    double least = INFINITY, area = INFINITY;
    for (int k = 0; k < n; k++) {
        mass[k] = law[k].mass;
        centre[0][k] = law[k].mass_centre[0];
        centre[1][k] = law[k].mass_centre[1];
        least = fmin(least, law[k].mass);
        area = fmin(area, law[k].area);
    }
    if (!(least > 0)) { // some density is not known: nobody may ask for it
        return 0;
    }
    const double away = fmax(tail(n, centre[0]), tail(n, centre[1]));
    return fmax(tail(n, mass) / least, away / sqrt(area));
}

double along_law_error(const law_along *along, int panel)
{
    return fmax(stiffness_error(along, panel), mass_error(along, panel));
}

double along_turn_error(const law_along *along, int panel)
{
    return tail(along->nnode, along->turn + (size_t)panel * (size_t)along->nnode);
}

double along_miss(const law_along *along, double s, const beam_law *solved, double turn)
{
    mat6 K;
    double centre[2];
    const beam_law exact = beam_law_turn(*solved, -turn);
    law_along_at(along, s, &K, NULL);
    const double stiffness = mat6_relative_error(K, exact.K);
    if (!(exact.mass > 0)) {
        return stiffness;
    }
    const double mass = fabs(law_along_mass(along, s, centre) / exact.mass - 1);
    const double away = hypot(centre[0] - exact.mass_centre[0], centre[1] - exact.mass_centre[1]);
    return fmax(stiffness, fmax(mass, away / sqrt(exact.area)));
}
