// api/document.c
// The program's own documents.
#include "api/handles.h"

#include "app/chain.h"
#include "io/json.h"
#include "reports/result.h"

#include <stdio.h>
#include <stdlib.h>

// in the words of `stiffaxis section --json`
static status write_section(const run_result *r, FILE *stream)
{
    status st = OK;
    json *j = NULL;
    TRY(json_open(stream, &j));
    st = result_json_section(j, NULL, r);
    const status closed = json_close(j);
    st = st != OK ? st : closed;

done:
    return st;
}

static status tell_section(const stiffaxis_section *section, char **out)
{
    status st = OK;
    const command nobody = {.quiet = true};
    const case_data *c = &section->c->data;
    run_result r = {.section = section->v.section, .section_model = c->file.section.model};
    size_t length;
    char *text = NULL;
    FILE *stream = open_memstream(&text, &length);
    *out = NULL;
    status_clear();
    TRY(stream ? OK : status_fail(ERR_RESOURCE, "out of memory: a document"));
    TRY(chain_about(&nobody, c, &r));
    TRY(chain_points(c, &r));
    TRY(chain_answers(c, false, &r));
    st = write_section(&r, stream);

done:
    if (stream && fclose(stream) != 0 && st == OK) {
        st = status_fail(ERR_RESOURCE, "out of memory: a document");
    }
    if (st == OK) {
        *out = text;
        text = NULL;
    }
    free(text);
    r.section = (section_result){0}; // it stays where it was
    run_result_free(&r);
    return st;
}

int stiffaxis_section_json(const stiffaxis_section *section, char **out)
{
    turn_begin();
    const status st = tell_section(section, out);
    turn_end();
    return (int)st;
}

void stiffaxis_text_free(char *text)
{
    free(text);
}
