#!/bin/sh
# Hostile input: each fuzz program for ten minutes, or with --short for 60 s; under ASan and UBSan.
set -u
cd "$(dirname "$0")/../.."
seconds=600
[ "${1:-}" = --short ] && seconds=60
bad=0
for program in build/dev/bin/fuzz_*; do
    echo "$(basename "$program"), $seconds s"
    "$program" "$seconds" || bad=1
done
exit $bad
