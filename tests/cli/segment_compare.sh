#!/bin/sh
# What the comparison tells of the 3D segment: the cost of each assumption about the section, and CalculiX beside it, be it there,
# missing or broken.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
case=$source/cases/constant_nc.yaml

expect 0 "$program" compare "$case"
out "what the section's models cost"
out 'full, knows its turning'
out 'its law alone'
out 'of which the ends take the same'
if command -v ccx >/dev/null; then
    out "load 'geometric centre': its work, ours against CalculiX"
else
    out 'ccx is not installed'
fi

# a section that narrows has another end at every length
sed 's/width_rad: pi\/8/width_rad: "pi\/8 + s"/' "$case" >"$work/narrow.yaml"
expect 0 env PATH="$work/nothing" "$program" compare "$work/narrow.yaml" --json
out '"why_no_second_length"'
valid_json "$work/out"

# beside a spring nothing is told: it is not the segment's compliance
expect 0 env PATH="$work/nothing" "$program" compare "$case" --set 'fem.tip_spring={translation_N_per_mm: [1, 0, 0]}'
out 'more than its base holds the segment'

# programs called ccx that are none: told, and no comparison fails for it
mkdir "$work/bin"
fake() {
    printf '#!/bin/sh\n%s\n' "$1" >"$work/bin/ccx"
    chmod +x "$work/bin/ccx"
    expect 0 env TMPDIR="$work" PATH="$work/bin" "$program" compare "$case"
    out "$2"
    [ "$(find "$work" -maxdepth 1 -name 'stiffaxis-ccx-*' | wc -l)" -eq 0 ] || fail 'a directory was left behind'
}
fake 'exit 3' 'CalculiX failed: exit code 3'
fake 'exit 0' 'segment.dat'
fake 'echo displacements >segment.dat; echo 1 2 x >>segment.dat' 'CalculiX printed no displacements'
fake 'kill -9 $$' 'CalculiX failed: signal 9'

# the deck asks for nothing but itself: no name of a user's reaches it
sed 's/name: geometric centre/name: "*INCLUDE, INPUT=x"/' "$case" >"$work/names.yaml"
printf '#!/bin/sh\n/bin/cp segment.inp "%s/deck"\nexit 1\n' "$work" >"$work/bin/ccx"
expect 0 env TMPDIR="$work" PATH="$work/bin" "$program" compare "$work/names.yaml"
if grep -q INCLUDE "$work/deck"; then
    fail 'a name of the case stands in the deck'
fi
finish
