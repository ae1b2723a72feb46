#!/bin/sh
# The verification page in small, ./run verification: two quick tests, and one with a wrong number, which must show.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
export PYTHONDONTWRITEBYTECODE=1

command -v python3 >/dev/null || {
    echo "verification: no python3 here, so there is no page"
    exit 0
}
maker=$source/tests/pages/verification.py
built=$(dirname "$(dirname "$program")")
page=$work/page/index.html

# page TEXT, and what must not be there
page() {
    grep -qF -- "$1" "$page" || fail "the page does not say '$1'"
}
no_page() {
    ! grep -qF -- "$1" "$page" || fail "the page says '$1'"
}

# every test says what it is held against
silent=$(grep -L 'against(' "$source"/tests/verify/*/verify_*.c)
[ -z "$silent" ] || fail "no word on what they are held against: $silent"

expect 0 python3 "$maker" --build "$built" --out "$work/page" --jobs 1 verify_becas verify_rod_order
out '0 do not hold'
page "Content-Security-Policy"
page "BECAS user&#x27;s guide"
page 'compare <small>S2, K35</small>'
page 'order is six (verify_rod_order)'
page 'order 6: 5.9'
no_page 'class="bad"'
no_page '://'

# what the page tells is what the test has judged: all numbers of a told check stand in a row of it
python3 - "$work/page" <<'END' || fail "a number of the record is not on the page"
import json, pathlib, sys
folder = pathlib.Path(sys.argv[1])
page = (folder / 'index.html').read_text()
told = [json.loads(line) for line in (folder / 'records/section.verify_becas.jsonl').read_text().splitlines()]
worst = max((r for r in told if r['kind'] == 'check' and r['tolerance']), key=lambda r: r['error'] / r['tolerance'])
row = f"<td>{worst['value']:.9g}</td><td>{worst['wanted']:.9g}</td>"
sys.exit(0 if row in page and len(told) > 35 else 1)
END

# a run of one test leaves the records of the others where they are
expect 0 python3 "$maker" --build "$built" --out "$work/page" --jobs 1 verify_rod_order
expect 0 python3 "$maker" --build "$built" --out "$work/page" --again verify_becas verify_rod_order
page 'BECAS user&#x27;s guide'
page 'order is six (verify_rod_order)'

# a wrong number, one that is none, a slope that is off and a program that breaks off
mkdir -p "$work/broken/bin" "$work/section"
cat >"$work/section/verify_becas.c" <<'END'
#include "tests/test.h"

static void slopes(void)
{
    const double h[3] = {1, 0.5, 0.25}, error[3] = {1e-2, 5e-3, 2.5e-3};
    CHECK_WITHIN(observed_order(3, h, error), 2, 0.1);
}

static void bounds(void)
{
    CHECK_AT_LEAST(3.0, 3.0);
    CHECK_AT_MOST(3.0, 3.0);
    CHECK_ABOVE(0.5, 2.0);
}

int main(void)
{
    against(BY_CLOSED_FORM, "a \"made\" <b>mistake</b>");
    CHECK_NEAR(1.25, 1.0, 0.2);
    for (int i = 0; i < 1000; i++) {
        CHECK_BELOW(i == 700 ? NAN : 1e-3 * i, 2.0);
    }
    CHECK(1 + 1 == 2);
    slopes();
    bounds();
    return test_failures != 0;
}
END
cat >"$work/section/verify_full.c" <<'END'
#include "tests/test.h"

int main(void)
{
    against(BY_SYMMETRY, "nothing");
    CHECK_NEAR(1.0, 1.0, 0);
    abort();
}
END
for one in verify_becas verify_full; do
    # _POSIX_C_SOURCE as the tests have it
    "${CC:-cc}" -std=c11 -D_POSIX_C_SOURCE=200809L -I"$source" "$work/section/$one.c" -o "$work/broken/bin/$one" -lm ||
        fail "$one.c does not compile"
done
expect 1 python3 "$maker" --build "$work/broken" --out "$work/page" --jobs 1 verify_becas verify_full verify_patch
out 'section/verify_becas: 4 checks do not hold'
out '1005 numbers and 1 conditions in 3 programs'
out 'section/verify_full: did not come to its end'
out 'fem/verify_patch: left no record'
page '2 of 1002 fail'
page 'no number of 2 allowed'
page '<td>1.25</td><td>1</td><td>0.25</td><td>0.2</td>'
page '1 of 1 fail'
page '0.5, at least 2'
page '<td>3</td><td>≥ 3</td>'
page '<dt>Conditions without a number</dt><dd>1 '
page 'ran in the short form'
page 'a &quot;made&quot; &lt;b&gt;mistake&lt;/b&gt;'
page 'order 1: 1.00'
no_page '<b>mistake'

# whole campaigns are told as such, and what was recorded so stays so
expect 1 python3 "$maker" --build "$work/broken" --out "$work/page" --jobs 1 --long verify_full
page 'The tests ran whole'
expect 1 python3 "$maker" --build "$work/broken" --out "$work/page" --again verify_becas verify_full
page 'others whole'

expect 2 python3 "$maker" --build "$built"
expect 1 python3 "$maker" --build "$built" --out "$work/page" verify_nothing
err 'no test is called verify_nothing'
finish
