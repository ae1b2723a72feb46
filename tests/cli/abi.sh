#!/bin/sh
# The C libraries show the names of cmake/abi/*.txt and no others, a name that went away or was renamed breaks who uses it; what is
# listed is declared in their headers; structs lie as cmake/abi/*_layout.txt has them; sections and rods load neither MPI nor gmsh
# nor HDF5.
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

# layout INCLUDE MAIN HEADER...: how the structs of these headers lie in memory
layout() {
    folder=$1
    echo "#include <$2>" >"$work/layout.c"
    shift 2
    awk -f "$source/cmake/abi/layout.awk" "$@" >>"$work/layout.c"
    cc -std=c11 -I "$folder" "$work/layout.c" -o "$work/layout" && "$work/layout"
}

# held NAME INCLUDE MAIN HEADER...
held() {
    grep -v '^#' "$source/cmake/abi/$1_layout.txt" >"$work/listed_layout"
    library=$1
    shift
    layout "$@" >"$work/seen_layout" || fail "no layout of lib$library"
    diff "$work/listed_layout" "$work/seen_layout" >"$work/difference" ||
        fail "structs of lib$library lie differently: $(grep '^[<>]' "$work/difference" | tr -s ' \n' ' ')"
}
held stiffaxis "$ninja_dir/include_api" stiffaxis/stiffaxis.h "$source/api/stiffaxis.h"
parts=$(cd "$source" && sed -n '/^set(ROD_HEADERS/,/)/p' cmake/rod_library.cmake | grep -oE '[a-z]+/[a-z0-9_]+\.h')
# shellcheck disable=SC2086
held stiffaxis_rod "$ninja_dir/include" stiffaxis/rod.h $(printf "$source/%s\n" $parts)

# the check itself works: a member more at an end that had room, a longer one, another constant; a name less
mkdir -p "$work/other/stiffaxis"
for change in 's/int isotropic;/int isotropic, more;/' 's/double shear_centre.2./double shear_centre[3]/' 's/STIFFAXIS_BUG = 6/STIFFAXIS_BUG = 7/'; do
    sed "$change" "$source/api/stiffaxis.h" >"$work/other/stiffaxis/stiffaxis.h"
    layout "$work/other" stiffaxis/stiffaxis.h "$work/other/stiffaxis/stiffaxis.h" >"$work/seen_layout" || fail "$change"
    grep -v '^#' "$source/cmake/abi/stiffaxis_layout.txt" | diff -q - "$work/seen_layout" >/dev/null && fail "not seen: $change"
done
sed 1,2d "$work/shown" | diff -q "$work/listed" - >/dev/null && fail 'a name that went away is not seen'

# C++ and strict C may include it
for language in c++ c; do
    command -v c++ >/dev/null || continue
    echo '#include <stiffaxis/stiffaxis.h>' | c++ -x "$language" -Wall -Wextra -Wpedantic -Werror -fsyntax-only -I "$ninja_dir/include_api" - ||
        fail "$language cannot include stiffaxis.h"
done

for heavy in mpi gmsh hdf5 petsc cairo; do
    if ldd "$build/libstiffaxis.so" | grep -q "lib$heavy"; then fail "libstiffaxis.so needs $heavy"; fi
done
finish
