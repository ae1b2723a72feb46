// reports/figure_section_panel.c
// Beside the section: legend, numbers, and the way of the stiffness centre along the rod.
#include "reports/figure_section.h"

#include <math.h>
#include <stdio.h>

static const double row = 19; // [points]

static void rule(canvas *c, box at, double y)
{
    canvas_segment(c, at.x, y, at.x + at.w, y);
    canvas_stroke(c, INK_GRID, 1);
}

static bool is_used(const mesh *m, int material)
{
    for (int b = 0; b < m->nblock; b++) {
        for (int k = 0; k < m->block[b].nelem; k++) {
            if (m->block[b].material[k] == material) {
                return true;
            }
        }
    }
    return false;
}

// of a directed material E along the rod, of a graded one that at the origin
static void material_numbers(canvas *c, const material *m, double x, double y)
{
    static const char *const kinds[] = {"isotropic", "orthotropic", "anisotropic"};
    const bool graded = m->modulus.across || m->modulus.along;
    const text_look look = look_aligned(LOOK_SMALL, TEXT_RIGHT);
    const number_text E = number_short(m->E * 1e-6, 5);
    if (m->kind == MATERIAL_ISOTROPIC && !graded) {
        say(c, x, y, look, "E = %s MPa,  ν = %s", E.text, number_short(m->nu, 4).text);
    } else {
        say(c, x, y, look, "%s, E = %s MPa", graded ? "graded" : kinds[m->kind], E.text);
    }
}

static double materials(canvas *c, const run_result *r, box at)
{
    double y = at.y + 12;
    int shown = 0, left_off = 0;
    say(c, at.x, y, LOOK_HEADING, "Materials");
    for (int m = 0; m < r->nmaterial; m++) {
        if (!is_used(&r->section_mesh, m)) {
            continue;
        }
        if (shown == 6) {
            left_off++;
            continue;
        }
        y += row;
        shown++;
        canvas_rectangle(c, at.x, y - 10, 20, 12);
        canvas_fill_stroke(c, colour_material(m), INK, 0.9);
        say_within(c, at.x + 30, y, at.w - 200, LOOK_TEXT, r->materials[m].name);
        material_numbers(c, &r->materials[m], at.x + at.w, y);
    }
    if (left_off > 0) {
        y += row;
        say(c, at.x + 30, y, LOOK_SMALL, "and %d more", left_off);
    }
    return y;
}

static void place_row(canvas *c, box at, double y, const char *name, const double place[2])
{
    say(c, at.x + 30, y, LOOK_TEXT, "%s", name);
    say(c, at.x + at.w, y, look_aligned(LOOK_TEXT, TEXT_RIGHT), "(%s, %s) mm",
        number_fixed(place[0] * 1e3, 4).text, number_fixed(place[1] * 1e3, 4).text);
}

static double tendon_row(canvas *c, const section_sketch *s, box at, double y)
{
    const int count = section_tendons(s);
    if (count > 0) {
        y += row + 1;
        mark_tendon(c, at.x + 10, y - 4);
        say(c, at.x + 30, y, LOOK_TEXT, count > 1 ? "tendons" : "tendon");
        say(c, at.x + at.w, y, look_aligned(LOOK_SMALL, TEXT_RIGHT), "%d", count);
    }
    return y;
}

static double kern_and_mass(canvas *c, const section_sketch *s, box at, double y)
{
    if (s->answers && s->answers->mass.known) {
        y += row + 1;
        mark_mass_centre(c, at.x + 10, y - 4);
        place_row(c, at, y, "mass centre", s->answers->mass.mass_centre);
    }
    if (s->answers && s->answers->nkern > 0) {
        y += row + 1;
        canvas_segment(c, at.x, y - 4, at.x + 22, y - 4);
        kern_stroke(c);
        say(c, at.x + 30, y, LOOK_TEXT, "kern: compression here leaves no tension");
    }
    return y;
}

static double places(canvas *c, const section_sketch *s, box at, double y)
{
    const double origin[2] = {0, 0};
    rule(c, at, y + 12);
    y += 32;
    say(c, at.x, y, LOOK_HEADING, "Centres and axes");

    y += row + 1;
    mark_geometric_centre(c, at.x + 10, y - 4);
    place_row(c, at, y, "geometric centre", origin);
    y += row + 1;
    mark_stiffness_centre(c, at.x + 10, y - 4);
    place_row(c, at, y, "stiffness centre", s->centres->stiffness_centre);
    y += row + 1;
    mark_shear_centre(c, at.x + 10, y - 4);
    place_row(c, at, y, "shear centre", s->centres->shear_centre);
    y = kern_and_mass(c, s, at, y);
    y = tendon_row(c, s, at, y);
    y += row + 1;
    if (s->centres->isotropic) {
        say(c, at.x, y, LOOK_SMALL, "No preferred axes: every direction bends alike.");
        return y;
    }
    canvas_dash(c, 7, 3.5);
    canvas_segment(c, at.x, y - 4, at.x + 22, y - 4);
    canvas_stroke(c, INK_ACCENT, 1.3);
    canvas_dash(c, 0, 0);
    say(c, at.x + 30, y, LOOK_TEXT, "principal axes");
    say(c, at.x + at.w, y, look_aligned(LOOK_TEXT, TEXT_RIGHT), "x′ turned by %s°",
        number_fixed(s->centres->principal_angle * 180 / acos(-1.0), 3).text);
    return y;
}

