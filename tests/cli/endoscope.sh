#!/bin/sh
# The synthetic ventricle: the same bytes again, a closed surface, sizes as anatomists measure them. Then the endoscope study on a
# coarse one, whose poses a slow check in Python retraces: constant curvature by its closed form, distances to all triangles.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
command -v python3 >/dev/null || finish
here=$source/cases/endoscope

# --- the anatomy

python3 "$here/ventricle.py" --triangles 1500 --targets 7 --out "$work/again" >"$work/again.told" 2>&1 &
expect 0 python3 "$here/ventricle.py" --triangles 1500 --targets 7 --out "$work/study"
out 'SYNTHETIC lateral ventricle'
wait
for file in ventricle.stl plexus.stl targets.csv entry.csv; do
    cmp -s "$work/again/$file" "$work/study/$file" || fail "$file is not made alike twice"
done
cmp -s "$work/again.told" "$work/out" || fail 'another table the second time'
expect 2 python3 "$here/ventricle.py" --triangles 10 --out "$work/none"
[ ! -e "$work/none" ] || fail 'files in spite of an error'

python3 - "$work" <<'END_CHECK' || fail 'the anatomy is not as its sources say'
import struct, sys
data = open(f"{sys.argv[1]}/study/ventricle.stl", "rb").read()
if not data.startswith(b"SYNTHETIC"): sys.exit("the surface is not labelled")
n = struct.unpack("<I", data[80:84])[0]
p = [struct.unpack("<9f", data[84 + 50 * i + 12:84 + 50 * i + 48]) for i in range(n)]
corners = [t[k:k + 3] for t in p for k in (0, 3, 6)]
# counter-clockwise from outside, a coarse surface some percent within the fine one
volume = sum(a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g) for a, b, c, d, e, f, g, h, i in p) / 6000
def within(value, low, high, what):
    if not low <= value <= high: sys.exit(f"{what}: {value}, not in {low} to {high}")
def across(axis, keep):
    values = [c[axis] for c in corners if keep(c)]
    return max(values) - min(values)
# docs/endoscope.md: enlarged, so beyond what is normal in width and volume, but as long as it is
within(volume, 20, 75, "volume [mL]")
within(max(c[1] for c in corners), 26, 35, "frontal horn [mm]")
within(2 * max(c[0] for c in corners if c[1] > 0), 0.3 * 129, 0.45 * 135, "both frontal horns [mm]")
within(across(0, lambda c: abs(c[1] + 62) < 5), 10.3, 25, "occipital horn's width [mm]")
within(across(2, lambda c: abs(c[1] + 28) < 5 and c[2] < -12), 2, 15, "temporal horn's height [mm]")
targets = open(f"{sys.argv[1]}/study/targets.csv").read().splitlines()
if "SYNTHETIC" not in targets[0]: sys.exit("the targets are not labelled")
if len(targets) != 3 + 7: sys.exit(f"{len(targets)} lines of targets")
END_CHECK

# --- the study

cp "$here/endoscope.yaml" "$here/design.yaml" "$work/study"
expect 0 "$program" check "$work/study/design.yaml"
expect 0 "$program" check "$work/study/endoscope.yaml"
out '7 scopes for 7 targets in a surface of 14'
# two scopes of the seven, no map
sed -e '/^  map:/d' -e '/paper.s, full K, 30 mm/,$d' "$work/study/endoscope.yaml" >"$work/study/small.yaml"
expect 0 "$program" reach "$work/study/small.yaml" --out "$work/results" --quiet
out 'SYNTHETIC tissue ventricle.stl'
out "the paper's Table IV, on a patient's anatomy that is not published: constant curvature 14 of 20, helical 18 of 20"
grep -q SYNTHETIC "$work/results/report.html" || fail 'the page does not say that the anatomy is synthetic'
expect 0 "$program" reach "$work/study/small.yaml" --json --quiet

python3 - "$work" <<'END_CHECK' || fail 'the poses are not what a slow check finds'
import csv, json, math, struct, sys
work = sys.argv[1]
told = json.load(open(f"{work}/out"))
if not told["synthetic"]: sys.exit("not told to be synthetic")

