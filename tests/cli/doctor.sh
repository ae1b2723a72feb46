#!/bin/sh
# The doctor finds what is missing, says how to get it, and fails only for what is needed.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
bin=$(dirname "$program")

expect 0 "$program" doctor
out 'both without MPI'
for library in libyaml muParser CHOLMOD OpenBLAS gmsh PETSc MUMPS MPI HDF5 cairo libpng three.js GSL Embree NLopt; do
    grep -qE "works.*$library [^,]*[0-9]" "$work/out" || fail "tells no version of $library"
done
if grep -q 'not loaded' "$work/out"; then fail "$(grep 'not loaded' "$work/out")"; fi

# other programs: missing, and nothing is wrong
expect 0 env PATH=/nowhere "$program" doctor --json
valid_json "$work/out"
out 'getdp is not installed'
out '"get": "getdp"'
out '"get": "calculix-ccx"'

# one module away: named, with what brings its library, and the others still tried
mkdir "$work/bin"
ln "$bin"/stiffaxis "$bin"/*.so "$work/bin" 2>/dev/null || cp "$bin"/stiffaxis "$bin"/*.so "$work/bin"
rm "$work/bin/stiffaxis_nlopt.so" "$work/bin/stiffaxis_petsc.so"
expect 5 env LD_LIBRARY_PATH="$work/bin" "$work/bin/stiffaxis" doctor
grep -q '^design searches  *FAILS .*the nlopt module' "$work/out" || fail "a module that is away is not found: $(grep design "$work/out")"
out 'apt-get install libnlopt-dev'
out 'apt-get install petsc-dev'
grep -q '^reach: tissue surfaces  *works' "$work/out" || fail 'the doctor stops at what fails'
err '2 of the parts that are needed do not work'
expect 0 env LD_LIBRARY_PATH="$work/bin" "$work/bin/stiffaxis" rod "$source/cases/constant_nc.yaml"

finish
