#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight bake`: maps and models that it writes, and what it refuses.

  bake_test.py PROGRAM [unittest arguments]"""
import json
import math
import pathlib
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import exr
import program

HEAD = pathlib.Path(__file__).resolve().parents[3] / "data/head/head.obj"
HIGH, LOW = "builtin:sphere:tolerance=0.0005", "builtin:sphere:tolerance=0.03"


def gltf_of(path):
    data = pathlib.Path(path).read_bytes()
    return json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])


def bent_square(n):
    """z = 0.05 sin(2 pi x) sin(2 pi y) over the square, as OBJ."""
    places = [(2 * i / n - 1, 2 * j / n - 1) for j in range(n + 1) for i in range(n + 1)]
    yield from (f"v {x} {y} {0.05 * math.sin(math.tau * x) * math.sin(math.tau * y)}\n" for x, y in places)
    yield from (f"f {v} {v + 1} {v + n + 2} {v + n + 1}\n" for j in range(n) for v in range(j * (n + 1) + 1, j * (n + 1) + n + 1))


class Bake(program.Case):
    def setUp(self):
        super().setUp()
        self.write("square.obj")
        if "follows no rays" in self.run_program("bake", "square.obj", "square.obj", "-o", "a.png", "--size", "4").err:
            self.skipTest("this build follows no rays")

    def bake(self, *words):
        result = self.run_program("bake", *words)
        self.assertEqual(result.code, 0, result.err)
        return result

    def row(self, *words):
        return json.loads(self.bake(*words, "--json").out)["rows"][0]

    def test_maps_go_to_files_by_their_names(self):
        row = self.row(HIGH, LOW, "-o", "maps/{map}.png", "--maps", "normal,height,curvature,occlusion", "--size", "64,32", "--rays", "4", "--bits", "8")
        self.assertEqual(sorted(p.name for p in (self.folder / "maps").iterdir()), ["curvature.png", "height.png", "normal.png", "occlusion.png"])
        self.assertEqual(row["maps"]["height"], "maps/height.png")
        self.assertEqual((row["width"], row["height"], row["missed"]), (64, 32, 0))
        self.assertTrue(row["distance_is_proposed"])
        width, height, channels, rows = program.png(self.folder / "maps/normal.png")
        self.assertEqual((width, height, channels), (64, 32, 3))
        for y in range(8, 24):  # away from the poles: a sphere on a sphere, nearly even
            for x in range(64):
                for code, even, most in zip(rows[y][3 * x:3 * x + 3], (128, 128, 255), (8, 8, 2)):
                    self.assertLessEqual(abs(code - even), most, (x, y))
        self.assertEqual(program.png(self.folder / "maps/occlusion.png")[2], 1)
        self.assertGreater(min(min(row) for row in program.png(self.folder / "maps/occlusion.png")[3]), 250)

    def test_a_tilted_square_has_the_normal_and_the_height_that_it_has(self):
        self.write("high.obj", "v -1 -1 0.05\nv 1 -1 0.15\nv 1 1 0.15\nv -1 1 0.05\nf 1 2 3 4\n")
        self.write("low.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n")
        for green, code in (("up", 128), ("down", 128)):
            self.bake("high.obj", "low.obj", "-o", "n.png", "--size", "8", "--green", green)
            self.assertEqual(tuple(program.png(self.folder / "n.png")[3][3][:3]), (121, code, 255))  # (-0.05, 0, 1), unit
        self.write("high.obj", "v -1 -1 0.05\nv 1 -1 0.05\nv 1 1 0.15\nv -1 1 0.15\nf 1 2 3 4\n")
        for green, code in (("up", 121), ("down", 134)):
            self.bake("high.obj", "low.obj", "-o", "n.png", "--size", "8", "--green", green)
            self.assertEqual(tuple(program.png(self.folder / "n.png")[3][3][:3]), (128, code, 255))
        self.bake("high.obj", "low.obj", "-o", "{map}.exr", "--maps", "height", "--size", "8", "--distance", "0.5")
        (_, rows), = exr.read(self.folder / "height.exr")[2].values()
        self.assertAlmostEqual(rows[0][0], 0.1 + 0.05 * 7 / 8, 6)  # meters; the top of the map is the top of the square

    def test_the_model_has_coordinates_tangents_and_the_map(self):
        self.write("low.obj", program.TWO_PARTS)
        row = self.row("low.obj", "low.obj", "-o", "n.png", "--size", "64", "--model", "baked.glb")
        self.assertEqual(row["meshes_with_made_coordinates"], 2)
        self.assertGreater(row["texels_per_meter"], 10)
        gltf = gltf_of(self.folder / "baked.glb")
        for mesh in gltf["meshes"]:
            self.assertLessEqual({"POSITION", "NORMAL", "TANGENT", "TEXCOORD_0"}, set(mesh["primitives"][0]["attributes"]))
            self.assertIn("normalTexture", gltf["materials"][mesh["primitives"][0]["material"]])
        self.assertEqual(self.run_program("render", "baked.glb", "-o", "a.png", "--resolution", "32,32").code, 0)

    def test_a_flat_model_with_its_map_looks_like_the_bent_one(self):
        self.write("high.obj", "".join(bent_square(60)))
        self.bake("high.obj", "square.obj", "-o", "n.png", "--size", "512", "--model", "baked.glb")
        for name, model in (("high", "high.obj"), ("low", "square.obj"), ("baked", "baked.glb")):
            self.assertEqual(self.run_program("render", model, "-o", name + ".png", "--resolution", "160,160", "--view", "front", "--camera-orthographic", "--color", "0.8,0.8,0.8",
                                              "--lighting", "lambert", "--light", "directional:-1,-0.5,-1").code, 0)
        psnr = {name: json.loads(self.run_program("compare", "high.png", name + ".png", "--json").out)["rows"][0]["psnr_db"] for name in ("low", "baked")}
        self.assertLess(psnr["low"], 30)
        self.assertGreater(psnr["baked"], 50)

    def test_two_runs_write_the_same_bytes_for_any_number_of_threads(self):
        files = []
        for threads in ("1", "3"):
            self.bake("builtin:teapot", "builtin:teapot", "-o", "n.png", "--size", "128", "--make-coordinates", "--chart-margin", "1", "-j", threads, "--model", "m.glb")
            files.append([(self.folder / name).read_bytes() for name in ("n.png", "m.glb")])
        self.assertEqual(*files)

    def test_object_space_is_not_in_the_model(self):
        result = self.bake(HIGH, LOW, "-o", "n.png", "--size", "32", "--space", "object", "--model", "m.glb")
        self.assertIn("only tangent-space normal maps", result.err)
        self.assertNotIn("textures", gltf_of(self.folder / "m.glb"))
        self.assertGreater(len({bytes(row[3 * x:3 * x + 3]) for row in program.png(self.folder / "n.png")[3] for x in range(32)}), 400)

    def test_what_cannot_be_baked_is_one_line(self):
        self.write("far.obj", "v 100 0 0\nv 101 0 0\nv 101 1 0\nf 1 2 3\n")
        self.write("points.obj", "v 0 0 0\nv 1 0 0\np 1 2\n")
        output = ("-o", "n.png")
        cases = (
            (("square.obj", "square.obj"), 2, "output"),
            (("square.obj", *output), 2, "LOW"),
            (("square.obj", "none.obj", *output), 3, "none.obj"),
            (("far.obj", "square.obj", *output, "--size", "32"), 4, "no ray from it meets", "far.obj", "--distance"),
            (("square.obj", "points.obj", *output), 4, "no triangles"),
            (("points.obj", "square.obj", *output, "--size", "32"), 4, "no triangles"),
            ((HIGH, HEAD, *output, "--make-coordinates", "--size", "16"), 2, "--size", "no room", "charts"),
            (("square.obj", "square.obj", "-o", "n.jpg"), 2, "n.jpg", ".png"),
            (("square.obj", "square.obj", *output, "--maps", "normal,height"), 2, "{map}"),
            (("square.obj", "square.obj", "-o", "{foo}.png"), 2, "{map}"),
            (("square.obj", "square.obj", *output, "--maps", "normals"), 2, "did you mean 'normal'?"),
            (("square.obj", "square.obj", "-o", "{map}.png", "--maps", "normal,normal"), 2, "--maps", "twice"),
            (("square.obj", "square.obj", *output, "--distance", "0"), 2, "--distance", "more than 0"),
            (("square.obj", "square.obj", *output, "--distance", "-1"), 2, "--distance"),
            (("square.obj", "square.obj", *output, "--distance", "nan"), 2, "--distance"),
            (("square.obj", "square.obj", *output, "--size", "0"), 2, "--size"),
            (("square.obj", "square.obj", *output, "--size", "16385"), 2, "--size", "16384"),
            (("square.obj", "square.obj", *output, "--size", "16384", "--max-memory", "64M"), 4, "baked maps", "64"),
            (("square.obj", "square.obj", *output, "--samples", "2"), 2, "--samples", "1, 4 or 16"),
            (("square.obj", "square.obj", *output, "--rays", "5000"), 2, "--rays"),
            (("square.obj", "square.obj", *output, "--bits", "12"), 2, "--bits"),
            (("square.obj", "square.obj", *output, "--space", "objct"), 2, "--space", "did you mean 'object'?"),
            (("square.obj", "square.obj", *output, "--distnce", "1"), 2, "did you mean --distance?"),
            (("square.obj", "square.obj", *output, "--model", "m.obj"), 2, "--model", ".glb"),
            (("square.obj", "square.obj", "-o", "square.obj/n.png"), 1, "not a folder"),
        )
        before = self.files()
        for words, code, *said in cases:
            with self.subTest(words=words):
                self.check_refused(self.run_program("bake", *words), code, *said)
        self.assertEqual(self.files(), before)


if __name__ == "__main__":
    program.main()
