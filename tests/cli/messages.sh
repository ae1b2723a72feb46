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
finish
