// base/law_along.h
// K(s) along a rod: Chebyshev-Lobatto panels of the law in a frame that turns with the pattern of
// the section.
#pragma once

#include "base/beam_law.h"

enum { LAW_ALONG_MAX_NODES = 33 };

typedef struct law_along {
    double length;         // [m]
    int npanel, nnode;     // nnode per panel, 1 (constant) to LAW_ALONG_MAX_NODES
    double *edge;          // [npanel + 1] [m], from 0 to length
    beam_law *law;         // [npanel][nnode], in the frame turned by `turn` at that node
    double *turn;          // [npanel][nnode] angle of the pattern [rad]; 0 where nothing turns
    bool symmetric;        // at every s the pattern's turn is an axis of symmetry, as the shapes
                           // declare it; false where nobody said so
    double relative_error; // of K between the nodes, from the decay of the coefficients; the laws'
                           // own error not included
} law_along;

status law_along_make(double length, int npanel, int nnode,
                      law_along *out); // zeroed, edges equally spaced
void law_along_free(law_along *along);

// Arclength of node i of panel k: edge[k] + (edge[k+1] - edge[k]) (1 - cos(pi i / (nnode - 1))) / 2
double law_along_node(const law_along *along, int panel, int i);

// K about the geometric centre in the unturned body frame and dK/ds; dK may be NULL. s is clipped
// to [0, length]. K_g(s) = R(turn) K(s) R(turn)^T, differentiated as such.
void law_along_at(const law_along *along, double s, mat6 *K, mat6 *dK);

// Mass per length [kg/m] and its centre [m] in the unturned body frame; s is clipped to [0,
// length].
double law_along_mass(const law_along *along, double s, double centre[2]);

// Whether the mass is known everywhere: every material of the rod has a density.
bool law_along_has_mass(const law_along *along);

// The stiffness-centre frame T(s) = (R_z(phi), p_nc) and its derivative along s; phi continuous
// from the first station.
typedef struct centre_frame {
    double p[2], dp[2]; // [m], [-]
    double phi, dphi;   // [rad], [rad/m]
} centre_frame;

// symmetric: phi is the turn itself, dphi the turn's rate, whatever phi_near. Else phi_near chooses
// among the principal axes (differing by pi/2); pass the previous station's phi, or turn(0) first.
// Where the two moments are equal to BEAM_LAW_ISOTROPIC the frame keeps the pattern's turn.
void law_along_centre_frame(const law_along *along, double s, double phi_near, centre_frame *out);
