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
