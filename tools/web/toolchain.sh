#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The toolchain of the web build: Debian 13's emscripten in a changed root, with the libraries that the web build links.
#
#   toolchain.sh COMMAND [ARGUMENT...]    runs a command in it, in the clone, which is /rakelight there
#
# It is made where it is missing, in some minutes and 3 GB, in RAKELIGHT_WEB_CACHE (~/.cache/rakelight/web), in a folder whose name
# is of the packages' versions and of how it is made; folders of other names are left alone. Headers and sources of libraries are
# those of Debian 12, which the native program has, so that the outputs are the same bytes. Needs root, debootstrap and a Debian
# mirror; without one of them it says so, with exit code 77. Where mounts are refused, the clone is copied in, and build/web out.
set -euo pipefail

# What is installed from Debian 13, and what is taken from Debian 12: headers alone, and sources that are compiled.
emscripten=3.1.69+dfsg-3
tools="emscripten=$emscripten cmake ninja-build pkgconf dpkg-dev ccache"
headers_13="libfast-float-dev nlohmann-json3-dev"
headers_12="libxsimd-dev libtomlplusplus-dev libstb-dev libfmt-dev libcli11-dev"
sources_12="zlib libspng libjpeg-turbo"

here=$(dirname "$(readlink -f "$0")")
clone=$(readlink -f "$here/../..")
cache=${RAKELIGHT_WEB_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/rakelight/web}
key=emscripten-$emscripten-$(cat "$0" "$here/libraries.sh" | sha256sum | cut -c1-12)
root=$cache/$key

skip() { echo "skipped: $*" >&2; exit 77; }

# Debian's mirror: that of this machine, if it has one.
mirror() {
    local uri
    uri=$(apt-get indextargets --format "\$(REPO_URI)" 'Created-By: Packages' 'Component: main' 'Codename: bookworm' 2>/dev/null | head -n 1 || true)
    echo "${uri:-http://deb.debian.org/debian}"
}

inside() {
    chroot "$1" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
        ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} "${@:2}"
}

make_toolchain() {
    local part debian
    debian=$(mirror)
    part=$(mktemp -d "$cache/part.XXXXXX")
    echo "making the toolchain of the web build from $debian in $root" >&2
    {
        debootstrap --variant=minbase trixie "$part" "$debian"
        printf '%s\n' 'APT::Install-Recommends "false";' 'APT::Get::Assume-Yes "true";' 'APT::Sandbox::User "root";' >"$part/etc/apt/apt.conf.d/90web"
        echo "deb $debian trixie main" >"$part/etc/apt/sources.list"
        printf '%s\n' "deb $debian bookworm main" "deb-src $debian bookworm main" >"$part/etc/apt/sources.list.d/bookworm.list"
        printf '%s\n' 'Package: *' 'Pin: release n=bookworm' 'Pin-Priority: 1' >"$part/etc/apt/preferences.d/bookworm"
        cp -L /etc/resolv.conf "$part/etc/resolv.conf"
        inside "$part" apt-get update
        # shellcheck disable=SC2086  # lists
        inside "$part" apt-get install $tools
        cp "$here/libraries.sh" "$part/libraries.sh"
        inside "$part" bash -euo pipefail /libraries.sh "$headers_13" "$headers_12" "$sources_12"
        inside "$part" apt-get clean
        mkdir "$part/rakelight"
    } >"$cache/toolchain.log" 2>&1 || { tail -n 20 "$cache/toolchain.log" >&2; rm -rf --one-file-system "$part"; return 1; }
    chmod 755 "$part"
    mv "$part" "$root"
}

[ $# -gt 0 ] || { sed -n '3,11s/^# \?//p' "$0" >&2; exit 2; }
[ "$(id -u)" = 0 ] || skip "the web build runs in a changed root, which only root can make"
command -v debootstrap >/dev/null || skip "debootstrap is not installed (Debian: debootstrap)"
mkdir -p "$cache"
(
    flock 9
    [ -d "$root" ] || make_toolchain
) 9>"$cache/lock"

environment=(PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 TERM=dumb
    RAKELIGHT_EMSCRIPTEN=/usr/share/emscripten PKG_CONFIG_LIBDIR=/usr/share/emscripten/cache/sysroot/lib/pkgconfig)
run=(chroot "$root" /usr/bin/env -i "${environment[@]}" bash -c 'cd /rakelight && exec "$@"' bash "$@")
if unshare --mount true 2>/dev/null; then
    mkdir -p "${CCACHE_DIR:=$HOME/.cache/ccache}" "$root/root/.cache/ccache"
    # shellcheck disable=SC2016  # for the inner shell
    exec unshare --mount bash -c 'mount --bind "$1" "$2/rakelight" && mount --bind "$3" "$2/root/.cache/ccache" && mount -t proc proc "$2/proc"; shift 3; exec "$@"' \
        bash "$clone" "$root" "$CCACHE_DIR" "${run[@]}"
fi
copy=$root/rakelight
(cd "$clone" && git ls-files -z --cached --others --exclude-standard | tar --null -T - --ignore-failed-read -cf -) | tar -C "$copy" -xf -
code=0
"${run[@]}" || code=$?
if [ -d "$copy/build/web" ]; then mkdir -p "$clone/build" && cp -R "$copy/build/web" "$clone/build/"; fi
exit "$code"
