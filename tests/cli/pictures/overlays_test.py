#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Grid, axes and words over the picture (docs/overlays.md), and ambient occlusion (docs/ambient-occlusion.md).

  overlays_test.py PROGRAM [unittest arguments]"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import exr
import program

SIZE = (160, 120)


class Over(program.Case):
    def render(self, *options, model="builtin:teapot", output="a.png", width=SIZE[0]):
        run = self.run_program("render", model, "-o", output, "--resolution", "%d,%d" % SIZE, *options)
        self.assertEqual(run.code, 0, run.err)
        return program.png(self.folder / output)[3] if output.endswith(".png") else None

    def differing(self, a, b):
        """[(x, y)] of pixels that differ"""
        channels = len(a[0]) // SIZE[0]
        return [(x, y) for y in range(len(a)) for x in range(SIZE[0])
                if a[y][channels * x:channels * (x + 1)] != b[y][channels * x:channels * (x + 1)]]

    def engines(self):
        return [e for e in ("soft", "gl", "trace")
                if self.run_program("render", "builtin:plane", "-o", "e.png", "--resolution", "8,8", "--engine", e).code == 0]


class Overlays(Over):
    ALL = ("--grid", "--axis", "--filename", "--metadata")

    def test_each_lies_in_its_place(self):
        plain = self.render()
        places = {"--axis": lambda x, y: x < 40 and y > 80, "--filename": lambda x, y: y < 16,
                  "--metadata": lambda x, y: x > 20 and y > 50}
        for option, is_there in places.items():
            found = self.differing(plain, self.render(option))
            self.assertGreater(len(found), 30, option)
            self.assertTrue(all(is_there(x, y) for x, y in found), option)

    def test_the_grid_is_hidden_by_the_model(self):
        gray = ("--light", "none", "--color", "#000000")
        plain, grid = self.render(*gray), self.render(*gray, "--grid")
        model = {(x, y) for y in range(SIZE[1]) for x in range(SIZE[0]) if plain[y][3 * x:3 * x + 3] == b"\0\0\0"}
        self.assertGreater(len(model), 1000)
        lines = set(self.differing(plain, grid))
        self.assertGreater(len(lines), 500)
        self.assertFalse(lines & {(x, y) for x, y in model if all((x + i, y + j) in model for i in (-1, 0, 1) for j in (-1, 0, 1))})

    def test_is_the_same_in_every_engine(self):
        on_ground = {}
        for engine in self.engines():
            options = ("--engine", engine, "--light", "none", "--color", "#000000")
            on_ground[engine] = set(self.differing(self.render(*options), self.render(*options, *self.ALL)))
        for engine, found in on_ground.items():
            self.assertLess(len(found ^ on_ground["soft"]), 0.02 * len(found), engine)

    def test_windows_and_samples_are_those_of_the_whole(self):
        for samples in ("1", "4"):
            whole = self.render(*self.ALL, "--samples", samples)
            self.render(*self.ALL, "--samples", samples, "--window", "20,60,90,60")
            part = program.png(self.folder / "a.png")[3]
            for y, row in enumerate(part):
                self.assertEqual(bytes(row), bytes(whole[60 + y][3 * 20:3 * 110]), (samples, y))

    def test_channels_stay_what_was_asked_for(self):
        plain = self.render("--channels", "normal", "--channel-files", "exr,layers")
        before = {p: (self.folder / p).read_bytes() for p in self.files() if p.endswith(".exr")}
        over = self.render("--channels", "normal", "--channel-files", "exr,layers", "--grid")
        self.assertNotEqual(plain, over)
        self.assertEqual(set(before), {p for p in self.files() if p.endswith(".exr")})
        self.assertEqual(before["a.normal.exr"], (self.folder / "a.normal.exr").read_bytes())
        self.assertEqual(sorted(exr.read(self.folder / "a.channels.exr")[2]), ["B", "G", "R", "normal.X", "normal.Y", "normal.Z"])

    def test_linear_and_transparent_pictures_have_them_too(self):
        for options in (("--background", "transparent"), ()):
            self.render(*options, output="a.exr")
            plain = exr.read(self.folder / "a.exr")[2]
            self.render(*options, *self.ALL, output="a.exr")
            over = exr.read(self.folder / "a.exr")[2]
            self.assertNotEqual(plain["R"], over["R"])
            if options:
                self.assertNotEqual(plain["A"], over["A"])

    def test_a_world_file_asks_for_them(self):
        self.write("w.scene.toml", '[[primitive]]\ntype = "sphere"\n[render]\ngrid = true\naxis = true\n')
        self.assertEqual(self.render(model="w.scene.toml"), self.render("--grid", "on", "--axis", model="w.scene.toml"))
        off = self.render("--grid", "off", "--axis", "off", model="w.scene.toml")
        self.assertTrue(self.differing(off, self.render(model="w.scene.toml")))


