#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the archive that runs where it is unpacked, into a folder: make_tarball.sh [FOLDER [BUILD FOLDER]]; build/packages, build/package
# without. It holds the programs, the helper and every library that they need but those of the C and C++ compilers and of the display,
# each with its licence, and Embree. It needs the C library of the machine that made it, or a later one.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."

packages=$(readlink -m "${1:-build/packages}")
build=$(readlink -m "${2:-build/package}")
epoch=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
command -v patchelf >/dev/null || { echo 'make_tarball.sh: patchelf is missing (Debian: patchelf)' >&2; exit 1; }

launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
cmake --preset package -B "$build" "${launcher[@]}" >/dev/null
cmake --build "$build" -j "$(nproc)"

version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
name=rakelight-$version-linux-$(uname -m)
stage=$(mktemp -d)
trap 'rm -rf "$stage"' EXIT
root=$stage/$name
for component in programs viewer documentation; do
    cmake --install "$build" --prefix "$root" --strip --component "$component" >/dev/null
done
# rakelight-doc has the pages, and the repository; without them, links in the list of changes are words.
doc=$root/share/doc/rakelight
rm -rf "$doc/docs" "$doc/examples" "$doc/README.md"
sed -i -E 's/\[([^]]*)\]\([^):]*\)/\1/g' "$doc/CHANGELOG.md"
cp packages/archive/README.in "$root/README.md"

# Of the system: the compilers' libraries, and those that belong to its display and drivers.
system='^(ld-linux.*|lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s|X11|xcb|Xau|Xdmcp|GL|EGL|GLX|OpenGL|GLdispatch)\.so.*)$'
# needed FILE: paths of the libraries that it loads, with what they load.
needed() { ldd "$1" | awk '$2 == "=>" && $3 ~ "^/" {print $3}'; }

mkdir -p "$root/lib" "$doc/licenses"
programs=("$root"/bin/* "$root"/libexec/rakelight/*)
embree=$(ldconfig -p | awk '/libembree3\.so\.3 / {print $NF; exit}')
{
    for program in "${programs[@]}"; do needed "$program"; done
    if [ -n "$embree" ]; then echo "$embree"; needed "$embree"; else echo 'make_tarball.sh: without Embree, which is not installed' >&2; fi
} | sort -u | while read -r library; do
    file=$(basename "$library")
    if [[ $file =~ $system ]]; then continue; fi
    install -m 644 "$(readlink -f "$library")" "$root/lib/$file"
    package=$(dpkg -S "$(readlink -f "$library")" 2>/dev/null | head -n 1 | cut -d: -f1 || true)
    [ -n "$package" ] || package=$(dpkg -S "${library#/usr}" 2>/dev/null | head -n 1 | cut -d: -f1)
    cp -L "/usr/share/doc/$package/copyright" "$doc/licenses/$package"
done
cp packages/debian/copyright "$doc/licenses/rakelight"

# Each finds the others from where it is.
for program in "$root"/bin/*; do patchelf --set-rpath "\$ORIGIN/../lib" "$program"; done
for program in "$root"/libexec/rakelight/*; do patchelf --set-rpath "\$ORIGIN/../../lib" "$program"; done
for library in "$root"/lib/*; do patchelf --set-rpath "\$ORIGIN" "$library"; done

mkdir -p "$packages"
chmod -R u=rwX,go=rX "$root"
tar -C "$stage" --sort=name --mtime="@$epoch" --owner=0 --group=0 --numeric-owner -c "$name" | xz -6 -T1 >"$packages/$name.tar.xz"
ls -l "$packages/$name.tar.xz"
