#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Cameras and scenes at the edge of sense: each gives one clear line, or the right picture.

  cameras_test.py PROGRAM [unittest arguments]"""
import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from models import TRIANGLE, triangle_gltf, write_glb


class Cameras(program.Case):
    def render(self, *arguments):
        return self.run_program("render", *arguments, "-o", "a.png", "--resolution", "64,48", "--json")

    def covered(self, result):
        self.assertEqual(result.code, 0, result.err)
        return json.loads(result.out)["rows"][0]["stats"]["pixels_covered"]

    def with_camera(self, camera, **node):
        write_glb(self.folder / "a.glb", triangle_gltf([{"mesh": 0}, {"camera": 0, "translation": [0, 0, 3], **node}], cameras=[camera]), TRIANGLE)

    def test_a_camera_that_looks_at_where_it_stands_is_refused(self):
        self.check_no_picture(self.render("builtin:teapot", "--camera-position", "1,2,3", "--camera-focal-point", "1,2,3"), "the same")

    def check_no_picture(self, result, *words):
        self.assertEqual((result.code, len(result.lines)), (2, 1), result.err)
        for word in words:
            self.assertIn(word, result.err)
        self.assertFalse((self.folder / "a.png").exists())

    def test_near_and_far_cut_the_model_and_what_cannot_be_is_refused(self):
        view = ("builtin:sphere", "--camera-position", "0,0,3", "--camera-focal-point", "0,0,0")
        whole = self.covered(self.render(*view))
        for cut, outline in (("--near", 1), ("--far", 0.99)):  # through the middle: near shows the same outline from inside, far the front
            result = self.render(*view, cut, "3", "--cull", "none")
            self.assertAlmostEqual(self.covered(result), outline * whole, delta=0.12 * whole)
        self.assertLess(self.covered(self.render(*view, "--near", "3.9", "--cull", "none")), 0.3 * whole)
        for words, message in ((("--near", "0"), "--near: must be more than 0"), (("--far=-1",), "--far: must be more than 0"), (("--near", "x"), "--near"),
                               (("--near", "2", "--far", "2"), "--near: must be less than --far"), (("--near", "50"), "near, 50 m, is not less than this camera's far"),
                               (("--far", "1"), "far, 1 m, is not more than this camera's near")):
            (self.folder / "a.png").unlink(missing_ok=True)
            self.check_no_picture(self.render(*view, *words), message)

    def test_a_camera_too_far_for_its_far_plane_is_replaced_and_the_plane_is_named(self):
        world = '[[primitive]]\ntype = "sphere"\n[[camera]]\nposition = [0, 0, 4301]\n'
        self.write("free.scene.toml", world)
        self.assertNotIn("default view", self.render("free.scene.toml").out)  # near and far follow the scene
        self.write("w.scene.toml", world + "near = 0.1\n")
        result = self.render("w.scene.toml")
        self.assertIn("all of it is 4300 m away or more, but the far plane is at 1000 m; the default view is used instead", result.out)
        result = self.render("w.scene.toml", "--far", "5000")
        self.assertEqual((result.code, "default view" in result.out), (0, False))

    def test_an_up_along_the_view_gives_a_picture_and_one_of_no_length_is_refused(self):
        view = ("builtin:teapot", "--camera-position", "0,5,0", "--camera-focal-point", "0,0,0")
        along = self.covered(self.render(*view))
        self.assertGreater(along, 100)
        self.assertAlmostEqual(self.covered(self.render(*view, "--camera-view-up", "0,0,-1")), along, delta=0.1 * along)  # only turned
        (self.folder / "a.png").unlink()
        self.check_no_picture(self.render(*view, "--camera-view-up", "0,0,0"), "up")

    def test_a_z_up_model_with_its_up_named_is_the_y_up_one(self):
        """Views, the environment and the camera's own up turn along: the same picture, by coordinates that are only swapped."""
        shape = "mtllib a.mtl\nusemtl m\n" + "".join("v {} {} {}\n".format(*place) for place in ((0, 0, 0), (2, 0, 0), (0, 1, 0), (0, 0, 0.5))) + "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n"
        self.write("a.mtl", "newmtl m\nKd .5 .6 .7\nKs .5 .5 .5\nNs 20\n")
        self.write("y.obj", shape)
        lines = [line.split() for line in shape.splitlines()]
        self.write("z.obj", "".join(("v {} {} {}".format(w[1], -float(w[3]), w[2]) if w[0] == "v" else " ".join(w)) + "\n" for w in lines))
        around = ("--hdri-ambient", "--hdri-skybox", "--hdri-rotation", "33", "--cull", "none")
        for view in (("--view", "front"), ("--view", "top"), ("--view", "bottom"), ("--view", "isometric"), (), ("--camera-azimuth-angle", "50", "--camera-elevation-angle", "20")):
            with self.subTest(view=view):
                pictures = []
                for model, up in (("y.obj", ()), ("z.obj", ("--up", "+Z"))):
                    result = self.run_program("render", model, *up, *view, *around, "-o", model + ".png", "--resolution", "64,48")
                    self.assertEqual(result.code, 0, result.err)
                    pictures.append(program.png(self.folder / (model + ".png"))[3])
                worst = max(abs(a - b) for one, other in zip(*pictures) for a, b in zip(one, other))
                self.assertLessEqual(worst, 2)
        for text in ("+W", "0,0,0", "z+", "1,2"):
            self.check_refused(self.run_program("render", "y.obj", "--up", text, "-o", "b.png"), 2, "up")

    def test_the_fitted_view_fills_nine_tenths_of_the_tighter_side(self):
        """By the picture itself: rows and columns that the model covers."""
        for options in ((), ("--view", "front"), ("--view", "top"), ("--up", "+Z"), ("--camera-view-up", "0,0,1", "--view", "front"), ("--camera-orthographic",),
                        ("--camera-direction", "1,-1,-2"), ("--camera-azimuth-angle", "90"), ("--camera-view-angle", "70")):
            for size in ((240, 90), (90, 240), (160, 160)):
                with self.subTest(options=options, size=size):
                    result = self.run_program("render", "builtin:teapot", *options, "--background", "#ff00ff", "-o", "a.png", "--resolution", "{},{}".format(*size))
                    self.assertEqual(result.code, 0, result.err)
                    width, height, _, rows = program.png(self.folder / "a.png")
                    model = [[row[3 * x:3 * x + 3] != b"\xff\x00\xff" for x in range(width)] for row in rows]
                    high = [any(row) for row in model]
                    wide = [any(row[x] for row in model) for x in range(width)]
                    fill = max(sum(high) / height, sum(wide) / width)
                    self.assertAlmostEqual(fill, 0.9, delta=0.025)
                    self.assertAlmostEqual(high.index(True) / height, high[::-1].index(True) / height, delta=0.04)
                    self.assertAlmostEqual(wide.index(True) / width, wide[::-1].index(True) / width, delta=0.04)

    def test_fields_of_view_that_see_nothing_or_all_are_refused(self):
        for angle in ("0", "180", "-10", "360", "nan", "inf"):
            with self.subTest(angle=angle):
                for option in ("--camera-view-angle", "--camera-horizontal-angle"):
                    self.check_no_picture(self.render("builtin:teapot", option, angle), option)
                self.check_no_picture(self.render("builtin:teapot", "--camera-view-angle", "40", "--camera-horizontal-angle", angle), "--camera-horizontal-angle")
        for option in ("--camera-view-angle", "--camera-horizontal-angle"):
            for angle in ("0.001", "179"):
                self.assertEqual(self.render("builtin:teapot", option, angle).code, 0)

    def test_either_angle_gives_square_pixels_and_both_hold(self):
        """A square of 1 m seen from 1 m: an angle of 2 atan(t) shows 2 t meters."""
        self.write("a.obj", "v -.5 -.5 0\nv .5 -.5 0\nv .5 .5 0\nv -.5 .5 0\nf 1 2 3 4\n")

        def extent(*angles):
            result = self.render("a.obj", "--camera-position", "0,0,1", "--camera-focal-point", "0,0,0", "--background", "0,0,0", *angles)
            self.assertEqual((result.code, result.err), (0, ""))
            rows = program.png(self.folder / "a.png")[3]
            return sum(any(rows[24][3 * x:3 * x + 3]) for x in range(64)), sum(any(row[96:99]) for row in rows)

        def angle(half_tangent):
            return repr(math.degrees(2 * math.atan(half_tangent)))

        for projection in ((), ("--camera-orthographic",)):
            with self.subTest(projection=projection):
                self.assertEqual(extent("--camera-view-angle", "90", *projection), (24, 24))
                self.assertEqual(extent("--camera-horizontal-angle", "90", *projection), (32, 32))
                self.assertEqual(extent("--camera-horizontal-angle", "90", "--camera-view-angle", "90", *projection), (32, 24))
                self.assertEqual(extent("--camera-horizontal-angle", angle(2), "--camera-view-angle", angle(0.75), *projection), (16, 32))

    def test_cameras_of_files_that_cannot_be_are_left_out_and_that_is_said(self):
        for depths, word in (((1, 1), "zfar must be greater than znear"), ((10, 1), "zfar must be greater than znear"), ((0, 100), "znear"), ((-1, 100), "znear"),
                             ((0.1, 1e38), "at most 1e30")):
            with self.subTest(depths=depths):
                self.with_camera({"type": "perspective", "perspective": {"yfov": 0.7, "znear": depths[0], "zfar": depths[1]}})
                result = self.render("a.glb")
                self.assertGreater(self.covered(result), 100)  # the view that is fitted to the model
                self.assertIn(word, result.err)
                self.assertEqual(self.render("a.glb", "--camera-index", "0").code, 2)
        for angle in (0, -1, math.pi, 4):
            with self.subTest(angle=angle):
                self.with_camera({"type": "perspective", "perspective": {"yfov": angle, "znear": 0.1}})
                result = self.render("a.glb")
                self.assertGreater(self.covered(result), 100)
                self.assertIn("yfov", result.err)
        self.with_camera({"type": "orthographic", "orthographic": {"xmag": 0, "ymag": 0, "znear": 0.1, "zfar": 10}})
        self.assertIn("must not be zero", self.render("a.glb").err)

    def test_a_range_that_holds_the_model_is_seen_however_thin_or_wide(self):
        pictures = set()
        for near, far in ((0.1, 100), (1e-20, 1e20), (2.999, 3.001), (1e-20, 3.001), (2.999, 1e29)):
            with self.subTest(near=near, far=far):
                self.with_camera({"type": "perspective", "perspective": {"yfov": 0.7, "znear": near, "zfar": far}})
                self.assertGreater(self.covered(self.render("a.glb", "--camera-index", "0")), 100)
                pictures.add((self.folder / "a.png").read_bytes())
        self.assertEqual(len(pictures), 1)

    def test_a_placement_without_extent_or_turned_inside_out_is_still_a_place(self):
        pictures = set()
        for node in ({}, {"scale": [0, 0, 0]}, {"scale": [1, 0, 1]}, {"scale": [-1, 1, 1]}, {"scale": [7, 7, 7]}, {"rotation": [0, 0, 0, 0]}):
            self.with_camera({"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1}}, **node)
            self.assertGreater(self.covered(self.render("a.glb", "--camera-index", "0")), 100, node)
            pictures.add((self.folder / "a.png").read_bytes())
        self.assertEqual(len(pictures), 1)

    def test_a_scene_without_light_shows_emission_alone_and_one_without_triangles_is_refused(self):
        self.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n")
        self.write("a.mtl", "newmtl m\nKd 1 1 1\nKe 1 0 0\n")
        dark = ("a.obj", "--light", "ambient:0,0,0", "--background", "0,0,0", "--view", "front")
        self.assertGreater(self.covered(self.render(*dark)), 100)
        shown = {bytes(row[3 * x:3 * x + 3]) for row in program.png(self.folder / "a.png")[3] for x in range(64)}
        self.assertEqual(shown, {b"\0\0\0", b"\xff\0\0"})
        (self.folder / "a.png").unlink()
        write_glb(self.folder / "b.glb", {"scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": "nothing"}]}, b"\0\0\0\0")
        result = self.run_program("render", "b.glb", "-o", "a.png")
        self.check_refused(result, 4, "b.glb")


if __name__ == "__main__":
    program.main()
