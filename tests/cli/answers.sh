#!/bin/sh
# What a case asks of its section: stiffness about places, strains and stresses under wrenches.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

cat >"$work/bar.yaml" <<'END'
format: 1
materials: {steel: {E_GPa: 210, nu: 0.3, density_kg_per_m3: 7850, linear_strain: 0.001}}
section:
  shapes:
    - {rectangle: {width_mm: 20, height_mm: 8}, material: steel}
  points_mm: [[10, 4]]
  wrenches:
    - {name: pull, force_N: [0, 0, 4000]}
    - {name: bend, moment_Nmm: [30000, 0, 0]}
    - {name: beside, force_N: [0, 0, 4000], at_mm: [0, 2]}
    - {name: at centre, force_N: [0, 0, 4000], at: stiffness_centre}
END

expect 0 "$program" section "$work/bar.yaml"
out "wrench 'bend'"
out 'shear stiffness'
out 'about (10, 4) mm'
expect 0 "$program" section "$work/bar.yaml" --json
valid_json "$work/out"
cp "$work/out" "$work/bar.json"

# nobody asks: nothing is solved again, nothing is said
expect 0 "$program" section "$source/cases/constant_nc.yaml"
! grep -q wrench "$work/out" || fail 'wrenches that nobody asked for'

expect 0 "$program" section "$work/bar.yaml" --out "$work/bar"
paper "$work/bar"
for file in stresses.csv kern.csv stresses.svg; do
    [ -s "$work/bar/$file" ] || fail "no $file"
done
expect 0 "$program" report "$work/bar/result.hdf" --out "$work/again"
cmp -s "$work/bar/stresses.svg" "$work/again/stresses.svg" || fail 'the stored fields give another picture'

# the model of the paper has strains too, but no warping constant
expect 0 "$program" section "$work/bar.yaml" --json --set section.model=classical
out '"EI_warping_Nm4": null'

expect 2 "$program" check "$work/bar.yaml" --set 'section.wrenches=[{name: a}]'
err 'neither force nor moment'
expect 2 "$program" check "$work/bar.yaml" \
    --set 'section.wrenches=[{name: a, force_N: [1, 0, 0]}, {name: a, force_N: [1, 0, 0]}]'
err 'two wrenches'
expect 2 "$program" check "$work/bar.yaml" \
    --set 'section.wrenches=[{name: a, force_N: [1, 0, 0], at: stiffness_centre, at_mm: [0, 0]}]'

if command -v python3 >/dev/null; then
    python3 - "$work/bar.json" <<'END' || fail 'the numbers are not as they should be'
import json, sys
s = json.load(open(sys.argv[1]))["stations"][0]
b, h = 20e-3, 8e-3
near = lambda a, b, tol=1e-9: abs(a - b) <= tol * abs(b)
assert near(s["mass_kg_per_m"], 7850 * b * h)
assert near(s["mass_matrix"][3][3], 7850 * b * h**3 / 12)
wanted = [(b / 6, 0), (-b / 6, 0), (0, h / 6), (0, -h / 6)]
assert len(s["kern_m"]) == 4
for x, y in wanted:
    assert min(abs(x - p[0]) + abs(y - p[1]) for p in s["kern_m"]) < 1e-9 * b, (x, y)
w = {x["name"]: x["materials"][0] for x in s["wrenches"]}
pull, bend = 4000 / (b * h), 30 / (b * h**2 / 6)
assert near(w["pull"]["von_mises_Pa"]["value"], pull)
assert near(w["bend"]["axial_stress_highest_Pa"]["value"], bend)
assert near(w["bend"]["axial_stress_highest_Pa"]["at_m"][1], h / 2)
assert near(w["beside"]["axial_stress_highest_Pa"]["value"], pull * (1 + 12 * 2e-3 * 4e-3 / h**2))
assert near(w["at centre"]["axial_stress_lowest_Pa"]["value"], pull)
assert near(w["bend"]["largest_strain"]["value"] ** 2, (bend / 210e9) ** 2)
K = s["points"][0]["K"]
assert near(K[3][3], 210e9 * b * h * (h**2 / 12 + 4e-3**2), 1e-8)
assert len(s["K_principal"]) == 6 and s["turn_rate_rad_per_m"] == 0
END
fi

finish
