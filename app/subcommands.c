// app/subcommands.c
// The list of subcommands with their help, and the way into one.
#include "app/answer.h"
#include "app/command.h"

#include <stdlib.h>
#include <string.h>

static const subcommand list[] = {
    {"run", "CASE", cmd_run, "everything that the case asks for, in order, and the report",
     "Sections, rod, 3D segment and the comparisons that they allow. With --out DIR: result.hdf\n"
     "(HDF5, opens in ParaView), report.html, figures as SVG and PNG, CSV tables. Without --out\n"
     "only the summary is printed. Exit code 1 when a comparison is out of tolerance.\n",
     "stiffaxis run fig4.yaml --out results/fig4"},
    {"section", "CASE", cmd_section, "cross sections: centres, axes, 6x6 stiffness",
     "One row per station. Matrices are in the order nx ny nz mx my mz at the geometric centre.\n",
     "stiffaxis section constant_nc.yaml --json"},
    {"rod", "CASE", cmd_rod, "shapes under the case's tendons and loads",
     "Tip position, bend, tendon lengths and stability for each row of tensions, pulled lengths "
     "and\n"
     "loads. Exit code 4 where one ends at a limit point; it is shown all the same, and marked.\n",
     "stiffaxis rod constant_nc.yaml --set rod.frame=nc"},
    {"fem", "CASE", cmd_fem, "the 3D segment under the case's tip loads",
     "Linear elasticity on the extruded section; runs under mpirun too.\n",
     "stiffaxis fem fig4.yaml --set fem.layers=24"},
    {"compare", "CASE", cmd_compare, "two ways to each number, side by side, with a verdict",
     "Section by us, by GetDP and by 3D FEM; rod in both frames; rod against 3D FEM. Exit code 1\n"
     "when a difference is out of its tolerance.\n",
     "stiffaxis compare fig4.yaml"},
    {"sensitivity", "CASE", cmd_sensitivity,
     "what moves the tip: parameters one at a time, and at "
     "random",
     "How far the tip goes by each parameter of the case's `sensitivity`: by the rod's own\n"
     "derivative, and by whole solves at the ends of its range. Without that block: tendon radii,\n"
     "Poisson's ratio, the stiffest modulus, friction, the section's other model. monte_carlo "
     "draws\n"
     "all of them together. --out DIR: the page, tornado.svg, sensitivity.csv, monte_carlo.csv.\n",
     "stiffaxis sensitivity constant_nc.yaml --set sensitivity.monte_carlo.samples=1000"},
    {"fit", "CASE", cmd_fit, "the case's open numbers by its measured shapes",
     "Nonlinear least squares of the rod's shapes to `measured.shapes`: each parameter of `fit`\n"
     "with its standard error and interval, how they go together, errors before and after. --out\n"
     "DIR writes fitted.yaml too, the case with the fitted values.\n",
     "stiffaxis fit bench.yaml --out results/bench"},
    {"reach", "CASE", cmd_reach, "which targets in a body scopes reach, and why not the others",
     "The case's `reach`: a tissue surface (STL, OBJ, PLY), targets (CSV), an entry line, and "
     "scopes\n"
     "that are rods or arcs of constant curvature. Each target is reached or not, with the "
     "reason,\n"
     "the pose, the body's clearance, and how thorough the search was; `map` tells which share of\n"
     "the surface is reached. Lengths in the surface's file are in `tissue_unit`.\n",
     "stiffaxis reach endoscope.yaml --out results/endoscope"},
    {"design", "CASE", cmd_design, "the rod whose scope reaches most",
     "The case's `reach.design`: numbers in bounds that stand in the expressions of some keys, by\n"
     "several searches side by side on all cores; under mpirun the ranks share them out. The same\n"
     "seed gives the same design. With --out DIR: designed.yaml, the case with the design put in,\n"
     "and every design that was looked at as a line of DIR.design-log: the same command goes on\n"
     "from there after an interrupt, or with more reach.design.evaluations. Where DIR is there\n"
     "already --force replaces it and keeps the log. The log may be removed.\n",
     "stiffaxis design endoscope.yaml --out results/design"},
    {"report", "RESULT", cmd_report, "figures and the page from a stored result",
     "RESULT is a result.hdf or the directory that holds it. Nothing is recomputed. Without --out\n"
     "the directory stands beside RESULT: results/fig4 and results/fig4/result.hdf give\n"
     "results/fig4-report, a copy mine.hdf gives mine-report.\n",
     "stiffaxis report results/fig4/result.hdf --out results/fig4-again"},
    {"material", "DATA...", cmd_material, "tensile tests to Young's modulus with its interval",
     "DATA: tables (CSV, text) with columns such as 'strain [%]' and 'stress [MPa]', or\n"
     "'extension [mm]' and 'force [N]' with --set gauge_length_mm=25 --set area_mm2=8 (or\n"
     "width_mm and thickness_mm, diameter_mm, or lines that say so above the names). Several\n"
     "files, several pairs of columns or a column 'specimen' are replicates, which are pooled.\n"
     "More to --set: name, source, nu=0.48 (at most 0.4999; for the block, tension does not tell\n"
     "it), departure=0.05, outliers=leave_out. With --out DIR:\n"
     "material.yaml, ready for a case's `materials`, and the curves as a figure.\n",
     "stiffaxis material bar1.csv bar2.csv --set name=soft --out results/soft"},
    {"scan", "CLOUD", cmd_scan, "a scanned tube's points to its centreline",
     "CLOUD: PLY, PCD, XYZ or CSV; or a YAML file, `format: 1`, `scan: {cloud: FILE, ...}`. "
     "Lengths\n"
     "in the file are mm unless --set scan.unit=m or its columns say else. What is known of the "
     "body\n"
     "helps: scan.radius_mm, scan.length_mm, scan.base.point_mm. The rod's frame comes from\n"
     "scan.fiducials (three or more), or scan.plate and scan.mark. With --out DIR: "
     "centreline.csv,\n"
     "which a case's `measured` reads, scan.json, a picture, a line for ParaView.\n",
     "stiffaxis scan helix.ply --set scan.radius_mm=4 --out results/helix"},
    {"check", "CASE", cmd_check, "what the case is understood to be, and whether it is sound",
     "Says what was understood: materials, section and areas, model, tendons' paths, the 3D mesh\n"
     "with what it costs, what `run` would do, files, defaults. Nothing is solved. Every mistake "
     "in\n"
     "a case is one line FILE:LINE:COL: error: ..., and exit code 2.\n",
     "stiffaxis check fig4.yaml"},
    {"schema", NULL, cmd_schema, "the key reference as JSON Schema",
     "For editors that check YAML while one types; --markdown prints it for people.\n",
     "stiffaxis schema > stiffaxis.schema.json"},
    {"example", "[NAME]", cmd_example,
     "a runnable case with comments; without NAME the list of them",
     "The cases of the repository's cases/, which this program carries, with a comment for every\n"
     "key that they use; --bare leaves out what their writers did not say. --out DIR writes\n"
     "DIR/NAME.yaml and, where the case reads images, scans or tables, those beside it.\n",
     "stiffaxis example fig4 > fig4.yaml"},
    {"doctor", NULL, cmd_doctor, "versions, and what works on this machine",
     "Uses every library once on a small problem. Exit code 5 when one that is needed fails.\n",
     "stiffaxis doctor"},
    {"man", "[case]", cmd_man, "the manual page; of the case file's keys with `case`",
     "As troff reads it: stiffaxis man | man -l -\n", "stiffaxis man case | man -l -"},
    {"completion", "bash|zsh|fish", cmd_completion,
     "a script that lets the shell complete commands",
     "Commands, options, examples, files, and the keys of --set with their choices. Installed "
     "ones\n"
     "are found by themselves.\n",
     "stiffaxis completion bash > ~/.local/share/bash-completion/completions/stiffaxis"},
    {0},
};

