// reports/page_section_over.c
// The section's picture with its values where one points, taps or tabs to: materials, centres,
// axes. Elements of SVG over the drawing; the browser shows what they say, without a script.
#include "reports/figure_section.h"
#include "reports/page_kit.h"
#include "reports/plane_edges.h"

#include <math.h>
#include <stdio.h>

typedef struct over {
    const section_sketch *s;
    sketch_frame frame;
    box at;
    bytes *out;
} over;

static double paper_x(const over *o, double x)
{
    return o->frame.x0 + o->frame.scale * x;
}

static double paper_y(const over *o, double y)
{
    return o->frame.y0 - o->frame.scale * y;
}

static bool is_on_paper(const over *o, const double at[2])
{
    return isfinite(paper_x(o, at[0])) && isfinite(paper_y(o, at[1]));
}

static bool mesh_is_on_paper(const over *o)
{
    const mesh *m = &o->s->r->section_mesh;
    bool all = true;
    for (int i = 0; all && i < m->nnode; i++) {
        all = is_on_paper(o, m->xyz + 3 * (size_t)i);
    }
    return all;
}

// words go with every part: for a pointer, for a screen reader, and under the drawing
static status open_part(over *o, const char *words)
{
    status st = OK;
    bytes *page = o->out;
    PAGE("<g class=\"over\" tabindex=\"0\" role=\"img\" aria-label=\"");
    TRY(page_escaped(page, words));
    PAGE("\"><title>");
    TRY(page_escaped(page, words));
    PAGE("</title><text x=\"28\" y=\"%.0f\">", o->at.y + o->at.h + 14);
    TRY(page_escaped(page, words));
    PAGE("</text>");

done:
    return st;
}

static status put_loop(over *o, const plane_edges *e, const plane_loops *l, int loop)
{
    status st = OK;
    bytes *page = o->out;
    const int cuts = e->line.order == 1 ? 1 : 4;
    for (int k = l->start[loop]; k < l->start[loop + 1]; k++) {
        for (int i = 0; i < cuts; i++) {
            double p[2];
            plane_edge_point(e, &e->edge[l->order[k]], 2.0 * i / cuts - 1, p);
            PAGE("%s%.1f %.1f", k == l->start[loop] && i == 0 ? "M" : "L", paper_x(o, p[0]),
                 paper_y(o, p[1]));
        }
    }
    PAGE("z");

done:
    return st;
}

static void material_words(const material *m, char *words, size_t size)
{
    static const char *const kinds[] = {"", ", orthotropic", ", anisotropic"};
    const bool graded = m->modulus.across || m->modulus.along;
    char density[60] = "";
    if (m->density > 0) {
        (void)snprintf(density, sizeof density, ", %s kg/m³", number_short(m->density, 5).text);
    }
    (void)snprintf(words, size, "%.80s: E = %s MPa, ν = %s%s%s%s", m->name,
                   number_short(m->E * 1e-6, 6).text, number_short(m->nu, 5).text, density,
                   kinds[(unsigned)m->kind % 3], graded ? ", graded" : "");
}

static status materials(over *o)
{
    status st = OK;
    enum { MOST_EDGES = 4000 }; // a picture of pixels has too many to point at
    bytes *page = o->out;
    plane_edges edges = {0};
    plane_loops loops = {0};
    TRY(plane_edges_make(&o->s->r->section_mesh, &edges));
    for (int m = 0; m < o->s->r->nmaterial && edges.count < MOST_EDGES; m++) {
        char words[280];
        plane_loops_free(&loops);
        TRY(plane_loops_make(&edges, m, &loops));
        if (loops.nloop == 0) {
            continue;
        }
        material_words(&o->s->r->materials[m], words, sizeof words);
        TRY(open_part(o, words));
        PAGE("<path class=\"mark\" fill-rule=\"evenodd\" d=\"");
        for (int i = 0; i < loops.nloop; i++) {
            TRY(put_loop(o, &edges, &loops, i));
        }
        PAGE("\"/></g>\n");
    }

done:
    plane_loops_free(&loops);
    plane_edges_free(&edges);
    return st;
}

