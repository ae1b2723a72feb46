// reports/page_materials.c
// The page's table of materials.
#include "reports/markup.h"
#include "reports/page_kit.h"
#include "reports/result.h"

static bool is_graded(const material *m)
{
    return m->modulus.across || m->modulus.along;
}

bool materials_are_plain(const run_result *r)
{
    for (int i = 0; i < r->nmaterial; i++) {
        if (r->materials[i].kind != MATERIAL_ISOTROPIC || is_graded(&r->materials[i])) {
            return false;
        }
    }
    return true;
}

static status orthotropic_constants(bytes *page, const material *m)
{
    status st = OK;
    const struct {
        const char *name;
        double value;
    } all[] = {
        {"E1", m->E1 * 1e-6},   {"E2", m->E2 * 1e-6},   {"E3", m->E3 * 1e-6},
        {"G12", m->G12 * 1e-6}, {"G13", m->G13 * 1e-6}, {"G23", m->G23 * 1e-6},
        {"ν12", m->nu12},       {"ν13", m->nu13},       {"ν23", m->nu23},
    };
    for (int i = 0; i < 9; i++) {
        PAGE("%s%s %s%s", i ? ", " : ": ", all[i].name, number_short(all[i].value, 5).text,
             i == 5 ? " MPa" : "");
    }

done:
    return st;
}

static status kind_words(bytes *page, const material *m)
{
    status st = OK;
    static const char *const kinds[] = {"isotropic", "orthotropic", "anisotropic"};
    PAGE("%s", kinds[m->kind]);
    if (m->kind == MATERIAL_ORTHOTROPIC) {
        TRY(orthotropic_constants(page, m));
    }
    if (is_graded(m)) {
        PAGE(", graded over the %s%s%s", m->modulus.across ? "section" : "",
             m->modulus.across && m->modulus.along ? " and along the " : "",
             m->modulus.along ? "rod" : "");
    }

done:
    return st;
}

status page_materials(bytes *page, const run_result *r)
{
    status st = OK;
    PAGE("<div class=\"scroll\"><table>\n<thead><tr><th>material</th><th>E<small>MPa</small></th>"
         "<th>ν</th><th>density<small>kg/m³</small></th>"
         "<th>linear up to<small>%% strain</small></th><th class=\"text\">kind</th></tr></thead>\n"
         "<tbody>\n");
    for (int i = 0; i < r->nmaterial; i++) {
        const material *m = &r->materials[i];
        PAGE("<tr><td>");
        TRY(page_escaped(page, m->name));
        PAGE("</td><td>%s</td><td>%s</td>", number_short(m->E * 1e-6, 6).text,
             number_short(m->nu, 5).text);
        PAGE("<td>%s</td>", m->density > 0 ? number_short(m->density, 5).text : "not given");
        PAGE("<td>%s</td><td class=\"text\">",
             m->linear_strain > 0 ? number_short(m->linear_strain * 100, 4).text : "not given");
        TRY(kind_words(page, m));
        PAGE("</td></tr>\n");
    }
    PAGE("</tbody></table></div>\n");
    if (!materials_are_plain(r)) {
        PAGE(
            "<p class=\"note\">E and ν of a directed material are those along the rod, without the "
            "axes of a shape; of a graded one, those at the origin.</p>\n");
    }

done:
    return st;
}
