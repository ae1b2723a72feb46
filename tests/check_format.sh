#!/bin/sh
# Every C file is as clang-format would lay it out.
set -eu
cd "${STIFFAXIS_SOURCE:-$(dirname "$0")/..}"
files=$(find app base bench fem io measure meshes reports rodsolver section tests -name '*.[ch]' | sort)
bad=0
for file in $files; do
    if ! clang-format --dry-run --Werror "$file" >/dev/null 2>&1; then
        echo "$file is not formatted: ./run format"
        bad=1
    fi
done
[ $bad = 0 ] && echo "format: $(echo "$files" | wc -l) files as they should be"
exit $bad
