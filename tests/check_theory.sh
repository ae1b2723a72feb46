#!/bin/sh
# Every equation that code and docs cite stands in docs/theory.md once; and four mistakes that must not pass.
set -u
cd "${STIFFAXIS_SOURCE:-$(dirname "$0")/..}" || exit 1
command -v python3 >/dev/null || {
    echo "check_theory: no python3 here"
    exit 0
}
python3 tests/docs/theory.py . || exit 1

small=$(mktemp -d)
trap 'rm -rf "$small"' EXIT
mkdir -p "$small/docs" "$small/base"
# mistake WORDS: the theory from stdin, a comment and a page that cite it
mistake() {
    cat >"$small/docs/theory.md"
    told=$(python3 tests/docs/theory.py "$small")
    case $told in
    *"$1"*) ;;
    *)
        echo "check_theory: '$1' is not told, but: $told"
        exit 1
        ;;
    esac
}
# shellcheck disable=SC2028
printf '// the law, docs/theory.md\n// (1.1) to (1.2a)\n' >"$small/base/a.c"
echo 'As in theory (1.1), (2.1) and section 2 of it; theory section 2.' >"$small/docs/page.md"
good() {
    printf '## 1. One\n\n(1.1) a.\n\n(1.2a) b, by (1.1).\n\n## 2. Two\n\n(2.1) c.\n'
}
good | mistake '3 equations, cited 6 times' || exit 1
good | sed 's/(1.2a)/(1.2b)/' | mistake 'base/a.c:1: the theory has no (1.2a)' || exit 1
good | sed 's/(2.1)/(1.1)/' | mistake '(1.1) stands there 2 times' || exit 1
good | sed 's/by (1.1)/by (1.3)/' | mistake 'docs/theory.md:5: the theory has no (1.3)' || exit 1
good | sed 's/## 2. Two//' | mistake 'docs/page.md:1: the theory has no section 2' || exit 1
