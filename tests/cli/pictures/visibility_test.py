#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight render --visibility` on the scenes of data/visibility: each failure where the textbook says it is, and none elsewhere.

  visibility_test.py PROGRAM [unittest arguments]"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from models import TRIANGLE, triangle_gltf, write_glb

DATA = pathlib.Path(__file__).resolve().parents[3] / "data/visibility"
SIDE = 120
FRONT = ("--shading", "unlit", "--camera-position", "0,0,5", "--camera-focal-point", "0,0,0")
DEPTHS = ("z16", "z24", "z32", "z-float", "z-reversed")


class Visibility(program.Case):
    def picture(self, model, *options):
        run = self.run_program("render", DATA / model, "-o", "out.png", "--resolution", f"{SIDE},{SIDE}", *options)
        self.assertEqual((run.code, run.err), (0, ""))
        _, _, channels, rows = program.png(self.folder / "out.png")
        return lambda x, y: tuple(rows[y][x * channels:x * channels + 3])

    def owner(self, color):
        """red, green, blue or background: the names of data/visibility/colors.mtl."""
        red, green, blue = color
        if max(color) - min(color) < 20:
            return "background"
        return {red: "red", green: "green", blue: "blue"}[max(color)]

    def test_only_depth_solves_the_cyclic_overlap(self):
        places, right = ((35, 74), (84, 74), (60, 32)), ["red", "green", "blue"]
        for method, owners in [(m, right) for m in DEPTHS] + [("painter", ["blue", "green", "blue"]), ("none", ["blue", "green", "blue"])]:
            at = self.picture("cyclic.obj", *FRONT, "--camera-view-angle", "46", "--visibility", method)
            self.assertEqual([self.owner(at(*p)) for p in places], owners, method)

    def test_only_depth_splits_triangles_that_pass_through_each_other(self):
        for method in DEPTHS + ("painter",):
            at = self.picture("crossing.obj", *FRONT, "--camera-view-angle", "36", "--visibility", method)
            left, right = self.owner(at(52, 45)), self.owner(at(68, 45))
            self.assertEqual((left, right), ("blue", "blue") if method == "painter" else ("red", "blue"), method)

    def test_planes_2_cm_apart_fight_in_16_bits_at_20_m_and_in_no_finer_format(self):
        for method in DEPTHS:
            at = self.picture("near_planes.gltf", "--visibility", method)
            blue_rows = sum(at(60, y)[2] > at(60, y)[0] for y in range(40, 100))
            if method == "z16":
                self.assertGreater(blue_rows, 10)
                self.assertLess(blue_rows, 50)
            else:
                self.assertEqual(blue_rows, 0, method)

    def test_the_default_is_reversed_depth(self):
        for options, name in (((), "a.png"), (("--visibility", "z-reversed"), "b.png")):
            run = self.run_program("render", "builtin:teapot", "-o", name, "--resolution", "90,60", *options)
            self.assertEqual(run.code, 0, run.err)
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())

    def test_interpolation_on_the_screen_bends_textures(self):
        model = DATA.parents[1] / "tests/golden/models/floor.obj"
        view = ("--camera-position", "0,1.2,4", "--camera-focal-point", "0,0.8,0", "--camera-view-angle", "60", "--shading", "unlit")
        pictures = []
        for words in ((), ("--interpolation", "perspective"), ("--interpolation", "screen")):
            run = self.run_program("render", model, "-o", "out.png", "--resolution", "96,72", *view, *words)
            self.assertEqual((run.code, run.err), (0, ""))
            pictures.append((self.folder / "out.png").read_bytes())
        self.assertEqual(pictures[0], pictures[1])
        self.assertNotEqual(pictures[0], pictures[2])
        self.check_refused(self.run_program("render", model, "-o", "a.png", "--interpolation", "linear"), 2, "--interpolation")

    def test_culling_back_faces_of_an_open_box_is_warned_of_where_it_was_asked_for(self):
        view = ("-o", "out.png", "--resolution", "64,48", "--camera-position", "2.4,3.4,4.2", "--camera-focal-point", "0,0.5,0")
        open_box = DATA / "open_box.obj"
        run = self.run_program("render", open_box, *view, "--cull", "back")
        self.assertEqual((run.code, len(run.lines)), (0, 1), run.err)
        for words in ("rakelight: warning: ", "'box'", "4 boundary edges"):
            self.assertIn(words, run.err)
        for words in ((), ("--cull", "none"), ("--cull", "front"), ("--visibility", "back-face")):
            run = self.run_program("render", open_box, *view, *words)
            self.assertEqual((run.code, run.err), (0, ""), words)
        self.assertIn("4 boundary edges", self.run_program("render", open_box, *view, "--visibility", "back-face", "--verbose").err)
        closed = self.write("closed.obj", open_box.read_text() + "f 5 6 7 8\n")
        run = self.run_program("render", closed, *view, "--cull", "back")
        self.assertNotIn("boundary", run.err)

    def test_a_model_that_turns_clockwise_is_drawn_as_one_that_does_not(self):
        """A triangle without normals, of a single-sided material, and the same with two corners exchanged."""
        turned = TRIANGLE[:12] + TRIANGLE[24:] + TRIANGLE[12:24]

        def picture(corners, *words):
            write_glb(self.folder / "a.glb", triangle_gltf([{"mesh": 0}]), corners)
            run = self.run_program("render", "a.glb", "-o", "out.png", "--resolution", "64,48", "--view", "front", *words)
            self.assertEqual(run.code, 0, run.err)
            return (self.folder / "out.png").read_bytes()

        right = picture(TRIANGLE)
        self.assertNotEqual(picture(turned), right)
        self.assertEqual(picture(turned, "--front-face", "cw"), right)
        self.assertEqual(picture(turned, "--front-face", "cw", "--shading", "gouraud"), picture(TRIANGLE, "--shading", "gouraud"))
        self.assertNotEqual(picture(TRIANGLE, "--front-face", "cw"), right)
        self.check_refused(self.run_program("render", "a.glb", "-o", "b.png", "--front-face", "left"), 2, "--front-face", "ccw")

    def test_an_unknown_method_is_wrong_usage(self):
        run = self.run_program("render", "builtin:teapot", "-o", "out.png", "--visibility", "w-buffer")
        self.check_refused(run, 2, "--visibility", "w-buffer", "painter")
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    program.main()
