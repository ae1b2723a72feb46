#!/bin/sh
# The cases run to the end with every comparison within its tolerance; the catheter goes through gmsh.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

for name in fig4 homogeneous_tube; do
    expect 0 "$program" run "$source/cases/$name.yaml" --out "$work/$name"
    [ "$(wc -l <"$work/out")" -le 24 ] || fail "$name: the summary is longer than 24 lines"
    [ -s "$work/$name/report.html" ] || fail "$name: no page"
done
for figure in section segment; do
    [ -s "$work/fig4/$figure.svg" ] || fail "fig4: no $figure.svg"
done
expect 0 "$program" run "$source/cases/fig4.yaml" --lines 5
[ "$(wc -l <"$work/out")" -le 5 ] || fail '--lines 5 is not kept'

# order 2 keeps the catheter's 3D segment small enough for a test
expect 0 "$program" section "$source/cases/catheter.yaml"
expect 0 "$program" rod "$source/cases/catheter.yaml"
expect 0 "$program" fem "$source/cases/catheter.yaml" --set fem.order=2
finish