class AmbientOcclusion(Over):
    AROUND = ("--light", "ambient:0.8,0.8,0.8", "--ambient-occlusion")

    def scene(self):
        return self.write("corner.obj", "o a\nv -2 0 -2\nv 2 0 -2\nv 2 0 2\nv -2 0 2\nf 4 3 2 1\n"
                                        "o b\nv -2 0 -2\nv 2 0 -2\nv 2 3 -2\nv -2 3 -2\nf 5 6 7 8\n")

    def test_darkens_the_corner_and_nothing_else(self):
        model = self.scene()
        open_picture, picture = self.render("--light", "ambient:0.8,0.8,0.8", model=model), self.render(*self.AROUND, model=model)
        darker = [(x, y) for x, y in self.differing(open_picture, picture)]
        self.assertGreater(len(darker), 200)
        self.assertTrue(all(picture[y][3 * x] <= open_picture[y][3 * x] for x, y in darker))
        lit = ("--light", "directional:0,-1,-1")
        self.assertEqual(self.render(*lit, model=model), self.render(*lit, "--ambient-occlusion", model=model))

    def test_windows_and_samples(self):
        model = self.scene()
        for samples in ("1", "4", "8"):
            options = (*self.AROUND, "--samples", samples)
            whole = self.render(*options, model=model)
            self.render(*options, "--window", "31,40,70,33", model=model)
            for y, row in enumerate(program.png(self.folder / "a.png")[3]):
                self.assertEqual(bytes(row), bytes(whole[40 + y][3 * 31:3 * 101]), (samples, y))

    def test_threads_and_instruction_sets(self):
        model = self.scene()
        self.render(*self.AROUND, "--threads", "1", model=model)
        first = (self.folder / "a.png").read_bytes()
        for isa in ("scalar", "sse2"):
            run = self.run_program("render", model, "-o", "b.png", "--resolution", "%d,%d" % SIZE, *self.AROUND, "--threads", "3",
                                   RAKELIGHT_ISA=isa)
            self.assertEqual(run.code, 0, run.err)
            self.assertEqual((self.folder / "b.png").read_bytes(), first, isa)

    def test_channel_and_explain_agree(self):
        model = self.scene()
        picture = self.render(*self.AROUND, "--channels", "ambient-occlusion", model=model)
        open_share = exr.read(self.folder / "a.ambient-occlusion.exr")[2]["Y"][1]
        plain = self.render("--light", "ambient:0.8,0.8,0.8", model=model)
        dark = min((open_share[y][x], x, y) for y in range(SIZE[1]) for x in range(SIZE[0]))
        self.assertLess(dark[0], 0.8)
        for x, y in ((dark[1], dark[2]), (80, 90)):
            run = self.run_program("explain", model, "--pixel", f"{x},{y}", "--resolution", "%d,%d" % SIZE, "--json", *self.AROUND)
            self.assertEqual(run.code, 0, run.err)
            row = json.loads(run.out)["rows"][0]
            self.assertEqual(row["codes"], list(picture[y][3 * x:3 * x + 3]))
            self.assertAlmostEqual(row["layers"][0]["ambient_occlusion"], open_share[y][x], 6)
            self.assertLessEqual(picture[y][3 * x], plain[y][3 * x])

    def test_what_cannot_be_is_refused(self):
        run = self.run_program("render", "builtin:plane", "-o", "a.png", "--ambient-occlusion", "--ambient-occlusion-samples", "7")
        self.check_refused(run, 2, "ambient-occlusion-samples")
        run = self.run_program("render", "builtin:plane", "-o", "a.png", "--channels", "ambient-occlusion")
        self.check_refused(run, 2, "ambient-occlusion")

    def test_settings_of_ambient_occlusion_that_is_off_are_said_to_have_no_effect(self):
        for setting, value in (("--ambient-occlusion-samples", "32"), ("--ambient-occlusion-radius", "2")):
            run = self.run_program("render", "builtin:plane", "-o", "a.png", "--resolution", "24,16", setting, value)
            self.assertEqual(run.code, 0, run.err)
            self.assertIn("no effect without --ambient-occlusion\n", run.err)
            for is_on in ("on", "off"):  # who says off knows
                run = self.run_program("render", "builtin:plane", "-o", "a.png", "--resolution", "24,16", setting, value, f"--ambient-occlusion={is_on}")
                self.assertEqual((run.code, run.err), (0, ""))


if __name__ == "__main__":
    program.main()
