#!/bin/sh
# The pages say what is so: every command that they show is run, outputs are compared, cases checked, links followed. The rules
# stand in tests/docs/docs.py; what follows first is pages with one mistake each. Outputs are written anew by
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

# --- the runner fails where it should: page NAME, read from stdin, in a small repository

small=$work/small
mkdir -p "$small/cases" "$small/tests" "$small/docs"
cp "$source/cases/fig4.yaml" "$small/cases"
echo 'stiffaxis fem cases/fig4.yaml' >"$small/tests/other.sh"

# mistake CODE WORDS: the page from stdin ends so
mistake() {
    cat >"$small/docs/page.md"
    rm -rf "$work/scratch_small" && mkdir "$work/scratch_small"
    expect "$1" python3 "$runner" "$small" "$program" "$work/scratch_small" docs/page.md
    out "$2"
}

good() {
    sed -n '/^#GOOD/,/^#END/{/^#[A-Z]/!p}' "$0"
}
: <<'#END'
#GOOD
# A page

[itself](page.md#a-page), [far](https://example.org/x), cases/fig4.yaml

```sh
stiffaxis section cases/fig4.yaml     # with a comment
```

```text
section: full (warping), 1 station, 1 section solved
...
    0.000     29.213  -2.1233   0.0000  180.000     81.235     170.34         65  -0.5565   0.0000  ...
...
shear stiffness there: 2.13825 N along x'', 2.86797 N along y'', x'' turned by 180.000 deg
```

<!-- exit 2 -->
```console
$ stiffaxis section none.yaml
...
```

<!-- run by tests/other.sh: fem cases/fig4.yaml -->
```sh
stiffaxis fem cases/fig4.yaml
```

<!-- in cases/fig4.yaml -->
```yaml
fem:
  length_mm: 30
```
#END
good | mistake 0 '1 elsewhere'
good | sed 's/29.213 /29.215 /' | mistake 1 'docs/page.md:9: stiffaxis section'
good | sed 's/1 station,/2 station,/' | mistake 1 'but: section: full (warping), 1 station, 1 section solved'
good | sed 's/along y/across y/' | mistake 1 'not said: shear stiffness there'
good | sed '$!N; /^\.\.\.\nshear/d; P; D' | mistake 1 'not said'
good | sed 's/exit 2/exit 3/' | mistake 1 'exit code 2, not 3'
good | sed 's/page.md#a-page/page.md#another/' | mistake 1 'dead link: page.md#another: no such heading'
good | sed 's/(page.md#a-page/(pages.md/' | mistake 1 'dead link: pages.md'
good | sed 's,https://example,https:/example,' | mistake 1 'is no link'
good | sed 's,^\(.itself.*\)cases/fig4,\1cases/fig5,' | mistake 1 'cases/fig5.yaml is named and not there'
good | sed 's/run by tests.*-->/not run: -->/' | mistake 1 'not run, and no reason why'
good | sed 's/run by tests.*-->/not run: a reason -->/' | mistake 0 'not run: a reason'
good | sed 's/other.sh: fem/others.sh: fem/' | mistake 1 'tests/others.sh is to run this and is not there'
good | sed 's/other.sh: fem/other.sh: rod/' | mistake 1 'does not hold "rod cases/fig4.yaml"'
good | sed 's/length_mm: 30/lenght_mm: 30/' | mistake 1 "did you mean 'length_mm'"
good | sed '/in cases.fig4/d' | mistake 1 'part of a case: which one?'
good | sed 's/^```yaml/```/; /in cases.fig4/d' | mistake 1 'neither output nor run'
good | sed 's/section cases/sections cases/' | mistake 1 'exit code 2, not 0'
# --update mends numbers, keeps what was left out, and does not take other words for a number
good | sed 's/29.213 /29.315 /; s/65  -0/66  -0/' >"$small/docs/page.md"
rm -rf "$work/scratch_small" && mkdir "$work/scratch_small"
expect 0 python3 "$runner" --update "$small" "$program" "$work/scratch_small" docs/page.md
good >"$work/good.md"
[ "$(diff "$work/good.md" "$small/docs/page.md" | grep -c '^>')" = 1 ] || fail "--update: $(diff "$work/good.md" "$small/docs/page.md")"
cp "$small/docs/page.md" "$work/renewed.md"
mistake 0 '2 outputs' <"$work/renewed.md"

# --- the pages

cd "$source" || exit 1
[ $# -gt 0 ] || set -- README.md docs/README.md docs/tutorial_*.md docs/*.md python/README.md docs/decisions/*.md
pages=
for page in "$@"; do
    case " $pages " in *" $page "*) continue ;; esac
    [ ! -f "$page" ] || pages="$pages $page"
done
mkdir "$work/scratch"
# shellcheck disable=SC2086
python3 "$runner" ${update:+"$update"} ${STIFFAXIS_TIMES:+--times} "$source" "$program" "$work/scratch" $pages || failures=1
finish
