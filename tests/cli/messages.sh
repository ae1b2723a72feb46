#!/bin/sh
# What is said about what people write wrong, word by word: one line with its place, what is wrong, what is allowed, the near
# word. tests/data/messages.txt has the mistakes.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
data=$source/tests/data

awk -v work="$work" -f "$source/tests/cli/messages.awk" "$data/messages.yaml" "$data/messages.txt" || fail 'the table is broken'
number=1
while [ -d "$work/$number" ]; do
    cd "$work/$number" || exit 1
    read -r command <command
    code=0
    eval "\"\$program\" $command" >out 2>err </dev/null || code=$?
    { printf '%s ' "$code" && cat err; } >got
    if ! cmp -s got wanted; then
        fail "row $number, stiffaxis $command"
        diff wanted got
    fi
    number=$((number + 1))
done
[ "$number" -gt 60 ] || fail "only $number rows"

# other files than cases, by how they begin
cd "$work" || exit 1
other() {
    expect 2 "$program" check "$1"
    err "$1: error: this is $2, not a case"
    one_line
}
cp "$source/cases/voxel_stack/slice_00.png" image
other image 'a PNG image'
{ printf '\211HDF\r\n\032\n' && head -c 90 /dev/zero; } >results
other results 'an HDF5 file'
{ head -c 80 /dev/zero && printf '\001\000\000\000' && head -c 50 /dev/zero; } >surface
other surface 'an STL surface'

# examples that are named have what is asked for
for part in section:fig4 rod:constant_nc fem:fig4 reach:endoscope; do
    "$program" example "${part#*:}" --bare 2>/dev/null | grep -q "^${part%:*}:" || fail "no ${part%:*} in ${part#*:}"
done
# a stack named as in a shell
expect 2 "$program" check "$source/cases/voxel_stack/voxel_stack.yaml" --set 'section.png.file=slice_*.png'
err "'slice_*.png' names no file: write %d instead of * where the number of a slice stands, or %03d for three digits"
finish
