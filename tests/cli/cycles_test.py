#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Paths against pictures of the same scenes by Blender Cycles (data/paths/reference): means of the picture and of its blocks of pixels.

  cycles_test.py PROGRAM [unittest arguments]"""
import pathlib

import exr
import program

PATHS = pathlib.Path(__file__).resolve().parents[2] / "data/paths"
BLOCK = 16  # px


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
    def hold(self, scene, reference, size, share, share_of_blocks):
        """share: of the mean, that it may be off; share_of_blocks: of the mean too, that blocks may be off, root of the mean square."""
        run = self.run_program("render", PATHS / scene, "-o", "out.exr", "--resolution", size, "--engine", "trace", "--method", "path",
                               "--samples", "64", "--seed", "3")
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


if __name__ == "__main__":
    program.main()
