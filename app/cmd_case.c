// app/cmd_case.c
// The subcommands that compute from a case: run, section, rod, fem, compare. Read, compute, save,
// show.
#include "app/answer.h"
#include "app/case.h"
#include "app/chain.h"
#include "app/command.h"
#include "app/compare.h"
#include "app/design_case.h"
#include "app/measured_case.h"
#include "app/print.h"
#include "app/reach_case.h"
#include "app/save.h"
#include "reports/figures.h"

#include <unistd.h>

typedef struct study {
    status (*need)(const case_data *c); // NULL: any case will do
    chain_parts (*parts)(const case_data *c);
    status (*document)(json *j, const char *key, const run_result *r);
    void (*print)(const run_result *r); // NULL: the summary
} study;

static status document_run(json *j, const char *key, const run_result *r)
{
    (void)key;
    return result_json_run(j, r);
}

static status show(command *cmd, const study *what, const run_result *r)
{
    status st = OK;
    json *j = NULL;
    if (cmd->json) {
        TRY(answer_open(cmd, &j));
        st = what->document(j, NULL, r);
        const status closed = json_close(j);
        return st != OK ? st : closed;
    }
    if (what->print) {
        what->print(r);
    } else {
        TRY(report_summary(r, cmd->summary_lines, stdout));
    }

done:
    return st;
}

// What the result that is about to be replaced holds solved; nothing where there is none, or none
// that can be read.
static void recall_sections(const command *cmd, section_known *known)
{
    char path[4096];
    if (cmd->out && cmd->force) {
        (void)snprintf(path, sizeof path, "%s/result.hdf", cmd->out);
        if (access(path, R_OK) == 0 && result_known_read(path, known) != OK) {
            status_clear();
        }
    }
}

static status do_study(command *cmd, const study *what)
{
    status st = OK;
    case_data c = {0};
    run_result r = {0};
    section_known known = {0};

    TRY(command_case(cmd, &c));
    recall_sections(cmd, &known);
    c.file.section.known = cmd->out ? &known : NULL; // without a result nobody keeps them
    TRY(what->need ? what->need(&c) : OK);
    TRY(save_check(cmd));
    chain_parts parts = what->parts(&c);
    parts.pictures = cmd->out != NULL;
    parts.answers = cmd->out || (parts.section && (cmd->json || c.file.section.wrenches.count > 0));
    TRY(chain_run(cmd, &c, parts, &r));
    TRY(save_result(cmd, &r));
    command_progress(cmd, NULL);
    TRY(show(cmd, what, &r));
    TRY(command_flush());
    if (cmd->out) {
        command_hint(cmd, "written: %s/report.html", cmd->out);
    } else if (!what->print) {
        command_hint(cmd, "nothing was written: --out DIR keeps the result, figures and a page");
    }
    TRY(chain_rod_verdict(&c, &r));
    st = compare_verdict(&r);

done:
    run_result_free(&r);
    section_known_free(&known);
    case_free(&c);
    return st;
}

static chain_parts parts_section(const case_data *c)
{
    (void)c;
    return (chain_parts){.section = true};
}

static chain_parts parts_rod(const case_data *c)
{
    (void)c;
    return (chain_parts){.rod = true};
}

static chain_parts parts_segment(const case_data *c)
{
    (void)c;
    return (chain_parts){.segment = true};
}

static chain_parts parts_compare(const case_data *c)
{
    const bool measured = case_has_measured(c);
    return (chain_parts){
        .rod = measured, .segment = case_has_segment(c), .compare = true, .measured = measured};
}

static chain_parts parts_sensitivity(const case_data *c)
{
    (void)c;
    return (chain_parts){.rod = true, .sensitivity = true};
}

static chain_parts parts_fit(const case_data *c)
{
    (void)c;
    return (chain_parts){.rod = true, .fit = true};
}

static chain_parts parts_reach(const case_data *c)
{
    (void)c;
    return (chain_parts){.reach = true};
}

static chain_parts parts_design(const case_data *c)
{
    (void)c;
    return (chain_parts){.design = true};
}

status cmd_run(command *cmd)
{
    return do_study(cmd, &(study){NULL, chain_all_parts, document_run, NULL});
}

status cmd_section(command *cmd)
{
    return do_study(cmd,
                    &(study){case_need_section, parts_section, result_json_section, print_section});
}

status cmd_rod(command *cmd)
{
    return do_study(cmd, &(study){case_need_rod, parts_rod, result_json_rod, print_rods});
}

status cmd_fem(command *cmd)
{
    return do_study(cmd,
                    &(study){case_need_segment, parts_segment, result_json_segment, print_segment});
}

status cmd_sensitivity(command *cmd)
{
    return do_study(cmd, &(study){case_need_rod, parts_sensitivity, result_json_sensitivity,
                                  print_sensitivity});
}

status cmd_fit(command *cmd)
{
    return do_study(cmd, &(study){case_need_fit, parts_fit, result_json_fit, print_fit});
}

status cmd_compare(command *cmd)
{
    return do_study(cmd,
                    &(study){case_need_section, parts_compare, result_json_compare, print_compare});
}

status cmd_reach(command *cmd)
{
    return do_study(cmd, &(study){case_need_reach, parts_reach, result_json_reach, print_reach});
}

status cmd_design(command *cmd)
{
    return do_study(cmd, &(study){case_need_design, parts_design, result_json_reach, print_design});
}
