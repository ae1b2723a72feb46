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
title: '"onload="document.title=1" <script>document.title="theirs"</script> <a href="javascript:document.title=1">a straight tip</a>'
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

command -v python3 >/dev/null || {
    echo "view: no python3 here, so the view itself is not tried"
    [ "$failures" = 0 ]
    exit
}
python3 -B "$source/tests/cli/view.py" "$page" "$work" || fail "the view in a browser"

[ "$failures" = 0 ]
