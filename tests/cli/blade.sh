#!/bin/sh
# The blade of tests/data/iea22_r050.txt as users would have it, a gmsh mesh with an angle per element and a case: the published
# 6x6 within 2e-5.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
data=$source/tests/data/iea22_r050.txt

awk '
function angle(c, s) { return atan2(s, c) }
/^#/ { next }
!left { what = $1; left = what == "groups" ? $3 + $2 : $2; total = left; groups = $2; element = $3; next }
what == "frames" { plane[nframe++] = angle($1, $2); left--; next }
what == "nodes" {
    if (left == total) printf "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n", total
    x += $1; y += $2
    printf "%d %.9f %.9f 0\n", ++node, x * 1e-6, y * 1e-6
    if (--left == 0) print "$EndNodes"
    next
}
what == "groups" {
    if (left == total) printf "$Elements\n%d\n", element
    left--
    if (!of_group) { material = $1; frame = $2; of_group = $3; next }
    of_group--
    first += $1
    printf "%d 2 2 %d %d %d %d %d\n", ++made, material + 1, material + 1, first + 1, first + $2 + 1, first + $3 + 1
    turned[made] = plane[frame]
    if (left == 0) {
        printf "$EndElements\n$ElementData\n1\n\"plane_angle_rad\"\n1\n0\n3\n0\n1\n%d\n", made
        for (i = 1; i <= made; i++) printf "%d %.12f\n", i, turned[i]
        print "$EndElementData"
    }
    next
}
{ left-- }' "$data" >"$work/mesh.msh"

# physical names go before the nodes
{
    sed -n '1,3p' "$work/mesh.msh"
    printf '$PhysicalNames\n6\n'
    for k in 1 2 3 4 5 6; do
        printf '2 %s "ply%s"\n' $k $k
    done
    printf '$EndPhysicalNames\n'
    sed '1,3d' "$work/mesh.msh"
} >"$work/blade.msh"

awk '
BEGIN {
    printf "format: 1\ntitle: blade of the IEA 22 MW turbine at half its length\nmaterials:\n"
    split("E1_Pa E2_Pa E3_Pa G12_Pa G13_Pa G23_Pa nu12 nu13 nu23", name)
    split("3 1 2 6 4 5", ours) # stretch, shear, twist, bending
}
/^#/ { next }
!left { what = $1; left = what == "groups" ? $3 + $2 : $2; next }
what == "materials" {
    printf "  ply%d: {", ++ply
    for (i = 1; i <= 9; i++) printf "%s%s: %s", (i > 1 ? ", " : ""), name[i], $i
    print "}"
}
what == "stiffness" {
    if (!row++) printf "section:\n  model: full\n  msh: {file: blade.msh, unit: m}\n  reference:\n    source: VABS\n    tolerance: 2e-5\n    K:\n"
    for (i = 1; i <= 6; i++) printf "      - [%d, %d, %s]\n", ours[row], ours[i], $i
}
{ left-- }' "$data" >"$work/blade.yaml"

expect 0 "$program" compare "$work/blade.yaml"
[ "$(grep -c 'against the published .* ok$' "$work/out")" -eq 36 ] || fail 'not all 36 entries were compared'
expect 1 "$program" compare "$work/blade.yaml" --set section.reference.tolerance=1e-8
finish
