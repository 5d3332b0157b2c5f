#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Real models of many parts, each in three pictures side by side: face level, smoothed per object, smoothed over the whole
# model. The seams between the parts are there in the second and gone in the third. Pictures go to build/demo.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."
program=${RAKELIGHT:-build/release/rakelight}
out=build/demo
mkdir -p "$out"

# three NAME MODEL OPTIONS...: face | object | model, side by side in NAME.png
three() {
    local name=$1 model=$2 scope
    shift 2
    for scope in flat object model; do
        "$program" render "$model" -o "$out/$name-$scope.png" --normals "$scope" --crease-angle 180 --resolution 840,840 "$@"
    done
    python3 tools/side_by_side.py --halve "$out/$name.png" "$out/$name-flat.png" "$out/$name-object.png" "$out/$name-model.png"
    echo "$out/$name.png"
}

light=(--light directional:-1,-0.6,-0.35:color=0.9,0.9,0.9 --light ambient:0.06,0.06,0.06)
three spot data/spot/spot_slab5.glb --lighting blinn-phong --camera-position 1.7,0.9,-2.1 --camera-focal-point 0,0.1,0.1 --camera-view-angle 38 "${light[@]}"

# A head scan with a normal map, cut into six objects, under two lamps: tangents show seams too.
cp data/head/head.mtl data/head/color.jpg data/head/normal_from_bump.png "$out/"
python3 tools/cut_obj.py data/head/head.obj "$out/head6.obj" --grid 2,3,1
three head "$out/head6.obj" --camera-position 0.1,0.29,0.5 --camera-focal-point 0,0.282,0.1 --camera-view-angle 20 \
    --light point:0.5,0.5,0.6:color=0.9,0.85,0.8:attenuation=0.6,0.2,0.4 \
    --light point:-0.7,0.1,0.35:color=0.3,0.45,0.75:attenuation=0.4,0.2,0.4 --light ambient:0.02,0.02,0.02

three knight data/knight/Knight_noNormals.glb --camera-position 0.9,1.5,2.6 --camera-focal-point 0,1.15,0 --camera-view-angle 34 \
    --light directional:-1,-0.35,-0.25:color=0.9,0.9,0.9 --light ambient:0.12,0.12,0.12

three teapot builtin:teapot --texture-normal data/bricks/normal.png \
    --camera-position 1.4,1.5,2.9 --camera-focal-point 0.07,0.45,0 --camera-view-angle 36 \
    --light directional:1,-0.75,-0.4:color=0.9,0.88,0.84 --light directional:-1,-0.2,-0.6:color=0.12,0.15,0.22 --light ambient:0.06,0.06,0.06
