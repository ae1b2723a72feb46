// app/cmd_completion.c
// stiffaxis completion SHELL: a script that lets the shell ask this program what fits.
#include "app/complete.h"
#include "app/document.h"

#include <string.h>

// bash takes '=' for the end of a word: the pieces are put together again, and of the candidates
// only what follows the last '=' goes back
static const char bash_script[] =
    "# stiffaxis in bash: asks the program what fits\n"
    "_stiffaxis() {\n"
    "    local words=() word line extension piece joined=no i\n"
    "    for ((i = 1; i <= COMP_CWORD; i++)); do\n"
    "        piece=${COMP_WORDS[i]}\n"
    "        if ((${#words[@]})) && [[ $piece == = || $joined == yes ]]; then\n"
    "            words[-1]+=$piece\n"
    "            [[ $piece == = ]] && joined=yes || joined=no\n"
    "        else\n"
    "            words+=(\"$piece\")\n"
    "        fi\n"
    "    done\n"
    "    word=${words[-1]-}\n"
    "    COMPREPLY=()\n"
    "    while IFS= read -r line; do\n"
    "        case $line in\n"
    "        :directories)\n"
    "            mapfile -t COMPREPLY < <(compgen -d -- \"$word\")\n"
    "            compopt -o filenames 2>/dev/null ;;\n"
    "        :files*)\n"
    "            mapfile -t COMPREPLY < <(compgen -d -- \"$word\"\n"
    "                for extension in ${line#:files}; do compgen -f -X \"!*.$extension\" -- "
    "\"$word\"; done)\n"
    "            compopt -o filenames 2>/dev/null ;;\n"
    "        *)\n"
    "            line=${line%%$'\\t'*}\n"
    "            [[ $line == *[.=] ]] && compopt -o nospace 2>/dev/null\n"
    "            [[ $word == *=* ]] && line=${line#\"${word%=*}=\"}\n"
    "            COMPREPLY+=(\"$line\") ;;\n"
    "        esac\n"
    "    done < <(\"$1\" completion words -- \"${words[@]}\" 2>/dev/null)\n"
    "}\n"
    "complete -F _stiffaxis stiffaxis\n";

static const char zsh_script[] =
    "#compdef stiffaxis\n"
    "# stiffaxis in zsh: asks the program what fits\n"
    "_stiffaxis() {\n"
    "    local line word\n"
    "    local -a found told\n"
    "    for line in \"${(@f)$(\"${words[1]}\" completion words -- \"${(@)words[2,CURRENT]}\" "
    "2>/dev/null)}\"; do\n"
    "        case $line in\n"
    "        '') ;;\n"
    "        :directories) _files -/ ;;\n"
    "        :files*) _files -g \"*.(${${line#:files }// /|})\" ;;\n"
    "        *)\n"
    "            word=${line%%$'\\t'*}\n"
    "            if [[ $word == *[.=] ]]; then\n"
    "                compadd -S '' -- \"$word\"\n"
    "            else\n"
    "                found+=(\"$word\")\n"
    "                told+=(\"${line/$'\\t'/  -- }\")\n"
    "            fi ;;\n"
    "        esac\n"
    "    done\n"
    "    (( $#found )) && compadd -l -d told -a found\n"
    "}\n"
    "if [[ $funcstack[1] == _stiffaxis ]]; then _stiffaxis \"$@\"; else compdef _stiffaxis "
    "stiffaxis; fi\n";

static const char fish_script[] =
    "# stiffaxis in fish: asks the program what fits\n"
    "function __stiffaxis_words\n"
    "    set -l typed (commandline -ct)\n"
    "    set -l words (commandline -opc) $typed\n"
    "    test (count $typed) -eq 0; and set -a words ''\n"
    "    for line in ($words[1] completion words -- $words[2..-1] 2>/dev/null)\n"
    "        switch $line\n"
    "            case ':directories'\n"
    "                __fish_complete_directories \"$typed\"\n"
    "            case ':files*'\n"
    "                for extension in (string split ' ' -- $line)[2..-1]\n"
    "                    __fish_complete_suffix .$extension\n"
    "                end\n"
    "            case '*'\n"
    "                printf '%s\\n' $line\n"
    "        end\n"
    "    end\n"
    "end\n"
    "complete -c stiffaxis -f -a '(__stiffaxis_words)'\n";

static status write_completion(const command *cmd, FILE *stream)
{
    const struct {
        const char *shell, *script;
    } all[] = {{"bash", bash_script}, {"zsh", zsh_script}, {"fish", fish_script}};
    if (strcmp(cmd->argument, "words") == 0) {
        complete(cmd->nargument - 1, cmd->arguments + 1, stream);
        return OK;
    }
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        if (strcmp(cmd->argument, all[i].shell) == 0 && cmd->nargument == 1) {
            (void)fputs(all[i].script, stream);
            return OK;
        }
    }
    return status_fail(ERR_INPUT, "no completion for '%s%s': bash, zsh or fish", cmd->argument,
                       cmd->nargument > 1 ? " ..." : "");
}

status cmd_completion(command *cmd)
{
    status st = OK;
    document d = {0};
    char name[64];
    TRY(document_begin(&d));
    TRY(write_completion(cmd, d.stream));
    (void)snprintf(name, sizeof name, "stiffaxis.%.40s", cmd->argument);
    TRY(document_end_text(&d, cmd, "stiffaxis/completion/1", name));

done:
    document_free(&d);
    return st;
}
