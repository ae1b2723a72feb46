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

# the same bodies on one rank and on two: `segment_scaling`. Strong: one size; weak: one size per rank
segment_scaling() {
    command -v mpirun >/dev/null || {
        echo 'no mpirun here'
        return
    }
    echo '#ranks#wall time [s]' >"$STIFFAXIS_BENCH_POINTS"
    strong_one=$(ranks 1 1) strong_two=$(ranks 2 1)
    weak_one=$(ranks 1 0.5)
    printf '%-32s %10s %8s %10s %10s %8s %8s\n' '' dofs levels iterations 'CPU s' 'peak GB' 'wall s'
    row 'one rank, 1 M' "$strong_one"
    row 'two ranks, 1 M (of the first)' "$strong_two"
    row 'one rank, 0.5 M' "$weak_one"
    verdict 'strong scaling, two ranks over one' "$strong_one" "$strong_two" 1.6
    verdict 'weak scaling, 0.5 M a rank, of 2' "$weak_one" "$strong_two" 0.75
    echo "strong,1,${strong_one##* }" >>"$STIFFAXIS_BENCH_POINTS"
    echo "strong,2,${strong_two##* }" >>"$STIFFAXIS_BENCH_POINTS"
    echo "weak,1,${weak_one##* }" >>"$STIFFAXIS_BENCH_POINTS"
    echo "weak,2,${strong_two##* }" >>"$STIFFAXIS_BENCH_POINTS"
}

# ranks COUNT MILLION: the row of bench_segment_size
ranks() {
    root=
    [ "$(id -u)" -ne 0 ] || root=--allow-run-as-root
    mpirun $root -n "$1" "$bin/bench_segment_size" body "$2" | tail -n 1
}

row() {
    echo "$2" | awk -v name="$1" '{ printf "%-32s %10d %8d %10d %10.2f %8.2f %8.2f\n", name, $1, $3, $4, $9, $10, $11 }'
}

# what the checks hold to a part of their cases, with all of them: `reach_full`
reach_full() {
    full_bad=0
    for name in inverse distance search reach_map way; do
        program=$bin/verify_$name
        if STIFFAXIS_LONG=1 "$program"; then
            printf 'PASS  %s, every case\n' "${program##*/verify_}"
        else
            printf 'FAIL  %s\n' "${program##*/verify_}"
            full_bad=1
        fi
    done
    return $full_bad
}

# the page of constant_nc in a browser, from nothing to a view that answers: `page`
page() {
    if ! command -v chromium >/dev/null || ! command -v python3 >/dev/null; then
        echo 'no chromium or no python3 here'
        return
    fi
    scratch=$(mktemp -d)
    "$bin/stiffaxis" run cases/constant_nc.yaml --quiet --out "$scratch/result" >/dev/null &&
        python3 -B bench/bench_page.py "$scratch/result/report.html" "$scratch"
    page_bad=$?
    rm -rf "$scratch"
    return $page_bad
}

# verdict WORDS ROW ROW LEAST: wall time of the first over the second's
verdict() {
    echo "$2 $3" | awk -v words="$1" -v least="$4" '{
        ratio = $11 / $22
        printf "%s  %s: %.2f, at least %s\n", (ratio >= least ? "PASS" : "FAIL"), words, ratio, least
    }'
}

names() {
    echo process
    echo segment_scaling
    echo reach_full
    echo page
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
    elif [ "$1" = segment_scaling ]; then
        STIFFAXIS_BENCH_POINTS=$out/$1.csv
        segment_scaling
    elif [ "$1" = reach_full ]; then
        reach_full
    elif [ "$1" = page ]; then
        page
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
