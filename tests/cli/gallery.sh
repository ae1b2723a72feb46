#!/bin/sh
# The gallery in small, ./run gallery: a case with its picture, one that another command runs, and one that fails.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
export PYTHONDONTWRITEBYTECODE=1

command -v python3 >/dev/null || {
    echo "gallery: no python3 here"
    exit 0
}
maker=$source/tests/pages/gallery.py
page=$work/gallery/index.html
# page TEXT, and what must not be there
page() {
    grep -qF -- "$1" "$page" || fail "the page does not say '$1'"
}

expect 0 python3 "$maker" --program "$program" --out "$work/gallery" yu_pipe design
out '2 cases, 1 of them run'
page 'Yu&#x27;s two-ply pipe'
page 'stiffaxis run cases/yu_pipe.yaml --out results/yu_pipe'
page '<img src="data:image/svg+xml;base64,'
page 'href="yu_pipe/report.html"'
page 'stiffaxis design cases/endoscope/design.yaml'
page "default-src 'none'"
[ -s "$work/gallery/yu_pipe/report.html" ] || fail 'no page of the case'
# the picture is the one that the run drew
sed -n 's/.*svg+xml;base64,\([^"]*\)".*/\1/p' "$page" | base64 -d >"$work/drawn.svg"
cmp -s "$work/drawn.svg" "$work/gallery/yu_pipe/section.svg" || fail 'the picture is another one'
if grep -oE '(src|href)="[^"]*' "$page" | grep -qvE '="(data:|#|yu_pipe/)'; then fail 'the page asks for something else'; fi

# every case of cases/ has its place, with a word on those that run by another command
expect 0 python3 "$maker" --program "$program" --out "$work/gallery" --again
for file in "$source"/cases/*.yaml "$source"/cases/*/*.yaml; do
    page "<section class=\"card\" id=\"$(basename "$file" .yaml)\">"
done

# a run of one case leaves those of the others where they are
expect 0 python3 "$maker" --program "$program" --out "$work/gallery" yu_box15
expect 0 python3 "$maker" --program "$program" --out "$work/gallery" --again
out ' 2 of them run'
page 'href="yu_pipe/report.html"'
page 'href="yu_box15/report.html"'

# what fails is told
printf '#!/bin/sh\necho "the <b>disk</b> is full" >&2\nexit 5\n' >"$work/full"
chmod +x "$work/full"
expect 1 python3 "$maker" --program "$work/full" --out "$work/gallery2" yu_pipe
out 'yu_pipe: exit code 5: the <b>disk</b> is full'
page=$work/gallery2/index.html
page 'exit code 5: the &lt;b&gt;disk&lt;/b&gt; is full'
expect 1 python3 "$maker" --program "$program" --out "$work/gallery" nothing
err 'no case is called nothing'
finish
