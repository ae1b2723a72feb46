#!/bin/sh
# The pages say what is so: every command that they show is run, outputs are compared, cases checked, links followed. The rules
# stand in tests/docs/docs.py. Outputs are written anew by
#   STIFFAXIS=build/release/bin/stiffaxis STIFFAXIS_SOURCE=$PWD sh tests/cli/docs.sh --update [PAGE...]
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
export PYTHONDONTWRITEBYTECODE=1
program=$(realpath "$program")
command -v python3 >/dev/null || {
    echo 'docs: left out, no python3'
    exit 0
}
runner=$source/tests/docs/docs.py
update=
[ "${1:-}" != --update ] || {
    update=--update
    shift
}

# --- the runner fails where it should: a small repository with a page that is right, and one with a mistake in every block

small=$work/small
mkdir -p "$small/cases" "$small/tests" "$small/docs" "$work/scratch" "$work/scratch_good" "$work/scratch_bad" "$work/scratch_update"
cp "$source/cases/fig4.yaml" "$small/cases"
cp -r "$source/run" "$source/bench" "$small"
cp "$source/tests/docs/good.md" "$source/tests/docs/bad.md" "$small/docs"
echo 'stiffaxis fem cases/fig4.yaml' >"$small/tests/other.sh"
expect 0 python3 "$runner" "$small" "$program" "$work/scratch_good" docs/good.md
out '2 commands, 0 again, 1 elsewhere, 0 short, 2 outputs, 0 cases, 1 parts, 0 python, 1 not run'
out 'docs/good.md:29: not run: a reason'
expect 1 python3 "$runner" "$small" "$program" "$work/scratch_bad" docs/bad.md
while read -r words; do
    out "$words"
done <<'END_OF_WORDS'
docs/bad.md:3: dead link: bad.md#another: no such heading
docs/bad.md:3: dead link: pages.md
docs/bad.md:3: https:/example.org is no link
docs/bad.md:3: cases/fig5.yaml is named and not there
docs/bad.md:4: exit code 2, not 0: stiffaxis sections --help
docs/bad.md:4: exit code 2, not 0: stiffaxis section cases/fig4.yaml --set fem.length=3
docs/bad.md:4: ./run knows no benches
docs/bad.md:4: ./run bench knows no colours
not said: 0.000     29.215
but: 0.000     29.213
not said: 0.000     29.213  -2.1233   0.0000  180.000     81.236     170.34         66
not said: shear stiffness there: 2.13825 N along x'', 2.86797 N across y''
not said: (the end; said next:
docs/bad.md:18: exit code 2, not 3
docs/bad.md:22: exit code 2, not 0
docs/bad.md:26: changes the machine
docs/bad.md:31: tests/others.sh is to run this and is not there
docs/bad.md:36: tests/other.sh is to run this and does not hold "rod cases/fig4.yaml"
docs/bad.md:41: not run, and no reason why
did you mean 'length_mm'
docs/bad.md:51: part of a case: which one?
docs/bad.md:56: a block of no language: neither output nor run
docs/bad.md:61: cases/fig4.yaml
docs/bad.md:67: results/none.svg was not made
docs/bad.md:71: a fence of ~~~
docs/bad.md:75: commands that are only indented
docs/bad.md:79: a fence further in than 3 spaces
docs/bad.md:82: a link by reference
docs/bad.md:82: a link in HTML
docs/bad.md:84: a link by reference
END_OF_WORDS
[ "$(grep -c '^docs/bad.md:[0-9]*: ' "$work/out")" = 31 ] || fail 'another number of mistakes'
# --update mends outputs, keeps what was left out and changes nothing else
sed -i 's/29.213 /29.315 /; s/65  -0/66  -0/' "$small/docs/good.md"
expect 0 python3 "$runner" --update "$small" "$program" "$work/scratch_update" docs/good.md
sed 's/81.235/81.236/' "$source/tests/docs/good.md" | cmp -s - "$small/docs/good.md" ||
    fail "--update: $(diff "$source/tests/docs/good.md" "$small/docs/good.md")"

# --- the pages

cd "$source" || exit 1
[ $# -gt 0 ] || set -- README.md docs/README.md docs/tutorial_*.md docs/*.md python/README.md docs/decisions/*.md
pages=
for page in "$@"; do
    case " $pages " in *" $page "*) continue ;; esac
    [ ! -f "$page" ] || pages="$pages $page"
done
# shellcheck disable=SC2086
python3 "$runner" ${update:+"$update"} ${STIFFAXIS_TIMES:+--times} "$source" "$program" "$work/scratch" $pages || failures=1
finish
