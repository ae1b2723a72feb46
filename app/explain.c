#include "app/explain.h"

#include "base/memory.h"
#include "io/utf8.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

enum { ABOUT_WIDTH = 13, TEXT_WIDTH = 110, MOST_LISTED = 8 };

static void write_wrapped(FILE *stream, const char *text)
{
    int column = ABOUT_WIDTH;
    for (const char *word = text; *word;) {
        const int n = (int)strcspn(word, " ");
        if (column > ABOUT_WIDTH && column + 1 + n > TEXT_WIDTH) {
            column = fprintf(stream, "\n%*s  ", ABOUT_WIDTH, "") - 1;
        } else if (column > ABOUT_WIDTH) {
            column += fprintf(stream, " ");
        }
        column += fprintf(stream, "%.*s", n, word);
        word += n;
        word += *word == ' ';
    }
    (void)fputc('\n', stream);
}

void explain(explanation *e, const char *about, const char *format, ...)
{
    char text[2 * EXPLAIN_WORDS];
    va_list args;
    va_start(args, format);
    (void)vsnprintf(text, sizeof text, format, args);
    va_end(args);
    utf8_make_plain(text); // names come from files
    if (e->j) {
        json_object(e->j, NULL);
        json_text(e->j, "about", about);
        json_text(e->j, "text", text);
        json_object_end(e->j);
        return;
    }
    const bool same = e->about && strcmp(e->about, about) == 0;
    fprintf(e->stream, "%-*s", ABOUT_WIDTH, same ? "" : about);
    write_wrapped(e->stream, text);
    e->about = about;
}

void word_list_add(word_list *l, const char *format, ...)
{
    char word[EXPLAIN_WORDS / 2];
    va_list args;
    va_start(args, format);
    const int n = vsnprintf(word, sizeof word, format, args);
    va_end(args);
    if (l->used + (size_t)(n > 0 ? n : 0) + 8 < sizeof l->text && n < (int)sizeof word) {
        l->used += (size_t)snprintf(l->text + l->used, sizeof l->text - l->used, "%s%s",
                                    l->used ? ", " : "", word);
    } else if (l->used < 3 || strcmp(l->text + l->used - 3, "...") != 0) {
        l->used += (size_t)snprintf(l->text + l->used, sizeof l->text - l->used, "%s...",
                                    l->used ? ", " : "");
    }
}

// --- materials

static void describe_material(const material *m, word_list *words)
{
    if (m->kind == MATERIAL_ANISOTROPIC) {
        word_list_add(words, "%.60s: anisotropic", m->name);
    } else if (m->kind == MATERIAL_ORTHOTROPIC) {
        word_list_add(words, "%.60s: orthotropic", m->name);
        word_list_add(words, "E1 %.6g MPa, E2 %.6g, E3 %.6g", 1e-6 * m->E1, 1e-6 * m->E2,
                      1e-6 * m->E3);
    } else if (material_is_graded(m) || material_varies(m)) {
        word_list_add(words, "%.60s: E varies over %s%s%s", m->name,
                      material_is_graded(m) ? "x and y" : "",
                      material_is_graded(m) && material_varies(m) ? " and " : "",
                      material_varies(m) ? "s" : "");
        word_list_add(words, "nu %.6g", m->nu);
    } else {
        word_list_add(words, "%.60s: E %.6g MPa, nu %.6g", m->name, 1e-6 * m->E, m->nu);
    }
    if (m->density > 0) {
        word_list_add(words, "%.6g kg/m3", m->density);
    }
    if (m->linear_strain > 0) {
        word_list_add(words, "close to linear up to %.3g %% of strain", 100 * m->linear_strain);
    }
}

static void explain_materials(explanation *e, const case_data *c)
{
    for (int i = 0; i < c->nmaterial && i < MOST_LISTED; i++) {
        word_list words = {0};
        describe_material(&c->materials[i], &words);
        explain(e, "materials", "%s", words.text);
    }
    if (c->nmaterial > MOST_LISTED) {
        explain(e, "materials", "and %d more", c->nmaterial - MOST_LISTED);
    }
}

// --- what the section is

