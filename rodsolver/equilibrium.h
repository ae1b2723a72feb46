// rodsolver/equilibrium.h
// The rod under loads, pulled tendons or friction: a two-point problem, docs/theory.md (4.11) on.
//
// Unknown are the strains xi at the stations (three Gauss stages per panel) and the tensions of
// tendons whose pull is given. Everything "in the base frame" is seen from the solve's frame at
// s = 0; a plan's panels are numbered from the base, panel k ends at its right node k + 1.
#pragma once

#include "rodsolver/panel_matrix.h"
#include "rodsolver/rod_plan.h"

// What is asked for, all of it scaled by one factor on the way.
typedef struct demand {
    double *tension; // [ntendon] at the base [N]
    double *pull;    // [ntendon] [m]; NAN: the tension is given
    double *load;    // [nload] factors
    vec6 tip_space, tip_body;
    mat3 to_base; // turns directions of the world into the base frame
} demand;

// Loads that act at one place, or per length, added up. Dead forces keep their directions in the
// base frame, wherever in the section they act: dyad = sum of place (in the body) times force^T.
typedef struct load_sum {
    vec3 dead, dead_moment, follower, follower_moment;
    mat3 dyad;
} load_sum;

typedef struct station_state {
    mat3 R;      // the section's axes in the base frame
    vec3 slope;  // p' = R v
    vec3 N, M;   // wrench of the loads beyond, about the section's centre, base frame
    vec3 rv, rw; // misfit of the local balance, base frame
} station_state;

// Linearised: nu = E (n - rv) - B omega and the blocks of (4.17), base frame
typedef struct station_tangent {
    mat3 E, B, D;
    mat3 wp, pw, pp;
} station_tangent;

typedef struct panel_factor {
    double A[PANEL_UNKNOWNS][PANEL_UNKNOWNS]; // L D L^T, or L U with rows exchanged
    int exchange[PANEL_UNKNOWNS];
    double response[PANEL_UNKNOWNS][3]; // omega by the rotation at the panel's left node
    mat3 S, SN; // at the right node: dM = S phi + c, dN = SN phi + cN of what lies beyond
} panel_factor;

// room for answers that tensions follow by friction
enum { FRICTION_VECTORS = 30 };
typedef struct follow_room {
    vec3 *v, *w;            // [nstation] the right-hand side ...
    double *given, *change; // [ntendon] ... and its lengths
    vec6 *x;                // [nstation]
    vec6 *basis;            // [FRICTION_VECTORS + 1][room]
} follow_room;

struct equilibrium {
    const rod *rod;
    const plan *plan;      // at hand
    int room;              // stations that the arrays hold
    bool conservative;     // dead forces, follower wrenches none, no friction
    bool lines, followers; // any line loads; any line loads that follow

    demand from, to; // of the way at hand
    double factor;   // along it
    bool *pulled;    // [ntendon] by `to`
    bool *slack;     // [ntendon] among those

    vec6 *xi;                 // [nstation]
    double *tension;          // [ntendon] at the base
    double *decay;            // [ntendon][room] tension there over the one at the base
    bool friction, bent_back; // bent_back: a path with friction turns another way within a panel
    follow_room follow;       // where any tendon has friction
    bool lost;                // a derivative with friction

    load_sum *line, *line_from, *line_to; // [nstation] at `factor`, and at both ends of the way
    load_sum *node, *node_from, *node_to; // [npanel + 1]
    load_sum *line_difference, *node_difference; // to - from
    mat3 *node_R;                                // [npanel + 1]
    vec3 *node_p;                                // [npanel + 1]
    station_state *state;                        // [nstation]
    station_tangent *tangent;                    // [nstation]
    panel_factor *panel;                         // [npanel]
    double shift;    // the tangent counts K by 1 + shift, for eigenvalues
    int negative;    // negative directions of the second variation at the last factorization
    int determinant; // sign of the tangent's determinant there ...
    double determinant_size; // ... and its size over that without loads: this times 2^exponent
    int determinant_exponent;

    // a linear answer: rotations and strains, base frame
    vec3 *phi;                 // [npanel + 1] at the nodes
    vec3 *omega;               // [nstation]
    vec3 *nu;                  // [nstation]
    vec3 *rv, *rw;             // [nstation] right-hand sides
    vec3 *node_N, *node_M;     // [npanel + 1] wrench just before the node
    vec3 *answer_N, *answer_M; // [npair] of the last answer at the pairs' right ends
    vec3 *load_rate;           // [nstation] minus dN / d factor at the last point of the way
    vec3 *beyond;              // [npanel] forces that turn beyond a panel
    vec3 *kept_v, *kept_w, *arc_v, *arc_w; // [nstation] right-hand sides kept
    vec6 *step, *slope, *old, *scratch; // [nstation] body strains: Newton's step, d xi / d factor,
                                        // the last point of the way
    vec6 *direction, *arc_step;         // [nstation] of an arclength step
    double *tension_step, *tension_slope, *tension_old, *tension_direction,
        *arc_tension; // [ntendon]

