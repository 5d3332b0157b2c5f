#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs a script in a Debian 12 that has nothing but its base system, to see what an installation of ours needs and leaves.
#
#   bare_debian.sh [--give PATH]... [--out FOLDER] [--ccache FOLDER] SCRIPT [ARGUMENT...]
#
# SCRIPT runs as root in a changed root (no container), by `bash -euo pipefail`, in an empty folder; it finds copies of the files and
# folders given in $GIVEN, and what it leaves in $OUT is in FOLDER afterwards. apt works in it, from the mirrors of this machine, without
# recommended packages. The compiler cache of --ccache is that of the inside too, with its settings. Its exit code is that of this script. Where root or debootstrap is missing, one line says so and the code is 77.
#
# The base system is made once, for a week, and kept in build/bare-debian, packages from the mirror too: a second run starts within
# seconds. Runs may overlap.
set -euo pipefail
shopt -s nullglob

suite=bookworm
cache=$(dirname "$(readlink -f "$0")")/../../build/bare-debian
base=$cache/$suite.tar
given=()
out=
ccache=

skip() { echo "skipped: $*"; exit 77; }

while [ $# -gt 0 ]; do
    case "$1" in
    --give) given+=("$(readlink -f "$2")"); shift 2 ;;
    --out) mkdir -p "$2"; out=$(readlink -f "$2"); shift 2 ;;
    --ccache) ccache=$(readlink -f "$2"); shift 2 ;;
    -*) echo "bare_debian.sh: unknown option: $1" >&2; exit 2 ;;
    *) break ;;
    esac
done
[ $# -gt 0 ] || { sed -n '3,14s/^# \?//p' "$0" >&2; exit 2; }
script=$(readlink -f "$1")
shift

[ "$(id -u)" = 0 ] || skip "a bare Debian is a changed root, which only root can make"
command -v debootstrap >/dev/null || skip "debootstrap is not installed (Debian: debootstrap)"
[ "$(dpkg --print-architecture)" = amd64 ] || skip "the packages are for amd64"

# Lines for sources.list: where this machine has Debian's packages from, else Debian's own address.
sources() {
    local lines
    lines=$(apt-get indextargets --format "deb \$(REPO_URI) \$(RELEASE) main" 'Created-By: Packages' 'Component: main' 2>/dev/null |
        grep -E " $suite(-updates|-security)? main\$" | sort -u || true)
    echo "${lines:-deb http://deb.debian.org/debian $suite main}"
}

make_base() {
    local root mirror
    root=$(mktemp -d "$cache/base.XXXXXX")
    mirror=$(sources | sed -n "s/^deb \([^ ]*\) $suite main\$/\1/p")
    echo "making a bare Debian ($suite) from $mirror"
    debootstrap --variant=minbase "$suite" "$root" "$mirror" >"$cache/debootstrap.log" 2>&1 ||
        { tail -n 20 "$cache/debootstrap.log" >&2; rm -rf --one-file-system "$root"; return 1; }
    sources >"$root/etc/apt/sources.list"
    printf '%s\n' 'APT::Install-Recommends "false";' 'APT::Get::Assume-Yes "true";' 'quiet "1";' 'Dpkg::Use-Pty "false";' \
        'APT::Sandbox::User "root";' 'Binary::apt::APT::Keep-Downloaded-Packages "true";' >"$root/etc/apt/apt.conf.d/90bare"
    rm -f "$root/etc/apt/apt.conf.d/docker-clean" "$root"/var/cache/apt/archives/*.deb
    cp -L /etc/resolv.conf "$root/etc/resolv.conf"
    chroot "$root" apt-get update >>"$cache/debootstrap.log" 2>&1
    tar -C "$root" --one-file-system -cf "$base.part" .
    rm -rf --one-file-system "$root"
    mv "$base.part" "$base"
}

mkdir -p "$cache/packages"
cache=$(readlink -f "$cache")
base=$cache/$suite.tar
(
    flock 9
    if [ -z "$(find "$base" -mtime -7 2>/dev/null)" ]; then make_base; fi
) 9>"$cache/lock"

root=$(mktemp -d "$cache/run.XXXXXX")
trap 'rm -rf --one-file-system "$root"' EXIT
trap 'exit 130' INT TERM
tar -C "$root" -xf "$base"
chmod 755 "$root"  # its other users go in, too
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
mkdir "$root/given" "$root/out" "$root/work"
for path in "${given[@]}"; do cp -RL "$path" "$root/given/"; done
cp "$script" "$root/given.sh"
archives=$root/var/cache/apt/archives
packages=("$cache"/packages/*.deb)
[ ${#packages[@]} -eq 0 ] || cp -l "${packages[@]}" "$archives/"

# In a space of mounts of its own, where that is allowed: what is mounted is gone with the last process of the script.
space=()
if unshare --mount --pid --fork true 2>/dev/null; then space=(unshare --mount --pid --fork --kill-child); fi
code=0
# shellcheck disable=SC2016  # for the inner shells
CCACHE=$ccache "${space[@]}" bash -c '
    if [ $$ = 1 ]; then
        mount -t proc proc "$0/proc"
        mount -t tmpfs tmpfs "$0/dev/shm"
        mount -t devpts devpts "$0/dev/pts"
        if [ -n "$CCACHE" ]; then mkdir -p "$0/root/.ccache" && mount --bind "$CCACHE" "$0/root/.ccache"; fi
    fi
    exec chroot "$0" "$@"' "$root" \
    /usr/bin/env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 TERM=dumb \
    DEBIAN_FRONTEND=noninteractive GIVEN=/given OUT=/out \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
    bash -c 'cd /work && exec bash -euo pipefail /given.sh "$@"' bash "$@" </dev/null || code=$?

for package in "$archives"/*.deb; do
    [ -e "$cache/packages/${package##*/}" ] || ln "$package" "$cache/packages/" 2>/dev/null || true
done
[ -z "$out" ] || cp -R "$root/out/." "$out/"
exit "$code"