static const char *kind_of(const shape_spec *s)
{
    const struct {
        mark at;
        const char *name;
    } kinds[] = {{s->annulus.at, "annulus"},
                 {s->sector.at, "sector"},
                 {s->disc.at, "disc"},
                 {s->rectangle.at, "rectangle"},
                 {s->polygon.at, "polygon"},
                 {s->ellipse.at, "ellipse"},
                 {s->rounded_rectangle.at, "rounded rectangle"},
                 {s->spline.at, "spline"},
                 {s->lumens.at, "lumens"}};
    for (int i = 0; i < (int)(sizeof kinds / sizeof *kinds); i++) {
        if (mark_given(kinds[i].at)) {
            return kinds[i].name;
        }
    }
    return "shape";
}

static void explain_shapes(explanation *e, const case_data *c)
{
    word_list words = {0};
    const section_case *section = &c->file.section;
    const shape_spec *shapes = section->shapes.items;
    const drawing_files *f = &section->files;
    if (section->drawing) {
        const int n = drawing_slice_count(section->drawing);
        const char *name = f->png.file.text    ? f->png.file.text
                           : f->msh.file.text  ? f->msh.file.text
                           : f->step.file.text ? f->step.file.text
                           : f->dxf.file.text  ? f->dxf.file.text
                                               : f->geo.file.text;
        if (n > 1) {
            explain(e, "section", "%d slices of %.6g mm from %s, one after another along the rod",
                    n, 1e3 * drawing_length(section->drawing) / n, name);
        } else {
            explain(e, "section", "from %s", name);
        }
        return;
    }
    for (int i = 0, same = 1; i < section->shapes.count; i += same) {
        const int k = shapes[i].material_index;
        char times[32] = "";
        same = 1;
        while (i + same < section->shapes.count && shapes[i + same].material_index == k &&
               strcmp(kind_of(&shapes[i]), kind_of(&shapes[i + same])) == 0) {
            same++;
        }
        if (same > 1) {
            (void)snprintf(times, sizeof times, "%d x ", same);
        }
        word_list_add(&words, k >= 0 ? "%s%s of %.60s" : "%s%s cut out", times, kind_of(&shapes[i]),
                      k >= 0 ? c->materials[k].name : "");
    }
    explain(e, "section", "%s%s", section->shapes.count > 1 ? "later ones on top: " : "",
            words.text);
}

static status explain_areas(explanation *e, const case_data *c, const mesh *m)
{
    status st = OK;
    double *area = NULL;
    word_list words = {0};
    int triangles = 0;
    if (m->nnode == 0) {
        return OK;
    }
    TRY(TAKE(area, (size_t)c->nmaterial));
    TRY(section_areas(m, c->nmaterial, area));
    for (int i = 0; i < c->nmaterial; i++) {
        if (area[i] > 0) {
            word_list_add(&words, "%.5g mm2 of %.60s", 1e6 * area[i], c->materials[i].name);
        }
    }
    for (int b = 0; b < m->nblock; b++) {
        triangles += m->block[b].shape == SHAPE_TRIANGLE ? m->block[b].nelem : 0;
    }
    const int all = mesh_element_count(m);
    explain(e, "section", "%s; %s of order %d: %d elements, %d nodes", words.text,
            triangles == all ? "triangles"
            : triangles > 0  ? "triangles and quadrilaterals"
                             : "quadrilaterals",
            m->order, all, m->nnode);

done:
    free(area);
    return st;
}

static const char *station_words(const case_data *c)
{
    const section_case *section = &c->file.section;
    bool along =
        section_varies(section) || (section->drawing && drawing_slice_count(section->drawing) > 1);
    for (int i = 0; i < c->nmaterial; i++) {
        along = along || material_varies(&c->materials[i]);
    }
    return section->stations.nrow > 0 ? "at the stations asked for"
           : along                    ? "at stations chosen by how it varies along s"
                                      : "the same all along: solved once";
}

static void explain_model(explanation *e, const case_data *c, const mesh *m)
{
    explain(e, "model",
            c->file.section.model == MODEL_FULL
                ? "full: warping solved, the 6x6 with all its couplings; %s"
            : m->nnode > 0 ? "classical: integrals of E and G over the mesh, Eq. 11 and 12; %s"
                           : "classical: integrals of E and G in closed form, Eq. 11 and 12; %s",
            station_words(c));
}

status explain_section(explanation *e, const case_data *c, const mesh *first)
{
    status st = OK;
    double reach = 0;
    explain_materials(e, c);
    explain_shapes(e, c);
    TRY(section_reach_at(&c->file.section, 0, &reach));
    explain(e, "section", "reaches %.4g mm from its origin", 1e3 * reach);
    TRY(explain_areas(e, c, first));
    explain_model(e, c, first);

done:
    return st;
}
