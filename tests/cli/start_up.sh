#!/bin/sh
# What a command does not need it does not load: sections, rods and prisms in 3D start neither MPI nor gmsh nor HDF5.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
cases=$source/cases

# loads COMMAND...: the names of the heavy libraries that the process loads
loads() {
    LD_DEBUG=files "$@" 2>&1 >/dev/null | grep -oE 'calling init: .*/lib(mpi|petsc|gmsh|hdf5)[^ ]*' |
        sed -E 's/.*\/lib(mpi|petsc|gmsh|hdf5).*/\1/' | sort -u | tr '\n' ' '
}

for command in 'section constant_nc' 'rod constant_nc' 'section helical_nc' 'rod helical_nc' 'check fig4' 'fem fig4' 'fem constant_nc'; do
    set -- $command
    found=$(loads "$program" "$1" "$cases/$2.yaml")
    [ -z "$found" ] || fail "$command loads $found"
done

# the check itself works: these do load them
case $(loads "$program" fem "$cases/fig4.yaml" --set fem.method=direct --set fem.order=2) in
*mpi*petsc*) ;;
*) fail 'fem loads no PETSc: this script looks for the wrong thing' ;;
esac
finish
