#!/bin/sh
# Every case of the repository is valid, and the program carries it byte for byte.
set -u
leaks=yes
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

count=0
for file in "$source"/cases/*.yaml; do
    name=$(basename "$file" .yaml)
    count=$((count + 1))
    expect 0 "$program" check "$file"
    expect 0 "$program" example "$name"
    cmp -s "$file" "$work/out" || fail "example $name is not $file"
    "$program" example "$name" | "$program" check - >/dev/null || fail "example $name | check -"
done
[ "$count" -ge 6 ] || fail "only $count cases"
expect 0 "$program" example
[ "$(wc -l <"$work/out")" -eq "$count" ] || fail 'the list of examples is not complete'

# what is printed has no colours and no progress when it goes into a file
expect 0 "$program" compare "$source/cases/helical_nc.yaml"
[ ! -s "$work/err" ] || fail 'progress without a terminal'
if grep -q "$(printf '\033')" "$work/out"; then
    fail 'colours without a terminal'
fi
finish