    double *rest_length;       // [ntendon] inside the body at rest [m]
    double *length;            // [ntendon]
    double *length_by_tension; // [ntendon][ntendon]
    int iterations;
};

status equilibrium_make(const rod *r, equilibrium **out);
void equilibrium_free(equilibrium *e);

// Of an answer to tensions alone: where a warm solve or a derivative starts.
void equilibrium_remember(rod_state *state);

// The state's last answer on its own plan: ERR_BUG before one, ERR_NUMERIC at a limit point;
// linearised, ERR_NUMERIC at a critical point; both.
status equilibrium_recall(rod_state *state);
status equilibrium_linearize(equilibrium *e);
status equilibrium_resume(rod_state *state);
// Another plan; e->xi must be strains at its stations.
void equilibrium_use_plan(equilibrium *e, const plan *p);
void equilibrium_start_at_rest(equilibrium *e, const plan *p);

// The smallest eigenvalue and the work of the last answer, into out.
void equilibrium_judge(rod_state *state, rod_solution *out);

// rod_solve where more acts than tensions.
status equilibrium_solve(rod_state *state, const rod_request *request, rod_solution *out);

// Tension at the stations of the answer's plan over the one at the base; NULL without friction.
const double *equilibrium_decay(const equilibrium *e, int tendon);

// --- equilibrium_demand.c

void demand_of(const rod_state *state, const rod_request *q, demand *d);
// Which kinds of load and tendon e->from and e->to have.
void demand_classify(equilibrium *e);

// --- equilibrium_refine.c

// Newton's share of the tolerance.
double refine_newton_tolerance(const equilibrium *e);
// The tip's place in the base frame by the present strains.
vec3 refine_tip(equilibrium *e);
// The strains at the stations of another plan, which becomes the one at hand.
void equilibrium_transfer(equilibrium *e, const plan *to);
int refine_level_of(const rod *r, const plan *p);
// The coarsest plan beyond `level` with at least this many times its panels.
int refine_level_beyond(const rod *r, int level, double times);
// REFINED: an answer within the tolerance, from the way's end on a coarse plan. ROUGH_FAILED: the
// coarse plan was too coarse; ROUGH_LEFT: the finest plan is.
enum { REFINED, ROUGH_FAILED, ROUGH_LEFT };
int refine_finish(equilibrium *e, double *error);

// --- equilibrium_state.c

// e->from's answer, kept in the state, as the start.
void equilibrium_load_answer(equilibrium *e, const rod_state *state);
void equilibrium_store_answer(equilibrium *e, rod_state *state);
void equilibrium_tell(equilibrium *e, const rod_state *state, double error, rod_solution *out);

// --- equilibrium_between.c

// Keeps the wrenches at the pairs' ends for equilibrium_wrench_at; after balance_wrenches.
void equilibrium_keep_wrenches(equilibrium *e);
// The wrench of all loads beyond s, about the geometric centre in its body frame, by statics from
// the last answer: as accurate as the poses.
vec6 equilibrium_wrench_at(const rod_state *state, double s);

// --- equilibrium_loads.c

void demand_copy(const rod *r, const demand *from, demand *to);
void demand_nothing(const rod *r, const demand *like, demand *d);
// Sums of one demand's loads, into e->line_difference and e->node_difference.
void loads_of(equilibrium *e, const demand *d);
// Sums of the loads at both ends of the way, on e->plan.
void loads_prepare(equilibrium *e);
// ... and at e->factor.
void loads_at_factor(equilibrium *e);

// --- equilibrium_balance.c

static inline double panel_length(const plan *p, int panel)
{
    const double *edge = &p->pair_edge[2 * (panel / 2)];
    return (edge[1] - edge[0]) / 2;
}

// Poses from the strains.
void balance_poses(equilibrium *e);
// N and M at the stations from the poses, by the sums given.
void balance_wrenches(equilibrium *e, const load_sum *line, const load_sum *node);
// Adds one load's force and moment on a section with axes R.
void balance_add_load(const load_sum *l, const mat3 *R, vec3 *force, vec3 *moment);
// Misfits at the stations; with their tangents. false where a tendon is eaten up or the local
// stiffness is not positive definite.
bool balance_stations(equilibrium *e, bool tangents);
// The strains' energy [J] and the misfit of the balance as a strain, over the largest strain.
void balance_check(equilibrium *e, double *energy, double *residual);
// Whether a tendon has all but eaten its own length, and where.
bool balance_finds_pressed(const equilibrium *e, int *station);
bool balance_finds_eaten(const equilibrium *e, int *tendon, int *station);
// The tendons' lengths.
void balance_lengths(equilibrium *e, double *length);
// Wrench (t, r x t) of a unit tension of this tendon at this station, body frame.
vec6 balance_tendon(const equilibrium *e, int tendon, int station);
// --- equilibrium_friction.c, equilibrium_follow.c

