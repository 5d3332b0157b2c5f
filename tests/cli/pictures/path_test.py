#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight render --engine trace --method path` through the program: samples, passes, seeds, windows, channels, denoising.

  path_test.py PROGRAM [unittest arguments]"""
import json
import os
import pathlib
import pty
import signal
import struct
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import exr
import program

SIZE = ("--resolution", "60,40")
WORLD = """
[[primitive]]
type = "plane"
size = [4, 4]
material = "white"
[[primitive]]
type = "plane"
size = [1, 1]
position = [0, 2, 0]
rotation_deg = [180, 0, 0]
material = "lamp"
[[material]]
name = "white"
metallic = 0
roughness = 1
[[material]]
name = "lamp"
metallic = 0
roughness = 1
emission = [6, 5, 4]
[[camera]]
position = [0, 1.5, 4]
target = [0, 0.5, 0]
[render]
engine = "trace"
method = "path"
samples = 8
background = "#000000"
"""


class Paths(program.Case):
    def picture(self, name, *options, model="w.scene.toml"):
        run = self.run_program("render", model, "-o", name, *SIZE, "--json", *options)
        self.assertEqual(run.code, 0, run.err)
        return (self.folder / name).read_bytes(), json.loads(run.out)["rows"][0]["stats"]["rays"]

    def setUp(self):
        super().setUp()
        if self.run_program("render", "builtin:plane", "-o", "try.png", *SIZE, "--engine", "trace").code != 0:
            self.skipTest("Embree is not there")
        (self.folder / "try.png").unlink()
        self.write("w.scene.toml", WORLD)

    def test_samples_come_in_passes_until_noise_or_time_ends_them(self):
        _, rays = self.picture("a.png")
        self.assertEqual((rays["samples"], rays["passes"]), (8, 4))
        self.assertEqual(rays["primary"], 8 * 60 * 40)
        self.assertGreater(rays["noise"], 0)
        _, rays = self.picture("b.png", "--samples", "4096", "--noise", "0.2")
        self.assertLess(rays["noise"], 0.2)
        self.assertLess(rays["samples"], 4096)
        begin = time.monotonic()
        _, rays = self.picture("c.png", "--samples", "1000000", "--max-seconds", "1")
        self.assertLess(time.monotonic() - begin, 30)
        self.assertLess(rays["samples"], 1000000)

    def test_the_same_seed_gives_the_same_bits(self):
        picture, _ = self.picture("a.png")
        self.assertEqual(self.picture("b.png", "--threads", "1")[0], picture)
        self.assertNotEqual(self.picture("c.png", "--seed", "1")[0], picture)

    def test_lamps_are_light_and_no_other_is_there(self):
        self.picture("a.png", "--light", "none")
        alone = program.png(self.folder / "a.png")[3]
        self.assertGreater(max(max(row) for row in alone), 100)
        self.picture("b.png")
        self.assertEqual(program.png(self.folder / "b.png")[3], alone)

    def test_no_light_is_black_in_every_engine(self):
        for words in (("soft",), ("trace",), ("trace", "--method", "path")):
            run = self.run_program("render", "builtin:sphere", "-o", "dark.png", *SIZE, "--light", "none", "--background", "#000000", "--engine", *words)
            self.assertEqual(run.code, 0, run.err)
            rows = program.png(self.folder / "dark.png")[3]
            self.assertEqual(max(max(row) for row in rows), 0, words)

    def test_other_engines_say_that_they_follow_no_rays(self):
        self.check_refused(self.run_program("render", "builtin:sphere", "-o", "out.png", "--engine", "soft", "--method", "path"), 2, "follow rays")

    def test_what_has_no_effect_is_said(self):
        for words in (("--denoise",), ("--noise", "0.1"), ("--seed", "2")):
            run = self.run_program("render", "builtin:sphere", "-o", "out.png", *SIZE, *words)
            self.assertEqual(run.code, 0, run.err)
            self.assertIn("no effect without the method path", run.err)
        run = self.run_program("render", "w.scene.toml", "-o", "out.png", *SIZE, "--denoise")
        self.assertEqual((run.code, run.err), (0, ""))
        run = self.run_program("render", "w.scene.toml", "-o", "out.png", *SIZE, "--visibility", "painter")
        self.check_refused(run, 2, "hidden-surface removal")

    def test_a_progress_line_says_how_long_it_takes(self):
        parent, child = pty.openpty()
        work = subprocess.Popen([program.PROGRAM, "render", "w.scene.toml", "-o", "long.png", "--resolution", "200,150", "--samples", "1000000",
                                 "--max-seconds", "6"], cwd=self.folder, stderr=child, stdin=subprocess.DEVNULL)
        os.close(child)
        said = b""
        try:
            while part := os.read(parent, 4096):
                said += part
        except OSError:  # the other end was closed
            pass
        self.assertEqual(work.wait(), 0)
        self.assertRegex(said.decode(), r"render \d+ %, \d+ s, about \d+ s left")

    def test_denoised_pictures_say_so_and_windows_of_them_are_parts(self):
        plain, _ = self.picture("a.png")
        whole, _ = self.picture("b.png", "--denoise")
        self.assertNotEqual(plain, whole)
        self.assertNotIn(b"denoised", plain)
        self.assertIn(b"tEXtComment\0rakelight: denoised", whole)
        self.assertIn(b"denoised", self.picture("c.exr", "--denoise")[0])
        self.assertIn(b"denoised", self.picture("c.jpg", "--denoise")[0])
        self.assertIn(b"\n# rakelight: denoised", self.picture("c.hdr", "--denoise")[0])
        self.picture("part.png", "--denoise", "--window", "17,9,20,15")
        part, rows = program.png(self.folder / "part.png")[3], program.png(self.folder / "b.png")[3]
        self.assertEqual([bytes(row) for row in part], [bytes(row[3 * 17:3 * 37]) for row in rows[9:24]])

    def test_channels_of_paths_are_for_paths(self):
        self.picture("a.png", "--channels", "paths,normal", "--channel-files", "png")
        self.assertEqual(len(list(self.folder.glob("a.*.png"))), 5)
        run = self.run_program("render", "w.scene.toml", "-o", "out.png", *SIZE, "--method", "whitted", "--samples", "1", "--channels", "variance")
        self.check_refused(run, 2, "variance", "path")
        self.check_refused(self.run_program("render", "w.scene.toml", "-o", "out.png", *SIZE, "--method", "whitted", "--samples", "16"), 2, "samples")

    def test_what_is_not_there_is_wrong_usage(self):
        for words in (("--samples", "0"), ("--samples", "2000000"), ("--seed", "-1"), ("--noise", "-1"), ("--max-seconds", "x"), ("--clamp", "-1"),
                      ("--light-sampling", "all")):
            self.check_refused(self.run_program("render", "w.scene.toml", "-o", "out.png", *SIZE, *words), 2, words[0])

    def test_an_interrupted_picture_is_kept_when_it_is_said(self):
        for keep in (False, True):
            work = subprocess.Popen([program.PROGRAM, "render", "w.scene.toml", "-o", "long.png", "--resolution", "200,150", "--samples", "1000000",
                                     *(["--keep-partial"] if keep else [])], cwd=self.folder, stderr=subprocess.PIPE, text=True)
            time.sleep(2)
            work.send_signal(signal.SIGINT)
            said = work.communicate()[1]
            self.assertEqual(work.returncode, -signal.SIGINT, said)
            self.assertEqual((self.folder / "long.png").exists(), keep, said)
            self.assertNotIn("shows the model", said)
        self.assertEqual(struct.unpack(">II", (self.folder / "long.png").read_bytes()[16:24]), (200, 150))

    def test_an_interrupted_picture_is_denoised_and_has_its_channels(self):
        work = subprocess.Popen([program.PROGRAM, "render", "w.scene.toml", "-o", "cut.exr", "--resolution", "200,150", "--samples", "1000000", "--denoise",
                                 "--keep-partial", "--channels", "normal"], cwd=self.folder, stderr=subprocess.PIPE, text=True)
        time.sleep(2)
        work.send_signal(signal.SIGINT)
        self.assertEqual((work.communicate()[0], work.returncode), (None, -signal.SIGINT))
        self.assertIn(b"denoised", (self.folder / "cut.exr").read_bytes()[:4096])
        normals = exr.read(self.folder / "cut.normal.exr")[2]
        self.assertGreater(max(max(row) for row in normals["G"][1]), 0.99)


if __name__ == "__main__":
    program.main()
