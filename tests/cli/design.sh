#!/bin/sh
# A design that reaches what is known by construction: found, the same again from the same seed, by one worker or two, by two
# ranks, and where a search goes on that was cut off. And what a search can have wrong.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

ball 12 40 0 15 >"$work/ball.stl"
# The scope is not inserted, so that a straight tip ends at its own length: target `ahead` wants 25 mm of it. The arc of a tip of
# 25 mm that its tendon bends by 1 rad ends 11.49 mm off its line: `aside` wants a tendon that is far enough from the axis.
cat >"$work/targets.csv" <<'END'
name,x [mm],y [mm],z [mm]
ahead,0,0,25
aside,11.49,0,21.04
END
cat >"$work/toy.yaml" <<'END'
format: 1
title: a tip whose length and tendon are to be found
materials:
  soft: {E_MPa: 1, nu: 0.45}
section:
  shapes:
    - {annulus: {outer_radius_mm: 1, inner_radius_mm: 0.5}, material: soft}
rod:
  length_mm: 12
  tendons:
    - {name: t1, radius_mm: 0.1, angle_rad: 0}
reach:
  tissue: ball.stl
  tissue_unit: mm
  targets: targets.csv
  entry: {point_mm: [0, 0, 0], direction: [0, 0, 1], free_mm: 0}
  synthetic: true
  scopes:
    - {name: soft, radius_mm: 1, insertion_mm: [0, 0.1], tensions_N: [[0, 0.05]], rod: {}}
  design:
    scope: soft
    parameters:
      - {name: tip, unit: mm, lower: 5, upper: 50, start: 12}
      - {name: off, lower: 0, upper: 0.9, start: 0.1}
    set:
      - rod.length_mm=tip
      - "rod.tendons.t1.radius_mm=off"
    islands: 2
    evaluations: 40
END
design() {
    expect 0 "$program" design "$work/toy.yaml" --out "$work/$1"
    cmp -s "$work/$1/designed.yaml" "$work/one/designed.yaml" || fail "$1: another design"
}

expect 0 "$program" design "$work/toy.yaml" --out "$work/one"
paper "$work/one"
out 'at first        0 of 2 targets'
out 'found           2 of 2 targets'
[ "$(grep -c '^[0-9]' "$work/one.design-log")" -eq 80 ] || fail 'not every design is in the log'
grep -q '^# designed: scope soft reaches 2 targets (synthetic), at first 0 targets; tip = 2' "$work/one/designed.yaml" ||
    fail 'the design is not told in the case'
# the design is a case of its own, wherever it lies
mkdir "$work/elsewhere"
cp "$work/one/designed.yaml" "$work/elsewhere/mine.yaml"
expect 0 "$program" reach "$work/elsewhere/mine.yaml"
out 'soft                                    2 of    2'
awk '$1 == "length_mm:" { if ($2 < 23.9 || $2 > 26.1) exit 1; found = 1 } END { exit !found }' "$work/elsewhere/mine.yaml" ||
    fail 'the tip has not the length that the target wants'

design again
command -v taskset >/dev/null && expect 0 taskset -c "$(taskset -cp $$ | sed 's/.*: *//;s/[^0-9].*//')" \
    "$program" design "$work/toy.yaml" --out "$work/alone" && cp "$work/alone/designed.yaml" "$work/alone.yaml" &&
    { cmp -s "$work/alone.yaml" "$work/one/designed.yaml" || fail 'one worker finds another design'; }
if command -v mpirun >/dev/null; then
    root=
    [ "$(id -u)" -ne 0 ] || root=--allow-run-as-root
    expect 0 timeout 120 mpirun $root --oversubscribe -n 2 "$program" design "$work/toy.yaml" --out "$work/ranks"
    cmp -s "$work/ranks/designed.yaml" "$work/one/designed.yaml" || fail 'two ranks find another design'
    [ "$(grep -c '^found' "$work/out")" -eq 1 ] || fail 'more than one process speaks'
    [ -s "$work/ranks.design-log.1" ] || fail 'the second rank has looked at nothing'
fi

# cut off in the middle of a line: what stands there is not computed again
head -n 50 "$work/one.design-log" >"$work/cut.design-log"
printf '1,9,0,0.3' >>"$work/cut.design-log"
design cut
looked_at() { # designs; one that was asked for twice may stand there twice
    grep '^[0-9]' "$1" | cut -d, -f5- | sort -u
}
looked_at "$work/one.design-log" >"$work/whole"
looked_at "$work/cut.design-log" | cmp -s - "$work/whole" || fail 'the search did not go on where it ended'
[ "$(grep -c '^[0-9]' "$work/cut.design-log")" -le 80 ] || fail 'what stood in the log was computed again'
# ended by a signal: the log stays, nothing else
"$program" design "$work/toy.yaml" --set reach.design.evaluations=20000 --out "$work/ended" >"$work/out" 2>&1 &
run=$!
for _ in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
    [ "$(grep -c . "$work/ended.design-log" 2>/dev/null)0" -gt 20 ] && break
    sleep 0.1
