#!/bin/sh
# `stiffaxis fit`: made shapes come back, and every mistake is one clear line with its exit code.
set -u
: "${STIFFAXIS:?}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
bad=0

fail() {
    printf 'fit: %s\n' "$1"
    bad=1
}

cat > truth.yaml <<'END'
format: 1
materials:
  soft:  {E_MPa: 0.66,  nu: 0.45}
  stiff: {E_MPa: 15.93, nu: 0.45}
section:
  model: classical
  shapes:
    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3.2}, material: soft}
    - {sector: {outer_radius_mm: 4, inner_radius_mm: 3.2, mid_angle_rad: pi, width_rad: pi/8}, material: stiff}
rod:
  length_mm: 120
  points: 61
  tolerance: 1e-6               # friction's corners are of low order: sharper costs ten times as much
  tendons: [{name: t1, radius_mm: 3.55, angle_rad: 0, friction: 0.2}]
  tensions_N: [[0.49], [0.98]]
END

# shapes of the truth as files of the unloaded rod's arclength; what is looked at here is the way, not the physics
"$STIFFAXIS" rod truth.yaml --json --quiet > truth.json || fail "the truth is not solved"
shape() {
    tr -d ' \n' < truth.json | sed 's/"shape":/\n&/g' | sed -n "$((1 + $1))p" | sed 's/{"s_m":/\n/g' | sed -n '2,$p' |
        sed 's/,"p_m":\[/,/; s/\].*//' | awk -F, 'BEGIN { print "s_mm,x_mm,y_mm,z_mm,sigma_mm" }
            { printf "%.6f,%.6f,%.6f,%.6f,0.05\n", 1e3 * $1, 1e3 * $2, 1e3 * $3, 1e3 * $4 }'
}
shape 1 > a.csv
shape 2 > b.csv
[ "$(wc -l < a.csv)" = 62 ] || fail "a.csv has $(wc -l < a.csv) lines"

sed 's/radius_mm: 3.55/radius_mm: 3.6/; s/friction: 0.2}/friction: 0.1}/' truth.yaml > case.yaml
cat >> case.yaml <<'END'
measured:
  synthetic: true
  source: the rod itself
  arclength: rest
  shapes:
    - {name: first, csv: a.csv, tensions_N: [0.49]}
    - {name: second, csv: b.csv, solution: 2}
fit:
  starts: 2
  parameters:
    - {name: tendon radius, keys: [rod.tendons.t1.radius_mm], start: 3.6, lower: 3.3, upper: 3.9}
    - {name: friction, keys: [rod.tendons.t1.friction], start: 0.1, lower: 0, upper: 0.8}
END

"$STIFFAXIS" check case.yaml --quiet > /dev/null || fail "check refuses the case"
"$STIFFAXIS" fit case.yaml --quiet --out out > out.txt || fail "fit fails"
grep -q 'SYNTHETIC' out.txt || fail "the table does not say synthetic"
grep -Eq '^tendon radius +3\.5(50|49|51)' out.txt || fail "radius: $(grep '^tendon' out.txt)"
grep -Eq '^friction +0\.(200|1999|2000|2001)' out.txt || fail "friction: $(grep '^friction' out.txt)"
for file in fit.svg fit.pdf fit.png fit.csv fit_residuals.csv fitted.yaml report.html result.hdf; do
    [ -s "out/$file" ] || fail "no $file"
done
grep -q 'Fitted to synthetic shapes' out/report.html || fail "the page does not say fitted"
"$STIFFAXIS" fit case.yaml --quiet --json | grep -q '"schema": *"stiffaxis/fit/1"' || fail "no fit document"
python3 "$STIFFAXIS_SOURCE/tests/cli/figures.py" out || fail "figures not fit for paper"
"$STIFFAXIS" report out --quiet --out again > /dev/null && cmp -s out/fit.svg again/fit.svg || fail "report differs"

# the fitted case goes on where it is written, and anywhere else, and says what it is
"$STIFFAXIS" compare out/fitted.yaml --quiet > err.txt 2>&1
grep -q 'No such file' err.txt && fail "fitted.yaml does not find its shapes: $(cat err.txt)"
grep -qF "csv: $(pwd -P)/a.csv" out/fitted.yaml || fail "no whole path in fitted.yaml"
mkdir -p sub && sed 's/a\.csv/none.csv/' case.yaml > sub/case.yaml
"$STIFFAXIS" check sub/case.yaml --quiet 2>&1 | grep -q 'sub/none.csv: No such' || fail "not sub/none.csv: $("$STIFFAXIS" check sub/case.yaml --quiet 2>&1)"
cp out/fitted.yaml . && "$STIFFAXIS" rod fitted.yaml --json --quiet | grep -q 'fitted: tendon radius' || fail "fitted.yaml"
# keys that the case leaves out, in a map in braces and in one of lines, and one written in another unit: all in force
tip() { "$STIFFAXIS" rod "$1" --json --quiet | grep tip_position; }
sed 's/, friction: 0.1}/}/; s/length_mm: 120/length_cm: 12/' case.yaml > without.yaml
for keys in braces lines; do
    [ "$keys" = braces ] ||
        sed -i 's/^  tendons: .*/  tendons:\n    - name: t1\n      radius_mm: 3.6\n      angle_rad: 0/' without.yaml
    "$STIFFAXIS" fit without.yaml --quiet --force --out short --set rod.length_mm=120 > /dev/null || fail "$keys: not fitted"
    cp short/fitted.yaml . && grep -q 'length_mm: 120' fitted.yaml || fail "$keys: no length_mm"
    "$STIFFAXIS" check fitted.yaml --quiet > /dev/null || fail "$keys: fitted.yaml is no case"
    [ "$(tip fitted.yaml | head -1)" != "$(tip without.yaml | head -1)" ] || fail "$keys: fitted.yaml changes nothing"
    grep -q 'NOT ALL' fitted.yaml && fail "$keys: something was left out"
    "$STIFFAXIS" rod fitted.yaml --json --quiet | awk '/tip_position/ { gsub(/[^-0-9.e,]/, ""); split($0, p, ","); n++
        if (n == 1) x = p[1] } END { exit !(x > 0) }' || fail "$keys: no tip"
    "$STIFFAXIS" rod without.yaml --json --quiet --set "rod.tendons.t1.friction=$(sed -n 's/.*friction: \(0\.[0-9]*\).*/\1/p' fitted.yaml | head -1)" \
        --set "rod.tendons.t1.radius_mm=$(sed -n 's/.*radius_mm: \(3\.[0-9]*\).*/\1/p' fitted.yaml | tail -1)" | grep tip_position > told
    tip fitted.yaml | cmp -s - told || fail "$keys: fitted.yaml is another rod than its own values"
