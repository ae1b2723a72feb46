#!/bin/sh
# CPU time against error: bench.sh [NAME...], all of them without names. Tables on stdout, PASS or FAIL and the measured ratio per
# target; points and pictures in results/bench.
set -u
cd "$(dirname "$0")/.."
bin=${STIFFAXIS_BIN:-build/release/bin}
out=results/bench
targets=$out/targets.txt
bad=0

# whole processes: CPU s, limits of a quiet machine
whole_processes() {
    printf '%-44s %8s %8s %8s %8s\n' 'whole process, CPU s' min median max limit
    timed 0.15 'section constant_nc (full)' section cases/constant_nc.yaml
    timed 0.15 'rod constant_nc (full)' rod cases/constant_nc.yaml
    timed 0.15 'rod helical_nc' rod cases/helical_nc.yaml
    timed 1.0 'section catheter (full, gmsh mesh)' section cases/catheter.yaml
    timed 1.5 'fem fig4' fem cases/fig4.yaml
}

# timed LIMIT LABEL COMMAND CASE
timed() {
    "$bin/bench_process" 9 "$1" "$2" "$bin/stiffaxis" "$3" "$4" --json
}

names() {
    echo process
    for program in "$bin"/bench_*; do
        name=$(basename "$program")
        case $name in
        bench_process | bench_draw) ;;
        *) echo "${name#bench_}" ;;
        esac
    done
}

# one NAME: its table, its points, its picture
one() {
    printf '\n== %s\n' "$1"
    rm -f "$out/$1.csv"
    if [ "$1" = process ]; then
        whole_processes
    else
        STIFFAXIS_BENCH_POINTS=$out/$1.csv "$bin/bench_$1"
    fi >"$out/$1.txt" 2>&1 || bad=1
    cat "$out/$1.txt"
    if [ -s "$out/$1.csv" ]; then
        "$bin/bench_draw" "$1" "$out/$1.csv" "$out" || bad=1
    fi
    grep -E '^(PASS|FAIL) ' "$out/$1.txt" | sed "s/^/$1 /" >>"$targets" || true
}

mkdir -p "$out"
: >"$targets"
for name in "$@"; do
    names | grep -qx -- "$name" || {
        printf 'no benchmark %s; there are: %s\n' "$name" "$(names | tr '\n' ' ')" >&2
        exit 2
    }
done
for name in ${*:-$(names)}; do
    one "$name"
done

printf '\n== targets (%s)\n' "$targets"
cat "$targets"
! grep -q ' FAIL ' "$targets" || bad=1
printf '%d pass, %d fail; tables, points and pictures in %s\n' "$(grep -c ' PASS ' "$targets")" "$(grep -c ' FAIL ' "$targets")" "$out"
exit $bad
