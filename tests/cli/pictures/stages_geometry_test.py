#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The stages of `rakelight stages` before there are pixels: spaces, projection, clipping, displacement, depth.

  stages_geometry_test.py PROGRAM [unittest arguments]"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from program import png
from stages import BRICKS, SIZE, STAGES, Case


class Geometry(Case):
    def test_displacement_shows_the_base_beside_what_it_is_made_into(self):
        options = ["--bump", "displacement", "--height-map", BRICKS, "--bump-depth", "0.02"]
        self.stages(*options, model="builtin:sphere")
        self.assertIn('<section id="displacement">', (self.out / "index.html").read_text())
        numbers = self.table("displacement")["numbers"]
        self.assertEqual(numbers["triangles after"], self.table("culled")["numbers"]["triangles in"])
        self.assertGreater(numbers["triangles after"], 4 * numbers["triangles before, of displaced meshes"])
        self.assertEqual(numbers["highest, from the base [m]"], 0)
        base = self.folder / "base.png"
        run = self.run_program("render", "builtin:sphere", "-o", base, "--resolution", SIZE, "--bump", "none")
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(png(base)[3], png(self.out / "displacement-base.png")[3])
        self.assertEqual(png(self.out / "picture.png")[3], png(self.out / "displacement.png")[3])
        self.assertNotEqual(png(self.out / "displacement-enlarged.png")[3], png(self.out / "displacement-base-enlarged.png")[3])

    def test_heights_of_displacement_are_widths_of_the_texture_times_the_depth(self):
        (self.folder / "h.png").write_bytes((BRICKS).read_bytes())
        world = self.write("w.scene.toml", "[[primitive]]\ntype = 'plane'\nname = 'road'\nsize = [4, 4]\nmaterial = 'bricks'\n"
                           "[[primitive]]\ntype = 'sphere'\nradius = 0.5\nposition = [0, 0.5, 0]\n"
                           "[[material]]\nname = 'bricks'\nbump = 'displacement'\nheight_texture = 'h.png'\nbump_depth = 0.05\n")
        self.stages(model=world)
        table = self.table("displacement")
        self.assertEqual(len(table["rows"]), 1)
        name, before, after, low, high = table["rows"][0]
        self.assertEqual((name, before), ("road", 2))
        self.assertGreater(after, 10000)
        self.assertAlmostEqual(low, -0.2, delta=0.002)  # 4 m are one width; black texels are the lowest
        self.assertAlmostEqual(high, 0, delta=0.002)
        self.stages("--bump", "none", model=self.write("plain.scene.toml", "[[primitive]]\ntype = 'plane'\n"))
        self.assertFalse((self.out / "displacement.json").exists())

    def test_coverage_of_once_is_not_the_color_of_the_most(self):
        one = "[[primitive]]\ntype = 'plane'\nrotation_deg = [90, 0, 0]\n"
        for count, caption in ((1, "blue 1. No pixel is covered twice."), (2, "blue 1, white 2."), (3, "blue 1, over green and yellow to white 3."),
                               (14, "to white 12 and more.")):
            planes = "".join(f"{one}position = [0, 0, {-0.01 * i}]\nmaterial = 'm'\n" for i in range(count))
            world = self.write("w.scene.toml", planes + "[[material]]\nname = 'm'\ndouble_sided = true\n"
                               "[[camera]]\nposition = [0, 0, 8]\ntarget = [0, 0, 0]\n")
            self.stages(model=world)
            table = self.table("coverage")
            self.assertEqual(table["numbers"]["largest overdraw"], count)
            self.assertTrue(table["pictures"][0]["caption"].endswith(caption), table["pictures"][0]["caption"])
            rows = png(self.out / "coverage.png")[3]
            red, green, blue = rows[32][3 * 48:3 * 48 + 3]
            if count == 1:
                self.assertTrue(red < 60 < green < blue, "blue")
            else:
                self.assertEqual((red, green, blue), (255, 255, 255))

    def test_lines_of_large_models_are_no_solid_color(self):
        world = self.write("w.scene.toml", "[[primitive]]\ntype = 'teapot'\ndivisions = 40\n")
        run = self.run_program("stages", world, "-o", self.out, "--resolution", "320,240")
        self.assertEqual(run.code, 0, run.err)
        self.assertGreater(self.table("model")["numbers"]["vertices"], 50000)
        for stage in ("model", "screen", "device", "clipped"):
            self.assertIn("the more, the brighter", self.table(stage)["pictures"][0]["caption"])
            rows = png(self.out / f"{stage}.png")[3]
            drawn = [row[i] for row in rows for i in range(0, len(row), 3) if row[i] != 16]
            self.assertGreater(len(drawn), 500)
            self.assertLess(sum(v == 150 for v in drawn), 0.15 * len(drawn), stage)
            self.assertGreater(len(set(drawn)), 15, stage)

    def test_vertices_agree_from_space_to_space(self):
        self.stages()
        clip, device, screen = (self.table(s)["rows"] for s in ("clip-space", "device", "screen"))
        self.assertGreater(len(clip), 10)
        for c, d, s in zip(clip, device, screen):
            self.assertEqual(c[:2], d[:2])
            self.assertAlmostEqual(c[2] / c[4], d[2], places=9)
            self.assertAlmostEqual((d[2] * 0.5 + 0.5) * 96, s[2], places=6)
            self.assertAlmostEqual((0.5 - d[3] * 0.5) * 64, s[3], places=6)
            self.assertLessEqual(abs(s[2] * 256 - s[4]), 0.5)

    def test_the_projection_is_its_three_matrices_one_after_the_other(self):
        self.stages("--camera-view-angle", "50")
        camera, frustum, central, depth, clip = (self.table(s)["rows"] for s in STAGES[2:7])
        step_1, step_2 = (self.table(s)["numbers"]["matrix"] for s in STAGES[3:5])
        numbers = self.table("depth-mapping")["numbers"]

        def times(matrix, v):
            return [sum(a * b for a, b in zip(row, v)) for row in matrix]

        self.assertAlmostEqual(step_1[1][1], 1 / math.tan(math.radians(25)), 12)
        for i, row in enumerate(camera):
            p = times(step_1, [*row[2:], 1])
            self.assertEqual(p[:3], frustum[i][2:])
            q = times(step_2, p)
            for found, expected in zip(central[i][2:], (q[3], q[0] / q[3], q[1] / q[3])):
                self.assertAlmostEqual(found, expected, 12)
            self.assertAlmostEqual(q[2] / q[3], -1, 12)  # all lie in the plane
            self.assertAlmostEqual(clip[i][2], q[0], 6)  # the engine's own, in single precision
            self.assertAlmostEqual(clip[i][4], q[3], 6)
            for k, name in ((3, "from 0 to 1"), (4, "from -1 to 1")):
                r = times(numbers["matrix of steps 2 and 3, depth " + name], p)
                self.assertAlmostEqual(depth[i][k], r[2] / r[3], 12)
                self.assertEqual(r[:2] + r[3:], q[:2] + q[3:])
        for name, low in (("from 0 to 1", 0), ("from -1 to 1", -1)):
            for distance, expected in ((numbers["near"], low), (numbers["far"], 1)):
                r = times(numbers["matrix of steps 2 and 3, depth " + name], [0, 0, -distance, 1])
                self.assertAlmostEqual(r[2] / r[3], expected, 12)

    def test_a_parallel_projection_divides_by_nothing_and_maps_depth_evenly(self):
        self.stages("--camera-orthographic", "--view", "front")
        for row in self.table("central-projection")["rows"]:
            self.assertEqual(row[2], 1)
        near, far = (self.table("depth-mapping")["numbers"][name] for name in ("near", "far"))
        for _, _, distance, zero_one, minus_one, key in self.table("depth-mapping")["rows"]:
            self.assertAlmostEqual(zero_one, (distance - near) / (far - near), 12)
            self.assertAlmostEqual(minus_one, 2 * zero_one - 1, 12)
            self.assertAlmostEqual(key, 1 - zero_one, 12)
        self.assertIn("nothing can wrap around", self.table("wrap-round")["text"])

    def test_each_plane_cuts_what_passes_it(self):
        # Seen from (0, 0, 0) along -z with 90 degrees: behind the eye, through the left, through the right and top plane, inside.
        (self.folder / "a.obj").write_text("v -1 -1 -5\nv 1 -1 -5\nv 0 0 5\nf 1 2 3\nv -9 0 -5\nv 0 0 -5\nv 0 1 -5\nf 4 5 6\n"
                                         "v 0 0 -4\nv 9 0 -4\nv 0 9 -4\nf 7 8 9\nv 0 0 -3\nv 1 0 -3\nv 0 1 -3\nf 10 11 12\n")
        self.stages("--camera-position", "0,0,0", "--camera-focal-point", "0,0,-3", "--camera-view-angle", "90", model="a.obj")
        rows = {row[0]: row[1:] for row in self.table("clip-planes")["rows"]}
        self.assertEqual(rows["near"], [4, 1, 0, 12, 13])
        # What is left of the first one reaches beyond the sides and the bottom of the picture too.
        self.assertEqual([rows[plane][1] for plane in ("far", "left", "right", "bottom", "top")], [0, 2, 2, 1, 1])
        ordered = [row[1:] for row in self.table("clip-planes")["rows"]]
        for before, after in zip(ordered, ordered[1:]):
            self.assertEqual(before[4], after[3])
        self.assertEqual({p["file"] for p in self.table("clip-planes")["pictures"]},
                         {f"clip-{plane}.png" for plane in ("near", "left", "right", "bottom", "top")})

    def test_what_lies_behind_the_eye_wraps_round_only_without_clipping(self):
        (self.folder / "a.obj").write_text("v -1 -1 -5\nv 1 -1 -5\nv 0 -1 5\nf 1 2 3\n")
        self.stages("--camera-position", "0,0,0", "--camera-focal-point", "0,0,-3", model="a.obj")
        table = self.table("wrap-round")
        self.assertEqual(table["numbers"], {"triangles": 1, "through the eye's plane": 1, "entirely behind the eye": 0})
        wrong, right = (png(self.out / name)[3] for name in ("wrap-round.png", "wrap-round-clipped.png"))
        ground = wrong[0][:3]

        def shows(row):
            return any(row[3 * x:3 * x + 3] != ground for x in range(96))

        self.assertTrue(any(map(shows, wrong[:32])))  # the floor's end behind the eye stands in the sky
        self.assertFalse(any(map(shows, right[:32])))
        self.assertTrue(shows(right[63]))
        self.assertFalse(shows(wrong[63]))  # and the part under the eye is missing
        self.stages()
        table = self.table("wrap-round")
        self.assertEqual(table["numbers"]["through the eye's plane"], 0)
        self.assertIn("built-in example", table["text"])
        self.assertEqual([p["file"] for p in table["pictures"]], ["wrap-round-example.png", "wrap-round-example-clipped.png"])

    def test_a_triangle_through_the_eye_plane_is_clipped_and_listed(self):
        (self.folder / "a.obj").write_text("v -1 -1 -5\nv 1 -1 -5\nv 0 0 5\nf 1 2 3\n")
        self.stages("--camera-position", "0,1,0", "--camera-focal-point", "0,0,-3", model="a.obj")
        table = self.table("clipped")
        self.assertEqual(table["numbers"]["triangles clipped"], 1)
        self.assertEqual(table["numbers"]["crossing, not entirely outside: near"], 1)
        self.assertEqual(table["rows"][0][2], 4)
        self.assertTrue(all(corner[2] > 0 for corner in table["rows"][0][3]))

    def test_in_the_world_the_camera_is_seen_from_one_side_wherever_it_stands(self):
        self.write("a.obj", "v 1 0 0\nv 0 0 1\nv -1 0 0\nv 0 0 -1\nv 0 1 0\nv 0 -1 0\n" +
                   "".join(f"f {i} {i % 4 + 1} {top}\n" for i in range(1, 5) for top in (5, 6)))
        pictures = []
        for view in ("front", "right", "back", "left"):
            self.stages("--view", view, model="a.obj")
            pictures.append(png(self.out / "world.png"))
        for picture in pictures[1:]:
            self.assertEqual(picture, pictures[0])

    def test_the_depth_is_as_fine_as_the_formula_says(self):
        model = pathlib.Path(__file__).resolve().parents[3] / "data/visibility/near_planes.gltf"
        self.stages("--camera-index", "1", model=model)  # near 1 m, far 1000 m
        table = self.table("depth-precision")
        self.assertAlmostEqual(table["numbers"]["share of the depths in the first 2 % of the range"], 0.9533, 4)
        self.assertAlmostEqual(table["numbers"]["part of the range that 98 % of the depths reach"], 0.0467, 4)
        for distance, depth, *steps in table["rows"]:
            self.assertAlmostEqual(depth, 1000 * (distance - 1) / (distance * 999), 12)
            slope = 1000 / (999 * distance ** 2)
            for step, bits in zip((steps[0], steps[1], steps[3]), (16, 24, 32)):
                self.assertAlmostEqual(step * slope * (2 ** bits - 1), 1, 9)


if __name__ == "__main__":
    program.main()
