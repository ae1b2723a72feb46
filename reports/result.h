// reports/result.h
// Everything that a run found, in one place: the way out to JSON, CSV, the store, the figures and
// the page, and the way back in from the store for `report`.
#pragma once

#include "base/law_along.h"
#include "base/material.h"
#include "base/mesh.h"
#include "base/se3.h"
#include "fem/segment.h"
#include "io/csv.h"
#include "io/json.h"
#include "io/store.h"
#include "reports/fit_result.h"
#include "reports/measured_result.h"
#include "reports/reach_result.h"
#include "reports/sensitivity_result.h"
#include "rodsolver/rod.h"
#include "section/answers.h"
#include "section/section.h"
#include "section/strain_along.h"

#include <stdbool.h>

// One comparison: two ways to the same number.
typedef struct compare_row {
    char what[96]; // "section: GJ, ours against GetDP"
    char unit[16];
    double ours, other; // in `unit`
    double difference;  // relative, by the definition that `what` names
    double tolerance;   // relative
    char reason[160];   // what the tolerance is made of
    bool skipped;       // the other way is not on this machine, or does not apply; reason says so
    bool ok;
} compare_row;

// An assumption about the section, held against the 3D segment: what a straight rod of such
// sections misses. Differences are relative to the 3D value's sqrt(C_ii C_jj).
enum { MODEL_CHECKS = 3 };
typedef struct model_check {
    char name[48];    // "full, knows its turning"
    char why[160];    // no such law; "" where there is one
    mat6 compliance;  // of the tip, as segment.tip_compliance
    double error;     // the largest of all entries
    int row, column;  // where
    double law_error; // the same of `law_difference`, over stretch, bending and twist; NAN: unknown
    int law_row, law_column;
} model_check;

typedef struct model_checks {
    bool there;
    char why_no_second[160]; // why no second length tells the ends from the law; "" where one does
    double lengths[2];       // of the segment, and the second one; 0: none [m]
    mat6 compliance;         // 3D, of the first
    mat6 law_difference; // 3D: (C(second) - C(first)) / (second - first), which no end enters; the
                         // entries of n_x and n_y, which ends do enter, are NAN
    model_check model[MODEL_CHECKS];
} model_checks;

enum { RESULT_MAX_TENDONS = 256, RESULT_MAX_LOADS = 256, RESULT_NAME = 64 };

// How the tip moves with what acts on the rod: columns are body twists of the tip (linear part
// first).
typedef struct rod_rates {
    vec6 *tension, *pull; // [ntendon] by tension [.. per N], by pulled length [.. per m]; 0 where
                          // the other of the two was given
    vec6 *load;           // [nload] by the loads' factors
    mat6 space, body;     // by wrenches on the tip, fixed in space or turning with it
} rod_rates;

// What a load does at factor 1 and where, for pictures.
enum { LOAD_PLACES = 13 };
typedef enum load_kind { LOAD_AT_POINT, LOAD_ALONG_LINE, LOAD_GRAVITY } load_kind;
typedef struct rod_load_sketch {
    int kind, frame;                              // load_kind, load_frame
    double from, to;                              // arclengths [m]; the same of a point
    vec3 force[LOAD_PLACES], moment[LOAD_PLACES]; // at equal steps from one to the other [N/m, N];
                                                  // a point's [N, N m] are all the same
    double place[LOAD_PLACES][2];                 // x, y in the section where the force acts [m]
    vec3 acceleration;                            // of gravity [m/s^2], which has no force here
} rod_load_sketch;

typedef struct rod_result {
    int ntendon, npoint;
    int nload;                        // point loads, line loads, then gravity where there is any
    char (*tendon_name)[RESULT_NAME]; // [ntendon]
    double (*tendon_base)[2];         // [ntendon] where each starts: x, y at s = 0 [m]
    double *tendon_end;               // [ntendon] arclength where each is anchored [m]
    double (*tendon_path)[2];         // [ntendon][npoint] x, y in the section [m]; past the end: as
                                      // there
    char (*load_name)[RESULT_NAME];   // [nload]
    rod_load_sketch *load_sketch;     // [nload]
    pose *rest;                       // [npoint] the shape without tension or load, in the world
    bool has_rates;
    int nsolution;
    struct rod_run {
        double *tension; // [ntendon] at the base, given or found [N]; 0: slack
        double *pull;    // [ntendon] length drawn out of the base [m]; NAN where the tension was
                         // given instead
        double *tendon_length; // [ntendon] inside the body [m]
        double *load;          // [nload] factors of the loads
        pose tip;
        double total_bend_rad; // angle between base and tip tangent, followed continuously along
                               // the rod
        int iterations;
        double relative_error;
        double fraction;   // of loads and tensions that was reached: below 1 at a limit point, and
                           // all else belongs to the shape there
        int stable;        // 1, 0, or -1: not known
        double eigenvalue; // smallest of the second variation over the elastic energy's; NAN: none
        int ncritical;     // limit points and bifurcations on the way from the start
        rod_critical critical[ROD_MAX_CRITICAL];
        double energy, work; // stored in the strains, and done by what acts [J]; NAN: no potential
        double residual;     // of the balance at the stations, over the largest strain
        double largest_strain;        // principal, over all materials and the whole rod [-]
        section_strain_place *strain; // [nmaterial] the same for each; NULL: not known
        rod_rates rates;              // where has_rates
        double *s;                    // [npoint] [m]
        pose *shape;                  // [npoint] of the geometric centreline, in the world
        double (*curvature)[3];       // [npoint] body components of w (kx, ky, twist) [1/m]
        double (*stretch)[3];         // [npoint] v - e_z: shear x, shear y, elongation [-]
        vec6 *wrench;                 // [npoint] of the section alone: force [N], moment [N m]
        double *along;                // [npoint][ntendon] tension there [N]; 0 past its end
    } * run;                          // [nsolution]
} rod_result;

