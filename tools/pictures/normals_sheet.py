#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Models with computed normals on one sheet: each by the weight `angle` with creases at 60 degrees, and beside it by the
defaults (docs/attributes.md).

  normals_sheet.py [--program build/release/rakelight] [--columns N] [--size W,H] MODELS OUT.png

MODELS is the folder of the model set; the models are those of LIST below. Only the standard library is needed."""
import argparse
import pathlib

from look_sheet import words_for
from sheet import PROGRAM, write_sheet

LIST = """
3ds/fels.3ds 3ds/test1.3ds ase/ThreeCubesGreen.ASE blend/4Cubes4Mats_248.blend blend/MirroredCube_252.blend blend/SmoothVsSolidCube_248.blend
crossformat/keg_decorated/keg_decorated.fbx crossformat/stairs_wood_decorated/stairs_wood_decorated.fbx crossformat/table_long_decorated_C/table_long_decorated_C.fbx
dae/Cinema4D.dae dae/earthCylindrical.DAE dae/kwxport_test_vcolors.dae dae/sphere.dae dae/teapots.DAE derived/spot/spot_checker6.glb
derived/spot/spot_noise7.glb derived/spot/spot_slab5.glb derived/stripped/Knight_noNormals.glb fbx/assimp/box.fbx fbx/assimp/phong_cube.fbx
fbx/assimp/spider.fbx fbx/assimp/cubes_with_mirroring_and_pivot.fbx fbx/ufbx/blender_282_suzanne_and_transform_7400_binary.fbx
fbx/ufbx/blender_293_instancing_7400_binary.fbx fbx/ufbx/blender_340_mirrored_normals_7400_binary.fbx fbx/ufbx/max_tangent_sign_7700_binary.fbx
fbx/ufbx/maya_instanced_pivots_7700_ascii.fbx gltf/FlightHelmet/FlightHelmet.gltf gltf/GlamVelvetSofa/GlamVelvetSofa.glb
gltf/BoomBoxWithAxes/BoomBoxWithAxes.gltf gltf/Suzanne/Suzanne.gltf gltf/MetalRoughSpheresNoTextures/MetalRoughSpheresNoTextures.glb
gltf/NegativeScaleTest/NegativeScaleTest.glb gltf/NormalTangentTest/NormalTangentTest.glb gltf/OrientationTest/OrientationTest.glb
gltf/RiggedFigure/RiggedFigure.glb gltf/babylon/BabylonShaderBall_Simple.gltf gltf/babylon/frostAxe_noMorph.glb gltf/babylon/roundedCube.glb
gltf/bevy/torus.gltf gltf/gltf-transform/ShapeCollection.glb gltf/godot/mushroom.glb gltf/kaykit/Knight.glb gltf/kenney/cakeBirthday.glb
gltf/playcanvas/PrimitiveModeNormalsTest.glb gltf/webxr/oculus-touch/right.glb gltf/SimpleInstancing/SimpleInstancing.glb
obj/LeePerrySmith/head.obj obj/assimp/regr01.obj obj/hollowcube.obj obj/spot.obj obj/teapot.obj obj/trimesh/fuze.obj obj/trimesh/quadknot.obj
ply/Wuson.ply ply/sphere.ply ply/suzanne.ply stl/20mm-xyz-cube.stl stl/Spider_binary.stl stl/sphereWithHole.stl
""".split()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("models", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    parser.add_argument("--columns", type=int, default=6, help="models in a row")
    parser.add_argument("--size", default="160,120")
    options = parser.parse_args()
    width, height = map(int, options.size.split(","))
    found = [options.models / name for name in LIST]
    missing = [str(path) for path in found if not path.is_file()]
    if missing or len(found) % options.columns:
        parser.error(f"not there: {' '.join(missing)}" if missing else f"{len(found)} models do not fill {options.columns} columns")
    ways = ("--weight", "angle", "--crease-angle", "60"), ()
    tiles = [[(str(path.resolve()), "--look", "plain", "--normals", "model", *way) for way in ways] for path in found]
    names = [[words_for(path.name, width), ""] for path in found]
    starts = range(0, len(found), options.columns)
    rows = [sum(tiles[i:i + options.columns], []) for i in starts]
    below = [sum(names[i:i + options.columns], []) for i in starts]
    write_sheet(options.picture, rows, width, height, options.program, below=below, samples=4, colors=256)


if __name__ == "__main__":
    main()
