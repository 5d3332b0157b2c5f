#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Renders the pictures of README.md into build/demo: models of many parts, smoothed per object and over the whole model, side
# by side. The first shows the seams between the parts; the second has none.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/../.."
program=${RAKELIGHT:-build/package/rakelight}
out=build/demo
mkdir -p "$out"

# compare NAME MODEL "SCOPES" OPTIONS...: one picture for each scope of --normals, side by side in NAME.png
compare() {
    local name=$1 model=$2 scopes=$3 scope pictures=()
    shift 3
    for scope in $scopes; do
        pictures+=("$out/$name-$scope.png")
        "$program" render "$model" -o "${pictures[-1]}" --normals "$scope" --crease-angle 180 "$@"
    done
    python3 tools/pictures/side_by_side.py --halve "$out/$name.png" "${pictures[@]}"
    echo "$out/$name.png"
}

compare spot-head data/spot/spot_slab5.glb "object model" --resolution 1120,960 --lighting blinn-phong \
    --camera-position 1.7,0.35,-1.15 --camera-focal-point -0.02,0.42,-0.23 --camera-view-angle 36 \
    --light directional:-0.9,-0.7,1.1:color=0.68,0.66,0.63 --light ambient:0.06,0.07,0.09

# A head scan with a normal map, cut into six objects, under two lamps. Tangents that are made per object show seams, too.
cp data/head/head.mtl data/head/color.jpg data/head/normal_from_bump.png "$out/"
python3 tools/make/cut_obj.py data/head/head.obj "$out/head6.obj" --grid 2,3,1
compare head "$out/head6.obj" "object model" --resolution 1120,960 \
    --camera-position 0.1,0.29,0.5 --camera-focal-point -0.005,0.285,0.1 --camera-view-angle 11 \
    --light point:0.5,0.5,0.6:color=0.9,0.85,0.8:attenuation=0.6,0.2,0.4 \
    --light point:-0.7,0.1,0.35:color=0.3,0.45,0.75:attenuation=0.4,0.2,0.4 --light ambient:0.02,0.02,0.02