done
# what has no place is told
sed 's/radius_mm: 3.6,/radius_mm: "3.6",/' case.yaml > quoted.yaml
"$STIFFAXIS" fit quoted.yaml --quiet --force --out short > /dev/null || fail "quoted: not fitted"
grep -q '^fitted: .*NOT ALL IN FORCE' short/fitted.yaml && tail -1 short/fitted.yaml | grep -q '^# .*--set rod.tendons.t1.radius_mm=3.5' ||
    fail "quoted: $(grep fitted: short/fitted.yaml)"

"$STIFFAXIS" run case.yaml --quiet --out run > run.txt && [ -s run/fit.svg ] && grep -q '^fitted .*SYNTHETIC' run.txt || fail "run does not fit"

# 2 for the case, 4 for numbers that cannot be told; the same for `check` where it can know
mistake() {
    code=$1 words=$2
    shift 2
    "$STIFFAXIS" fit "$@" --quiet > /dev/null 2> err.txt
    got=$?
    [ "$got" = "$code" ] || fail "$*: exit code $got, not $code: $(cat err.txt)"
    [ "$(wc -l < err.txt)" = 1 ] || fail "$*: $(wc -l < err.txt) lines"
    grep -qF "$words" err.txt || fail "$*: '$(cat err.txt)' does not say '$words'"
}
first=fit.parameters.0
mistake 2 "has no 'fit'" truth.yaml
mistake 2 "unknown" case.yaml --set "$first.keys=[rod.tendons.t1.radiuss_mm]"
mistake 2 "no entry is named 't7'" case.yaml --set "$first.keys=[rod.tendons.t7.radius_mm]"
mistake 2 "tendon radius = 3.6: " case.yaml --set "$first.keys=[rod.nothing]"
mistake 2 "is no key" case.yaml --set "$first.keys=['a=b']"
mistake 2 "names no key" case.yaml --set "$first.keys=[]"
mistake 2 "does not lie below upper" case.yaml --set "$first.lower=3.9" --set "$first.upper=3.3"
mistake 2 "lies outside its bounds" case.yaml --set "$first.start=5"
mistake 2 "start = 0.0036 is 0.001 times the case's own rod.tendons.t1.radius_mm = 3.6: start, lower and upper are in the key's unit, mm" \
    case.yaml --set "$first.start=0.0036" --set "$first.lower=0.0033" --set "$first.upper=0.0039"
mistake 2 "names 'rod.tendons.t1.radius_mm' twice" case.yaml \
    --set "$first.keys=[rod.tendons.t1.radius_mm, rod.tendons.t1.radius_mm]"
mistake 2 "belongs to parameter" case.yaml --set "$first.keys=[rod.tendons.t1.friction]"
mistake 2 "they take one unit" case.yaml --set "$first.keys=[rod.tendons.t1.radius_mm, rod.tendons.t1.friction]"
mistake 2 "two parameters are called" case.yaml --set "$first.name=friction"
mistake 2 "'start'" case.yaml --set "$first.start=~"
mistake 2 "expected" case.yaml --set "$first.start=much"
mistake 2 "fit.base" case.yaml --set fit.base_mm=3
mistake 2 "'fit' names no parameters" case.yaml --set 'fit.parameters=[]'
mistake 2 "out of range" case.yaml --set fit.starts=0
mistake 4 "moves none of the measured shapes" case.yaml \
    --set "fit.parameters=[{name: nu, keys: [materials.stiff.density_kg_per_m3], start: 1000, lower: 900, upper: 1100}]"
# all moduli and all tensions by one factor: the same shapes
mistake 4 "cannot be told apart" case.yaml --set fit.starts=1 --set "fit.parameters=[\
{name: E, keys: [materials.soft.E_MPa], start: 0.7, lower: 0.3, upper: 2}, \
{name: E2, keys: [materials.stiff.E_MPa], start: 16, lower: 8, upper: 40}, \
{name: T, keys: [rod.tensions_N.0.0], start: 0.5, lower: 0.2, upper: 1}, \
{name: T2, keys: [rod.tensions_N.1.0], start: 1, lower: 0.5, upper: 2}]"
printf 's_mm,x_mm,y_mm,z_mm\n0,0,0,0\n10,0,0,10\n' > short.csv
mistake 2 "points" case.yaml --set measured.shapes.first.csv=short.csv
sed '/^measured:/,/solution: 2/d' case.yaml > bare.yaml
mistake 2 "no 'measured.shapes'" bare.yaml
[ $bad = 0 ] && echo "fit: all as expected"
exit $bad
