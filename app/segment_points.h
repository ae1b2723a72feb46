// app/segment_points.h
// Where the loads of the 3D segment act.
#pragma once

#include "app/case.h"

// point [loads.count]: the geometric centre, the case's own point, or the stiffness centre of the
// section at the segment's base, by what costs least: closed forms, integrals, or the section
// analysis where Poisson's ratios differ or a material is not isotropic.
status segment_points(const case_data *c, double (*point)[2]);

// A plane mesh of a section: whether all of it is isotropic and uniform, and has one Poisson's
// ratio.
bool segment_is_isotropic(const material *materials, const mesh *m);
bool segment_has_one_poisson(const material *materials, const mesh *m);

// ERR_INPUT at the first material of the mesh without a density where a load accelerates.
status segment_check_densities(const case_data *c, const mesh *m);
