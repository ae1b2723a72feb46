// app/cmd_man.c
// stiffaxis man [case]: the manual pages stiffaxis(1) and stiffaxis-case(5), from the lists that
// the program itself goes by.
#include "app/case.h"
#include "app/document.h"
#include "app/options.h"
#include "io/json.h"
#include "io/roff.h"

#include <string.h>

static void write_options(FILE *stream)
{
    roff_heading(stream, "Options");
    for (int i = 0; i < OPTION_COUNT; i++) {
        char words[OPTION_WORDS];
        option_words(&options[i], words);
        roff_item(stream, words);
        roff_text(stream, options[i].about);
        (void)fputc('\n', stream);
    }
}

static void write_subcommands(FILE *stream)
{
    roff_heading(stream, "Commands");
    for (const subcommand *sub = subcommands(); sub->name; sub++) {
        char words[64];
        (void)snprintf(words, sizeof words, "%s%s%s", sub->name, sub->argument ? " " : "",
                       sub->argument ? sub->argument : "");
        roff_item(stream, words);
        roff_text(stream, sub->about);
        (void)fputs(".\n", stream);
        roff_text(stream, sub->details);
        (void)fputs(".IP\n.EX\n", stream);
        roff_line(stream, sub->example);
        (void)fputs("\n.EE\n", stream);
    }
}

static void write_exit_codes(FILE *stream)
{
    roff_heading(stream, "Exit status");
    for (const exit_code *e = exit_codes; e->about; e++) {
        char words[16];
        (void)snprintf(words, sizeof words, "%d", e->code);
        roff_item(stream, words);
        roff_text(stream, e->about);
        (void)fputc('\n', stream);
    }
}

static void write_program(FILE *stream)
{
    roff_title(stream, "stiffaxis", 1, STIFFAXIS_VERSION);
    (void)fputs(
        ".SH NAME\n"
        "stiffaxis \\- soft rods in several materials, from the cross section to the shape\n"
        ".SH SYNOPSIS\n"
        ".B stiffaxis\n\\fICOMMAND\\fR [\\fICASE\\fR] [\\fIOPTION\\fR]...\n"
        ".SH DESCRIPTION\n"
        "Reads a case, a text in YAML (see\n.BR stiffaxis\\-case (5)),\n"
        "and tells the stiffness of its cross sections,\n"
        "the shapes of the rod under its tendons, the answer of a 3D segment,\n"
        "how these agree, and which targets a scope reaches.\n"
        "Results go to standard output, messages and progress to standard error.\n",
        stream);
    write_subcommands(stream);
    write_options(stream);
    write_exit_codes(stream);
    (void)fputs(".SH ENVIRONMENT\n.TP\n.B NO_COLOR\nNot empty: no colours.\n"
                ".TP\n.B TMPDIR\nWhere temporary files stand; /tmp where it is not set.\n"
                ".SH EXAMPLES\n.EX\n"
                "stiffaxis example fig4 > fig4.yaml\n"
                "stiffaxis run fig4.yaml \\-\\-out results/fig4\n"
                ".EE\n.SH SEE ALSO\n.BR stiffaxis\\-case (5)\n",
                stream);
}

static status write_case(FILE *stream)
{
    key_table root;
    case_file initial;
    case_keys(&root, &initial);
    roff_title(stream, "stiffaxis-case", 5, STIFFAXIS_VERSION);
    (void)fputs(".SH NAME\n"
                "stiffaxis\\-case \\- the keys of a case of stiffaxis\n"
                ".SH DESCRIPTION\n"
                "A case is a YAML text. Units stand in the names of its keys,\n"
                "of which one spelling is given; ranges and defaults are told in the first.\n"
                "Wherever a number stands, arithmetic may stand, with pi,\n"
                "the rod\\(aqs length L, and the arclength s where a key says so.\n"
                "Of a group, exactly one key is given.\n"
                "The sections below are the maps of a case, the outermost first;\n"
                "a map\\(aqs name stands in italics where a key holds it.\n"
                ".B stiffaxis example\nwrites cases to begin with.\n",
                stream);
    const status st = schema_man(&root, stream);
    (void)fputs(".SH SEE ALSO\n.BR stiffaxis (1)\n", stream);
    return st;
}

static status write_page(bool of_case, FILE *stream)
{
    if (of_case) {
        return write_case(stream);
    }
    write_program(stream);
    return OK;
}

status cmd_man(command *cmd)
{
    const bool of_case = cmd->argument && strcmp(cmd->argument, "case") == 0;
    status st = OK;
    document page = {0};
    if (cmd->argument && !of_case) {
        return status_fail(ERR_INPUT, "no manual page '%s': stiffaxis man, or stiffaxis man case",
                           cmd->argument);
    }
    TRY(document_begin(&page));
    TRY(write_page(of_case, page.stream));
    TRY(document_end_text(&page, cmd, "stiffaxis/man/1",
                          of_case ? "stiffaxis-case.5" : "stiffaxis.1"));

done:
    document_free(&page);
    return st;
}
