#!/bin/sh
# Shapes that were measured, in a case: what compare, run and report make of them, and files that are none.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

# what other programs compare is not at issue here
alone() {
    env PATH="$work/nothing" "$program" "$@"
}

cases=$source/cases/measured
expect 0 alone compare "$cases/constant_nc_measured.yaml"
out 'synthetic shapes: the rod'
out 'SYNTHETIC data, not from a bench'
out 't1 at 0.98 N'
out '1.25 (1.0)'
out 'which are not published'
expect 0 alone compare "$cases/helical_nc_measured.yaml" --json
valid_json "$work/out"
cp "$work/out" "$work/helical.json"

cat >"$work/rod.yaml" <<'END'
format: 1
title: a soft tube
materials: {soft: {E_MPa: 0.66, nu: 0.45}}
section: {model: classical, shapes: [{annulus: {outer_radius_mm: 4, inner_radius_mm: 3.2}, material: soft}]}
rod:
  length_mm: 120
  tendons: [{name: t1, radius_mm: 3.6, angle_rad: 0}, {name: t2, radius_mm: 3.6, angle_rad: pi/2}]
  tensions_N: [[0.1, 0], [0.2, 0], [0.2, 0]]
measured:
  source: our bench
  shapes:
    - {name: first, csv: line.csv, tensions_N: [0.1, 0]}
END
printf 's_mm,x_mm,y_mm,z_mm,sigma_mm\n0,0,0,0,0.1\n60,8,0,59,0.1\n117.8,31,0,112.5,0.1\n' >"$work/line.csv"

# without the key nothing is computed
sed '/^measured:/,$d' "$work/rod.yaml" >"$work/plain.yaml"
expect 0 alone compare "$work/plain.yaml"
! grep -qi 'measured\|synthetic' "$work/out" || fail 'measured shapes that nobody asked for'
expect 0 alone compare "$work/plain.yaml" --json
! grep -q '"measured"' "$work/out" || fail 'measured shapes in the JSON that nobody asked for'

# measured is called measured, with its source
expect 0 alone compare "$work/rod.yaml"
out 'measured shapes: the rod'
out 'Measured: our bench'
! grep -qi synthetic "$work/out" || fail 'measured data called synthetic'

# a solution of the paper's without a shape: its errors, and nothing invented for ours
expect 0 alone compare "$work/rod.yaml" --set measured.paper=table_2 --set 'rod.tensions_N=[[0.1, 0], [0.49, 0]]'
out 'not published'
out '1.25 (1.0)'

# an error of the model is no failure, unless the case says so
expect 0 alone compare "$work/rod.yaml" --set measured.tolerance=0.5
out 'measured: tip error over L, largest (first)'
expect 1 alone compare "$work/rod.yaml" --set measured.tolerance=1e-6

# everything is in the result, and comes back from it
expect 0 alone run "$work/rod.yaml" --out "$work/result"
paper "$work/result"
out 'measured 1 shape'
for file in measured.csv measured_shapes.csv measured.svg measured.pdf measured.png measured_along.svg; do
    [ -s "$work/result/$file" ] || fail "no $file"
done
expect 0 "$program" report "$work/result" --out "$work/again"
for file in measured.csv measured_shapes.csv measured.svg measured_along.svg; do
    cmp -s "$work/result/$file" "$work/again/$file" || fail "the stored $file is another one"
done

# which solution
wrong() { # WORDS OVERRIDE...: exit 2 and one line
    words=$1
    shift
    expect 2 "$program" check "$work/rod.yaml" "$@"
    err "$words"
    one_line
}
wrong 'not solved for tensions of 0.3, 0 N' --set 'measured.shapes.0.tensions_N=[0.3, 0]'
wrong '1 tension, but the rod has 2' --set 'measured.shapes.0.tensions_N=[0.1]'
wrong 'solutions 2 and 3' --set 'measured.shapes.0.tensions_N=[0.2, 0]'
wrong 'exclude each other' --set measured.shapes.0.solution=1
wrong 'solution 4, but the rod has 3' --set 'measured.shapes=[{csv: line.csv, solution: 4}]'
wrong 'neither shapes nor' --set 'measured.shapes=[]'
wrong 'unknown key' --set measured.colour=red
sed '/^rod:/,/tensions_N: \[\[/d' "$work/rod.yaml" >"$work/rodless.yaml"
expect 2 "$program" check "$work/rodless.yaml"
err "need a 'rod'"

