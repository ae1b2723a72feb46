#!/bin/sh
# The README's commands as somebody with an empty Debian 12 has them: a minimal root is made, the committed tree is put into it,
# and `./run demo`, `./run check` or what is asked for runs inside, as root and with an empty environment. Needs root and mmdebstrap.
# usage: newcomer.sh [--root DIR] [COMMAND...]      (DIR: kept afterwards, used again when it is there; default: demo)
set -eu
source=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
root=
if [ "${1:-}" = --root ]; then
    root=$2
    shift 2
fi
[ $# -gt 0 ] || set -- demo

say() {
    printf 'newcomer: %s\n' "$*" >&2
}

[ "$(id -u)" = 0 ] || { say 'needs root, to make a root file system'; exit 5; }
command -v mmdebstrap >/dev/null 2>&1 || { say 'mmdebstrap is missing: apt-get install mmdebstrap'; exit 5; }

if [ -z "$root" ]; then
    root=$(mktemp -d "${TMPDIR:-/var/tmp}/stiffaxis-newcomer-XXXXXX")
    trap 'rm -rf --one-file-system "$root"' EXIT
    rmdir "$root"
fi

now() {
    date +%s
}

# a small Debian 12: essential packages and apt
make_root() {
    start=$(now)
    mmdebstrap --quiet --mode=root --variant=minbase bookworm "$root"
    say "an empty Debian 12 with $(chroot "$root" dpkg-query -f '.\n' -W | wc -l) packages: $(($(now) - start)) s"
}
[ -d "$root" ] || make_root
cp /etc/resolv.conf "$root/etc/resolv.conf"

mkdir -p "$root/root/stiffaxis"
git -C "$source" archive HEAD | tar -x -C "$root/root/stiffaxis"

# its own mounts and processes, which end with it
inside() {
    unshare --mount --pid --fork --mount-proc="$root/proc" sh -c '
        root=$1
        shift
        mount --rbind /dev "$root/dev"
        exec chroot "$root" env -i HOME=/root TERM=dumb PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "$@"
    ' sh "$root" "$@"
}

for command in "$@"; do
    start=$(now)
    code=0
    inside sh -c "cd /root/stiffaxis && ./run $command" || code=$?
    say "./run $command: exit code $code after $(($(now) - start)) s"
    [ "$code" = 0 ] || exit "$code"
done
