#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The same sources give the same bytes from two folders, without the compiler cache: the attribute library is built twice, and the Debian
# packages are put together twice of one build. With RAKELIGHT_WHOLE=1 everything is built twice, which takes an hour on two cores.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."

export SOURCE_DATE_EPOCH
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
folders=("$place/a" "$place/another place with a longer name")
zones=(UTC Asia/Kolkata)

# build FOLDER ZONE
build() {
    mkdir -p "$1"
    git ls-files -z | xargs -0 cp --parents -t "$1"
    if [ "${RAKELIGHT_WHOLE:-}" != 1 ]; then
        cmake --preset deb -S "$1" -B "$1/build/deb" >/dev/null
        cmake --build "$1/build/deb" -j "$(nproc)" --target rakelight_attributes_shared rakelight_attributes_static
        mkdir -p "$1/build/packages"
        cp "$1"/build/deb/lib/librakelight-attributes.{a,so.*.*} "$1/build/packages/"
    else
        (cd "$1" && umask 027 && TZ=$2 tools/package/make_packages.sh)
    fi
}

for i in 0 1; do
    CCACHE_DISABLE=1 build "${folders[i]}" "${zones[i]}" >"$place/log" 2>&1 || { tail -n 30 "$place/log"; exit 1; }
done
if [ "${RAKELIGHT_WHOLE:-}" != 1 ]; then
    for i in 0 1; do
        TZ=${zones[i]} tools/package/make_packages.sh "$place/packages$i" >"$place/log" 2>&1 || { tail -n 30 "$place/log"; exit 1; }
        mv "$place/packages$i"/* "${folders[i]}/build/packages/"
    done
fi
different=0
for file in "${folders[0]}"/build/packages/*; do
    cmp "$file" "${folders[1]}/build/packages/${file##*/}" || different=1
    sha256sum "$file" | sed "s|$place/a/build/packages/||"
done
exit "$different"
