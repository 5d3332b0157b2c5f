#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight render --engine trace` through the program: methods, depth, shadows, shapes, what is counted and what is refused.

  trace_test.py PROGRAM [unittest arguments]"""
import json
import pathlib
import signal
import struct
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import program

SIZE = ("--resolution", "90,60")
WORLD = """
[[primitive]]
type = "sphere"
material = "glass"
[[primitive]]
type = "plane"
size = [8, 8]
position = [0, -1, 0]
material = "silver"
[[material]]
name = "glass"
metallic = 0
roughness = 0
transmission = 1
thickness = 1
[[material]]
name = "silver"
color = [0.1, 0.1, 0.1]
specular = [0.8, 0.8, 0.8]
mirror = "constant"
[[light]]
type = "point"
position = [3, 5, 4]
[[camera]]
position = [0, 1, 5]
target = [0, 0, 0]
[render]
engine = "trace"
"""


class Trace(program.Case):
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

    def test_rays_are_counted_by_what_they_are_for(self):
        _, rays = self.picture("a.png")
        self.assertEqual(rays["primary"], 90 * 60)
        for kind in ("shadow", "reflected", "refracted", "deepest", "scene_bytes"):
            self.assertGreater(rays[kind], 0, kind)
        _, rays = self.picture("a.png", "--samples", "4", "--shadows", "off", "--max-depth", "0")
        self.assertEqual([rays[k] for k in ("primary", "shadow", "reflected", "refracted", "deepest")], [4 * 90 * 60, 0, 0, 0, 0])
        text = self.run_program("render", "w.scene.toml", "-o", "a.png", *SIZE, "--stats").out
        self.assertIn("refracted rays", text)

    def test_casting_is_depth_0_and_naive_casting_sees_the_same(self):
        cast, _ = self.picture("a.png", "--method", "cast")
        self.assertEqual(cast, self.picture("b.png", "--max-depth", "0")[0])
        self.assertNotEqual(cast, self.picture("c.png")[0])
        naive, rays = self.picture("d.png", "--method", "cast", "--naive")
        self.assertEqual(naive, cast)
        self.assertEqual(rays["triangle_tests"], 2 * (rays["primary"] + rays["shadow"]), "two shapes")

    def test_shadows_are_on_unless_it_is_said(self):
        on, off = self.picture("a.png")[0], self.picture("b.png", "--shadows", "off")[0]
        self.assertNotEqual(on, off)
        self.assertEqual(on, self.picture("c.png", "--shadows")[0])

    def test_shapes_are_met_by_their_formulas_unless_it_is_said(self):
        view = ("--engine", "trace", "--camera-position", "0,1,5", "--camera-focal-point", "0,0,0")
        exact = self.picture("a.png", *view, model="builtin:sphere:tolerance=0.1")[0]
        self.assertEqual(exact, self.picture("b.png", *view, model="builtin:sphere:tolerance=0.01")[0])
        self.assertNotEqual(exact, self.picture("c.png", *view, "--tessellate", model="builtin:sphere:tolerance=0.1")[0])

    def test_rasterizers_say_what_they_do_not_show(self):
        run = self.run_program("render", "w.scene.toml", "-o", "a.png", *SIZE, "--engine", "soft", "--verbose")
        self.assertEqual(run.code, 0, run.err)
        self.assertIn("light passes through 1 material:", run.err)
        self.assertIn("1 material mirrors:", run.err)
        self.check_refused(self.run_program("render", "w.scene.toml", "-o", "out.png", *SIZE, "--engine", "soft", "--method", "whitted"),
                           2, "engine soft cannot follow rays")

    def test_what_is_not_there_is_wrong_usage(self):
        for words in (("--max-depth", "65"), ("--max-depth", "-1"), ("--method", "paths"), ("--naive",), ("--naive-limit", "-1")):
            self.check_refused(self.run_program("render", "w.scene.toml", "-o", "out.png", *SIZE, *words), 2, words[0])
        run = self.run_program("render", "w.scene.toml", "-o", "out.png", *SIZE, "--method", "cast", "--naive", "--tessellate",
                               "--naive-limit", "1000")
        self.check_refused(run, 2, "tests", "--naive-limit")

    def test_an_interrupted_picture_is_kept_when_it_is_said(self):
        for keep in (False, True):
            work = subprocess.Popen([program.PROGRAM, "render", "w.scene.toml", "-o", "large.png", "--resolution", "9000,6000", "--samples", "8",
                                     *(["--keep-partial"] if keep else [])], cwd=self.folder, stderr=subprocess.PIPE, text=True)
            time.sleep(1)
            work.send_signal(signal.SIGINT)
            said = work.communicate()[1]
            self.assertEqual(work.returncode, -signal.SIGINT, said)
            self.assertEqual((self.folder / "large.png").exists(), keep, said)
            self.assertIn("of its pixels are there" if keep else "cancelled", said)
        size = struct.unpack(">II", (self.folder / "large.png").read_bytes()[16:24])
        self.assertEqual(size, (9000, 6000))


if __name__ == "__main__":
    program.main()
