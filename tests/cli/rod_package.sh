#!/bin/sh
# The rod solver as a library: installed into an empty prefix, and a program built against it out of tree with
# pkg-config, with CMake and against the static library; nothing but the headers' own functions is visible.
set -eu
source=${STIFFAXIS_SOURCE:-$(cd "$(dirname "$0")/../.." && pwd)}
build=$(dirname "$(dirname "${STIFFAXIS:-$source/build/release/bin/stiffaxis}")")
work=$(mktemp -d "${TMPDIR:-/tmp}/stiffaxis-test-XXXXXX")
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix

fail() {
    printf 'rod_package: %s\n' "$*"
    exit 1
}

# a sanitized library asks its users for the sanitizer
if nm -D "$build/bin/libstiffaxis_rod.so" | grep -q '__asan_\|__ubsan_\|__gcov_'; then
    echo 'rod_package: left out, the library is built with a sanitizer or for coverage'
    exit 0
fi

cmake --install "$build" --prefix "$prefix" --component rod >"$work/install.log" 2>&1 || fail "$(cat "$work/install.log")"
library=$(find "$prefix" -name 'libstiffaxis_rod.so')
[ -n "$library" ] || fail 'no library was installed'
libraries=$(dirname "$library")
[ -z "$(cd "$prefix" && find . -type f | grep -v stiffaxis)" ] || fail 'other files were installed, too'

# --- what it is: versioned, of libm and libc alone, its own symbols hidden

readelf -d "$library" | grep -q 'SONAME.*\[libstiffaxis_rod\.so\.[0-9]*\]' || fail 'no versioned SONAME'
needed=$(readelf -d "$library" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' | grep -v '^lib[mc]\.so\|^libpthread\|^ld-linux' || true)
[ -z "$needed" ] || fail "it needs $needed"
if readelf -d "$library" | grep -q 'RPATH\|RUNPATH'; then fail 'it looks for libraries in a fixed place'; fi
visible=$(nm -D --defined-only "$library" | sed -n 's/.* T \([a-z0-9_]*\)@.*/\1/p')
for name in $visible; do
    cat "$prefix"/include/stiffaxis/*/*.h | grep -q "\<$name(" || fail "$name is visible, but in no header"
done
for name in rod_make rod_solve rod_derive rod_batch law_along_make status_message; do
    printf '%s\n' "$visible" | grep -q "^$name\$" || fail "$name is not visible"
done

# --- every header stands alone

for header in $(cd "$prefix/include" && find . -name '*.h' | sed 's|^\./||'); do
    printf '#include <%s>\nint main(void) { return 0; }\n' "$header" >"$work/alone.c"
    cc -std=c11 -Wall -Wextra -Wpedantic -Werror -I "$prefix/include" -fsyntax-only "$work/alone.c" || fail "$header does not stand alone"
done

# --- programs in C++ may use it, too

if command -v c++ >/dev/null 2>&1; then
    cat >"$work/plus.cpp" <<'END'
#include <cmath>
#include <stiffaxis/rod.h>
int main() {
    law_along law = {};
    const status st = law_along_make(std::fabs(-0.12), 1, 1, &law);
    law_along_free(&law);
    return st;
}
END
    c++ -I "$prefix/include" "$work/plus.cpp" -o "$work/plus" -L "$libraries" -lstiffaxis_rod || fail 'no C++ program can use it'
    LD_LIBRARY_PATH=$libraries "$work/plus" || fail 'the C++ program failed'
fi

# --- programs

# check_output PROGRAM: it runs with the installed library and says what it should
check_output() {
    LD_LIBRARY_PATH=$libraries "$1" >"$work/output" || fail "$1 failed"
    grep -q ' per second$' "$work/output" && grep -q 'once it is there$' "$work/output" || fail "$1 says: $(cat "$work/output")"
}

cp "$source/examples/control_loop.c" "$work"
export PKG_CONFIG_PATH="$libraries/pkgconfig"
# shellcheck disable=SC2046
cc -std=gnu11 -O2 "$work/control_loop.c" -o "$work/by_pkgconfig" $(pkg-config --cflags --libs stiffaxis-rod) -lm
check_output "$work/by_pkgconfig"

cc -std=gnu11 -O2 -I "$prefix/include" "$work/control_loop.c" "$libraries/libstiffaxis_rod.a" -o "$work/static" -lm -pthread
check_output "$work/static"
if readelf -d "$work/static" | grep -q libstiffaxis; then fail 'the static program needs the shared library'; fi

cat >"$work/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.16)
project(user C)
find_package(stiffaxis_rod REQUIRED)
add_executable(by_cmake control_loop.c)
target_link_libraries(by_cmake PRIVATE stiffaxis::rod m)
add_executable(by_cmake_static control_loop.c)
target_link_libraries(by_cmake_static PRIVATE stiffaxis::rod_static)
END
{ cmake -S "$work" -B "$work/build" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release && cmake --build "$work/build"; } \
    >"$work/cmake.log" 2>&1 || fail "$(cat "$work/cmake.log")"
check_output "$work/build/by_cmake"
check_output "$work/build/by_cmake_static"

# the package may be moved: nothing in it knows where it was
mv "$prefix" "$work/moved"
export PKG_CONFIG_PATH="$work/moved/${libraries#"$prefix"/}/pkgconfig"
libraries=$work/moved/${libraries#"$prefix"/}
# shellcheck disable=SC2046
cc -std=gnu11 -O2 "$work/control_loop.c" -o "$work/moved_program" $(pkg-config --cflags --libs stiffaxis-rod) -lm
check_output "$work/moved_program"
if grep -rqF "$prefix" "$work/moved"; then fail 'the installed files name the prefix'; fi
echo 'rod_package: installed, and used from outside by pkg-config, CMake and statically'
