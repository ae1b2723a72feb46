#!/bin/sh
# Too little memory, on one process or on one of several, and a process that is killed: a clear line, the exit code,
# no hang and no torn file.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
case=$source/cases/fig4.yaml
large='--set fem.method=direct --set fem.order=4 --set fem.layers=40 --set fem.size_mm=1'

# a sanitizer needs terabytes of addresses
if [ "${STIFFAXIS_BUILD_TYPE:-}" != Debug ]; then
    for limit in 250000 400000 700000; do
        (ulimit -v $limit && exec timeout 120 "$program" fem "$case" $large --out "$work/out_$limit") \
            >"$work/out" 2>"$work/err"
        code=$?
        [ $code = 5 ] || fail "exit code $code, not 5, under $limit kB"
        grep -Eq 'memory|too large' "$work/err" || fail "no word of memory under $limit kB: $(cat "$work/err")"
        one_line
        [ ! -e "$work/out_$limit/result.hdf" ] || fail 'a torn result'
    done
fi

# whatever the way, and whatever library has to do without
small='--set fem.layers=4'
if [ "${STIFFAXIS_BUILD_TYPE:-}" != Debug ]; then
    for way in auto doubling direct iterative; do
        (ulimit -v 150000 && exec timeout 60 "$program" fem "$case" $small --set fem.method=$way --out "$work/less") \
            >"$work/out" 2>"$work/err"
        code=$?
        [ $code = 5 ] || fail "exit code $code, not 5, of $way under 150000 kB"
        one_line
        err 'no memory'
        [ -z "$(find "$work" -name 'less*')" ] || fail 'something was left without memory'
    done
fi

# a disk that is full at any point (here: a limit on the size of files): nothing is left
for blocks in 1 40 400; do
    expect 5 sh -c 'ulimit -f "$1"; shift; exec "$@"' sh $blocks "$program" fem "$case" $small --out "$work/full"
    one_line
    [ -z "$(find "$work" -name 'full*')" ] || fail "something was left on a disk of $blocks blocks"
done

# supports that leave a motion free, whichever way finds it
sed '/^fem:/,$d' "$case" >"$work/loose.yaml"
cat >>"$work/loose.yaml" <<END
fem:
  length_mm: 20
  base: free
  springs: [{face: base, normal_N_per_mm3: 2}]
  loads: [{name: across, force_N: [1, 0, 0]}]
END
for way in auto direct iterative; do
    expect 4 "$program" fem "$work/loose.yaml" $small --set fem.method=$way --out "$work/loose"
    err 'supports are singular'
    one_line
    [ ! -e "$work/loose" ] || fail 'a result of singular supports'
done

# a body that folds over itself, bent to less than its own radius, or with its walls tapered to nothing
sed '/^fem:/,$d' "$case" >"$work/folded.yaml"
cat >>"$work/folded.yaml" <<END
rod: {length_mm: 20, rest: {curvature_y_per_m: 400}}
fem: {length_mm: 20, loads: [{name: push, force_N: [0, 0, -1]}]}
END
expect 2 "$program" fem "$work/folded.yaml" --out "$work/folded"
err 'the body folds over itself'
one_line
[ ! -e "$work/folded" ] || fail 'a result of a folded body'
sed 's/{annulus: {outer_radius_mm: 4, /{annulus: {outer_radius_mm: 4 - 0.1*s, /; s/at: stiffness_centre/at_mm: [0, 0]/' \
    "$case" >"$work/tapered.yaml"
expect 2 "$program" fem "$work/tapered.yaml" --out "$work/tapered"
err 'is not between 0 and its outer_radius'
one_line

command -v mpirun >/dev/null && command -v pgrep >/dev/null || finish
root=
[ "$(id -u)" -ne 0 ] || root=--allow-run-as-root

# one of two
if [ "${STIFFAXIS_BUILD_TYPE:-}" != Debug ]; then
    for limit in 300000 400000; do
        timeout 120 mpirun $root --oversubscribe -n 1 "$program" fem "$case" $large : \
            -n 1 sh -c "ulimit -v $limit; exec '$program' fem '$case' $large" >"$work/out" 2>"$work/err"
        code=$?
        [ $code = 5 ] || fail "exit code $code, not 5, with $limit kB for one of two"
        grep -q 'error: .*memory' "$work/err" || fail "no word of memory: $(cat "$work/err")"
    done
fi

# killed in the middle
timeout 120 mpirun $root --oversubscribe -n 2 "$program" fem "$case" $large --out "$work/killed" \
    >"$work/out" 2>"$work/err" &
run=$!
sleep 2
starter=$(pgrep -P $run mpirun || echo $run)
victim=$(pgrep -P "$starter" | tail -1)
if [ -n "$victim" ] && kill -9 "$victim"; then
    wait $run
    code=$?
    [ $code -ne 0 ] && [ $code -ne 124 ] || fail "exit code $code after a process was killed"
    [ ! -e "$work/killed/result.hdf" ] || fail 'a torn result after a process was killed'
    [ -s "$work/err" ] || fail 'not a word about the killed process'
else
    wait $run
fi
finish
