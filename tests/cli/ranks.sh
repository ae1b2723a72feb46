#!/bin/sh
# The direct way's loads and supports on several ranks, more of them than layers too.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
command -v mpirun >/dev/null || exit 0
here=$(dirname "$program")
[ -x "$here/verify_direct_loads" ] || exit 0
root=
[ "$(id -u)" -ne 0 ] || root=--allow-run-as-root
short=6
! long || short="2 3 6"
for n in $short; do
    expect 0 timeout 120 mpirun $root --oversubscribe -n $n "$here/verify_direct_loads"
done
finish
