#!/bin/sh
# A scanned cloud to its centreline; and files that are none, one clear line each. All clouds here are synthetic.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

# tube COUNT FORMAT: points of a tube of 4 mm around an arc of 60 mm radius, 2 rad long, from the origin along z
tube() {
    awk -v n="$1" -v format="$2" 'BEGIN {
        srand(5)
        for (i = 0; i < n; i++) {
            t = 2 * rand(); a = 6.283185307 * rand(); r = 4 + 0.05 * (rand() + rand() - rand() - rand())
            x = 60 * (1 - cos(t)) + r * cos(a) * cos(t)
            z = 60 * sin(t) - r * cos(a) * sin(t)
            printf format "\n", x, r * sin(a), z
        }
    }'
}
tube 8000 '%.4f %.4f %.4f' >"$work/tube.xyz"

# --- the pleasant path

expect 0 "$program" scan "$work/tube.xyz" --set scan.radius_mm=4
out 'text, 3 columns, 8000 points in mm'
out 'radius 4 mm as stated'
out "frame    of the body's own base; free in its turn about z"
expect 0 "$program" scan --help
out 'scan.radius_mm'

# two ways to write the same cloud, and the same line
expect 0 "$program" scan "$work/tube.xyz" --set scan.radius_mm=4 --json --quiet
cp "$work/out" "$work/xyz.json"
valid_json "$work/xyz.json"
grep -q '"stiffaxis/scan/1"' "$work/xyz.json" || fail 'the document has no schema'
{
    printf 'ply\nformat ascii 1.0\nelement vertex 8000\nproperty float x\nproperty float y\nproperty float z\nend_header\n'
    cat "$work/tube.xyz"
} >"$work/tube.bin"
expect 0 "$program" scan "$work/tube.bin" --set scan.radius_mm=4 --json --quiet
sed -n '/"centreline"/,$p' "$work/out" >"$work/ply.line"
sed -n '/"centreline"/,$p' "$work/xyz.json" | cmp -s - "$work/ply.line" || fail 'PLY and XYZ give other lines'
{
    echo 'x [m], y [m], z [m]'
    awk '{ printf "%.7f,%.7f,%.7f\n", $1 / 1000, $2 / 1000, $3 / 1000 }' "$work/tube.xyz"
} >"$work/tube.csv"
expect 0 "$program" scan "$work/tube.csv" --set scan.radius_mm=4
out 'points in m by its columns'

# settings in a file, the cloud beside it; three features fix the frame: turned by a right angle about z
cat >"$work/scan.yaml" <<END
format: 1
title: an arc
scan:
  cloud: tube.xyz
  synthetic: true
  radius_mm: 4
  length_mm: 120
  fiducials:
    - {name: left, cloud_mm: [20, 0, 0], rod_mm: [0, 20, 0], sigma_mm: 0.1}
    - {name: right, cloud_mm: [-20, 0, 0], rod_mm: [0, -20, 0], sigma_mm: 0.1}
    - {name: front, cloud_mm: [0, 30, 0], rod_mm: [-30, 0, 0], sigma_mm: 0.1}
END
expect 0 "$program" scan "$work/scan.yaml" --out "$work/result"
paper "$work/result"
out 'synthetic: made, not measured'
out 'fiducial left: 0.0000 mm'
for name in centreline.csv centreline.vtk scan.json scan.svg scan.pdf scan.png; do
    [ -s "$work/result/$name" ] || fail "no $name"
done
valid_json "$work/result/scan.json"
sed -n 2p "$work/result/centreline.csv" | grep -q '^# SYNTHETIC' || fail 'centreline.csv is not called synthetic'
[ "$(head -1 "$work/result/centreline.csv" | tr -d '\r')" = s_mm,x_mm,y_mm,z_mm,sigma_mm,fit_sigma_mm ] ||
    fail 'the names of centreline.csv'
# the tip of the arc: 60 (1 - cos 2) = 84.97 along the rod's y, 60 sin 2 = 54.56 up
tail -1 "$work/result/centreline.csv" | awk -F, '{
    exit !($1 > 119.5 && $1 < 120.5 && $2 * $2 < 0.04 && ($3 - 84.969) ^ 2 < 0.09 && ($4 - 54.558) ^ 2 < 0.09) }' ||
    fail "the tip: $(tail -1 "$work/result/centreline.csv")"
# without a mark the line says so, and how far its errors go together; without a file of settings keys need no `scan.`
expect 0 "$program" scan "$work/tube.xyz" --set radius_mm=4 --out "$work/unmarked"
out 'radius 4 mm as stated'
grep -q '^# the frame is free in its turn about z' "$work/unmarked/centreline.csv" || fail 'no word of the free turn'
grep -Eq '^# correlation_length_mm: [0-9.]+' "$work/unmarked/centreline.csv" || fail 'no correlation length'
! grep -q 'free in its turn' "$work/result/centreline.csv" || fail 'fiducials called free'
expect 2 "$program" scan "$work/tube.xyz" --set colour=red
err "unknown key 'colour'"
# a unit that makes a body of no robot: said, with the one that would
awk '{ printf "%.7f %.7f %.7f\n", $1 / 1000, $2 / 1000, $3 / 1000 }' "$work/tube.xyz" >"$work/metres.xyz"
expect 0 "$program" scan "$work/metres.xyz"
err 'perhaps it is in m'
out 'DOUBT'
expect 0 "$program" scan "$work/tube.xyz" --set unit=m
err 'perhaps it is in mm'
expect 0 "$program" scan "$work/tube.xyz"
! grep -q warning "$work/err" || fail 'a doubt of 4 mm'
# what it writes, a case reads (the other programs that a comparison asks have tests of their own)
sed 's/^  tensions_N:.*/  tensions_N: [[0.49, 0]]/; /^measured:/,$d' "$source/cases/constant_nc.yaml" >"$work/case.yaml"
cat >>"$work/case.yaml" <<END
measured:
  shapes: [{name: arc, csv: result/centreline.csv, solution: 1}]
