#!/bin/sh
# The README's commands as somebody with an empty Debian 12 has them: the committed tree is put into a minimal root, and
# `./run demo`, `./run check` or what is asked for runs inside. Needs root and mmdebstrap.
# usage: newcomer.sh [--root DIR] [COMMAND...]      (DIR: kept afterwards, used again when it is there; default: demo)
set -eu
source=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
root=
if [ "${1:-}" = --root ]; then
    root=$2
    shift 2
fi
[ $# -gt 0 ] || set -- demo
. "$source/tests/newcomer/root"
make_root

mkdir -p "$root/root/stiffaxis"
git -C "$source" archive HEAD | tar -x -C "$root/root/stiffaxis"
for command in "$@"; do
    start=$(now)
    code=0
    inside sh -c "cd /root/stiffaxis && ./run $command" || code=$?
    say "./run $command: exit code $code after $(($(now) - start)) s"
    [ "$code" = 0 ] || exit "$code"
done
