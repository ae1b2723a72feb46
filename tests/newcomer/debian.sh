#!/bin/sh
# The Debian packages: built here from the committed tree, looked at by lintian where it is there, and installed and used in an
# empty Debian 12. Needs root and mmdebstrap; for the build what debian/control names (apt-get build-dep ./).
# usage: debian.sh [--root DIR] [--out DIR]      (--out: where the packages are left)
set -eu
source=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
root=
out=
while [ $# -gt 0 ]; do
    case $1 in
    --root) root=$2 ;;
    --out) out=$2 ;;
    *) exit 2 ;;
    esac
    shift 2
done
. "$source/tests/newcomer/root"
make_root
build=$(mktemp -d "$root/var/tmp/stiffaxis-XXXXXX") # goes with the root

start=$(now)
mkdir "$build/stiffaxis"
git -C "$source" archive HEAD | tar -x -C "$build/stiffaxis"
(cd "$build/stiffaxis" && dpkg-buildpackage -us -uc -b) >"$build/log" 2>&1 || {
    tail -n 30 "$build/log" >&2
    say 'the packages were not built'
    exit 1
}
say "built in $(($(now) - start)) s: $(cd "$build" && echo *.deb)"
if command -v lintian >/dev/null 2>&1; then
    lintian --allow-root --fail-on error,warning "$build"/*.changes
    say 'lintian has nothing to say against them'
fi
if [ -n "$out" ]; then
    mkdir -p "$out"
    cp "$build"/*.deb "$out"
fi

rm -rf "$root/root/packages"
mkdir "$root/root/packages"
cp "$build"/*.deb "$root/root/packages"
rm -f "$root"/root/packages/*-dbgsym_*

# install WORDS...: apt-get's, inside
install() {
    start=$(now)
    inside sh -c "apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq $*" >"$root/root/install.log" 2>&1 || {
        tail -n 20 "$root/root/install.log" >&2
        say "not installed: $*"
        exit 1
    }
    say "installed $* in $(($(now) - start)) s"
}

# without what is recommended: sections and rods, from Python too, no MPI
install --no-install-recommends '/root/packages/stiffaxis_*.deb /root/packages/libstiffaxis0_*.deb /root/packages/python3-stiffaxis_*.deb'
inside sh -c 'cd /root && stiffaxis example constant_nc >case.yaml && stiffaxis section case.yaml && stiffaxis rod case.yaml' | head -n 3
cp -r "$source/debian/tests" "$root/root/"
inside /root/tests/module
if [ -n "$(find "$root/usr/lib" -name 'libmpi.so*')" ]; then
    say 'the least that is installed brings MPI'
    exit 1
fi
code=0
inside stiffaxis doctor >"$root/root/doctor.log" 2>&1 || code=$?
[ "$code" = 5 ] && grep -q 'apt-get install' "$root/root/doctor.log" || {
    say 'the doctor does not miss what is left out'
    exit 1
}

# apt asks for what is recommended only where the package is new
inside apt-get remove -y -qq stiffaxis >>"$root/root/install.log" 2>&1
install '/root/packages/*.deb'
# what autopkgtest runs, with what it would install
install --no-install-recommends "$(sed -n 's/^Depends: *//p' "$source/debian/tests/control" | tr ',\n' '  ')"
for name in $(sed -n 's/^Tests: *//p' "$source/debian/tests/control"); do
    start=$(now)
    inside "/root/tests/$name" || {
        say "debian/tests/$name failed"
        exit 1
    }
    say "debian/tests/$name passed in $(($(now) - start)) s"
done
inside sh -c 'dpkg -V stiffaxis libstiffaxis0 libstiffaxis-rod0 python3-stiffaxis'
