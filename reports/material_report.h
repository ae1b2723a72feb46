// reports/material_report.h
// What tensile tests gave, for people and for programs.
#pragma once

#include "io/json.h"
#include "measure/material_test.h"

#include <stdio.h>

void material_print(const material_result *r, FILE *stream);
status material_json(json *j, const material_result *r);

// DIR/material.yaml (a block for a case), material.csv, material.json, material.svg, .pdf and .png.
status material_files(const char *directory, const void *result); // a material_result
status figure_material(const material_result *r, const char *directory);
