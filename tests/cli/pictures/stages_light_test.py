#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The stages of `rakelight stages` from light to the picture: terms, shadows, layers, samples, tone curve.

  stages_light_test.py PROGRAM [unittest arguments]"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program
from program import png
from stages import SIZE, Case, linear


class Light(Case):
    def test_the_picture_is_the_rendered_one_and_the_means_of_the_terms_add_up_to_its_mean(self):
        for shading in ("phong", "gouraud", "flat", "unlit"):
            self.stages("--shading", shading)
            run = self.run_program("render", "builtin:teapot", "-o", "a.png", "--resolution", SIZE, "--shading", shading, "--background", "0,0,0", "--json")
            covered = json.loads(run.out)["rows"][0]["stats"]["pixels_covered"]
            self.run_program("render", "builtin:teapot", "-o", "a.png", "--resolution", SIZE, "--shading", shading)
            self.assertEqual((self.out / "picture.png").read_bytes(), (self.folder / "a.png").read_bytes())
            if shading == "unlit":
                continue
            terms = self.table("lighting")["rows"]
            self.assertEqual(len(terms), 10)  # emission, and three of each of the three lights
            pixels = self.table("visibility")["numbers"]["pixels that show a surface"]
            self.assertEqual(pixels, covered)
            red = sum(row[1] for row in terms)
            rows = png(self.out / "picture.png")[3]
            ground = rows[0][:3]
            shown = [linear(row[3 * x]) for row in rows for x in range(96) if row[3 * x:3 * x + 3] != ground]
            self.assertAlmostEqual(red, sum(shown) / len(shown), delta=0.01)

    def sum_of_terms_is_the_mean_of_the_picture(self, *options):
        self.stages("--background", "0,0,0", *options)
        rows = png(self.out / "picture.png")[3]
        pixels = self.table("visibility")["numbers"]["pixels that show a surface"]
        mean = sum(linear(row[3 * x]) for row in rows for x in range(96)) / pixels
        terms = self.table("lighting")["rows"]
        self.assertAlmostEqual(sum(row[1] for row in terms), mean, delta=0.002)
        return {row[0]: row[1] for row in terms}

    def test_surroundings_and_fog_have_their_terms_and_the_sum_is_the_picture(self):
        terms = self.sum_of_terms_is_the_mean_of_the_picture("--hdri-ambient")
        self.assertEqual(list(terms), ["Emission", "Surroundings: diffuse", "Surroundings: specular"])
        self.assertGreater(terms["Surroundings: diffuse"], 0.1)
        self.assertGreater(terms["Surroundings: specular"], 0.01)
        for picture in ("surroundings-diffuse", "surroundings-specular"):
            self.assertTrue((self.out / f"{picture}.png").is_file())
        clear = self.sum_of_terms_is_the_mean_of_the_picture()
        foggy = self.sum_of_terms_is_the_mean_of_the_picture("--fog", "exp:0.3:color=#ffffff")
        share = self.table("lighting")["numbers"]["fraction seen through the fog, mean of opaque pixels"]
        self.assertAlmostEqual(foggy["Fog"], 1 - share, 5)
        lit = [name for name in clear if clear[name] > 0]
        self.assertEqual(len(lit), 5)  # an ambient term, and two of each of two lights
        for name in lit:
            self.assertAlmostEqual(foggy[name] / clear[name], share, delta=0.02)
        both = self.sum_of_terms_is_the_mean_of_the_picture("--hdri-ambient", "--fog", "exp2:0.3", "--shading", "gouraud", "--light", "directional:0,-1,0", "--light-intensity", "0.3")
        self.assertEqual(len(both), 7)

    def test_exposure_and_tone_curve_are_in_the_picture_and_shown_before_and_after(self):
        options = ("--tone-mapping", "agx", "--exposure", "2", "--samples", "4")
        self.stages(*options)
        self.run_program("render", "builtin:teapot", "-o", "a.png", "--resolution", SIZE, *options)
        for picture in ("picture", "shading-phong"):
            self.assertEqual((self.out / f"{picture}.png").read_bytes(), (self.folder / "a.png").read_bytes(), picture)
        self.stages()
        plain = (self.out / "picture.png").read_bytes()
        self.stages("--exposure", "2", "--tone-mapping", "agx")
        self.assertEqual((self.out / "tone-light.png").read_bytes(), plain)
        tone = self.table("tone")
        self.assertEqual((tone["numbers"]["tone curve"], tone["numbers"]["exposure [EV]"]), ("agx", 2))
        self.assertGreater(tone["numbers"]["pixels brighter than 1 with the exposure"], 100)
        self.assertEqual(self.table("picture")["numbers"]["pixels brighter than 1, clamped"], 0)  # the curve has no such light
        for ev, light, exposed, after, code in tone["rows"]:
            self.assertAlmostEqual(light / 0.18 / 2 ** ev, 1, 5)
            self.assertAlmostEqual(exposed / light, 4, 5)
            self.assertAlmostEqual(linear(code), after, delta=0.006)
        self.assertLess([row[3] for row in tone["rows"] if row[0] == 2][0], 1)
        self.stages("--exposure", "2")
        self.assertGreater(self.table("picture")["numbers"]["pixels brighter than 1, clamped"], 100)

    def test_shadows_are_shown_light_by_light_with_the_maps(self):
        self.write("a.obj", "o floor\nv -2 0 -2\nv 2 0 -2\nv 2 0 2\nv -2 0 2\nf 4 3 2 1\no lid\nv -1 1 -1\nv 1 1 -1\nv 1 1 1\nv -1 1 1\nf 8 7 6 5\n")
        above = ("--camera-position", "0,0.9,0", "--camera-focal-point", "0,0,0", "--camera-view-up", "0,0,-1", "--camera-view-angle", "60")
        lights = ("--light", "directional:0,-1,0", "--light", "ambient:0.1,0.1,0.1", "--light", "point:0,0.5,0", "--shadow-size", "64")
        self.stages("--shadows", *above, *lights, model="a.obj")
        shadows = self.table("shadows")
        self.assertEqual([p["file"] for p in shadows["pictures"]],
                         ["shadow-0.png", "shadow-map-0.png", "shadow-2.png", "shadow-map-2.png"])
        self.assertEqual(png(self.out / "shadow-map-0.png")[:2], (64, 64))
        self.assertEqual(png(self.out / "shadow-map-2.png")[:2], (3 * 64 + 2 * 4, 2 * 64 + 4))
        sun, _, lamp = shadows["rows"]
        pixels = 96 * 64  # the floor under the lid, seen from under it, fills the picture
        self.assertEqual((sun[1], sun[3], sun[4], sun[5]), (1, pixels, 0, pixels))  # all of it in shadow
        self.assertEqual((lamp[1], lamp[3], lamp[7]), (6, pixels, pixels))  # none of it
        self.assertEqual({c for row in png(self.out / "shadow-0.png")[3] for c in row}, {0})
        self.assertEqual({c for row in png(self.out / "shadow-2.png")[3] for c in row}, {255})
        self.assertEqual(self.table("lighting")["rows"][2][1], 0)  # its diffuse term
        text = (self.out / "index.html").read_text()
        self.assertLess(text.index('<section id="shadows">'), text.index('<section id="lighting">'))
        self.stages(*above, *lights, model="a.obj")
        self.assertFalse((self.out / "shadows.json").exists())

    def test_lights_beyond_the_eighth_share_a_term(self):
        lights = [word for i in range(11) for word in ("--light", f"directional:0,0,-1:color=0.0{i % 3 + 1},0,0")]
        terms = self.sum_of_terms_is_the_mean_of_the_picture(*lights)
        self.assertIn("Lights 8 to 10, all terms", terms)
        self.assertGreater(terms["Lights 8 to 10, all terms"], 0)

    def test_blended_layers_lie_over_one_another_far_to_near(self):
        square = "v -1 -1 {z}\nv 1 -1 {z}\nv 1 1 {z}\nv -1 1 {z}\n"
        self.write("a.mtl", "newmtl wall\nKd 0 0 1\nnewmtl red\nKd 1 0 0\nd 0.25\nnewmtl green\nKd 0 1 0\nd 0.5\n")
        self.write("a.obj", "mtllib a.mtl\n" + "".join(square.format(z=z) for z in (2, 0, 1)) + "usemtl green\nf 1 2 3 4\nusemtl wall\nf 5 6 7 8\nusemtl red\nf 9 10 11 12\n")
        self.stages("--view", "front", "--shading", "unlit", model="a.obj")
        table = self.table("blended")
        self.assertEqual([row[0] for row in table["rows"]], [1, 2])
        middle = [[linear(c) for c in png(self.out / f"blended-{n}.png")[3][32][3 * 48:3 * 48 + 3]] for n in (0, 1, 2)]
        alphas = [png(self.out / f"blended-{n}-alpha.png")[3][32][3 * 48] for n in (1, 2)]
        self.assertEqual(alphas, [64, 128])
        for found, expected in zip(middle, ([0, 0, 1], [0.25, 0, 0.75], [0.125, 0.5, 0.375])):
            for a, b in zip(found, expected):
                self.assertAlmostEqual(a, b, delta=0.005)
        self.assertEqual((self.out / "blended-2.png").read_bytes(), (self.out / "picture.png").read_bytes())
        self.stages()
        self.assertEqual(self.table("blended")["numbers"], {"pixels that something is laid over": 0, "layers shown": 0})

    def test_terms_of_layers_are_in_the_pictures_of_the_light(self):
        square = "v -1 -1 {z}\nv 1 -1 {z}\nv 1 1 {z}\nv -1 1 {z}\n"
        self.write("a.mtl", "newmtl wall\nKd 0 0 1\nnewmtl red\nKd 1 0 0\nd 0.25\n")
        self.write("a.obj", "mtllib a.mtl\n" + "".join(square.format(z=z) for z in (0, 1)) + "usemtl wall\nf 1 2 3 4\nusemtl red\nf 5 6 7 8\n")
        self.stages("--view", "front", "--light", "directional:0,0,-1", model="a.obj")
        found = [linear(c) for c in png(self.out / "light-0-diffuse.png")[3][32][3 * 48:3 * 48 + 3]]
        for a, b in zip(found, (0.25, 0, 0.75)):
            self.assertAlmostEqual(a, b, delta=0.005)
        self.assertEqual(png(self.out / "light-0-diffuse.png")[3][32][3 * 48:3 * 48 + 3], png(self.out / "picture.png")[3][32][3 * 48:3 * 48 + 3])

    def test_several_samples_have_a_stage_of_their_own_and_the_picture_is_their_mean(self):
        for options in (("--samples", "4"), ("--samples", "8", "--anisotropy", "4")):
            self.stages(*options)
            run = self.run_program("render", "builtin:teapot", "-o", "a.png", "--resolution", SIZE, *options, "--json")
            stats = json.loads(run.out)["rows"][0]["stats"]
            self.assertEqual((self.out / "picture.png").read_bytes(), (self.folder / "a.png").read_bytes())
            self.assertEqual((self.out / "shading-phong.png").read_bytes(), (self.folder / "a.png").read_bytes())
            table = self.table("samples")
            self.assertEqual(table["numbers"]["samples covered"], stats["samples_covered"])
            self.assertEqual(table["numbers"]["pixels covered"], stats["pixels_covered"])
            self.assertEqual(table["numbers"]["opaque triangles shaded, over all pixels"], stats["pixels_shaded"])
            self.assertEqual(sum(n * pixels for n, pixels, _ in table["rows"]), stats["samples_covered"])
            self.assertEqual(sum(n * pixels for n, _, pixels in table["rows"]), stats["pixels_shaded"])
            text = (self.out / "index.html").read_text()
            self.assertLess(text.index('<section id="samples">'), text.index('<section id="picture">'))
            for picture in table["pictures"]:
                self.assertTrue((self.out / picture["file"]).is_file())

    def test_shading_frequencies_are_those_of_render(self):
        self.stages()
        for shading, _, evaluations, difference in self.table("shading-frequency")["rows"]:
            run = self.run_program("render", "builtin:teapot", "-o", "a.png", "--resolution", SIZE, "--shading", shading, "--json")
            self.assertEqual(json.loads(run.out)["rows"][0]["stats"]["lighting_evaluations"], evaluations, shading)
            self.assertEqual((self.folder / "a.png").read_bytes(), (self.out / f"shading-{shading}.png").read_bytes())
            self.assertEqual(difference == 0, shading == "phong")


if __name__ == "__main__":
    program.main()
