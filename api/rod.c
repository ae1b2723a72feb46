// api/rod.c
#include "api/handles.h"

#include "app/chain.h"
#include "base/memory.h"

#include <stdio.h>
#include <string.h>

// for messages: "rod.length_mm=90, rod.frame=nc"
static void tell_settings(settings *s)
{
    size_t at = 0;
    for (int i = 0; i < s->count && at < sizeof s->about; i++) {
        const int n =
            snprintf(s->about + at, sizeof s->about - at, "%s%s", i ? ", " : "", s->text[i]);
        at += n > 0 ? (size_t)n : 0;
    }
}

static status make_rod(stiffaxis_section *section, settings *s, stiffaxis_rod **out)
{
    status st = OK;
    stiffaxis_rod *rod = NULL;
    *out = NULL;
    status_clear();
    TRY(case_need_rod(&section->c->data));
    TRY(TAKE(rod, 1));
    tell_settings(s);
    TRY(varied_make(&section->v, s->count > 0 ? s : NULL, section->c->data.file.rod.at, &rod->w));
    rod->base = rod_case_base(&rod->w.c.file.rod);
    rod->users = 1;
    rod->section = section;
    (void)atomic_fetch_add(&section->users, 1);
    *out = rod;
    rod = NULL;

done:
    free(rod);
    return st;
}

int stiffaxis_rod_make(stiffaxis_section *section, int nsetting, const char *const *texts,
                       stiffaxis_rod **out)
{
    settings s = {.count = nsetting, .text = (char **)texts}; // they are only read
    turn_begin();
    const status st = make_rod(section, &s, out);
    turn_end();
    return (int)st;
}

void stiffaxis_rod_free(stiffaxis_rod *rod)
{
    if (rod && atomic_fetch_sub(&rod->users, 1) == 1) {
        turn_begin();
        varied_free(&rod->w);
        turn_end();
        stiffaxis_section_free(rod->section);
        free(rod);
    }
}

double stiffaxis_rod_length(const stiffaxis_rod *rod)
{
    return rod->w.c.file.rod.length;
}

int stiffaxis_rod_tendons(const stiffaxis_rod *rod)
{
    return rod->w.c.file.rod.tendons.count;
}

int stiffaxis_rod_loads(const stiffaxis_rod *rod)
{
    return rod_case_loads(&rod->w.c.file.rod);
}

// --- names and numbers of the case

static status need_index(int i, int count, const char *what)
{
    return i >= 0 && i < count ? OK
                               : status_fail(ERR_INPUT, "no %s %d: there are %d", what, i, count);
}

static status copy_name(const char *from, char *name, size_t room)
{
    const int n = snprintf(name, room, "%s", from);
    return n >= 0 && (size_t)n < room
               ? OK
               : status_fail(ERR_INPUT, "the name needs %d bytes, not %zu", n + 1, room);
}

int stiffaxis_rod_tendon_name(const stiffaxis_rod *rod, int i, char *name, size_t room)
{
    char own[RESULT_NAME];
    status_clear();
    if (need_index(i, stiffaxis_rod_tendons(rod), "tendon") != OK) {
        return ERR_INPUT;
    }
    chain_tendon_name(&rod->w.c.file.rod, i, own);
    return (int)copy_name(own, name, room);
}

int stiffaxis_rod_load_name(const stiffaxis_rod *rod, int i, char *name, size_t room)
{
    char own[RESULT_NAME];
    status_clear();
    if (need_index(i, stiffaxis_rod_loads(rod), "load") != OK) {
        return ERR_INPUT;
    }
    chain_load_name(&rod->w.c.file.rod, i, own);
    return (int)copy_name(own, name, room);
}

double stiffaxis_rod_critical_tension(const stiffaxis_rod *rod, int tendon)
{
    const bool there = tendon >= 0 && tendon < stiffaxis_rod_tendons(rod);
    return there ? rod_critical_tension(rod->w.rod, tendon, NULL) : NAN;
}

int stiffaxis_rod_solutions(const stiffaxis_rod *rod)
{
    return rod_case_solutions(&rod->w.c.file.rod);
}

int stiffaxis_rod_points(const stiffaxis_rod *rod)
{
    return rod->w.c.file.rod.points;
}

int stiffaxis_rod_solution(const stiffaxis_rod *rod, int i, double *tension, double *pull,
                           double *load)
{
    status_clear();
    if (need_index(i, stiffaxis_rod_solutions(rod), "solution") != OK) {
        return ERR_INPUT;
    }
    rod_case_solution(&rod->w.c.file.rod, i, tension, pull, load);
    return OK;
}
