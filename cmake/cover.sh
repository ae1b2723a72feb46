#!/bin/sh
# Line coverage per room, by gcov's JSON; run by ./run cover after the tests.
set -eu
cd "${STIFFAXIS_SOURCE:-$(dirname "$0")/..}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
find build/cover -name '*.gcda' | while read -r data; do
    (cd "$work" && gcov --stdout "$OLDPWD/$data" 2>/dev/null) || true
done >"$work/all"
awk -F: '
    /^ *-: *0:Source:/ { split($0, part, "Source:"); file = part[2]; sub(/^.*\/(api|app|base|fem|io|meshes|reports|rodsolver|section)\//, "", file)
        room = part[2]; ours = match(room, /(api|app|base|fem|io|meshes|reports|rodsolver|section)\/[^\/]*\.c$/)
        room = ours ? substr(room, RSTART) : ""; next }
    room != "" { line = room ":" ($2 + 0); count = $1; gsub(/ /, "", count)
        if (count == "-") next
        seen[line] = 1; if (count !~ /^[#=]/) hit[line] = 1 }
    END { for (l in seen) { split(l, p, "/"); n[p[1]]++; if (l in hit) h[p[1]]++ }
        for (r in n) printf "%-10s %5d of %5d lines, %5.1f %%\n", r, h[r], n[r], 100 * h[r] / n[r] }' "$work/all" | sort
