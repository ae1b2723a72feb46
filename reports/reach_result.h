// reports/reach_result.h
// Which targets the scopes reach, for tables, files, pictures and the page. Lengths in m, places in
// the world.
#pragma once

#include "base/se3.h"
#include "base/status.h"
#include "reach/scope.h"

#include <stdbool.h>

enum { REACH_NAME = 64, REACH_TEXT = 160 };

// of a way in that is shown: so many poses at most, each a body of so many points
enum { REACH_WAY_STEPS = 32, REACH_WAY_POINTS = 33 };

// verdicts; the first four are those of a search (reach/search.h)
typedef enum reach_verdict {
    REACH_REACHED,
    REACH_OUT_OF_REACH,
    REACH_JOINT_LIMIT,
    REACH_COLLISION,
    REACH_NO_WAY, // there is a pose, but no way in was found to it that touches nothing
    REACH_FAILED, // the scope's equation has no answer there: `why`
} reach_verdict;

// One scope at one target.
typedef struct reach_answer {
    int verdict;
    double q[SCOPE_JOINTS]; // of the pose that is shown: insertion [m], turn [rad], tensions [N] or
                            // the bend [rad]
    double miss;            // of the tip from the target [m]
    double clearance, s; // least along the body, and where (s < 0: on the shaft) [m]; NAN: too far
    double bound;        // no pose that is near has more; INFINITY: not known
    int joint;           // whose limit keeps it away; -1
    int looks, starts;   // how thorough the search was
    double strain;       // largest of a material in that pose [-]; NAN: none told
    double path_clearance;        // least on the way in [m]; NAN: not asked for, or no pose
    int npath;                    // poses of the way in, 0: none
    double (*path)[SCOPE_JOINTS]; // [npath]
    int nway; // bodies along the path that are shown, spread over it, the first and last among
              // them
    double (*way)[REACH_WAY_POINTS][3]; // [nway] each at equal steps from the entry to the tip
    int npoint;                         // of the body in that pose, from the entry to the tip
    double *along;                      // [npoint] s [m]
    double (*point)[3];                 // [npoint]
    double *room;                       // [npoint] clearance there [m]
    char why[REACH_TEXT];               // the reason in words, "" where it is reached
} reach_answer;

// A sample of the tissue's surface in the reach map.
typedef enum reach_map_state { MAP_NOT_REACHED, MAP_REACHED, MAP_UNDECIDED } reach_map_state;

typedef struct reach_scope_result {
    char name[REACH_NAME], kind[REACH_NAME]; // "constant curvature", "rod, full K, 1 tendon"
    double length, radius;
    bool arc; // of constant curvature: its third joint is the bend [rad], not a tension
    int njoint;
    double low[SCOPE_JOINTS], high[SCOPE_JOINTS]; // joint limits as used
    char limit_note[REACH_TEXT];                  // "tension limited by the strain of soft"; ""
    double spacing;                               // between nodes of the inverse's map [m]
    int nreached;
    int *state;          // [nmap] reach_map_state; NULL: no map
    double area_reached; // shares of the tissue's area
    double area_undecided;
    double area_error;    // standard error of the shares, by the number of samples
    double map_spacing;   // between tips of the map's poses [m]
    double seconds;       // CPU
    reach_answer *answer; // [ntarget]
} reach_scope_result;

// What a search for a better design found.
typedef struct reach_design_row {
    double *value; // [nparameter]
    double goal;   // targets reached, or share of the area
    double score;  // what was maximised: the goal, and how near the rest is
    int island, evaluation;
} reach_design_row;

typedef struct reach_design_result {
    bool there;
    char scope[REACH_NAME];
    int goal; // design_goal
    int nparameter;
    char (*name)[REACH_NAME]; // [nparameter]
    char (*unit)[REACH_NAME];
    double *lower, *upper, *start; // [nparameter]
    int nrow;
    reach_design_row *row;          // [nrow] each island's improvements, in its order
    int best;                       // row
    double start_goal, start_score; // of the case as it stands
    int evaluations, failed;
    int islands, seed;
} reach_design_result;

typedef struct reach_result {
    bool there;
    bool synthetic;
    char source[REACH_TEXT], tissue[REACH_TEXT]; // of the anatomy, and its file's name
    int nvertex, ntriangle;
    double (*vertex)[3];
    int (*triangle)[3];
    double area, volume; // of the tissue's wall
    pose entry;          // z along the line
    double entry_free;   // of the line, from the entry on, where the shaft is not looked at
    double tolerance, clearance;
    double resolution; // boxes of joints in which the body moves by less were not divided [m]
    int tip, path;     // reach_tip, reach_path
    int paper;         // reach_paper: whose counts stand beside
    int ntarget;
    char (*target_name)[REACH_NAME];
    double (*target)[3];
    double *target_depth; // [ntarget] from the wall, positive inside [m]
    int nmap, map_seed;
    double (*map_point)[3]; // [nmap]
    int nscope;
    reach_scope_result *scope;
    reach_design_result design;
} reach_result;

// Room for all of these by the counts in `sizes` (nvertex ... nscope, and where design.there its
// counts), zeroed; of answers' bodies nothing yet. out->there is set.
status reach_result_make(const reach_result *sizes, reach_result *out);
// The same for the design alone, where a search is told of later.
status reach_design_make(int nparameter, int nrow, reach_design_result *out);
status reach_answer_room(reach_answer *a, int npoint, int npath);
status reach_answer_way(reach_answer *a, int nway);
void reach_result_free(reach_result *r);
void reach_design_free(reach_design_result *d);

const char *reach_verdict_words(int verdict); // "reached", "out of reach", ...

// The paper's counts (Table IV, another anatomy), printed beside ours as the paper's.
enum { PAPER_REACH_TARGETS = 20, PAPER_REACH_CONSTANT_CURVATURE = 14, PAPER_REACH_HELICAL = 18 };
