#!/bin/sh
# docs/prototypes.md shows what the program says: every block's command is run, and every line of the block stands in its
# output, in that order. Numbers with an exponent are rounding and estimates, and are not held.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
page=$source/docs/prototypes.md
cd "$source" || exit 1

plain() {
    sed -E 's/[0-9.]+e-[0-9]+/~/g; s/[ ]+/ /g; s/ $//' "$1"
}

count=$(grep -c '^\$ stiffaxis ' "$page")
[ "$count" -ge 8 ] || fail "only $count commands on the page"
awk -v dir="$work" '/^```console$/ { n++; inside = 1; next } /^```$/ { inside = 0 }
    inside { print > sprintf("%s/block%02d", dir, n) }' "$page"
for block in "$work"/block*; do
    line=$(head -1 "$block")
    arguments=${line#\$ stiffaxis }
    # what many samples take long for is not run in a sanitized build
    case "$arguments" in *monte_carlo*) [ "${STIFFAXIS_BUILD_TYPE:-}" != Debug ] || continue ;; esac
    # the page's own words, split as a shell would without quotes or wild cards
    set -f
    # shellcheck disable=SC2086
    expect 0 "$program" $arguments
    set +f
    plain "$work/out" >"$work/said"
    sed '1d; /^\.\.\.$/d; /^$/d' "$block" >"$work/lines"
    plain "$work/lines" >"$work/wanted"
    awk 'NR == FNR { want[++n] = $0; next } k < n && $0 == want[k + 1] { k++ } END { if (k < n) { print want[k + 1]; exit 1 } }' \
        "$work/wanted" "$work/said" >"$work/missing" || fail "$line does not say: $(cat "$work/missing")"
done

# the figures that the page names
expect 0 "$program" rod cases/constant_nc.yaml --out "$work/constant"
for figure in rods curvature section; do
    [ -s "$work/constant/$figure.svg" ] || fail "no $figure.svg"
done
expect 0 "$program" sensitivity cases/helical_nc_sensitivity.yaml --out "$work/helical"
[ -s "$work/helical/tornado.svg" ] || fail 'no tornado.svg'
finish
