// reports/figure_reach_kit.c
#include "reports/figure_reach.h"

#include <math.h>
#include <stdio.h>

camera reach_camera(int view)
{
    static const camera cameras[REACH_VIEWS] = {
        {{{1, 0, 0}}, {{0, 0, 1}}, {{0, -1, 0}}},
        {{{0, 1, 0}}, {{0, 0, 1}}, {{1, 0, 0}}},
        {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}},
    };
    return cameras[view];
}

const char *reach_camera_name(int view)
{
    static const char *const names[REACH_VIEWS] = {"seen along y", "seen against x",
                                                   "seen against z"};
    return names[view];
}

const char *reach_count_words(const reach_result *r, int scope, char words[REACH_TEXT])
{
    (void)snprintf(words, REACH_TEXT, "%d of %d targets reached", r->scope[scope].nreached,
                   r->ntarget);
    return words;
}

void reach_source_line(canvas *c, double x, double y, double width, const run_result *r)
{
    char words[2 * REACH_TEXT + 64];
    (void)snprintf(words, sizeof words, "%s%s%s%s", r->reach.synthetic ? "Synthetic anatomy: " : "",
                   r->reach.tissue, r->reach.source[0] ? "; " : "", r->reach.source);
    say_within(c, x, y, width, LOOK_SMALL, words);
}

void reach_axes(canvas *c, const camera *camera, double x, double y)
{
    static const char *const name[] = {"x", "y", "z"};
    static const double length = 20;
    text_look look = look_aligned(LOOK_TICK, TEXT_CENTRE);
    look.style = TEXT_ITALIC;
    for (int k = 0; k < 3; k++) {
        vec3 unit = {{0}};
        unit.a[k] = 1;
        const vec3 seen = camera_see(camera, unit);
        if (fabs(seen.a[2]) < 0.5) {
            arrow(c, x, y, x + length * seen.a[0], y - length * seen.a[1], INK_SOFT, 1);
            say(c, x + (length + 8) * seen.a[0], y - (length + 8) * seen.a[1] + 3.5, look, "%s",
                name[k]);
        }
    }
}
