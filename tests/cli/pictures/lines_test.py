#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight render` with lines and points: the options, and models that hold lines and points.

  lines_test.py PROGRAM [unittest arguments]"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program

MARKS = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nl 1 2\nl 3 4\np 1 2 3 4\n"
SIZE = ("--resolution", "90,60", "--background", "0,0,0", "--view", "front")


class Lines(program.Case):
    def lit(self, model, *options, name="out.png"):
        """Pixels that are not background."""
        run = self.run_program("render", model, "-o", name, *SIZE, *options)
        self.assertEqual((run.code, run.err), (0, ""))
        _, _, channels, rows = program.png(self.folder / name)
        return {(x, y) for y, row in enumerate(rows) for x in range(90) if any(row[x * channels:x * channels + 3])}

    def test_edges_lie_over_the_picture_and_a_wireframe_is_edges_alone(self):
        plain = self.lit("builtin:teapot")
        wires = self.lit("builtin:teapot", "--wireframe")
        edges = self.lit("builtin:teapot", "--edges", "--line-color", "1,0,0")
        self.assertLess(len(wires), len(edges) * 1.2)
        self.assertTrue(plain <= edges)
        self.assertEqual(self.lit("builtin:teapot", "-e", "--line-color", "1,0,0"), edges)
        self.assertGreater(len(self.lit("builtin:teapot", "--wireframe", "--line-width", "3")), len(wires))

    def test_points_lie_over_the_picture_and_point_sprites_take_its_place(self):
        self.write("square.obj")
        plain = self.lit("square.obj")
        self.assertTrue(plain < self.lit("square.obj", "--points", "square", "--line-color", "1,1,0"))
        small = self.lit("square.obj", "--point-sprites", "--point-size", "1")
        self.assertTrue(4 <= len(small) <= 16, small)
        self.assertGreater(len(self.lit("square.obj", "--point-sprites", "--point-size", "6")), 4 * 20)

    def test_lines_and_points_of_a_model_are_drawn_without_any_triangle(self):
        self.write("marks.obj", MARKS)
        marks = self.lit("marks.obj", "--point-size", "5", "--json")
        self.assertGreater(len(marks), 60)
        run = self.run_program("render", "marks.obj", "-o", "out.png", "--json", *SIZE)
        stats = json.loads(run.out)["rows"][0]["stats"]
        self.assertEqual((stats["drawn"], stats["pixels_shaded"]), (0, 0))
        self.assertGreater(stats["pixels_marked"], 0)

    def test_sizes_and_colors_are_checked(self):
        for options in (("--line-width", "0"), ("--line-width", "thin"), ("--point-size", "300"), ("--points", "round"),
                        ("--line-color", "transparent"), ("--point-sprites", "--points", "none")):
            run = self.run_program("render", "builtin:teapot", "-o", "out.png", *options)
            self.check_refused(run, 2, options[0])
        self.assertNotIn("or transparent", self.run_program("render", "builtin:teapot", "-o", "out.png", "--line-color", "rod").err)
        self.assertEqual(self.files(), [])

    def test_only_surfaces_can_be_explained_and_the_scenes_own_lines_are_pointed_out(self):
        self.check_refused(self.run_program("explain", "builtin:teapot", "--pixel", "5,5", "--edges"), 2, "--edges")
        self.check_refused(self.run_program("stages", "builtin:teapot", "-o", "out", "--wireframe"), 2, "--wireframe")
        self.write("both.obj", program.SQUARE.format(name="square") + "l 1 3\n")
        run = self.run_program("explain", "both.obj", "--pixel", "45,30", *SIZE)
        self.assertEqual(run.code, 0, run.err)
        self.assertIn("lines or points", run.err)

    def test_stages_show_the_scenes_lines_in_the_picture(self):
        self.write("both.obj", program.SQUARE.format(name="square") + "l 1 3\n")
        self.lit("both.obj")
        run = self.run_program("stages", "both.obj", "-o", "stages", *SIZE)
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(program.png(self.folder / "stages/picture.png"), program.png(self.folder / "out.png"))


if __name__ == "__main__":
    program.main()
