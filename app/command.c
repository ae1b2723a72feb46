// app/command.c
#include "app/command.h"

#include "app/options.h"
#include "base/nearest.h"
#include "fem/segment.h"

#include <errno.h>
#include <limits.h>
#include <poll.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static status fail_unknown(const char *kind, const char *word, const nearest *near)
{
    char words[NEAREST_WORDS];
    (void)nearest_words(near, words);
    return status_fail(ERR_INPUT, "unknown %s '%s'%s", kind, word,
                       words[0] ? words : ": see stiffaxis --help");
}

static status find_subcommand(const char *word, const subcommand **out)
{
    nearest near = nearest_to(word);
    for (const subcommand *sub = subcommands(); sub->name; sub++) {
        if (strcmp(sub->name, word) == 0) {
            *out = sub;
            return OK;
        }
        nearest_offer(&near, sub->name, sub->name);
    }
    const size_t n = strlen(word);
    if (n > 5 && strcmp(word + n - 5, ".yaml") == 0) {
        return status_fail(ERR_INPUT, "a command comes before '%s', as in: stiffaxis run %s", word,
                           word);
    }
    return fail_unknown("command", word, &near);
}

// the option that `word` names; *value is what follows its '=', NULL without one
static status find_option(const char *word, int *id, const char **value)
{
    char name[64];
    const char *equals = strchr(word, '=');
    const size_t length = equals ? (size_t)(equals - word) : strlen(word);
    (void)snprintf(name, sizeof name, "%.*s", length < 63 ? (int)length : 63, word);
    if (strcmp(name, "-h") == 0) {
        (void)strcpy(name, options[OPTION_HELP].name);
    }
    *value = equals ? equals + 1 : NULL;
    nearest near = nearest_to(name);
    for (int i = 0; i < OPTION_COUNT; i++) {
        if (strcmp(options[i].name, name) == 0) {
            *id = i;
            return OK;
        }
        nearest_offer(&near, options[i].name, options[i].name);
    }
    return fail_unknown("option", name, &near);
}

static status take_value(command *cmd, int id, const char *value)
{
    if (value[0] == '\0') {
        return status_fail(ERR_INPUT, "%s needs %s", options[id].name, options[id].value);
    }
    if (id != OPTION_SET && (cmd->given & 1U << id)) {
        return status_fail(ERR_INPUT, "%s is given twice", options[id].name);
    }
    cmd->given |= 1U << id;
    if (id == OPTION_OUT) {
        cmd->out = value;
    } else if (id == OPTION_SET) {
        const char *equals = strchr(value, '=');
        if (!equals || equals == value) {
            return status_fail(ERR_INPUT, "--set '%s': write KEY=VALUE", value);
        }
        if (cmd->noverride == COMMAND_MAX_OVERRIDES) {
            return status_fail(ERR_INPUT, "more than %d --set", COMMAND_MAX_OVERRIDES);
        }
        cmd->overrides[cmd->noverride++] = value;
    } else {
        char *end = NULL;
        errno = 0;
        const long lines = strtol(value, &end, 10);
        if (*end || errno || lines < 1 || lines > 1000) {
            return status_fail(ERR_INPUT, "--lines '%s': a number from 1 to 1000", value);
        }
        cmd->summary_lines = (int)lines;
    }
    return OK;
}

static void take_flag(command *cmd, int id)
{
    cmd->given |= 1U << id;
    cmd->json = cmd->json || id == OPTION_JSON;
    cmd->force = cmd->force || id == OPTION_FORCE;
    cmd->quiet = cmd->quiet || id == OPTION_QUIET;
    cmd->markdown = cmd->markdown || id == OPTION_MARKDOWN;
    cmd->bare = cmd->bare || id == OPTION_BARE;
    cmd->allow_scripts = cmd->allow_scripts || id == OPTION_ALLOW_SCRIPTS;
    cmd->help = cmd->help || id == OPTION_HELP;
    cmd->version = cmd->version || id == OPTION_VERSION;
}

static status take_option(command *cmd, int argc, const char *const *argv, int *i)
{
    status st = OK;
    int id = 0;
    const char *value = NULL;
    TRY(find_option(argv[*i], &id, &value));
    if (!options[id].value) {
        if (value) {
            return status_fail(ERR_INPUT, "%s takes no value", options[id].name);
        }
        take_flag(cmd, id);
        return OK;
    }
    if (!value) {
        if (*i + 1 >= argc) {
            return status_fail(ERR_INPUT, "%s needs %s", options[id].name, options[id].value);
        }
        value = argv[++*i];
    }
    TRY(take_value(cmd, id, value));

done:
    return st;
}

