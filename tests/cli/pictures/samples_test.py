#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight render --samples` and `--anisotropy` through the program.

  samples_test.py PROGRAM [unittest arguments]"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
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

    def test_a_pixel_of_two_colors_is_their_mean_in_linear_light(self):
        # Red to the left of the edge in the middle of column 8, blue to the right; 4 and 8 samples: half on each side.
        (self.folder / "two.mtl").write_text("newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n")
        corners = "".join(f"v {x} {y} 0\n" for x in (-2, 0.0625, 2) for y in (-2, 2))
        (self.folder / "two.obj").write_text(f"mtllib two.mtl\n{corners}usemtl red\nf 1 3 4 2\nusemtl blue\nf 3 5 6 4\n")
        for n in ("4", "8"):
            run = self.run_program("render", "two.obj", "-o", "two.png", "--resolution", "16,16", "--samples", n, "--shading",
                                   "unlit", "--camera-orthographic", "--camera-position", "0,0,1", "--camera-focal-point",
                                   "0,0,0", "--camera-view-angle", "90")
            self.assertEqual(run.code, 0, run.err)
            for row in program.png(self.folder / "two.png")[3]:
                self.assertEqual([list(row[3 * x:3 * x + 3]) for x in (7, 8, 9)], [[255, 0, 0], [188, 0, 188], [0, 0, 255]])

    def test_data_channels_do_not_change(self):
        for n in ("1", "4"):
            self.picture(n + ".png", "--samples", n, "--channels", "depth,normal")
        for channel in ("depth", "normal"):
            self.assertEqual((self.folder / f"1.{channel}.exr").read_bytes(), (self.folder / f"4.{channel}.exr").read_bytes())

    def test_what_is_not_there_is_wrong_usage(self):
        for n in ("0", "2", "3", "16", "-4", "4.0", "many", ""):
            self.check_refused(self.run_program("render", "builtin:teapot", "-o", "out.png", f"--samples={n}"), 2, "--samples")
        run = self.run_program("render", "builtin:teapot", "-o", "out.png", "--samples", "16")  # not: did you mean '1'?
        self.check_refused(run, 2, "--samples: the samples of a pixel must be 1, 4 or 8, except for the method path\n")
        self.write("w.scene.toml", "[[model]]\nfile = 'builtin:teapot'\n[render]\nsamples = 3\n")
        run = self.run_program("render", "w.scene.toml", "-o", "out.png")
        self.check_refused(run, 4, "w.scene.toml: line 4, column 1: samples: the samples of a pixel must be 1, 4 or 8, except for the method path\n")
        (self.folder / "w.scene.toml").unlink()
        run = self.run_program("render", "builtin:teapot", "-o", "out.png", "--samples", "4", "--visibility", "painter")
        self.check_refused(run, 2, "--samples: 4 samples need --visibility", "z-reversed")
        self.check_refused(self.run_program("explain", "builtin:teapot", "--pixel", "3,3", "--samples", "5"), 2, "--samples")
        self.check_refused(self.run_program("stages", "builtin:teapot", "-o", "out", "--samples", "5"), 2, "--samples")
        for n in ("0", "17", "2.5", "some", ""):
            self.check_refused(self.run_program("render", "builtin:teapot", "-o", "out.png", f"--anisotropy={n}"), 2, "--anisotropy")
        self.check_refused(self.run_program("explain", "builtin:teapot", "--pixel", "3,3", "--anisotropy", "40"), 2, "--anisotropy")
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    program.main()
