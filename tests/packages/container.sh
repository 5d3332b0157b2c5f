#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The container file: its form, and in a bare Debian, which stands for the image, the steps of its last stage; then the program draws as the
# user that the file names. The stage before is ./dev setup and tools/package/make_packages.sh, which other tests run.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."

file=packages/container/Containerfile
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for broken in 's/^USER .*/USER root/' 's/--from=build/--from=other/' 's/^CMD .*/CMD [--help]/' 's/^COPY . /CPY . /' 's/^FROM debian:12-slim/FROM debian/'; do
    sed "$broken" "$file" >"$work/broken"
    if python3 tests/packages/container_steps.py "$work/broken" >/dev/null 2>&1; then echo "not found: $broken" >&2; exit 1; fi
done
python3 tests/packages/container_steps.py "$file" >"$work/steps"

compgen -G 'build/packages/*.deb' >/dev/null || { echo 'there are no packages: tools/package/make_packages.sh makes them' >&2; exit 1; }
cat >"$work/inside" <<'INSIDE'
cp -r "$GIVEN/packages" /packages
while read -r step; do bash -c "$step" >/root/log 2>&1 </dev/null || { echo "$step"; tail -n 30 /root/log; exit 1; }; done <"$GIVEN/steps"
cp "$GIVEN/spot_slab5.glb" /models
cd /models
runuser -u rakelight -- rakelight spot_slab5.glb -o spot.png --resolution 64,64
runuser -u rakelight -- rakelight spot_slab5.glb -o traced.png --resolution 64,64 --engine trace
[ "$(stat -c %U spot.png)" = rakelight ]
echo 'drawn as a user'
INSIDE
tests/packages/bare_debian.sh --give build/packages --give "$work/steps" --give data/spot/spot_slab5.glb "$work/inside"
