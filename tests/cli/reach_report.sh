#!/bin/sh
# What a reach study leaves behind: tables and JSON that say the same, a page that `report` makes again from the stored result
# alone, names that stay words, damaged results refused.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

box >"$work/box.stl"
cat >"$work/targets.csv" <<'END'
name,x [mm],y [mm],z [mm]
<script>alert(1)</script>,0,6,25
=1+1,-8,0,22
"a, b",0,0,44
far,19,19,-4
END
cat >"$work/box.yaml" <<'END'
format: 1
title: scopes <b>in</b> a box
materials: {soft: {E_MPa: 1, nu: 0.45, linear_strain: 0.12}}
section:
  model: classical
  shapes: [{annulus: {outer_radius_mm: 1.4, inner_radius_mm: 1}, material: soft}]
rod: {length_mm: 20, tendons: [{name: t, radius_mm: 1.2, angle_rad: 0}]}
reach:
  tissue: box.stl
  tissue_unit: mm
  targets: targets.csv
  entry: {point_mm: [0, 0, -8], direction: [0, 0, 1]}
  synthetic: true
  source: made by a test & nobody's
  map: {points: 200, seed: 3}
  paper: table_4
  scopes:
    - {name: "arc <i>", radius_mm: 1.4, insertion_mm: [0, 60], constant_curvature: {length_mm: 20, bend_deg: [0, 180]}}
    - {name: rod, radius_mm: 1.4, insertion_mm: [0, 60], rod: {}, tensions_N: [[0, 0.3]], strain_limit: true}
END
expect 0 "$program" reach "$work/box.yaml" --out "$work/first" --json
cp "$work/out" "$work/box.json"
valid_json "$work/box.json"

expect 0 "$program" report "$work/first/result.hdf" --out "$work/again"
out '4 targets in SYNTHETIC anatomy, final poses only'
out 'the paper prints 14 and 18 of 20'
for file in reach.csv reach_scopes.csv reach_body.csv reach_map.csv report.html; do
    cmp -s "$work/first/$file" "$work/again/$file" || fail "$file: not the same from the stored result"
done
grep -qF 'The anatomy is synthetic' "$work/again/report.html" || fail 'the page does not say that the anatomy is synthetic'
grep -qF '&lt;script&gt;alert(1)' "$work/again/report.html" || fail 'the page does not show the name of a target'
grep -qF '<script>alert' "$work/again/report.html" && fail 'the page runs the name of a target'
grep -qF '<i>' "$work/again/report.html" && fail 'the page takes the name of a scope for markup'

if command -v python3 >/dev/null; then
    python3 - "$work" <<'END' || fail 'tables and JSON do not say the same'
import csv, json, sys
told = json.load(open(f"{sys.argv[1]}/box.json"))
rows = list(csv.DictReader(open(f"{sys.argv[1]}/first/reach.csv")))
answers = [(s, a) for s in told["scopes"] for a in s["answers"]]
if len(rows) != len(answers) or len(rows) != 8: sys.exit("not a row per scope and target")
number = lambda text: float(text) if text else None
for row, (s, a) in zip(rows, answers):
    same = [row["scope"] == s["name"], row["verdict"].replace(" ", "_") == a["verdict"], row["why"] == a["why"],
            number(row["miss_m"]) == a["miss_m"], number(row["clearance_m"]) == a["clearance_m"],
            number(row["insertion_m"]) == a["pose"]["insertion_m"],
            number(row["bend_rad"]) == a["pose"].get("bend_rad"),
            [number(row["tension_1_N"])] == a["pose"].get("tensions_N", [None])]
    if not all(same): sys.exit(f"{s['name']}, {a['target']}: {same}")
if not any(a["verdict"] == "reached" for s, a in answers): sys.exit("nothing is reached")
if all(a["verdict"] == "reached" for s, a in answers): sys.exit("all is reached")
scopes = list(csv.DictReader(open(f"{sys.argv[1]}/first/reach_scopes.csv")))
if [int(r["reached_count"]) for r in scopes] != [s["reached"] for s in told["scopes"]]: sys.exit("counts")
if [r["anatomy"] for r in scopes] != ["synthetic"] * 2: sys.exit("whose anatomy")
samples = list(csv.DictReader(open(f"{sys.argv[1]}/first/reach_map.csv")))
if len(samples) != 200: sys.exit("samples")
for i, s in enumerate(told["scopes"]):
    n = sum(r[f"scope_{i + 1}_{s['name']}"] == "reached" for r in samples)
    if abs(n / 200 - s["map"]["area_reached_share"]) > 1e-12: sys.exit(f"{s['name']}: {n} samples, {s['map']}")
if not 0 < told["scopes"][0]["map"]["area_reached_share"] < 1: sys.exit("share of the wall")
body = [r for r in csv.DictReader(open(f"{sys.argv[1]}/first/reach_body.csv")) if r["scope"] == "rod"]
if len(body) != sum(len(a["body"]["s_m"]) for s, a in answers if s["name"] == "rod"): sys.exit("bodies")
END
fi

# every number of the page, and a check of it that can fail: one digit of a sentence, of each table, of what the view says
numbers() {
    python3 -B "$source/tests/cli/page_numbers.py" "$1" "$2"
}
if command -v python3 >/dev/null; then
    numbers "$work/first/report.html" "$work/box.json" >"$work/told" || fail "$(cat "$work/told")"
    for change in 's/enclosing 80/enclosing 81/' 's/<dd>3 of/<dd>4 of/' 's/<td>9\.0 ±/<td>9.1 ±/' 's/>14 of/>15 of/' 's/at s = 20\.0 mm</at s = 20.1 mm</' \
        's/(19\.0, 19\.0/(19.0, 19.1/' 's/<td>0 to 60</<td>0 to 61</' 's/of the map: 0\.44/of the map: 0.45/' \
        's/tip is 1\.000 mm/tip is 1.001 mm/' 's/✗ joint limit/✗ collision/' 's/least clearance 0\.176/least clearance 0.177/'; do
        sed "$change" "$work/first/report.html" >"$work/changed.html"
        if cmp -s "$work/first/report.html" "$work/changed.html" || numbers "$work/changed.html" "$work/box.json" >/dev/null; then
            fail "what is wrong goes unnoticed: $change"
        fi
    done
fi

# --- ways in

expect 0 "$program" reach "$work/box.yaml" --set reach.path=insertion --set reach.map.points=50 --out "$work/ways" --json --quiet
cp "$work/out" "$work/ways.json"
if command -v python3 >/dev/null; then
    numbers "$work/ways/report.html" "$work/ways.json" >"$work/told" || fail "$(cat "$work/told")"
fi
paper "$work/first" "$work/ways"
expect 0 "$program" report "$work/ways/result.hdf" --out "$work/ways_again"
out 'final poses and ways in'
for file in reach.csv reach_way.csv report.html; do
    cmp -s "$work/ways/$file" "$work/ways_again/$file" || fail "$file: not the same from the stored result, with ways in"
done
[ "$(wc -l <"$work/ways/reach_way.csv")" -gt 2 ] || fail 'no way in is told'

# --- damaged

size=$(wc -c <"$work/first/result.hdf")
head -c $((size / 2)) "$work/first/result.hdf" >"$work/half.hdf"
expect 3 "$program" report "$work/half.hdf" --out "$work/half"
[ ! -e "$work/half" ] || fail 'something was written of a damaged result'
finish