// Tension along tendons with friction: e->decay from the present shape.
void balance_friction(equilibrium *e);
// Length at rest times tension over the one at the base, integrated: what stretches [m].
double friction_stretched_length(const equilibrium *e, int tendon);
// Any tendon with friction pulls.
bool friction_follows(const equilibrium *e);
// Adds what friction takes from tensions when the strains change by `step` to e->rv, e->rw, and
// what their stretch thereby takes to the lengths' change [ntendon].
void friction_misfits(equilibrium *e, const vec6 *step, double *change);
// pull_solve with tensions that follow the answer by friction; false where that is not found to the
// relative tolerance.
bool friction_solve(equilibrium *e, double tolerance, double *change, vec6 *strain);

// --- equilibrium_sweep.c

// log of the determinant's size at the last factorization.
double sweep_log_determinant(const equilibrium *e);
// Factors the tangent panel by panel from the tip, e->negative and e->determinant; false where it
// is singular.
bool sweep_factor(equilibrium *e);
// The factored 9x9 problem of one panel, in place.
void sweep_solve_panel(const equilibrium *e, int panel, double *b);

// --- equilibrium_answer.c

// -A^-1 r for the misfits rv, rw [nstation], base frame: e->phi, e->omega, e->nu, and the strains
// in the body frame [nstation].
void sweep_solve(equilibrium *e, const vec3 *rv, const vec3 *rw, vec6 *strain);

// --- equilibrium_pull.c: tensions of pulled tendons as unknowns

bool pull_any(const equilibrium *e);     // any tendon is pulled
bool pull_unknown(const equilibrium *e); // any of them is not slack
// Elongation of the whole tendon per tension at the base [m/N].
double pull_compliance(const equilibrium *e, int tendon);
// What the tendon is too long inside the body: positive pulls [m].
double pull_excess(const equilibrium *e, int tendon);
// Adds c times the misfit that a unit tension makes to e->rv, e->rw.
void pull_misfit(equilibrium *e, int tendon, double c);
// -A^-1 times that misfit; and how much longer the tendon gets by strains that change.
void pull_answer(equilibrium *e, int tendon, vec6 *strain);
double pull_length_change(const equilibrium *e, int tendon, const vec6 *strain);
// Factors what lengths do by tensions; corrects e->negative and e->determinant.
void pull_factor(equilibrium *e);
// As sweep_solve on e->rv, e->rw, tendons not slack getting longer by change[ntendon] besides what
// their own stretch takes; on return the tensions' changes.
void pull_solve(equilibrium *e, double *change, vec6 *strain);
// Tendons that would push go slack, slack ones too long inside pull; whether any changed.
bool pull_update_slack(equilibrium *e);

// --- equilibrium_newton.c

// integral of |nu| / L + |omega|: no point moves by more, over the length
double newton_size(const equilibrium *e, const vec6 *strain);
enum { CORRECTIONS = 12 };

// Everything at e->xi, e->tension and e->factor up to the factorization.
bool newton_linearize(equilibrium *e);
// An equilibrium at e->factor from e->xi. moved: size of the whole correction; most: steps.
bool newton_correct(equilibrium *e, double tolerance, int most, double *moved);
// e->step, e->tension_step: Newton's step, after newton_linearize.
void newton_step(equilibrium *e);
void newton_advance(equilibrium *e, double share, const vec6 *step, const double *tension_step);
// The largest share of e->step that no tendon and no rotation takes amiss.
double newton_longest_share(const equilibrium *e);
// e->slope, e->tension_slope: d xi, d tension / d factor, with the present factorization.
void newton_slope(equilibrium *e);
// e->rv, e->rw: the misfits of the loads in e->line_difference and e->node_difference.
void newton_sum_misfits(equilibrium *e);
// e->rv, e->rw: the misfits' derivative by the factor at the present shape.
void newton_load_misfits(equilibrium *e);

// --- equilibrium_energy.c

// The smallest eigenvalue of the second variation over the elastic energy's at the present
// equilibrium; NAN where it has no potential or cannot be found.
double energy_eigenvalue(equilibrium *e);
// What dead loads and tendons do on the way from rest to e->to, by integrals over equilibria on the
// way on e->plan [J]; NAN where there is no potential or no such way. Changes e->xi.
double energy_work(equilibrium *e);

// --- equilibrium_path.c, equilibrium_critical.c

enum { PATH_ARRIVED, PATH_LIMIT, PATH_LOST };

typedef struct path {
    bool past;                 // follow past limit points
    double factor;             // reached
    int negative, determinant; // at the last point
    int ncritical;
    rod_critical critical[ROD_MAX_CRITICAL];
    double log_determinant;      // of its size
    double earlier, earlier_log; // factor and determinant of the point before
    int most;                    // Newton steps, beyond which the way is given up
} path;

// From the equilibrium e->xi at factor 0 to factor 1 on e->plan.
int path_follow(equilibrium *e, path *way, double tolerance);
