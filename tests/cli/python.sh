#!/bin/sh
# The Python module: sections and rods to the last bit of --json, what a solve costs, errors, threads, memory, installed by pip.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
export STIFFAXIS_LIBRARY="$(dirname "$program")/libstiffaxis.so" PYTHONPATH="$source/python" PYTHONDONTWRITEBYTECODE=1

[ -f "$STIFFAXIS_LIBRARY" ] || {
    echo 'python: left out, libstiffaxis was not built'
    exit 0
}
if nm -D "$STIFFAXIS_LIBRARY" | grep -q '__asan_\|__ubsan_\|__gcov_'; then
    echo 'python: left out, the library is built with a sanitizer or for coverage (test_api watches its memory)'
    exit 0
fi

python_with numpy /usr/bin/python3 python3
# without numpy the module says what is missing
bare=$(command -v "${python:-python3}") || exit 0
mkdir -p "$work/no/numpy"
echo 'raise ImportError("none")' >"$work/no/numpy/__init__.py"
expect 1 env PYTHONPATH="$work/no:$PYTHONPATH" "$bare" -c 'import stiffaxis'
err 'stiffaxis needs numpy'
err 'apt-get install python3-numpy'
if [ -z "$python" ]; then
    echo 'python: left out, no python3 has numpy'
    finish
fi
# ... and without the library
expect 1 env STIFFAXIS_LIBRARY=/nowhere/libstiffaxis.so "$python" -c 'import stiffaxis'
err '/nowhere/libstiffaxis.so cannot be used'
# ... and with one of another version, or of a time when there were other functions
{
    echo 'const char *stiffaxis_version(void) { return "9.8.7"; }'
    grep '^stiffaxis' "$source/cmake/abi/stiffaxis.txt" | grep -v version | sed 's/.*/int &(void) { return 0; }/'
} >"$work/other.c"
cc -shared -fPIC "$work/other.c" -o "$work/libother.so" && sed -e /stiffaxis_solve/d -e s/9.8.7/0.1.0/ "$work/other.c" | cc -shared -fPIC -x c - -o "$work/libold.so"
expect 1 env STIFFAXIS_LIBRARY="$work/libother.so" "$python" -c 'import stiffaxis'
err 'libother.so is version 9.8.7, this module 0.1.0'
expect 1 env STIFFAXIS_LIBRARY="$work/libold.so" "$python" -c 'import stiffaxis'
err 'undefined symbol: stiffaxis_solve'

# same CASE [--set SETTING]...: Python's numbers and the program's
same() {
    "$program" section "$@" --json --quiet >"$work/section.json" || fail "section $*"
    "$program" rod "$@" --json --quiet >"$work/rod.json" || fail "rod $*"
    "$python" "$source/tests/python/same_as_program.py" "$work/section.json" "$work/rod.json" "$@" || fail "not the same: $*"
}
same "$source/cases/constant_nc.yaml"
same "$source/cases/constant_nc.yaml" --set section.model=classical --set rod.derivatives=true
same "$source/cases/helical_nc.yaml" --set section.model=classical
same "$source/cases/constant_nc.yaml" --set 'section.wrenches=[{name: push, force_N: [0.1, 0, -1]}]' --set 'section.points_mm=[[1, 2]]'
same "$source/cases/loaded_nc.yaml" --set section.model=classical --set rod.derivatives=true
same "$source/cases/pulled_tube.yaml"

"$python" "$source/tests/python/declared.py" "$source" || fail 'declared.py'
"$python" "$source/tests/python/errors.py" "$source/cases/constant_nc.yaml" || fail 'errors.py'
(cd "$work" && "$python" "$source/tests/python/arrays.py" "$source/cases/constant_nc.yaml") || fail 'arrays.py'
mkdir "$work/locales"
localedef -i de_DE -f UTF-8 "$work/locales/de_DE.UTF-8" 2>/dev/null # where the package `locales` is there
LOCPATH=$work/locales "$python" "$source/tests/python/sharing.py" "$source/cases/constant_nc.yaml" || fail 'sharing.py'

# --- what a solve costs, against the same solves from C
headers=$(dirname "$(dirname "$program")")/include_api
cc -std=c11 -D_POSIX_C_SOURCE=200809L -O2 -Wall -Wextra -Werror -I "$headers" "$source/tests/python/solve_time.c" "$STIFFAXIS_LIBRARY" \
    -Wl,-rpath,"$(dirname "$STIFFAXIS_LIBRARY")" -o "$work/solve_time" || fail 'solve_time.c does not build'
