#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight render --channels`: which files, and what a reader of its own finds in them.

  channels_test.py PROGRAM [unittest arguments]"""
import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import exr
import program

ALL = ["depth", "normal", "object", "material", "mesh", "triangle", "face-normal", "tangent", "position", "barycentric", "uv", "uv1", "overdraw",
       "base-color", "ambient", "diffuse", "specular", "emission"]
SIZE = ("--resolution", "80,60")


class Channels(program.Case):
    def render(self, *options, code=0):
        result = self.run_program("render", "builtin:teapot", *SIZE, *options)
        self.assertEqual(result.code, code, result.err)
        return result

    def test_all_channels_are_layers_of_one_exr(self):
        result = self.render("-o", "a.exr", "--channels", "all", "--channel-files", "layers", "--json")
        self.assertEqual(self.files(), ["a.exr"])
        self.assertEqual(json.loads(result.out)["rows"][0]["channel_files"], [])
        width, height, c = exr.read(self.folder / "a.exr")
        self.assertEqual((width, height), (80, 60))
        self.assertEqual({name.split(".")[0] for name in c}, {"R", "G", "B"} | {name.replace("-", "_") for name in ALL})
        self.assertEqual({name for name, (kind, _) in c.items() if kind == "I"},
                         {"object.I", "material.I", "mesh.I", "triangle.I", "overdraw.I"})
        at = lambda name, x, y: c[name][1][y][x]
        seen = [(x, y) for y in range(60) for x in range(80) if at("object.I", x, y) != 0xFFFFFFFF]
        self.assertGreater(len(seen), 800)
        for x, y in seen:
            for color in "RGB":  # the light's terms are the color
                terms = sum(at(f"{term}.{color}", x, y) for term in ("ambient", "diffuse", "specular", "emission"))
                self.assertAlmostEqual(terms, at(color, x, y), delta=2e-6)
            self.assertAlmostEqual(sum(at(f"barycentric.{k}", x, y) for k in "XYZ"), 1, delta=1e-6)
            for layer in ("normal", "face_normal"):
                self.assertAlmostEqual(math.hypot(*(at(f"{layer}.{k}", x, y) for k in "XYZ")), 1, delta=1e-5)
            self.assertIn(at("tangent.W", x, y), (-1, 1))
            self.assertGreaterEqual(at("overdraw.I", x, y), 1)
            self.assertTrue(0 < at("depth.Z", x, y) < math.inf)
        self.assertEqual((at("depth.Z", 0, 0), at("triangle.I", 0, 0), at("overdraw.I", 0, 0), at("position.X", 0, 0)), (math.inf, 0xFFFFFFFF, 0, 0))

    def test_the_layers_are_the_numbers_of_the_files_apart(self):
        self.render("-o", "a.png", "--channels", "depth,position,uv,tangent,object,overdraw", "--channel-files", "exr,layers")
        self.assertEqual(self.files(), ["a.channels.exr", "a.depth.exr", "a.object.exr", "a.overdraw.exr", "a.png", "a.position.exr", "a.tangent.exr", "a.uv.exr"])
        layers = exr.read(self.folder / "a.channels.exr")[2]
        for layer, parts, own in (("depth", "Z", "Y"), ("position", "XYZ", "RGB"), ("uv", "UV", "RG"), ("tangent", "XYZW", "RGBA")):
            alone = exr.read(self.folder / f"a.{layer}.exr")[2]
            for part, name in zip(parts, own, strict=True):
                self.assertEqual(alone[name], layers[f"{layer}.{part}"])
        alone = exr.read(self.folder / "a.object.exr")[2]["Y"]
        self.assertEqual(alone[1], [tuple(-1 if n == 0xFFFFFFFF else n for n in row) for row in layers["object.I"][1]])

    def test_half_is_for_colors_alone(self):
        self.render("-o", "a.exr", "--channels", "depth,base-color", "--channel-files", "layers", "--exr-colors", "half")
        c = exr.read(self.folder / "a.exr")[2]
        self.assertEqual({name: kind for name, (kind, _) in c.items()},
                         {"R": "e", "G": "e", "B": "e", "base_color.R": "e", "base_color.G": "e", "base_color.B": "e", "depth.Z": "f"})

    def test_pictures_for_the_eye_say_their_range(self):
        result = self.render("-o", "a.png", "--channels", "depth,position,triangle", "--channel-files", "png", "--json")
        row = json.loads(result.out)["rows"][0]
        self.assertEqual(row["channel_files"], ["a.depth.png", "a.triangle.png", "a.position.png"])
        low, high = row["view_range"]["depth_m"]
        self.assertTrue(0 < low < high)
        self.assertTrue(any("depth from" in r["message"] for r in row["remarks"]))
        _, _, _, rows = program.png(self.folder / "a.depth.png")
        values = {row[i] for row in rows for i in range(0, len(row), 3)}
        self.assertTrue(min(values - {0}) >= 32 and 0 in values)
        _, _, _, rows = program.png(self.folder / "a.triangle.png")
        self.assertGreater(len({bytes(row[i:i + 3]) for row in rows for i in range(0, len(row), 3)}), 100)

    def test_a_window_has_the_same_numbers(self):
        self.render("-o", "a.exr", "--channels", "all", "--channel-files", "layers")
        self.render("-o", "b.exr", "--channels", "all", "--channel-files", "layers", "--window", "13,7,50,40")
        whole, part = exr.read(self.folder / "a.exr")[2], exr.read(self.folder / "b.exr")[2]
        for name, (kind, rows) in part.items():
            self.assertEqual((kind, rows), (whole[name][0], [row[13:63] for row in whole[name][1][7:47]]), name)

    def test_exr_files_of_a_window_know_their_place_in_the_picture(self):
        self.render("-o", "a.exr")
        whole = exr.windows(self.folder / "a.exr")
        self.assertEqual(whole[0], whole[1])
        self.render("-o", "b.exr", "--channels", "depth,triangle", "--channel-files", "exr,layers", "--window", "13,7,50,40")
        self.render("-o", "c.png", "--channels", "depth", "--channel-files", "layers", "--window", "13,7,50,40")
        for name in ("b.exr", "b.depth.exr", "b.triangle.exr", "c.channels.exr"):
            self.assertEqual(exr.windows(self.folder / name), ((13, 7, 62, 46), whole[1]), name)
        self.render("-o", "d.png", "--texture-base-color", "b.exr", "--uv", "box")  # and they are read as pictures of their own size

    def test_wrong_words_are_refused_with_the_right_ones(self):
        for options, words in ((("--channels", "depth,smell"), ("smell", "face-normal")), (("--channels", ""), ("empty",)),
                               (("--channels", "depth", "--channel-files", "tiff"), ("tiff", "layers")),
                               (("--channel-files", "png"), ("--channels",)), (("--exr-colors", "quarter"), ("half",)),
                               (("--exr-colors", "half"), ("none is written", ".exr")),
                               (("--exr-colors", "half", "--channels", "depth", "--channel-files", "png"), ("none is written",))):
            result = self.run_program("render", "builtin:teapot", "-o", "a.png", *options)
            self.assertEqual((result.code, len(result.lines)), (2, 1), result.err)
            for word in words:
                self.assertIn(word, result.err)
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    program.main()
