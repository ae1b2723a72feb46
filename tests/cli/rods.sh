#!/bin/sh
# Rods under loads, pulled lengths, friction and sweeps, from the case file to the numbers.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

cat >"$work/tube.yaml" <<'CASE'
format: 1
materials:
  soft: {E_MPa: 0.66, nu: 0.45, density_kg_per_m3: 1100}
section:
  model: classical
  shapes:
    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3.2}, material: soft}
rod:
  length_mm: 120
  tolerance: 1e-11
  points: 3
  tendons:
    - {name: t1, radius_mm: 3.6}
  loads:
    - {name: tip, force_N: [0, 0.02, 0]}
  tensions_N: [[0], [0.5]]
CASE
cat >"$work/strip.yaml" <<'CASE'
format: 1
materials:
  soft: {E_MPa: 0.66, nu: 0.3}
section:
  model: classical
  shapes:
    - {rectangle: {width_mm: 4, height_mm: 12}, material: soft}
rod:
  length_mm: 120
  points: 3
  start: last
  loads:
    - {name: weight, force_N: [0, 0, -0.01]}
    - {name: side, force_N: [0.001, 0, 0]}
  # a column beyond its Euler load leans one way, and is pushed over to the other
  load_factors: [[1, 0.1], [1, -1], [1, -3], [1, -3]]
CASE

# rod NAME OPTIONS...: $work/NAME.json from $work/tube.yaml
rod() {
    name=$1
    shift
    expect 0 "$program" rod "$work/tube.yaml" --json "$@"
    cp "$work/out" "$work/$name.json"
}
free='rod.loads=[]'

rod loaded --set rod.derivatives=true
rod more --set 'rod.tensions_N=[[0], [0.5001]]'
rod less --set 'rod.tensions_N=[[0], [0.4999]]'
rod pulled --set "$free" --set 'rod.tensions_N=[[~]]' --set 'rod.pulls_mm=[[2]]'
rod elastic --set "$free" --set 'rod.tensions_N=[[~]]' --set 'rod.pulls_mm=[[2]]' --set rod.tendons.t1.EA_N=20 \
    --set rod.tendons.t1.outside_mm=300
rod slack --set "$free" --set 'rod.tensions_N=[[~]]' --set 'rod.pulls_mm=[[-1]]'
rod rubbing --set "$free" --set 'rod.tensions_N=[[0.5]]' --set rod.tendons.t1.friction=0.3
rod turned --set 'rod.base={rotation_deg: [0, 0, 90], position_mm: [10, 20, 30]}' \
    --set 'rod.loads=[{force_N: [-0.02, 0, 0]}]'
rod following --set 'rod.loads=[{force_N: [0, 0.02, 0], frame: body}]'
rod heavy --set "$free" --set 'rod.gravity_m_per_s2=[0, 9.81, 0]' --set 'rod.tensions_N=[[0]]'
rod weight --set 'rod.loads=[]' --set 'rod.tensions_N=[[0]]' \
    --set 'rod.line_loads=[{force_N_per_m: [0, 1100*9.81*pi*(0.004^2 - 0.0032^2), 0]}]'
rod sweep --set 'rod.tensions_N=[[0]]' --set 'rod.sweep=[{tension_of: t1, from_N: 0, to_N: 0.5, steps: 20},
    {load: tip, from: 0, to: 1, steps: 1}]'
rod last --set rod.start=last --set 'rod.tensions_N=[[0]]' \
    --set 'rod.sweep=[{tension_of: t1, from_N: 0, to_N: 0.5, steps: 20}]'
for name in shared single; do
    [ $name = shared ] && loads='[{force_N_per_m: [0, 0.1*s/L, 0]}, {force_mN_per_mm: [0, 0.1 - 0.1*s/L, 0]}]'
    [ $name = single ] && loads='[{force_N_per_mm: [0, 1e-4, 0], from_mm: 60}, {force_N_per_m: [0, 0.1, 0], to_mm: 60}]'
    rod $name --set 'rod.loads=[]' --set "rod.line_loads=$loads"
done

