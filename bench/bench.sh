#!/bin/sh
# Run time against error. Whole processes first (CPU seconds, limits of a quiet machine), then kernels in process.
set -u
cd "$(dirname "$0")/.."
bin=build/release/bin
program=$bin/stiffaxis
bad=0

printf '%-44s %8s %8s %8s %8s\n' 'whole process, CPU s' min median max limit
timed() {
    "$bin/bench_process" 9 "$@" || bad=1
}
timed 0.15 'section constant_nc (full)' "$program" section cases/constant_nc.yaml --json
timed 0.15 'rod constant_nc (full)' "$program" rod cases/constant_nc.yaml --json
timed 0.15 'rod helical_nc' "$program" rod cases/helical_nc.yaml --json
timed 1.0 'section catheter (full, gmsh mesh)' "$program" section cases/catheter.yaml --json
timed 1.5 'fem fig4' "$program" fem cases/fig4.yaml --json

for bench in "$bin"/bench_*; do
    case $bench in
    */bench_process) continue ;;
    esac
    printf '\n%s\n' "$(basename "$bench")"
    "$bench" || bad=1
done
exit $bad
