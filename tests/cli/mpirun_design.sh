#!/bin/sh
# Ranks share the islands of a design search out, and each of them has what one process finds.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
command -v mpirun >/dev/null || exit 0
root=
[ "$(id -u)" -ne 0 ] || root=--allow-run-as-root
search=$(dirname "$program")/test_design

expect 0 "$search" '' 0
cp "$work/out" "$work/one"
[ "$(wc -l <"$work/one")" -eq 1000 ] || fail 'no search was made'
for n in 2 3; do
    expect 0 timeout 120 mpirun $root --oversubscribe -n $n "$search" "$work/log" $((n - 1))
    cmp -s "$work/out" "$work/one" || fail "$n ranks find something else"
    [ -s "$work/log.1" ] || fail 'the second rank has no log'
done
# what the ranks wrote serves one process too
cat "$work"/log* | sort >"$work/before"
expect 0 "$search" "$work/log" 0
cmp -s "$work/out" "$work/one" || fail 'the logs of the ranks give something else'
cat "$work"/log* | sort | cmp -s - "$work/before" || fail 'what stood in the logs was computed again'
finish