# a limit point in the way: all solutions are shown, that one is marked, and the exit code says so
expect 4 "$program" rod "$work/strip.yaml" --json --quiet --out "$work/snapped"
cp "$work/out" "$work/snap.json"
one_line
err 'strip.yaml:16:17: error: 1 of 4 solutions ends at a limit point, where the rod snaps: solution 3 at 0.40753'
err 'past_limit_points: true'
[ -s "$work/snapped/result.hdf" ] || fail 'the result of a snapping rod is not written'
[ -s "$work/snapped/report.html" ] || fail 'a snapping rod has no page'
expect 4 "$program" rod "$work/strip.yaml"
out 'solution 3: limit point at 0.40753 of its way'
out '0.4075!'
expect 0 "$program" rod "$source/cases/pulled_tube.yaml"
out 'slack'
expect 0 "$program" rod "$work/strip.yaml" --json --set rod.past_limit_points=true
cp "$work/out" "$work/past.json"
expect 0 "$program" report "$work/snapped" --out "$work/again"
for table in rods shapes; do
    cmp -s "$work/snapped/$table.csv" "$work/again/$table.csv" || [ ! -e "$work/again/$table.csv" ] ||
        fail "$table.csv differs when it is made from the store"
done

# what cannot be solved ends the run, and nothing is written
expect 4 "$program" rod "$work/tube.yaml" --set 'rod.tensions_N=[[9]]' --out "$work/eaten"
err "tendon 't1'"
[ ! -e "$work/eaten" ] || fail 'a rod without an answer was written'

# mistakes
expect 2 "$program" check "$work/tube.yaml" --set rod.tendons.t1.friction=-1
err "error: 'friction': -1 is out of range"
expect 2 "$program" check "$work/tube.yaml" --set rod.loads.tip.at_s_mm=130
err 'the load lies at 130 mm'
expect 2 "$program" check "$work/tube.yaml" --set materials.soft.density_kg_per_m3=0 \
    --set 'rod.gravity_m_per_s2=[0, 0, 1]'
expect 3 "$program" check "$work/tube.yaml" --set rod.tendons.t1.path_csv=none.csv
printf 's_mm;x_mm;y_mm\n0;3.6;0\n60;3.6;0\n120;3.6;oops\n' >"$work/path.csv"
expect 3 "$program" check "$work/tube.yaml" --set rod.tendons.t1.path_csv=path.csv
err "path.csv:4: 'oops' is not a number"
sed -i 's/oops/0/; s/3.6/0/' "$work/path.csv"
rod tabled --set rod.tendons.t1.radius_mm=3.6 --set rod.tendons.t1.path_csv=path.csv

expect 0 "$program" schema
valid_json "$work/out"
for key in gravity_m_per_s2 load_factors past_limit_points curvature_y_per_m force_mN_per_mm path_csv insertion_mm; do
    out "\"$key\""
done

command -v python3 >/dev/null || finish
python3 - "$work" <<'PYTHON' || fail 'the numbers are not as they should be'
import json, math, sys
load = lambda name: json.load(open(f"{sys.argv[1]}/{name}.json"))["solutions"]
apart = lambda a, b: math.dist(a["tip_position_m"], b["tip_position_m"])
E, L, r = 0.66e6, 0.12, 3.6e-3
EA = E * math.pi * (4e-3**2 - 3.2e-3**2)
EI = E * math.pi / 4 * (4e-3**4 - 3.2e-3**4)
give = 1 / EA + r * r / EI  # a straight tendon shortens by this times its tension, per length

# an independent solver's tips, good to 1e-11 m; ours is asked for 1e-11 of 0.12 m
loaded = load("loaded")
for solution, tip in zip(loaded, ([0, 0.07852296901404067, 0.08310723449111658],
                                  [0.054729954587487015, 0.06225301055928794, 0.023125766351884125])):
    assert math.dist(solution["tip_position_m"], tip) < 2e-11, (solution["tip_position_m"], tip)
    assert solution["stable"] is True and solution["fraction"] == 1 and solution["eigenvalue"] > 0
    assert abs(solution["energy_misfit"]) < 1e-8
# the section carries what the force does: at the tip of the rod without tension, the force itself
at_tip = loaded[0]["shape"][-1]
R = loaded[0]["tip_rotation"]
assert all(abs(at_tip["force_N"][i] - 0.02 * R[1][i]) < 1e-11 for i in range(3)), at_tip
assert math.hypot(*at_tip["moment_Nm"]) < 1e-12
# and at the base its moment about it
base = loaded[0]["shape"][0]
assert abs(base["moment_Nm"][0] / (-0.02 * loaded[0]["tip_position_m"][2]) - 1) < 1e-9, base

