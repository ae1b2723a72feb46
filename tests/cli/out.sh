#!/bin/sh
# --out writes whole or not at all; --force replaces only what this program wrote; report recomputes nothing.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
case=$source/cases/helical_nc.yaml
dir=$work/results/helical

expect 0 "$program" run "$case" --out "$dir"
for file in result.hdf report.html case.yaml section.svg section.pdf section.png rods.svg rods.pdf rods.png wrench.svg tendons.svg sections.csv rods.csv \
    shapes.csv compare.csv; do
    [ -s "$dir/$file" ] || fail "$file is missing or empty"
done
cmp -s "$case" "$dir/case.yaml" || fail 'case.yaml is not the case'

# a second run finds the sections that the first one solved; a changed one is solved anew
expect 0 "$program" section "$case" --out "$work/results/again"
out 'sections solved'
expect 0 "$program" section "$case" --out "$work/results/again" --force
out '0 sections solved, '
out 'unchanged since the last result'
expect 0 "$program" section "$case" --out "$work/results/again" --force --set materials.soft.nu=0.31
grep -q 'unchanged since' "$work/out" && fail 'a changed material did not lead to new solves'

# an existing directory stays, unless --force, and unless somebody else wrote it
expect 2 "$program" run "$case" --out "$dir"
err '--force'
one_line
echo mine >"$dir/notes"
expect 2 "$program" run "$case" --out "$dir" --force
err "'notes' in it was not written by this program"
one_line
[ "$(cat "$dir/notes")" = mine ] || fail "--force touched the user's file"
rm "$dir/notes"
mkdir "$work/mine"
echo keep >"$work/mine/file"
expect 2 "$program" run "$case" --out "$work/mine" --force
[ "$(cat "$work/mine/file")" = keep ] || fail 'a foreign directory was touched'

# a failure, or Ctrl-C, leaves nothing
expect 4 "$program" run "$source/cases/homogeneous_tube.yaml" --set 'rod.tensions_N=[[4.1]]' --out "$work/failed"
[ ! -e "$work/failed" ] || fail 'a failed run left a directory'
if command -v timeout >/dev/null; then
    expect 130 timeout --preserve-status -s INT 1 "$program" run "$source/cases/fig4.yaml" --set fem.order=4 \
        --set fem.layers=60 --set fem.size_mm=0.5 --out "$work/interrupted"
fi
[ -z "$(find "$work" -name '*.tmp-*' -o -name interrupted)" ] || fail 'something half-written was left behind'

# the page from the stored result alone: the same figures and tables, byte for byte, and no case needed
cp "$dir/result.hdf" "$work/alone.hdf"
expect 0 "$program" report "$work/alone.hdf" --out "$work/again"
for file in section.svg section.pdf rods.svg curvature.svg wrench.svg tendons.svg sections.csv rods.csv shapes.csv; do
    cmp -s "$dir/$file" "$work/again/$file" || fail "$file differs when made again"
done
expect 0 "$program" report "$dir"
[ -s "$dir-report/report.html" ] || fail 'report without --out wrote nothing'
(cd "$dir" && expect 0 "$program" report result.hdf --force && [ "$failures" -eq 0 ]) || fail 'report from inside'
[ ! -e "$dir/result-report" ] || fail 'report wrote into the directory of the results'
expect 0 "$program" report "$work/alone.hdf"
[ -s "$work/alone-report/report.html" ] || fail 'report of a copied result wrote nothing'
expect 0 "$program" run "$case" --out "$dir" --force

# a disk that is full at any point (here: a limit on the size of files): one line, exit code 5, nothing left
for blocks in 0 1 8 40 100 400; do
    expect 5 sh -c 'ulimit -f "$1"; shift; exec "$@"' sh "$blocks" "$program" section "$case" --out "$work/full"
    [ "$blocks" -eq 0 ] || one_line
    [ -z "$(find "$work" -name 'full*')" ] || fail "something was left on a disk of $blocks blocks"
done

# other commands keep their results too
expect 0 "$program" section "$case" --out "$work/section"
[ -s "$work/section/sections.csv" ] || fail 'section --out wrote no table'
expect 0 "$program" schema --out "$work/schema"
valid_json "$work/schema/stiffaxis.schema.json"

# --set is told in the case that is kept
expect 0 "$program" section "$case" --set section.model=full --out "$work/set"
grep -qxF '# --set section.model=full' "$work/set/case.yaml" || fail 'the override is not kept'
finish
