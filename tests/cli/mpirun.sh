#!/bin/sh
# Under mpirun one process speaks, and the numbers are those of one process alone.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
command -v mpirun >/dev/null && command -v python3 >/dev/null || exit 0
case=$source/cases/fig4.yaml
root=
[ "$(id -u)" -ne 0 ] || root=--allow-run-as-root

expect 0 "$program" fem "$case" --json
cp "$work/out" "$work/one.json"
expect 0 mpirun $root --oversubscribe -n 2 "$program" fem "$case" --json
valid_json "$work/out"
python3 - "$work/one.json" "$work/out" <<'END' || fail 'two processes find other numbers'
import json, sys
one, two = (json.load(open(name)) for name in sys.argv[1:])
def numbers(x):
    if isinstance(x, dict):
        for key in sorted(x):
            yield from numbers(x[key])
    elif isinstance(x, list):
        for item in x:
            yield from numbers(item)
    elif isinstance(x, (int, float)):
        yield x
def flat(rows):
    return [list(numbers(row)) for row in rows]
# relative to the largest entry of the same matrix or vector: the small ones are rounding
def compare(a, b, scale):
    assert len(a) == len(b) and all(abs(x - y) <= 1e-10 * scale for x, y in zip(a, b)), (a, b)
assert one["dofs"] == two["dofs"]
for i in range(6):
    for j in range(6):
        scale = (one["K"][i][i] * one["K"][j][j]) ** 0.5
        compare([one["K"][i][j]], [two["K"][i][j]], scale)
compare(one["stiffness_centre_m"], two["stiffness_centre_m"], 4e-3)
gc = one["loads"][0]
for a, b in zip(one["loads"], two["loads"]):
    for key in ("shortening_m", "tip_rotation_rad", "mid_curvature_per_m", "strain_energy_J"):
        compare(list(numbers(a[key])), list(numbers(b[key])), max(map(abs, numbers(gc[key]))))
END
# also with --out: one process writes
expect 0 mpirun $root --oversubscribe -n 2 "$program" fem "$case" --out "$work/two"
[ -s "$work/two/result.hdf" ] || fail 'nothing was written'
[ "$(grep -c 'centre found' "$work/out")" -eq 1 ] || fail 'more than one process speaks'
# every rank takes part in a comparison; one speaks
expect 0 timeout 120 mpirun $root --oversubscribe -n 2 "$program" compare "$case"
[ "$(grep -c '^tolerances' "$work/out")" -eq 1 ] || fail 'more than one process speaks'

# fields that ranks share out become the file that one process writes
shared=$(dirname "$program")/test_shared_store
for ranks in 2 3; do
    [ ! -x "$shared" ] || expect 0 timeout 120 mpirun $root --oversubscribe -n $ranks "$shared"
done
small="--set fem.method=direct --set fem.order=2 --set fem.layers=6 --set fem.stress=true"
expect 0 timeout 120 mpirun $root --oversubscribe -n 2 "$program" fem "$case" $small --out "$work/both"
[ -s "$work/both/result.hdf" ] || fail 'two ranks wrote nothing'
[ ! -e "$work/both/segment.svg" ] || fail 'one rank has all fields: nothing was shared'
expect 0 "$program" report "$work/both"
[ -s "$work/both-report/segment.svg" ] && [ -s "$work/both-report/segment_stress.svg" ] || fail 'the shared fields are not all there'
# a disk that is full: one line from a rank, and nothing is left
expect 5 timeout 120 mpirun $root --oversubscribe -n 2 sh -c \
    "trap '' XFSZ; ulimit -f 1000; exec '$program' fem '$case' $small --out '$work/full'"
err 'cannot write'
[ -z "$(ls "$work" | grep full)" ] || fail 'a full disk leaves something behind'
# a rank that is killed takes the others with it; there is a whole result, or none
timeout 120 mpirun $root --oversubscribe -n 2 "$program" fem "$case" --set fem.method=direct --set fem.layers=40 --out "$work/killed" \
    >"$work/out" 2>&1 &
run=$!
sleep 2
ranks=$(ps -e -o pid= -o ppid= | awk -v top=$run '$2 == top { mpirun[$1] } { parent[$1] = $2 }
    END { for (p in parent) if (parent[p] in mpirun) print p }')
victim=${ranks%%[!0-9]*}
[ -z "$victim" ] || kill -9 "$victim" 2>/dev/null
wait $run
[ ! -e "$work/killed" ] || expect 0 "$program" report "$work/killed"
finish
