#!/bin/sh
# Materials of every kind: what a case may say, and what is refused with its place.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

cat >"$work/ply.yaml" <<'END'
format: 1
materials:
  ply: {E1_MPa: 41000, E2_MPa: 10400, E3_MPa: 9100, G12_MPa: 4300, G13_MPa: 4100, G23_MPa: 3500, nu12: 0.28, nu13: 0.31, nu23: 0.45, density_g_per_cm3: 1.9}
  soft: {E_MPa: "1 + 100*x", nu: 0.3, density_kg_per_m3: 1100}
  step: {E_table: {along: y, at_mm: [-2, 0, 2], E_MPa: [1, 2, 4]}, nu: 0.4}
  full: {stiffness_MPa: [[4,2,2,0,0,0],[2,4,2,0,0,0],[2,2,4,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,1]], plane_angle_deg: 20}
section:
  mesh: {order: 2}
  shapes:
    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3}, material: ply, axes: tangent, fibre_angle_deg: 30}
    - {sector: {outer_radius_mm: 4, inner_radius_mm: 3, mid_angle_deg: 0, width_deg: 40}, material: soft}
    - {sector: {outer_radius_mm: 4, inner_radius_mm: 3, mid_angle_deg: 90, width_deg: 40}, material: step}
    - {sector: {outer_radius_mm: 4, inner_radius_mm: 3, mid_angle_deg: 180, width_deg: 40}, material: full, plane_angle_deg: 10}
END
expect 0 "$program" check "$work/ply.yaml"
expect 0 "$program" section "$work/ply.yaml"
expect 0 "$program" section "$work/ply.yaml" --set section.model=classical

refused() { # key=value, words
    expect 2 "$program" check "$work/ply.yaml" --set "$1"
    one_line
    err "$2"
}
refused materials.ply.nu12=2.1 "material 'ply': nu12 = 2.1 breaks nu12^2 < E1/E2 = 3.94"
refused materials.ply.nu23=1.06 'it must be more than 0'
refused materials.ply.E_MPa=3 "exclude each other"
refused materials.ply.nu=0.3 "material 'ply': nu does not belong here"
refused materials.soft.nu=0.5 'nu = 0.5 breaks -1 < nu < 0.5'
refused materials.soft.E_MPa=1+q "unknown name 'q'"
refused 'materials.step.E_table.at_mm=[0, 0, 2]' 'must ascend'
refused 'materials.step.E_table.E_MPa=[1, 2]' 'a table of 3 places needs as many values'
refused materials.step.density_kg_m3=3 "did you mean 'density_kg_per_m3'?"
refused 'section.shapes.0.axes=radial' "'axes'"

sed 's/G13_MPa: 4100, //' "$work/ply.yaml" >"$work/missing.yaml"
expect 2 "$program" check "$work/missing.yaml"
err "$work/missing.yaml:3:3: error: material 'ply': G13 is missing"
sed 's/\[\[4,2,2/[[4,2,9/' "$work/ply.yaml" >"$work/lopsided.yaml"
expect 2 "$program" check "$work/lopsided.yaml"
err "$work/lopsided.yaml:6:3: error: material 'full': stiffness: it must be symmetric"

# a modulus that is none is found where the section lies
sed 's/1 + 100\*x/1 - 400*x/' "$work/ply.yaml" >"$work/negative.yaml"
expect 2 "$program" section "$work/negative.yaml"
one_line
err "$work/negative.yaml:4:3: error: material 'soft': E = -"

# x and y are metres: who writes millimetres is told, and only then
sed 's/1 + 100\*x/1 + x/' "$work/ply.yaml" >"$work/hardly.yaml"
expect 0 "$program" section "$work/hardly.yaml"
err "warning: E of 'soft' is given over x or y, but changes by less than 0.01"
expect 0 "$program" section "$work/ply.yaml"
grep -q 'changes by less' "$work/err" && fail 'a graded material is taken for a mistake'

# the 3D segment is made of all of them
printf 'fem:\n  length_mm: 30\n  order: 2\n  layers: 6\n  loads: [{name: pull, force_N: [0, 0, 1]}]\n' >>"$work/ply.yaml"
expect 0 "$program" fem "$work/ply.yaml"
out 'pull'

finish
