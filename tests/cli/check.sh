#!/bin/sh
# What `check` says it has understood is what the other commands then do.
set -u
leaks=yes
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
cases=$source/cases

expect 0 "$program" check "$cases/fig4.yaml"
out 'fig4.yaml: good: 2 materials, 2 shapes, segment of 20 mm with 2 loads'
out 'soft: E 0.66 MPa, nu 0.3, close to linear up to 5 % of strain'
out 'later ones on top: annulus of soft, sector of stiff'
# the ring of 4 and 3.2 mm has 18.096 mm^2, the sector of pi/8 a sixteenth of it
out '16.965 mm2 of soft, 1.131 mm2 of stiff'
out 'absent       rod, measured, sensitivity, fit, reach'
out "2 loads: 'geometric centre', 'stiffness centre'"
out 'defaults     fem: body along, method auto'
expect 0 "$program" check "$cases/fig4.yaml" --set fem.method=direct
out 'defaults     fem: body along, tolerance'
out 'method direct'

# the unknowns are those that are solved for; `fem` tells them first, then those of every mesh on the way
dofs() {
    sed -n 's/.*"dofs": \([0-9]*\).*/\1/p' "$work/out" | head -1
}
expect 0 "$program" check "$cases/fig4.yaml" --json
foreseen=$(dofs)
expect 0 "$program" fem "$cases/fig4.yaml" --json
[ -n "$foreseen" ] && [ "$foreseen" = "$(dofs)" ] || fail "check foresees $foreseen unknowns, fem has $(dofs)"

# what no machine holds is told before it is tried
expect 0 "$program" check "$cases/fig4.yaml" --set fem.method=direct --set fem.layers=10000 --set fem.size_mm=0.1
out 'more than this machine has'

# paths, solutions and files
expect 0 "$program" check "$cases/pulled_tube.yaml"
out 'wind: from (0, 3.6) to (-3.6, 0) mm, anchored at s = 90 mm, friction 0.15'
out '4 solutions: tensions up to 0.1 N, pulled lengths given; each reached from rest'
expect 0 "$program" check "$cases/precurved.yaml"
out 'curved or twisted at rest, its base placed by `base`'
out 'each reached from the one before it'
expect 0 "$program" check "$cases/voxel_stack/voxel_stack.yaml" --json
out '"slice_%02d.png"'
out '24 slices of 5 mm'
expect 0 "$program" check "$cases/helical_nc.yaml"
out 'classical: integrals of E and G in closed form, Eq. 11 and 12; at stations chosen by how it'

# warnings with their place, in the document too
expect 0 "$program" check "$cases/fig4.yaml" --set fem.length_mm=2 --json
err 'warning: the segment is 0.5 radii long'
out "warning: the segment is 0.5 radii long"

# a long name is cut, and what belongs to it stays
long=$(printf '%0300d' 0 | tr 0 n)
sed "s/soft/$long/g" "$cases/fig4.yaml" >"$work/long.yaml"
expect 0 "$program" check "$work/long.yaml"
cut=$(printf '%060d' 0 | tr 0 n)
out "materials    $cut: E 0.66 MPa, nu 0.3, close to linear"
out "annulus of $cut,"
out "16.965 mm2 of $cut, 1.131 mm2 of stiff"

# a tendon beside a square tube, within the circle around it; in the tube's hollow and in its corner it is inside
sed -e '/^fem:/,$d' -e '/^    - {annulus/d' -e 's/^    - {sector.*/    - {rectangle: {width_mm: 10, height_mm: 10}, material: soft}/' \
    -e 's/{name: t1, radius_mm: 3.6, angle_rad: 0}/{name: right, x_mm: 7, y_mm: 0}/' "$source/tests/data/messages.yaml" >"$work/square.yaml"
echo '    - {rectangle: {width_mm: 8, height_mm: 8}, material: none}' >"$work/hole"
sed -i "/width_mm: 10/r $work/hole" "$work/square.yaml"
for command in check rod; do
    expect 0 "$program" "$command" "$work/square.yaml"
    err "square.yaml:14:7: warning: tendon 'right' runs 7 mm from the centre, outside the section, which reaches 5 mm there"
done
for x in 2 5; do
    expect 0 "$program" check "$work/square.yaml" --set "rod.tendons.right.x_mm=$x"
    [ ! -s "$work/err" ] || fail "x = $x: $(cat "$work/err")"
done
expect 0 "$program" check "$work/square.yaml" --set 'rod.tendons.right={x_mm: 4.9, y_mm: 4.9, name: right}'
[ ! -s "$work/err" ] || fail "corner: $(cat "$work/err")"

# names play with no terminal, however they are written
escaped() {
    sed "s/name: geometric centre/name: \"a$1b\"/" "$cases/fig4.yaml" >"$work/escape.yaml"
    expect 2 "$program" check "$work/escape.yaml"
    err "the control character $2 in a text"
    one_line
}
escaped '\\e[31m' U+001B
escaped '\\u202e' U+202E
escaped '\\u2028' U+2028
escaped '\\r' U+000D
sed 's/name: geometric centre/name: "a\\n error: b\\n"/' "$cases/fig4.yaml" >"$work/escape.yaml"
expect 0 "$program" check "$work/escape.yaml"
out "'a  error: b'"
finish
