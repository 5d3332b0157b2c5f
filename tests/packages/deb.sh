#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The Debian packages in a bare Debian: they install, draw, make thumbnails as file managers do, serve C++ programs and Python, and leave
# nothing when they are removed. Outside, lintian and the checkers of desktop files look at them.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."

compgen -G 'build/packages/*.deb' >/dev/null || { echo 'there are no packages: tools/package/make_packages.sh makes them' >&2; exit 1; }
if command -v lintian >/dev/null; then
    lintian --allow-root --display-info --fail-on error,warning,info build/packages/*.deb
else
    echo 'lintian is not installed: left out'
fi
if command -v desktop-file-validate >/dev/null; then desktop-file-validate packages/desktop/*.desktop; fi
if command -v appstreamcli >/dev/null; then appstreamcli validate --no-net packages/desktop/*.metainfo.xml; fi

inside=$(mktemp)
place=$(mktemp -d)
trap 'rm -rf "$inside" "$place"' EXIT
icon=packages/desktop/rakelight.svg
[ "$(stat -c %s $icon)" -lt 4096 ]
python3 -c 'import sys, xml.etree.ElementTree as tree; assert tree.parse(sys.argv[1]).getroot().get("viewBox") == "0 0 256 256"' $icon
if command -v rsvg-convert >/dev/null; then
    for size in 16 48 256; do rsvg-convert -w $size -h $size -o "$place/$size.png" $icon; done
    cmp "$place/48.png" packages/desktop/48x48/rakelight.png
else
    echo 'rsvg-convert is not installed: the icon is not drawn'
fi
if command -v update-mime-database >/dev/null; then
    mkdir -p "$place/mime/packages"
    cp packages/desktop/rakelight.xml "$place/mime/packages"
    XDG_DATA_DIRS=$place update-mime-database "$place/mime"
    for line in 50:model/x-geomview-off:*.off 40:model/x-ase:*.ase 50:model/x-ply:*.ply 80:application/x-rakelight-scene:*.scene.toml; do
        grep -q -x -F "$line" "$place/mime/globs2" || { echo "MIME types: $line is missing"; exit 1; }
    done
fi
dpkg-deb -x build/packages/rakelight_*.deb "$place/tree"
python3 blender/make_zip.py "$place/again.zip" >/dev/null
cmp "$place/again.zip" "$place/tree/usr/share/rakelight/rakelight_seams.zip"

cat >"$inside" <<'INSIDE'
quietly() { "$@" >/root/log 2>&1 || { tail -n 30 /root/log; exit 1; }; }
# All files but those that apt, dpkg and caches write.
files() { find / -xdev \( -path /var -o -path /work -o -path /given -o -path /out -o -path /root -o -path /proc -o -path /dev -o -path /sys -o -path /tmp \) -prune -o ! -type d -print | sort; }
is_png() { [ "$(head -c 4 "$1" | tail -c 3)" = PNG ]; }

files >/root/before
quietly apt-get install "$GIVEN"/packages/{rakelight_,librakelight0_}*.deb
rakelight --version
if [ "$(dpkg-query -W -f '${db:Status-Status}' libgl1-mesa-dri 2>/dev/null)" = installed ]; then echo "the program without its viewer needs drivers of OpenGL"; exit 1; fi
quietly apt-get install "$GIVEN"/packages/rakelight-view_*.deb

cp "$GIVEN/spot_slab5.glb" .
rakelight spot_slab5.glb -o spot.png --resolution 200,200
is_png spot.png
printf 'xof 0303txt 0032\nMesh a {\n3;\n0.0;0.0;0.0;,\n1.0;0.0;0.0;,\n0.0;1.0;0.0;;\n1;\n3;0,1,2;;\n}\n' >a.x
rakelight a.x -o x.png --resolution 64,64  # by the helper
is_png x.png
[ "$(rakelight-view --help | head -n 1)" ]
if rakelight-view spot_slab5.glb 2>/dev/null; then echo "the window opened without a display"; exit 1; fi

# The line of the entry, with %u, %o and %s as a file manager fills them in. Its words have no blanks.
cp spot_slab5.glb 'a spot.glb'
line=$(sed -n 's/^Exec=//p' /usr/share/thumbnailers/rakelight.thumbnailer)
command -v "$(sed -n 's/^TryExec=//p' /usr/share/thumbnailers/rakelight.thumbnailer)" >/dev/null
line=${line//%u/file://$PWD/a%20spot.glb}
line=${line//%o/$PWD/thumbnail}
read -ra words <<<"${line//%s/128}"
"${words[@]}"
is_png thumbnail
cp thumbnail spot.png "$OUT"

for file in /usr/share/man/man1/rakelight.1.gz /usr/share/man/man1/rakelight-view.1.gz /usr/share/applications/rakelight-view.desktop \
    /usr/share/mime/packages/rakelight.xml /usr/share/icons/hicolor/48x48/apps/rakelight.png \
    /usr/share/icons/hicolor/scalable/apps/rakelight.svg /usr/share/bash-completion/completions/rakelight; do
    [ -s "$file" ] || { echo "$file is missing"; exit 1; }
done

# Python: draws, and reads X by the helper of the package rakelight.
quietly apt-get install "$GIVEN"/packages/python3-rakelight_*.deb
module=/usr/lib/python3/dist-packages/rakelight
[ -s $module/__pycache__/__init__.cpython-311.pyc ]
python3 - "$(dpkg-query -W -f '${Version}' python3-rakelight)" <<'TEXT'
import importlib.metadata
import sys
import rakelight
assert importlib.metadata.version("rakelight") + "-1" == sys.argv[1]
rakelight.render_file("spot_slab5.glb", "python.png", resolution=(200, 200))
print("Python:", rakelight.load("a.x"))
TEXT
is_png python.png
cmp spot.png python.png

# Programs that use the attributes alone, and everything, by pkg-config.
quietly apt-get install "$GIVEN"/packages/{librakelight-dev,librakelight-attributes0}*.deb g++ pkg-config
# shellcheck disable=SC2046
g++ -std=c++20 "$GIVEN/attributes.cpp" -o attributes $(pkg-config --cflags --libs rakelight-attributes)
./attributes
# shellcheck disable=SC2046
g++ -std=c++20 "$GIVEN/minimal.cpp" -o minimal $(pkg-config --cflags --libs rakelight)
./minimal spot_slab5.glb minimal.png
is_png minimal.png
quietly apt-get install "$GIVEN"/packages/rakelight-doc_*.deb
[ -s /usr/share/doc/rakelight/python/examples/dataset.py ]
quietly apt-get purge '~nrakelight' g++ pkg-config
[ ! -e $module ]
quietly apt-get autoremove --purge
files >/root/after
diff <(grep -i rakelight /root/before || true) <(grep -i rakelight /root/after || true)
# Whose it is does not matter: in Debian 12 the packages that came along leave nothing outside of /var either.
left=$(comm -13 /root/before /root/after)
[ -z "$left" ] || { echo "left behind: $left"; exit 1; }
echo 'installed, drawn, linked and removed'
INSIDE
tests/packages/bare_debian.sh --give build/packages --give data/spot/spot_slab5.glb --give examples/attributes.cpp --give examples/minimal.cpp --out build/packages-tried "$inside"