const subcommand *subcommands(void)
{
    return list;
}

// the same words as one JSON document
static status answer_text(command *cmd, const char *schema, const char *key, const char *text)
{
    status st = OK;
    json *j = NULL;
    TRY(answer_open(cmd, &j));
    json_object(j, NULL);
    json_text(j, "schema", schema);
    json_text(j, key, text);
    json_object_end(j);
    st = json_close(j);

done:
    return st;
}

static status answer_help(command *cmd)
{
    char *text = NULL;
    size_t size = 0;
    if (!cmd->json) {
        command_help(cmd, stdout);
        return OK;
    }
    FILE *memory = open_memstream(&text, &size);
    if (!memory) {
        return status_fail(ERR_RESOURCE, "out of memory: the help text");
    }
    command_help(cmd, memory);
    const bool closed = fclose(memory) == 0;
    const status st = closed ? answer_text(cmd, "stiffaxis/help/1", "text", text)
                             : status_fail(ERR_RESOURCE, "out of memory: the help text");
    free(text);
    return st;
}

status command_run(command *cmd)
{
    // under mpirun one process speaks
    if (!cmd->first_rank) {
        if (!freopen("/dev/null", "w", stdout)) {
            return status_fail(ERR_RESOURCE, "cannot open /dev/null");
        }
    }
    if (cmd->help) {
        return answer_help(cmd);
    }
    if (cmd->version) {
        if (cmd->json) {
            return answer_text(cmd, "stiffaxis/version/1", "version", STIFFAXIS_VERSION);
        }
        printf("stiffaxis " STIFFAXIS_VERSION "\n");
        return OK;
    }
    return cmd->sub->run(cmd);
}
