#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Paths against pictures of the same scenes by Blender Cycles (data/paths/reference): means of the picture and of its blocks of pixels.

  cycles_test.py PROGRAM [unittest arguments]"""
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import exr
import program

PATHS = pathlib.Path(__file__).resolve().parents[3] / "data/paths"
MODELS = pathlib.Path(os.environ.get("RAKELIGHT_SHARED", PATHS.parents[2] / "shared")) / "assets/gltf"
BLOCK = 16  # px
SKY = ("--hdri-file", PATHS / "sky.hdr", "--hdri-ambient", "--hdri-skybox", "--cull", "none")

WHITE = ("--hdri-file", PATHS / "white.hdr", "--hdri-ambient", "--hdri-skybox", "--cull", "none", "--bump", "none", "--material", "metallic=0",
         "--material", "roughness=1", "--material", "specular_factor=0")


def blocks(path):
    """Means of each color over blocks of BLOCK x BLOCK pixels."""
    width, height, channels = exr.read(path)
    out = []
    for name in "RGB":
        rows = channels[name][1]
        for y in range(0, height - BLOCK + 1, BLOCK):
            for x in range(0, width - BLOCK + 1, BLOCK):
                out.append(sum(sum(row[x:x + BLOCK]) for row in rows[y:y + BLOCK]) / BLOCK ** 2)
    return out


class Cycles(program.Case):
    def hold(self, scene, reference, size, share, share_of_blocks, *options):
        """share: of the mean, that it may be off; share_of_blocks: of the mean too, that blocks may be off, root of the mean square."""
        run = self.run_program("render", PATHS / scene, "-o", "out.exr", "--resolution", size, "--engine", "trace", "--method", "path",
                               "--samples", "64", "--seed", "3", *options)
        self.assertEqual(run.code, 0, run.err)
        ours, theirs = blocks(self.folder / "out.exr"), blocks(PATHS / "reference" / reference)
        mean = sum(theirs) / len(theirs)
        self.assertAlmostEqual(sum(ours) / len(ours) / mean, 1, delta=share)
        off = (sum((a - b) ** 2 for a, b in zip(ours, theirs)) / len(ours)) ** 0.5
        self.assertLess(off / mean, share_of_blocks)

    def setUp(self):
        super().setUp()
        if self.run_program("render", "builtin:plane", "-o", "try.png", "--resolution", "8,8", "--engine", "trace").code != 0:
            self.skipTest("Embree is not there")

    def test_cornell_box(self):
        self.hold("cornell.scene.toml", "cornell.exr", "256,256", 1e-3, 5e-3)

    def test_point_light(self):
        self.hold("lamp.scene.toml", "lamp.exr", "256,256", 1e-3, 8e-3)

    def test_metals(self):
        self.hold("panel.scene.toml", "panel.exr", "320,180", 4e-3, 1e-2)

    def hold_model(self, model, reference, size, share, share_of_blocks, position, target, angle, light=SKY):
        if not MODELS.exists():
            self.skipTest("the shared assets are not there")
        self.hold(MODELS / model, reference, size, share, share_of_blocks, *light, "--camera-position", position, "--camera-focal-point", target,
                  "--camera-view-angle", angle)

    def test_helmet(self):
        self.hold_model("FlightHelmet/FlightHelmet.gltf", "helmet-sky.exr", "640,360", 3e-3, 1e-2, "0.5,0.5,0.9", "0,0.36,0", "40")

    def test_helmet_of_lambert_in_white(self):
        self.hold_model("FlightHelmet/FlightHelmet.gltf", "helmet-white.exr", "320,180", 1e-3, 1e-2, "0.5,0.5,0.9", "0,0.36,0", "40", WHITE)

    def test_suzanne(self):
        self.hold_model("Suzanne/Suzanne.gltf", "suzanne.exr", "320,180", 3e-3, 1e-2, "1.5,0.8,3.5", "0,0,0", "40")

    def test_spheres(self):
        self.hold_model("MetalRoughSpheresNoTextures/MetalRoughSpheresNoTextures.glb", "spheres.exr", "320,180", 5e-3, 2e-2,
                        "0.0028,0.0027,0.0125", "0.0028,0.0027,0", "36")


if __name__ == "__main__":
    program.main()
