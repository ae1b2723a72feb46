#!/bin/sh
# Meshes, STEP files and scripts as sections: each gives what the same shapes give, or one line; no file that they name makes the
# program run or write anything.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
files=$source/tests/files
witness=$work/witness
materials='materials:
  soft: {E_MPa: 1, nu: 0.3}
  stiff: {E_MPa: 5, nu: 0.4}'

# with SECTION-LINES: a case of this section
with() {
    printf 'format: 1\ntitle: from a file\n%s\nsection:\n  model: full\n  mesh: {order: 4}\n%s\n' "$materials" "$1" >"$work/case.yaml"
}
# entries of K on one line, as JSON has them
stiffness() {
    tr -d ' \n' <"$work/out" | sed 's/.*"K":\[\(\[[^]]*\],*\)\{6\}\].*/&/; s/.*"K":\[\[//; s/\]\].*//; s/\],\[/,/g'
}
# the largest difference of two such lines, relative to the diagonal, is below LIMIT
alike() {
    printf '%s\n%s\n' "$1" "$2" | awk -F, -v limit="$3" '
        { for (i = 0; i < 36; i++) k[NR, i] = $(i + 1) }
        END {
            for (i = 0; i < 6; i++) for (j = 0; j < 6; j++) {
                d = k[1, 6 * i + j] - k[2, 6 * i + j]
                scale = sqrt(k[1, 7 * i] * k[1, 7 * j])
                if (!(scale > 0) || d > limit * scale || -d > limit * scale) bad = 1
            }
            exit bad
        }' || fail "stiffnesses differ by more than $3"
}

# a STEP file, cut across its own axis, and the same shapes
with "  step:
    file: $files/bar.step
    origin_mm: [10, 20, 30]
    normal: [1, 0, 0]
    x_axis: [0, 1, 0]
    parts: [{name: jacket, material: soft}, {colour: '#ff0000', material: stiff}]"
expect 0 "$program" section "$work/case.yaml" --json
step=$(stiffness)
with "  shapes:
    - {disc: {radius_mm: 4}, material: soft}
    - {disc: {radius_mm: 2, centre_x_mm: 0.5}, material: stiff}"
expect 0 "$program" section "$work/case.yaml" --json
alike "$(stiffness)" "$step" 1e-5

# a mesh, and the script that made it
with "  msh: {file: $files/tongue_41_bytes_4.msh}"
expect 0 "$program" section "$work/case.yaml" --json
mesh=$(stiffness)
with "  geo: {file: $files/tongue.geo}"
expect 2 "$program" section "$work/case.yaml" --json
err '--allow-scripts'
one_line
expect 0 "$program" section "$work/case.yaml" --json --allow-scripts
# its nodes lie on the arcs; the file has them equally spaced on the polynomials through arcs of pi / 4: a^6 / 194000
alike "$(stiffness)" "$mesh" 1e-5

# content counts, not names
printf '#!/bin/sh\ntouch %s\n' "$witness" >"$work/a.msh"
chmod +x "$work/a.msh"
printf '$MeshFormat\n2.2 0 8\n$EndMeshFormat\nSystemCall "touch %s";\n' "$witness" >"$work/b.msh"
printf 'SystemCall "touch %s";\n' "$witness" >"$work/c.step"
head -c 9000 "$files/bar.step" >"$work/d.step"
printf 'ISO-10303-21;\nSystemCall "touch %s";\nEND-ISO-10303-21;\n' "$witness" >"$work/e.step"
mkfifo "$work/f.msh" "$work/f.step"
for file in a.msh b.msh c.step d.step e.step f.msh f.step absent.msh .; do
    for kind in msh step; do
        with "  $kind: {file: $file}"
        expect 3 "$program" section "$work/case.yaml"
        one_line
    done
done
[ -e "$witness" ] && fail 'a file made a program run'
finish
