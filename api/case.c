// api/case.c
#include "api/handles.h"

#include "base/memory.h"

const char *stiffaxis_version(void)
{
    return STIFFAXIS_VERSION;
}

const char *stiffaxis_error(void)
{
    return status_message();
}

static status open_case(const case_request *request, stiffaxis_case **out)
{
    status st = OK;
    stiffaxis_case *c = NULL;
    *out = NULL;
    status_clear();
    TRY(TAKE(c, 1));
    TRY(case_open(request, &c->data));
    c->users = 1;
    *out = c;
    c = NULL;

done:
    free(c);
    return st;
}

static int open_in_turn(const case_request *request, stiffaxis_case **out)
{
    turn_begin();
    const status st = open_case(request, out);
    turn_end();
    return (int)st;
}

int stiffaxis_case_open(const char *path, int nsetting, const char *const *settings,
                        int allow_scripts, stiffaxis_case **out)
{
    return open_in_turn(&(case_request){.path = path,
                                        .noverride = nsetting,
                                        .overrides = settings,
                                        .allow_scripts = allow_scripts},
                        out);
}

int stiffaxis_case_read(const char *text, const char *name, int nsetting,
                        const char *const *settings, int allow_scripts, stiffaxis_case **out)
{
    return open_in_turn(&(case_request){.path = name,
                                        .text = text,
                                        .noverride = nsetting,
                                        .overrides = settings,
                                        .allow_scripts = allow_scripts},
                        out);
}

void stiffaxis_case_free(stiffaxis_case *c)
{
    if (c && atomic_fetch_sub(&c->users, 1) == 1) {
        turn_begin();
        case_free(&c->data);
        free(c);
        turn_end();
    }
}

const char *stiffaxis_case_title(const stiffaxis_case *c)
{
    return c->data.file.title;
}

double stiffaxis_case_length(const stiffaxis_case *c)
{
    return c->data.length;
}

int stiffaxis_case_has_section(const stiffaxis_case *c)
{
    return case_has_section(&c->data);
}

int stiffaxis_case_has_rod(const stiffaxis_case *c)
{
    return case_has_rod(&c->data);
}