# files that are no measured line: exit 3, one line with the file's name
bad() { # WORDS TEXT
    printf '%b' "$2" >"$work/line.csv"
    expect 3 "$program" compare "$work/rod.yaml" --out "$work/none"
    err "$1"
    err line.csv
    one_line
    [ ! -e "$work/none" ] || fail 'a result of nothing'
}
names='s_mm,x_mm,y_mm,z_mm\n'
bad line.csv ''
bad 'two or more' "${names}0,0,0,0\n"
bad 'line.csv:3' "${names}0,0,0,0\n60,nan,0,60\n120,0,0,120\n"
bad 'line.csv:4: s does not ascend' "${names}0,0,0,0\n60,0,0,60\n50,0,0,120\n"
bad 'is its unit right' 's_m,x_mm,y_mm,z_mm\n0,0,0,0\n60,0,0,60\n120,0,0,120\n'
bad 'right units' 's_mm,x_m,y_m,z_m\n0,0,0,0\n60,0,0,60\n120,0,0,120\n'
bad unit 's,x,y,z\n0,0,0,0\n60,0,0,60\n120,0,0,120\n'
bad line.csv '1,2,3,4,5,6,7,8,9,10\n1,2,3,4,5,6,7,8,9,10\n'
bad line.csv 'a,b,c,d,e,f,g,h,i,j\n1,2,3,4,5,6,7,8,9,10\n2,2,3,4,5,6,7,8,9,10\n'
bad line.csv '\0000\0001\0002\0003'
truncate -s 5G "$work/line.csv"
expect 3 timeout 20 "$program" check "$work/rod.yaml"
err line.csv
one_line
rm "$work/line.csv"
expect 3 "$program" check "$work/rod.yaml"
err line.csv
mkfifo "$work/line.csv"
expect 3 timeout 20 "$program" check "$work/rod.yaml"
rm "$work/line.csv"

# a file that says what it is is believed, whatever the case says
printf '# SYNTHETIC: made\ns_mm,x_mm,y_mm,z_mm\n0,0,0,0\n60,8,0,59\n117.8,31,0,112.5\n' >"$work/line.csv"
expect 0 alone compare "$work/rod.yaml"
out 'SYNTHETIC data, not from a bench'

# a part of the rod: no tip
printf 's_mm,x_mm,y_mm,z_mm\n10,0,0,10\n30,1,0,30\n60,8,0,59\n' >"$work/line.csv"
expect 0 alone compare "$work/rod.yaml"
out 'not measured'

# what is to be doubted is said on stderr and in the table: a free turn, a line longer than the model, another solution's line
printf 's_mm,x_mm,y_mm,z_mm,sigma_mm\n# the frame is free in its turn about z\n# correlation_length_mm: 5\n' >"$work/line.csv"
printf '0,0,0,0,0.1\n60,8,0,59,0.1\n117.8,31,0,112.5,0.1\n' >>"$work/line.csv"
expect 0 alone compare "$work/rod.yaml"
err 'warning: first: its scan is free in its turn about z'
out 'first: its scan is free in its turn about z'
! grep -q 'first .*+-' "$work/out" || fail 'an uncertainty of a direction that nobody knows'
expect 0 alone compare "$work/rod.yaml" --json
valid_json "$work/out"
grep -q '"turn_free": true' "$work/out" || fail 'no turn_free in the JSON'
cp "$cases"/helical_nc_*.csv "$work"
sed 's/csv: helical_nc_1.96N.csv/csv: helical_nc_0.49N.csv/' "$cases/helical_nc_measured.yaml" >"$work/wrong.yaml"
expect 0 alone compare "$work/wrong.yaml"
err 'longer than the model by 5.1 mm'
err 'far nearer to solution 1 (t1 at 0.49 N)'
out '1.96 N: longer than the model by 5.1 mm'
[ "$(grep -c warning "$work/err")" = 1 ] || fail 'doubts of shapes that are well'
# no shapes of its own: no word of a model against them
expect 0 alone compare "$work/rod.yaml" --set measured.shapes=[] --set measured.paper=table_2 --set 'rod.tensions_N=[[0.49, 0]]'
! grep -q 'against them' "$work/out" || fail 'shapes that are not there'

if command -v python3 >/dev/null; then
    python3 - "$work/helical.json" <<'END' || fail 'the numbers are not as they should be'
import json, sys
m = json.load(open(sys.argv[1]))["measured"]
assert m["schema"] == "stiffaxis/measured/1" and m["synthetic"] is True
assert len(m["shapes"]) == 5
paper = [(1.47, 2.2), (2.85, 4.0), (3.15, 4.6), (3.47, 6.1), (1.69, 6.6)]
for one, (tip, shape) in zip(m["shapes"], paper):
    assert one["published"] and one["synthetic"] and one["tip_measured"]
    assert abs(one["paper"]["tip_error_m"] - 1e-3 * tip) < 1e-12
    assert abs(one["paper"]["shape_error"] - 1e-2 * shape) < 1e-12
    # both errors again from the points: the last distance, and trapezoids of the distances over s
    p = one["points"]
    d = [sum((a - b) ** 2 for a, b in zip(x["p_m"], x["model_p_m"])) ** 0.5 for x in p]
    s = [x["s_m"] for x in p]
    assert abs(s[-1] - 0.12) < 1e-9
    assert abs(d[-1] - one["tip_error_m"]) < 1e-9
    f = [d[1] / s[1]] + [a / b for a, b in zip(d[1:], s[1:])]
    total = sum((s[i + 1] - s[i]) * (f[i] + f[i + 1]) / 2 for i in range(len(s) - 1)) / 0.12
    # a few per cent: the first steps, where the scan's errors are larger than the distance
    assert abs(total - one["shape_error"]) < 0.05 * total, (total, one["shape_error"])
    assert abs(one["tip_error_sigma_m"] - 5e-5) < 1e-12
END
fi

finish
