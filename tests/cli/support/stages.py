# SPDX-License-Identifier: Apache-2.0
"""What the tests of `rakelight stages` share."""
import json
import pathlib

import program

SIZE = "96,64"
METAL = pathlib.Path(__file__).resolve().parents[3] / "data/materials/layers.gltf"
BRICKS = pathlib.Path(__file__).resolve().parents[3] / "data/maps/brick_height.png"
STAGES = ["model", "world", "camera", "normalized-frustum", "central-projection", "depth-mapping", "clip-space", "clipped", "clip-planes",
          "wrap-round", "device", "screen", "culled", "coverage", "depth", "depth-precision", "visibility", "normal", "shading-frequency",
          "lighting", "blended", "tone", "picture"]


def linear(code):
    v = code / 255
    return v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4


class Case(program.Case):
    def setUp(self):
        super().setUp()
        self.out = self.folder / "out"

    def stages(self, *options, model="builtin:teapot"):
        run = self.run_program("stages", model, "-o", self.out, "--resolution", SIZE, *options)
        self.assertEqual(run.code, 0, run.err)
        return run

    def table(self, stage):
        return json.loads((self.out / f"{stage}.json").read_text())
