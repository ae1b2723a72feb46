#!/bin/sh
# What moves the answer, from the case file to tables, page and store; and everything that may be wrong in its block.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

cat >"$work/rod.yaml" <<'CASE'
format: 1
title: trial
materials:
  soft: {E_MPa: 0.66, nu: 0.3}
  stiff: {E_MPa: 15.93, nu: 0.3}
section:
  model: classical
  shapes:
    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3.2}, material: soft}
    - {sector: {outer_radius_mm: 4, inner_radius_mm: 3.2, mid_angle_rad: pi, width_rad: pi/8}, material: stiff}
rod:
  length_mm: 120
  tendons:
    - {name: t1, radius_mm: 3.6, angle_rad: 0}
    - {name: t2, radius_mm: 3.6, angle_rad: pi}
  tensions_N: [[0.49, 0], [0, 0.98]]
CASE

# block LINES...: $work/case.yaml is the rod with that block
block() {
    cp "$work/rod.yaml" "$work/case.yaml"
    printf 'sensitivity:\n' >>"$work/case.yaml"
    printf '%s\n' "$@" >>"$work/case.yaml"
}
radius='    - {name: radius, keys: [rod.tendons.t1.radius_mm, rod.tendons.t2.radius_mm], low: 3.5, high: 3.7}'
width='    - {name: width, keys: [section.shapes.1.sector.width_rad], alternative: pi/16}'

# --- without a block: the list for any case
expect 0 "$program" sensitivity "$work/rod.yaml"
out 'what moves the tip'
out 'the list for any case'
out 'tendon radius, mm'
out "Poisson's ratio"
out 'friction'
out 'full'
expect 0 "$program" sensitivity "$work/rod.yaml" --json
valid_json "$work/out"
# without it `run` does not do so either
expect 0 "$program" run "$work/rod.yaml" --json --set section.stations_mm='[0]'
grep -q '"sensitivity"' "$work/out" && fail 'run did what nobody asked for'

# --- numbers: the ends are those of --set, the derivative lies between
block '  parameters:' "$radius" "$width" '  solutions: [2]'
expect 0 "$program" sensitivity "$work/case.yaml" --json
valid_json "$work/out"
cp "$work/out" "$work/moves.json"
for end in 3.5 3.6 3.7; do
    expect 0 "$program" rod "$work/rod.yaml" --json --set rod.tendons.t1.radius_mm=$end --set rod.tendons.t2.radius_mm=$end
    cp "$work/out" "$work/at$end.json"
done
expect 0 "$program" rod "$work/rod.yaml" --json --set section.shapes.1.sector.width_rad=pi/16
cp "$work/out" "$work/narrow.json"
if command -v python3 >/dev/null; then
    python3 - "$work" <<'CHECK' || fail 'the numbers are others'
import json, sys
work = sys.argv[1]
tip = lambda name: json.load(open(f"{work}/{name}.json"))["solutions"][1]["tip_position_m"]
s = json.load(open(f"{work}/moves.json"))
assert s["schema"] == "stiffaxis/sensitivity/1"
[solution] = s["solutions"]
assert solution["solution"] == 2
radius, width = solution["moves"]
for end, name in enumerate(["at3.5", "at3.7"]):
    for a, b, c in zip(radius["ends"][end]["tip_moves_m"], tip(name), tip("at3.6")):
        assert abs(a - (b - c)) < 2e-7, (a, b, c)
middle = [(h - l) / 0.2 for h, l in zip(tip("at3.7"), tip("at3.5"))]
for a, b in zip(radius["tip_rate_m_per_unit"], middle):
    assert abs(a - b) < 2e-5, (a, b)  # per mm; the square of 0.1 mm
for a, b, c in zip(width["ends"][0]["tip_moves_m"], tip("narrow"), tip("at3.6")):
    assert abs(a - (b - c)) < 2e-7
assert width["tip_rate_m_per_unit"] == [None] * 3
assert 0.001 < radius["largest_m"] < 0.01
CHECK
fi

# --- random samples: the same bits whatever the number of cores, others by another seed
block '  parameters:' "$radius" '    - {name: friction, keys: [rod.tendons.t1.friction], low: 0, high: 0.2}' \
    '  monte_carlo: {samples: 60, seed: 3}'
expect 0 env OMP_NUM_THREADS=1 "$program" sensitivity "$work/case.yaml" --json
valid_json "$work/out"
cp "$work/out" "$work/one.json"
expect 0 env OMP_NUM_THREADS=4 "$program" sensitivity "$work/case.yaml" --json
cmp -s "$work/out" "$work/one.json" || fail 'other bits on four threads'
expect 0 "$program" sensitivity "$work/case.yaml" --json --set sensitivity.monte_carlo.seed=4
cmp -s "$work/out" "$work/one.json" && fail 'a seed that changes nothing'
expect 0 "$program" sensitivity "$work/case.yaml"
out 'Monte Carlo: 60 samples, seed 3'

# --- `run` does it where the case asks for it; the page, tables and the store
expect 0 "$program" run "$work/case.yaml" --out "$work/result"
for file in tornado.svg tornado.pdf tornado.png sensitivity.csv monte_carlo.csv; do
    [ -s "$work/result/$file" ] || fail "no $file"
