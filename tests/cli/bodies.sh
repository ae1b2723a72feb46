#!/bin/sh
# 3D bodies that are no prisms: turning ones, robots that change along the rod, stacks; what cannot stand is refused.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

expect 0 "$program" fem "$source/cases/turning_30.yaml"
out 'way: doubling'
[ ! -s "$work/err" ] || fail 'a warning without a cause'
expect 0 "$program" fem "$source/cases/turning_30.yaml" --set fem.body=prism
err 'keeps the section of s = 0 mm'

# the strip of the helical robot passes through itself where its width does through zero
expect 2 "$program" fem "$source/cases/helical_segment.yaml" \
    --set 'section.shapes.1.sector.width_rad=pi/4 - pi*(s/L)'
one_line
err 'width_rad'

stack=$source/cases/voxel_stack/voxel_segment.yaml
expect 2 "$program" fem "$stack" --set fem.length_mm=121 --set rod.length_mm=130
one_line
err 'slices is 120 mm thick'
expect 2 "$program" fem "$stack" --set fem.size_mm=3
one_line
err 'leave nothing of the slices'
finish
