#!/bin/sh
# What bash offers for a line that is being typed, through the installed script and bash's own machinery; zsh and fish where they
# are there.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
command -v bash >/dev/null || {
    echo 'completion: left out, there is no bash'
    exit 0
}
"$program" completion bash >"$work/script" || fail 'no script for bash'
mkdir "$work/here" "$work/here/folder"
: >"$work/here/mine.yaml"
: >"$work/here/picture.png"
cat >"$work/ask" <<'END'
# ask WORD...: the last word is being typed; what comes back, in one line. '=' parts words, as bash does it
source "$SCRIPT"
compopt() { :; }
COMP_WORDS=("$PROGRAM")
for word in "$@"; do
    rest=$word
    while [[ $rest == *?=* || $rest == *=?* ]]; do
        piece=${rest%%=*}
        [[ -n $piece ]] && COMP_WORDS+=("$piece")
        COMP_WORDS+=("=")
        rest=${rest#*=}
        [[ -z $rest ]] && break
    done
    [[ -n $rest || -z $word ]] && COMP_WORDS+=("$rest")
done
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
_stiffaxis "$PROGRAM"
echo "${COMPREPLY[*]}"
END

# offers WANTED WORD...
offers() {
    wanted=$1
    shift
    got=$(cd "$work/here" && SCRIPT=$work/script PROGRAM=$program bash --norc "$work/ask" "$@")
    [ "$got" = "$wanted" ] || fail "$*: offers '$got', wanted '$wanted'"
}
offers 'section sensitivity' se
offers 'folder mine.yaml' rod ''
offers 'folder' rod mine.yaml --out ''
offers '--set' rod mine.yaml --s
offers '--markdown' schema --ma
offers '' rod --markd
offers 'fig4 fig4_compliance' example fig
offers 'homogeneous_tube' example hom
offers 'rod.frame=' rod mine.yaml --set rod.fr
offers 'full classical' section mine.yaml --set section.model=
offers 'classical' section mine.yaml --set section.model=cl
offers 'section.shapes.0.' section mine.yaml --set section.shapes.
offers 'section.shapes.0.annulus.outer_radius_mm=' section mine.yaml --set section.shapes.0.annulus.outer
offers 'rod.length_mm= rod.length_m=' rod mine.yaml --set rod.length_m
offers 'gauge_length_mm=' material bar.csv --set gauge
offers 'scan.radius_mm=' scan cloud.ply --set scan.radius
offers '' rod mine.yaml --lines ''
offers '' rod mine.yaml --set nothing.
offers 'bash' completion ba

# every key that is offered is one that the program knows: none is offered that check calls unknown
for key in $("$program" completion words -- check --set section. | sed -n 's/=.*//p'); do
    "$program" check "$source/cases/constant_nc.yaml" --set "$key=0" 2>&1 | grep -q 'unknown key' && fail "$key is offered, and unknown"
done

if command -v zsh >/dev/null; then
    "$program" completion zsh >"$work/_stiffaxis"
    zsh -n "$work/_stiffaxis" || fail 'zsh cannot read its script'
fi
if command -v fish >/dev/null; then
    "$program" completion fish >"$work/stiffaxis.fish"
    PATH=$(dirname "$program"):$PATH
    got=$(HOME=$work fish --no-config -c "source $work/stiffaxis.fish; complete -C 'stiffaxis rod mine.yaml --set rod.fr'" | cut -f 1)
    [ "$got" = 'rod.frame=' ] || fail "fish offers '$got'"
    got=$(HOME=$work fish --no-config -c "source $work/stiffaxis.fish; complete -C 'stiffaxis sec'" | cut -f 1)
    [ "$got" = 'section' ] || fail "fish offers '$got'"
fi
expect 2 "$program" completion tcsh
expect 2 "$program" completion bash fish
expect 0 "$program" completion bash --json
valid_json "$work/out"
finish
