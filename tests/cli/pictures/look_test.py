#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The default look: what is chosen where nobody names it, and what is left alone (docs/default-look.md).

  look_test.py PROGRAM [unittest arguments]"""
import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from models import TRIANGLE, triangle_gltf, write_glb

DARK, LIGHT = (48, 50, 54), (217, 218, 219)
METAL = {"pbrMetallicRoughness": {"baseColorFactor": [0.9, 0.6, 0.3, 1], "metallicFactor": 1, "roughnessFactor": 0.3}}


class Looks(program.Case):
    def render(self, model, *options, look="default"):
        """(picture, notes)"""
        result = self.run_program("render", model, "-o", "a.png", "--resolution", "64,48", "--json", "--look", look, *options)
        self.assertEqual(result.code, 0, result.err)
        notes = " ".join(entry["message"] for entry in json.loads(result.out)["rows"][0]["remarks"])
        return program.png(self.folder / "a.png")[3], notes

    def corner(self, picture):
        return tuple(picture[0][:3])

    def model(self, material=METAL, camera=None, light=None):
        nodes = [{"mesh": 0}]
        extra = {"materials": [material]}
        if camera:
            nodes.append({"camera": 0, "translation": camera})
            extra["cameras"] = [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.01, "zfar": 100}}]
        if light:
            nodes.append({"extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [0, 0, 2]})
            extra["extensionsUsed"] = ["KHR_lights_punctual"]
            extra["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": light}]}}
        tree = triangle_gltf(nodes, **extra)
        tree["meshes"][0]["primitives"][0]["material"] = 0
        write_glb(self.folder / "m.glb", tree, TRIANGLE)
        return "m.glb"

    def test_classical_models_get_samples_and_a_background(self):
        standard, _ = self.render("builtin:teapot")
        self.assertEqual(self.corner(standard), DARK)
        background = ("--background", "0.19,0.195,0.21")
        self.assertEqual(standard, self.render("builtin:teapot", "--samples", "4", *background, look="plain")[0])
        self.assertEqual(self.render("builtin:teapot", "--samples", "1")[0], self.render("builtin:teapot", *background, look="plain")[0])
        self.assertEqual(self.corner(self.render("builtin:teapot", "--background", "#102030")[0]), (16, 32, 48))

    def test_metals_get_the_studio_unless_the_light_is_named(self):
        model = self.model()
        standard, _ = self.render(model)
        studio = ("--light", "studio", "--shadows", "on", "--shadow-filter", "2", "--samples", "4")
        background = ("--background", "0.19,0.195,0.21") if self.corner(standard) == DARK else ("--background", "0.85,0.855,0.86")
        self.assertEqual(standard, self.render(model, *studio, *background, look="plain")[0])
        for named in (("--light", "default"), ("--lighting", "phong"), ("--hdri-ambient",)):
            with self.subTest(named=named):
                both = (*named, "--background", "#000000", "--samples", "1")
                self.assertEqual(self.render(model, *both)[0], self.render(model, *both, look="plain")[0])

    def test_a_dark_model_stands_before_a_light_background(self):
        dark = {"pbrMetallicRoughness": {"baseColorFactor": [0.2, 0.2, 0.2, 1], "metallicFactor": 0}, "extensions": {"KHR_materials_unlit": {}}}
        self.assertEqual(self.corner(self.render(self.model({**dark, "pbrMetallicRoughness": {"baseColorFactor": [0.03, 0.03, 0.03, 1]}}))[0]), LIGHT)
        self.assertEqual(self.corner(self.render(self.model({**dark, "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.8, 0.8, 1]}}))[0]), DARK)

    def test_the_files_camera_counts_where_it_shows_the_model(self):
        far = self.model(camera=[0.3, 0.3, 5])
        picture, notes = self.render(far, "--background", "#000000")
        self.assertIn("the file's camera is used: it shows 100 % of the model", notes)
        self.assertEqual(picture, self.render(far, "--background", "#000000", "--view", "file")[0])
        near = self.model(camera=[0.5, 0.5, 0.4])
        picture, notes = self.render(near, "--background", "#000000")
        self.assertIn("the fitted view is used; 'view' file uses the file's camera", notes)
        self.assertEqual(picture, self.render(near, "--background", "#000000", "--view", "default")[0])
        self.check_refused(self.run_program("render", self.model(), "-o", "b.png", "--view", "file"), 2, "the file has no camera")

    def test_lights_in_physical_units_are_exposed(self):
        bright = self.model(light=50000)
        picture, notes = self.render(bright)
        self.assertIn("ask for an exposure of -", notes)
        self.assertLess(sum(max(row[3 * x:3 * x + 3]) == 255 for row in picture for x in range(64)), 0.1 * 64 * 48)
        burnt, _ = self.render(bright, "--exposure", "0")
        self.assertGreater(sum(max(row[3 * x:3 * x + 3]) == 255 for row in burnt for x in range(64)), 0.2 * 64 * 48)

    def bare(self, model, *options):
        """The picture without any --look."""
        done = subprocess.run([program.PROGRAM, "render", model, "-o", "a.png", "--resolution", "64,48", *options], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return program.png(self.folder / "a.png")[3]

    def test_a_world_gets_samples_and_keeps_its_light(self):
        lamps = "[[light]]\ntype = 'directional'\ndirection = [-1, -2, -1]\ndiffuse = [0.9, 0.9, 0.8]\n[[light]]\ntype = 'ambient'\nambient = [0.2, 0.2, 0.2]\n"
        camera = "[[camera]]\nposition = [0, 0.3, 1.6]\ntarget = [0, 0.3, 0]\n"  # shows little of the floor
        parts = "[[primitive]]\ntype = 'sphere'\nradius = 0.5\n[[primitive]]\ntype = 'plane'\nsize = [40, 40]\n"
        for name, text in (("lit", parts + lamps + camera), ("dark", parts + camera)):
            with self.subTest(name=name):
                world = f"{name}.scene.toml"
                self.write(world, text)
                standard, plain = self.bare(world), self.bare(world, "--look", "plain")
                self.assertEqual(standard, self.bare(world, "--look", "plain", "--samples", "4"))
                self.assertNotEqual(standard, plain)
                self.assertEqual(self.bare(world, "--samples", "1"), plain)
                self.assertEqual(self.bare(world, "--visibility", "z32"), self.bare(world, "--visibility", "z32", "--look", "plain"))
                asked = self.bare(world, "--look", "default", "--background", "#808080")
                same = self.bare(world, "--background", "#808080")
                self.assertEqual(asked == same, name == "lit")  # a world without light gets the studio where the look is asked for

    def test_a_worlds_lamps_in_physical_units_stay_as_bright_as_they_are(self):
        self.write("w.scene.toml", "[[primitive]]\ntype = 'sphere'\n[[light]]\ntype = 'photometric-point'\nposition = [0, 0, 3]\nintensity_cd = 5000\n")
        self.assertEqual(self.bare("w.scene.toml", "--look", "default", "--background", "#808080"), self.bare("w.scene.toml", "--background", "#808080"))

    def test_a_panorama_alone_lights_the_model(self):
        ramp = pathlib.Path(__file__).resolve().parents[3] / "data/environment/ramp.hdr"
        for look in ("default", "plain"):
            def lit(*options):
                return self.render("builtin:teapot", "--hdri-file", str(ramp), "--background", "#000000", *options, look=look)[0]
            self.assertEqual(lit(), lit("--hdri-ambient"))
            self.assertNotEqual(lit(), lit("--hdri-ambient", "off"))
            self.assertEqual(lit("--hdri-skybox"), lit("--hdri-skybox", "--hdri-ambient", "off"))

    def test_explain_takes_the_same_look(self):
        model = self.model()
        self.render(model)
        x, y = 32, 24
        pixel = program.png(self.folder / "a.png")[3][y][3 * x:3 * x + 3]
        result = self.run_program("explain", model, "--pixel", f"{x},{y}", "--resolution", "64,48", "--look", "default")
        self.assertEqual(result.code, 0, result.err)
        self.assertIn("sRGB code  {} {} {}".format(*pixel), result.out)


if __name__ == "__main__":
    program.main()
