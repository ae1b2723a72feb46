#!/bin/sh
# The page's view in space: one file with nothing from outside, whose policy lets its own two scripts run and no other; and in
# a browser, where there is one, a view that is drawn, chosen from and, without WebGL, told to be left out.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

ball 20 20 0 15 >"$work/ball.stl"
cat >"$work/targets.csv" <<'END'
name,x [mm],y [mm],z [mm]
on,0,0,15
</script><script>document.title='theirs'</script>,0.9,0,15
off,9,0,15
END
cat >"$work/case.yaml" <<'END'
format: 1
title: a straight tip in a ball
reach:
  tissue: ball.stl
  tissue_unit: mm
  targets: targets.csv
  entry: {point_mm: [0, 0, -20], direction: [0, 0, 3]}
  synthetic: true
  scopes:
    - {name: long, radius_mm: 1.4, insertion_mm: [0, 60], constant_curvature: {length_mm: 10, bend_deg: [0, 0]}}
    - {name: "</script><b>short", radius_mm: 1.4, insertion_mm: [0, 20], constant_curvature: {length_mm: 10, bend_deg: [0, 0]}}
END
expect 0 "$program" reach "$work/case.yaml" --out "$work/result" --quiet
page=$work/result/report.html

# --- the file

count() {
    grep -o "$2" "$1" | wc -l
}

[ "$(count "$page" '<script')" = 3 ] || fail "the page has not three scripts: a scene, three.js and its own"
[ "$(count "$page" '</script')" = 3 ] || fail "a name ends a script"
grep -q "default-src 'none'" "$page" || fail "the page has no policy"
grep -q 'three.js authors' "$page" || fail "three.js has no notice"
if grep -qE '(src|href)="(https?:|//)' "$page"; then
    fail "the page fetches something"
fi
size=$(wc -c <"$page")
[ "$size" -lt 1500000 ] || fail "the page has $size bytes"
expect 0 "$program" report "$work/result/result.hdf" --out "$work/again" --quiet
cmp -s "$page" "$work/again/report.html" || fail "the same result makes another page"

# the hashes of the policy are those of the scripts
if command -v python3 >/dev/null; then
    python3 - "$page" <<'END' || fail "the policy does not let the page's scripts run"
import base64, gzip, hashlib, json, re, sys
page = open(sys.argv[1], encoding='utf-8').read()
scripts = re.findall(r'<script>(.*?)</script>', page, re.S)
hashes = re.findall(r"'sha256-([^']*)'", page)
packed = re.search(r'<script type="application/gzip" id="three">(.*?)</script>', page, re.S)[1]
scripts.insert(0, gzip.decompress(base64.b64decode(packed)).decode())
made = [base64.b64encode(hashlib.sha256(s.encode()).digest()).decode() for s in scripts]
scene = json.loads(re.search(r'<script type="application/json"[^>]*>(.*?)</script>', page, re.S)[1])
assert made == hashes and len(made) == 2
assert scene['choices'][0]['options'] == ['long', '</script><b>short']
END
fi

# --- in a browser

if ! command -v chromium >/dev/null; then
    echo "view: no chromium here, so the view itself is not tried"
    [ "$failures" = 0 ]
    exit
fi

# browse FILE [OPTION...]: the page, all of it in sight, as it stands after three seconds of its own time, and what it told the console
browse() {
    file=$1
    shift
    timeout 100 chromium --headless --no-sandbox --disable-gpu --user-data-dir="$work/profile" --enable-logging=stderr --v=0 \
        --virtual-time-budget=3000 --window-size=1200,6000 "$@" --dump-dom "file://$file" >"$work/dom" 2>"$work/told"
    [ -s "$work/dom" ] || fail "the browser shows nothing"
}
drawn='--use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader'
complaint='Uncaught|Refused|Content Security Policy|THREE\.'

# shellcheck disable=SC2086
browse "$page" $drawn
grep -q 'data-state="live"' "$work/dom" || fail "the view is not drawn"
grep -q '<canvas' "$work/dom" || fail "the view has no canvas"
if grep -qE "$complaint" "$work/told"; then
    fail "the console complains: $(grep -E "$complaint" "$work/told" | head -1)"
fi

# what a person does: the second scope, the second target, the map on, a key; without the policy, which would not let it
{
    sed -e '/http-equiv="Content-Security-Policy"/d' -e 's,</body>,,' -e 's,</html>,,' "$page"
    cat <<'END'
<script>
setTimeout(() => {
    const choose = (select, value) => { select.value = value; select.dispatchEvent(new Event("change")); };
    const selects = document.querySelectorAll("figure.view select"), boxes = document.querySelectorAll("figure.view input[type=checkbox]");
    const told = () => document.querySelector("figure.view .words").textContent;
    const log = [told()];
    choose(selects[0], 1); choose(selects[1], 1); log.push(told());
    choose(selects[0], 0); log.push(told());
    boxes.forEach((box) => box.click());
    const stage = document.querySelector("figure.view .stage");
    ["ArrowLeft", "ArrowUp", "+", "-", "0"].forEach((key) => stage.dispatchEvent(new KeyboardEvent("keydown", {key: key, cancelable: true})));
    document.body.dataset.told = log.join("|");
    document.body.dataset.tags = document.querySelectorAll("figure.view b").length;
}, 1500);
</script></body></html>
END
} >"$work/tried.html"
# shellcheck disable=SC2086
browse "$work/tried.html" $drawn
grep -q 'data-tags="0"' "$work/dom" || fail "a name became markup"
told=$(grep -o 'data-told="[^"]*"' "$work/dom")
case $told in
*'long (constant curvature): 2 of 3 targets reached.|'*'short (constant curvature): 0 of 3'*'Target 2: '*'Target 2: '*reached*) ;;
*) fail "choices are not told: $told" ;;
esac
if grep -qE "$complaint" "$work/told"; then
    fail "the console complains when choices are made: $(grep -E "$complaint" "$work/told" | head -1)"
fi

# a script that is not the page's own does not run
sed 's,</body>,<script>document.body.dataset.state = "theirs"</script></body>,' "$page" >"$work/theirs.html"
browse "$work/theirs.html" --disable-3d-apis
if grep -q 'data-state="theirs"' "$work/dom"; then
    fail "the page's policy lets any script run"
fi
# and without WebGL a line says so
grep -q 'data-state="still"' "$work/dom" || fail "without WebGL the view does not say so"

[ "$failures" = 0 ]
