// app/chain_about.c
// What a result says of its case before anything is computed.
#include "app/chain.h"
#include "base/memory.h"
#include "reports/markup.h"

#include <stdio.h>
#include <string.h>

// the case's text, and below it what --set changed
static status copy_text(const command *cmd, const case_data *c, run_result *out)
{
    status st = OK;
    size_t length = 0;
    const char *text = config_text(c->config, &length);
    size_t room = length + 1;
    for (int i = 0; i < cmd->noverride; i++) {
        room += strlen(cmd->overrides[i]) + sizeof "# --set \n";
    }
    TRY(TAKE(out->case_text, room));
    memcpy(out->case_text, text, length);
    for (int i = 0; i < cmd->noverride; i++) {
        length += (size_t)snprintf(out->case_text + length, room - length, "# --set %s\n",
                                   cmd->overrides[i]);
    }
    out->case_length = length;

done:
    return st;
}

static status copy_materials(const case_data *c, run_result *out)
{
    status st = OK;
    TRY(TAKE(out->materials, (size_t)c->nmaterial));
    out->nmaterial = c->nmaterial;
    for (int i = 0; i < c->nmaterial; i++) {
        const char *name = c->materials[i].name;
        char *copy = NULL;
        out->materials[i] = c->materials[i];
        out->materials[i].name = NULL;
        TRY(TAKE(copy, strlen(name) + 1));
        memcpy(copy, name, strlen(name));
        out->materials[i].name = copy;
    }

done:
    return st;
}

static void copy_title(const case_data *c, run_result *out)
{
    const char *title = c->file.title;
    if (!title) {
        const char *path = config_path(c->config), *slash = strrchr(path, '/');
        title = slash ? slash + 1 : path;
    }
    char words[2 * sizeof out->title];
    const char *fitted = c->file.fitted;
    (void)snprintf(words, sizeof words, "%s%s%s%s", title, fitted ? " [fitted: " : "",
                   fitted ? fitted : "", fitted ? "]" : "");
    utf8_shorten(words, sizeof out->title - 16, out->title, sizeof out->title);
}

status chain_about(const command *cmd, const case_data *c, run_result *out)
{
    status st = OK;
    copy_title(c, out);
    TRY(copy_text(cmd, c, out));
    TRY(copy_materials(c, out));

done:
    return st;
}
