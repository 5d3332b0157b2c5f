#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The commands of README.md, word for word, in a clone in a bare Debian: the installation, ./dev demo, and the four commands with a model of
# the repository as parts.glb. This compiles the program, which takes long; RAKELIGHT_CCACHE=FOLDER lends it a compiler cache (and installs
# ccache). RAKELIGHT_CONFIGURE=1 goes no further than the configuration of each preset after its lists of packages.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
git clone -q --no-hardlinks . "$work/rakelight"
# block HEADING: the code of the first fenced block below a heading.
block() { awk -v heading="## $1" '$0 == heading {on = 1} on && /^```/ {if (code++) exit; next} on && code' README.md; }
block Install >"$work/install"
block 'Four commands' >"$work/four"
[ "$(wc -l <"$work/install")" -ge 1 ] && [ "$(wc -l <"$work/four")" = 4 ]
grep -q -F './dev demo' README.md

cat >"$work/inside" <<'INSIDE'
cp -a "$GIVEN/rakelight" .
cd rakelight
size() { dpkg-query -W -f '${Installed-Size}\n' | awk '{size += $1} END {printf "%d packages, %d MiB\n", NR, size / 1024}'; }
run() { echo "\$ $1"; bash -c "$1" >/root/log 2>&1 </dev/null || { tail -n 40 /root/log; exit 1; }; }
is_png() { [ "$(head -c 4 "$1" | tail -c 3)" = PNG ]; }
if [ -e /root/.ccache ]; then
    run 'apt-get update && apt-get install ccache'
    export CCACHE_DIR=/root/.ccache CCACHE_BASEDIR=$(dirname "$PWD") CCACHE_NOHASHDIR=1
fi
size
if [ "${1:-}" = configure ]; then
    # The list of a preset suffices: its configuration ends well.
    for preset in package deb release; do
        case $preset in package) lists='program viewer' ;; deb) lists='program viewer python' ;; *) lists='program viewer gl tests' ;; esac
        run "./dev setup $lists"
        size
        run "cmake --preset $preset"
    done
    exit 0
fi
while read -r line; do run "$line"; done <"$GIVEN/install"
size
for unwanted in libgtest-dev qemu-user ffmpeg xvfb imagemagick; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' $unwanted 2>/dev/null)" != installed ] || { echo "the installation brought $unwanted"; exit 1; }
done
run './dev demo'
is_png build/demo/spot-head.png && is_png build/demo/head.png
cp build/demo/*.png "$OUT"
mkdir ../place
cd ../place
cp ../rakelight/data/spot/spot_slab5.glb parts.glb
while read -r line; do run "$line"; done <"$GIVEN/four"
is_png parts.png
cp parts.png "$OUT"
rakelight inspect seamless.glb --check --max-seam 0.1 >/dev/null
rakelight-view --help >/dev/null
echo 'installed, and all commands ran'
INSIDE
lent=()
[ -z "${RAKELIGHT_CCACHE:-}" ] || lent=(--ccache "$RAKELIGHT_CCACHE")
tests/packages/bare_debian.sh --give "$work/rakelight" --give "$work/install" --give "$work/four" "${lent[@]}" --out build/readme-tried "$work/inside" ${RAKELIGHT_CONFIGURE:+configure}
