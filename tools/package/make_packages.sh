#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the Debian packages into a folder: make_packages.sh [FOLDER [BUILD FOLDER]]; build/packages, build/deb without.
# Files have the time of the last commit (or SOURCE_DATE_EPOCH), so that the same sources give the same bytes.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."

packages=$(readlink -m "${1:-build/packages}")
build=$(readlink -m "${2:-build/deb}")
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}

launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
cmake --preset deb -B "$build" "${launcher[@]}" >/dev/null
cmake --build "$build" -j "$(nproc)"
rm -rf "$build/packages"
(umask 022 && cpack --config "$build/CPackConfig.cmake" -G DEB)
mkdir -p "$packages"
rm -f "$packages"/*.deb
cp "$build"/packages/*.deb "$packages/"
