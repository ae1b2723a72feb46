#!/bin/sh
# The print slices of cases/voxel_stack bend as the robot that they were drawn from; slices that are none are refused.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
stack=$source/cases/voxel_stack

# the row of the smallest tension: tip x, y, z in mm
tip() {
    awk '$1 == "0.490" { print $2, $3, $4 }' "$work/out"
}
expect 0 "$program" rod "$stack/voxel_stack.yaml"
printed=$(tip)
expect 0 "$program" rod "$source/cases/helical_nc.yaml" --set section.model=full \
    --set materials.soft.nu=0.3 --set materials.stiff.nu=0.3
# 24 steps for the strip's turn, pixels of a tenth of the wall: 0.5 % of the rod's 120 mm
echo "$printed $(tip)" | awk '
    NF != 6 || ($1 - $4)^2 + ($2 - $5)^2 + ($3 - $6)^2 > 0.6^2 { exit 1 }' ||
    fail "tips at $printed and $(tip) mm"
# every slice is solved once, and the pixels are said to be worth something
expect 0 "$program" section "$stack/voxel_stack.yaml" --set section.model=classical
out '24 sections solved'
out 'pixels twice as wide'
expect 0 "$program" compare "$stack/voxel_stack.yaml"
out 'jumps from slice to slice'

cp "$stack"/*.png "$stack/voxel_stack.yaml" "$work"
printf '#!/bin/sh\ntouch "%s/ran"\n' "$work" >"$work/slice_07.png"
expect 3 "$program" section "$work/voxel_stack.yaml"
err 'slice_07.png: not a PNG image'
one_line
[ ! -e "$work/ran" ] || fail 'a script in an image was run'
head -c 300 "$stack/slice_07.png" >"$work/slice_07.png"
expect 3 "$program" section "$work/voxel_stack.yaml"
err 'slice_07.png: byte 300: not a sound PNG image: the file ends early'
rm "$work/slice_07.png"
expect 2 "$program" check "$work/voxel_stack.yaml"
err 'no slice 7, although there is a slice 8'
expect 2 "$program" check "$stack/voxel_stack.yaml" --set section.png.layer_mm=0
# the order that a case names is the order of its image's elements; order 2 is what an image has without one
cat >"$work/order.yaml" <<EOF
format: 1
materials: {soft: {E_MPa: 0.66, nu: 0.3}, stiff: {E_MPa: 15.93, nu: 0.3}}
section:
  png:
    file: $stack/slice_00.png
    pitch_mm: [0.084, 0.084]
    parts: [{colour: '#ff0000', material: soft}, {colour: '#00ff00', material: stiff}]
EOF
torsion() {
    awk '$1 == "0.000" && NF > 7 { print $8; exit }' "$work/out"
}
expect 0 "$program" section "$work/order.yaml"
none=$(torsion)
expect 0 "$program" section "$work/order.yaml" --set section.mesh.order=2
[ -n "$none" ] && [ "$(torsion)" = "$none" ] || fail "order 2 gives $(torsion), none $none"
expect 0 "$program" section "$work/order.yaml" --set section.mesh.order=1
[ "$(torsion)" != "$none" ] || fail 'order 1 is not heard'
finish
