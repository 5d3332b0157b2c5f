#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A named background stays the color that was named, whatever tone curve and exposure do to the light.

  background_test.py PROGRAM [unittest arguments]"""
import itertools
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import exr
import program

NAMED = (200, 100, 30)
COLOR = "#c8641e"


class Background(program.Case):
    def render(self, *options, output="a.png", model="builtin:sphere", **environment):
        run = self.run_program("render", model, "-o", output, "--resolution", "48,40", *options, **environment)
        self.assertEqual(run.code, 0, run.err)
        return program.png(self.folder / output) if output.endswith(".png") else None

    def engines(self):
        """Those that are built in and can draw here."""
        return [e for e in ("soft", "gl", "trace")
                if self.run_program("render", "builtin:plane", "-o", "e.png", "--resolution", "8,8", "--engine", e).code == 0]

    def test_is_exact_in_every_engine(self):
        for engine in self.engines():
            samples = ("1",) if engine == "trace" else ("1", "4")
            for tone, exposure, count in itertools.product(("none", "reinhard", "neutral", "aces", "agx"), ("0", "3", "-4"), samples):
                with self.subTest(engine=engine, tone=tone, exposure=exposure, samples=count):
                    picture = self.render("--engine", engine, "--tone-mapping", tone, "--exposure", exposure, "--samples", count,
                                          "--background", COLOR)
                    for row in (picture[3][0], picture[3][-1]):
                        for x in range(picture[0]):
                            self.assertEqual(tuple(row[3 * x:3 * x + 3]), NAMED)

    def test_white_and_black_stay_too(self):
        for color, codes in (("#ffffff", (255, 255, 255)), ("#000000", (0, 0, 0))):
            picture = self.render("--tone-mapping", "agx", "--exposure", "2", "--background", color)
            self.assertEqual(tuple(picture[3][0][:3]), codes)

    def test_edges_are_mixed_by_coverage(self):
        """Where a black model covers a part of a pixel, its color lies between the background's and black, in linear light."""
        options = ("--samples", "8", "--light", "none", "--background", COLOR)
        plain, toned = (self.render(*options, "--tone-mapping", tone) for tone in ("none", "reinhard"))
        self.assertEqual(plain, toned)  # black stays black under that curve
        self.assertGreater(sum(0 < row[3 * x] < NAMED[0] for row in toned[3] for x in range(48)), 20)

    def test_a_transparent_background_is_as_before(self):
        plain = self.render("--background", "transparent")
        toned = self.render("--background", "transparent", "--tone-mapping", "agx", "--exposure", "1")
        self.assertEqual(plain[2], 4)
        for a, b in zip(plain[3], toned[3]):
            self.assertEqual(a[3::4], b[3::4])

    def test_surroundings_are_toned(self):
        sky = ("--hdri-skybox", "--background", COLOR)
        self.assertNotEqual(self.render(*sky)[3][0], self.render(*sky, "--exposure", "-2")[3][0])

    def test_linear_files_hold_the_light_of_the_color(self):
        for exposure in ("0", "3"):
            self.render("--background", COLOR, "--exposure", exposure, output="a.exr")
            red = exr.read(self.folder / "a.exr")[2]["R"][1][0][0]
            self.assertAlmostEqual(red, ((NAMED[0] / 255 + 0.055) / 1.055) ** 2.4, 4)

    def test_mirrors_see_it_as_light(self):
        if "trace" not in self.engines():
            self.skipTest("the engine trace is not built in")
        mirror = ("--engine", "trace", "--light", "none", "--metallic", "1", "--roughness", "0", "--background", COLOR)
        picture = self.render(*mirror, "--tone-mapping", "reinhard")
        middle = picture[3][20][3 * 24:3 * 24 + 3]
        self.assertGreater(middle[0], 60)
        self.assertLess(middle[0], NAMED[0])

    def test_explain_and_stages_show_the_picture(self):
        options = ("--background", COLOR, "--exposure", "1.5", "--tone-mapping", "aces", "--samples", "4")
        picture = self.render(*options)
        options = ("--resolution", "48,40", *options)
        for x, y in ((0, 0), (24, 20), (24, 2), (24, 1), (11, 9)):
            run = self.run_program("explain", "builtin:sphere", "--pixel", f"{x},{y}", "--json", *options)
            self.assertEqual(run.code, 0, run.err)
            self.assertEqual(json.loads(run.out)["rows"][0]["codes"], list(picture[3][y][3 * x:3 * x + 3]), (x, y))
        run = self.run_program("stages", "builtin:sphere", "-o", "out", *options)
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(program.png(pathlib.Path(self.folder) / "out/picture.png")[3], picture[3])


if __name__ == "__main__":
    program.main()