static double numbers(canvas *c, const section_sketch *s, box at, double y)
{
    const beam_law *law = &s->r->section.station[0].law;
    const struct {
        const char *symbol, *below, *meaning, *unit;
        double value;
    } rows[] = {
        {"EA", "", "axial stiffness", "N", s->centres->EA},
        {"EI", "x′", "bending about x′", "N mm²", s->centres->EI[0] * 1e6},
        {"EI", "y′", "bending about y′", "N mm²", s->centres->EI[1] * 1e6},
        {"GJ", "", "torsion", "N mm²", s->centres->GJ * 1e6},
        {"A", "", "area", "mm²", law->area * 1e6},
    };
    text_look symbol = LOOK_TEXT;
    symbol.style = TEXT_ITALIC;
    text_look below = symbol;
    below.size = SMALLEST_LETTERS;

    rule(c, at, y + 12);
    y += 32;
    say(c, at.x, y, LOOK_HEADING, "Stiffness, %s model",
        s->r->section_model == MODEL_CLASSICAL ? "classical" : "full");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        y += row;
        say(c, at.x, y, symbol, "%s", rows[i].symbol);
        say(c, at.x + canvas_text_width(c, &symbol, rows[i].symbol) + 1, y + 3, below, "%s",
            rows[i].below);
        say(c, at.x + 52, y, LOOK_SMALL, "%s", rows[i].meaning);
        say(c, at.x + at.w - 52, y, look_aligned(LOOK_TEXT, TEXT_RIGHT), "%s",
            number_digits(rows[i].value, 7).text);
        say(c, at.x + at.w, y, look_aligned(LOOK_SMALL, TEXT_RIGHT), "%s", rows[i].unit);
    }
    y += row;
    say(c, at.x, y, LOOK_SMALL, "relative error of the 6×6 stiffness, estimated: %s",
        number_digits(law->relative_error, 2).text);
    return y;
}

static void path_plot(canvas *c, const section_sketch *s, box at)
{
    plot p = {.at = at, .x0 = 0, .x1 = s->path[s->npath - 1][0] * 1e3, .y0 = 0, .y1 = 0};
    for (int i = 0; i < s->npath; i++) {
        for (int k = 1; k <= 2; k++) {
            p.y0 = fmin(p.y0, s->path[i][k] * 1e3);
            p.y1 = fmax(p.y1, s->path[i][k] * 1e3);
        }
    }
    range_pad(&p.y0, &p.y1, 0.08, 1e-3);
    plot_frame(c, &p, "arclength s, mm", "position, mm");
    for (int k = 1; k <= 2; k++) {
        const colour ink = k == 1 ? INK_ACCENT : INK_SECOND;
        for (int i = 0; i < s->npath; i++) {
            const double x = plot_x(&p, s->path[i][0] * 1e3), y = plot_y(&p, s->path[i][k] * 1e3);
            if (i == 0) {
                canvas_move(c, x, y);
            } else {
                canvas_line(c, x, y);
            }
        }
        canvas_dash(c, k == 1 ? 0 : 6, k == 1 ? 0 : 3);
        canvas_stroke(c, ink, 2);
        canvas_dash(c, 0, 0);
    }
}

static void path_inset(canvas *c, const section_sketch *s, box at, double y)
{
    rule(c, at, y + 12);
    y += 32;
    say(c, at.x, y, LOOK_HEADING, "Stiffness centre along the rod");
    const double x = at.x + at.w - 78;
    canvas_segment(c, x, y - 4, x + 20, y - 4);
    canvas_stroke(c, INK_ACCENT, 2);
    say(c, x + 24, y, LOOK_SMALL, "x");
    canvas_dash(c, 6, 3);
    canvas_segment(c, x + 42, y - 4, x + 64, y - 4);
    canvas_stroke(c, INK_SECOND, 2);
    canvas_dash(c, 0, 0);
    say(c, x + 69, y, LOOK_SMALL, "y");
    path_plot(c, s, (box){at.x + 50, y + 12, at.w - 60, at.y + at.h - y - 50});
}

void section_panel(canvas *c, const section_sketch *s, box at)
{
    double y = materials(c, s->r, at);
    y = places(c, s, at, y);
    y = numbers(c, s, at, y);
    if (s->npath > 0) {
        path_inset(c, s, at, y);
    }
}
