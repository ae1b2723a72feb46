#!/bin/sh
# The C libraries show the names of cmake/abi/*.txt and no others, a name that went away or was renamed breaks who uses it; what is
# listed is declared in their headers; sections and rods load neither MPI nor gmsh nor HDF5.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
build=$(dirname "$program")
ninja_dir=$(dirname "$build")

# names FILE: what a shared library shows, but for the sanitizers' own and the version's
names() {
    nm -D --defined-only "$1" | sed -n 's/.* [TDBRVW] \([a-z][a-z0-9_]*\).*/\1/p' | grep -v '^__' | sort
}

# declared HEADER...: the functions that stand in headers
declared() {
    grep -hoE '^(STIFFAXIS_API )?[a-z][a-z0-9_ ]* \*?[a-z0-9_]+\(' "$@" | grep -vE '^(static|typedef)' |
        sed -E 's/.*[ *]([a-z0-9_]+)\($/\1/' | sort
}

for library in stiffaxis stiffaxis_rod; do
    file=$build/lib$library.so
    grep -v '^#' "$source/cmake/abi/$library.txt" | sort >"$work/listed"
    names "$file" >"$work/shown"
    diff "$work/listed" "$work/shown" >"$work/difference" ||
        fail "lib$library.so shows other names than cmake/abi/$library.txt lists: $(grep '^[<>]' "$work/difference" | tr '\n' ' ')"
    [ -s "$work/shown" ] || fail "lib$library.so shows nothing"
    readelf -d "$file" | grep -q "SONAME.*\[lib$library\.so\.[0-9][0-9]*\]" || fail "lib$library.so has no numbered SONAME"
    version=$(printf '%s' "$library" | tr a-z A-Z)
    nm -D --defined-only "$file" | grep -q "@@*${version}_[0-9]" || fail "lib$library.so: names without a version"
    if [ "$library" = stiffaxis ]; then
        declared "$source/api/stiffaxis.h" >"$work/declared"
    else
        find "$ninja_dir/include" -name '*.h' | xargs cat >"$work/headers.h"
        declared "$work/headers.h" >"$work/declared"
    fi
    diff "$work/listed" "$work/declared" >"$work/difference" ||
        fail "the headers of lib$library.so declare other names than it lists: $(grep '^[<>]' "$work/difference" | tr '\n' ' ')"
done

# the check itself works: a name less, and one more
sed 1,2d "$work/shown" | diff -q "$work/listed" - >/dev/null && fail 'a name that went away is not seen'

for heavy in mpi gmsh hdf5 petsc cairo; do
    if ldd "$build/libstiffaxis.so" | grep -q "lib$heavy"; then fail "libstiffaxis.so needs $heavy"; fi
done
finish
