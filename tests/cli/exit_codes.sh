#!/bin/sh
# Every class of error has its exit code and one line on stderr.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
cases=$source/cases

# 0
expect 0 "$program" --help
out 'usage: stiffaxis'
expect 0 "$program" rod --help
out 'example'
expect 0 "$program" --version
expect 0 "$program" check "$cases/fig4.yaml"

# 2: usage
expect 2 "$program"
expect 2 "$program" sektion "$cases/fig4.yaml"
err "did you mean 'section'?"
one_line
expect 2 "$program" section "$cases/fig4.yaml" --jsno
err "did you mean '--json'?"
expect 2 "$program" section
expect 2 "$program" section "$cases/fig4.yaml" --out
expect 2 "$program" section "$cases/fig4.yaml" --set model
expect 2 "$program" section "$cases/fig4.yaml" "$cases/fig4.yaml"
expect 2 "$program" section "$cases/fig4.yaml" --json=yes
expect 2 "$program" schema --set a=b
expect 2 "$program" example fig5
err "did you mean 'fig4'?"
expect 2 "$program" rod "$cases/fig4.yaml"
err "the case has no 'rod'"

# 2: case file, with its place
expect 2 "$program" check "$work/missing.yaml"
one_line
sed 's/outer_radius_mm: 4,/outer_radius_mm: 4, outer_radus_mm: 5,/' "$cases/fig4.yaml" >"$work/unknown.yaml"
expect 2 "$program" check "$work/unknown.yaml"
line=$(grep -n outer_radus "$work/unknown.yaml" | head -1 | cut -d: -f1)
err "$work/unknown.yaml:$line:"
err "error: unknown key 'outer_radus_mm' (did you mean 'outer_radius_mm'?)"
one_line
sed 's/material: stiff/material: stif/' "$cases/fig4.yaml" >"$work/material.yaml"
expect 2 "$program" check "$work/material.yaml"
line=$(grep -n 'material: stif}' "$work/material.yaml" | cut -d: -f1)
err "$work/material.yaml:$line:"
one_line
sed 's/format: 1/format: 2/' "$cases/fig4.yaml" >"$work/format.yaml"
expect 2 "$program" check "$work/format.yaml"
expect 2 "$program" section "$cases/fig4.yaml" --set section.modell=full
err "did you mean 'model'?"
expect 2 "$program" section "$cases/helical_nc.yaml" --set section.stations_mm=130
expect 2 "$program" fem "$cases/constant_nc.yaml" --set fem.section_at_mm=130

# 2: what the ranges exclude is refused, however near it lies
tube=$cases/homogeneous_tube.yaml
for change in materials.soft.E_MPa=0 materials.soft.E_MPa=-1e-6 'rod.tensions_N=[[-1e-6]]' \
    section.tolerance=0 rod.tendons.0.end_mm=0 section.shapes.0.annulus.inner_radius_mm=-1e-7; do
    expect 2 "$program" check "$tube" --set "$change"
    err 'out of range'
    one_line
done

# 2: a section that cannot be meshed, at the shape's own place, by check too
cat >"$work/apart.yaml" <<END
format: 1
materials: {soft: {E_MPa: 1, nu: 0.3}}
section:
  shapes:
    - {rectangle: {width_mm: 1, height_mm: 1}, material: soft}
    - {rectangle: {width_mm: 1, height_mm: 1, centre_x_mm: 3}, material: soft}
END
expect 2 "$program" check "$work/apart.yaml"
err "$work/apart.yaml:6:7: error: shape 2 (rectangle): a part of it does not touch"
sed '6s/.*/    - {rectangle: {width_mm: 2, height_mm: 2}, material: none}/' "$work/apart.yaml" >"$work/cut.yaml"
expect 2 "$program" check "$work/cut.yaml"
err 'the section is empty'
sed '5s/.*/    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 4}, material: soft}/;6d' "$work/apart.yaml" \
    >"$work/wall.yaml"
expect 2 "$program" section "$work/wall.yaml"
err "$work/wall.yaml:5:7: error: shape 1 (annulus): its inner_radius of 4 mm"
sed '5s/.*/    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3.999}, material: soft}/;6d' "$work/apart.yaml" \
    >"$work/thin.yaml"
expect 4 "$program" section "$work/thin.yaml"
err "$work/thin.yaml:5:7: error: shape 1: at 0.001 mm it is too thin"
expect 2 "$program" section "$cases/helical_nc.yaml" --set 'section.stations_mm=[300]'
err 'station 300 mm lies outside 0 to 120 mm'

# what hardly was meant is computed, with a warning
expect 0 "$program" rod "$tube" --set rod.tendons.0.radius_mm=4.2 --set 'rod.tensions_N=[[0.01]]'
err "warning: tendon 't1' runs 4.2 mm from the centre, outside the section, which reaches 4 mm there"
one_line
expect 0 "$program" check "$tube" --set fem.length_mm=2
err 'warning: the segment is 0.5 radii long'
out '1 material, 1 shape, rod of 120 mm with 1 tendon, 3 solutions'

# 5: more than memory holds
expect 5 "$program" fem "$cases/fig4.yaml" --set fem.layers=10000 --set fem.order=4 --set fem.method=direct
err 'fewer fem.layers'
one_line

# 3: a damaged or foreign input file
echo 'no HDF5 file' >"$work/result.hdf"
expect 3 "$program" report "$work/result.hdf" --out "$work/report"
one_line

# 4: past the tension at which a tendon eats its own length there is no answer
expect 4 "$program" rod "$cases/homogeneous_tube.yaml" --set 'rod.tensions_N=[[4.1]]'
one_line

# 1: the comparison is told, and out of tolerance (the other programs that it asks have tests of their own)
expect 1 env PATH="$work/nothing" "$program" compare "$cases/fig4.yaml" --set fem.order=1 --set fem.layers=2
out 'OUT'
err 'out of tolerance'

# 5: stdout is full or closed
if [ -e /dev/full ]; then
    "$program" check "$cases/fig4.yaml" >/dev/full 2>"$work/err"
    [ $? = 5 ] || fail 'a full stdout is not exit code 5'
    err 'cannot write to stdout: No space left on device'
    "$program" schema >/dev/full 2>"$work/err"
    [ $? = 5 ] || fail 'a full stdout is not exit code 5 of a long document'
    err 'cannot write to stdout: No space left on device'
fi

# 0: a reader that has seen enough is no error
mkfifo "$work/pipe"
sleep 1 <"$work/pipe" &
(
    exec 3>"$work/pipe"
    wait_for_reader=$!
    while kill -0 "$wait_for_reader" 2>/dev/null; do sleep 0.1; done
    "$program" schema >&3 2>"$work/err"
    echo $? >"$work/code"
)
[ "$(cat "$work/code")" = 0 ] || fail 'a closed pipe is an error'
[ ! -s "$work/err" ] || fail 'a closed pipe is told'

# 130: interrupted
if command -v timeout >/dev/null; then
    expect 130 timeout --preserve-status -s INT 1 "$program" fem "$cases/fig4.yaml" \
        --set fem.order=4 --set fem.layers=60 --set fem.size_mm=0.5
    err 'interrupted'
fi
finish
