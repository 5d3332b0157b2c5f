#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The archive in a bare Debian: it runs from where it is unpacked and from where it is moved, with the helper and Embree, as any user, without
# a package; it loads nothing of the system but the C and C++ libraries. Links in its pages lead to files that it has.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."

compgen -G 'build/packages/*.tar.xz' >/dev/null || { echo 'there is no archive: tools/package/make_tarball.sh makes it' >&2; exit 1; }
tar -tf build/packages/rakelight-*.tar.xz >build/tarball.list
grep -q /licenses/libtbb12 build/tarball.list
inside=$(mktemp)
pages=$(mktemp -d)
trap 'rm -rf "$inside" "$pages"' EXIT
tar -C "$pages" --strip-components=1 -xf build/packages/rakelight-*.tar.xz
count=0
while IFS=: read -r page link; do
    target=${link#](}
    target=${target%)}
    case $target in http*) continue ;; esac
    count=$((count + 1))
    [ -e "$(dirname "$page")/${target%#*}" ] || { echo "${page#"$pages"/} leads to ${target}, which is not there"; exit 1; }
done < <(find "$pages" -name '*.md' -exec grep -o -H ']([^)]*)' {} +)
[ "$count" -gt 10 ]
python3 blender/make_zip.py "$pages/again.zip" >/dev/null
cmp "$pages/again.zip" "$pages/share/rakelight/rakelight_seams.zip"
# A bare Debian has no xz.
archive=build/$(basename build/packages/rakelight-*.tar.xz .xz)
xz -dc build/packages/rakelight-*.tar.xz >"$archive"
cat >"$inside" <<'INSIDE'
mkdir '/tmp/a place'
tar -C '/tmp/a place' -xf "$GIVEN"/rakelight-*.tar
mv '/tmp/a place'/rakelight-* '/tmp/a place/moved'
program='/tmp/a place/moved/bin/rakelight'
"$program" --version
cp "$GIVEN/spot_slab5.glb" .
printf 'xof 0303txt 0032\nMesh a {\n3;\n0.0;0.0;0.0;,\n1.0;0.0;0.0;,\n0.0;1.0;0.0;;\n1;\n3;0,1,2;;\n}\n' >a.x
chmod 777 .
as_nobody() { setpriv --reuid=65534 --regid=65534 --clear-groups env HOME=/nowhere "$@"; }
as_nobody "$program" spot_slab5.glb -o spot.png --resolution 100,100
as_nobody "$program" a.x -o x.png --resolution 64,64
as_nobody "$program" spot_slab5.glb -o traced.png --resolution 64,64 --engine trace
for file in spot.png x.png traced.png; do [ "$(head -c 4 "$file" | tail -c 3)" = PNG ]; done
for file in '/tmp/a place/moved'/bin/rakelight '/tmp/a place/moved'/libexec/rakelight/*; do
    foreign=$(ldd "$file" | grep -v -E '/tmp/a place|linux-vdso|ld-linux|lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s)\.so' || true)
    [ -z "$foreign" ] || { echo "$file loads $foreign"; exit 1; }
done
echo 'runs from where it was moved'
INSIDE
tests/packages/bare_debian.sh --give "$archive" --give data/spot/spot_slab5.glb "$inside"
