#!/bin/sh
# Every C file is as clang-format would lay it out.
set -eu
cd "${STIFFAXIS_SOURCE:-$(dirname "$0")/..}"
files=$(find app base bench fem io meshes reports rodsolver section tests -name '*.[ch]' | sort)
# shellcheck disable=SC2086
clang-format --dry-run --Werror $files
echo "format: $(echo "$files" | wc -l) files"
