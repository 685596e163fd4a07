#!/usr/bin/env bash
# Tries the README's two commands on a bare Debian: makes a chroot of SUITE by debootstrap, puts a clean copy of the last commit
# into it, and runs scripts/demo.sh and then scripts/test.sh there. Prints one line per step with its result and time.
#   scripts/portability.sh SUITE [--compiler gcc|clang] [--keep]     SUITE is bullseye, bookworm, trixie or sid
# --keep leaves the chroot. Needs root and debootstrap. CONTACT_SHAPELETS_CHROOTS names another folder for chroots, logs and
# downloaded packages than the one under ~/.cache.
set -euo pipefail

usage() {
  sed -n '/^#   scripts/s/^# *//p' "$0" >&2
  exit 2
}

compiler=gcc
keep=false
suite=
while [ $# -gt 0 ]; do
  case $1 in
    --compiler) compiler=${2:-}; shift 2 || usage ;;
    --keep) keep=true; shift ;;
    -*) usage ;;
    *) suite=$1; shift ;;
  esac
done
[ -n "$suite" ] || usage
case $compiler in gcc | clang) ;; *) usage ;; esac
if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null; then
  echo "$0 needs root and debootstrap (Debian: apt-get install debootstrap)" >&2
  exit 1
fi

package=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
chroots=${CONTACT_SHAPELETS_CHROOTS:-${XDG_CACHE_HOME:-$HOME/.cache}/contact_shapelets/chroots}
base=$chroots/$suite.tar
debs=$chroots/debs/$suite
logs=$chroots/logs/$suite-$compiler
mkdir -p "$debs/partial" "$logs"
root=$(mktemp -d "$chroots/$suite-$compiler.XXXXXX")
finish() {
  if "$keep"; then echo "The chroot is $root"; else rm -rf --one-file-system "$root"; fi
}
trap finish EXIT

# The mounts are seen by this command alone and end with it.
in_chroot() {
  unshare --mount --pid --fork --kill-child bash -c '
    set -e
    mount -t proc proc "$0/proc"
    mount --bind "$1" "$0/var/cache/apt/archives"
    shift
    exec chroot "$0" "$@"' "$root" "$debs" /usr/bin/env -i HOME=/root LANG=C.UTF-8 \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "${environment[@]}" "$@"
}

make_base() {
  [ -f "$base" ] && return
  debootstrap --variant=minbase "$suite" "$root" http://deb.debian.org/debian
  tar -C "$root" -cf "$base.new" .
  mv "$base.new" "$base"
  find "$root" -mindepth 1 -delete
}

unpack() {
  tar -C "$root" -xpf "$base"
  printf '127.0.0.1 localhost %s\n' "$(hostname)" >"$root/etc/hosts"
  # Nothing here has to outlive a power failure.
  echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/unsafe-io"
  mkdir "$root/root/contact_shapelets"
  git -C "$package" archive HEAD | tar -C "$root/root/contact_shapelets" -x
}

install_clang() {
  in_chroot apt-get update
  in_chroot apt-get install -y --no-install-recommends clang
}

# What the README's table says of the suite.
versions() {
  in_chroot dpkg-query --show --showformat='${Package} ${Version}\n' cmake "$compiler" catkin libeigen3-dev libmujoco-dev 2>/dev/null |
    paste -sd, | sed 's/,/, /g'
}

failed=0
step() {  # NAME COMMAND...
  local name=$1 begin=$SECONDS result=passed
  shift
  # In a process of its own, so that it stops at its first fault.
  "$@" >"$logs/$name.log" 2>&1 &
  wait $! || { result="failed (see $logs/$name.log)"; failed=1; }
  printf '%s %s %-10s %5d s  %s  %s\n' "$suite" "$compiler" "$name" $((SECONDS - begin)) "$result" \
    "$(grep -E '^[0-9]+ passed, [0-9]+ failed' "$logs/$name.log" | tail -n 1 || true)"
}

environment=()
# A function, which bash reads as a whole: the script may change while it runs.
main() {
  step debootstrap make_base
  step unpack unpack
  [ "$failed" -eq 0 ] || exit 1
  if [ "$compiler" = clang ]; then
    environment=(CC=clang CXX=clang++)
    step clang install_clang
  fi
  step demo.sh in_chroot /root/contact_shapelets/scripts/demo.sh
  step test.sh in_chroot /root/contact_shapelets/scripts/test.sh
  versions
  exit "$failed"
}
main
