#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Sizes at the far end: a hundred thousand objects, one object of twenty million triangles, textures of 8192 x 8192.

  sizes_test.py PROGRAM [unittest arguments]"""
import json
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from models import TRIANGLE, triangle_gltf, write_glb, write_grid, write_quarters
from program import png

QUAD = "mtllib a.mtl\nusemtl white\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n"


class Sizes(program.Case):
    def render(self, *arguments):
        result = self.run_program("render", *arguments, "-o", "a.png", "--json", "--background", "0,0,0")
        self.assertEqual(result.code, 0, result.err)
        return json.loads(result.out)["rows"][0], png(self.folder / "a.png")[3]

    def test_a_hundred_thousand_objects_are_each_in_their_place(self):
        side = 317
        nodes = [{"mesh": 0, "translation": [x - 158, y - 158, 0]} for y in range(side) for x in range(side)]
        write_glb(self.folder / "a.glb", triangle_gltf(nodes), TRIANGLE)
        row, pixels = self.render("a.glb", "--resolution", "1268,1268", "--shading", "unlit", "--camera-position", "0,0,100",
                                  "--camera-focal-point", "0,0,0", "--camera-orthographic", "--camera-view-angle", "115.480")
        self.assertEqual((row["objects"], row["stats"]["triangles_in"]), (side * side, side * side))
        # Four pixels an object, give or take the angle: each covers about 5 of its 16, so that every column and row of objects shows.
        self.assertAlmostEqual(row["stats"]["pixels_covered"] / (side * side), 16 * 0.32, delta=1)
        for y in range(0, 1268, 4):
            self.assertTrue(any(any(line) for line in pixels[y:y + 4]), y)

    def test_one_object_of_twenty_million_triangles_is_drawn(self):
        with open("/proc/meminfo") as file:
            free = {line.split(":")[0]: int(line.split()[1]) for line in file}["MemAvailable"]
        if free < 6_000_000:
            self.skipTest("needs 6 GB of free memory")
        write_grid(self.folder / "a.glb", 3163)
        row, pixels = self.render("a.glb", "--resolution", "400,400", "--normals", "model", "--view", "front", "--camera-orthographic")
        self.assertEqual((row["objects"], row["stats"]["triangles_in"]), (1, 2 * 3163 * 3163))
        lit = [[any(line[3 * x:3 * x + 3]) for x in range(400)] for line in pixels]
        columns, rows = [x for x in range(400) if lit[200][x]], [y for y in range(400) if lit[y][200]]
        # A square without a hole.
        self.assertAlmostEqual(len(columns), len(rows), delta=1)
        self.assertEqual(sum(map(sum, lit)), len(columns) * len(rows))
        self.assertEqual((columns[-1] - columns[0], rows[-1] - rows[0]), (len(columns) - 1, len(rows) - 1))
        self.assertGreater(len(columns), 150)

    def test_textures_of_8192_texels_a_side_are_read(self):
        write_quarters(self.folder / "a.png", 8192)
        os.rename(self.folder / "a.png", self.folder / "texture.png")
        self.write("quad.obj", QUAD)
        self.write("a.mtl", "newmtl white\nKd 1 1 1\n")
        _, pixels = self.render("quad.obj", "--resolution", "300,300", "--shading", "unlit", "--view", "front", "--texture-base-color", "texture.png",
                                "--texture-normal", "texture.png")
        quarters = [tuple(pixels[y][3 * x:3 * x + 3]) for y in (110, 190) for x in (110, 190)]
        self.assertEqual(quarters, [(255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 255)])


if __name__ == "__main__":
    program.main()