static status centre(over *o, const char *name, const double at[2])
{
    status st = OK;
    bytes *page = o->out;
    char words[200];
    if (!is_on_paper(o, at)) {
        return OK;
    }
    (void)snprintf(words, sizeof words, "%s: (%s, %s) mm from the origin", name,
                   number_fixed(at[0] * 1e3, 5).text, number_fixed(at[1] * 1e3, 5).text);
    TRY(open_part(o, words));
    PAGE("<circle class=\"mark\" cx=\"%.1f\" cy=\"%.1f\" r=\"9\"/></g>\n", paper_x(o, at[0]),
         paper_y(o, at[1]));

done:
    return st;
}

// each of them, where they are few enough to be told by name
static status tendons(over *o)
{
    status st = OK;
    enum { MOST_NAMED = 32 };
    const run_result *r = o->s->r;
    for (int i = 0; r->has_rod && r->rod.ntendon <= MOST_NAMED && i < r->rod.ntendon; i++) {
        char name[RESULT_NAME + 10];
        double at[2];
        (void)snprintf(name, sizeof name, "tendon %s", r->rod.tendon_name[i]);
        TRY(section_tendon(o->s, i, at) ? centre(o, name, at) : OK);
    }

done:
    return st;
}

// a band along the axis, wide enough to point at
static status axis(over *o, const char *name, double EI, double angle)
{
    status st = OK;
    bytes *page = o->out;
    char words[200];
    const double *c = o->s->centres->stiffness_centre;
    const double reach = 0.42 * fmin(o->at.w, o->at.h);
    if (!is_on_paper(o, c) || !isfinite(angle)) {
        return OK;
    }
    (void)snprintf(words, sizeof words,
                   "principal axis %s: turned by %s deg from x, bending about it %s N mm²", name,
                   number_fixed(angle * 180 / acos(-1.0), 3).text, number_digits(EI * 1e6, 8).text);
    TRY(open_part(o, words));
    const double dx = reach * cos(angle), dy = reach * sin(angle);
    PAGE("<path class=\"mark\" stroke=\"#fff\" stroke-opacity=\"0\" stroke-width=\"9\" d=\"M%.1f "
         "%.1fL%.1f %.1f\"/></g>\n",
         paper_x(o, c[0]) - dx, paper_y(o, c[1]) + dy, paper_x(o, c[0]) + dx,
         paper_y(o, c[1]) - dy);

done:
    return st;
}

// later ones lie on top
static status parts(over *o)
{
    status st = OK;
    const beam_centres *c = o->s->centres;
    TRY(materials(o));
    if (!c->isotropic) {
        TRY(axis(o, "x′", c->EI[0], c->principal_angle));
        TRY(axis(o, "y′", c->EI[1], c->principal_angle + 0.5 * acos(-1.0)));
    }
    TRY(tendons(o));
    if (o->s->answers && o->s->answers->mass.known) {
        TRY(centre(o, "mass centre", o->s->answers->mass.mass_centre));
    }
    TRY(centre(o, "geometric centre", (const double[]){0, 0}));
    TRY(centre(o, "shear centre", c->shear_centre));
    TRY(centre(o, "stiffness centre", c->stiffness_centre));

done:
    return st;
}

status page_section_figure(bytes *page, const run_result *r, const char *dir)
{
    status st = OK;
    bytes over_text = {0};
    section_sketch s = {0};
    if (r->section_mesh.nnode > 0) {
        TRY(section_sketch_make(r, &s));
        const box at = section_sketch_box(&s);
        over o = {&s, sketch_frame_of(&r->section_mesh, at), at, &over_text};
        TRY(mesh_is_on_paper(&o) ? parts(&o) : OK);
    }
    TRY(page_figure_under(page, dir, "section", over_text.data,
                          s.r && section_tendons(&s) > 0
                              ? "The section at the first station, to scale. Point at, tap or tab "
                                "to a material, a tendon, a centre or an axis for its values."
                              : "The section at the first station, to scale. Point at, tap or tab "
                                "to a material, a centre or an axis for its values."));

done:
    section_sketch_free(&s);
    bytes_free(&over_text);
    return st;
}
