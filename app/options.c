// app/options.c
#include "app/options.h"

#include <string.h>

const option options[OPTION_COUNT] = {
    {"--json", NULL, "print exactly one JSON document on stdout (SI units)", NULL},
    {"--out", "DIR", "write the results to DIR, whole or not at all", NULL},
    {"--force", NULL, "replace an existing DIR that this program wrote", NULL},
    {"--set", "KEY=VALUE", "override a key of the case, e.g. --set section.model=classical", NULL},
    {"--quiet", NULL, "no progress and no hints on stderr", NULL},
    {"--lines", "N", "at most N lines of summary (run, report)", "run, report"},
    {"--markdown", NULL, "the key reference as Markdown (schema)", "schema"},
    {"--bare", NULL, "the case as it was written, without a comment for every key (example)",
     "example"},
    {"--allow-scripts", NULL, "let a `geo:` section run its gmsh script, which may run programs",
     NULL},
    {"--help", NULL, "this help, or that of a command", NULL},
    {"--version", NULL, "the program's version", NULL},
};

const exit_code exit_codes[] = {
    {0, "done"},
    {1, "done, but a comparison is out of tolerance"},
    {2, "usage or case file"},
    {3, "input file damaged"},
    {4, "no convergence"},
    {5, "out of memory, disk or time"},
    {6, "a bug of ours"},
    {130, "interrupted"},
    {0, NULL},
};

static bool is_one_of(const char *word, const char *list)
{
    const size_t n = strlen(word);
    for (const char *p = strstr(list, word); p; p = strstr(p + 1, word)) {
        if ((p == list || p[-1] == ' ') && (p[n] == '\0' || p[n] == ',')) {
            return true;
        }
    }
    return false;
}

bool option_known_to(const option *o, const subcommand *sub)
{
    if (o == &options[OPTION_SET]) {
        return sub->argument && is_one_of(sub->argument, "CASE, CLOUD, DATA...");
    }
    return !o->only || is_one_of(sub->name, o->only);
}

void option_words(const option *o, char words[OPTION_WORDS])
{
    (void)snprintf(words, OPTION_WORDS, "%s%s%s", o->name, o->value ? " " : "",
                   o->value ? o->value : "");
}

// sub: NULL for those of all commands
static void help_options(const subcommand *sub, FILE *stream)
{
    fprintf(stream, "\noptions\n");
    for (int i = 0; i < OPTION_COUNT; i++) {
        char left[OPTION_WORDS];
        if (sub && !option_known_to(&options[i], sub)) {
            continue;
        }
        option_words(&options[i], left);
        fprintf(stream, "  %-16s %s\n", left, options[i].about);
    }
}

void command_help(const command *cmd, FILE *stream)
{
    const subcommand *sub = cmd->sub;
    if (sub) {
        fprintf(stream, "stiffaxis %s%s%s [options]\n\n%s\n%s", sub->name, sub->argument ? " " : "",
                sub->argument ? sub->argument : "", sub->about, sub->details);
        help_options(sub, stream);
        fprintf(stream, "\nexample\n  %s\n", sub->example);
        return;
    }
    fprintf(stream, "stiffaxis " STIFFAXIS_VERSION ": soft rods in several materials, from the "
                    "cross section to the shape\n\n"
                    "usage: stiffaxis COMMAND [CASE] [options]\n\ncommands\n");
    for (sub = subcommands(); sub->name; sub++) {
        char left[32];
        (void)snprintf(left, sizeof left, "%s%s%s", sub->name, sub->argument ? " " : "",
                       sub->argument ? sub->argument : "");
        fprintf(stream, "  %-16s %s\n", left, sub->about);
    }
    help_options(NULL, stream);
    fprintf(stream, "\nexit codes\n");
    for (const exit_code *e = exit_codes; e->about; e++) {
        fprintf(stream, "  %-4d %s\n", e->code, e->about);
    }
    fprintf(stream, "\nfirst steps\n"
                    "  stiffaxis example fig4 > fig4.yaml\n"
                    "  stiffaxis run fig4.yaml --out results/fig4\n");
}
