#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Models as the default look shows them, each with its name, on one sheet (docs/default-look.md).

  look_sheet.py [--program build/release/rakelight] [--columns N] [--look plain] MODELS OUT.png

MODELS is the folder of the model set; the models are those of LIST below. Only the standard library is needed."""
import argparse
import pathlib

from labels import GLYPHS, width_of
from sheet import PROGRAM, write_sheet

LIST = """
gltf/FlightHelmet/FlightHelmet.gltf gltf/GlamVelvetSofa/GlamVelvetSofa.glb gltf/Suzanne/Suzanne.gltf gltf/BoomBoxWithAxes/BoomBoxWithAxes.gltf
gltf/MetalRoughSpheresNoTextures/MetalRoughSpheresNoTextures.glb gltf/NormalTangentTest/NormalTangentTest.glb gltf/blender-io/10_custom_normals.gltf
gltf/NegativeScaleTest/NegativeScaleTest.glb gltf/AlphaBlendModeTest/AlphaBlendModeTest.glb gltf/RiggedFigure/RiggedFigure.glb
gltf/babylon/BabylonShaderBall_Simple.gltf gltf/babylon/frostAxe_noMorph.glb gltf/babylon/roundedCube.glb gltf/bevy/CornellBox.glb
gltf/bevy/torus.gltf gltf/gltf-transform/ShapeCollection.glb gltf/godot/mushroom.glb gltf/kaykit/Knight.glb gltf/kenney/cakeBirthday.glb
gltf/webxr/oculus-touch/right.glb gltf/TextureSettingsTest/TextureSettingsTest.glb gltf/SimpleInstancing/SimpleInstancing.glb gltf/BoxVertexColors/BoxVertexColors.glb
3ds/test1.3ds 3ds/fels.3ds ase/ThreeCubesGreen.ASE blend/4Cubes4Mats_248.blend dae/kwxport_test_vcolors.dae
crossformat/table_long_decorated_C/table_long_decorated_C.fbx fbx/assimp/spider.fbx fbx/ufbx/blender_282_suzanne_and_transform_7400_binary.fbx
obj/LeePerrySmith/head.obj obj/spot.obj obj/teapot.obj obj/trimesh/fuze.obj obj/cornell_box.obj ply/Wuson.ply ply/suzanne.ply
stl/Spider_binary.stl derived/spot/spot_slab5.glb
""".split()


def words_for(name, width):
    """The name in the letters that there are, as much of it as there is room for."""
    words = "".join(c if c in GLYPHS else "-" for c in name.lower())
    while width_of(words) > width:
        words = words[:-1]
    return words


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("models", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    parser.add_argument("--columns", type=int, default=8)
    parser.add_argument("--look", default="default")
    options = parser.parse_args()
    width, height = 160, 120
    found = [options.models / name for name in LIST]
    missing = [str(path) for path in found if not path.is_file()]
    if missing or len(found) % options.columns:
        parser.error(f"not there: {' '.join(missing)}" if missing else f"{len(found)} models do not fill {options.columns} columns")
    tiles = [(str(path.resolve()), "--look", options.look) for path in found]
    names = [words_for(path.name, width) for path in found]
    rows = [tiles[i:i + options.columns] for i in range(0, len(tiles), options.columns)]
    below = [names[i:i + options.columns] for i in range(0, len(names), options.columns)]
    write_sheet(options.picture, rows, width, height, options.program, below=below, samples=4, colors=256)


if __name__ == "__main__":
    main()
