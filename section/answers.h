// section/answers.h
// Everything else that a user asks of a section: what its 6x6 tells beyond its centres, what needs
// its area, its warping, and stresses under wrenches. docs/theory.md (3.20)-(3.27)
#pragma once

#include "section/extremes.h"
#include "section/mass.h"

// What follows from the law alone.
typedef struct section_axes {
    mat6 K_principal; // about the stiffness centre, in principal axes; K itself is about the origin
    double shear_stiffness[2]; // along the principal shear axes x'', y'' [N]
    double shear_angle;        // of x'' from x, x'' the one nearest to x' [rad]
} section_axes;

// ERR_NUMERIC where K is not positive definite.
status section_axes_of(const beam_law *law, const beam_centres *centres, section_axes *out);

// EI_omega = int E omega^2 [N m^4], omega the torsion's warping per twist without mean and linear
// parts. (3.25)
status section_warping_constant(const mesh *m, const material *materials,
                                const section_warping *warping, double *out);

// One of the case's wrenches and what it does at one station.
typedef struct section_load_answer {
    char name[64];
    double at[2];              // where the force acts [m]
    double force[3];           // [N]
    double moment[3];          // about that place [N m]
    section_extremes *extreme; // [nmaterial]
    double (*strain)[6];       // [nodes.nnode] xx yy zz yz xz xy; NULL where no field is kept
    double (*stress)[6];       // [Pa]
} section_load_answer;

typedef struct section_answers {
    int station; // index of the result's station that they belong to
    section_mass mass;
    double EI_warping; // [N m^4]; NaN: the classical model has none
    int nkern;         // 0: there is none
    double (*kern)[2]; // [nkern] [m]
    int nload;         // the case's wrenches
    section_load_answer *load;
    mesh nodes; // the section's, its nodes apart where materials meet: the fields' own. nnode 0
                // where no fields are kept
} section_answers;

typedef struct section_question {
    const section_case *request;
    const material *materials;
    bool fields; // keep strains and stresses at the nodes
} section_question;

// One more solve at the station in the full model, on the mesh of the station's law.
status section_answer(const section_question *q, const section_station *station, int index,
                      section_answers *out);
void section_answers_free(section_answers *a);

// The force and moment of one wrench about the origin.
vec6 section_wrench_at_origin(const double *at, const double *force, const double *moment);
