#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs `rakelight explain`: its sum is the pixel that `rakelight render` draws.

  explain_test.py PROGRAM [unittest arguments]"""
import json
import pathlib
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from models import TRIANGLE, triangle_gltf, write_glb, write_quarters
from program import png

SIZE = (96, 64)
# A wall, a pane of glass before it, and a wall behind it.
SCENE = ("mtllib m.mtl\no back\nv -2 -2 -1\nv 2 -2 -1\nv 2 2 -1\nv -2 2 -1\nusemtl red\nf 1 2 3 4\n"
         "o front\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nusemtl gray\nf 5 6 7 8\n"
         "o pane\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nusemtl glass\nf 9 10 11 12\n")
MATERIALS = "newmtl red\nKd 1 0 0\nnewmtl gray\nKd 0.5 0.5 0.5\nKs 0.3 0.3 0.3\nNs 20\nnewmtl glass\nKd 0.2 0.4 1\nd 0.3\n"


def single(value):
    return struct.unpack("<f", struct.pack("<f", value))[0]


class Explain(program.Case):
    def setUp(self):
        super().setUp()
        (self.folder / "scene.obj").write_text(SCENE)
        (self.folder / "m.mtl").write_text(MATERIALS)

    def explain(self, model, x, y, *options, **environment):
        run = self.run_program("explain", model, "--pixel", f"{x},{y}", "--resolution", "%d,%d" % SIZE, "--json", *options, **environment)
        self.assertEqual(run.code, 0, run.err)
        document = json.loads(run.out)
        self.assertEqual(document["schema"], "rakelight.explain/1")
        return document["rows"][0]

    def test_codes_are_those_of_the_rendered_picture(self):
        for model in ("scene.obj", "builtin:teapot"):
            for options in ((), ("--lighting", "phong", "--specular", "normalized"), ("--shading", "unlit"),
                            ("--shading", "flat"), ("--shading", "gouraud")):
                picture = self.folder / "picture.png"
                run = self.run_program("render", model, "-o", picture, "--resolution", "%d,%d" % SIZE, *options)
                self.assertEqual(run.code, 0, run.err)
                for x, y in ((0, 0), (48, 32), (30, 40), (60, 25), (95, 63)):
                    row = self.explain(model, x, y, *options)
                    self.assertEqual(row["codes"], list(png(picture)[3][y][3 * x:3 * x + 3]), (model, options, x, y))
                    self.assertEqual(row["sum"], row["color"])

    def test_the_default_look_comes_to_the_rendered_pixel_and_is_listed(self):
        for model, topics in (("builtin:teapot", ["samples", "background"]), (self.metal(), ["samples", "light", "shadows", "background"]),
                              (self.metal(light=50000), ["samples", "light", "background", "exposure"])):
            run = self.run_program("render", model, "-o", "picture.png", "--resolution", "%d,%d" % SIZE, "--look", "default")
            self.assertEqual(run.code, 0, run.err)
            for x, y in ((0, 0), (48, 32), (40, 40), (95, 63)):
                row = self.explain(model, x, y, "--look", "default")
                self.assertEqual(row["codes"], list(png(self.folder / "picture.png")[3][y][3 * x:3 * x + 3]), (model, x, y))
                self.assertEqual(row["sum"], row["color"])
                self.assertEqual([choice["topic"] for choice in row["look"]], topics)
        self.assertEqual(self.explain("builtin:teapot", 48, 32)["look"], [])
        row = self.explain(self.metal(), 40, 40, "--look", "default")
        self.assertEqual(row["layers"][0]["lights"][0]["name"], "studio key")
        self.assertIn("environment", row["layers"][0])
        exposed = self.run_program("explain", self.metal(light=50000), "--pixel", "40,40", "--resolution", "%d,%d" % SIZE, "--look", "default").out
        for word in ("the default look", "built-in studio as environment", "x 2^exposure", "= color of the surface"):
            self.assertIn(word, exposed)

    def metal(self, light=None):
        nodes, extra = [{"mesh": 0}], {"materials": [{"pbrMetallicRoughness": {"metallicFactor": 1, "roughnessFactor": 0.4}}]}
        if light:
            nodes.append({"extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [0, 0, 2]})
            extra.update(extensionsUsed=["KHR_lights_punctual"],
                         extensions={"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": light}]}})
        tree = triangle_gltf(nodes, **extra)
        tree["meshes"][0]["primitives"][0]["material"] = 0
        name = self.folder / ("lit.glb" if light else "metal.glb")
        write_glb(name, tree, TRIANGLE)
        return name

    def test_overlays_are_said_to_be_left_out(self):
        for verb, *words in (("explain", "--pixel", "3,3"), ("stages", "-o", "page.html", "--single-file")):
            run = self.run_program(verb, "scene.obj", *words, "--resolution", "%d,%d" % SIZE, "--grid")
            self.assertEqual(run.code, 0)
            self.assertIn("left out", run.err)
            self.assertNotIn("left out", self.run_program(verb, "scene.obj", *words, "--resolution", "%d,%d" % SIZE).err)

    def test_several_pixels_are_rows_of_their_own(self):
        words = ("explain", "scene.obj", "builtin:teapot", "--pixel", "48,32", "--pixel", "0,0", "--resolution", "%d,%d" % SIZE)
        rows = json.loads(self.run_program(*words, "--json").out)["rows"]
        self.assertEqual([(row["file"], row["pixel"]) for row in rows],
                         [(name, pixel) for name in ("scene.obj", "builtin:teapot") for pixel in ([48, 32], [0, 0])])
        for row in rows:
            alone = self.explain(row["file"], *row["pixel"])
            self.assertEqual({**alone, "remarks": []}, {**row, "remarks": []})
        text = self.run_program(*words).out
        self.assertEqual(text.count("of 96 x 64"), 4)

    def test_a_file_takes_text_or_json(self):
        words = ("explain", "scene.obj", "--pixel", "48,32", "--resolution", "%d,%d" % SIZE)
        for options, name, made in ((("-o", "a.txt"), "a.txt", self.run_program(*words).out), (("-o", "a.json"), "a.json", self.run_program(*words, "--json").out),
                                    (("-o", "b.txt", "--json"), "b.txt", self.run_program(*words, "--json").out)):
            run = self.run_program(*words, *options)
            self.assertEqual((run.code, run.out, run.err), (0, "", ""))
            self.assertEqual((self.folder / name).read_text(), made)
        self.assertEqual(self.run_program(*words, "-o", "made/a.txt").code, 0)
        self.assertTrue((self.folder / "made/a.txt").read_text().startswith("scene.obj: pixel 48,32"))

    def test_the_object_under_the_pixel_is_named(self):
        row = self.explain("scene.obj", 48, 32, "--view", "front")
        self.assertEqual((row["shows"]["object"], row["shows"]["material_name"]), ("pane", "glass"))
        text = self.run_program("explain", "scene.obj", "--pixel", "48,32", "--resolution", "%d,%d" % SIZE, "--view", "front").out
        self.assertIn("  shows object 'pane', mesh ", text)

    def test_a_background_pixel_names_the_nearest_that_shows_something(self):
        for options in ((), ("--samples", "4")):
            row = self.explain("scene.obj", 0, 32, "--view", "front", *options)
            self.assertEqual((row["shows"], row["is_background"]), (None, True))
            near = row["nearest"]
            self.assertEqual((near["object"], near["pixel"][1]), ("back", 32))
            x = near["pixel"][0]
            self.assertEqual(self.explain("scene.obj", x, 32, "--view", "front", *options)["shows"]["object"], "back")
            self.assertTrue(self.explain("scene.obj", x - 1, 32, "--view", "front", *options)["is_background"])
        text = self.run_program("explain", "scene.obj", "--pixel", "0,32", "--resolution", "%d,%d" % SIZE, "--view", "front").out
        self.assertRegex(text, r"background: no triangle covers it; the nearest pixel that shows something is \d+,32: object 'back'")

    def test_a_point_is_named_where_it_shows(self):
        (self.folder / "scan.xyz").write_text("0 0 0 255 0 0\n1 0 0 0 255 0\n")
        for options in ((), ("--samples", "4")):
            row = self.explain("scan.xyz", 48, 32, "--camera-focal-point", "0,0,0", "--camera-position", "0,0,5", *options)
            self.assertEqual((row["shows"]["kind"], row["shows"]["mesh"], row["is_background"]), ("point", 0, False))
            row = self.explain("scan.xyz", 5, 5, "--camera-focal-point", "0,0,0", "--camera-position", "0,0,5", *options)
            self.assertIsNone(row["shows"])

    def test_exposure_and_tone_curve_are_said_where_they_act(self):
        options = ("--tone-mapping", "reinhard", "--exposure", "1")
        plain, curved = self.explain("builtin:teapot", 48, 32), self.explain("builtin:teapot", 48, 32, *options)
        self.assertEqual(plain["displayed"], plain["color"])
        self.assertEqual(curved["color"], plain["color"])
        luminance = sum(2 * w * c for w, c in zip((0.2126, 0.7152, 0.0722), plain["color"]))
        for light, shown in zip(plain["color"], curved["displayed"][:3]):
            self.assertAlmostEqual(shown, 2 * light / (1 + luminance), 6)
        words = [self.run_program("explain", "builtin:teapot", "--pixel", "48,32", "--resolution", "%d,%d" % SIZE, *o).out for o in ((), options)]
        self.assertEqual(["displayed" in text for text in words], [False, True])

    def test_a_normal_map_is_listed_where_it_acts(self):
        bricks = pathlib.Path(__file__).resolve().parents[3] / "data/bricks/normal.png"
        for options, acts in (((), True), (("--bump", "none"), False), (("--shading", "flat"), False), (("--shading", "gouraud"), False)):
            layer = self.explain("builtin:teapot", 48, 32, "--texture-normal", bricks, "--texture-base-color", bricks, *options)["layers"][0]
            self.assertEqual([m["role"] for m in layer["maps"]], ["base_color"] + ["normal"] * acts, options)

    def test_samples_and_probes_come_to_the_rendered_pixel(self):
        floor = pathlib.Path(__file__).resolve().parents[3] / "data/visibility/floor.obj"
        painted = ("--texture-base-color", floor.parents[1] / "bricks/normal.png", "--camera-position", "0,0.3,3.3",
                   "--camera-focal-point", "0,0,0", "--camera-view-angle", "16")
        for model, view, x, y in (("builtin:teapot", (), 41, 24), ("scene.obj", ("--view", "front"), 35, 30), (floor, painted, 48, 30)):
            for options in (("--samples", "4"), ("--samples", "8"), ("--samples", "4", "--anisotropy", "16")):
                picture = self.folder / "picture.png"
                run = self.run_program("render", model, "-o", picture, "--resolution", "%d,%d" % SIZE, *view, *options)
                self.assertEqual(run.code, 0, run.err)
                row = self.explain(model, x, y, *view, *options)
                self.assertEqual(row["codes"], list(png(picture)[3][y][3 * x:3 * x + 3]), (model, options))
                self.assertEqual(row["sum"], row["color"])
                self.assertEqual(len(row["samples"]), int(options[1]))
                for c in range(3):
                    mean = sum(sample["color"][c] for sample in row["samples"]) / len(row["samples"])
                    self.assertEqual(single(mean), row["color"][c])
                shown = [sample for layer in row["layers"] if not layer["blended"] for sample in layer["samples"]]
                self.assertEqual(len(shown), sum(sample["triangle"] is not None for sample in row["samples"]))
                probes = [m["probes"] for layer in row["layers"] for m in layer["maps"]]
                self.assertEqual(max(probes, default=1) > 2, model == floor and len(options) > 2, probes)
        text = self.run_program("explain", floor, "--pixel", "48,30", "--resolution", "96,64", *painted, *options).out
        for word in ("the mean of its samples", "VVVV", "Probes of the anisotropic filter", "shaded once for samples 0 1 2 3"):
            self.assertIn(word, text)

    def test_the_terms_add_up_to_the_color_in_single_precision(self):
        row = self.explain("builtin:teapot", 48, 32)
        layer = row["layers"][0]
        for c in range(3):
            total = layer["emission"][c]
            for light in layer["lights"]:
                terms = single(single(light["ambient"][c] + light["diffuse"][c]) + light["specular"][c])
                total = single(total + terms)
                self.assertEqual(total, light["sum"][c])
            self.assertEqual(total, layer["color"][c])
            self.assertEqual(total, row["color"][c])

    def test_light_of_the_corners_is_interpolated_and_reflected_at_the_pixel(self):
        for shading, where, count in (("flat", "face", 1), ("gouraud", "vertices", 3)):
            layer = self.explain("builtin:teapot", 48, 32, "--shading", shading)["layers"][0]
            self.assertEqual((layer["lit_at"], len(layer["corners"]), layer["lights"]), (where, count, []))
            weights = [1] if count == 1 else layer["barycentric"]
            for c in range(3):
                total = layer["emission"][c]
                for term, k in (("ambient", "k_ambient"), ("diffuse", "k_diffuse"), ("specular", "k_specular")):
                    between = sum(w * corner[term][c] for w, corner in zip(weights, layer["corners"]))
                    self.assertAlmostEqual(between, layer["received"][term][c], 6)
                    for corner in layer["corners"]:
                        self.assertAlmostEqual(sum(light[term][c] for light in corner["lights"]), corner[term][c], 6)
                    total += layer["surface"][k][c] * layer["received"][term][c]
                self.assertAlmostEqual(total, layer["color"][c], 6)
            text = self.run_program("explain", "builtin:teapot", "--pixel", "48,32", "--resolution", "96,64", "--shading", shading).out
            for word in ("Lit once for the face" if count == 1 else "Lit at vertex", "diffuse of all", "+ k diffuse times it"):
                self.assertIn(word, text)

    def test_texels_are_those_of_the_picture(self):
        head = pathlib.Path(__file__).resolve().parents[3] / "data/head/head.obj"
        row = self.explain(head, 48, 32)
        for picture in row["layers"][0]["maps"]:
            self.assertAlmostEqual(sum(texel["weight"] for texel in picture["texels"]), 1, 5)
            for c in range(4):
                self.assertAlmostEqual(sum(texel["weight"] * texel["value"][c] for texel in picture["texels"]), picture["value"][c], 3)
        (self.folder / "texel.mtl").write_text("newmtl m\nKd 1 1 1\nmap_Kd quarters.png\n")
        (self.folder / "texel.obj").write_text("mtllib texel.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n")
        write_quarters(self.folder / "quarters.png", 2)
        texels = self.explain("texel.obj", 48, 32, "--view", "front")["layers"][0]["maps"][0]["texels"]
        found = {(t["x"], t["y"]): [round(v, 4) for v in t["value"]] for t in texels}
        self.assertEqual(found, {(0, 0): [1, 0, 0, 1], (1, 0): [0, 1, 0, 1], (0, 1): [0, 0, 1, 1], (1, 1): [1, 1, 1, 1]})
        self.assertEqual({t["level"] for t in texels}, {0})
        text = self.run_program("explain", "texel.obj", "--pixel", "48,32", "--resolution", "96,64", "--view", "front").out
        self.assertIn("Source texels", text)

    def test_every_instruction_set_says_the_same(self):
        rows = []
        for isa in ("scalar", "sse2", "avx2", "avx512"):
            run = self.run_program("explain", "scene.obj", "--pixel", "40,30", "--resolution", "96,64", "--json", RAKELIGHT_ISA=isa)
            if run.code == 0:
                rows.append(run.out)
        self.assertGreater(len(rows), 1)
        self.assertEqual(len(set(rows)), 1)

    def test_what_is_behind_is_listed_and_layers_are_laid_over(self):
        row = self.explain("scene.obj", 48, 32, "--view", "front")
        self.assertEqual([(t["object"], t["fate"]) for t in row["triangles"]],
                         [("pane", "blended"), ("front", "visible"), ("back", "hidden")])
        self.assertEqual([layer["blended"] for layer in row["layers"]], [False, True])
        distances = [t["distance"] for t in row["triangles"]]
        self.assertEqual(distances, sorted(distances))

    def test_background_is_said(self):
        row = self.explain("builtin:teapot", 0, 0)
        self.assertTrue(row["is_background"])
        self.assertEqual(row["triangles"], [])
        run = self.run_program("explain", "builtin:teapot", "--pixel", "0,0")
        self.assertIn("background: no triangle covers it", run.out)

    def test_text_has_every_part(self):
        run = self.run_program("explain", "builtin:teapot", "--pixel", "640,360")
        self.assertEqual((run.code, run.err), (0, ""))
        for word in ("barycentrics", "normal, interpolated", "n.l", "n.h", "light 1 specular", "= color of the surface", "sRGB code"):
            self.assertIn(word, run.out)

    def test_wrong_pixels_are_usage_errors(self):
        for pixel in ("96,0", "0,64", "-1,0", "0,-1", "1", "1,2,3", "a,b", "", "1.5,2", "99999999999,0"):
            run = self.run_program("explain", "builtin:teapot", f"--pixel={pixel}", "--resolution", "96,64")
            self.assertEqual(run.code, 2, (pixel, run.err))
            self.assertEqual(len(run.err.splitlines()), 1, run.err)
        self.assertEqual(self.run_program("explain", "builtin:teapot").code, 2)
        self.assertEqual(self.run_program("explain", "builtin:teapot", "--pixel", "1,1", "-o", "a.png").code, 2)

    def test_a_missing_model_is_an_error_row(self):
        run = self.run_program("explain", "none.obj", "builtin:teapot", "--pixel", "1,1", "--json")
        rows = json.loads(run.out)["rows"]
        self.assertEqual(run.code, 3)
        self.assertEqual([("error" in row) for row in rows], [True, False])


if __name__ == "__main__":
    program.main()
