#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight render` of point clouds at its defaults, and colors by numbers of the vertices.

  points_test.py PROGRAM [unittest arguments]"""
import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import clouds
import program

SIZE = ("--resolution", "160,120", "--look", "default")
FLAT = ("--background", "0,0,0", "--view", "front")


def brightness(pixel):
    return 0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2]


class Points(program.Case):
    def picture(self, *arguments, name="out.png"):
        """Rows of (r, g, b)."""
        run = self.run_program("render", *arguments, "-o", name, *SIZE)
        self.assertEqual((run.code, run.err), (0, ""))
        width, height, channels, rows = program.png(self.folder / name)
        return [[tuple(rows[y][x * channels:x * channels + 3]) for x in range(width)] for y in range(height)]

    def put(self, name, data):
        (self.folder / name).write_bytes(data if isinstance(data, bytes) else data.encode())
        return name

    def inside(self, rows):
        """Pixels well within the sphere that fills the picture."""
        return [rows[y][x] for y in range(120) for x in range(160) if math.hypot(x - 79.5, y - 59.5) < 45]

    def test_a_scan_of_a_surface_closes_in_its_colors_with_no_option(self):
        sphere = clouds.sphere(6000)
        for name, data in (("lit.ply", clouds.ply(sphere)), ("unlit.ply", clouds.ply(sphere, normals=False)), ("colors.obj", clouds.obj(sphere)),
                           ("lines.xyz", clouds.xyz(sphere))):
            with self.subTest(name):
                pixels = self.inside(self.picture(self.put(name, data), *FLAT))
                holes = sum(brightness(p) < 4 for p in pixels)
                self.assertLess(holes, 0.01 * len(pixels))
                orange = sum(p[0] > p[2] for p in pixels)
                self.assertGreater(orange, 0.95 * len(pixels), "red outweighs blue all over it")

    def test_names_of_the_writers_and_types_give_one_picture(self):
        sphere = clouds.sphere(800)
        first = self.picture(self.put("a.ply", clouds.ply(sphere)), *FLAT)
        for names in (("diffuse_red", "diffuse_green", "diffuse_blue"), ("r", "g", "b")):
            self.assertEqual(self.picture(self.put("b.ply", clouds.ply(sphere, names=names)), *FLAT), first)
        words = self.picture(self.put("c.ply", clouds.ply(sphere, kind=clouds.WORDS)), *FLAT)
        self.assertLess(max(abs(a - b) for r, s in zip(first, words) for p, q in zip(r, s) for a, b in zip(p, q)), 4)

    def test_normals_light_points_and_a_size_that_is_named_draws_discs(self):
        plain = self.put("plain.ply", clouds.ply(clouds.sphere(6000), names=()))
        pixels = self.inside(self.picture(plain, *FLAT, "--light", "directional:-1,0,0", "--light", "ambient:0.05,0.05,0.05"))
        self.assertGreater(max(map(brightness, pixels)), 3 * min(map(brightness, pixels)), "one side is lit")
        self.assertEqual(len(set(self.inside(self.picture(plain, *FLAT, "--point-size", "8")))), 1, "discs are not lit")
        run = self.run_program("render", plain, "-o", "json.png", *SIZE, "--json")
        self.assertEqual(json.loads(run.out)["rows"][0]["triangles"], 12 * 6000)
        run = self.run_program("render", plain, "-o", "json.png", "--json", "--look", "plain")
        self.assertEqual(json.loads(run.out)["rows"][0]["triangles"], 0)

    def test_a_few_points_are_dots(self):
        rows = self.picture(self.put("few.ply", clouds.ply(clouds.sphere(12))), *FLAT)
        share = sum(brightness(p) > 4 for row in rows for p in row) / (160 * 120)
        self.assertTrue(0.0005 < share < 0.08, share)

    def test_numbers_of_vertices_are_colors_of_the_colormap(self):
        cloud = self.put("a.ply", clouds.ply(clouds.sphere(6000), arrays=[("intensity", lambda p: p[0]), ("height", lambda p: p[1])]))
        rows = self.picture(cloud, *FLAT, "--scalars", "intensity")
        left, right = rows[60][30], rows[60][129]
        self.assertTrue(left[2] > left[1] and right[1] > right[2] + 60, "viridis goes from purple to yellow")
        self.assertEqual(self.picture(cloud, *FLAT, "--scalar-coloring"), rows, "the first array")
        plain, colored = (self.run_program("render", cloud, "-o", "n.png", "--verbose", *FLAT, *words).err for words in ((), ("--scalars", "height")))
        self.assertIn("note: " + str(cloud) + ": numbers of the vertices that a picture shows by --scalars alone: intensity, height", plain)
        self.assertNotIn("alone", colored)
        gray = self.picture(cloud, *FLAT, "--scalars", "height", "--colormap", "gray")
        self.assertLess(gray[100][80][0], gray[20][80][0])
        self.assertEqual(len(set(gray[60][80])), 1)
        narrow = self.picture(cloud, *FLAT, "--scalars", "height", "--colormap", "gray", "--coloring-range", "-0.1,0.1")
        self.assertEqual((narrow[20][80], narrow[100][80]), ((255, 255, 255), (0, 0, 0)))
        bar = self.picture(cloud, *FLAT, "--scalars", "height", "--colormap", "gray", "--bar")
        changed = {x for y in range(120) for x in range(160) if bar[y][x] != gray[y][x]}
        self.assertTrue(changed and min(changed) > 80, "the bar stands at the right")

    def test_names_that_are_not_there_are_said_with_those_that_are(self):
        cloud = self.put("a.ply", clouds.ply(clouds.sphere(50), arrays=[("intensity", lambda p: p[0]), ("height", lambda p: p[1])]))
        self.check_refused(self.run_program("render", cloud, "-o", "a.png", "--scalars", "heigth"), 2, "intensity, height")
        self.check_refused(self.run_program("render", cloud, "-o", "a.png", "--colormap", "turbo"), 2, "--scalar-coloring")
        self.check_refused(self.run_program("render", cloud, "-o", "a.png", "--scalars", "height", "--colormap", "rainbow"), 2, "viridis")
        self.write("square.obj")
        self.check_refused(self.run_program("render", "square.obj", "-o", "a.png", "--scalar-coloring"), 2, "no numbers")

    def test_inspect_lists_numbers_with_their_ranges(self):
        cloud = self.put("a.ply", clouds.ply(clouds.sphere(50), arrays=[("quality", lambda p: 2.0)]))
        arrays = json.loads(self.run_program("inspect", cloud, "--json").out)["rows"][0]["arrays"]
        self.assertEqual([(a["name"], a["components"], a["low"], a["high"], a["vertices"]) for a in arrays], [("quality", 1, 2.0, 2.0, 50)])
        self.assertIn("quality", self.run_program("inspect", cloud).out)

    def test_smooth_keeps_the_colors_of_a_ply_file(self):
        self.put("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                 "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
                 "property list uchar int vertex_indices\nend_header\n0 0 0 255 128 7\n1 0 0 255 128 7\n0 1 0 255 128 7\n3 0 1 2\n")
        self.assertEqual(self.run_program("smooth", "a.ply", "-o", "b.ply").code, 0)
        self.assertEqual((self.folder / "b.ply").read_bytes().count(bytes((255, 128, 7, 255))), 3)

    def test_a_model_that_stands_on_its_lowest_z_gets_a_note(self):
        self.put("stand.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 3\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n")
        note = "--up +Z"
        self.assertIn(note, self.run_program("render", "stand.obj", "-o", "a.png", *SIZE, "--verbose").err)
        self.assertNotIn(note, self.run_program("render", "stand.obj", "-o", "a.png", *SIZE, "--verbose", "--up", "+Z").err)


if __name__ == "__main__":
    program.main()