time=$("$work/solve_time" "$source/cases/constant_nc.yaml") || fail "solve_time: $time"
"$python" "$source/tests/python/overhead.py" "$source/cases/constant_nc.yaml" "$time" || fail 'a solve through Python costs too much'

# sections by shapes and rods load nothing heavy
loaded=$(LD_DEBUG=files "$python" -c "import stiffaxis; stiffaxis.Case('$source/cases/constant_nc.yaml').rod().solve([0.1, 0])" 2>&1 |
    grep -oE 'calling init: .*/lib(mpi|petsc|gmsh|hdf5|cairo)[^ ]*' || true)
[ -z "$loaded" ] || fail "loads $loaded"
# ... and what needs gmsh finds it beside the library
"$python" -c "
import stiffaxis
print(stiffaxis.Case('$source/cases/constant_nc.yaml', {'section.mesh.kind': 'free'}).section()[0].area_m2)" >"$work/out" ||
    fail 'a section that needs gmsh'

# --- installed: found from the module's place alone, and by pkg-config and CMake from C; moved together
build=$(dirname "$(dirname "$program")")
if [ -f "$build/share/stiffaxis.1" ]; then
    cmake --install "$build" --prefix "$work/prefix" >"$work/log" 2>&1 || fail "$(tail -3 "$work/log")"
    mv "$work/prefix" "$work/moved"
    env -u STIFFAXIS_LIBRARY PYTHONPATH="$work/moved/share/stiffaxis/python" "$python" -c "
import stiffaxis
assert stiffaxis.library_path().startswith('$work/moved/lib'), stiffaxis.library_path()
print(stiffaxis.Case('$source/cases/constant_nc.yaml', {'section.mesh.kind': 'free'}).section()[0].area_m2)" >"$work/out" ||
        fail 'the installed module'
    libraries=$(dirname "$(find "$work/moved/lib" -name libstiffaxis.so)")
    export PKG_CONFIG_PATH="$libraries/pkgconfig"
    # shellcheck disable=SC2046
    cc -std=c11 -D_POSIX_C_SOURCE=200809L "$source/tests/python/solve_time.c" $(pkg-config --cflags --libs stiffaxis) -o "$work/by_pkgconfig" &&
        LD_LIBRARY_PATH="$libraries" "$work/by_pkgconfig" "$source/cases/constant_nc.yaml" >"$work/out" || fail 'a program by pkg-config'
    mkdir "$work/user"
    cat >"$work/user/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.16)
project(user C)
find_package(stiffaxis REQUIRED)
add_executable(by_cmake ${SOLVE_TIME})
target_compile_definitions(by_cmake PRIVATE _POSIX_C_SOURCE=200809L)
target_link_libraries(by_cmake PRIVATE stiffaxis::stiffaxis)
END
    { cmake -S "$work/user" -B "$work/user/build" -DSOLVE_TIME="$source/tests/python/solve_time.c" -DCMAKE_PREFIX_PATH="$work/moved" &&
        cmake --build "$work/user/build" && "$work/user/build/by_cmake" "$source/cases/constant_nc.yaml"; } >"$work/log" 2>&1 ||
        fail "a program by CMake: $(tail -3 "$work/log")"
fi

# --- the tour, and installed by pip where that works without a network
(cd "$work" && "$python" "$source/examples/python_tour.py" "$source/cases/constant_nc.yaml") >"$work/out" 2>&1 || fail "the tour: $(tail -3 "$work/out")"
out 'stiffness centre'
if "$python" -m pip --version >/dev/null 2>&1 && "$python" -c 'import setuptools, sys; sys.exit(int(setuptools.__version__.split(".")[0]) < 61)' 2>/dev/null; then
    cp -r "$source/python" "$work/source"
    "$python" -m pip install --quiet --no-index --no-deps --no-build-isolation --target "$work/site" "$work/source" >"$work/log" 2>&1 ||
        fail "pip: $(tail -3 "$work/log")"
    (cd "$work" && PYTHONPATH="$work/site" "$python" -c 'import stiffaxis, sys; assert "/site/" in stiffaxis.__file__') || fail 'not installed by pip'
else
    echo 'python: pip or setuptools are not there, nothing was installed'
fi
finish
