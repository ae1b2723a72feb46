#!/bin/sh
# The page that people open: its size, every number of it against the JSON document of the same run, and in a browser, where there
# is one: no complaint, no request, sliders that move what is drawn, the keyboard, a phone, night, paper, and no WebGL.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

expect 0 "$program" run "$source/cases/constant_nc.yaml" --json --quiet --out "$work/result"
cp "$work/out" "$work/run.json"
page=$work/result/report.html
size=$(wc -c <"$page")
[ "$size" -lt 1500000 ] || fail "the page has $size bytes, wanted less than 1500000"

command -v python3 >/dev/null || {
    echo "page_browser: no python3 here, so the numbers are not compared"
    exit "$failures"
}
check() {
    python3 -B "$source/tests/cli/page_numbers.py" "$1" "$work/run.json"
}
check "$page" >"$work/told" || fail "$(cat "$work/told")"
# a check that can fail: one digit of a table, of the headline, of what a view says
for change in 's/29\.213042</29.213043</' 's/226\.4 </226.5 </' 's/bend 58\.41 deg/bend 58.42 deg/'; do
    sed "$change" "$page" >"$work/changed.html"
    if cmp -s "$page" "$work/changed.html" || check "$work/changed.html" >/dev/null; then
        fail "a digit that is wrong goes unnoticed: $change"
    fi
done

command -v chromium >/dev/null || {
    echo "page_browser: no chromium here, so the page is not opened"
    exit "$failures"
}

# in a browser: see there
python3 -B "$source/tests/cli/page_browser.py" "$page" "$work/run.json" "$work" || fail "the page in a browser"

# printed and without WebGL nothing is missing: the drawn pictures are all there
[ "$(grep -oE '<svg role|<img alt' "$page" | wc -l)" = 9 ] || fail "pictures are missing"

[ "$failures" = 0 ]
