#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The Debian packages in a bare Debian: they install, draw, and leave nothing when they are removed.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."

tools/make_packages.sh build/packages
inside=$(mktemp)
trap 'rm -f "$inside"' EXIT
cat >"$inside" <<'INSIDE'
find / -xdev -path /var -prune -o -path /work -prune -o -print | sort >/root/before
apt-get install "$GIVEN"/packages/{rakelight_,librakelight0_}*.deb >/root/log 2>&1 || { tail -n 30 /root/log; exit 1; }
rakelight --version
rakelight "$GIVEN/spot_slab5.glb" -o spot.png --resolution 200,200
printf 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n' >a.stl
rakelight a.stl -o stl.png --resolution 64,64  # by the helper
head -c 8 spot.png | grep -q PNG
head -c 8 stl.png | grep -q PNG
echo 'installed and drawn'
INSIDE
tests/packages/bare_debian.sh --give build/packages --give data/spot/spot_slab5.glb "$inside"