data = open(f"{work}/study/ventricle.stl", "rb").read()
triangle = []
for i in range(struct.unpack("<I", data[80:84])[0]):
    v = struct.unpack("<9f", data[84 + 50 * i + 12:84 + 50 * i + 48])
    triangle.append(tuple(tuple(1e-3 * x for x in v[k:k + 3]) for k in (0, 3, 6)))
rows = [r for r in csv.reader(open(f"{work}/study/targets.csv")) if not r[0].startswith("#")][1:]
target = [tuple(1e-3 * float(x) for x in r[:3]) for r in rows]
point, towards, L, radius, tolerance = (0.03, 0.075, 0.018), (0, -0.1, -0.01), 0.02, 1.4e-3, 1e-3

sub = lambda a, b: tuple(x - y for x, y in zip(a, b))
dot = lambda a, b: sum(x * y for x, y in zip(a, b))
cross = lambda a, b: (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
axpy = lambda a, t, b: tuple(x + t * y for x, y in zip(a, b))

def segment(p, a, b):
    d = sub(b, a)
    return math.dist(p, axpy(a, min(max(dot(sub(p, a), d) / dot(d, d), 0), 1), d))

def to_triangle(p, t):
    a, b, c = t
    n = cross(sub(b, a), sub(c, a))
    within = all(dot(cross(n, sub(y, x)), sub(p, x)) >= 0 for x, y in ((a, b), (b, c), (c, a)))
    return abs(dot(sub(p, a), n)) / math.sqrt(dot(n, n)) if within else min(segment(p, a, b), segment(p, b, c), segment(p, c, a))

middle = [tuple(sum(x) / 3 for x in zip(*t)) for t in triangle]
reach_of = [max(math.dist(m, x) for x in t) for m, t in zip(middle, triangle)]

def inside(p):
    """by the solid angle that the surface fills"""
    total = 0
    for t in triangle:
        a, b, c = (sub(x, p) for x in t)
        x, y, z = (math.sqrt(dot(v, v)) for v in (a, b, c))
        total += 2 * math.atan2(dot(a, cross(b, c)), x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y)
    return total > 2 * math.pi

def distance(p):
    best = math.inf
    for t, m, r in zip(triangle, middle, reach_of):
        if math.dist(p, m) - r < best:
            best = min(best, to_triangle(p, t))
    return best if inside(p) else -best

# the entry's frame: the smallest turn that takes z onto the line
z = sub(towards, point)
z = tuple(x / math.sqrt(dot(z, z)) for x in z)
def world(v):
    axis = (-z[1], z[0], 0)
    a = cross(axis, v)
    return tuple(x + y + w / (1 + z[2]) for x, y, w in zip(v, a, cross(axis, a)))

def body(q, s):
    insertion, turn, bend = q
    a = bend * s / L
    x, along = (0, s) if s <= 0 or bend == 0 else ((1 - math.cos(a)) * L / bend, math.sin(a) * L / bend)
    v = (x * math.cos(turn), x * math.sin(turn), insertion + along)
    return axpy(point, 1, world(v)), v

free = told["entry"]["free_m"]
def room(q, s):
    p, v = body(q, s)
    channel = 1e-4 - math.hypot(v[0], v[1], max(v[2] - free, 0))
    return max(distance(p) - radius, channel)

def exact(t):
    """the poses whose tip is at t: bends of every root of rho"""
    d = sub(t, point)
    local = [dot(d, world(e)) for e in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    rho, phi = math.hypot(local[0], local[1]), math.atan2(local[1], local[0])
    f = lambda u: (1 - math.cos(u)) * L / u - rho
    us = [1e-9 + 1.5 * math.pi * i / 4000 for i in range(4001)]
    for u, w in zip(us, us[1:]):
        if f(u) * f(w) <= 0:
            for _ in range(60):
                half = (u + w) / 2
                u, w = (half, w) if f(u) * f(half) > 0 else (u, half)
            yield local[2] - math.sin(u) * L / u, phi, u
    return

def wrong(answer, words):
    sys.exit(f"{answer['target']} ({answer['verdict']}): {words}")

verdicts = set()
for t, a in zip(target, told["scopes"][0]["answers"]):
    verdicts.add(a["verdict"])
    q = (a["pose"]["insertion_m"], a["pose"]["turn_rad"], a["pose"]["bend_rad"])
    miss = math.dist(body(q, L)[0], t)
    if abs(miss - a["miss_m"]) > 1e-9: wrong(a, f"misses by {miss}")
    poses = list(exact(t))
    if a["verdict"] == "out_of_reach":
        if poses or miss <= tolerance: wrong(a, "a bend brings it there")
        continue
    if miss > tolerance + 1e-9: wrong(a, "the tip is not there")
    here = room(q, a["least_clear_at_s_m"])
    if abs(here - a["clearance_m"]) > 1e-6: wrong(a, f"clearance {here}, told {a['clearance_m']}")
    least = min(room(q, L * i / 8) for i in range(1, 9))
    if least < a["clearance_m"] - 5e-5: wrong(a, f"clearance {least} elsewhere")
    # the shaft's clearance counts from a place past where it comes out, but there it must not touch either
    if a["verdict"] == "reached" and min(room(q, (free - q[0]) * i / 4) for i in range(5)) < 0: wrong(a, "it touches")
    if a["verdict"] == "collision":
        for p in poses:
            if all(room(p, L - (L + p[0] - free) * i / 20) >= 0 for i in range(20)): wrong(a, f"free at {p}")
if verdicts != {"reached", "out_of_reach", "collision"}: sys.exit(f"only {verdicts}")
reached = sum(a["verdict"] == "reached" for a in told["scopes"][0]["answers"])
if told["scopes"][0]["reached"] != reached: sys.exit("another count")
END_CHECK

# --- a search for a better pattern: on the whole ventricle it ends with no less than the paper's design, which it begins with, and
# the same seed ends with the same bytes. With fewer evaluations than design.yaml asks for.

if long; then
    expect 0 python3 "$here/ventricle.py" --out "$work/whole"
    cp "$here/design.yaml" "$work/whole"
    for run in one two; do
        expect 0 "$program" design "$work/whole/design.yaml" --set reach.design.islands=2 --set reach.design.evaluations=8 \
            --out "$work/$run" --quiet
        cp "$work/out" "$work/$run.told"
    done
    awk '$1 == "at" && $2 == "first" { start = $3; of = $5; score = $8 } $1 == "found" { found = $2; best = $6 }
        END { exit !(of == 20 && found >= start && best >= score && score > 0) }' "$work/one.told" ||
        fail 'the search ends with less than it began with'
    cmp -s "$work/one/designed.yaml" "$work/two/designed.yaml" || fail 'another design from the same seed'
    # the paper's pattern as a case of its own reaches what the search says of it
    expect 0 "$program" reach "$work/whole/design.yaml" --quiet
    cp "$work/out" "$work/start.told"
    [ "$(sed -n 's/^at first *\([0-9]*\) of.*/\1/p' "$work/one.told")" = "$(sed -n 's/^helical  *\([0-9]*\) of.*/\1/p' "$work/start.told")" ] ||
        fail 'the search begins with another design'
fi

# --- a target with one narrow way to be reached, which bounds alone do not find: the pose is there with the joints held about it

expect 0 python3 "$here/ventricle.py" --triangles 2500 --out "$work/narrow"
printf 'x_mm,y_mm,z_mm\n17.803571,13.867652,8.266612\n' >"$work/narrow/targets.csv"
cat >"$work/narrow/narrow.yaml" <<'END'
format: 1
reach:
  tissue: ventricle.stl
  tissue_unit: mm
  targets: targets.csv
  entry: {point_mm: [30, 75, 18], towards_mm: [0, -100, -10]}
  tolerance_mm: 0.3
  clearance_mm: 0.8
  tip: skin
  scopes:
    - {name: held, radius_mm: 1.4, insertion_mm: [31.7770, 31.7771], turn_deg: [32.3, 32.4], constant_curvature: {length_mm: 31.337780426368475, bend_deg: [0, 0.03]}}
    - {name: free, radius_mm: 1.4, insertion_mm: [-50, 126.11216035695041], turn_deg: [-180, 180], constant_curvature: {length_mm: 31.337780426368475, bend_deg: [0, 258.64563040278506]}}
END
expect 0 "$program" reach "$work/narrow/narrow.yaml" --quiet
out 'held                                    1 of    1'
out 'free                                    1 of    1'
finish
