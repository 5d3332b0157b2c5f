#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight render --samples` and `--anisotropy` through the program.

  samples_test.py PROGRAM [unittest arguments]"""
import json

import program

SIZE = ("--resolution", "90,60")


class Samples(program.Case):
    def picture(self, name, *options):
        run = self.run_program("render", "builtin:teapot", "-o", name, *SIZE, "--json", *options)
        self.assertEqual(run.code, 0, run.err)
        return (self.folder / name).read_bytes(), json.loads(run.out)["rows"][0]["stats"]

    def test_one_is_the_default_and_more_are_other_pictures(self):
        default, _ = self.picture("a.png")
        pictures = {n: self.picture(n + ".png", "--samples", n) for n in ("1", "4", "8")}
        self.assertEqual(default, pictures["1"][0])
        self.assertEqual(len({bytes for bytes, _ in pictures.values()}), 3)
        for n, (_, stats) in pictures.items():
            self.assertLessEqual(stats["samples_covered"], int(n) * stats["pixels_covered"])
            self.assertEqual(stats["pixels_shaded"] > stats["pixels_covered"], n != "1")

    def test_data_channels_do_not_change(self):
        for n in ("1", "4"):
            self.picture(n + ".png", "--samples", n, "--channels", "depth,normal")
        for channel in ("depth", "normal"):
            self.assertEqual((self.folder / f"1.{channel}.exr").read_bytes(), (self.folder / f"4.{channel}.exr").read_bytes())

    def test_what_is_not_there_is_wrong_usage(self):
        for n in ("0", "2", "3", "16", "-4", "4.0", "many", ""):
            self.check_refused(self.run_program("render", "builtin:teapot", "-o", "out.png", f"--samples={n}"), 2, "--samples")
        run = self.run_program("render", "builtin:teapot", "-o", "out.png", "--samples", "4", "--visibility", "painter")
        self.check_refused(run, 2, "--samples 4", "z-reversed")
        self.check_refused(self.run_program("explain", "builtin:teapot", "--pixel", "3,3", "--samples", "4"), 2, "--samples")
        self.check_refused(self.run_program("stages", "builtin:teapot", "-o", "out", "--samples", "4"), 2, "--samples")
        for n in ("0", "17", "2.5", "some", ""):
            self.check_refused(self.run_program("render", "builtin:teapot", "-o", "out.png", f"--anisotropy={n}"), 2, "--anisotropy")
        self.check_refused(self.run_program("explain", "builtin:teapot", "--pixel", "3,3", "--anisotropy", "4"), 2, "--anisotropy")
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    program.main()
