// app/reach_run.h
// One scope at all targets of a scene.
#pragma once

#include "app/command.h"
#include "app/reach_scopes.h"

typedef struct reach_study {
    const case_data *c;
    const reach_scene *scene;
    const command *cmd;     // for progress; NULL: none
    int workers;            // as team_options has it
    bool bodies;            // samples of the body for pictures, and strains of poses
    int nmap;               // places of the reach map; 0: none
    const double (*map)[3]; // [nmap]
    int map_looks;          // at most, and no finer than map_resolution [m]; 0: the usual ones
    double map_resolution;
} reach_study;

// points of a body that is shown, from the entry to the tip
enum { REACH_BODY_POINTS = 61 };

// Fills `out`, whose answers have room [ntarget], and states [nmap]. The answers do not depend on
// the workers.
status reach_study_scope(const reach_study *how, reach_scope *s, reach_scope_result *out);

// The maps of n scopes, each on one core: states [nmap] of `out` and what is told of them; CPU time
// is added to what is there. A failure comes with its scope's place.
status reach_study_maps(const reach_study *how, int n, reach_scope *scopes,
                        reach_scope_result *out);

// How finely joints are looked at for a tip's tolerance [m].
double reach_resolution(double tolerance);
