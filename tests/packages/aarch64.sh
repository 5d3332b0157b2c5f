#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# AArch64: cross-builds the program and the tests of bits (attributes, core, engine soft; optional parts off) with Debian's compiler and a
# tree of Debian's arm64 libraries, runs them under qemu-aarch64, and compares attributes and pictures byte by byte with those of
# the program of this machine.
#
#   aarch64.sh [PROGRAM]      default: build/release/rakelight
#
# The tree is kept in build/arm64 (or $RAKELIGHT_ARM64_TREE), the build in build/aarch64. Exit code 1 where bytes differ, 77 where a tool is missing.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."

program=$(readlink -f "${1:-build/release/rakelight}")
tree=${RAKELIGHT_ARM64_TREE:-$PWD/build/arm64}
packages=libc6-dev,libstdc++-12-dev,libtbb-dev,libexpat1-dev,libspng-dev,libjpeg62-turbo-dev,libfmt-dev,nlohmann-json3-dev,libxsimd-dev,libcli11-dev,libtomlplusplus-dev,libstb-dev,libgtest-dev,libmpfr-dev

skip() { echo "skipped: $*"; exit 77; }
[ -x "$program" ] || { echo "aarch64.sh: no program at $program" >&2; exit 2; }
[ "$(id -u)" = 0 ] || skip "debootstrap needs root"
for tool in debootstrap aarch64-linux-gnu-g++ qemu-aarch64 ninja; do
    command -v $tool >/dev/null || skip "$tool is not installed (Debian: debootstrap, g++-aarch64-linux-gnu, qemu-user, ninja-build)"
done

if [ ! -e "$tree/complete" ]; then
    rm -rf --one-file-system "$tree"
    mkdir -p "$tree"
    debootstrap --arch=arm64 --foreign --variant=minbase --include=$packages bookworm "$tree/root" >"$tree/log" 2>&1 ||
        { tail -n 20 "$tree/log" >&2; exit 1; }
    for package in "$tree"/root/var/cache/apt/archives/*.deb; do dpkg-deb -x "$package" "$tree/root"; done
    touch "$tree/complete"
fi

launcher=()
command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
off=()
for part in DRACO MESHOPT SUBDIVISION OPENEXR WEBP IMPORT OPENGL TRACE VIEWER; do off+=("-DRAKELIGHT_$part=OFF"); done
mkdir -p build/aarch64
cmake -S . -B build/aarch64 -G Ninja -DCMAKE_TOOLCHAIN_FILE=cmake/toolchains/aarch64-linux-gnu.cmake -DRAKELIGHT_SYSROOT="$tree/root" \
    -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -g0" -DRAKELIGHT_WERROR=ON "${launcher[@]}" "${off[@]}" >build/aarch64/configure.log 2>&1 ||
    { tail -n 20 build/aarch64/configure.log >&2; exit 1; }
cmake --build build/aarch64 --target rakelight test_math test_raster

arm() { qemu-aarch64 -L "$tree/root" "$@"; }
echo "wide arithmetic, and pictures for each number of threads and each window, under qemu"
arm build/aarch64/src/math/test_math --gtest_brief=1
arm build/aarch64/src/engines/raster/test_raster --gtest_filter='*Bits*' >build/aarch64/bits.log || { tail -n 20 build/aarch64/bits.log; exit 1; }
grep -q '\[  PASSED  \] [1-9]' build/aarch64/bits.log || { echo "no test of bits ran"; exit 1; }

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
count=0
different=0
# same NAME ARGUMENTS...: the file that both programs write, with %o in its place
same() {
    local name=$1
    shift
    "$program" "${@//%o/$out/x86_$name}" >/dev/null 2>&1 || { echo "$name: x86-64 failed: $*"; different=$((different + 1)); return; }
    arm build/aarch64/rakelight "${@//%o/$out/arm_$name}" >"$out/log" 2>&1 || { echo "$name: AArch64 failed: $*"; tail -n 3 "$out/log"; different=$((different + 1)); return; }
    count=$((count + 1))
    cmp -s "$out/x86_$name" "$out/arm_$name" || { echo "$name: differs: $*"; different=$((different + 1)); }
}

small=(--resolution "320,240")
for model in data/spot/*.glb data/head/head.obj data/knight/*.glb data/cages/jack.obj builtin:teapot; do
    name=$(basename "$model" | tr ':.' '__')
    same "$name.png" render "$model" -o %o "${small[@]}"
    case $model in builtin:*) continue ;; esac
    same "$name.glb" smooth "$model" -o %o
    same "${name}_tangents.glb" smooth "$model" -o %o --tangents always
done
for world in data/lighting/*.scene.toml data/materials/*.gltf data/maps/wall.obj data/environment/*.scene.toml; do
    same "$(basename "$world" | tr . _).png" render "$world" -o %o "${small[@]}"
done
for lighting in lambert phong blinn-phong oren-nayar ward pbr; do
    same "lighting_$lighting.png" render builtin:teapot -o %o "${small[@]}" --lighting $lighting
done
echo "$count files compared, $different differ"
[ "$different" = 0 ] || exit 1
[ "$count" -gt 40 ] || { echo "only $count files were compared"; exit 1; }
