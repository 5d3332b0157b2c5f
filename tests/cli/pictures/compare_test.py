#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs `rakelight compare`: numbers, limits and exit codes, folders, scenes and engines, outputs, and what it refuses.

  compare_test.py PROGRAM [unittest arguments]"""
import base64
import json
import math
import pathlib
import re
import struct
import sys
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from program import png

SIZE = "64,48"


def png_bytes(width, height, rows):
    """An RGB picture; rows of width * 3 codes."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))) + chunk(b"IEND", b""))


class Compare(program.Case):
    def picture(self, name, code=100, width=20, height=16):
        (self.folder / name).parent.mkdir(exist_ok=True)
        (self.folder / name).write_bytes(png_bytes(width, height, [[code] * (3 * width)] * height))
        return name

    def rows(self, *arguments, code=0):
        run = self.run_program("compare", *arguments, "--json")
        self.assertEqual(run.code, code, run.err)
        document = json.loads(run.out)
        self.assertEqual(document["schema"], "rakelight.compare/1")
        return document["rows"]

    def test_the_table_and_the_json_say_how_much_two_pictures_differ(self):
        a, b = self.picture("a.png", 100), self.picture("b.png", 151)
        run = self.run_program("compare", a, b)
        self.assertEqual((run.code, run.err), (0, ""))
        head, row = run.out.splitlines()
        self.assertEqual(head.split(), ["A", "B", "max", "error", "RMSE", "PSNR", "[dB]", "SSIM", "FLIP", "differing"])
        self.assertEqual(row.split()[:5], ["a.png", "b.png", "0.2", "0.2", "13.9794"])
        self.assertEqual(row.split()[-2:], ["100", "%"])
        (found,) = self.rows(a, b)
        self.assertAlmostEqual(found["max_error"], .2)
        self.assertAlmostEqual(found["psnr_db"], -20 * math.log10(.2))
        x, y = 100 / 255, 151 / 255
        self.assertAlmostEqual(found["ssim"], (2 * x * y + 1e-4) / (x * x + y * y + 1e-4), places=9)
        self.assertEqual((found["width"], found["height"], found["differing_pixels"], found["equal"]), (20, 16, 320, False))
        self.assertTrue(0 < found["flip"] < 1)

    def test_equal_pictures_have_no_end_of_psnr(self):
        self.picture("a.png"), self.picture("b.png")
        (found,) = self.rows("a.png", "b.png", "--max-error", 0, "--max-flip", 0, "--min-ssim", 1, "--min-psnr", 200, "--max-rmse", 0, "--max-differing", 0)
        self.assertEqual((found["equal"], found["psnr_db"], found["ssim"], found["flip"]), (True, None, 1, 0))

    def test_a_limit_that_is_passed_is_exit_code_5_and_a_line(self):
        self.picture("a.png", 100), self.picture("b.png", 102)
        for option, kept, passed in (("--max-error", "2/255", "1.9/255"), ("--max-rmse", "2/255", ".007"), ("--min-psnr", "42", "43"),
                                     ("--min-ssim", ".999", ".9999"), ("--max-flip", ".06", ".01"), ("--max-differing", "1", ".99")):
            self.assertEqual(self.run_program("compare", "a.png", "b.png", option, kept).code, 0, option)
            run = self.run_program("compare", "a.png", "b.png", option, passed)
            self.assertEqual((run.code, len(run.lines)), (5, 1), option)
            self.assertTrue(run.err.startswith(f"rakelight: error: b.png: {option[2:]}: "), run.err)
        self.assertEqual(self.run_program("compare", "a.png", "b.png", "--tolerance", "2/255", "--max-differing", "0").code, 0)
        (row,) = self.rows("a.png", "b.png", "--max-flip", 0, "--max-error", 0, code=5)
        self.assertEqual([f["limit"] for f in row["check"]["failures"]], ["max-error", "max-flip"])

    def test_pictures_of_different_size_are_one_line(self):
        self.picture("a.png"), self.picture("b.png", width=21)
        self.check_refused(self.run_program("compare", "a.png", "b.png"), 5, "a.png, b.png: the pictures differ in size: 20 x 16 and 21 x 16 pixels")

    def test_what_cannot_be_read_is_one_line_with_its_name(self):
        self.picture("a.png")
        (self.folder / "text.png").write_text("no picture")
        (self.folder / "short.png").write_bytes((self.folder / "a.png").read_bytes()[:60])
        (self.folder / "empty.png").write_bytes(b"")
        (self.folder / "huge.png").write_bytes(png_bytes(30000, 30000, [[0] * 30]))
        for name, code in (("none.png", 3), ("text.png", 4), ("short.png", 4), ("empty.png", 4), ("huge.png", 4)):
            self.check_refused(self.run_program("compare", "a.png", name), code, name)
            self.check_refused(self.run_program("compare", name, "a.png"), code, name)
        self.check_refused(self.run_program("compare", "a.png", "a.png", "--max-memory", "2000"), 4, "memory")

    def test_wrong_usage_is_one_line(self):
        self.picture("a.png"), self.picture("b/a.png")
        for arguments, word in ((("a.png",), "not 1"), (("a.png", "a.png", "a.png"), "not 3"), (("a.png", "b"), "b: is a folder"),
                                (("a.png", "a.png", "--lighting", "phong"), "--lighting"), (("a.png", "a.png", "-o", "x.gif"), "x.gif"),
                                (("a.png", "a.png", "--gain", "3"), "--gain"), (("a.png", "a.png", "-o", "d.png", "--gain", "3"), "--gain"),
                                (("a.png", "a.png", "--difference", "flip"), "--difference"), (("a.png", "a.png", "--max-flip", "x"), "--max-flip"),
                                (("a.png", "a.png", "--max-error", "1/0"), "--max-error"), (("a.png", "a.png", "--tolerance", "-1"), "--tolerance"),
                                (("a.png", "a.png", "--pixels-per-degree", "0"), "--pixels-per-degree"),
                                (("--engines", "soft", "builtin:teapot"), "--engines"), (("--engines", "soft,soft"), "A B is required"),
                                (("--engines", "soft,soft", "builtin:teapot", "--engine", "soft"), "--engine"),
                                (("--engines", "soft,nosuch", "builtin:teapot"), "'nosuch' is not built in")):
            with self.subTest(arguments):
                self.check_refused(self.run_program("compare", *arguments), 2, word)
        self.check_refused(self.run_program("compare", "a.png", "a.png", "-o", "a.png/d.png"), 1, "a.png")

    def test_the_difference_is_a_picture(self):
        a, b = self.picture("a.png", 100), self.picture("b.png", 103)
        (row,) = self.rows(a, b, "-o", "d.png", "--difference", "absolute")
        self.assertEqual(row["output"], "d.png")
        self.assertEqual(png(self.folder / "d.png"), (20, 16, 3, [bytearray([30] * 60)] * 16))
        self.rows(a, b, "-o", "d.png", "--difference", "absolute", "--gain", 2)
        self.assertEqual(png(self.folder / "d.png")[3][0], bytearray([6] * 60))
        self.rows(a, a, "-o", "d.png")
        self.assertEqual(png(self.folder / "d.png")[3][0], bytearray([20, 20, 64] * 20))

    def test_two_folders_are_compared_by_the_names_in_them(self):
        self.picture("a/same.png"), self.picture("b/same.png"), self.picture("a/other.png", 10), self.picture("b/other.png", 20)
        self.picture("a/only_a.png"), self.picture("b/only_b.png")
        for other in ("a/.hidden.png", "a/notes.txt", "b/report.json"):
            (self.folder / other).write_text("x")
        run = self.run_program("compare", "a", "b", "-o", "page.html")
        self.assertEqual(run.code, 5)
        self.assertEqual(run.lines, ["rakelight: error: a/only_a.png: there is no such file in 'b'", "rakelight: error: b/only_b.png: there is no such file in 'a'"])
        self.assertEqual([line.split()[0] for line in run.out.splitlines()], ["A", "a/other.png", "a/same.png"])
        self.assertEqual((self.folder / "page.html").read_text().count("<section>"), 2)
        rows = self.rows("a", "b", code=5)
        self.assertEqual([row["a"] for row in rows], ["a/only_a.png", "a/only_b.png", "a/other.png", "a/same.png"])
        self.assertEqual(rows[0]["error"]["code"], "check_failed")

    def test_each_pair_of_folders_has_its_own_difference(self):
        for folder in "ab":
            self.picture(f"{folder}/one.png"), self.picture(f"{folder}/two.png")
        self.check_refused(self.run_program("compare", "a", "b", "-o", "d.png"), 2, "{model}")
        self.assertEqual(self.run_program("compare", "a", "b", "-o", "d-{model}.png").code, 0)
        self.assertEqual([n for n in self.files() if n.startswith("d-")], ["d-one.png", "d-two.png"])
        (self.folder / "c").mkdir(), (self.folder / "e").mkdir()
        self.check_refused(self.run_program("compare", "c", "e"), 3, "c: neither")

    def test_one_broken_pair_does_not_stop_the_others(self):
        for folder in "ab":
            self.picture(f"{folder}/good.png"), self.picture(f"{folder}/bad.png")
        (self.folder / "b/bad.png").write_text("no picture")
        run = self.run_program("compare", "a", "b")
        self.assertEqual((run.code, len(run.lines), len(run.out.splitlines())), (4, 1, 2))

    def test_engines_draw_the_scene_as_render_does(self):
        (row,) = self.rows("--engines", "soft,soft", "builtin:teapot", "--resolution", SIZE, "--lighting", "phong", "--max-error", 0)
        self.assertEqual((row["engine_a"], row["engine_b"], row["equal"]), ("soft", "soft", True))
        self.assertEqual((row["width"], row["height"]), (64, 48))
        self.run_program("render", "builtin:teapot", "-o", "a.png", "--resolution", SIZE)
        self.run_program("render", "builtin:teapot", "-o", "b.png", "--resolution", SIZE, "--lighting", "lambert")
        run = self.run_program("compare", "--engines", "soft,soft", "builtin:teapot", "--resolution", SIZE, "--lighting", "lambert", "-o", "p.html")
        self.assertEqual(run.code, 0, run.err)
        pictures = re.findall(r'<img class="(\w+)"[^>]* src="data:image/png;base64,([^"]+)"', (self.folder / "p.html").read_text())
        self.assertEqual([name for name, _ in pictures], ["a", "b", "flip", "absolute"])
        (self.folder / "from_page.png").write_bytes(base64.b64decode(pictures[1][1]))
        self.assertEqual(png(self.folder / "from_page.png"), png(self.folder / "b.png"))
        self.assertNotEqual(png(self.folder / "a.png"), png(self.folder / "b.png"))

    def test_a_scene_beside_a_picture_is_drawn_as_large_as_that(self):
        self.assertEqual(self.run_program("render", "builtin:teapot", "-o", "old.png", "--resolution", "64,48", "--look", "default").code, 0)
        for pair in (("old.png", "builtin:teapot"), ("builtin:teapot", "old.png")):
            self.assertEqual(self.run_program("compare", *pair, "--max-error", "0").code, 0)
        self.assertEqual(self.run_program("compare", "old.png", "builtin:teapot", "--resolution", "64,49").code, 5)
        self.assertEqual(self.run_program("compare", "old.png", "builtin:sphere", "--max-flip", "0.01").code, 5)

    def test_two_scenes_are_drawn_and_compared(self):
        for name, color in (("one", "#ffffff"), ("two", "#ff0000")):
            self.write(f"{name}.scene.toml", f"[[primitive]]\ntype = 'sphere'\n[render]\nresolution = [64, 48]\ncolor = '{color}'\n")
        (row,) = self.rows("one.scene.toml", "two.scene.toml")
        self.assertFalse(row["equal"])
        (row,) = self.rows("one.scene.toml", "two.scene.toml", "--color", "#00ff00")
        self.assertTrue(row["equal"])
        self.write("wrong.scene.toml", "[[primitive]]\ntype = 'sphere'\n[render]\nlighting = 'no'\n")
        self.check_refused(self.run_program("compare", "one.scene.toml", "wrong.scene.toml"), 4, "wrong.scene.toml", "line 4")
        self.write("shadows.scene.toml", "[[primitive]]\ntype = 'sphere'\n[[light]]\ntype = 'point'\nposition = [0, 0, 2]\n"
                                         "[render]\nshadows = true\nshadow-size = 8192\n")  # found out while it is drawn
        for arguments in (("shadows.scene.toml", "one.scene.toml"), ("--engines", "soft,soft", "shadows.scene.toml")):
            run = self.run_program("compare", *arguments, "--max-memory", "50M")
            render = self.run_program("render", "shadows.scene.toml", "-o", "none.png", "--max-memory", "50M")
            self.assertEqual((run.code, run.err), (render.code, render.err))
            self.assertIn("line 8", run.err)
        self.run_program("render", "one.scene.toml", "-o", "one.png")
        (row,) = self.rows("one.scene.toml", "one.png", "--look", "plain")
        self.assertTrue(row["equal"])

    def test_one_model_in_several_formats_differs_by_its_material_alone(self):
        corners = {(x, y, z): (x * 200 + 10, y * 150 + 60, z * 220) for x in (0, 1) for y in (0, 1) for z in (0, 1)}
        numbers = {corner: i for i, corner in enumerate(corners)}
        faces = [[numbers[c] for c in face] for face in (((0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)), ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)),
                                                         ((0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)), ((0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)))]
        rows = ["%g %g %g %d %d %d" % (*place, *color) for place, color in corners.items()]
        self.write("box.obj", "".join(f"v {row}\n" for row in rows) + "".join("f %d %d %d %d\n" % tuple(k + 1 for k in f) for f in faces))
        self.write("box.ply", "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
                              "property uchar green\nproperty uchar blue\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n" +
                              "".join(f"{row}\n" for row in rows) + "".join("4 %d %d %d %d\n" % tuple(f) for f in faces))
        self.assertEqual(self.run_program("smooth", "box.obj", "-o", "box.glb").code, 0)
        size = ("--resolution", "96,64")
        (row,) = self.rows("box.obj", "box.ply", *size)
        self.assertTrue(row["equal"])
        for pair in (("box.obj", "box.glb"), ("box.glb", "box.ply")):
            (row,) = self.rows(*pair, *size)
            self.assertLess(row["flip"], 0.02)
            self.assertGreater(row["psnr_db"] or 99, 36)

    def test_two_scenes_have_one_camera(self):
        (row,) = self.rows("builtin:sphere:radius=1", "builtin:sphere:radius=2", "--resolution", SIZE)
        self.assertGreater(row["differing_share"], 0.2)  # each by a view of its own would look like the other
        self.assertEqual(self.rows("builtin:sphere:radius=2", "builtin:sphere:radius=1", "--resolution", SIZE)[0]["rmse"], row["rmse"])
        placed = ("--camera-position", "0,0,9", "--resolution", SIZE)
        self.run_program("render", "builtin:sphere:radius=2", "-o", "placed.png", *placed, "--look", "default")
        run = self.run_program("compare", "builtin:sphere:radius=1", "builtin:sphere:radius=2", *placed, "-o", "p.html")
        self.assertEqual(run.code, 0, run.err)
        pictures = re.findall(r'<img class="b"[^>]* src="data:image/png;base64,([^"]+)"', (self.folder / "p.html").read_text())
        (self.folder / "b.png").write_bytes(base64.b64decode(pictures[0]))
        self.assertEqual(png(self.folder / "b.png")[3], png(self.folder / "placed.png")[3])

    def test_a_scene_without_light_gets_that_of_the_other(self):
        sphere = "[[primitive]]\ntype = 'sphere'\n"
        self.write("lit.scene.toml", sphere + "[[light]]\ntype = 'point'\nposition = [2, 3, 4]\ndiffuse = [1, 0.2, 0.1]\n"
                                              "[[camera]]\nposition = [0, 2, 5]\ntarget = [0, 0, 0]\n")
        self.write("bare.scene.toml", sphere)
        for pair in (("lit.scene.toml", "bare.scene.toml"), ("bare.scene.toml", "lit.scene.toml"), ("lit.scene.toml", "builtin:sphere")):
            (row,) = self.rows(*pair, "--resolution", SIZE)
            self.assertTrue(row["equal"], pair)

    def test_scenes_have_the_default_look_as_render_gives_it(self):
        metal = pathlib.Path(__file__).resolve().parents[3] / "data/materials/layers.gltf"
        for model in (metal, "builtin:teapot"):
            size = ("--resolution", "96,64")
            self.assertEqual(self.run_program("render", model, "-o", "look.png", *size, "--look", "default").code, 0)
            (row,) = self.rows(model, "look.png", *size, "--look", "default")
            self.assertTrue(row["equal"])
            (row,) = self.rows(model, "look.png", *size, "--look", "plain")
            self.assertFalse(row["equal"])
            looks = [self.rows("--engines", "soft,trace", model, *size, "--look", look)[0]["flip"] for look in ("default", "plain")]
            self.assertEqual(*looks)

    def test_the_numbers_do_not_depend_on_the_threads(self):
        for name, options in (("a.png", ()), ("b.png", ("--shading", "flat"))):
            self.run_program("render", "builtin:teapot", "-o", name, "--resolution", "400,300", *options)
        one, four = (self.rows("a.png", "b.png", "--threads", n) for n in (1, 4))
        self.assertEqual(one, four)
        self.assertGreater(one[0]["flip"], 0)


if __name__ == "__main__":
    program.main()