static status take_word(command *cmd, const char *word)
{
    if (!cmd->sub) {
        return find_subcommand(word, &cmd->sub);
    }
    if (!cmd->sub->argument) {
        return status_fail(ERR_INPUT, "%s takes no argument, not '%s'", cmd->sub->name, word);
    }
    const bool several =
        strstr(cmd->sub->argument, "...") != NULL || strchr(cmd->sub->argument, '|') != NULL;
    if (cmd->argument && !several) {
        const char *what = cmd->sub->argument + (cmd->sub->argument[0] == '[');
        return status_fail(ERR_INPUT, "%s takes one %.*s, not '%s' too", cmd->sub->name,
                           (int)strcspn(what, "]"), what, word);
    }
    if (cmd->nargument == COMMAND_MAX_ARGUMENTS) {
        return status_fail(ERR_INPUT, "%s takes at most %d files", cmd->sub->name,
                           COMMAND_MAX_ARGUMENTS);
    }
    cmd->arguments[cmd->nargument++] = word;
    cmd->argument = cmd->arguments[0];
    return OK;
}

// contradictions between the subcommand and what came with it
static status check_command(const command *cmd)
{
    const subcommand *sub = cmd->sub;
    if (cmd->help || cmd->version) {
        return OK;
    }
    if (!sub) {
        return status_fail(ERR_INPUT, "a command is missing: see stiffaxis --help");
    }
    if (sub->argument && sub->argument[0] != '[' && !cmd->argument) {
        return status_fail(ERR_INPUT, "%s needs %s%s, for example: %s", sub->name,
                           strchr(sub->argument, '|') ? "" : "a ", sub->argument, sub->example);
    }
    for (int i = 0; i < OPTION_COUNT; i++) {
        if ((cmd->given & 1U << i) && i != OPTION_SET && !option_known_to(&options[i], sub)) {
            return status_fail(ERR_INPUT, "unknown option '%s' of %s: it belongs to %s",
                               options[i].name, sub->name, options[i].only);
        }
    }
    if (cmd->noverride > 0 && !option_known_to(&options[OPTION_SET], sub)) {
        return status_fail(ERR_INPUT, "%s reads no case, so --set has nothing to override",
                           sub->name);
    }
    if (cmd->force && !cmd->out && strcmp(sub->name, "report") != 0) {
        return status_fail(ERR_INPUT, "--force replaces the directory of --out, which is missing");
    }
    return OK;
}

status command_parse(int argc, const char *const *argv, command *out)
{
    status st = OK;
    bool only_words = false;
    *out = (command){.summary_lines = COMMAND_SUMMARY_LINES, .first_rank = segment_rank() == 0};
    for (int i = 1; i < argc; i++) {
        if (!only_words && strcmp(argv[i], "--") == 0) {
            only_words = true;
        } else if (!only_words && argv[i][0] == '-' && argv[i][1] != '\0') {
            TRY(take_option(out, argc, argv, &i));
        } else {
            TRY(take_word(out, argv[i]));
        }
    }
    TRY(check_command(out));

done:
    return st;
}

void command_progress(const command *cmd, const char *words)
{
    const char *terminal = getenv("TERM");
    if (cmd->quiet || !cmd->first_rank || !isatty(STDERR_FILENO) || !terminal ||
        strcmp(terminal, "dumb") == 0) {
        return;
    }
    fprintf(stderr, words ? "\r\033[K%s ..." : "\r\033[K", words ? words : "");
    (void)fflush(stderr);
}

void command_hint(const command *cmd, const char *format, ...)
{
    if (cmd->quiet || !cmd->first_rank) {
        return;
    }
    command_progress(cmd, NULL);
    va_list args;
    va_start(args, format);
    (void)vfprintf(stderr, format, args);
    va_end(args);
    (void)fputc('\n', stderr);
}

bool command_colour(void)
{
    const char *terminal = getenv("TERM"), *no_colour = getenv("NO_COLOR");
    return isatty(STDOUT_FILENO) && terminal && strcmp(terminal, "dumb") != 0 &&
           !(no_colour && no_colour[0]);
}

bool command_reader_left(void)
{
    struct pollfd out = {.fd = STDOUT_FILENO, .events = POLLOUT};
    return ferror(stdout) && poll(&out, 1, 0) == 1 && (out.revents & POLLERR) != 0;
}

// why an earlier write failed: stdio does not keep it, another try tells it again
static const char *write_error(void)
{
    errno = 0;
    return write(STDOUT_FILENO, "\n", 1) < 0 ? strerror(errno) : "an earlier write failed";
}

status command_flush(void)
{
    errno = 0;
    if (fflush(stdout) != 0 || ferror(stdout)) {
        const char *words = errno ? strerror(errno) : NULL;
        if (command_reader_left()) {
            return OK;
        }
        return status_fail(ERR_RESOURCE, "cannot write to stdout: %s",
                           words ? words : write_error());
    }
    return OK;
}
