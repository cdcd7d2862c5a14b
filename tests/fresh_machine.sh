#!/usr/bin/env bash
# Proves that .ci/packages.txt is whole: makes a minimal Debian 12 in a temporary folder, clones
# this checkout into it and runs ./run and ./test there, as a new user would. Needs root and
# debootstrap; takes some 20 minutes on 2 cores and 3 GB of disk. Not part of continuous integration.
#   tests/fresh_machine.sh [MIRROR]      keep the machine with KEEP=1
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
mirror="${1:-http://deb.debian.org/debian}"
[ "$(id -u)" -eq 0 ] || { echo "fresh_machine.sh: must run as root" >&2; exit 1; }
command -v debootstrap >/dev/null || { echo "fresh_machine.sh: needs debootstrap" >&2; exit 1; }

machine="$(mktemp -d /tmp/seaway-fresh.XXXXXX)"
finish() {
  umount -l "$machine/proc" 2>/dev/null || true
  if [ "${KEEP:-0}" = 1 ]; then echo "kept: $machine"; else rm -rf "$machine"; fi
}
trap finish EXIT

debootstrap --variant=minbase bookworm "$machine" "$mirror" >"$machine.log" 2>&1 || {
  tail -n 20 "$machine.log" >&2
  exit 1
}
rm -f "$machine.log"
cp /etc/resolv.conf "$machine/etc/resolv.conf"
mount -t proc proc "$machine/proc"
git clone -q --no-hardlinks "$root" "$machine/seaway"
in_machine() { chroot "$machine" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 "$@"; }

echo "== ./run"
in_machine bash -c 'cd /seaway && ./run'
in_machine bash -c 'cd /seaway && ls -l out/canaveral && ls out/canaveral/frames | wc -l'
echo "== ./test"
in_machine bash -c 'cd /seaway && ./test'
echo "fresh_machine.sh: ./run and ./test passed on a minimal Debian 12"
