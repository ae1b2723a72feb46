#!/bin/sh
# The cases run to the end with every comparison within its tolerance; the catheter goes through gmsh.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

for name in fig4 homogeneous_tube; do
    expect 0 "$program" run "$source/cases/$name.yaml" --out "$work/$name"
    paper "$work/$name"
    [ "$(wc -l <"$work/out")" -le 24 ] || fail "$name: the summary is longer than 24 lines"
    [ -s "$work/$name/report.html" ] || fail "$name: no page"
done
for figure in section segment; do
    [ -s "$work/fig4/$figure.svg" ] || fail "fig4: no $figure.svg"
done
# README shows it as it is drawn now (tests/docs/pictures.py --update makes it anew)
if command -v python3 >/dev/null; then
    expect 0 env PYTHONDONTWRITEBYTECODE=1 python3 "$source/tests/docs/pictures.py" "$work/fig4/segment.png" "$source/docs/fig4.png" 2
    [ "$(wc -c <"$source/docs/fig4.png")" -lt 150000 ] || fail 'docs/fig4.png is too heavy for a page'
fi
expect 0 "$program" run "$source/cases/fig4.yaml" --lines 5
[ "$(wc -l <"$work/out")" -le 5 ] || fail '--lines 5 is not kept'

# the other programs that comparisons ask have tests of their own; here they are not installed
alone() {
    env PATH="$work/nothing" "$program" "$@"
}

# no false alarm at any pair of ends: the segment's ends differ from the beam by physics, not by error
sed 's/, at_mm: .*}/}/; /name: stiffness centre/d' "$source/cases/fig4.yaml" >"$work/uniform.yaml" # takes no place
for base in clamped free_to_contract; do
    for tip in rigid E_proportional uniform; do
        file=$source/cases/fig4.yaml
        [ "$tip" != uniform ] || file=$work/uniform.yaml
        ratios=0.45
        ! long || ratios="0.3 0.45"
        for nu in $ratios; do
            expect 0 alone compare "$file" --set fem.base=$base --set fem.tip=$tip --set materials.soft.nu=$nu
            out 'tip compliance axial'
        done
    done
done
# nor where the moduli lie far apart, the segment is short, the wall thin or the section's mesh of order 1
expect 0 alone compare "$source/cases/fig4.yaml" --set materials.stiff.E_MPa=10000
out 'no verdict'
expect 0 alone compare "$source/cases/fig4.yaml" --set materials.stiff.E_MPa=32 --set materials.soft.nu=0.45
expect 0 alone compare "$source/cases/fig4.yaml" --set fem.length_mm=2
out 'all end layers'
sed 's/inner_radius_mm: 3.2/inner_radius_mm: 3.92/g' "$source/cases/fig4.yaml" >"$work/thin.yaml"
expect 0 alone compare "$work/thin.yaml"
expect 0 alone compare "$source/cases/constant_nc.yaml" --set section.mesh.order=1
# but a 3D mesh that is too coarse does not count as agreement
expect 1 alone compare "$source/cases/fig4.yaml" --set fem.order=1
err 'section: EA, ours (full) against 3D FEM'
out 'too coarse to tell'

# order 2 keeps the catheter's 3D segment small enough for a test
expect 0 "$program" section "$source/cases/catheter.yaml"
expect 0 "$program" rod "$source/cases/catheter.yaml"
expect 0 "$program" fem "$source/cases/catheter.yaml" --set fem.order=2
finish
