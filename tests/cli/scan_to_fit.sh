#!/bin/sh
# docs/measurements.md, "To try it": its commands, run as they stand there, take the repository's synthetic clouds to fitted
# numbers; and the clouds are what cases/scan/make.awk makes.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

for tension in 0.98 1.96; do
    awk -f "$source/cases/scan/make.awk" "$source/cases/measured/helical_nc_${tension}N.csv" >"$work/cloud"
    cmp -s "$work/cloud" "$source/cases/scan/helical_${tension}N.ply" || fail "helical_${tension}N.ply is not what make.awk makes"
done

# --out and the case's own paths begin at the repository's root: a copy of what they need
mkdir "$work/cases" && cp -r "$source/cases/scan" "$work/cases" && cd "$work" || exit 1
awk '/^### / { inside = $0 == "### To try it" } inside && /^stiffaxis / ' \
    "$source/docs/measurements.md" >commands
[ "$(wc -l <commands)" = 4 ] || fail "$(wc -l <commands) commands in the docs"
while read -r word arguments; do
    # the docs' own words, split as a shell would
    # shellcheck disable=SC2086
    expect 0 env PATH="$work/nothing" "$program" $arguments
    ! grep -q warning "$work/err" || fail "$word $arguments: $(grep warning "$work/err")"
    cp "$work/out" "said_$(set -- $arguments; echo "$1")"
done <commands
grep -q 'SYNTHETIC data' said_compare || fail 'made shapes pass for measured ones'
# made with 3.65 mm and 0.05: within four standard errors, and these no larger than a wall's tenth
awk '/^tendon radius/ { good += ($3 - 3.65) ^ 2 < 16 * $4 ^ 2 && $4 < 0.02 } /^friction/ { good += ($2 - 0.05) ^ 2 < 16 * $3 ^ 2 && $3 < 0.005 }
    END { exit good != 2 }' said_fit || fail "fitted: $(grep -E '^(tendon|friction)' said_fit)"

# a scan without a mark, turned by 40 degrees: its bend tells the same, and the turn that was found is told
line=results/scan_1.96N/centreline.csv
awk -F, 'BEGIN { OFS = ","; c = cos(0.6981317); s = sin(0.6981317) } /^[0-9]/ { x = $2; $2 = c * x - s * $3; $3 = s * x + c * $3 }
    { print } NR == 1 { print "# the frame is free in its turn about z\r" }' "$line" >turned && mv turned "$line"
expect 0 "$program" fit cases/scan/helical_nc_scanned.yaml --set fit.starts=1
err '../../results/scan_1.96N/centreline.csv is free in its turn about z'
out '* its scan is free in its turn about z'
awk '/^tendon radius/ { good += ($3 - 3.65) ^ 2 < 16 * $4 ^ 2 } /^1.96 N .*[*]$/ { good += ($8 - 40) ^ 2 < 4 }
    END { exit good != 2 }' "$work/out" || fail "a turned scan: $(grep -E '^(tendon|1.96)' "$work/out")"
finish
