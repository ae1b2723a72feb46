#!/bin/sh
# The page that people open: its size, every number of it against the JSON document of the same run, and in a browser, where there
# is one: no complaint, no request, open within a second, and sliders that move what is drawn.
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
    python3 "$source/tests/cli/page_numbers.py" "$1" "$work/run.json"
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

# browse FILE: all of it in sight; its elements as they are in the end, what it told the console, and what was asked of the network
browse() {
    timeout 100 chromium --headless --no-sandbox --user-data-dir="$work/profile" --no-first-run --disable-background-networking \
        --disable-component-update --enable-logging=stderr --v=0 --virtual-time-budget=3000 --window-size=1200,9000 \
        --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --log-net-log="$work/net" \
        --dump-dom "file://$1" >"$work/dom" 2>"$work/told"
    [ -s "$work/dom" ] || fail "the browser shows nothing"
    if grep -E 'CONSOLE|Uncaught' "$work/told" | grep -qv 'INFO:CONSOLE.*GPU stall'; then
        fail "the console complains: $(grep -E 'CONSOLE|Uncaught' "$work/told" | head -1)"
    fi
}

browse "$page"
[ "$(grep -o 'data-state="live"' "$work/dom" | wc -l)" = 2 ] || fail "not both views are drawn"
# what the browser itself asks its maker stands there too
if grep -oE '"url":"(https?|wss?)://[^"/]*' "$work/net" | grep -qvE '(google|googleapis|gstatic|gvt1)\.com$'; then
    fail "the page asks the network: $(grep -oE '"url":"https?://[^"/]*' "$work/net" | sort -u | grep -vE "google|gstatic|gvt1")"
fi

# what a person does, without the policy, which would not let it: every solution, both colours, the segment's slider
{
    sed -e '/http-equiv="Content-Security-Policy"/d' -e 's,</body>,,' -e 's,</html>,,' "$page"
    cat <<'END'
<script>
setTimeout(() => {
    const [rod, segment] = document.querySelectorAll("figure.view"), told = {rods: [], segment: []};
    const set = (e, value, event) => { e.value = value; e.dispatchEvent(new Event(event)); };
    const state = (f) => Object.assign({words: f.querySelector(".words").textContent}, f.dataset);
    const slider = rod.querySelectorAll("input[type=range]:not([hidden])")[0];
    for (let i = 0; i <= Number(slider.max); i++) { set(slider, i, "input"); told.rods.push(state(rod)); }
    set(rod.querySelectorAll("select")[0], 1, "change");
    told.strain = rod.querySelector(".keys").textContent;
    set(slider, -1, "input");
    told.all = state(rod);
    const factor = segment.querySelector("output").parentNode.querySelector("input");
    [0, 20, 40].forEach((k) => { set(factor, k, "input"); told.segment.push(state(segment)); });
    told.requests = performance.getEntriesByType("resource").map((r) => r.name).filter((name) => !name.startsWith("data:"));
    told.ready = Number(document.documentElement.dataset.ready);
    told.marks = Array.from(document.querySelectorAll("svg .over")).map((g) => g.getAttribute("aria-label") + "|" + g.tabIndex);
    document.body.dataset.told = JSON.stringify(told);
}, 1500);
</script></body></html>
END
} >"$work/tried.html"
browse "$work/tried.html"
python3 - "$work/dom" "$work/run.json" <<'END' || fail "the views do not do what they should"
import html, json, re, sys
told = json.loads(html.unescape(re.search(r'data-told="([^"]*)"', open(sys.argv[1], encoding='utf-8').read())[1]))
run = json.load(open(sys.argv[2], encoding='utf-8'))
solutions, length = run['rod']['solutions'], 1e3 * run['rod']['length_m']
assert told['requests'] == [], told['requests']
# milliseconds; machines that run several tests at once are slow, so the second has a factor of safety of what is told
assert 0 < told['ready'] < 1000, told['ready']
assert len(told['rods']) == len(solutions)
quantum = length * 2 / 65535 + 1e-3  # coordinates are 16 bits of a box of the rod's size, told to a micrometre
for shown, s in zip(told['rods'], solutions):
    end = [float(x) for x in shown['end'].split()]
    assert all(abs(a - 1e3 * b) < quantum for a, b in zip(end, s['tip_position_m'])), (shown['end'], s['tip_position_m'])
    low, high = ([float(x) for x in shown[k].split()] for k in ('low', 'high'))
    # the section's radius is 4 mm: what is drawn lies around the centreline, and no further
    for d in range(3):
        line = [1e3 * p['p_m'][d] for p in s['shape']]
        assert min(line) - 4.1 < low[d] <= min(line) + 0.1 and max(line) - 0.1 <= high[d] < max(line) + 4.1, (d, low, high)
assert len({shown['end'] for shown in told['rods']}) == len(solutions)
assert told['all']['shown'].count(';') == len(solutions) - 1
assert 'strain' in told['strain'], told['strain']
# the segment: at rest, as the slider begins, and twice that
low, high = ([[float(x) for x in s[k].split()] for s in told['segment']] for k in ('low', 'high'))
assert abs(high[0][2] - 1e3 * run['fem']['length_m']) < 0.01 and abs(high[0][0] - 4) < 0.01, high
once, twice = high[1][0] - high[0][0], high[2][0] - high[0][0]
load = run['fem']['loads'][0]
assert once > 0.5 and abs(twice - 2 * once) < 0.05 * once, (once, twice)
assert 0.8 < once / (1e3 * load['tip_displacement_m'][0]) < 1.2, (once, load['tip_displacement_m'])
# values over the section: materials, axes and centres, all within reach of the keyboard
assert all(m.endswith('|0') for m in told['marks'])
at = run['section']['stations'][0]['stiffness_centre_m'][0]
want = 'stiffness centre: (%.5f' % (1e3 * at)
assert any(m.replace('\u2212', '-').startswith(want) for m in told['marks']), told['marks']
assert sum('E = ' in m for m in told['marks']) == 2
END

# printed and without WebGL nothing is missing: the drawn pictures are all there
[ "$(grep -oE '<svg role|<img alt' "$page" | wc -l)" = 8 ] || fail "pictures are missing"

[ "$failures" = 0 ]
