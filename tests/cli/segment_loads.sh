#!/bin/sh
# Pressures, gravity, imposed motions, springs: the answers have the right signs and sizes.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

expect 0 "$program" fem "$source/cases/bending_actuator.yaml" --set fem.order=2 --json
if command -v python3 >/dev/null; then
    python3 - "$work/out" <<'END' || fail 'the actuator is not what a beam says'
import json, math, sys
d = json.load(open(sys.argv[1]))
air, wound, weight, held = d["loads"]
R, r, x, L, E, p, rho, g = 5e-3, 1.5e-3, 2.5e-3, 40e-3, 0.25e6, 10e3, 1070, 9.81
A, a = math.pi * R**2, math.pi * r**2
centre = -a * x / (A - a)
Iy = math.pi / 4 * R**4 - math.pi / 4 * r**4 - a * x**2 - (A - a) * centre**2
Ix = math.pi / 4 * (R**4 - r**4)
turn = -p * a * (x - centre) * L / (E * Iy)
assert 0.9 < wound["tip_rotation_rad"][1] / turn < 1.05, (wound["tip_rotation_rad"], turn)
# of the plain wall's bending 1 - 2 nu is left, and what the two ends do not let widen, some radii of the length
plain = air["tip_rotation_rad"][1] / turn
assert 0.02 < plain < 0.25, plain
# a cantilever under its weight, shear and a clamped end aside
sag = -rho * (A - a) * g * L**4 / (8 * E * Ix)
assert 0.9 < weight["tip_displacement_m"][1] / sag < 1.25, (weight["tip_displacement_m"], sag)
u = held["tip_displacement_m"]
assert abs(u[0] - 2e-3) < 1e-9 and abs(u[1]) < 1e-9
END
fi

# an E-proportional pull through a spring: two springs in a row
cat >"$work/bar.yaml" <<'END'
format: 1
materials: {m: {E_MPa: 1, nu: 0}}
section:
  shapes:
    - {rectangle: {width_mm: 2, height_mm: 2}, material: m}
fem:
  length_mm: 10
  tip: E_proportional
  loads: [{name: pull, force_N: [0, 0, 0.4]}]
END
coarse='--set fem.order=2 --set fem.layers=6' # these answers are exact on any mesh
shortening() {
    expect 0 "$program" fem "$@" $coarse --json
    sed -n 's/.*"shortening_m": *\([-0-9.e]*\).*/\1/p' "$work/out" | head -1
}
near() { # NAME VALUE WANTED
    awk -v a="$2" -v b="$3" 'BEGIN { d = a - b; if (d < 0) d = -d; exit !(d < 1e-6 * (b < 0 ? -b : b)) }' ||
        fail "$1: $2, wanted $3"
}
near 'bar' "$(shortening "$work/bar.yaml")" -1e-3                                # F L / E A
near 'spring' "$(shortening "$work/bar.yaml" --set 'fem.tip_spring={translation_N_per_mm: [0, 0, 0.4]}')" -5e-4
near 'moved' "$(shortening "$work/bar.yaml" --set 'fem.loads=[{name: m, tip_motion: {translation_mm: [~, ~, 3]}}]')" -3e-3
near 'traction' "$(shortening "$work/bar.yaml" --set 'fem.tip=free' \
    --set 'fem.loads=[{name: t, pressures: [{face: tip, traction_MPa: [0, 0, 0.1]}]}]')" -1e-3
near 'volume' "$(shortening "$work/bar.yaml" --set 'fem.loads=[{name: v, body_force_N_per_mm3: [0, 0, 0.01]}]')" -5e-4
near 'foundation' "$(shortening "$work/bar.yaml" --set fem.base=free --set fem.tip=rigid \
    --set 'fem.springs=[{face: base, normal_N_per_mm3: 0.1, tangential_N_per_mm3: 0.1}]')" -2e-3
near 'hold' "$(shortening "$work/bar.yaml" --set fem.base=free --set 'fem.holds=[{face: base, motion_mm: [0, 0, 0]}]')" -1e-3
near 'moved hold' "$(shortening "$work/bar.yaml" --set fem.base=free \
    --set 'fem.holds=[{face: base, motion_mm: [0, 0, 0.5]}]' --set 'fem.loads=[{name: m, move_holds: true}]')" -5e-4
# a hole that is not there
expect 2 "$program" fem "$work/bar.yaml" --set 'fem.loads=[{name: p, pressures: [{face: hole_2, pressure_kPa: 1}]}]'
err 'no hole 2'
one_line

# a sleeve, a foundation, a spring on the tip: they take a part of what acts on the tip, and the middle has no law;
# such a result is stored, and read again
for support in 'holds=[{face: outside, from_mm: 6, motion_mm: [0, 0, ~]}]' \
    'springs=[{face: outside, normal_N_per_mm3: 1, tangential_N_per_mm3: 1}]' 'springs=[{face: tip, normal_N_per_mm3: 1}]'; do
    expect 0 "$program" fem "$work/bar.yaml" $coarse --set "fem.$support" --json
    out '"stiffness_centre_m": [null'
    expect 0 "$program" fem "$work/bar.yaml" $coarse --set "fem.$support" --out "$work/held" --force
    expect 0 "$program" report "$work/held" --force
    grep -qi '(nan' "$work"/held*/report.html && fail "the page shows what is not known: $support"
done

# a pressure on all walls balances itself: what misses is measured by what it stores
expect 0 "$program" fem "$work/bar.yaml" $coarse --set 'fem.loads=[{name: p, pressures: [{face: outside, pressure_kPa: 10}]}]' --json
balance=$(sed -n 's/.*"balance": *\([-0-9.e]*\).*/\1/p' "$work/out" | head -1)
awk -v b="$balance" 'BEGIN { exit !(b != "" && b + 0 < 1e-9) }' || fail "balance of a pressure: $balance"

# one mesh alone says nothing about its errors
expect 0 "$program" fem "$work/bar.yaml" --set fem.order=1 --json
out '"shortening_error_m": null'
finish