// Room for everything but the materials' strains, zeroed; out->nsolution is set. The counts and
// has_rates of `sizes` are looked at, nothing else. rod_run_room: for the shape of one solution.
status rod_result_make(const rod_result *sizes, rod_result *out);
status rod_run_room(const rod_result *rod, struct rod_run *run);

// |energy - work| over the larger of the two; NAN where there is no potential.
double result_energy_misfit(const struct rod_run *run);

// Whether the tendon's length was given and it hangs loose.
bool result_is_slack(const struct rod_run *run, int tendon);

typedef struct run_result {
    char title[160];
    char *case_text; // as read
    size_t case_length;
    char versions[512]; // one line per library that was used

    int nmaterial;
    material *materials; // names owned by the result

    bool has_section, has_rod, has_segment, has_compare;
    section_result section;
    int nanswer;
    section_answers *answer; // of the stations asked for, else of the first; in their order
    int npoint;
    double (*point)[2]; // about which K is asked for too [m]
    int section_model;
    mesh section_mesh; // at the first station; nnode 0 where none was made
    double symmetry_turn;

    double rod_length; // [m]
    rod_result rod;

    double segment_length, segment_section_at; // [m]
    int segment_base, segment_tip;
    segment_result segment; // fields kept

    bool has_measured;
    measured_result measured;

    int ncompare;
    compare_row *compare;
    model_checks models;

    bool has_sensitivity;
    sensitivity_result sensitivity;
    fit_result fit;
    reach_result reach;  // where reach.there
    char *fitted_case;   // with the fitted values put in, NUL at its end; not in the store
    char *designed_case; // the same with the design that was found

    char **load_name; // [segment.nload], owned, where a store was read; NULL where the case owns
                      // the loads' names
} run_result;

void run_result_free(run_result *r);

// The largest of the materials' strains in a solution, each over its material's linear strain, and
// whose it is; NAN and -1 where none is told.
double result_strain_share(const run_result *r, const struct rod_run *run, int *whose);
// The material that a solution of the rod strains furthest past its linear strain, over that
// strain; -1: none, or none is told.
int result_beyond_linear(const run_result *r, const struct rod_run *run);
// What belongs to a station beyond its law; NULL where it was not asked for.
const section_answers *result_answers(const run_result *r, int station);

// reports/result_json.c, json_rod.c: the documents of the contract ("stiffaxis/section/1" ...).
// run: {"schema": "stiffaxis/run/1", "section":
// {...}, "rod": {...}, "fem": {...}, "compare": {...}} with the parts that are there.
status result_json_section(json *j, const char *key, const run_result *r);
status result_json_rod(json *j, const char *key, const run_result *r);
status result_json_segment(json *j, const char *key, const run_result *r);
status result_json_compare(json *j, const char *key, const run_result *r);
status result_json_sensitivity(json *j, const char *key, const run_result *r);
status result_json_fit(json *j, const char *key, const run_result *r); // reports/json_fit.c
status result_json_reach(json *j, const char *key,
                         const run_result *r); // reports/json_reach.c
status result_json_run(json *j, const run_result *r);

// reports/json_measured.c, "measured": errors against measured shapes; inside the comparison's
// document.
void result_json_measured(json *j, const char *key, const run_result *r);

// "models": what assumptions about the section cost; inside the comparison's document.
void result_json_models(json *j, const char *key, const model_checks *m);

// reports/result_csv.c: sections.csv, rods.csv (tips), shapes.csv, segment.csv, compare.csv and
// models.csv into the directory `dir`.
status result_csv(const run_result *r, const char *dir);

// reports/result_store.c: one HDF5 file (io/store.h) with everything above, and at /VTKHDF the
// section's mesh (part 0) and one deformed segment per load, with the point field displacement_m.
// Reading recomputes nothing. Every count, index and choice of a file is checked: ERR_FILE where it
// is damaged or not ours.
//
// Where ranks share the segment's levels out (segment.body.shared) all of them call the writing
// one, the first with the path; without one of its own it gives NULL, and nobody writes.
status result_store_write(const run_result *r, const char *path);
status result_store_read(const char *path, run_result *out);

// Only the sections that a result holds solved: reports/store_known.c
status result_known_read(const char *path, section_known *out);
