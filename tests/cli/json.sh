#!/bin/sh
# --json prints exactly one JSON document with the promised keys, also where the program fails.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
cases=$source/cases

# document CODE KEYS COMMAND...: stdout is one document that has all the keys
document() {
    wanted_code=$1 keys=$2
    shift 2
    expect "$wanted_code" "$@"
    valid_json "$work/out"
    for key in $keys; do
        out "\"$key\""
    done
}

section='schema stations s_m area_m2 EA_N stiffness_centre_m principal_angle_rad EI_Nm2 EI_centre_Nm2 GJ_Nm2
    shear_centre_m K relative_error'
rod='schema solutions tensions_N tip_position_m tip_rotation tendon_length_m iterations stable relative_error
    shape s_m p_m'
fem='schema dofs K stiffness_centre_m loads name shortening_m tip_rotation_rad mid_curvature_per_m strain_energy_J'

document 0 "$section stiffaxis/section/1" "$program" section "$cases/constant_nc.yaml" --json
document 0 "$rod stiffaxis/rod/1" "$program" rod "$cases/constant_nc.yaml" --json
document 0 "$fem stiffaxis/fem/1" "$program" fem "$cases/fig4.yaml" --json
document 0 'schema rows' "$program" compare "$cases/helical_nc.yaml" --json
document 0 'stiffaxis/run/1 section rod compare' "$program" run "$cases/helical_nc.yaml" --json
document 0 'stiffaxis/check/1 valid' "$program" check "$cases/fig4.yaml" --json
document 0 'properties' "$program" schema --json
document 0 'stiffaxis/examples/1' "$program" example --json
document 0 'stiffaxis/example/1' "$program" example fig4 --json
document 0 'stiffaxis/doctor/1' "$program" doctor --json
document 0 'version' "$program" --version --json
document 0 'text' "$program" rod --help --json
document 2 'stiffaxis/error/1 exit_code message' "$program" check "$work/missing.yaml" --json
document 4 'stiffaxis/error/1' "$program" rod "$cases/homogeneous_tube.yaml" --json \
    --set 'rod.tensions_N=[[4.1]]'

# one number of each, so that a key is not an empty promise: EA in closed form, 226 deg of bend, 20 mm of segment
if command -v python3 >/dev/null; then
    "$program" section "$cases/constant_nc.yaml" --json >"$work/section.json"
    "$program" rod "$cases/constant_nc.yaml" --json >"$work/rod.json"
    "$program" fem "$cases/fig4.yaml" --json >"$work/fem.json"
    python3 - "$work" <<'END' || fail 'the numbers are not as they should be'
import json, math, sys
load = lambda name: json.load(open(f"{sys.argv[1]}/{name}.json"))
station = load("section")["stations"][0]
area = math.pi * (4e-3**2 - 3.2e-3**2)
EA = area * (0.66e6 * 15 / 16 + 15.93e6 / 16)
assert abs(station["EA_N"] / EA - 1) < 1e-9, station["EA_N"]
assert len(station["K"]) == 6 and all(len(row) == 6 for row in station["K"])
solutions = load("rod")["solutions"]
assert [s["tensions_N"] for s in solutions][2] == [0.98, 0]
assert solutions[2]["stable"] is True
R = solutions[2]["tip_rotation"]
assert abs(math.degrees(math.atan2(R[0][2], R[2][2])) % 360 - 226.4) < 0.5
assert solutions[2]["shape"][-1]["p_m"] == solutions[2]["tip_position_m"]
fem = load("fem")
assert abs(fem["loads"][0]["mid_curvature_per_m"][1] / 6.232 - 1) < 3e-3
END
fi
finish