done
grep -q 'id="sensitivity"' "$work/result/report.html" || fail 'not on the page'
expect 0 "$program" report "$work/result" --out "$work/again"
for file in tornado.svg sensitivity.csv monte_carlo.csv; do
    cmp -s "$work/result/$file" "$work/again/$file" || fail "$file is another from the store"
done

# --- mistakes: one line, the place, exit code 2, nothing written
# mistake WORDS LINES...
mistake() {
    words=$1
    shift
    block "$@"
    for command in check sensitivity; do
        expect 2 "$program" $command "$work/case.yaml"
        err "$words"
        err 'case.yaml:'
        one_line
    done
}
mistake 'low 3.7 is not below high 3.5' '  parameters:' '    - {name: r, keys: [rod.tendons.t1.radius_mm], low: 3.7, high: 3.5}'
mistake 'low 3.5 is not below high 3.5' '  parameters:' '    - {name: r, keys: [rod.tendons.t1.radius_mm], low: 3.5, high: 3.5}'
mistake 'one end of a range only' '  parameters:' '    - {name: r, keys: [rod.tendons.t1.radius_mm], low: 3.5}'
mistake 'neither a range' '  parameters:' '    - {name: r, keys: [rod.tendons.t1.radius_mm]}'
mistake 'a range and an alternative' '  parameters:' '    - {name: r, keys: [rod.tendons.t1.radius_mm], low: 3, high: 4, alternative: 5}'
mistake "'t9'" '  parameters:' '    - {name: r, keys: [rod.tendons.t9.radius_mm], low: 3, high: 4}'
mistake "'radius_m2'" '  parameters:' '    - {name: r, keys: [rod.tendons.t1.radius_m2], low: 3, high: 4}'
mistake 'is no number' '  parameters:' '    - {name: m, keys: [section.model], low: 0, high: 1}'
mistake 'names no key' '  parameters:' '    - {name: r, keys: [], low: 3, high: 4}'
mistake 'called' '  parameters:' "$radius" '    - {name: radius, keys: [rod.tendons.t1.friction], low: 0, high: 1}'
mistake 'belongs to parameter' '  parameters:' "$radius" '    - {name: r, keys: [rod.tendons.t1.radius_mm], low: 3, high: 4}'
mistake 'unknown key' '  parameters:' '    - {name: r, keys: [rod.tendons.t1.radius_mm], lowest: 3, high: 4}'
mistake 'give its sigma' '  parameters:' '    - {name: r, keys: [rod.tendons.t1.radius_mm], low: 3, high: 4, distribution: normal}'
mistake 'distribution: normal' '  parameters:' '    - {name: r, keys: [rod.tendons.t1.radius_mm], sigma: 0.1}'
mistake 'needs its middle' '  parameters:' '    - {name: r, keys: [rod.tensions_N], sigma: 0.1, distribution: normal}'
mistake 'samples' '  monte_carlo: {samples: 0}'
mistake 'samples' '  monte_carlo: {samples: -5}'
mistake 'samples' '  monte_carlo: {samples: 1000000000000}'
mistake 'samples' '  monte_carlo: {samples: .nan}'
mistake 'seed' '  monte_carlo: {samples: 10, seed: -1}'
mistake 'there is no solution 3' '  solutions: [3]'
mistake 'there is no solution 1.5' '  solutions: [1.5]'
mistake 'named twice' '  solutions: [1, 1]'
mistake 'one list' '  solutions: [[1], [2]]'

# what the program only finds when it tries: a clear line that names the parameter
tried() {
    code=$1
    words=$2
    shift 2
    block "$@"
    expect "$code" "$program" sensitivity "$work/case.yaml" --out "$work/none"
    err "$words"
    one_line
    [ ! -e "$work/none" ] || fail 'something was written'
}
tried 2 'mu = -3' '  parameters:' '    - {name: mu, keys: [rod.tendons.t1.friction], low: -3, high: 0.4}'
tried 2 'm = wooden' '  parameters:' '    - {name: m, keys: [section.model], alternative: wooden}'
tried 2 'nu = 0.7' '  parameters:' '    - {name: nu, keys: [materials.soft.nu], low: 0.3, high: 0.7}'
tried 2 'no parameter has a range' '  parameters:' "$width" '  monte_carlo: {samples: 10}'

# a tendon that eats its length at one end is an answer too: told, and the rest stands
block '  parameters:' '    - {name: tension row, keys: [rod.tendons.t1.radius_mm], low: 3.5, high: 100}'
expect 0 "$program" sensitivity "$work/case.yaml"
out 'tension row = 100:'

# no rod
sed '/^rod:/,$d' "$work/rod.yaml" >"$work/plane.yaml"
expect 2 "$program" sensitivity "$source/cases/helical_nc.yaml" \
    --set 'sensitivity.parameters=[{name: a, keys: [rod.tensions_N], alternative: "[[1], [2]]"}]'
err 'the rod has no solution 3 with this value'
expect 2 "$program" sensitivity "$work/plane.yaml"
err "no 'rod'"
printf 'sensitivity:\n  solutions: [1]\n' >>"$work/plane.yaml"
expect 2 "$program" check "$work/plane.yaml"
err 'the case has none'

finish
