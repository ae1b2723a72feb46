// measure/scan_parts.h
// Pieces of a scan: is the unit credible, and where the plate is.
#pragma once

#include "measure/scan.h"

// ERR_FILE where the cloud is as large as no body of the length or radius stated can be in any
// picture of it: the unit is another one, which is named.
// unit: in which it was read [m].
status scan_check_unit(const point_cloud *cloud, const char *name, double unit,
                       const scan_settings *settings);

// The plate, its normal towards the body, and from it where the body begins and goes to.
status scan_find_plate(const point_cloud *cloud, const scan_settings *settings, tube_options *o,
                       cloud_plane *out);
double scan_plate_height_sigma(const cloud_plane *plate, vec3 at);

// `st`, an ERR_INPUT with the place of a key.
status scan_fail_at(mark at, status st);
