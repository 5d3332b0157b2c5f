#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`rakelight join-windows`: windows that the program renders are, joined, the picture of one run; parts that make none are one line.

  join_windows_test.py PROGRAM [unittest arguments]"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import exr
import program

MODEL = pathlib.Path(__file__).resolve().parents[3] / "data/spot/spot_slab5.glb"
SIZE = ("--resolution", "151,103")
WINDOWS = ("0,0,80,50", "80,0,71,50", "0,50,80,53", "80,50,71,53")


class JoinWindows(program.Case):
    def draw(self, *options, model=MODEL):
        result = self.run_program("render", model, *options)
        self.assertEqual(result.code, 0, result.err)

    def parts(self, ending, *options, windows=WINDOWS):
        names = [f"part{i}{ending}" for i in range(len(windows))]
        for name, window in zip(names, windows, strict=True):
            self.draw("-o", name, *SIZE, "--window", window, *options)
        return names

    def join(self, parts, output, *options):
        result = self.run_program("join-windows", *parts, "-o", output, *options)
        self.assertEqual((result.code, result.err), (0, ""))
        return result

    def same_bytes(self, a, b):
        self.assertEqual((self.folder / a).read_bytes(), (self.folder / b).read_bytes(), f"{a} {b}")

    def test_two_by_two_windows_have_the_bytes_of_one_run(self):
        for ending, options in ((".png", ("--look", "default")), (".png", ("--background", "transparent")), (".exr", ()), (".hdr", ("--samples", "4")),
                                (".exr", ("--exr-colors", "half", "--background", "transparent"))):
            with self.subTest(ending=ending, options=options):
                self.draw("-o", "whole" + ending, *SIZE, *options)
                self.join(self.parts(ending, *options), "joined" + ending)
                self.same_bytes("whole" + ending, "joined" + ending)

    def test_a_window_that_is_damaged_in_its_middle_is_refused_by_name(self):
        for ending in (".png", ".exr", ".hdr"):
            with self.subTest(ending=ending):
                names = self.parts(ending)
                whole = (self.folder / names[2]).read_bytes()
                cut = len(whole) // 2
                damaged = whole[:cut] + bytes(len(whole) - cut - 12) + whole[-12:] if ending == ".png" else whole[:cut]
                (self.folder / names[2]).write_bytes(damaged)
                self.check_refused(self.run_program("join-windows", *names, "-o", "joined" + ending), 4, names[2])
                self.assertFalse((self.folder / ("joined" + ending)).exists())

    def test_data_channels_are_joined_as_they_are(self):
        layers = ("--channels", "depth,normal,object,triangle,uv", "--channel-files", "layers,png")
        self.draw("-o", "whole.exr", *SIZE, *layers)
        parts = self.parts(".exr", *layers)
        self.join(parts, "joined.exr")
        whole, joined = exr.read(self.folder / "whole.exr"), exr.read(self.folder / "joined.exr")
        self.assertIn("object.I", whole[2])
        self.assertEqual(whole, joined)
        self.assertEqual(exr.windows(self.folder / "joined.exr"), ((0, 0, 150, 102), (0, 0, 150, 102)))
        self.join([part.replace(".exr", ".normal.png") for part in parts], "joined.normal.png")
        self.same_bytes("whole.normal.png", "joined.normal.png")

    def test_windows_may_overlap_and_come_in_any_order(self):
        self.draw("-o", "whole.png", *SIZE)
        parts = self.parts(".png", windows=("60,0,91,103", "0,30,100,73", "0,0,151,31"))
        self.join(parts, "joined.png")
        self.same_bytes("whole.png", "joined.png")
        self.join(reversed(parts), "joined.png")
        self.same_bytes("whole.png", "joined.png")

    def test_places_may_stand_on_the_command_line(self):
        self.draw("-o", "whole.png", "--resolution", "64,48")
        self.draw("-o", "a@b.png", "--resolution", "32,48")
        (self.folder / "a@1,2").write_bytes((self.folder / "a@b.png").read_bytes())
        result = self.join(["a@b.png@0,0", "a@1,2@32,0"], "joined.png", "--resolution", "64x48", "--json")
        self.assertEqual(json.loads(result.out)["rows"][0], {"output": "joined.png", "width": 64, "height": 48, "parts": 2, "remarks": [],
                                                            "remarks_left_out": 0})
        _, _, _, half = program.png(self.folder / "a@b.png")
        self.assertEqual(program.png(self.folder / "joined.png"), (64, 48, 3, [row + row for row in half]))
        self.join(["whole.png"], "copy.png")
        self.same_bytes("whole.png", "copy.png")

    def test_what_makes_no_picture_is_one_line_and_no_file(self):
        parts = self.parts(".png")
        self.draw("-o", "foreign.png", "--resolution", "151,104", "--window", WINDOWS[3])
        self.draw("-o", "differs.png", *SIZE, "--window", "70,40,81,63", "--background", "white")
        self.draw("-o", "alpha.png", *SIZE, "--window", WINDOWS[3], "--background", "transparent")
        self.draw("-o", "whole.png", *SIZE)
        broken = self.folder / "broken.png"
        broken.write_bytes((self.folder / parts[3]).read_bytes()[:-200])
        before = self.files()
        join = lambda names, *options, output="joined.png": self.run_program("join-windows", *names, "-o", output, *options)
        self.check_refused(join(parts[:3]), 4, "joined.png: ", "columns 80 to 150 of rows 50 to 102", "--window 80,50,71,53")
        self.check_refused(join([*parts[:3], "foreign.png"]), 4, "foreign.png: ", "151 x 104 pixels, not of 151 x 103")
        self.check_refused(join([*parts, "differs.png"]), 4, "part", "differs.png", " differs from '", ", which both cover")
        self.check_refused(join([*parts[:3], "alpha.png"]), 4, "alpha.png: is PNG of 4 channels")
        self.check_refused(join([*parts[:3], "broken.png"]), 4, "broken.png: broken PNG")
        self.check_refused(join([*parts[:3], "none.png"]), 3, "none.png: cannot be opened")
        self.check_refused(join([*parts[:3], "whole.png"]), 2, "whole.png: does not record which window", "whole.png@X,Y")
        self.check_refused(join([parts[0] + "@0,0", parts[1] + "@80,0"]), 2, "--resolution")
        self.check_refused(join([*parts[:3], parts[3] + "@81,50"]), 4, "part3.png: ", "extends beyond")
        self.check_refused(join(parts, "--resolution", "200,200"), 4, "not of 200 x 200")
        self.check_refused(join(parts, "--resolution", "0,5"), 2, "--resolution")
        self.check_refused(join(parts, output="joined.exr"), 2, "joined.exr: ", ".png")
        self.check_refused(join([MODEL]), 4, "is not a PNG, EXR or HDR picture")
        self.check_refused(self.run_program("join-windows", "-o", "a.png"), 2)
        self.check_refused(self.run_program("join-windows", *parts), 2, "-o")
        self.assertEqual(self.files(), before)
        failed = json.loads(join(parts[:3], "--json").out)["rows"][0]["error"]
        self.assertEqual((failed["code"], failed["file"]), ("bad_file", "joined.png"))


if __name__ == "__main__":
    program.main()
