#!/bin/sh
# Curved shapes and DXF drawings from the case file on: numbers of the section, exit codes, and one line for each mistake.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

expect 0 "$program" section "$source/cases/multilumen.yaml"
out '515.83' # EA, as the free mesh of any order gives it
expect 0 "$program" section "$source/cases/multilumen.yaml" --set section.mesh.order=3
out '515.83'
# which shape, which copy
expect 2 "$program" section "$source/cases/multilumen.yaml" --set section.shapes.1.array.radius_mm=1
err 'shape 2 (rounded_rectangle, copy 2): a part of it does not touch the rest of the section'
sed 's/, material: body}/}/' "$source/cases/multilumen.yaml" >"$work/bare.yaml"
expect 2 "$program" check "$work/bare.yaml"
err "bare.yaml:14:7: error: key 'material' is missing in this entry of 'shapes'"

# pairs of a DXF file, one word a line
dxf() {
    printf '%s\n' "0 SECTION 2 ENTITIES $* 0 ENDSEC 0 EOF" | tr ' ' '\n' >"$work/drawing.dxf"
}
cat >"$work/case.yaml" <<'END'
format: 1
title: a drawing
materials:
  soft: {E_MPa: 1, nu: 0.3}
section:
  dxf: {file: drawing.dxf}
END
dxf 0 CIRCLE 8 soft 10 0 20 0 40 2 0 CIRCLE 8 none 10 0 20 0 40 1
expect 0 "$program" section "$work/case.yaml"
out '9.42' # N: 1 MPa on pi (4 - 1) mm^2
expect 0 "$program" section "$work/case.yaml" --set section.dxf.unit=in
out '6080.5' # 25.4^2 times as much
dxf 0 LINE 8 soft 10 0 20 0 11 1 21 0
expect 3 "$program" section "$work/case.yaml"
err "drawing.dxf:5: in layer 'soft' the outline is open at (0, 0)"
dxf 0 CIRCLE 8 wall 10 0 20 0 40 2
expect 3 "$program" check "$work/case.yaml"
err "the layer 'wall' has no material"

# a script, whatever it is called, is read as what it is not
printf 'SystemCall("touch %s");\n' "$work/witness" >"$work/drawing.dxf"
expect 3 "$program" section "$work/case.yaml"
err 'drawing.dxf:1: a group code is expected here: this is no ASCII DXF file'
[ ! -e "$work/witness" ] || fail 'the drawing ran a program'

finish
