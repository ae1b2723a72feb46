#!/bin/sh
# Both ways that share the levels of a body out find on three ranks what each of them finds on one.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
command -v mpirun >/dev/null || exit 0
root=
[ "$(id -u)" -ne 0 ] || root=--allow-run-as-root
ways=$(dirname "$program")/verify_way_iterative

expect 0 timeout 300 mpirun $root --oversubscribe -n 3 "$ways" shared
grep -q 'residual' "$work/out" || fail 'no run was reported'
finish