END
expect 0 env PATH="$work/nothing" "$program" compare "$work/case.yaml"
out 'SYNTHETIC'
expect 2 "$program" scan "$work/scan.yaml" --out "$work/result"
err '--force replaces it'
expect 0 "$program" scan "$work/scan.yaml" --out "$work/result" --force --set scan.spacing_mm=5
expect 0 "$program" scan "$work/scan.yaml" --set scan.fiducials.0.name=post
out 'fiducial post'

# a mark fixes the turn, a box keeps the hand out
expect 0 "$program" scan "$work/tube.xyz" --set 'scan={radius_mm: 4, base: {point_mm: [0, 0, 0], direction: [0, 0, 1]},
    mark: {point_mm: [10, 0, 3], angle_deg: 90}, box_mm: [[-20, -20, -5], [120, 20, 60]]}'
out "by the body's own base and the mark"

# --- settings that cannot be

expect 2 "$program" scan "$work/scan.yaml" --set scan.fiducials.1.rod_mm='[0, 0.1, 0]'
err 'fiducials'
one_line
expect 2 "$program" scan "$work/scan.yaml" --set 'scan.plate={noise_mm: 0.1}'
err 'leave plate and mark out'
one_line
expect 2 "$program" scan "$work/tube.xyz" --set scan.radius=4
err "key 'radius' needs its unit: radius_mm"
one_line
expect 2 "$program" scan "$work/tube.xyz" --set scan.raduis_mm=4
err "did you mean 'radius_mm'?"
one_line
expect 2 "$program" scan "$work/tube.xyz" --set scan.cloud=other.ply
one_line
expect 2 "$program" scan "$work/tube.csv" --set scan.unit=mm
err 'its columns are in m'
one_line
expect 2 "$program" scan

# --- files that are no scan: exit code 3, one line that names the file, quickly

# refused WORDS FILE [OPTION...]
refused() {
    words=$1
    shift
    expect 3 timeout 60 "$program" scan "$@" --out "$work/none"
    err "$words"
    err "$1"
    one_line
    [ ! -e "$work/none" ] || fail "$1: something was written"
}
: >"$work/empty.ply"
refused 'it is empty' "$work/empty.ply"
refused 'No such file' "$work/missing.ply"
refused 'it is a directory' "$work"
mkfifo "$work/pipe"
refused 'it is no regular file' "$work/pipe"
echo '1 2 3' >"$work/one.xyz"
refused '1 point: too few to show a tube' "$work/one.xyz"
yes 'nan nan nan' | head -500 >"$work/nan.xyz"
refused 'none of its 500 points is a finite place' "$work/nan.xyz"
echo '1 2 3 4 5 6 7 8 9 10' >"$work/ten.csv"
refused ':1: 10 columns without names' "$work/ten.csv"
printf '1 2 3\n4 5\n' >"$work/short.xyz"
refused ':2: 2 columns, but 3 in the first row' "$work/short.xyz"
refused 'perhaps it is in mm' "$work/tube.xyz" --set scan.unit=m --set scan.radius_mm=4
refused 'perhaps it is in mm' "$work/tube.xyz" --set scan.unit=um --set scan.length_mm=120
head -c 4000 "$work/tube.bin" >"$work/cut.ply"
refused 'points take' "$work/cut.ply"
head -c 2000 /dev/zero >"$work/zero.pcd"
refused 'it is no point cloud' "$work/zero.pcd"
awk 'BEGIN { srand(2); for (i = 0; i < 4000; i++) print 50 * rand(), 50 * rand(), 50 * rand() }' >"$work/fog.xyz"
refused 'no tube' "$work/fog.xyz"
awk 'BEGIN { srand(2); for (i = 0; i < 4000; i++) print 50 * rand(), 50 * rand(), 0.01 * rand() }' >"$work/flat.xyz"
refused 'tube' "$work/flat.xyz"

# headers that promise more than there is, or than memory holds
head='ply\nformat binary_little_endian 1.0\nelement vertex %s\nproperty float x\nproperty float y\nproperty float z\nend_header\n'
# shellcheck disable=SC2059
for count in 1000000000000000000 400000000; do
    printf "$head" $count >"$work/many.ply"
    refused 'at most 20000000 are read' "$work/many.ply"
done
# 5 GB that take no room on the disk: with the same header, with too many points, as text, as nothing
if truncate -s 5G "$work/many.ply" 2>/dev/null; then
    refused 'at most 20000000 are read' "$work/many.ply"
    # shellcheck disable=SC2059
    printf "$head" 1000000 >"$work/some.ply"
    truncate -s 5G "$work/some.ply"
    refused 'tube' "$work/some.ply"
    tube 200 '%.4f %.4f %.4f' >"$work/text.xyz"
    truncate -s 5G "$work/text.xyz"
    refused 'zero byte' "$work/text.xyz"
    truncate -s 5G "$work/empty.ply"
    refused 'it is no point cloud' "$work/empty.ply"
fi
finish
