#!/bin/sh
# The packages' files agree with one another: versions, libraries, what the Dockerfile and the recipe name. Building them is
# tests/newcomer/debian.sh.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
cd "$source"

# --- one version
version=$(sed -n 's/^project(stiffaxis VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
same() {
    [ "$2" = "$version" ] || fail "$1 says version '$2', CMakeLists.txt says '$version'"
}
same 'the program' "$("$program" --version | sed 's/^stiffaxis //')"
same debian/changelog "$(sed -n '1s/^stiffaxis (\([^)]*\)).*/\1/p' debian/changelog)"
same CITATION.cff "$(sed -n 's/^version: *//p' CITATION.cff)"
same python/pyproject.toml "$(sed -n 's/^version = "\(.*\)"/\1/p' python/pyproject.toml)"
same python/stiffaxis/_library.py "$(sed -n 's/^VERSION = "\(.*\)"/\1/p' python/stiffaxis/_library.py)"
[ "$(cat debian/source/format)" = '3.0 (native)' ] || fail 'a native package has no revision'

# --- every library that ./run installs for the build is asked for by the package, and the other way round
listed=$(sed -e 's/#.*//' packages.txt | grep -E '^(lib|petsc|cmake|ninja|pkg-config|fonts)' | sort)
asked=$(sed -n '/^Build-Depends/,/^$/p' debian/control | sed -e 's/^Build-Depends: *//' -e 's/(.*)//' | tr -d ' ,' |
    grep -E '^(lib|petsc|cmake|ninja|pkg-config|fonts)' | sort)
[ "$listed" = "$asked" ] || {
    fail 'packages.txt and Build-Depends differ'
    printf '%s\n' "$listed" >"$work/listed"
    printf '%s\n' "$asked" | diff "$work/listed" -
}

# --- every binary package has its list of files; the libraries' names have the number of their ABI
major=${version%%.*}
for package in $(sed -n 's/^Package: *//p' debian/control); do
    [ -s "debian/$package.install" ] || fail "debian/$package.install is not there"
done
for package in libstiffaxis libstiffaxis-rod; do
    grep -q "^Package: $package$major\$" debian/control || fail "no package $package$major"
done
# ... and the names that these show, as cmake/abi lists them
for name in stiffaxis stiffaxis_rod; do
    grep '^[a-z]' "cmake/abi/$name.txt" | sort >"$work/listed"
    sed -n 's/^ \([a-z0-9_]*\)@.* [0-9.]*$/\1/p' "debian/lib$(echo $name | tr _ -)$major.symbols" | sort >"$work/symbols"
    diff "$work/listed" "$work/symbols" || fail "the symbols of lib$name are not those of cmake/abi/$name.txt"
done
for test in $(sed -n 's/^Tests: *//p' debian/tests/control); do
    [ -x "debian/tests/$test" ] && sh -n "debian/tests/$test" || fail "debian/tests/$test cannot be run"
done
for file in debian/*.install; do
    package=$(basename "$file" .install)
    grep -q "^Package: $package\$" debian/control || fail "$file is of no package"
done
[ -x debian/rules ] || fail 'debian/rules is not executable'
grep -q '^ENTRYPOINT \["stiffaxis"\]' Dockerfile && grep -q '^USER ' Dockerfile || fail 'the image does not start the program as a user of its own'
head -1 LICENSE | grep -q 'GNU GENERAL PUBLIC LICENSE' || fail 'LICENSE is another one'
grep -q 'GPL-2.0-or-later' CITATION.cff && grep -q '^License: GPL-2+' debian/copyright || fail 'the licence is told differently'
if command -v dpkg-parsechangelog >/dev/null; then
    dpkg-parsechangelog -l debian/changelog 2>"$work/err" | grep -q '^Distribution: bookworm' || fail 'debian/changelog'
    [ ! -s "$work/err" ] || fail "debian/changelog: $(cat "$work/err")"
fi
finish
