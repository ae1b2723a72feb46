// app/cmd_material.c
// stiffaxis material DATA...: tensile tests to Young's modulus.
#include "app/answer.h"
#include "app/command.h"
#include "app/save.h"
#include "io/config.h"
#include "reports/material_report.h"

static status show(command *cmd, const material_result *r)
{
    status st = OK;
    json *j = NULL;
    if (!cmd->json) {
        material_print(r, stdout);
        return OK;
    }
    TRY(answer_open(cmd, &j));
    st = material_json(j, r);
    const status closed = json_close(j);
    st = st == OK ? closed : st;

done:
    return st;
}

status cmd_material(command *cmd)
{
    status st = OK;
    config *cfg = NULL;
    material_settings s = {0};
    material_result r = {0};
    TRY(config_open_text("--set", "{}\n", cmd->noverride, cmd->overrides, &cfg));
    TRY(config_read(cfg, &material_settings_keys, &s));
    TRY(save_check(cmd));
    TRY(material_measure(cmd->nargument, cmd->arguments, &s, &r));
    TRY(save_files(cmd, material_files, &r));
    command_progress(cmd, NULL);
    for (int i = 0; i < r.nwarning; i++) {
        fprintf(stderr, "warning: %s\n", r.warning[i]);
    }
    TRY(show(cmd, &r));
    TRY(command_flush());
    if (cmd->out) {
        command_hint(cmd, "written: %s/material.yaml, material.png", cmd->out);
    } else {
        command_hint(cmd, "nothing was written: --out DIR keeps the block for a case and a figure");
    }

done:
    material_result_free(&r);
    config_free(cfg);
    return st;
}
