// tests/unit/app/test_command.c
// The command line: what is understood, and what a slip is told.
#include "app/command.h"

#include "tests/test.h"

#include <string.h>

enum { MAX_WORDS = 8 };

static status parse(const char *const words[MAX_WORDS], command *cmd)
{
    const char *argv[MAX_WORDS + 1] = {"stiffaxis"};
    int argc = 1;
    for (; argc <= MAX_WORDS && words[argc - 1]; argc++) {
        argv[argc] = words[argc - 1];
    }
    status_clear();
    return command_parse(argc, argv, cmd);
}

#define PARSE(cmd, ...) parse((const char *const[MAX_WORDS]){__VA_ARGS__}, (cmd))

static void options_are_understood_anywhere(void)
{
    command cmd;
    CHECK_OK(
        PARSE(&cmd, "--json", "section", "--set", "a.b=1", "x.yaml", "--set=c=d=e", "--quiet"));
    CHECK(strcmp(cmd.sub->name, "section") == 0);
    CHECK(strcmp(cmd.argument, "x.yaml") == 0);
    CHECK(cmd.json && cmd.quiet && !cmd.force && !cmd.help);
    CHECK(cmd.noverride == 2);
    CHECK(strcmp(cmd.overrides[0], "a.b=1") == 0);
    CHECK(strcmp(cmd.overrides[1], "c=d=e") == 0);
    CHECK(cmd.summary_lines == COMMAND_SUMMARY_LINES);

    CHECK_OK(PARSE(&cmd, "run", "x.yaml", "--out", "dir", "--force", "--lines", "7"));
    CHECK(strcmp(cmd.out, "dir") == 0 && cmd.force && cmd.summary_lines == 7);
}

static void a_double_dash_and_a_single_one_are_words(void)
{
    command cmd;
    CHECK_OK(PARSE(&cmd, "check", "--", "--json"));
    CHECK(strcmp(cmd.argument, "--json") == 0 && !cmd.json);
    CHECK_OK(PARSE(&cmd, "check", "-"));
    CHECK(strcmp(cmd.argument, "-") == 0);
}

static void help_needs_nothing_else(void)
{
    command cmd;
    CHECK_OK(PARSE(&cmd, "--help"));
    CHECK(cmd.help && !cmd.sub);
    CHECK_OK(PARSE(&cmd, "rod", "-h"));
    CHECK(cmd.help && cmd.sub && !cmd.argument);
    CHECK_OK(PARSE(&cmd, "--version"));
    CHECK(cmd.version);
}

static void slips_are_usage_errors_with_the_nearest_name(void)
{
    const struct {
        const char *words[MAX_WORDS];
        const char *said;
    } slips[] = {
        {{"rum", "x.yaml"}, "did you mean 'run'?"},
        {{"run", "x.yaml", "--forse"}, "did you mean '--force'?"},
        {{"run", "x.yaml", "--outt=dir"}, "did you mean '--out'?"},
        {{"run", "x.yaml", "--zebra"}, "unknown option '--zebra'"},
        {{NULL}, "a command is missing"},
        {{"run"}, "run needs a CASE"},
        {{"run", "a.yaml", "b.yaml"}, "not 'b.yaml' too"},
        {{"doctor", "x.yaml"}, "takes no argument"},
        {{"run", "x.yaml", "--json=1"}, "takes no value"},
        {{"run", "x.yaml", "--out"}, "--out needs DIR"},
        {{"run", "x.yaml", "--out="}, "--out needs DIR"},
        {{"run", "x.yaml", "--set", "a"}, "write KEY=VALUE"},
        {{"run", "x.yaml", "--set", "=a"}, "write KEY=VALUE"},
        {{"run", "x.yaml", "--lines", "12x"}, "a number from 1"},
        {{"run", "x.yaml", "--lines", "0"}, "a number from 1"},
        {{"run", "x.yaml", "--force"}, "--out"},
        {{"doctor", "--set", "a=b"}, "nothing to override"},
        {{"check", "x.yaml", "--markdown"}, "unknown option '--markdown' of check"},
        {{"--lines", "3", "section", "x.yaml"}, "unknown option '--lines' of section"},
        {{"run", "x.yaml", "--out", "a", "--out", "b"}, "--out is given twice"},
    };
    for (size_t i = 0; i < sizeof slips / sizeof *slips; i++) {
        command cmd;
        CHECK(parse(slips[i].words, &cmd) == ERR_INPUT);
        if (!strstr(status_message(), slips[i].said)) {
            printf("slip %zu: '%s' does not say '%s'\n", i, status_message(), slips[i].said);
            test_failures++;
        }
    }
}

static void too_many_overrides_are_refused(void)
{
    const char *argv[3 + 2 * (COMMAND_MAX_OVERRIDES + 1)] = {"stiffaxis", "run", "x.yaml"};
    int argc = 3;
    command cmd;
    for (int i = 0; i <= COMMAND_MAX_OVERRIDES; i++) {
        argv[argc++] = "--set";
        argv[argc++] = "a=1";
    }
    status_clear();
    CHECK(command_parse(argc, argv, &cmd) == ERR_INPUT);
    status_clear();
    CHECK_OK(command_parse(argc - 2, argv, &cmd));
    CHECK(cmd.noverride == COMMAND_MAX_OVERRIDES);
}

static void every_subcommand_has_its_help(void)
{
    for (const subcommand *sub = subcommands(); sub->name; sub++) {
        char *text = NULL;
        size_t size = 0;
        FILE *memory = open_memstream(&text, &size);
        CHECK(memory != NULL);
        command_help(&(command){.sub = sub}, memory);
        CHECK(fclose(memory) == 0);
        CHECK(strstr(text, sub->about) && strstr(text, sub->example) && strstr(text, "--json"));
        // the example is a command line of this program, and is understood
        CHECK(strncmp(sub->example, "stiffaxis ", 10) == 0);
        CHECK(strstr(sub->example, sub->name) == sub->example + 10);
        free(text);
    }
}

int main(void)
{
    options_are_understood_anywhere();
    a_double_dash_and_a_single_one_are_words();
    help_needs_nothing_else();
    slips_are_usage_errors_with_the_nearest_name();
    too_many_overrides_are_refused();
    every_subcommand_has_its_help();
    return test_failures != 0;
}
