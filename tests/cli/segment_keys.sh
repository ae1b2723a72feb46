#!/bin/sh
# Loads, supports and methods of the 3D segment: what a case may say, and where contradictions are told.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

# tell NAME REST: a case; REST follows its section, from line 8 on
tell() {
    cat >"$work/$1.yaml" <<'END'
format: 1
materials:
  wall: {E_MPa: 0.66, nu: 0.45, density_kg_per_m3: 1070}
  core: {E_MPa: 0.66, nu: 0.45}
section:
  shapes:
    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3}, material: wall}
END
    echo "$2" >>"$work/$1.yaml"
}

# refused FEM LINE:COL WORDS: a segment of 20 mm with these keys, in line 8
refused() {
    tell refused "fem: {length_mm: 20, $1}"
    expect 2 "$program" check "$work/refused.yaml"
    err "$work/refused.yaml:$2: error: "
    err "$3"
    one_line
}
push='{name: push, force_N: [0, 0, -0.5]}'

tell whole 'fem:
  length_mm: 20
  base: free
  tip: E_proportional
  method: direct
  tolerance: 1e-3
  mixed: auto
  body: prism
  stress: true
  tip_spring: {translation_N_per_mm: [1, 1, 0], rotation_Nmm_per_rad: [0, 0, 5]}
  springs: [{face: base, normal_N_per_mm3: 2, tangential_N_per_mm3: 1}]
  holds: [{face: outside, to_mm: 2, motion_mm: [0, ~, 0.1]}]
  loads:
    - {name: lumen, pressures: [{face: hole_1, from_mm: 2, pressure_kPa: 20}, {face: tip, traction_Pa: [0, 0, 9]}]}
    - {name: weight, acceleration_m_per_s2: [0, -9.81, 0], body_force_N_per_m3: [0, 0, 1]}
    - {name: bent, force_N: [0, 0, -0.1], tip_motion: {translation_mm: [1, ~, ~], rotation_deg: [0, ~, ~]}}
    - {name: moved, move_holds: true}'
expect 0 "$program" check "$work/whole.yaml"

# what no single key shows
refused 'loads: [{name: idle}]' 8:30 "load 'idle' has neither force nor moment"
refused "base: free, loads: [$push]" 8:1 'nothing else holds the segment'
refused "tip: free, loads: [$push]" 8:41 'nothing acts on a free tip'
refused 'tip: free, loads: [{name: a, tip_motion: {translation_mm: [1, ~, ~]}}]' 8:51 'a motion needs a tip'
refused 'loads: [{name: a, force_N: [1, 0, 0], tip_motion: {translation_mm: [1, ~, ~]}}]' 8:60 'a motion and a force along x in the same direction'
refused 'loads: [{name: a, at_mm: [1, 0], tip_motion: {translation_mm: [1, ~, ~]}}]' 8:55 'leave `at` out'
refused 'loads: [{name: a, pressures: [{face: base, pressure_MPa: 1}]}]' 8:52 'on the base, which is held'
refused 'loads: [{name: a, pressures: [{face: inside, to_mm: 30, pressure_MPa: 1}]}]' 8:52 '30 mm lies beyond the segment'
refused 'loads: [{name: a, pressures: [{face: tip, to_mm: 3, pressure_MPa: 1}]}]' 8:52 'an end has no heights'
refused "loads: [$push], holds: [{face: tip, motion_mm: [0, 0, 0]}]" 8:76 'the tip is a rigid cap'
refused "loads: [$push], holds: [{face: outside, motion_mm: [0, 0, 1]}]" 8:76 'the hold moves in no load'
refused 'loads: [{name: a, move_holds: true}]' 8:30 'there are no `holds` to move'
refused "loads: [$push], springs: [{face: outside}]" 8:78 'the spring has no stiffness'
refused "tip: uniform, loads: [$push], tip_spring: {translation_N_per_mm: [1, 0, 0]}" 8:82 'a spring needs a tip'
refused 'method: doubling, loads: [{name: a, pressures: [{face: inside, pressure_MPa: 1}]}]' 8:48 'method doubling takes tip loads only'

# what single keys show
refused 'loads: [{name: a, pressures: [{face: insde, pressure_MPa: 1}]}]' 8:59 "did you mean 'inside'?"
refused 'loads: [{name: a, pressures: [{face: inside, pressure_MPa: 1, traction_MPa: [0, 0, 1]}]}]' 8:84 "'pressure_MPa' and 'traction_MPa' exclude each other"
refused 'loads: [{name: a, pressures: [{face: inside, pressure: 1}]}]' 8:67 "key 'pressure' needs its unit"
refused "method: magic, loads: [$push]" 8:30 'expected one of auto, doubling, direct, iterative'
refused "tolerance: 1e-12, loads: [$push]" 8:33 'out of range'

# gravity needs densities
sed 's/material: wall/material: core/' "$work/whole.yaml" >"$work/light.yaml"
expect 2 "$program" check "$work/light.yaml"
err "$work/light.yaml:4:3: error: 'core' needs its \`density_kg_per_m3\`"
one_line

# past the rod's tip nothing says what a section that varies is
tell long "rod: {length_mm: 15}
fem: {length_mm: 20, loads: [$push]}"
expect 0 "$program" check "$work/long.yaml"
sed -i 's/inner_radius_mm: 3/inner_radius_mm: 3 + 0.02*s/' "$work/long.yaml"
expect 2 "$program" check "$work/long.yaml"
err "$work/long.yaml:9:1: error: the segment ends at 20 mm, beyond the rod's 15 mm"
expect 0 "$program" check "$work/long.yaml" --set fem.body=prism
finish
