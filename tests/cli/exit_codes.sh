#!/bin/sh
# Every class of error has its exit code and one line on stderr.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
cases=$source/cases

# 0
expect 0 "$program" --help
out 'usage: stiffaxis'
expect 0 "$program" rod --help
out 'example'
expect 0 "$program" --version
expect 0 "$program" check "$cases/fig4.yaml"

# 2: usage
expect 2 "$program"
expect 2 "$program" sektion "$cases/fig4.yaml"
err "did you mean 'section'?"
one_line
expect 2 "$program" section "$cases/fig4.yaml" --jsno
err "did you mean '--json'?"
expect 2 "$program" section
expect 2 "$program" section "$cases/fig4.yaml" --out
expect 2 "$program" section "$cases/fig4.yaml" --set model
expect 2 "$program" section "$cases/fig4.yaml" "$cases/fig4.yaml"
expect 2 "$program" section "$cases/fig4.yaml" --json=yes
expect 2 "$program" schema --set a=b
expect 2 "$program" example fig5
err "did you mean 'fig4'?"
expect 2 "$program" rod "$cases/fig4.yaml"
err "the case has no 'rod'"

# 2: case file, with its place
expect 2 "$program" check "$work/missing.yaml"
one_line
sed 's/outer_radius_mm: 4,/outer_radius_mm: 4, outer_radus_mm: 5,/' "$cases/fig4.yaml" >"$work/unknown.yaml"
expect 2 "$program" check "$work/unknown.yaml"
line=$(grep -n outer_radus "$work/unknown.yaml" | head -1 | cut -d: -f1)
err "$work/unknown.yaml:$line:"
err "error: unknown key 'outer_radus_mm' (did you mean 'outer_radius_mm'?)"
one_line
sed 's/material: stiff/material: stif/' "$cases/fig4.yaml" >"$work/material.yaml"
expect 2 "$program" check "$work/material.yaml"
line=$(grep -n 'material: stif}' "$work/material.yaml" | cut -d: -f1)
err "$work/material.yaml:$line:"
one_line
sed 's/format: 1/format: 2/' "$cases/fig4.yaml" >"$work/format.yaml"
expect 2 "$program" check "$work/format.yaml"
expect 2 "$program" section "$cases/fig4.yaml" --set section.modell=full
err "did you mean 'model'?"
expect 2 "$program" section "$cases/helical_nc.yaml" --set section.stations_mm=130
expect 2 "$program" fem "$cases/constant_nc.yaml" --set fem.section_at_mm=130

# 3: a damaged or foreign input file
echo 'no HDF5 file' >"$work/result.hdf"
expect 3 "$program" report "$work/result.hdf" --out "$work/report"
one_line

# 4: past the tension at which a tendon eats its own length there is no answer
expect 4 "$program" rod "$cases/homogeneous_tube.yaml" --set 'rod.tensions_N=[[4.1]]'
one_line

# 1: the comparison is told, and out of tolerance
expect 1 "$program" compare "$cases/fig4.yaml" --set fem.order=1 --set fem.layers=2
out 'OUT'
err 'out of tolerance'

# 5: stdout is full or closed
if [ -e /dev/full ]; then
    "$program" check "$cases/fig4.yaml" >/dev/full 2>"$work/err"
    [ $? = 5 ] || fail 'a full stdout is not exit code 5'
    err 'cannot write to stdout'
fi

# 130: interrupted
if command -v timeout >/dev/null; then
    expect 130 timeout --preserve-status -s INT 1 "$program" fem "$cases/fig4.yaml" \
        --set fem.order=4 --set fem.layers=150 --set fem.size_mm=0.3
    err 'interrupted'
fi
finish