# derivatives against differences over 2e-4 N
more, less, here = load("more")[1], load("less")[1], loaded[1]
v = here["tip_derivatives"]["by_tension_per_N"][0][:3]
world = [sum(here["tip_rotation"][i][k] * v[k] for k in range(3)) for i in range(3)]
slope = [(a - b) / 2e-4 for a, b in zip(more["tip_position_m"], less["tip_position_m"])]
assert math.dist(world, slope) < 1e-6 * math.hypot(*slope), (world, slope)
C = here["tip_derivatives"]["compliance_body"]
assert len(C) == 6 and all(abs(C[i][j] - C[j][i]) < 1e-6 * math.sqrt(C[i][i] * C[j][j]) for i in range(6) for j in range(6))

# pulled lengths in closed form
pulled, elastic, slack = load("pulled")[0], load("elastic")[0], load("slack")[0]
assert abs(pulled["tensions_N"][0] / (2e-3 / (L * give)) - 1) < 1e-9, pulled["tensions_N"]
assert abs(pulled["tendon_length_m"][0] - (L - 2e-3)) < 1e-11 and pulled["pulls_m"] == [0.002]
assert abs(elastic["tensions_N"][0] / (2e-3 / (L * give + (L + 0.3) / 20)) - 1) < 1e-9, elastic["tensions_N"]
assert slack["tensions_N"] == [0] and slack["slack"] == [True] and abs(slack["tendon_length_m"][0] - L) < 1e-12

# capstan: what a plane tendon loses is its coefficient times the angle it turned through
rubbing = load("rubbing")[0]
along = [place["tension_N"][0] for place in rubbing["shape"]]
assert rubbing["tensions_N"] == [0.5] and abs(along[0] / 0.5 - 1) < 1e-7, along
assert abs(along[-1] / (0.5 * math.exp(-0.3 * rubbing["total_bend_rad"])) - 1) < 1e-7, along
assert rubbing["stable"] is None and load("following")[0]["stable"] is None

# the same rod turned and moved; the same loads written differently
for a, b in zip(loaded, load("turned")):
    x, y, z = a["tip_position_m"]
    assert math.dist([-y + 0.01, x + 0.02, z + 0.03], b["tip_position_m"]) < 1e-12, (a, b)
for a, b in (("shared", "single"), ("heavy", "weight"), ("loaded", "tabled")):
    assert all(apart(x, y) < 5e-12 for x, y in zip(load(a), load(b))), (a, b)

# sweeps: the last one runs fastest; from rest and from the last answer
sweep, last = load("sweep"), load("last")
assert len(sweep) == 42 and sweep[1]["tensions_N"] == [0] and sweep[1]["load_factors"] == [1]
assert apart(sweep[41], loaded[1]) < 1e-12 and abs(sweep[2]["tensions_N"][0] - 0.025) < 1e-15
assert all(apart(a, b) < 5e-12 for a, b in zip(sweep[1::2], last))

# limit points: the marked solution is an equilibrium at the loads it tells, and the others are as without it
snap, past = load("snap"), load("past")
assert [s["fraction"] < 1 for s in snap] == [False, False, True, False]
limit = snap[2]["critical_points"][0]
assert limit["kind"] == "limit_point" and abs(limit["fraction"] - snap[2]["fraction"]) < 1e-9
# by shooting from the tip's angle with Runge-Kutta, 2000 steps, the extremum of the side force by golden section
assert abs(limit["fraction"] / 0.40753018033810 - 1) < 1e-8, limit
assert snap[2]["relative_error"] is None and snap[2]["stable"] is not True
assert apart(snap[0], past[0]) < 1e-12 and apart(snap[1], past[1]) < 1e-12
assert past[2]["fraction"] == 1 and past[2]["stable"] is True and past[2]["tip_position_m"][0] < 0 < snap[2]["tip_position_m"][0]
assert [c["kind"] for c in past[2]["critical_points"]] == ["limit_point", "limit_point"]
PYTHON
finish
