#!/bin/sh
# Tensile tests from a file to a modulus: the answer, the files, and every kind of bad input.
set -u
leaks=yes
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
data=$source/cases/tensile/soft_synthetic.csv

# the example is what its script makes, and says what it is
awk -f "$source/cases/tensile/make.awk" | cmp -s - "$data" || fail 'cases/tensile/soft_synthetic.csv is not what make.awk makes'
expect 0 "$program" material "$data" --set name=soft --set source=synthetic --out "$work/soft"
paper "$work/soft"
out 'SYNTHETIC data'
out 'soft: E = 0.6'
out 'of 5 curves'
for file in material.yaml material.csv material.json material.svg material.pdf material.png; do
    [ -s "$work/soft/$file" ] || fail "$file is missing"
done
grep -q SYNTHETIC "$work/soft/material.yaml" || fail 'the block does not say that the data is synthetic'
valid_json "$work/soft/material.json"
expect 2 "$program" material "$data" --out "$work/soft"
expect 0 "$program" material "$data" --json
valid_json "$work/out"
out '"schema": "stiffaxis/material/1"'
out '"synthetic": true'

# the block is ready for a case
expect 0 "$program" material "$data" --set name=soft --set nu=0.45 --out "$work/block" --quiet
{
    echo 'format: 1'
    cat "$work/block/material.yaml"
    echo 'section: {shapes: [{annulus: {outer_radius_mm: 4, inner_radius_mm: 3.2}, material: soft}]}'
    echo 'rod: {length_mm: 120}'
} >"$work/case.yaml"
expect 0 "$program" check "$work/case.yaml"

# made here: a line of 2 MPa with a little of a wave, in several spellings
rows() {
    awk -v x="$1" -v y="$2" -v mark="$3" 'BEGIN { for (i = 0; i <= 60; i++) { e = i / 1000
        printf "%.6g%s%.8g\n", e * x, mark, (2 * e + 0.0002 * sin(7 * i * i)) * y } }'
}
{ echo 'strain [%],stress [MPa]'; rows 100 1 ,; } >"$work/a.csv"
{ echo 'Extension;Force'; echo 'mm;N'; rows 50 8 ';'; } >"$work/b.csv"
{ echo '# gauge_length_mm: 50'; echo '# area_mm2: 8'; echo 'displacement_um force_mN'; rows 50000 8000 ' '; } >"$work/c.csv"
expect 0 "$program" material "$work/a.csv"
first=$(sed -n 1p "$work/out" | sed 's/^[^:]*//')
expect 0 "$program" material "$work/b.csv" --set gauge_length_mm=50 --set width_mm=4 --set thickness_mm=2
[ "$(sed -n 1p "$work/out" | sed 's/^[^:]*//')" = "$first" ] || fail 'force and extension give another modulus'
expect 0 "$program" material "$work/c.csv"
[ "$(sed -n 1p "$work/out" | sed 's/^[^:]*//')" = "$first" ] || fail 'a file that names its bar gives another modulus'
expect 0 "$program" material "$work/a.csv" "$work/c.csv" --json
valid_json "$work/out"
out '"curves": 2'
expect 2 "$program" material "$work/b.csv"
err 'needs the gauge length'
expect 2 "$program" material "$work/b.csv" --set gauge_length_mm=50
err 'needs the cross section'
expect 2 "$program" material "$work/a.csv" --set gauge_lenght_mm=50
err 'did you mean'
expect 2 "$program" material

# what was divided by, and whence; a file that says else; strains that nobody has
expect 0 "$program" material "$work/c.csv"
out 'gauge length 50 mm (line 1), cross section 8 mm^2 (line 2)'
out 'narrower: more readings'
expect 0 "$program" material "$work/c.csv" --set gauge_length_mm=25 --set diameter_mm=4 --json --out "$work/sizes"
err 'gauge length 25 mm of option --set is used, but its line 1 says 50 mm'
err 'cross section 12.57 mm^2 of option --set is used, but its line 2 says 8 mm^2'
valid_json "$work/out"
out '"gauge_length_m": 0.025'
out '"gauge_length_from": "option --set"'
grep -q 'gauge_length_mm,gauge_length_from,area_mm2,area_from' "$work/sizes/material.csv" || fail 'material.csv names no sizes'
grep -q ',25,option --set,12[.]56' "$work/sizes/material.csv" || fail 'material.csv has no sizes'
expect 0 "$program" material "$work/c.csv" --set gauge_length_mm=50
[ "$(grep -c warning "$work/err")" = 0 ] || fail 'a warning for the size that the file has too'
expect 0 "$program" material "$work/c.csv" --set gauge_length_mm=0.05
err 'is the gauge length of 0.05 mm (option --set) right?'
{ echo 'strain [%],stress [MPa]'; rows 1 1 ,; } >"$work/small.csv"
expect 0 "$program" material "$work/small.csv"
err "is the unit '%' of 'strain' right?"
expect 0 "$program" material "$work/a.csv"
[ "$(grep -c warning "$work/err")" = 0 ] || fail 'a warning for strains to 6 %'
expect 0 "$program" material "$work/a.csv" --out "$work/no_nu"
grep -q 'set nu=' "$work/no_nu/material.yaml" || fail 'the block does not say how to give nu'
expect 2 "$program" material "$work/a.csv" --set nu=0.5
err '0.4999'

# bad input: one clear line, nothing written
bad() {
    words=$1
    expect 3 "$program" material "$work/bad.csv" --out "$work/none"
    err "$words"
    one_line
    [ ! -e "$work/none" ] || fail "something was written for: $words"
}
: >"$work/bad.csv"
bad 'bad.csv: it is empty'
printf 'strain [%%],stress [MPa]\n0,0\n1,nan\n' >"$work/bad.csv"
bad "bad.csv:3: 'nan' is not a number"
printf 'strain [%%],stress [MPa]\n0,0\n1,inf\n' >"$work/bad.csv"
bad "bad.csv:3: 'inf' is not a number"
printf 'strain [%%],stress [MPa]\n1,2\n' >"$work/bad.csv"
bad '1 point of a first loading'
printf 'a,b,c,d,e,f,g,h,i,j\n1,2,3,4,5,6,7,8,9,10\n' >"$work/bad.csv"
bad 'bad.csv:1: no column of strain or extension among the 10'
printf 'strain,stress [MPa]\n0,0\n1,2\n' >"$work/bad.csv"
bad "column 'strain' has no unit"
printf 'strain [mm],stress [MPa]\n0,0\n1,2\n' >"$work/bad.csv"
bad "column 'strain' cannot be in 'mm'"
printf 'strain [%%],stress [N]\n0,0\n1,2\n' >"$work/bad.csv"
bad "column 'stress' cannot be in 'N'"
{ echo 'strain [%],stress [GPa]'; rows 0.00001 1000 ,; } >"$work/bad.csv"
bad 'are the units right?'
{ echo 'strain [%],stress [MPa]'; rows 100 -1 ,; } >"$work/bad.csv"
bad 'no straight stretch'
{ echo 'strain [%],stress [MPa]'; rows 0 1 ,; } >"$work/bad.csv"
bad 'the strain does not rise'
head -c 3000 "$program" >"$work/bad.csv"
bad 'it is no text'
truncate -s 5G "$work/bad.csv"
bad '5368709120 bytes; at most'
rm "$work/bad.csv"
bad 'No such file'
finish
