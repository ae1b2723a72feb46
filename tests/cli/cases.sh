#!/bin/sh
# Every case of the repository is valid, and the program carries it byte for byte, or with a comment for every key and nothing
# else, with the files that it reads.
set -u
leaks=yes
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

# words FILE: what is left without comments and blanks at line ends
words() {
    sed -E 's/^ *#.*//; s/ #[^"]*$//; s/ +$//; /^$/d' "$1"
}

expect 0 "$program" example --quiet
[ ! -s "$work/err" ] || fail 'hints in spite of --quiet'
names=$(cut -d' ' -f1 "$work/out")
for file in "$source"/cases/*.yaml; do
    echo " $names " | tr '\n' ' ' | grep -q " $(basename "$file" .yaml) " || fail "no example of $file"
done
count=0
for name in $names; do
    count=$((count + 1))
    file=$(find "$source/cases" -name "$name.yaml")
    expect 0 "$program" example "$name" --bare
    cmp -s "$file" "$work/out" || fail "example $name --bare is not $file"
    words "$file" >"$work/bare.words"
    expect 0 "$program" example "$name" --out "$work/$name" --quiet
    cmp -s "$work/out" "$work/$name/$name.yaml" || fail "example $name is not what it writes"
    words "$work/out" | cmp -s - "$work/bare.words" || fail "example $name says more than $file"
    bare=$(awk -f "$source/tests/cli/bare_keys.awk" "$work/out")
    [ -z "$bare" ] || fail "keys of example $name without a comment:" $bare
    awk 'length($0) > 140 { exit 1 }' "$work/out" || fail "example $name has lines longer than 140"
    case $name in
        scan) expect 0 "$program" scan "$work/$name/$name.yaml" ;;
        endoscope | design) [ -s "$work/$name/ventricle.py" ] || fail "no ventricle.py beside $name" ;;
        *)
            expect 0 "$program" check "$work/$name/$name.yaml" --json
            grep -v '"case":' "$work/out" >"$work/commented.json"
            expect 0 "$program" check "$file" --json
            grep -v '"case":' "$work/out" | cmp -s - "$work/commented.json" ||
                fail "example $name is another case than $file"
            ;;
    esac
done
[ "$count" -ge 29 ] || fail "only $count examples"

# the checker sees what is missing
[ "$(awk -f "$source/tests/cli/bare_keys.awk" "$source/cases/fig4.yaml" | wc -l)" -ge 20 ] || fail 'bare keys are not seen'
# standard input, as people try it
"$program" example fig4 | "$program" check - >/dev/null || fail 'example fig4 | check -'

# what is printed has no colours and no progress when it goes into a file
expect 0 "$program" compare "$source/cases/helical_nc.yaml"
[ ! -s "$work/err" ] || fail 'progress without a terminal'
if grep -q "$(printf '\033')" "$work/out"; then
    fail 'colours without a terminal'
fi
finish
