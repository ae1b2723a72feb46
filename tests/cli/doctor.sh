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

# modules away, and one whose library is, as where packages were installed without what they recommend: named, with what brings
# the library, and the others still tried
mkdir "$work/bin"
ln "$bin"/stiffaxis "$bin"/*.so "$work/bin" 2>/dev/null || cp "$bin"/stiffaxis "$bin"/*.so "$work/bin"
rm "$work/bin/stiffaxis_nlopt.so" "$work/bin/stiffaxis_petsc.so" "$work/bin/stiffaxis_gmsh.so"
echo 'void missing(void); void need(void) { missing(); }' >"$work/need.c"
echo 'void missing(void) {}' | cc -shared -fPIC -x c - -o "$work/libgone.so.7" -Wl,-soname,libgone.so.7
cc -shared -fPIC "$work/need.c" "$work/libgone.so.7" -o "$work/bin/stiffaxis_gmsh.so" && rm "$work/libgone.so.7"
export LD_LIBRARY_PATH="$work/bin"
expect 5 "$work/bin/stiffaxis" doctor
grep -q '^design searches  *FAILS .*stiffaxis_nlopt.so .* install stiffaxis again' "$work/out" ||
    fail "a module that is away is not found: $(grep design "$work/out")"
out 'apt-get install libnlopt-dev'
out 'apt-get install petsc-dev'
grep -q '^free meshes.*libgone.so.7: .*directory$' "$work/out" || fail 'a library that is away is not told'
out 'apt-get install libgmsh-dev'
grep -q '^reach: tissue surfaces  *works' "$work/out" || fail 'the doctor stops at what fails'
err '3 of the parts that are needed do not work'
# other commands name the doctor, or do not mind
expect 5 "$work/bin/stiffaxis" section "$source/cases/constant_nc.yaml" --set section.mesh.kind=free
err 'libgone.so.7: cannot open shared object file: No such file or directory; stiffaxis doctor tells which package brings it'
expect 0 "$work/bin/stiffaxis" rod "$source/cases/constant_nc.yaml"

finish
