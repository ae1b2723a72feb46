#!/bin/sh
# What is installed is whole and may be moved: staged under DESTDIR, taken elsewhere, and used from there with an empty environment.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"
build=$(dirname "$(dirname "$program")")
[ -f "$build/share/stiffaxis.1" ] || {
    echo 'install: left out, only the program was built'
    exit 0
}
DESTDIR=$work/stage cmake --install "$build" --prefix /opt/somewhere >"$work/log" 2>&1 || fail "$(tail -3 "$work/log")"
[ -z "$(find "$work/stage" -mindepth 1 -maxdepth 1 ! -name opt)" ] || fail 'DESTDIR is not kept to'
mv "$work/stage/opt/somewhere" "$work/moved"
there=$work/moved
for file in bin/stiffaxis lib/stiffaxis/libstiffaxis_base.so lib/stiffaxis/stiffaxis_gmsh.so share/man/man1/stiffaxis.1 \
    share/man/man5/stiffaxis-case.5 share/bash-completion/completions/stiffaxis share/zsh/site-functions/_stiffaxis \
    share/fish/vendor_completions.d/stiffaxis.fish share/stiffaxis/stiffaxis.schema.json share/doc/stiffaxis/README.md \
    share/doc/stiffaxis/docs/keys.md share/doc/stiffaxis/docs/theory.md share/doc/stiffaxis/cases/fig4.yaml \
    share/doc/stiffaxis/LICENSE share/doc/stiffaxis/examples/control_loop.c; do
    [ -s "$there/$file" ] || fail "$file is not there"
done
[ -n "$(find "$there" -name stiffaxis-rod.pc)" ] || fail 'no pkg-config file'
# neither the prefix nor the place of the build stands in what is installed
for place in /opt/somewhere "$source" "$build"; do
    found=$(grep -rlF "$place" "$there" | head -3)
    # sanitizers and debuggers are told the places of the sources
    [ -z "$found" ] || [ "${STIFFAXIS_BUILD_TYPE:-}" = Debug ] || fail "$place is named by $found"
done

# alone NAME...: the installed program with nothing around it
alone() {
    env -i ${ASAN_OPTIONS:+ASAN_OPTIONS="$ASAN_OPTIONS"} TMPDIR="$work" "$there/bin/stiffaxis" "$@"
}
expect 0 alone doctor
out 'stiffaxis '
(cd "$work" && alone example constant_nc --out example && alone rod example/constant_nc.yaml --out rod) >"$work/log" 2>&1 ||
    fail "a rod from the installed program: $(tail -1 "$work/log")"
[ -s "$work/rod/result.hdf" ] && [ -s "$work/rod/report.html" ] || fail 'no result, or no page'
# the installed modules are the ones that are used
loaded=$(LD_DEBUG=files env -u LD_LIBRARY_PATH "$there/bin/stiffaxis" section "$source/cases/multilumen.yaml" 2>&1 >/dev/null |
    sed -n 's/.*calling init: \(.*stiffaxis[^ ]*\).*/\1/p' | grep -vF "$there" | grep -vF "$work" || true)
[ -z "$loaded" ] || fail "loads $loaded"

# every file is told about: nothing of ours outside of folders that are shared by design
stray=$(cd "$there" && find . -type f | grep -v stiffaxis || true)
[ -z "$stray" ] || fail "also installed: $stray"
if command -v man >/dev/null && command -v groff >/dev/null; then
    for page in man1/stiffaxis.1 man5/stiffaxis-case.5; do
        wrong=$(man --warnings -E UTF-8 -l "$there/share/man/$page" 2>&1 >/dev/null | head -3)
        [ -z "$wrong" ] || fail "$page: $wrong"
    done
fi
if command -v mandoc >/dev/null; then
    # no date: the same sources give the same page
    wrong=$(mandoc -Tlint "$there"/share/man/man*/* | grep -v 'missing date' | head -3)
    [ -z "$wrong" ] || fail "manual pages: $wrong"
fi
# every key of the schema stands in the page
for key in rod.frame fit.parameters; do
    last=${key##*.}
    grep -q "fB$last" "$there/share/man/man5/stiffaxis-case.5" || fail "the manual page knows no $key"
done
finish
