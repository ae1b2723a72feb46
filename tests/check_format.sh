#!/bin/sh
# Every C file is as clang-format would lay it out.
set -eu
cd "${STIFFAXIS_SOURCE:-$(dirname "$0")/..}"
files=$(find app base bench fem io measure meshes reach reports rodsolver section tests -name '*.[ch]' | sort)
# many files per process: starting it costs more than looking at one
if found=$(printf '%s\n' "$files" | xargs -n 100 clang-format --dry-run --Werror 2>&1); then
    echo "format: $(echo "$files" | wc -l) files as they should be"
else
    printf '%s\n' "$found" | sed -n 's/^\([^: ]*\.[ch]\):.*/\1 is not formatted: .\/run format/p' | sort -u
    exit 1
fi