done
kill -TERM $run
wait $run
[ $? -eq 130 ] || fail 'an interrupt is not told'
[ ! -e "$work/ended" ] || fail 'an interrupted search leaves results'
design ended
! ps -e -o args= | grep -q "[d]esign $work" || fail 'a worker is left behind'

# a tip that cannot bend is on its line with every tension
expect 0 timeout 60 "$program" reach "$work/toy.yaml" --set rod.length_mm=25 --set 'reach.scopes.soft.tensions_N=[[0, 0]]'
out 'soft                                    1 of    2'

# of an area, in a smaller ball: at first the tip comes nowhere near the wall
mkdir "$work/area"
cp "$work/targets.csv" "$work/area"
ball 12 25 0 15 >"$work/area/ball.stl"
sed 's/^  design:/  map: {points: 40}\n  design:/; s/insertion_mm: .0, 0.1./insertion_mm: [0, 20]/
    s/    parameters:/    maximise: area\n    parameters:/' "$work/toy.yaml" >"$work/area/area.yaml"
expect 0 "$program" design "$work/area/area.yaml" --set reach.design.evaluations=8 --set reach.design.islands=1
out 'at first       0.00 % of the area'
awk '$1 == "found" && $2 > 0 { found = 1 } END { exit !found }' "$work/out" || fail 'no area is found'

# every number of the page
if command -v python3 >/dev/null; then
    numbers() {
        python3 -B "$source/tests/cli/page_numbers.py" "$1" "$work/area.json"
    }
    expect 0 "$program" design "$work/area/area.yaml" --set reach.design.evaluations=4 --json --quiet --out "$work/shown"
    cp "$work/out" "$work/area.json"
    numbers "$work/shown/report.html" >"$work/told" || fail "$(cat "$work/told")"
    sed 's/: 8 evaluations/: 9 evaluations/' "$work/shown/report.html" >"$work/changed.html"
    numbers "$work/changed.html" >/dev/null && fail 'a wrong count of evaluations goes unnoticed'
fi

# --- what can be wrong

wrong() {
    sed "$1" "$work/toy.yaml" >"$work/wrong.yaml"
    expect 2 "$program" design "$work/wrong.yaml" --out "$work/wrong"
    err "$2"
}
wrong 's/scope: soft/scope: hard/' "wrong.yaml:21:12: error: no scope is called 'hard'"
wrong 's/name: off/name: pi/' "a parameter cannot be called 'pi': expressions know that name already"
wrong 's/name: off/name: true/' "a parameter cannot be called 'true'"
wrong 's/      - rod.length_mm=tip/&\n      - rod.length_mm=2*tip/' "wrong.yaml:27:9: error: 'rod.length_mm' is set twice"
wrong 's/rod: {}/rod: {set: [rod.length_mm=9]}/' "'rod.length_mm' is set twice, by the scope's rod.set too"
wrong 's/name: off/name: a-b/' "'a-b' is no name for a parameter"
wrong 's/name: off/name: tip/' "two parameters are called 'tip'"
wrong 's/radius_mm=off/radius_mm=0.2/' "parameter 'off' stands in no expression of \`set\`"
wrong 's/radius_mm=off/radius_mm=off off/' 'error: '
wrong 's/t1.radius_mm=/t2.radius_mm=/' 'error: '
wrong 's/=tip/=tip + tap/' 'tap'
wrong 's/lower: 5/lower: 13/' "parameter 'tip': start = 12 lies outside its bounds, 13 to 50"
wrong 's/- rod.length_mm=tip/- reach.scopes.soft.radius_mm=tip/' 'is of the search, not of the design'
wrong 's/    parameters:/    maximise: area\n    parameters:/' 'give map'
wrong 's/^  design:/  nothing:/' "unknown key 'nothing'"
expect 2 "$program" design "$source/cases/fig4.yaml"
err "the case has no 'reach.design'"
# another case's log is not touched
sed 's/E_MPa: 1,/E_MPa: 2,/' "$work/toy.yaml" >"$work/other.yaml"
cp "$work/one.design-log" "$work/other.design-log"
expect 2 "$program" design "$work/other.yaml" --out "$work/other"
err 'other.design-log: belongs to the search of another case'
cmp -s "$work/one.design-log" "$work/other.design-log" || fail 'the log of another case was touched'
[ ! -e "$work/wrong.design-log" ] || fail 'a mistake leaves a log'
finish
