// reports/scene.h
// A scene for the page's view in space (reports/view*.js): surfaces, bodies, lines and points in
// layers that are switched on and off, and choices of which only one option is shown. Lengths in m;
// coordinates are kept in 65535 steps of the scene's box.
#pragma once

#include "base/se3.h"
#include "reports/figure_kit.h"
#include "reports/markup.h"

enum { SCENE_LAYERS = 16, SCENE_CHOICES = 3, SCENE_ANY = -1 };

typedef struct scene scene;

typedef struct scene_choice {
    const char *name;
    int noption;
    const char *const *option;
    bool all;  // "all" can be chosen too, and comes first
    int first; // option chosen at first; SCENE_ANY: all
} scene_choice;

// A factor that a slider gives to what moves (scene_moved).
typedef struct scene_factor {
    const char *name; // NULL: there is none
    double most, first;
} scene_factor;

typedef struct scene_spec {
    const char *name;    // what a screen reader says
    double low[3], size; // the box, a cube [m]
    int nlayer;
    const char *const *layer;
    const bool *on; // [nlayer] at first
    int nchoice;
    const scene_choice *choice;
    const char *value_name; // what bodies are coloured by: "clearance, mm"; NULL: nothing
    double value_most;      // end of the ramp, in the unit that value_name names
    bool by_value;          // the first choice is between the bodies' own colours and their values
    scene_factor factor;
} scene_spec;

// The box around places.
typedef struct scene_box {
    double low[3], high[3];
    bool unknown; // one of them is no number
} scene_box;

scene_box scene_box_empty(void);
void scene_box_add(scene_box *b, const double place[3]);
// The scene's cube: about the middle of the box, across `times` its longest side and `more`. [m]
void scene_box_put(const scene_box *b, double times, double more, scene_spec *spec);

// Whether its sizes are numbers, and such as a browser draws. What is not possible is not opened.
bool scene_is_possible(const scene_spec *spec);
status scene_open(const scene_spec *spec, scene **out);
// The page's element: <figure class="view"> with the scene inside.
status scene_close(scene *s, const char *caption, bytes *page);
void scene_free(scene *s); // NULL is nothing

// Where a thing belongs. It is shown where the layer is on and every choice is at this option, or
// at "all"; SCENE_ANY: at any.
typedef struct scene_place {
    int layer, option[SCENE_CHOICES];
} scene_place;

static inline scene_place scene_in(int layer)
{
    return (scene_place){layer, {SCENE_ANY, SCENE_ANY, SCENE_ANY}};
}

// Tubes, lines, points and rods with a place that is no number, and what moves by no number, are
// left out.

// At most 65535 vertices. Seen from within through what faces the eye.
status scene_wall(scene *s, scene_place at, int nvertex, const double (*vertex)[3], int ntriangle,
                  const int (*triangle)[3], colour ink);
// Colours for the last wall's vertices, one of `ink` each, where `at` is shown.
status scene_paint(scene *s, scene_place at, int nvertex, const unsigned char *kind, int nink,
                   const colour *ink);

// A tube; value [npoint]: coloured by it, NULL: in one colour. Less than 0 stands out, what is
// no number is grey.
status scene_tube(scene *s, scene_place at, int npoint, const double (*point)[3],
                  const double *value, double radius, colour ink);
// The same going through poses: point [nframe npoint]; a slider shows one of them.
status scene_motion(scene *s, scene_place at, int nframe, int npoint, const double (*point)[3],
                    double radius, colour ink, const char *name);
status scene_line(scene *s, scene_place at, int npoint, const double (*point)[3], colour ink);
// Balls of different colours, with words beside them (label [npoint], may be NULL).
status scene_points(scene *s, scene_place at, int npoint, const double (*point)[3], double radius,
                    const unsigned char *kind, int nink, const colour *ink,
                    const char *const *label);
// What rods wear from here on: the loops of their section's outline, what lies inside to the left,
// with one ink for each piece of them.
typedef struct scene_outline {
    int nloop;
    const int *loop;          // [nloop] points of each
    const double (*point)[2]; // of one loop after the other [m]
    const unsigned char *ink; // [points] of the piece from there to the loop's next point
    int nink;
    const colour *colour;
} scene_outline;
// turn [npoint]: of the outline at the points of every rod [rad].
status scene_skin(scene *s, const scene_outline *outline, int npoint, const double *turn);
// A rod in the last skin; strain [npoint]: at the origin, and its slopes in x and y [value, value
// per m]; what is drawn is its size. Grey where one of them is no number.
status scene_rod(scene *s, scene_place at, int npoint, const pose *shape, const double (*strain)[3],
                 const char *name);

// A body at rest; ink [nvertex]. At most 65535 vertices.
status scene_solid(scene *s, scene_place at, int nvertex, const double (*vertex)[3], int ntriangle,
                   const int (*triangle)[3], const unsigned char *ink, int nink,
                   const colour *colour);
// The last solid moved by the view's factor times `move`, coloured by value [nvertex]. It is seen
// where this place is shown.
status scene_moved(scene *s, scene_place at, int nvertex, const double (*move)[3],
                   const double *value, const char *name);

// Words under the view; of those that belong to an option only where it is chosen itself.
status scene_words(scene *s, scene_place at, const char *words);
// A line of the key: what a colour means; `layer` must be on.
status scene_key(scene *s, int layer, colour ink, const char *words);
